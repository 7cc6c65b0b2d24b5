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

from .annotations import SymmetryPlane
from .graph import Face, SketchGraph
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


def mirrored(graph: SketchGraph, drawn: Geometry) -> Geometry:
    """Add the copies of every symmetry plane, one plane after the other.

    Parameters
    ----------
    graph : SketchGraph
        Its symmetry planes are used.
    drawn : Geometry
        The solved geometry.
    """
    geometry = drawn
    for id_, annotation in topology_of(graph).by_kind["symmetry_plane"]:
        geometry = _mirror(geometry, id_, *_plane(annotation, graph, drawn.vertices))
    return geometry


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
        if frozenset((partner[a], partner[b])) not in joined:
            edges[f"{id_}@{plane}"] = (partner[a], partner[b])
    faces = dict(geometry.faces)
    known = {frozenset(face.loop) for face in faces.values()}
    for id_, face in geometry.faces.items():
        image = _mirror_face(face, partner)
        if frozenset(image.loop) not in known:
            faces[f"{id_}@{plane}"] = image
    return Geometry({**geometry.vertices, **copies}, edges, faces)


def _partners(
    vertices: Mapping[str, Array], plane: str, point: Array, normal: Array
) -> tuple[dict[str, str], dict[str, Array]]:
    names = list(vertices)
    X = np.array([vertices[v] for v in names])
    images = X - 2 * ((X - point) @ normal)[:, None] * normal
    reach = PARTNER_TOLERANCE * float(np.linalg.norm(np.ptp(X, axis=0)))
    partner: dict[str, str] = {}
    copies: dict[str, Array] = {}
    for name, image in zip(names, images, strict=True):
        distances = np.linalg.norm(X - image, axis=1)
        nearest = int(np.argmin(distances))
        if distances[nearest] <= reach:
            partner[name] = names[nearest]
        else:
            partner[name] = f"{name}@{plane}"
            copies[partner[name]] = image
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
