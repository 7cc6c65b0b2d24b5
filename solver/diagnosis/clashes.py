"""Annotations that cannot all hold, whatever the drawing: found by reasoning alone.

Terms
-----
clash
    A set of annotations from which a contradiction follows (an edge across itself, of no length, or
    of two), and no smaller part of it does.
culprit
    An annotation without which all the others agree.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from ..annotations import Annotation, Diameter, EqualLength, Length, targets_of
from ..directions import direction_classes
from ..effort import asking, questions_within_reason
from ..graph import SketchGraph
from ..structure import build_structure, structure_along
from ..topology import topology_of, topology_with
from ..values import Stop, frozen_mapping, kept
from .same_sizes import sizes_clash

#: How often it may be asked whether some annotations agree, to find the culprits, and after that,
#: to find what they clash with: of 122 clashes none took more than 123. One that is not the
#: smallest by then is told as it is.
MAX_QUESTIONS, MORE_QUESTIONS = 60, 150
#: So many of the nearest annotations are asked first whether they clash with the culprits.
NEAREST = 8
#: How many parts are left out in turn, to see which holds the culprit.
PARTS = 6


@dataclass(frozen=True, slots=True)
class Clash:
    """What cannot hold together.

    Parameters
    ----------
    culprits : tuple of annotation ids
        Without any one of these the others agree; the last one said first.
    others : tuple of annotation ids
        The rest of the clash.
    """

    culprits: tuple[str, ...]
    others: tuple[str, ...]

    @property
    def ids(self) -> tuple[str, ...]:
        """All of it, culprits first."""
        return (*self.culprits, *self.others)


def find_clash(graph: SketchGraph, stop: Stop | None = None) -> Clash:
    """A smallest clash among annotations of which it is known that they cannot all hold.

    Parameters
    ----------
    graph : SketchGraph
    stop : callable, optional
        Asked at each question; True ends the search with what was found so far.
    """
    search = _Search(graph, stop)
    culprits = sorted(search.culprits(), key=search.said.index, reverse=True)
    search.limit = len(search.asked) + MORE_QUESTIONS
    # Without any culprit all others agree: each clash has them all.
    clash = search.smallest(culprits)
    others = [k for k in search.said if k in clash - set(culprits)]
    if not build_structure(graph).contradiction:
        # Of what is said of sizes the directions are not to blame.
        about_sizes = (Length, Diameter, EqualLength)
        sized = [k for k in others if isinstance(graph.annotations[k], about_sizes)]
        # A search that grew tired may have found none.
        others = others if not (sized or culprits) else sized
    return Clash(tuple(culprits), tuple(others))


def disagree(graph: SketchGraph, annotations: Mapping[str, Annotation] | None = None) -> bool:
    """Whether reasoning alone finds that annotations cannot all hold; by default the graph's."""
    if annotations is None:
        structure = build_structure(graph)
        return structure.contradiction or sizes_clash(topology_of(graph), structure)
    topology = topology_with(graph, annotations)
    directions = direction_classes(topology)
    if directions.contradiction:
        return True
    structure = structure_along(graph, topology, directions)
    return structure.contradiction or sizes_clash(topology, structure)


def clashing_annotations(graph: SketchGraph) -> tuple[str, ...]:
    """The annotations of a smallest clash, culprits first."""
    return find_clash(graph).ids


