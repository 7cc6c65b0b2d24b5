"""The lifted shape seen through the solved camera: where it lies in the photo. Pure, no Qt.

Terms
-----
copy
    What a symmetry plane mirrored; its id has an ``@``.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ...solver.solution import Solution, SolvedCircle
    from ...solver.values import Array
    from .plane import Point

#: Straight pieces that a circle is drawn with.
CORNERS = 48


@dataclass(frozen=True, slots=True)
class LiftedView:
    """The lifted shape in photo px.

    Parameters
    ----------
    edges : mapping of edge to its two ends
        Without the copies.
    copies : tuple of lines
        Mirrored edges.
    mirrored : mapping of vertex to its place
        Copies of vertices.
    circles : tuple of lines
    faces : tuple of loops
    """

    edges: Mapping[str, tuple[Point, Point]] = field(default_factory=dict)
    copies: tuple[tuple[Point, ...], ...] = ()
    mirrored: Mapping[str, Point] = field(default_factory=dict)
    circles: tuple[tuple[Point, ...], ...] = ()
    faces: tuple[tuple[Point, ...], ...] = ()


def lifted_view(solution: Solution | None) -> LiftedView:
    """What a solution looks like in the photo; nothing where there is no camera."""
    if solution is None or solution.camera is None:
        return LiftedView()
    places = solution.camera.project(np.array(list(solution.vertices_mm.values()))).tolist()
    at = {id_: (u, v) for id_, (u, v) in zip(solution.vertices_mm, places, strict=True)}
    at = {id_: place for id_, place in at.items() if _is_finite([place])}
    there = {e: ends for e, ends in solution.edges.items() if at.keys() >= set(ends)}
    lines = {e: (at[v], at[w]) for e, (v, w) in there.items()}
    loops = [face.loop for face in solution.faces.values() if face.included]
    rings = [solution.camera.project(ring_mm(c)).tolist() for c in solution.circles.values()]
    return LiftedView(
        edges={e: line for e, line in lines.items() if "@" not in e},
        copies=tuple(line for e, line in lines.items() if "@" in e),
        mirrored={v: place for v, place in at.items() if "@" in v},
        circles=tuple(tuple((u, v) for u, v in ring) for ring in rings if _is_finite(ring)),
        faces=tuple(tuple(at[v] for v in loop) for loop in loops if at.keys() >= set(loop)),
    )


def _is_finite(ring: Iterable[Iterable[float]]) -> bool:
    return all(math.isfinite(number) for point in ring for number in point)


def ring_mm(circle: SolvedCircle) -> Array:
    """Points around a horizontal circle in the world, the first one again at the end."""
    turn = np.linspace(0.0, 2 * np.pi, CORNERS + 1)
    around = np.stack([np.cos(turn), np.sin(turn), np.zeros_like(turn)], axis=1)
    return circle.center_mm + circle.radius_mm * around
