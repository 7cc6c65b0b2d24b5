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

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from .annotations import SymmetryPlane
from .geometry import diagonal
from .graph import COPY_SIGN, Face, SketchGraph
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
        Its symmetry planes are used, and the faces that it lists with mirrored corners.
    drawn : Geometry
        The solved geometry.

    Returns
    -------
    Geometry, tuple of annotation ids
        The planes that were left out: each may double what there is, so that thirty would make
        millions of copies.
    """
    geometry = drawn
    partners: dict[str, Mapping[str, str]] = {}
    left_out: tuple[str, ...] = ()
    planes = topology_of(graph).by_kind["symmetry_plane"]
    for k, (id_, annotation) in enumerate(planes):
        if max(len(geometry.vertices), len(geometry.edges)) > MAX_EDGES:
            left_out = tuple(id_ for id_, _ in planes[k:])
            break
        plane = _plane(annotation, graph, drawn.vertices)
        geometry, partners[id_] = _mirror(geometry, id_, *plane)
    listed, known = graph.faces or {}, graph.drawn_faces or {}
    if len(listed) > len(known):
        geometry = replace(geometry, faces=_with_half_drawn(geometry, graph, partners))
    return geometry, left_out


def _with_half_drawn(
    geometry: Geometry, graph: SketchGraph, partners: Mapping[str, Mapping[str, str]]
) -> dict[str, Face]:
    """The faces with those listed that have mirrored corners, and with their mirror images."""
    drawn, both_ways = graph.drawn_faces or {}, {}
    for plane, partner in partners.items():
        both_ways[plane] = {**{copy: v for v, copy in partner.items()}, **partner}
    faces: dict[str, Face] = {}
    for id_, face in (graph.faces or {}).items():
        there = face if id_ in drawn else _resolved(face, partners, geometry.vertices)
        if there is not None:
            faces[id_] = there
    known = {frozenset(face.loop) for face in faces.values()}
    halves = {id_: face for id_, face in faces.items() if id_ not in drawn}
    copies = {id_: face for id_, face in geometry.faces.items() if id_ not in drawn}
    _add_images(faces, known, copies.items())
    for plane, partner in both_ways.items():
        images = [
            (f"{id_}{COPY_SIGN}{plane}", _mirror_face(face, partner))
            for id_, face in halves.items()
            if all(partner.keys() >= set(loop) for loop in face.loops)
        ]
        _add_images(faces, known, images)
    return faces


def _resolved(
    face: Face, partners: Mapping[str, Mapping[str, str]], at: Mapping[str, Array]
) -> Face | None:
    """A listed face with the names that its corners have by now; None where one is not there."""

    def name(vertex: str) -> str:
        here, *planes = vertex.split(COPY_SIGN)
        for plane in planes:
            # A drawn vertex has come to lie where the copy was, say.
            here = partners.get(plane, {}).get(here, vertex)
        return here

    loops = [tuple(v if v in at else name(v) for v in loop) for loop in face.loops]
    if not all(set(loop) <= at.keys() and len(set(loop)) == len(loop) for loop in loops):
        return None
    return replace(face, loop=loops[0], holes=tuple(loops[1:]))


def _add_images(
    faces: dict[str, Face], known: set[frozenset[str]], images: Iterable[tuple[str, Face]]
) -> None:
    """Add faces with corners of their own, where no other has the same."""
    for id_, image in images:
        corners = frozenset(image.loop)
        whole = all(len(set(loop)) == len(loop) for loop in image.loops)
        if whole and corners not in known:
            known.add(corners)
            faces[id_] = image


def _plane(
    annotation: SymmetryPlane, graph: SketchGraph, at: Mapping[str, Array]
) -> tuple[Array, Array]:
    """A point of the plane and its unit normal."""
    ends = np.array([[at[v] for v in graph.edges[e]] for e in annotation.midpoints_of])
    across = ends[0, 1] - ends[0, 0]
    length = float(np.linalg.norm(across))
    return ends.mean(axis=(0, 1)), across / length if length > 0 else across


def _mirror(
    geometry: Geometry, plane: str, point: Array, normal: Array
) -> tuple[Geometry, dict[str, str]]:
    """The geometry with its copies behind a plane, and the partner of each vertex."""
    partner, copies = _partners(geometry.vertices, plane, point, normal)
    edges = dict(geometry.edges)
    joined = {frozenset(ends) for ends in edges.values()}
    for id_, (a, b) in geometry.edges.items():
        image_ends = frozenset((partner[a], partner[b]))
        if len(image_ends) == 2 and image_ends not in joined:
            joined.add(image_ends)
            edges[f"{id_}{COPY_SIGN}{plane}"] = (partner[a], partner[b])
    faces = dict(geometry.faces)
    known = {frozenset(face.loop) for face in faces.values()}
    images = [
        (f"{id_}{COPY_SIGN}{plane}", _mirror_face(f, partner)) for id_, f in geometry.faces.items()
    ]
    _add_images(faces, known, images)
    return Geometry({**geometry.vertices, **copies}, edges, faces), partner


def _partners(
    vertices: Mapping[str, Array], plane: str, point: Array, normal: Array
) -> tuple[dict[str, str], dict[str, Array]]:
    names = list(vertices)
    X = np.array([vertices[v] for v in names])
    images = X - 2 * ((X - point) @ normal)[:, None] * normal
    reach = PARTNER_TOLERANCE * diagonal(X)
    distances, nearest = cKDTree(X).query(images)
    partner: dict[str, str] = {}
    copies: dict[str, Array] = {}
    for k, name in enumerate(names):
        if distances[k] <= reach:
            partner[name] = names[nearest[k]]
        else:
            partner[name] = f"{name}{COPY_SIGN}{plane}"
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
