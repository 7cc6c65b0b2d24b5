"""Findings before any solve: what is wrong or missing in a sketch, one line each."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from .annotations import Diameter, Ground, Length, OnFace, RightAngle, targets_of
from .circles import flat_circles
from .diagnosis import clashing_annotations
from .graph import SketchGraph
from .revolution import without_profiles
from .structure import build_structure

#: Drawn vertices nearer than this to each other are probably meant to be one, px.
NEAR_PX = 3.0


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
            _unknown_faces,
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
    if graph.edges and build_structure(graph).contradiction:
        ids = clashing_annotations(graph)
        yield _error(f"cannot all hold ({', '.join(ids)}); try: take one of them away", *ids)


def _unused_vertices(graph: SketchGraph) -> Iterator[Finding]:
    used = {v for ends in graph.edges.values() for v in ends}
    used |= {v for r in graph.revolutions.values() for v in r.profile}
    for v in graph.vertices:
        if v not in used:
            yield _warning(f"a vertex without edges ({v}); try: delete it", v)


def _near_vertices(graph: SketchGraph) -> Iterator[Finding]:
    names = list(graph.vertices)
    if len(names) < 2:
        return
    points = np.array(list(graph.vertices.values()))
    order = np.argsort(points[:, 0], kind="stable")
    for k, i in enumerate(order):
        for j in order[k + 1 :]:
            if points[j, 0] - points[i, 0] > NEAR_PX:
                break
            if abs(points[j, 1] - points[i, 1]) <= NEAR_PX:
                pair = sorted((names[i], names[j]))
                yield _warning(
                    f"two vertices almost in one place ({', '.join(pair)}); try: merge them", *pair
                )


def _outside_photo(graph: SketchGraph) -> Iterator[Finding]:
    if graph.photo is None:
        return
    wide, high = graph.photo.width_px, graph.photo.height_px
    far = [
        v
        for v, (x, y) in graph.vertices.items()
        if not (-wide <= x <= 2 * wide and -high <= y <= 2 * high)
    ]
    if far:
        yield _warning(f"far outside the photo ({', '.join(far[:5])}); try: move them", *far)


def _no_right_angles(graph: SketchGraph) -> Iterator[Finding]:
    straight = without_profiles(graph).edges
    if straight and not any(isinstance(a, RightAngle) for a in graph.annotations.values()):
        yield _warning("no right angle is marked; try: click the corners that are square")


def _apart(graph: SketchGraph) -> Iterator[Finding]:
    """Parts that neither an edge nor an annotation joins float in space."""
    parts = _parts(graph)
    if len(parts) > 1:
        loose = min((sorted(p) for p in parts), key=len)[:5]
        yield _warning(
            f"{len(parts)} parts that nothing joins ({', '.join(loose)} ...); "
            "try: ground, parallel or on_face between them",
            *loose,
        )


def _parts(graph: SketchGraph) -> list[set[str]]:
    groups = [set(ends) for ends in graph.edges.values()]
    for annotation in graph.annotations.values():
        named = targets_of(annotation)
        joined = set(named.get("vertex", ()))
        joined |= {v for e in named.get("edge", ()) for v in graph.edges[e]}
        for f in named.get("face", ()):
            face = (graph.faces or {}).get(f)
            joined |= set(face.loop if face is not None else ())
        groups.append(joined)
    parts: list[set[str]] = []
    for group in (g for g in groups if g):
        touching = [p for p in parts if p & group]
        merged = group.union(*touching)
        parts = [p for p in parts if not p & group] + [merged]
    return parts


def _no_ground(graph: SketchGraph) -> Iterator[Finding]:
    drawn = graph.edges or graph.circles
    if (
        drawn
        and not graph.revolutions
        and not any(isinstance(a, Ground) for a in graph.annotations.values())
    ):
        yield _warning("no vertex stands on the ground; try: mark those that do")


def _no_length(graph: SketchGraph) -> Iterator[Finding]:
    if graph.edges and not any(
        isinstance(a, Length | Diameter) for a in graph.annotations.values()
    ):
        yield _warning("no length is given, so the longest edge will be 100 mm; try: give one")


def _face_edges(graph: SketchGraph) -> Iterator[Finding]:
    drawn = {frozenset(ends) for ends in graph.edges.values()}
    for id_, face in (graph.faces or {}).items():
        for loop in face.loops:
            gaps = [
                f"{a}-{b}"
                for a, b in zip(loop, loop[1:] + loop[:1], strict=True)
                if frozenset((a, b)) not in drawn
            ]
            if gaps:
                yield _warning(f"face {id_} has sides that are not drawn ({', '.join(gaps)})", id_)


def _unknown_faces(graph: SketchGraph) -> Iterator[Finding]:
    if graph.faces is None:
        for id_, a in graph.annotations.items():
            if isinstance(a, OnFace):
                yield _warning(
                    f"annotation {id_} names face {a.face}, but the sketch lists no faces; "
                    "try: list the face",
                    id_,
                )
