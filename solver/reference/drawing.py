"""A sketch graph as the reference methods see it.

Terms
-----
drawing unit
    A hundredth of the drawn vertices' diagonal. The paper gives no unit of length; with this one
    an error of a hundredth of the drawing weighs about as much as an error of one degree, which
    is how its weights (0.4 for the projection, 0.5 for angles) look meant.
drawing frame
    x right and y down from the principal point, z away from the eye, in drawing units.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..annotations import (
    Annotation,
    EqualLength,
    Ground,
    Length,
    OnFace,
    Parallel,
    RightAngle,
)
from ..graph import SketchGraph
from ..values import Array
from .energies import GeometricConstraints

#: The drawing's diagonal in drawing units.
DIAGONAL = 100.0


@dataclass(frozen=True, slots=True, eq=False)
class Drawing:
    """A sketch graph as the reference methods see it.

    Parameters
    ----------
    graph : SketchGraph
    p : (n, 2) array
        [Lau10]'s p: the drawn vertices, drawing units from the principal point.
    px_per_unit : float
    focal : float
        Where the search for the focal length begins, drawing units.
    constraints : GeometricConstraints
    ground : tuple of int
        Indices of the ground vertices.
    rectangles : tuple of 4-tuples of int
        The quadrilaterals all of whose angles are annotated as right.
    """

    graph: SketchGraph
    p: Array
    px_per_unit: float
    focal: float
    constraints: GeometricConstraints
    ground: tuple[int, ...]
    rectangles: tuple[tuple[int, int, int, int], ...]


#: Longer side of the photo to focal length where the photo does not tell: a usual phone.
USUAL_FOCAL = 0.8


def read_drawing(graph: SketchGraph) -> Drawing:
    """Take from a sketch graph what the paper's method uses."""
    index = {v: i for i, v in enumerate(graph.vertices)}
    pixels = np.array(list(graph.vertices.values()), dtype=float)
    diagonal = float(np.linalg.norm(np.ptp(pixels, axis=0)))
    px_per_unit = diagonal / DIAGONAL
    said = tuple(graph.annotations.values())
    return Drawing(
        graph=graph,
        p=(pixels - np.array(graph.principal_point_px)) / px_per_unit,
        px_per_unit=px_per_unit,
        focal=_focal_px(graph, diagonal) / px_per_unit,
        constraints=_constraints(graph, index, said),
        ground=tuple(sorted({index[v] for a in said if isinstance(a, Ground) for v in a.vertices})),
        rectangles=tuple(_rectangles(graph, index)),
    )


def _focal_px(graph: SketchGraph, diagonal: float) -> float:
    if graph.camera is not None:
        return float(graph.camera.focal_px)
    if graph.photo is None:
        return 2.0 * diagonal
    usual = USUAL_FOCAL * max(graph.photo.width_px, graph.photo.height_px)
    return float(graph.photo.focal_px or usual)


def _constraints(
    graph: SketchGraph, index: Mapping[str, int], said: Iterable[Annotation]
) -> GeometricConstraints:
    rows: dict[str, list[tuple[int, ...]]] = {}

    def line(edge: str, start: str | None = None) -> tuple[int, int]:
        v, w = graph.edges[edge]
        return (index[w], index[v]) if start == w else (index[v], index[w])

    for a in said:
        if isinstance(a, RightAngle):
            rows.setdefault(a.kind, []).append(
                (*line(a.between[0], a.at), *line(a.between[1], a.at))
            )
        elif isinstance(a, EqualLength | Parallel):
            rows.setdefault(a.kind, []).extend(
                (*line(e), *line(following)) for e, following in pairwise(a.edges)
            )
        elif isinstance(a, OnFace) and a.face in (graph.drawn_faces or {}):
            loop = (graph.drawn_faces or {})[a.face].loop
            rows.setdefault(a.kind, []).append((*(index[v] for v in loop[:3]), index[a.vertex]))
    kinds = (RightAngle.kind, EqualLength.kind, Parallel.kind, OnFace.kind)
    return GeometricConstraints(
        *(np.array(rows.get(kind, []), dtype=np.int64).reshape(-1, 4) for kind in kinds)
    )


def _rectangles(
    graph: SketchGraph, index: Mapping[str, int]
) -> Iterable[tuple[int, int, int, int]]:
    """The quadrilaterals with four annotated right angles, each once, in the drawing's order."""
    corners: set[tuple[int, frozenset[int]]] = set()
    for a in graph.annotations.values():
        if isinstance(a, RightAngle):
            tips = {v for e in a.between for v in graph.edges[e]} - {a.at}
            corners.add((index[a.at], frozenset(index[v] for v in tips)))
    arms: dict[int, list[frozenset[int]]] = {}
    for at, ends in sorted(corners, key=lambda corner: (corner[0], sorted(corner[1]))):
        arms.setdefault(at, []).append(ends)
    seen: set[frozenset[int]] = set()
    for b, pairs in sorted(arms.items()):
        for pair in (p for p in pairs if len(p) == 2):
            i, k = sorted(pair)
            for d in sorted({v for p in arms.get(i, []) if b in p for v in p} - {b, k}):
                loop = ((i, frozenset({b, d})), (k, frozenset({b, d})), (d, pair))
                if all(corner in corners for corner in loop) and {i, b, k, d} not in seen:
                    seen.add(frozenset({i, b, k, d}))
                    yield (i, b, k, d)


#: Kinds that the paper's energies speak of; a length sets the size when all is done.
KNOWN_KINDS = frozenset(a.kind for a in (RightAngle, EqualLength, Parallel, Ground, Length))


def unknown_annotations(graph: SketchGraph) -> tuple[str, ...]:
    """The ids of the annotations that the reference methods leave out."""
    given = graph.drawn_faces or {}
    return tuple(
        id_
        for id_, a in graph.annotations.items()
        if a.kind not in KNOWN_KINDS and not (isinstance(a, OnFace) and a.face in given)
    )
