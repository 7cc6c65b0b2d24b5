"""Dimensions by their properties' names: four kinds, each with what reads, says and frees it.

Terms
-----
dimension
    A length, diameter, height or angle, of one element or of the corner of two edges.
driving
    Said by the sketch; the others follow.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution

LENGTH, DIAMETER, HEIGHT, ANGLE = "Length_", "Diameter_", "Height_", "Angle_"
PREFIXES = (LENGTH, DIAMETER, HEIGHT, ANGLE)
_BETWEEN = "_and_"
_TOKENS = re.compile(r"__|_x([0-9a-f]+)_|_and_|[A-Za-z0-9]")


@dataclass(frozen=True, slots=True)
class Dimension:
    """A dimension: its kind by the prefix of its name, and the ids of what it measures."""

    prefix: str
    ids: tuple[str, ...]

    @property
    def name(self) -> str:
        """The name of its property: ASCII, different for different dimensions."""
        return self.prefix + _BETWEEN.join(_safe(id_) for id_ in self.ids)


def property_name(prefix: str, *ids: str) -> str:
    """The name of a dimension's property."""
    return Dimension(prefix, ids).name


def is_dimension(name: str) -> bool:
    """Whether a property's name may be that of a dimension."""
    return name.startswith(PREFIXES)


def dimension_named(name: str) -> Dimension | None:
    """The dimension whose property has the name; None where it is no such name."""
    prefix = next((p for p in PREFIXES if name.startswith(p)), None)
    if prefix is None:
        return None
    ids, rest = [""], name[len(prefix) :]
    while rest:
        token = _TOKENS.match(rest)
        if token is None:
            return None
        rest = rest[token.end() :]
        if token[0] == _BETWEEN:
            ids.append("")
        else:
            ids[-1] += _unsafe(token)
    measures = 2 if prefix == ANGLE else 1
    return Dimension(prefix, tuple(ids)) if len(ids) == measures else None


def _safe(id_: str) -> str:
    return re.sub(r"[^A-Za-z0-9]", lambda m: "__" if m[0] == "_" else f"_x{ord(m[0]):x}_", id_)


def _unsafe(token: re.Match[str]) -> str:
    if token[0] == "__":
        return "_"
    return chr(int(token[1], 16)) if token[1] else token[0]


def driving(graph: SketchGraph) -> dict[Dimension, float]:
    """What the sketch says of its dimensions, mm and degrees."""
    from ...solver.dimensions.angles import driving_angles_deg
    from ...solver.dimensions.heights import driving_heights_mm
    from ...solver.dimensions.lengths import driving_sizes_mm

    found = {_size(graph, id_): size for id_, size in driving_sizes_mm(graph).items()}
    found |= {Dimension(HEIGHT, (id_,)): h for id_, h in driving_heights_mm(graph).items()}
    return found | {Dimension(ANGLE, ids): a for ids, a in driving_angles_deg(graph).items()}


def measured(
    graph: SketchGraph, solution: Solution, corners: Iterable[tuple[str, str]] = ()
) -> dict[Dimension, float]:
    """What all dimensions came out as, mm and degrees; `corners` beside those of faces."""
    from ...solver.dimensions.angles import angles_deg
    from ...solver.dimensions.heights import heights_mm
    from ...solver.dimensions.lengths import sizes_mm

    found = {
        Dimension(DIAMETER if id_ in solution.circles else LENGTH, (id_,)): size
        for id_, size in sizes_mm(solution).items()
    }
    found |= {Dimension(HEIGHT, (id_,)): h for id_, h in heights_mm(graph, solution).items()}
    angles = angles_deg(graph, solution, corners)
    return found | {Dimension(ANGLE, ids): a for ids, a in angles.items()}


def said(graph: SketchGraph, dimension: Dimension, value: float | None) -> SketchGraph:
    """The graph with a dimension said, in mm or degrees; None lets it follow again.

    Raises
    ------
    SketchError
        Where the value cannot be, or the sketch has no words for it.
    """
    from ...solver.dimensions.angles import set_angle
    from ...solver.dimensions.heights import set_height
    from ...solver.dimensions.lengths import set_size

    if dimension.prefix == HEIGHT:
        return set_height(graph, dimension.ids[0], value)
    if dimension.prefix == ANGLE:
        first, second = dimension.ids
        return set_angle(graph, (first, second), value)
    return set_size(graph, dimension.ids[0], value)


def _size(graph: SketchGraph, id_: str) -> Dimension:
    return Dimension(DIAMETER if id_ in graph.circles else LENGTH, (id_,))
