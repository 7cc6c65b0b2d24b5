"""Findings before any solve: what is wrong or missing in a sketch, one line each."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from .annotations import Annotation, Diameter, Length, RightAngle, targets_of
from .circles import flat_circles
from .diagnosis import clashing_annotations, disagree
from .graph import SketchGraph
from .revolution import without_profiles
from .topology import Topology, topology_of
from .union_find import UnionFind
from .values import Array, kept

#: Drawn vertices nearer than this to each other are probably meant to be one, px.
NEAR_PX = 3.0
#: So many near pairs are told.
MAX_NEAR = 100


class Severity(StrEnum):
    """Whether a solve can succeed at all."""

    ERROR = "error"
    WARNING = "warning"


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that is wrong or missing.

    Parameters
    ----------
    severity : Severity
    ids : tuple of str
        The elements concerned.
    text : str
        One line: what, where, what to try.
    """

    severity: Severity
    ids: tuple[str, ...]
    text: str


def findings(graph: SketchGraph) -> tuple[Finding, ...]:
    """What is wrong or missing in a sketch, errors first."""
    found = [
        finding
        for check in (
            _no_edges,
            _circles,
            _clashes,
            _unused_vertices,
            _near_vertices,
            _outside_photo,
            _no_right_angles,
            _apart,
            _no_ground,
            _no_length,
            _face_edges,
        )
        for finding in check(graph)
    ]
    return tuple(sorted(found, key=lambda f: f.severity != Severity.ERROR))


def _error(text: str, *ids: str) -> Finding:
    return Finding(Severity.ERROR, ids, text)


def _warning(text: str, *ids: str) -> Finding:
    return Finding(Severity.WARNING, ids, text)


def _no_edges(graph: SketchGraph) -> Iterator[Finding]:
    if not graph.edges and not graph.circles:
        yield _error("nothing is drawn yet; try: draw the object's edges over the photo")


def _circles(graph: SketchGraph) -> Iterator[Finding]:
    for c in flat_circles(graph):
        yield _error(f"circle {c} has no width or no height; try: pull the ellipse open", c)


def _clashes(graph: SketchGraph) -> Iterator[Finding]:
    if (graph.edges or graph.circles) and disagree(graph):
        ids = clashing_annotations(graph)
        some = ", ".join(ids if len(ids) < 8 else (*ids[:4], f"{len(ids) - 4} more"))
        yield _error(f"cannot all hold ({some}); try: take one of them away", *ids)


def _unused_vertices(graph: SketchGraph) -> Iterator[Finding]:
    for v in _without_edges(topology_of(graph)):
        yield _warning(f"a vertex without edges ({v}); try: delete it", v)


@kept
def _without_edges(topology: Topology) -> tuple[str, ...]:
    profiles = {v for r in topology.revolutions.values() for v in r.profile}
    used = np.zeros(len(topology.vertices), dtype=bool)
    used[topology.ends.reshape(-1)] = True
    names = tuple(topology.vertices)
    return tuple(names[k] for k in np.flatnonzero(~used).tolist() if names[k] not in profiles)


def _near_vertices(graph: SketchGraph) -> Iterator[Finding]:
    names = list(graph.vertices)
    for i, j in _near_pairs(graph.positions_px):
        pair = sorted((names[i], names[j]))
        yield _warning(
            f"two vertices almost in one place ({', '.join(pair)}); try: merge them", *pair
        )


def _near_pairs(points: Array) -> list[tuple[int, int]]:
    """Pairs of points in almost one place, from left to right, so many as anybody reads."""
    order = np.argsort(points[:, 0], kind="stable")
    x, y = points[order].T
    left = np.arange(len(points))
    found: list[tuple[int, int]] = []
    for ahead in range(1, len(points)):
        left = left[left < len(points) - ahead]
        left = left[x[left + ahead] - x[left] <= NEAR_PX]
        if not len(left) or len(found) > MAX_NEAR:
            break
        near = left[np.abs(y[left + ahead] - y[left]) <= NEAR_PX]
        found += zip(near.tolist(), (near + ahead).tolist(), strict=True)
    return [(int(order[i]), int(order[j])) for i, j in sorted(found)[:MAX_NEAR]]


