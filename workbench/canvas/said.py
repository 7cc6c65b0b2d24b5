"""Where the symbol of each annotation lies, to be pointed at: pure, no Qt.

Terms
-----
symbol
    What stands for one annotation in the drawing: lines, and areas with an inside.
size
    Photo px of one px of the screen: symbols keep their size on the screen at any zoom.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from ...solver.annotations import Ground
from . import style, symbols
from .marks import Marks, length_text
from .plane import Point, foot, is_inside, middle
from .symmetry import outline_of

if TYPE_CHECKING:
    from ...solver.annotations import Annotation
    from ...solver.graph import SketchGraph
    from .symbols import Stroke

#: A symbol is meant within this distance of its lines, px of the screen.
NEAR_PX = 3.5


@dataclass(frozen=True, slots=True)
class Symbol:
    """The lines of an annotation's symbol, and the areas that belong to it."""

    lines: tuple[Stroke, ...] = ()
    areas: tuple[Stroke, ...] = ()

    def distance(self, point: Point) -> float:
        """From a point; nothing in an area."""
        if any(is_inside(point, area) for area in self.areas):
            return 0.0
        outlines = (*self.lines, *((*area, area[0]) for area in self.areas))
        pieces = (piece for line in outlines for piece in pairwise(line))
        return min((math.dist(point, foot(point, *piece)) for piece in pieces), default=math.inf)

    def off_middle(self, point: Point) -> float:
        """From a point to the middle of the nearest of its strokes."""
        return min(math.dist(point, middle(stroke)) for stroke in (*self.areas, *self.lines))


@dataclass(frozen=True, slots=True)
class Places:
    """Where a graph's vertices and circles lie, and the size of a px of the screen there."""

    graph: SketchGraph
    marks: Marks
    at: Mapping[str, Point]
    circles: Mapping[str, Stroke]
    size: float = 1.0

    def ends(self, edge: str) -> tuple[Point, Point]:
        """The places of an edge's two ends."""
        v, w = self.graph.edges[edge]
        return self.at[v], self.at[w]


def on_photo(graph: SketchGraph, marks: Marks, size: float) -> Places:
    """The places in photo px."""
    circles = {c: symbols.ellipse(drawn.a, drawn.b) for c, drawn in graph.circles.items()}
    return Places(graph, marks, graph.vertices, circles, size)


def annotation_at(places: Places, point: Point) -> str | None:
    """The annotation whose symbol is at a place; of several the nearest.

    Parameters
    ----------
    places : Places
    point : (x, y)
        In the same px.
    """
    drawn = ((symbol_of(places, id_), id_) for id_ in places.graph.annotations)
    near = [(s, id_) for s, id_ in drawn if s.distance(point) <= NEAR_PX * places.size]
    # The ground lies below vertices, where others have their symbols too.
    others = [pair for pair in near if places.graph.annotations[pair[1]].kind != Ground.kind]
    # Right angles at one vertex cover each other in part: the one in whose middle the place is.
    nearest = min(others or near, key=lambda pair: pair[0].off_middle(point), default=(None, None))
    return nearest[1]


def symbol_of(places: Places, id_: str) -> Symbol:
    """The symbol of an annotation."""
    annotation = places.graph.annotations[id_]
    drawn = _SYMBOLS.get(annotation.kind)
    return Symbol() if drawn is None else drawn(places, id_, annotation)


def _right_angle(places: Places, id_: str, _: Annotation) -> Symbol:
    vertices = places.marks.right_angles.get(id_)
    if vertices is None:
        return Symbol()
    points = [places.at[v] for v in vertices]
    size = style.RIGHT_ANGLE_PX * places.size
    return Symbol(areas=((points[0], *symbols.right_angle(*points, size)),))


def _group(places: Places, _: str, annotation: Annotation) -> Symbol:
    of = ticks_on if annotation.kind == "equal_length" else arrows_on
    return Symbol(tuple(s for edge in annotation.edges for s in of(places, edge)))


