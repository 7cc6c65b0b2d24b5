"""The paper's own method and plain Lipson, readable beside the paper, for comparison.

Both take a `SketchGraph` and give a `Solution`, as the solver itself does.
"""

from collections.abc import Callable

from ..solution import Solution
from . import lau2010, lipson1996
from .common import Limits

#: The methods by name; each takes a graph, and ``limits`` and ``stop`` by keyword.
METHODS: dict[str, Callable[..., Solution]] = {
    "lau2010": lau2010.solve,
    "lipson1996": lipson1996.solve,
}

__all__ = ["METHODS", "Limits", "lau2010", "lipson1996"]
