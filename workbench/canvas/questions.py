"""What a person is asked for in a small field over the photo: a length of some kind."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from typing import TYPE_CHECKING

from .plane import Point, middle

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from .selection import Selection


class About(Enum):
    """What a length is said of."""

    EDGE = "edge"
    CIRCLE = "circle"
    FACE = "face"


@dataclass(frozen=True, slots=True)
class Question:
    """How long, how wide, how thick?

    Parameters
    ----------
    about : About
    target : str
        The edge's, circle's or face's id.
    at_px : (u, v)
        Photo position of the field.
    said_mm : float or None
        What was said so far.
    """

    about: About
    target: str
    at_px: Point
    said_mm: float | None = None


def about_edge(graph: SketchGraph, edge: str) -> Question:
    """How long is an edge?"""
    lengths = graph.annotations_of("length").values()
    said = next((a.length_mm for a in lengths if a.edge == edge), None)
    return Question(About.EDGE, edge, middle([graph.vertices[v] for v in graph.edges[edge]]), said)


def about_circle(graph: SketchGraph, circle: str) -> Question:
    """How wide is a circle?"""
    diameters = graph.annotations_of("diameter").values()
    said = next((a.diameter_mm for a in diameters if a.circle == circle), None)
    return Question(About.CIRCLE, circle, middle(graph.circles[circle].a), said)


def about_annotation(graph: SketchGraph, id_: str) -> Question | None:
    """The question to which an annotation is the answer; None where it is no size."""
    annotation = graph.annotations[id_]
    if annotation.kind == "length":
        return about_edge(graph, annotation.edge)
    return about_circle(graph, annotation.circle) if annotation.kind == "diameter" else None


def about_selection(graph: SketchGraph, chosen: Selection) -> Question | None:
    """The one question that what is selected can answer; None where there is none, or several."""
    of_sizes = (about_annotation(graph, id_) for id_ in chosen.annotations)
    found = [question for question in of_sizes if question is not None]
    found += [about_edge(graph, edge) for edge in chosen.edges]
    found += [about_circle(graph, circle) for circle in chosen.circles]
    return found[0] if len(found) == 1 else None


@dataclass(frozen=True, slots=True)
class KnownRectangle:
    """Something flat on the ground whose size is known: it tells where the camera was.

    Parameters
    ----------
    corners_px : four (u, v)
        In order around; none forgets the camera.
    size_mm : (float, float) or None
        Its sides; None where a person has still to say them.
    """

    corners_px: tuple[Point, ...]
    size_mm: tuple[float, float] | None = None

    def with_corner(self, k: int, point_px: Point) -> KnownRectangle:
        """The same with one corner elsewhere."""
        corners = (*self.corners_px[:k], point_px, *self.corners_px[k + 1 :])
        return replace(self, corners_px=corners)
