"""Lift an annotated 2D sketch to 3D: the Modified Lipson solver of [Lau10].

[Lau10] Lau, Saul, Mitani, Igarashi: Modeling-in-Context: User Design of Complementary Objects with
a Single Photo, 2010.
"""

from .counts import ParameterCounts, parameter_counts
from .diagnosis.redundancy import redundant_annotations
from .dragging import Drag, begin_drag, drag
from .errors import SketchError
from .serialise import load_sketch, load_solution, save_sketch, save_solution
from .two_step import solve
from .validation import findings

__all__ = [
    "Drag",
    "ParameterCounts",
    "SketchError",
    "begin_drag",
    "drag",
    "findings",
    "load_sketch",
    "load_solution",
    "parameter_counts",
    "redundant_annotations",
    "save_sketch",
    "save_solution",
    "solve",
]
