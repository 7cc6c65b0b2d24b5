"""How far each annotation is from being true, in the unit in which people think of it."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from .annotations import (
    Annotation,
    Diameter,
    EqualLength,
    Ground,
    Length,
    OnFace,
    Parallel,
    RightAngle,
    SymmetryPlane,
)
from .graph import Face, SketchGraph
from .solution import Residual, SolvedCircle
from .values import Array


def annotation_residuals(
    graph: SketchGraph,
    vertices_mm: Mapping[str, Array],
    faces: Mapping[str, Face],
    circles: Mapping[str, SolvedCircle],
) -> dict[str, Residual]:
    """Residuals of all annotations.

    Right angles and parallels in degrees, all else in mm; for groups the largest deviation.
    """
    measure = _Measure(graph, vertices_mm, faces, circles)
    found = {}
    for id_, annotation in graph.annotations.items():
        value = measure.of(annotation)
        if value is not None:
            found[id_] = Residual(value, annotation.unit)
    return found


class _Measure:
    def __init__(
        self,
        graph: SketchGraph,
        at: Mapping[str, Array],
        faces: Mapping[str, Face],
        circles: Mapping[str, SolvedCircle],
    ) -> None:
        self.graph, self.at, self.faces, self.circles = graph, at, faces, circles

    def of(self, a: Annotation) -> float | None:
        if isinstance(a, RightAngle):
            u, v = (self._away_from(a.at, e) for e in a.between)
            return abs(_angle_deg(u, v) - 90.0)
        if isinstance(a, Parallel):
            return self._parallel(a.edges)
        if isinstance(a, EqualLength):
            return float(np.ptp([self._length(e) for e in a.edges]))
        if isinstance(a, Length):
            return abs(self._length(a.edge) - a.length_mm)
        if isinstance(a, Diameter):
            return abs(2 * self.circles[a.circle].radius_mm - a.diameter_mm)
        if isinstance(a, Ground):
            return float(max(abs(self.at[v][2]) for v in a.vertices))
        if isinstance(a, SymmetryPlane):
            return self._symmetry(a.midpoints_of)
        if isinstance(a, OnFace) and a.face in self.faces:
            return self._off_plane(a.vertex, self.faces[a.face].loop)
        return None

    def _vector(self, edge: str) -> Array:
        v, w = self.graph.edges[edge]
        return np.asarray(self.at[w] - self.at[v])

    def _length(self, edge: str) -> float:
        return float(np.linalg.norm(self._vector(edge)))

    def _away_from(self, vertex: str, edge: str) -> Array:
        u = self._vector(edge)
        return u if self.graph.edges[edge][0] == vertex else -u

    def _parallel(self, edges: tuple[str, ...]) -> float:
        first = self._vector(edges[0])
        angles = [_angle_deg(first, self._vector(e)) for e in edges[1:]]
        return max(min(a, 180.0 - a) for a in angles)

    def _symmetry(self, edges: tuple[str, ...]) -> float:
        first = self._vector(edges[0])
        normal = first / max(float(np.linalg.norm(first)), 1e-300)
        middles = [sum(self.at[v] for v in self.graph.edges[e]) / 2 for e in edges]
        return max(abs(float((m - middles[0]) @ normal)) for m in middles)

    def _off_plane(self, vertex: str, loop: tuple[str, ...]) -> float:
        corners = np.array([self.at[v] for v in loop])
        middle = corners.mean(axis=0)
        normal = np.linalg.svd(corners - middle)[2][2]
        return abs(float((self.at[vertex] - middle) @ normal))


def _angle_deg(u: Array, v: Array) -> float:
    # Plain numbers: a sketch has many angles, each too small for arrays. atan2 keeps its accuracy
    # near 0 and 90 degrees, where acos loses half the digits.
    (a, b, c), (d, e, f) = u.tolist(), v.tolist()
    sine = math.hypot(b * f - c * e, c * d - a * f, a * e - b * d)
    return math.degrees(math.atan2(sine, a * d + b * e + c * f))