def ticks_on(places: Places, edge: str) -> list[Stroke]:
    """The ticks on an edge that is as long as others."""
    count, beside = _counts(places, edge)
    spacing = style.MARK_SPACING_PX * places.size
    # An edge may have both kinds of marks: side by side then, not one over the other.
    shift = -spacing * (beside + 1) / 2 if beside else 0.0
    return symbols.ticks(*places.ends(edge), count, style.TICK_PX * places.size, spacing, shift)


def arrows_on(places: Places, edge: str) -> list[Stroke]:
    """The arrow heads on an edge that is parallel to others."""
    beside, count = _counts(places, edge)
    spacing = style.MARK_SPACING_PX * places.size
    shift = spacing * (beside + 1) / 2 if beside else 0.0
    return symbols.arrows(*places.ends(edge), count, style.ARROW_PX * places.size, spacing, shift)


def _counts(places: Places, edge: str) -> tuple[int, int]:
    marks = places.marks
    return marks.equal_lengths.get(edge, 0), marks.parallels.get(edge, 0)


def _symmetry_plane(places: Places, _: str, annotation: Annotation) -> Symbol:
    middles = [middle(places.ends(e)) for e in annotation.midpoints_of]
    size = style.DIAMOND_PX * places.size
    return Symbol((outline_of(middles),), tuple(symbols.diamond(m, size) for m in middles))


def _length(places: Places, _: str, annotation: Annotation) -> Symbol:
    everything = [*places.at.values(), *(p for line in places.circles.values() for p in line)]
    room = _room(places, length_text(annotation.length_mm))
    away = style.PLAQUE_DISTANCE_PX * places.size
    place = symbols.beside(*places.ends(annotation.edge), middle(everything), room, away)
    return Symbol(areas=(_box(place, room),))


def _diameter(places: Places, _: str, annotation: Annotation) -> Symbol:
    room = _room(places, f"\N{DIAMETER SIGN} {length_text(annotation.diameter_mm)}")
    x, y = max(places.circles[annotation.circle], key=lambda p: p[1])
    below = style.PLAQUE_DISTANCE_PX * places.size + room[1] / 2
    return Symbol(areas=(_box((x, y + below), room),))


def _ground(places: Places, _: str, annotation: Annotation) -> Symbol:
    return Symbol(tuple(s for v in annotation.vertices for s in ground_below(places, v)))


def ground_below(places: Places, vertex: str) -> list[Stroke]:
    """The ground on which a vertex stands: a shape, for who cannot tell the colour."""
    (x, y), below = places.at[vertex], style.GROUND_BELOW_PX * places.size
    return symbols.ground((x, y + below), style.GROUND_PX * places.size)


def _on_face(places: Places, _: str, annotation: Annotation) -> Symbol:
    (x, y), r = places.at[annotation.vertex], style.TOUCHING_PX * places.size
    return Symbol((symbols.ellipse(((x - r, y), (x + r, y)), ((x, y - r), (x, y + r)), 16),))


def _room(places: Places, text: str) -> Point:
    """About how much room a plaque takes; its font alone knows it exactly."""
    em = style.TEXT_PX * places.size
    return (0.62 * em * len(text) + 10 * places.size, 1.25 * em + 4 * places.size)


def _box(place: Point, room: Point) -> Stroke:
    (x, y), (w, h) = place, (room[0] / 2, room[1] / 2)
    return ((x - w, y - h), (x + w, y - h), (x + w, y + h), (x - w, y + h))


_SYMBOLS: dict[str, Callable[[Places, str, Annotation], Symbol]] = {
    "right_angle": _right_angle,
    "equal_length": _group,
    "parallel": _group,
    "symmetry_plane": _symmetry_plane,
    "length": _length,
    "diameter": _diameter,
    "ground": _ground,
    "on_face": _on_face,
}


def seen_at_vertex(graph: SketchGraph, vertex: str) -> Iterator[str]:
    """The annotations that a vertex itself shows: it is on the ground, or touches a face."""
    for id_, annotation in graph.annotations.items():
        on_ground = annotation.kind == "ground" and vertex in annotation.vertices
        if on_ground or (annotation.kind == "on_face" and vertex == annotation.vertex):
            yield id_