def _outside_photo(graph: SketchGraph) -> Iterator[Finding]:
    if graph.photo is None:
        return
    size = np.array([graph.photo.width_px, graph.photo.height_px], dtype=float)
    points = graph.positions_px
    outside = ((points < -size) | (points > 2 * size)).any(axis=1)
    if outside.any():
        names = list(graph.vertices)
        far = [names[k] for k in np.flatnonzero(outside).tolist()]
        yield _warning(f"far outside the photo ({', '.join(far[:5])}); try: move them", *far)


def _no_right_angles(graph: SketchGraph) -> Iterator[Finding]:
    if not len(topology_of(graph).right_angles) and without_profiles(graph).edges:
        yield _warning("no right angle is marked; try: click the corners that are square")


def _apart(graph: SketchGraph) -> Iterator[Finding]:
    """Parts that neither an edge nor an annotation joins float in space."""
    # What belongs to profiles alone is held by its circles, which stand on the ground.
    core = without_profiles(graph)
    count, loose = _smallest_part(topology_of(core), core.annotations)
    if count > 1:
        yield _warning(
            f"{count} parts that nothing joins ({', '.join(loose)} ...); "
            "try: ground, parallel or on_face between them",
            *loose,
        )


@kept
def _smallest_part(
    topology: Topology, annotations: Mapping[str, Annotation]
) -> tuple[int, tuple[str, ...]]:
    """How many parts there are, and some vertices of the smallest one."""
    sets = UnionFind(len(topology.vertices))
    touched: set[int] = set()
    for group in (*topology.ends.tolist(), *_joined_by_annotations(topology, annotations)):
        touched.update(group)
        for i in group[1:]:
            sets.union(group[0], i)
    names = tuple(topology.vertices)
    parts: dict[int, list[str]] = {}
    for i in sorted(touched):
        parts.setdefault(sets.find(i), []).append(names[i])
    smallest = min((sorted(part) for part in parts.values()), key=len, default=[])
    return len(parts), tuple(smallest[:5])


def _joined_by_annotations(
    topology: Topology, annotations: Mapping[str, Annotation]
) -> Iterator[list[int]]:
    """The vertices that each annotation speaks of."""
    ends = topology.ends.tolist()
    for annotation in annotations.values():
        # A right angle's edges meet: they are joined already.
        if isinstance(annotation, RightAngle):
            continue
        named = targets_of(annotation)
        joined = [topology.vertices[v] for v in named.get("vertex", ())]
        joined += [i for e in named.get("edge", ()) for i in ends[topology.edges[e]]]
        for f in named.get("face", ()):
            face = (topology.faces or {}).get(f)
            joined += [topology.vertices[v] for v in (face.loop if face is not None else ())]
        if joined:
            yield joined


def _no_ground(graph: SketchGraph) -> Iterator[Finding]:
    drawn = graph.edges or graph.circles
    if drawn and not graph.revolutions and not len(topology_of(graph).ground):
        yield _warning("no vertex stands on the ground; try: mark those that do")


def _no_length(graph: SketchGraph) -> Iterator[Finding]:
    # The height of a known camera over the ground tells the size as well.
    on_ground = graph.revolutions or len(topology_of(graph).ground)
    by_camera = graph.camera is not None and on_ground
    if graph.edges and not by_camera and not (_kinds(graph.annotations) & {Length, Diameter}):
        yield _warning("no length is given, so the longest edge will be 100 mm; try: give one")


@kept
def _kinds(annotations: Mapping[str, Annotation]) -> frozenset[type[Annotation]]:
    return frozenset(type(a) for a in annotations.values())


def _face_edges(graph: SketchGraph) -> Iterator[Finding]:
    for id_, gaps in _undrawn_sides(topology_of(graph)):
        yield _warning(f"face {id_} has sides that are not drawn ({', '.join(gaps)})", id_)


@kept
def _undrawn_sides(topology: Topology) -> tuple[tuple[str, list[str]], ...]:
    drawn = {frozenset(pair) for pair in topology.ends.tolist()}
    index = topology.vertices
    found = []
    for id_, face in (topology.faces or {}).items():
        for loop in face.loops:
            gaps = [
                f"{a}-{b}"
                for a, b in zip(loop, loop[1:] + loop[:1], strict=True)
                if frozenset((index[a], index[b])) not in drawn
            ]
            if gaps:
                found.append((id_, gaps))
    return tuple(found)
