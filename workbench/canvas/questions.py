"""What a person is asked for in a small field over the photo: a length of some kind."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from .plane import Point


class About(Enum):
    """What a length is said of."""

    EDGE = "edge"
    CIRCLE = "circle"
    FACE = "face"


@dataclass(frozen=True, slots=True)
class Question:
    """How long, how wide, how thick?

    Parameters
    ----------
    about : About
    target : str
        The edge's, circle's or face's id.
    at_px : (u, v)
        Photo position of the field.
    said_mm : float or None
        What was said so far.
    """

    about: About
    target: str
    at_px: Point
    said_mm: float | None = None
