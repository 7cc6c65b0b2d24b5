"""A grid on the ground in the photo's perspective, which guides the hand: pure, no Qt.

Terms
-----
spacing
    Between two lines, mm: 1, 2 or 5 times a power of ten.
crossing
    Where two lines of the grid meet.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ...solver.values import Array
from .perspective import on_plane
from .plane import on_line
from .snapping import Snap, SnapKind

if TYPE_CHECKING:
    from ...solver.camera import Camera
    from .plane import Point

#: About so many spacings make up the object's width.
CELLS = 6
#: The grid goes on around the object for so many times its width.
AROUND = 1.2
#: Every fifth line is stronger.
STRONG_EVERY = 5
#: Nothing nearer to the camera than this part of its distance from the object is shown.
NEAREST = 0.05
#: Lines lead within this many times the reach: less than a crossing, as guides do.
LINE_REACH = 0.6


@dataclass(frozen=True, eq=False)
class GroundGrid:
    """Lines along the object's two horizontal directions, through the world's origin.

    Parameters
    ----------
    camera : Camera
    spacing_mm : float
    first, last : (2,) arrays of int
        The first and the last line across x and across y, counted from the origin.
    """

    camera: Camera
    spacing_mm: float
    first: Array
    last: Array

    @cached_property
    def lines_px(self) -> tuple[list[tuple[Point, Point]], list[tuple[Point, Point]]]:
        """The fine and the strong lines as they are seen."""
        found: tuple[list[tuple[Point, Point]], list[tuple[Point, Point]]] = ([], [])
        ends = (self.first * self.spacing_mm, self.last * self.spacing_mm)
        for axis in (0, 1):
            for k in range(int(self.first[axis]), int(self.last[axis]) + 1):
                line = np.array([[*end, 0.0] for end in ends])
                line[:, axis] = k * self.spacing_mm
                seen = self._seen(line)
                if seen is not None:
                    found[k % STRONG_EVERY == 0].append(seen)
        return found

    def _seen(self, line_mm: Array) -> tuple[Point, Point] | None:
        """The part of a line that lies before the camera."""
        turn, shift = self.camera.rotation_cam_from_world, self.camera.translation_cam_from_world_mm
        depths = line_mm @ turn[2] + shift[2]
        middle = (self.first + self.last) / 2 * self.spacing_mm
        least = NEAREST * float(np.linalg.norm(self.camera.position_mm - [*middle, 0.0]))
        if depths.max() <= least:
            return None
        near, far = (line_mm[k] for k in np.argsort(depths))
        if depths.min() < least:
            near = far + (near - far) * (depths.max() - least) / np.ptp(depths)
        (u1, v1), (u2, v2) = self.camera.project(np.array([near, far])).tolist()
        return (u1, v1), (u2, v2)

    def snap(self, point_px: Point, reach_px: float) -> Snap | None:
        """The crossing that is within reach, else the place on the nearest line.

        Parameters
        ----------
        point_px : (u, v)
        reach_px : float
        """
        at = on_plane(self.camera, point_px, np.zeros(3), np.array([0.0, 0.0, 1.0]))
        if at is None:
            return None
        there = at[:2] / self.spacing_mm
        nearest = np.rint(there)
        if (nearest < self.first).any() or (nearest > self.last).any():
            return None
        crossing = self._px(nearest)
        if math.dist(crossing, point_px) <= reach_px:
            return Snap(SnapKind.GRID, crossing)
        # A line of the ground is straight in the photo: two places of it say where it is.
        feet = []
        for axis in (0, 1):
            on_it = there.copy()
            on_it[axis] = nearest[axis]
            other = on_it.copy()
            other[1 - axis] += 0.25
            line = (self._px(on_it), self._px(other))
            feet.append((on_line(point_px, *line), line))
        place, line = min(feet, key=lambda found: math.dist(found[0], point_px))
        near = math.dist(place, point_px) <= LINE_REACH * reach_px
        return Snap(SnapKind.GRID, place, guide=line) if near else None

    def _px(self, cells: Array) -> Point:
        u, v = self.camera.project(np.array([*(cells * self.spacing_mm), 0.0]))[0]
        return (float(u), float(v))


def ground_grid(camera: Camera, points_mm: Iterable[Array]) -> GroundGrid | None:
    """The grid about some points; None where the camera does not see the ground from above.

    Parameters
    ----------
    camera : Camera
    points_mm : iterable of (3,) arrays
        The object's vertices; none where only the camera is known.
    """
    height = float(camera.position_mm[2])
    if not np.isfinite(camera.position_mm).all() or height <= 0:
        return None
    points = np.array(list(points_mm), dtype=float).reshape(-1, 3)
    if len(points):
        middle = (points.min(axis=0) + points.max(axis=0))[:2] / 2
        width = float(np.ptp(points, axis=0).max())
    else:
        middle, width = _seen_at(camera), height / 2
    if width <= 0:
        return None
    spacing = nice_below(width / CELLS)
    reach = AROUND * width
    return GroundGrid(
        camera,
        spacing,
        np.ceil((middle - reach) / spacing),
        np.floor((middle + reach) / spacing),
    )


def _seen_at(camera: Camera) -> Array:
    """Where the axis of view meets the ground, or the place below the camera."""
    u, v = camera.principal_point_px
    at = on_plane(camera, (float(u), float(v)), np.zeros(3), np.array([0.0, 0.0, 1.0]))
    return np.asarray((camera.position_mm if at is None else at)[:2])


def nice_below(length_mm: float) -> float:
    """The largest 1, 2 or 5 times a power of ten that is no longer than a length."""
    power = 10.0 ** math.floor(math.log10(length_mm))
    return max(step * power for step in (1.0, 2.0, 5.0) if step * power <= length_mm * (1 + 1e-9))
