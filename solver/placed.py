"""The lifted shape in the world: vertices and circles in mm, and the camera that sees them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from .camera import Camera
from .full import FullProblem, Pose
from .graph import SketchGraph
from .problem import Problem
from .profiles import ends_on_circles, followed, held, said_of_profiles
from .revolution import SidePlane
from .sides import Planes
from .solution import SolvedCircle
from .values import Array, FrozenRows, rows_of
from .world import Lifted, Placement, place, up_direction


@dataclass(frozen=True, slots=True, eq=False)
class Placed:
    """Where everything drawn is.

    Parameters
    ----------
    vertices : mapping of vertex id to (3,) array, mm
        In the sketch's order.
    circles : mapping of circle id to SolvedCircle
    camera : Camera
    scale_assumed : bool
    camera_off_mm : float
        How far a known camera had to be moved for the given lengths.
    wished : tuple of annotation ids
        What is said of profiles though the drawing shows otherwise.
    """

    vertices: Mapping[str, Array]
    circles: Mapping[str, SolvedCircle]
    camera: Camera
    scale_assumed: bool
    camera_off_mm: float
    wished: tuple[str, ...] = ()

    def reprojection_px(self, graph: SketchGraph) -> dict[str, float]:
        """Distance between each drawn and projected vertex, px."""
        if not self.vertices:
            return {}
        off = self.camera.project(rows_of(self.vertices)) - graph.positions_px
        return dict(zip(self.vertices, np.hypot(off[:, 0], off[:, 1]).tolist(), strict=True))


def put_in_world(
    graph: SketchGraph, core: SketchGraph, full: FullProblem, pose: Pose, drawn: Pose | None = None
) -> Placed:
    """Choose the world's frame and size, and put the shape there.

    Parameters
    ----------
    graph : SketchGraph
        The whole sketch.
    core : SketchGraph
        The part of it that the problem and the pose speak of.
    full : FullProblem
    pose : Pose
    drawn : Pose, optional
        What the drawing shows where sizes are wished that it contradicts.
    """
    problem = full.problem
    shape, wished = _shape(graph, core, full, pose, drawn)
    placement = place(graph, core, problem, pose, shape)
    circles = {
        c: SolvedCircle(x, placement.scale * shape.radii[c])
        for c, x in placement.all_to_world(shape.centres).items()
    }
    return Placed(
        placement.all_to_world(shape.vertices),
        circles,
        _camera(graph, problem, pose, placement),
        placement.scale_assumed,
        placement.camera_off_mm,
        wished,
    )


def _shape(
    graph: SketchGraph, core: SketchGraph, full: FullProblem, pose: Pose, drawn: Pose | None
) -> tuple[Lifted, tuple[str, ...]]:
    """The shape in object axes, profiles included, and what is wished of these."""
    shape = _core_shape(core, full.problem, pose)
    if graph is core:
        return shape, ()
    up = up_direction(core, full.problem, pose)
    as_drawn = shape if drawn is None else _core_shape(core, full.problem, drawn)
    axes = {id_: as_drawn.centres[r.ground] for id_, r in graph.revolutions.items()}
    planes = {id_: SidePlane.facing(axis, up) for id_, axis in axes.items()}
    as_drawn = _with_profiles(graph, core, full.problem, pose, as_drawn, planes)
    if drawn is not None:
        more = followed(graph, core, as_drawn, shape, planes)
        shape = _in_order(graph, {**shape.vertices, **more}, shape)
    else:
        shape = as_drawn
    if not said_of_profiles(graph, core):
        return shape, ()
    alone = place(core, core, full.problem, pose, _core_shape(core, full.problem, pose))
    unit_mm = None if alone.scale_assumed else alone.scale
    ends = ends_on_circles(graph, as_drawn, planes, full, pose)
    found = held(graph, core, shape, planes, unit_mm, ends)
    return found.shape, found.wished


def _core_shape(core: SketchGraph, problem: Problem, pose: Pose) -> Lifted:
    c = pose.g[problem.structure.coordinate]
    return Lifted(
        FrozenRows(core.vertices, c[: len(core.vertices)]),
        dict(zip(core.circles, c[len(core.vertices) :], strict=True)),
        dict(zip(core.circles, pose.g[problem.structure.radius].tolist(), strict=True)),
    )


def _with_profiles(
    graph: SketchGraph,
    core: SketchGraph,
    problem: Problem,
    pose: Pose,
    shape: Lifted,
    planes: Planes,
) -> Lifted:
    """The profiles' own vertices where they are drawn, in the side planes."""
    vertices = dict(shape.vertices)
    for id_, revolution in graph.revolutions.items():
        missing = [v for v in revolution.profile if v not in core.vertices]
        pixels = np.array([graph.vertices[v] for v in missing]).reshape(-1, 2)
        seen = (pixels - np.array(graph.principal_point_px)) / problem.px_per_unit
        in_cam = np.hstack([seen / np.exp(pose.log_focal), np.ones((len(seen), 1))])
        vertices |= dict(zip(missing, planes[id_].met_by(in_cam @ pose.R), strict=True))
    return _in_order(graph, vertices, shape)


def _in_order(graph: SketchGraph, vertices: Mapping[str, Array], shape: Lifted) -> Lifted:
    """The shape with vertices in the sketch's own order."""
    return replace(shape, vertices={v: vertices[v] for v in graph.vertices})


def _camera(graph: SketchGraph, problem: Problem, pose: Pose, placement: Placement) -> Camera:
    if placement.camera_kept and graph.camera is not None:
        return graph.camera
    rotation = pose.R @ placement.rotation_world_from_object.T
    return Camera(
        focal_px=float(np.exp(pose.log_focal)) * problem.px_per_unit,
        principal_point_px=np.array(graph.principal_point_px),
        rotation_cam_from_world=rotation,
        translation_cam_from_world_mm=-rotation @ placement.translation_mm,
    )
