"""Where an optimisation begins, and where it begins again when that led nowhere."""
