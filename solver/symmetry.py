"""Symmetry planes: what has no partner on its other side is mirrored ([Lau10] 3.2, Figure 6).

Terms
-----
symmetry plane
    Goes through the midpoints of the annotated edges, which cross it at right angles.
partner
    The element that stands where the mirror image falls; elements in the plane are their own.
copy
    A mirror image that had no partner; the copy of ``v3`` made by ``a5`` is ``v3@a5``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from .annotations import SymmetryPlane
from .graph import Face, SketchGraph
from .reading.parsing import MAX_EDGES
from .topology import topology_of
from .values import Array

#: A mirror image this near (in parts of the size) to a drawn vertex has that one as its partner.
PARTNER_TOLERANCE = 0.01


@dataclass(frozen=True, slots=True)
class Geometry:
    """Vertices (world, mm), edges and faces by id."""

    vertices: Mapping[str, Array]
    edges: Mapping[str, tuple[str, str]]
    faces: Mapping[str, Face]


def mirrored(graph: SketchGraph, drawn: Geometry) -> tuple[Geometry, tuple[str, ...]]:
    """Add the copies of every symmetry plane, one plane after the other.

    Parameters
    ----------
    graph : SketchGraph
        Its symmetry planes are used.
    drawn : Geometry
        The solved geometry.

    Returns
    -------
    Geometry, tuple of annotation ids
        The planes that were left out: each may double what there is, so that thirty would make
        millions of copies.
    """
    geometry = drawn
    planes = topology_of(graph).by_kind["symmetry_plane"]
    for k, (id_, annotation) in enumerate(planes):
        if max(len(geometry.vertices), len(geometry.edges)) > MAX_EDGES:
            return geometry, tuple(id_ for id_, _ in planes[k:])
        geometry = _mirror(geometry, id_, *_plane(annotation, graph, drawn.vertices))
    return geometry, ()


def _plane(
    annotation: SymmetryPlane, graph: SketchGraph, at: Mapping[str, Array]
) -> tuple[Array, Array]:
    """A point of the plane and its unit normal."""
    ends = np.array([[at[v] for v in graph.edges[e]] for e in annotation.midpoints_of])
    across = ends[0, 1] - ends[0, 0]
    length = float(np.linalg.norm(across))
    return ends.mean(axis=(0, 1)), across / length if length > 0 else across


def _mirror(geometry: Geometry, plane: str, point: Array, normal: Array) -> Geometry:
    partner, copies = _partners(geometry.vertices, plane, point, normal)
    edges = dict(geometry.edges)
    joined = {frozenset(ends) for ends in edges.values()}
    for id_, (a, b) in geometry.edges.items():
        image_ends = frozenset((partner[a], partner[b]))
        if len(image_ends) == 2 and image_ends not in joined:
            joined.add(image_ends)
            edges[f"{id_}@{plane}"] = (partner[a], partner[b])
    faces = dict(geometry.faces)
    known = {frozenset(face.loop) for face in faces.values()}
    for id_, face in geometry.faces.items():
        image = _mirror_face(face, partner)
        corners = frozenset(image.loop)
        whole = all(len(set(loop)) == len(loop) for loop in image.loops)
        if whole and corners not in known:
            known.add(corners)
            faces[f"{id_}@{plane}"] = image
    return Geometry({**geometry.vertices, **copies}, edges, faces)


def _partners(
    vertices: Mapping[str, Array], plane: str, point: Array, normal: Array
) -> tuple[dict[str, str], dict[str, Array]]:
    names = list(vertices)
    X = np.array([vertices[v] for v in names])
    images = X - 2 * ((X - point) @ normal)[:, None] * normal
    reach = PARTNER_TOLERANCE * float(np.linalg.norm(np.ptp(X, axis=0)))
    distances, nearest = cKDTree(X).query(images)
    partner: dict[str, str] = {}
    copies: dict[str, Array] = {}
    for k, name in enumerate(names):
        if distances[k] <= reach:
            partner[name] = names[nearest[k]]
        else:
            partner[name] = f"{name}@{plane}"
            copies[partner[name]] = images[k]
    return partner, copies


def _mirror_face(face: Face, partner: Mapping[str, str]) -> Face:
    """A mirror image runs the other way round."""

    def image(loop: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(partner[v] for v in reversed(loop))

    return Face(
        image(face.loop),
        tuple(image(hole) for hole in face.holes),
        face.included,
        face.thickness_mm,
    )
