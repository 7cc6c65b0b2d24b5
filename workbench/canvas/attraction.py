"""What attracts the pen besides the drawing itself, when it is asked to: pure, no Qt."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from .ground_grid import GroundGrid, ground_grid
from .lifted import ring_mm
from .photo_edges import Patch, photo_snap
from .snapping import Snap, SnapKind

if TYPE_CHECKING:
    from ...solver.camera import Camera
    from ...solver.graph import Point, SketchGraph
    from ...solver.values import Array
    from .solved import Solved

#: Places of their own, which come before guides.
PLACES = (SnapKind.PHOTO_CORNER, SnapKind.GRID)
#: What is not drawn: elements of the drawing come before anything here.
LOOSE = (SnapKind.FREE, SnapKind.PARALLEL, SnapKind.VANISHING)


def _no_patch(place_px: Point, reach_px: float) -> Patch | None:
    return None


def _points_of(solved: Solved | None) -> list[Array]:
    """What is drawn, in space: the grid is large enough for it."""
    if solved is None:
        return []
    rings = (ring_mm(circle) for circle in solved.solution.circles.values())
    return [*solved.solution.vertices_mm.values(), *(place for ring in rings for place in ring)]


class Attraction:
    """The grid on the ground and the edges of the photo, each of them off at first."""

    def __init__(self) -> None:
        self.grid_shown = False
        self.photo_edges = False
        #: The window of the photo around a place; the view knows it.
        self.patch: Callable[[Point, float], Patch | None] = _no_patch
        self._grid: tuple[tuple[object, object], GroundGrid | None] | None = None

    def grid(self, graph: SketchGraph, solved: Solved | None) -> GroundGrid | None:
        """The grid, where it is shown and a camera is known."""
        if not self.grid_shown:
            return None
        if solved is not None and not _is_same(graph.camera, solved.graph.camera):
            # It is of another world.
            solved = None
        camera = graph.camera if solved is None else solved.solution.camera
        if camera is None:
            return None
        if self._grid is None or self._grid[0] != (camera, solved):
            self._grid = ((camera, solved), ground_grid(camera, _points_of(solved)))
        return self._grid[1]

    def attract(self, found: Snap, reach_px: float, grid: GroundGrid | None) -> Snap:
        """Where a press lands: as found, or where something attracts it.

        Parameters
        ----------
        found : Snap
            What the drawing itself says of the pointer.
        reach_px : float
        grid : GroundGrid or None
        """
        if found.kind not in LOOSE:
            return found
        pulls = []
        # A guide may have led the pointer away from where it is: by no more than the reach.
        if self.photo_edges:
            patch = self.patch(found.point_px, reach_px)
            pulls.append(None if patch is None else photo_snap(patch, found.point_px, reach_px))
        if grid is not None:
            pulls.append(grid.snap(found.point_px, reach_px))
        there = [pull for pull in pulls if pull is not None]
        places = [pull for pull in there if pull.kind in PLACES and pull.guide is None]
        if places:
            return places[0]
        return there[0] if there and found.kind is SnapKind.FREE else found


def _is_same(one: Camera | None, other: Camera | None) -> bool:
    """Whether two known cameras are one, or none is known."""
    if one is None or other is None or one is other:
        return one is other
    return one.to_json() == other.to_json()
