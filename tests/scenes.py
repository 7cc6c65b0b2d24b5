"""Shapes whose truth is known, and photographs of them as sketch graphs: the solver's own."""

from __future__ import annotations

from incontext.solver.synthetic import *  # noqa: F403
