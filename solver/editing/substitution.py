"""Elements of a graph replaced by others or taken away, with all that names them.

Terms
-----
substitution
    Ids to be replaced: by another id of the same kind, or by None, which takes them away.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields, replace

from ..annotations import Annotation, Length, RightAngle
from ..graph import COPY_SIGN, Face, Revolution, SketchGraph

Ids = Mapping[str, str | None]


@dataclass(slots=True)
class Substitution:
    """What becomes of which ids; an id that is not named stays."""

    vertices: dict[str, str | None] = field(default_factory=dict)
    edges: dict[str, str | None] = field(default_factory=dict)
    circles: dict[str, str | None] = field(default_factory=dict)
    faces: dict[str, str | None] = field(default_factory=dict)
    annotations: dict[str, str | None] = field(default_factory=dict)


def substituted(graph: SketchGraph, changes: Substitution) -> SketchGraph:
    """The graph after a substitution, valid if it was so before.

    An edge whose ends become one goes; two edges that come to join the same vertices become one;
    faces and annotations that have lost what they are about go as well.

    Parameters
    ----------
    graph : SketchGraph
    changes : Substitution
        Completed on the way with what follows from it.

    Returns
    -------
    SketchGraph
    """
    vertices = {v: p for v, p in graph.vertices.items() if v not in changes.vertices}
    edges = _edges(graph, changes)
    circles = {c: drawn for c, drawn in graph.circles.items() if c not in changes.circles}
    faces = _faces(graph, changes, {frozenset(ends) for ends in edges.values()})
    smaller = replace(
        graph,
        vertices=vertices,
        edges=edges,
        circles=circles,
        revolutions=_revolutions(graph, changes),
        # Once the last face that was said is gone, faces are found in 3D again.
        faces=faces or (None if graph.faces else graph.faces),
        construction=_mapped(_mapped(graph.construction, changes.edges), changes.circles),
    )
    return _without_lost_copies(replace(smaller, annotations=_annotations(graph, smaller, changes)))


def _without_lost_copies(graph: SketchGraph) -> SketchGraph:
    """The graph without the faces whose mirrored corners are there no more."""
    if graph.faces is None or graph.faces is graph.drawn_faces:
        return graph
    kept = {
        id_: face
        for id_, face in graph.faces.items()
        if all(v in graph.vertices or graph.is_copy(v) for loop in face.loops for v in loop)
    }
    return graph if len(kept) == len(graph.faces) else replace(graph, faces=kept or None)


def _mapped(ids: Iterable[str], changes: Ids) -> tuple[str, ...]:
    """The ids after a substitution, each once."""
    after = [changes.get(id_, id_) for id_ in ids]
    return tuple(dict.fromkeys(id_ for id_ in after if id_ is not None))


def _edges(graph: SketchGraph, changes: Substitution) -> dict[str, tuple[str, str]]:
    kept: dict[str, tuple[str, str]] = {}
    between: dict[frozenset[str], str] = {}
    for edge, ends in graph.edges.items():
        if edge in changes.edges:
            continue
        after = _mapped(ends, changes.vertices)
        twin = between.get(frozenset(after))
        if len(after) < 2 or twin is not None:
            changes.edges[edge] = twin
        else:
            kept[edge] = (after[0], after[1])
            between[frozenset(after)] = edge
    return kept


def _revolutions(graph: SketchGraph, changes: Substitution) -> dict[str, Revolution]:
    kept = {}
    for id_, revolution in graph.revolutions.items():
        profile = _mapped(revolution.profile, changes.vertices)
        circles = (revolution.ground, revolution.bottom, revolution.top)
        if len(profile) >= 2 and not any(c in changes.circles for c in circles):
            kept[id_] = replace(revolution, profile=profile)
    return kept


def _faces(
    graph: SketchGraph, changes: Substitution, joined: set[frozenset[str]]
) -> dict[str, Face]:
    before = {frozenset(ends) for ends in graph.edges.values()}
    kept = {}
    for id_, face in (graph.faces or {}).items():
        loops = [_loop(loop, changes.vertices, before, joined) for loop in face.loops]
        if id_ in changes.faces or loops[0] is None:
            changes.faces[id_] = None
            continue
        holes = tuple(hole for hole in loops[1:] if hole is not None)
        kept[id_] = replace(face, loop=loops[0], holes=holes)
    return kept


def _loop(
    loop: tuple[str, ...], changes: Ids, before: set[frozenset[str]], joined: set[frozenset[str]]
) -> tuple[str, ...] | None:
    """A loop after a substitution, or None where it is open or passes a vertex twice."""
    after = [_corner(v, changes) for v in loop]
    sides = [(*pair, _drawn(old)) for pair, old in zip(_pairs(after), _pairs(loop), strict=True)]
    shorter = tuple(v for v, w, _ in sides if v is not None and v != w)
    lost = any(old in before and v != w and _drawn((v, w)) not in joined for v, w, old in sides)
    if None in after or lost or len(shorter) < 3 or len(set(shorter)) < len(shorter):
        return None
    return shorter


def _corner(vertex: str, changes: Ids) -> str | None:
    """A corner after a substitution; a copy goes, and changes its name, with what it is of."""
    drawn, sign, planes = vertex.partition(COPY_SIGN)
    if vertex in changes or drawn not in changes:
        return changes.get(vertex, vertex)
    after = changes[drawn]
    return None if after is None else f"{after}{sign}{planes}"


def _drawn(ends: Iterable[str | None]) -> frozenset[str | None]:
    """The ends of a side; of a copy, those of what it is of."""
    parts = [("", "", "") if v is None else v.partition(COPY_SIGN) for v in ends]
    alike = len({planes for _, _, planes in parts}) == 1
    return frozenset(v if alike else "".join((v, *rest)) for v, *rest in parts)


def _pairs(ids: Iterable[str | None]) -> list[tuple[str, str]]:
    """Each id with the next one, the last with the first."""
    listed: list[str] = list(ids)  # type: ignore[arg-type]
    return list(zip(listed, [*listed[1:], *listed[:1]], strict=True))


def _annotations(
    graph: SketchGraph, smaller: SketchGraph, changes: Substitution
) -> dict[str, Annotation]:
    kept: dict[str, Annotation] = {}
    said: set[Annotation | str] = set()
    for id_, annotation in graph.annotations.items():
        after = None if id_ in changes.annotations else _annotation(annotation, changes)
        if after is None or not _makes_sense(smaller, after):
            continue
        # An edge has one length, whatever it is.
        key = after.edge if isinstance(after, Length) else after
        if key not in said:
            said.add(key)
            kept[id_] = after
    return kept


def _annotation(annotation: Annotation, changes: Substitution) -> Annotation | None:
    """An annotation after a substitution, or None where too little is left of it."""
    maps = {
        "vertex": changes.vertices,
        "edge": changes.edges,
        "circle": changes.circles,
        "face": changes.faces,
    }
    values = {f.name: getattr(annotation, f.name) for f in fields(annotation)}
    for name, target in annotation.targets.items():
        value = values[name]
        several = isinstance(value, tuple)
        left = _mapped(value if several else (value,), maps[target])
        if len(left) < annotation.arity.get(name, (1, None))[0]:
            return None
        values[name] = left if several else left[0]
    return type(annotation)(**values)


def _makes_sense(graph: SketchGraph, annotation: Annotation) -> bool:
    """False for a right angle whose edges no longer meet."""
    if not isinstance(annotation, RightAngle):
        return True
    return all(annotation.at in graph.edges[edge] for edge in annotation.between)
