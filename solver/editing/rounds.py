"""Edits of circles and surfaces of revolution: each gives a new valid graph, the old one stays.

Terms
-----
axis end
    One of an ellipse's four points on its axes, by which it is edited ([Lau10] 3.1).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import replace

from ..annotations import Diameter
from ..errors import SketchError
from ..graph import Ellipse, Point, Revolution, SketchGraph
from ..ids import fresh_id, need
from ..reading.parsing import check_references
from .annotating import need_size, say_once, without_annotations
from .elements import move_vertices, rounded


def ellipse_in_box(a: Point, b: Point) -> Ellipse:
    """The ellipse that touches the four sides of an upright box, by two opposite corners of it."""
    (left, right), (top, bottom) = sorted((a[0], b[0])), sorted((a[1], b[1]))
    u, v = (left + right) / 2, (top + bottom) / 2
    return ordered(Ellipse(((left, v), (right, v)), ((u, top), (u, bottom))))


def ordered(drawn: Ellipse) -> Ellipse:
    """The same ellipse, its longer axis first, positions as files keep them."""
    axes = [(rounded(p), rounded(q)) for p, q in (drawn.a, drawn.b)]
    if math.dist(*axes[0]) < math.dist(*axes[1]):
        axes.reverse()
    return Ellipse(axes[0], axes[1])


def add_circle(graph: SketchGraph, drawn: Ellipse) -> tuple[SketchGraph, str]:
    """The graph with one more circle, and its id."""
    circle = fresh_id("c", (*graph.circles, *graph.edges))
    return replace(graph, circles={**graph.circles, circle: ordered(drawn)}), circle


def shifted(drawn: Ellipse, by_px: Point) -> Ellipse:
    """The ellipse moved by so much."""
    du, dv = by_px
    (a1, a2), (b1, b2) = (tuple((u + du, v + dv) for u, v in axis) for axis in (drawn.a, drawn.b))
    return Ellipse((a1, a2), (b1, b2))


def pulled(drawn: Ellipse, axis: str, end: int, to_px: Point) -> Ellipse:
    """The ellipse with one axis end elsewhere; the end opposite to it stays.

    The other axis keeps its length, in the middle of the pulled one and at right angles to it.

    Parameters
    ----------
    drawn : Ellipse
    axis : "a" or "b"
    end : 0 or 1
    to_px : (u, v)
    """
    along, across = (drawn.a, drawn.b) if axis == "a" else (drawn.b, drawn.a)
    stays = along[1 - end]
    length, half = math.dist(to_px, stays), math.dist(*across) / 2
    if length == 0:
        return drawn
    du, dv = (to_px[0] - stays[0]) / length, (to_px[1] - stays[1]) / length
    # The ends of the other axis keep their sides.
    side = (across[1][0] - across[0][0]) * -dv + (across[1][1] - across[0][1]) * du
    half = math.copysign(half, side)
    u, v = (to_px[0] + stays[0]) / 2, (to_px[1] + stays[1]) / 2
    pulled_axis = (to_px, stays) if end == 0 else (stays, to_px)
    other = ((u + half * dv, v - half * du), (u - half * dv, v + half * du))
    return Ellipse(pulled_axis, other) if axis == "a" else Ellipse(other, pulled_axis)


def set_diameter(graph: SketchGraph, circle: str, diameter_mm: float | None) -> SketchGraph:
    """The graph with a diameter said of a circle; None takes it back.

    Raises
    ------
    SketchError
        Where the diameter is not above 0, or the circle is not there.
    """
    need((circle,), graph.circles)
    said = [
        i for i, a in graph.annotations.items() if isinstance(a, Diameter) and a.circle == circle
    ]
    if diameter_mm is None:
        return without_annotations(graph, said)
    need_size("diameter", diameter_mm, circle)
    return say_once(graph, said, Diameter(circle, float(diameter_mm)))


def set_revolution(
    graph: SketchGraph, circles: tuple[str, str, str], profile: Iterable[str]
) -> tuple[SketchGraph, str]:
    """The graph with a surface of revolution on three circles, and its id.

    Where there is one on these three circles already, it gets the profile.

    Parameters
    ----------
    graph : SketchGraph
    circles : tuple of circle ids
        Ground, bottom, top.
    profile : iterable of vertex ids
        From the bottom to the top circle, two or more.

    Raises
    ------
    SketchError
        Where something is not there, or the profile is too short.
    """
    vertices = tuple(profile)
    if len(vertices) < 2:
        raise SketchError("a side of fewer than two points", vertices, "draw it from bottom to top")
    said = {(r.ground, r.bottom, r.top): id_ for id_, r in graph.revolutions.items()}
    id_ = said.get(circles) or fresh_id("r", graph.revolutions)
    larger = replace(graph, revolutions={**graph.revolutions, id_: Revolution(*circles, vertices)})
    check_references(larger)
    return larger, id_


def move(
    graph: SketchGraph,
    vertices: Mapping[str, Point],
    circles: Mapping[str, Ellipse] | None = None,
) -> SketchGraph:
    """The graph with vertices and circles elsewhere; what they share places with follows.

    A vertex that lies on an axis end of a circle stays on it, whichever of the two is moved.

    Raises
    ------
    SketchReferenceError
        Where one is not there.
    """
    given = circles or {}
    need(given, graph.circles)
    drawn = {c: ordered(ellipse) for c, ellipse in given.items()}
    follow = {
        v: place
        for c, ellipse in given.items()
        for old, place in zip(_ends(graph.circles[c]), _ends(ellipse), strict=True)
        for v in vertices_at(graph, old)
        if v not in vertices
    }
    for v, place in vertices.items():
        for c, ellipse in graph.circles.items():
            ends = [(axis, k) for axis in "ab" for k in (0, 1)]
            for (axis, k), old in zip(ends, _ends(ellipse), strict=True):
                if c not in drawn and old == graph.vertices.get(v):
                    drawn[c] = ordered(pulled(ellipse, axis, k, place))
    moved = move_vertices(graph, {**vertices, **follow})
    return replace(moved, circles={**graph.circles, **drawn})


def _ends(drawn: Ellipse) -> tuple[Point, Point, Point, Point]:
    return (*drawn.a, *drawn.b)


def vertices_at(graph: SketchGraph, point_px: Point) -> list[str]:
    """The vertices that lie in one place."""
    return [v for v, place in graph.vertices.items() if place == point_px]
