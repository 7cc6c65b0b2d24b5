"""What is said of the profiles of surfaces of revolution, held in the side plane.

The circles are solved first, and a profile is where it is drawn in the side plane (`revolution`).
Its vertices are unknowns (x, z) there, and so are the radii and heights of the circles at its ends,
but for those that something else says: the ground, a diameter, something traced. What is said of
the profile's edges then holds with the least stretching, edges being elastic bars and each vertex
an elastic hoop: where a side is longer, what is above it is lifted and nothing else changes. Where
all holds as drawn, nothing is changed at all.

Terms
-----
end
    The first or last vertex of a profile: it goes with its circle.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from .annotations import (
    Annotation,
    EqualLength,
    Ground,
    Length,
    Parallel,
    RightAngle,
)
from .candidates import drawn_diagonal
from .full import FullProblem, Pose
from .graph import Revolution, SketchGraph
from .problem import IMAGINED_SIGMA
from .sides import LEAST_BAR, Planes, Sides, conditions_on_sides, met, worst_first
from .values import Array
from .world import Lifted

#: An end so near to that of an axis is there. Where a hand drew, and not a projection, that misses
#: the circles by no more than this, it may be as far off as hands are.
AT_AN_END_PX, EXACT_PX = 2.0, 0.05
#: A vertex that follows keeps at least this part of its distance from the axis.
SLIMMEST = 0.2
#: A profile that is moved by this part of the shape's size (RMS) is another than the drawn one.
ANOTHER = 0.012


@dataclass(frozen=True, slots=True, eq=False)
class HeldProfiles:
    """A shape in which what is said of the profiles holds.

    Parameters
    ----------
    shape : Lifted
    wished : tuple of annotation ids
        What the drawing contradicts.
    """

    shape: Lifted
    wished: tuple[str, ...] = ()


def said_of_profiles(graph: SketchGraph, core: SketchGraph) -> dict[str, Annotation]:
    """The annotations that the sketch without the profiles does not say."""
    if graph is core:
        return {}
    kinds = (Length, EqualLength, Parallel, RightAngle, Ground)
    return {
        id_: a
        for id_, a in graph.annotations.items()
        if isinstance(a, kinds) and core.annotations.get(id_) != a
    }


def ends_on_circles(
    graph: SketchGraph, shape: Lifted, planes: Planes, full: FullProblem, pose: Pose
) -> frozenset[str]:
    """The ends of profiles that are drawn on their circles, as well as the drawing is.

    At an end of the ellipse's major or minor axis, where the tools put them, or where the side
    plane meets the circle.
    """
    problem = full.problem
    n = max(1, 2 * len(problem.points) + problem.circles.supports.size)
    rms_px = float(np.sqrt(2 * full.misfit(pose) / n)) * problem.px_per_unit
    near_px = AT_AN_END_PX
    if rms_px > EXACT_PX:
        near_px = max(near_px, IMAGINED_SIGMA * drawn_diagonal(problem) * problem.px_per_unit)
    found = set()
    for id_, r in graph.revolutions.items():
        for v, c in ((r.profile[0], r.bottom), (r.profile[-1], r.top)):
            x, _ = planes[id_].local(shape.vertices[v])
            rim = shape.centres[c] + np.copysign(shape.radii[c], x) * planes[id_].side
            in_cam = pose.R @ rim
            seen = np.exp(pose.log_focal) * in_cam[:2] / in_cam[2] * problem.px_per_unit
            ellipse = graph.circles[c]
            places = [*ellipse.a, *ellipse.b, seen + np.array(graph.principal_point_px)]
            if min(math.dist(graph.vertices[v], p) for p in places) <= near_px:
                found.add(v)
    return frozenset(found)


def followed(
    graph: SketchGraph, core: SketchGraph, drawn: Lifted, wished: Lifted, planes: Planes
) -> dict[str, Array]:
    """The profiles' vertices where circles have other sizes than they are drawn with.

    A profile follows its two ends, affinely in the side plane; in proportion where it is so slim
    that it would come out on the other side of the axis.
    """
    found: dict[str, Array] = {}
    for id_, r in graph.revolutions.items():
        plane, base = planes[id_], wished.centres[r.ground]
        before, after = (_ends_of(r, shape, plane.up) for shape in (drawn, wished))
        own = [v for v in r.profile if v not in core.vertices]
        x, z = np.array([plane.local(drawn.vertices[v]) for v in own]).reshape(-1, 2).T
        rise = before[1, 1] - before[0, 1]
        flat = abs(rise) <= LEAST_BAR * float(before[:, 0].max())
        part = np.full(len(own), 0.5) if flat else (z - before[0, 1]) / rise
        weights = np.stack([1 - part, part])
        within = np.clip(weights, 0.0, 1.0)
        wider = (after - before)[:, 0] @ within
        if bool((np.abs(x) + wider < SLIMMEST * np.abs(x)).any()):
            wider = np.abs(x) * ((after / before)[:, 0] @ within - 1)
        x, z = x + np.sign(x) * wider, z + (after - before)[:, 1] @ weights
        found |= {v: plane.at(base, *place) for v, *place in zip(own, x, z, strict=True)}
    return found


def _ends_of(r: Revolution, shape: Lifted, up: Array) -> Array:
    """Radius, and height above the ground, of the bottom and the top circle, (2, 2)."""
    base = shape.centres[r.ground]
    ends = [(shape.radii[c], (shape.centres[c] - base) @ up) for c in (r.bottom, r.top)]
    return np.array(ends)


def held(
    graph: SketchGraph,
    core: SketchGraph,
    shape: Lifted,
    planes: Planes,
    unit_mm: float | None,
    attached: frozenset[str],
) -> HeldProfiles:
    """The shape with what is said of the profiles; as it is where that cannot hold.

    Parameters
    ----------
    graph, core : SketchGraph
        The whole sketch, and what was solved of it.
    shape : Lifted
        With the profiles as drawn.
    planes : mapping of revolution id to SidePlane
    unit_mm : float or None
        How large the shape's unit is; None where only the profiles tell it.
    attached : frozenset of vertex ids
        Ends that are drawn on their circles.
    """
    said = said_of_profiles(graph, core)
    if not said or not all(np.isfinite(x).all() for x in shape.vertices.values()):
        return HeldProfiles(shape)
    sides = Sides(graph, core, shape, planes, _on_circles(graph, said, attached))
    conditions = list(conditions_on_sides(graph, said, unit_mm))
    try:
        q = met(sides, conditions)
    except np.linalg.LinAlgError:
        q = None
    if q is None or not sides.free:
        return HeldProfiles(shape)
    moved = np.linalg.norm(sides.points(q) - sides.points(0 * q), axis=1)[sides.free]
    other = np.sqrt(np.mean(moved**2)) > ANOTHER * sides.size
    return HeldProfiles(sides.shape(q), worst_first(sides, conditions) if other else ())


def _on_circles(
    graph: SketchGraph, said: Mapping[str, Annotation], attached: frozenset[str]
) -> frozenset[str]:
    """The ends that are put on their circles: those of edges whose size is said."""
    named: set[str] = set()
    for a in said.values():
        edges = (a.edge,) if isinstance(a, Length) else getattr(a, "edges", ())
        named.update(v for e in edges for v in graph.edges[e])
    return attached & named
