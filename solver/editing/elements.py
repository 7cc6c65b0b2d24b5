"""Edits of what is drawn: each gives a new valid graph, the old one stays.

Edits that add something also give its id: the kind's letter and the first number above all that
are in use, so that the ids of what is there never change.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import pairwise

from ..annotations import Annotation, Ground, Parallel, RightAngle
from ..graph import COPY_SIGN, Ellipse, Face, Point, Revolution, SketchGraph
from ..ids import fresh_id, need
from ..reading.parsing import check_references
from .annotating import annotate
from .substitution import Substitution, substituted

#: Positions are kept to a thousandth of a px: files stay short, nobody can see less.
DECIMALS = 3


def rounded(point_px: Point) -> Point:
    """A position as files keep it."""
    u, v = point_px
    return (round(float(u), DECIMALS), round(float(v), DECIMALS))


def add_vertex(graph: SketchGraph, point_px: Point) -> tuple[SketchGraph, str]:
    """The graph with one more vertex, and its id."""
    vertex = fresh_id("v", graph.vertices)
    return replace(graph, vertices={**graph.vertices, vertex: rounded(point_px)}), vertex


def add_edge(graph: SketchGraph, v: str, w: str) -> tuple[SketchGraph, str]:
    """The graph with an edge between two vertices, and its id; the old one where there is one.

    Raises
    ------
    SketchError
        Where the two are one, or one is not there.
    """
    there = graph.edge_between(v, w)
    if there is not None:
        return graph, there
    edge = fresh_id("e", (*graph.edges, *graph.circles))
    larger = replace(graph, edges={**graph.edges, edge: (v, w)})
    check_references(larger)
    return larger, edge


def move_vertices(graph: SketchGraph, positions_px: Mapping[str, Point]) -> SketchGraph:
    """The graph with some vertices elsewhere.

    Raises
    ------
    SketchReferenceError
        Where one is not there.
    """
    need(positions_px, graph.vertices)
    moved = {v: rounded(point) for v, point in positions_px.items()}
    return replace(graph, vertices={**graph.vertices, **moved})


def merge_vertices(graph: SketchGraph, kept: str, gone: str) -> SketchGraph:
    """The graph with one vertex taken into another one, and all that named it.

    Raises
    ------
    SketchReferenceError
        Where one is not there.
    """
    need((kept, gone), graph.vertices)
    if kept == gone:
        return graph
    return substituted(graph, Substitution(vertices={gone: kept}))


def delete(
    graph: SketchGraph,
    *,
    vertices: Iterable[str] = (),
    edges: Iterable[str] = (),
    circles: Iterable[str] = (),
    faces: Iterable[str] = (),
    annotations: Iterable[str] = (),
) -> SketchGraph:
    """The graph without some elements and all that depends on them.

    Vertices that lose their last edge by it go too. Ids that are not there are no mistake.
    """
    lost = set(vertices)
    cut = {e for e, ends in graph.edges.items() if lost.intersection(ends)} | set(edges)
    at_cut = {v for e in cut & set(graph.edges) for v in graph.edges[e]}
    held = {v for e, ends in graph.edges.items() if e not in cut for v in ends}
    held.update(v for r in graph.revolutions.values() for v in r.profile)
    return substituted(
        graph,
        Substitution(
            vertices=dict.fromkeys(lost | (at_cut - held)),
            edges=dict.fromkeys(cut),
            circles=dict.fromkeys(circles),
            faces=dict.fromkeys(faces),
            annotations=dict.fromkeys(annotations),
        ),
    )


def split_edge(graph: SketchGraph, edge: str, point_px: Point) -> tuple[SketchGraph, str]:
    """The graph with a vertex on an edge, and that vertex's id.

    The edge keeps its id on its first half. The halves stay on one line in 3D, which a parallel
    annotation says. Lengths, equal lengths and symmetry planes were about the whole edge and let
    go of it.

    Raises
    ------
    SketchReferenceError
        Where the edge is not there.
    """
    need((edge,), graph.edges)
    v, w = graph.edges[edge]
    larger, middle = add_vertex(graph, point_px)
    half = fresh_id("e", (*graph.edges, *graph.circles))
    helping = graph.construction
    larger = replace(
        larger,
        edges={**graph.edges, edge: (v, middle), half: (middle, w)},
        revolutions=_split_revolutions(graph.revolutions, {v, w}, middle),
        faces=None if graph.faces is None else _split_faces(graph.faces, {v, w}, middle),
        annotations=_split_annotations(graph, edge, half, w),
        construction=(*helping, half) if edge in helping else helping,
    )
    return _straight(larger, edge, half), middle


def split_crossing(
    graph: SketchGraph, one: str, two: str, point_px: Point
) -> tuple[SketchGraph, str]:
    """The graph with one vertex on two edges that cross, and its id; see `split_edge`.

    Raises
    ------
    SketchReferenceError
        Where an edge is not there.
    """
    graph, middle = split_edge(graph, one, point_px)
    graph, twin = split_edge(graph, two, point_px)
    return merge_vertices(graph, middle, twin), middle


def _split_faces(faces: Mapping[str, Face], ends: set[str], middle: str) -> dict[str, Face]:
    def split(loop: tuple[str, ...]) -> tuple[str, ...]:
        return _split_chain((*loop, loop[0]), ends, middle)[:-1]

    return {
        id_: replace(face, loop=split(face.loop), holes=tuple(map(split, face.holes)))
        for id_, face in faces.items()
    }


def _split_revolutions(
    revolutions: Mapping[str, Revolution], ends: set[str], middle: str
) -> dict[str, Revolution]:
    return {
        id_: replace(r, profile=_split_chain(r.profile, ends, middle))
        for id_, r in revolutions.items()
    }


def _split_chain(chain: tuple[str, ...], ends: set[str], middle: str) -> tuple[str, ...]:
    """A chain of vertices with one more where the split edge was passed."""
    longer: list[str] = []
    for v, w in pairwise(chain):
        # The copies of an edge are split as it is.
        (drawn_v, copy), (drawn_w, copy_w) = (
            v.partition(COPY_SIGN)[::2],
            w.partition(COPY_SIGN)[::2],
        )
        there = {v, w} == ends or ({drawn_v, drawn_w} == ends and copy == copy_w)
        longer += [v, f"{middle}{COPY_SIGN}{copy}" if copy else middle] if there else [v]
    return (*longer, chain[-1])


def _split_annotations(graph: SketchGraph, edge: str, half: str, far: str) -> dict[str, Annotation]:
    """The annotations after a split; `far` is the vertex that the new half ends at."""
    about_whole = {
        id_: a
        for id_, a in graph.annotations.items()
        if not isinstance(a, Parallel | RightAngle | Ground)
    }
    # Only what names the whole edge lets go of it; its faces and vertices are all there still.
    whole = replace(graph, faces=None, annotations=about_whole)
    kept = substituted(whole, Substitution(edges={edge: None})).annotations
    after: dict[str, Annotation] = {}
    for id_, a in graph.annotations.items():
        if isinstance(a, RightAngle) and a.at == far:
            after[id_] = replace(a, between=tuple(half if e == edge else e for e in a.between))
        elif isinstance(a, Parallel) and edge in a.edges:
            after[id_] = replace(a, edges=(*a.edges, half))
        elif id_ not in about_whole:
            after[id_] = a
        elif id_ in kept:
            after[id_] = kept[id_]
    return after


def _straight(graph: SketchGraph, edge: str, half: str) -> SketchGraph:
    groups = [a for a in graph.annotations.values() if isinstance(a, Parallel)]
    if any(edge in group.edges and half in group.edges for group in groups):
        return graph
    return annotate(graph, Parallel((edge, half)))[0]


def toggle_construction(graph: SketchGraph, ids: Iterable[str]) -> SketchGraph:
    """The graph with edges and circles made construction, or part of the object if all were it.

    Raises
    ------
    SketchReferenceError
        Where one is not there.
    """
    named = tuple(dict.fromkeys(ids))
    need(named, (*graph.edges, *graph.circles))
    others = tuple(id_ for id_ in graph.construction if id_ not in named)
    were_all = set(named) <= set(graph.construction)
    return replace(graph, construction=others if were_all else (*others, *named))


def scaled(graph: SketchGraph, factor: float) -> SketchGraph:
    """The graph over a photo that is so many times as large, which is another value to set."""

    def place(point_px: Point) -> Point:
        return rounded((factor * point_px[0], factor * point_px[1]))

    camera = graph.camera
    if camera is not None:
        principal_point_px = factor * camera.principal_point_px
        focal_px = factor * camera.focal_px
        camera = replace(camera, focal_px=focal_px, principal_point_px=principal_point_px)
    return replace(
        graph,
        vertices={v: place(point) for v, point in graph.vertices.items()},
        circles={
            c: Ellipse((place(e.a[0]), place(e.a[1])), (place(e.b[0]), place(e.b[1])))
            for c, e in graph.circles.items()
        },
        camera=camera,
    )
