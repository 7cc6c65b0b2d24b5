"""Faces that lie in one another in one plane, as a door that touches the edge of its wall.

Faces are loops of edges as they were drawn. Where a loop touches a larger one from inside, the
larger face covers it too, or has it as a hole on its border.

Terms
-----
within
    A face is within another one of its plane that covers all of it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient

from ...solver.model import Model, ModelFace
from ...solver.values import Array
from .enclosed import plane_axes
from .frame import SNAP_MM, newell

#: Vertices so near to an edge lie on it, and faces so near to a plane in it, mm.
_ON_MM = SNAP_MM / 10
_PARALLEL = 1 - 1e-9
_GRID_MM = _ON_MM / 10
Loop = tuple[str, ...]


def disjoint(model: Model) -> Model:
    """The model with each face cut out of those that it is within.

    Parameters
    ----------
    model : Model

    Returns
    -------
    Model
        The same one where no face is within another. Otherwise all loops have the vertices that
        lie on their edges, so that neighbours still share whole edges.
    """
    pairs = list(_overlapping_boxes(model.faces)) if model.faces else []
    if not pairs and not any(face.holes for face in model.faces.values()):
        return model
    faces = _with_vertices_on_edges(model)
    lost: dict[str, list[str]] = {id_: [] for id_, face in faces.items() if _is_touched(face)}
    for pair in pairs:
        for outer, inner in (pair, pair[::-1]):
            axes = plane_axes(faces[outer].loop_mm)[:2]
            if _is_within(_flat(faces[inner], axes), _flat(faces[outer], axes)):
                lost.setdefault(outer, []).append(inner)
    cut = {
        outer: _less(faces[outer], [faces[f] for f in inner], model.vertices_mm)
        for outer, inner in lost.items()
    }
    return replace(model, faces={**faces, **cut}) if cut else model


def _overlapping_boxes(faces: Mapping[str, ModelFace]) -> Iterator[tuple[str, str]]:
    """Pairs of faces of one plane whose boxes share more than an edge."""
    ids = list(faces)
    normals = np.array([newell(face.loop_mm) for face in faces.values()])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    corners = np.array([face.loop_mm[0] for face in faces.values()])
    low = np.array([face.loop_mm.min(axis=0) for face in faces.values()])
    high = np.array([face.loop_mm.max(axis=0) for face in faces.values()])
    one, two = np.nonzero(np.triu(np.abs(normals @ normals.T) > _PARALLEL, 1))
    off = np.einsum("ij,ij->i", corners[two] - corners[one], normals[one])
    shared = np.minimum(high[one], high[two]) - np.maximum(low[one], low[two])
    wide = (shared > _ON_MM).sum(axis=1) + (shared < -_ON_MM).any(axis=1) * -3 >= 2
    for i, j in np.column_stack([one, two])[wide & (np.abs(off) < _ON_MM)].tolist():
        yield ids[i], ids[j]


def _with_vertices_on_edges(model: Model) -> dict[str, ModelFace]:
    names, points = list(model.vertices_mm), np.array(list(model.vertices_mm.values()))
    return {
        id_: _face(
            face, [_split(loop, at, names, points) for loop, at in _loops(face)], model.vertices_mm
        )
        for id_, face in model.faces.items()
    }


def _loops(face: ModelFace) -> Iterator[tuple[Loop, Array]]:
    yield face.loop, face.loop_mm
    yield from zip(face.holes, face.holes_mm, strict=True)


def _split(loop: Loop, at: Array, names: Sequence[str], points: Array) -> Loop:
    """A loop with the vertices that lie on its edges."""
    result: list[str] = []
    for n, start in enumerate(loop):
        span = at[(n + 1) % len(at)] - at[n]
        length = float(np.linalg.norm(span))
        along = (points - at[n]) @ span / length
        off = np.linalg.norm(points - at[n] - along[:, None] * span / length, axis=1)
        on = np.flatnonzero((off < _ON_MM) & (along > _ON_MM) & (along < length - _ON_MM))
        result += [start, *(names[k] for k in on[np.argsort(along[on])].tolist())]
    return tuple(result)


def _is_touched(face: ModelFace) -> bool:
    """Whether a hole touches the outline or another one along an edge."""
    axes = plane_axes(face.loop_mm)[:2]
    outer, *holes = (at @ axes.T for _, at in _loops(face))
    return bool(holes) and not Polygon(outer, holes).is_valid


def _flat(face: ModelFace, axes: Array) -> Polygon:
    outer, *holes = (Polygon(at @ axes.T) for _, at in _loops(face))
    return outer.difference(shapely.union_all(holes), grid_size=_GRID_MM) if holes else outer


def _is_within(inner: Polygon, outer: Polygon) -> bool:
    if not (inner.is_valid and outer.is_valid) or inner.area >= outer.area - _ON_MM:
        return False
    return bool(inner.difference(outer.buffer(_ON_MM)).area < _ON_MM**2)


def _less(face: ModelFace, inner: Sequence[ModelFace], vertices: Mapping[str, Array]) -> ModelFace:
    """A face without those within it; the same where that is no one face with known corners."""
    axes = plane_axes(face.loop_mm)
    lost = shapely.union_all([_flat(other, axes[:2]) for other in inner])
    left = _flat(face, axes[:2]).difference(lost, grid_size=_GRID_MM)
    if left.geom_type != "Polygon":
        return face
    names, points = list(vertices), np.array(list(vertices.values()))
    near = np.flatnonzero(np.abs((points - face.loop_mm[0]) @ axes[2]) < _ON_MM)
    left = orient(left)
    loops = []
    for ring in (left.exterior, *left.interiors):
        corners = shapely.get_coordinates(ring)[:-1]
        gaps = np.linalg.norm(corners[:, None] - (points[near] @ axes[:2].T)[None], axis=2)
        if gaps.min(axis=1).max() > _ON_MM:
            return face
        loops.append(tuple(names[k] for k in near[gaps.argmin(axis=1)].tolist()))
    return _face(face, loops, vertices)


def _face(face: ModelFace, loops: Sequence[Loop], vertices: Mapping[str, Array]) -> ModelFace:
    placed = [np.array([vertices[v] for v in loop]) for loop in loops]
    return replace(
        face, loop=loops[0], loop_mm=placed[0], holes=tuple(loops[1:]), holes_mm=tuple(placed[1:])
    )
