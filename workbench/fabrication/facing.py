"""Where plates face one another closely, and the ways that are blocked by that alone.

Terms
-----
side, cap
    What bounds a plate: a rectangle over each edge of its rings; its two flat faces.
facing
    Two parallel sides of two plates that look at one another, or points of a plate's sides before
    the cap of another. Moved along d, at an angle a to the normal of the second face, the first
    reaches it g tan(a) off: it runs into it wherever that is less than the radius r of a circle
    that both share (or the face alone, about the point).

Source: R. H. Wilson, J.-C. Latombe, Geometric reasoning about mechanical assembly (1994), 3: the
half-spaces blocked by contacts; the gap g is for play.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.values import Array
from .plates import Plate

#: Plates may overlap so much without touching: sweeps, which decide, are made thinner by half.
SLACK_MM = 1e-2
#: A way this near to square to a normal slides along the face: off by SLACK_MM over a metre.
SLIDES = 1e-5
_PARALLEL = 1e-9
_LEAST_GAP_MM = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Facings:
    """The facings of some plates, one a row.

    Parameters
    ----------
    pairs : (k, 2) array of int
        The plates; the first one's face looks along the normal.
    normals : (k, 3) array
    slopes : (k,) array
        r / g of the module's terms.
    """

    pairs: Array
    normals: Array
    slopes: Array

    def blocked(self, ways: Array, count: int) -> Array:
        """Which plates surely run into which: (ways, plates, plates) of bool.

        Parameters
        ----------
        ways : (m, 3) array
            Unit vectors; each odd row is opposite to the row before it.
        count : int
            How many plates there are.
        """
        surely = np.zeros((len(ways), count, count), dtype=bool)
        for (one, other), normal, slope in zip(self.pairs, self.normals, self.slopes, strict=True):
            ahead = ways @ normal
            hits = ahead > np.maximum(SLIDES, np.sqrt(np.maximum(0.0, 1 - ahead**2)) / slope)
            surely[:, one, other] |= hits
            surely[:, other, one] |= hits.reshape(-1, 2)[:, ::-1].ravel()
        return surely


@dataclass(frozen=True, slots=True, eq=False)
class _Sides:
    """The rectangles over the edges of a plate, in the world: starts, edges, normals."""

    plate: Plate
    area: Polygon
    starts: Array
    edges: Array
    normals: Array

    @property
    def up(self) -> Array:
        return np.asarray(self.plate.world_from_plate[:3, 2])

    @property
    def middles(self) -> Array:
        """Of each rectangle, of its lower and of its upper edge: (3, k, 3)."""
        rise = self.plate.thickness_mm * self.up
        lower = self.starts + self.edges / 2
        return np.stack([lower, lower + rise / 2, lower + rise])

    def corners(self, some: Array) -> Array:
        """(k, 4, 3), in the world."""
        start, end = self.starts[some], self.starts[some] + self.edges[some]
        rise = self.plate.thickness_mm * self.up
        return np.stack([start, end, end + rise, start + rise], axis=1)


def facings(plates: Sequence[Plate]) -> Facings:
    """All facings of plates that are nearer than they are thick."""
    sides = [_sides(plate) for plate in plates]
    lows = np.array([plate.corners_mm.min(axis=0) for plate in plates])
    highs = np.array([plate.corners_mm.max(axis=0) for plate in plates])
    found: dict[tuple[int, int, tuple[float, ...]], tuple[Array, float]] = {}
    for one, two in combinations(range(len(plates)), 2):
        reach = min(plates[one].thickness_mm, plates[two].thickness_mm)
        if np.maximum(lows[one] - highs[two], lows[two] - highs[one]).max() > reach:
            continue
        before = [(1.0, _before_caps(sides[one], sides[two], reach))]
        before += [(-1.0, _before_caps(sides[two], sides[one], reach))]
        before += [(1.0, _sides_facing(sides[one], sides[two], reach))]
        for sign, (normals, slopes) in before:
            for normal, slope in zip(sign * normals, slopes.tolist(), strict=True):
                key = (one, two, tuple((np.round(normal, 6) + 0.0).tolist()))
                if key not in found or slope > found[key][1]:
                    found[key] = (normal, slope)
    pairs = np.array([key[:2] for key in found], dtype=int).reshape(-1, 2)
    normals = np.array([normal for normal, _ in found.values()]).reshape(-1, 3)
    return Facings(pairs, normals, np.array([slope for _, slope in found.values()]))


def _sides_facing(one: _Sides, two: _Sides, reach: float) -> tuple[Array, Array]:
    """Normals of the first, and slopes."""
    first, second = np.nonzero(one.normals @ two.normals.T < _PARALLEL - 1)
    gaps = np.einsum("ij,ij->i", two.starts[second] - one.starts[first], one.normals[first])
    near = (gaps > -SLACK_MM) & (gaps < reach)
    first, second, gaps = first[near], second[near], gaps[near]
    along = one.edges[first] / np.linalg.norm(one.edges[first], axis=1)[:, None]
    frame = np.stack([along, np.broadcast_to(one.up, along.shape)], axis=2)
    origin = one.starts[first][:, None]
    quads = [(side.corners(n) - origin) @ frame for side, n in ((one, first), (two, second))]
    areas = shapely.intersection(*map(shapely.polygons, quads))
    radii = shapely.distance(shapely.centroid(areas), shapely.boundary(areas))
    wide = radii > SLACK_MM
    return one.normals[first[wide]], radii[wide] / np.maximum(gaps[wide], _LEAST_GAP_MM)


def _before_caps(one: _Sides, two: _Sides, reach: float) -> tuple[Array, Array]:
    """The ways of the first straight into the second, and slopes: the widest before each cap."""
    plate, border = two.plate, two.area.boundary
    rotation, origin = plate.world_from_plate[:3, :3], plate.world_from_plate[:3, 3]
    points = ((one.middles - origin) @ rotation).reshape(-1, 3)
    normals, slopes = [], []
    for sign, gaps in ((1.0, -points[:, 2]), (-1.0, points[:, 2] - plate.thickness_mm)):
        near = (gaps > -SLACK_MM) & (gaps < reach)
        flat = shapely.points(points[near, :2])
        inner = shapely.contains(two.area, flat)
        radii = shapely.distance(flat[inner], border)
        wide = radii > SLACK_MM
        if wide.any():
            normals.append(sign * rotation[:, 2])
            slopes.append((radii / np.maximum(gaps[near][inner], _LEAST_GAP_MM))[wide].max())
    return np.array(normals).reshape(-1, 3), np.array(slopes)


def _sides(plate: Plate) -> _Sides:
    rings = (plate.outline, *plate.holes)
    steps = np.vstack([np.roll(ring, -1, axis=0) - ring for ring in rings])
    lengths = np.linalg.norm(steps, axis=1)
    real = lengths > 0.0
    flat, steps = np.vstack(rings)[real], steps[real]
    rotation, origin = plate.world_from_plate[:3, :3], plate.world_from_plate[:3, 3]
    edges = steps @ rotation[:, :2].T
    normals = np.cross(edges, rotation[:, 2]) / lengths[real, None]
    return _Sides(plate, plate.polygon, flat @ rotation[:, :2].T + origin, edges, normals)