class _Search:
    """Asks whether annotations agree, few of them at a time where that will do."""

    def __init__(self, graph: SketchGraph, stop: Stop | None) -> None:
        self.graph = graph
        self.said = list(graph.annotations)
        self.asked: dict[frozenset[str], bool] = {}
        elements = len(graph.edges) + len(self.said)
        self.reason = questions_within_reason(elements)
        self.stop = asking(stop, elements)
        self.limit = MAX_QUESTIONS
        self.stopped = False

    def agree(self, ids: Iterable[str]) -> bool:
        """Whether no contradiction follows from these; not known, and False, after too many."""
        key = frozenset(ids)
        if key not in self.asked:
            self.stopped = self.stopped or (not self.tired and self.stop())
            if self.tired:
                return False
            annotations = {k: self.graph.annotations[k] for k in self.said if k in key}
            self.asked[key] = not disagree(self.graph, annotations)
        return self.asked[key]

    @property
    def tired(self) -> bool:
        """Whether enough was asked."""
        return self.stopped or len(self.asked) >= min(self.limit, self.reason)

    def culprits(self) -> list[str]:
        """All annotations without any one of which the others agree.

        Left out part by part: without a culprit's part the others agree too, and a part of evenly
        spread annotations seldom does that by itself, as true ones are backed by others.
        """
        parts = [self.said[k::PARTS] for k in range(min(PARTS, len(self.said)))]
        found = []
        while parts:
            part = parts.pop(0)
            left_out = set(part)
            if self.agree(k for k in self.said if k not in left_out):
                if len(part) == 1:
                    found += part
                else:
                    parts += [part[::2], part[1::2]]
        return found

    def smallest(self, members: Sequence[str]) -> set[str]:
        """A clash with some members, no part of which clashes; near annotations preferred."""
        last = self.said[-1]
        order = self._by_distance(members[0]) if members else [last, *self._by_distance(last)]
        near = [id_ for id_ in order if id_ not in members]
        if members and not self.agree(members):
            return set(members)
        enough = NEAREST
        while enough < len(near) and self.agree([*members, *near[:enough]]):
            enough *= 2
        return {*members, *self._needed(list(members), near[:enough], grown=False)}

    def _needed(self, base: list[str], others: list[str], *, grown: bool) -> list[str]:
        """Of others those without which a base does not clash with them (Junker's QuickXplain).

        Half of them is added to the base, and what is needed of the other half then; with that,
        what is needed of the first half. `grown` tells whether the base may clash by itself.
        """
        if self.tired:
            return others
        if grown and not self.agree(base):
            return others if self.tired else []
        if len(others) == 1:
            return others
        half = (len(others) + 1) // 2
        first, second = others[:half], others[half:]
        far = self._needed([*base, *first], second, grown=True)
        return [*self._needed([*base, *far], first, grown=bool(far)), *far]

    def _by_distance(self, member: str) -> list[str]:
        """The other annotations, those that speak of the same or of neighbouring vertices first."""
        joined: dict[str, set[str]] = {v: set() for v in self.graph.vertices}
        for v, w in self.graph.edges.values():
            joined[v].add(w)
            joined[w].add(v)
        distance = dict.fromkeys(self._vertices(member), 0)
        rim, step = list(distance), 0
        while rim:
            rim = list(dict.fromkeys(w for v in rim for w in joined[v] if w not in distance))
            step += 1
            distance.update(dict.fromkeys(rim, step))

        def far(id_: str) -> float:
            steps = [distance.get(v, len(joined)) for v in self._vertices(id_)]
            return sum(steps) / max(1, len(steps))

        return sorted((id_ for id_ in self.said if id_ != member), key=far)

    def _vertices(self, id_: str) -> set[str]:
        """The vertices that an annotation speaks of."""
        named = targets_of(self.graph.annotations[id_])
        ends = {v for e in named.get("edge", ()) for v in self.graph.edges[e]}
        faces = self.graph.drawn_faces or {}
        loops = {v for f in named.get("face", ()) if f in faces for v in faces[f].loop}
        return ends | loops | set(named.get("vertex", ()))


def without(graph: SketchGraph, *ids: str) -> SketchGraph:
    """The graph with annotations taken away."""
    return replace(graph, annotations=_fewer(graph.annotations, ids)) if ids else graph


@kept
def _fewer(annotations: Mapping[str, Annotation], ids: tuple[str, ...]) -> Mapping[str, Annotation]:
    """The same ones for the same annotations: a person drags, and nothing is reasoned out anew."""
    return frozen_mapping({id_: a for id_, a in annotations.items() if id_ not in ids})
