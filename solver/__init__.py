"""Lift an annotated 2D sketch to 3D: the Modified Lipson solver of [Lau10].

[Lau10] Lau, Saul, Mitani, Igarashi: Modeling-in-Context: User Design of Complementary Objects with
a Single Photo, 2010.
"""

from .dragging import Drag, begin_drag, drag
from .errors import SketchError
from .serialise import load_sketch, load_solution, save_sketch, save_solution
from .two_step import solve
from .validation import findings

__all__ = [
    "Drag",
    "SketchError",
    "begin_drag",
    "drag",
    "findings",
    "load_sketch",
    "load_solution",
    "save_sketch",
    "save_solution",
    "solve",
]
