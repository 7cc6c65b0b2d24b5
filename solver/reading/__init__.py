"""From plain JSON values to frozen ones: every reference checked, every error with its place."""
