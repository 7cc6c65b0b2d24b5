"""The last good solution as the canvas uses it: pure, no Qt.

Terms
-----
place
    Photo position of a vertex: as it is drawn now, else where the solution is seen.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ...solver.editing.listing import choices, found_faces
from ...solver.geometry import cross
from .plane import Point, is_inside, middle

if TYPE_CHECKING:
    from ...solver.graph import Face, SketchGraph
    from ...solver.solution import Solution


#: Edges whose lines pass this near to each other, in parts of their lengths, meet.
NEAR = 1e-3
#: A direction this near to the photo's plane (sine) vanishes too far off to lead anything.
FLAT = 1e-4


@dataclass(frozen=True, eq=False)
class Solved:
    """A sketch that was solved, with its solution.

    Parameters
    ----------
    graph : SketchGraph
        What was solved; the drawing may have gone on since.
    solution : Solution
        With a camera.
    """

    graph: SketchGraph
    solution: Solution

    @cached_property
    def found(self) -> Mapping[str, Face]:
        """All minimal planar loops, see `listing.found_faces`."""
        return found_faces(self.graph, self.solution)

    @cached_property
    def seen(self) -> Mapping[str, Point]:
        """Photo positions of all lifted vertices, mirrored ones too."""
        return dict(
            zip(
                self.solution.vertices_mm,
                self.on_photo(self.solution.vertices_mm.values()),
                strict=True,
            )
        )

    @cached_property
    def vanishing_px(self) -> tuple[Point, ...]:
        """Where the object's three directions meet in the photo, those at a finite place."""
        camera = self.solution.camera
        if camera is None:
            return ()
        places = []
        for towards in camera.rotation_cam_from_world.T:
            if abs(towards[2]) > FLAT:
                u, v = camera.focal_px * towards[:2] / towards[2] + camera.principal_point_px
                places.append((float(u), float(v)))
        return tuple(places)

    def meet(self, one: str, two: str) -> bool:
        """Whether two edges, lengthened, meet in space."""
        edges, at = self.solution.edges, self.solution.vertices_mm
        if one not in edges or two not in edges:
            return False
        p, q, r, s = (at[v] for e in (one, two) for v in edges[e])
        across = cross(q - p, s - r)
        width = float(np.linalg.norm(across))
        size = float(np.linalg.norm(q - p) + np.linalg.norm(s - r))
        return width > 0 and abs(float((r - p) @ across)) <= NEAR * size * width

    def on_photo(self, points_mm: Iterable[np.ndarray]) -> list[Point]:
        """Photo positions of world points."""
        points = np.array(list(points_mm), dtype=float).reshape(-1, 3)
        if self.solution.camera is None or not len(points):
            return []
        return [(float(u), float(v)) for u, v in self.solution.camera.project(points)]


def face_choices(graph: SketchGraph, solved: Solved | None) -> dict[str, Face]:
    """The faces of which something can be said, by id, see `listing.choices`.

    Loops of a solution that is older than the drawing are there while all their vertices are.
    """
    return choices(graph, {} if solved is None else solved.found)


#: Why there are no faces to say something of, as a hint.
NO_FACES = "Faces are known once the sketch is solved: the line below says what is missing"


def places(graph: SketchGraph, solved: Solved | None) -> dict[str, Point]:
    """Where all vertices are: as they are drawn, mirrored ones as they were seen last."""
    return {**({} if solved is None else solved.seen), **graph.vertices}


def outline(at: Mapping[str, Point], loop: Iterable[str]) -> tuple[Point, ...]:
    """The places of a loop's vertices."""
    return tuple(at[v] for v in loop)


def face_at(at: Mapping[str, Point], faces: Mapping[str, Face], point_px: Point) -> str | None:
    """The face that a photo position means: around it, its middle the nearest ([Lau10] 3.2).

    In a box drawn with its hidden edges every place lies in several; each has a place of its own
    about its middle.
    """
    outlines = {id_: outline(at, face.loop) for id_, face in faces.items()}
    around = [id_ for id_, places in outlines.items() if is_inside(point_px, places)]
    return min(around, key=lambda id_: math.dist(middle(outlines[id_]), point_px), default=None)
