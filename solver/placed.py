"""The lifted shape in the world: vertices and circles in mm, and the camera that sees them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from .camera import Camera
from .full import Pose
from .graph import SketchGraph
from .problem import Problem
from .revolution import in_side_plane
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
    """

    vertices: Mapping[str, Array]
    circles: Mapping[str, SolvedCircle]
    camera: Camera
    scale_assumed: bool
    camera_off_mm: float

    def reprojection_px(self, graph: SketchGraph) -> dict[str, float]:
        """Distance between each drawn and projected vertex, px."""
        if not self.vertices:
            return {}
        off = self.camera.project(rows_of(self.vertices)) - graph.positions_px
        return dict(zip(self.vertices, np.hypot(off[:, 0], off[:, 1]).tolist(), strict=True))


def put_in_world(graph: SketchGraph, core: SketchGraph, problem: Problem, pose: Pose) -> Placed:
    """Choose the world's frame and size, and put the shape there.

    Parameters
    ----------
    graph : SketchGraph
        The whole sketch.
    core : SketchGraph
        The part of it that the problem and the pose speak of.
    problem : Problem
    pose : Pose
    """
    shape = _shape(graph, core, problem, pose)
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
    )


def _shape(graph: SketchGraph, core: SketchGraph, problem: Problem, pose: Pose) -> Lifted:
    """The shape in object axes, profiles included."""
    c = pose.g[problem.structure.coordinate]
    vertices: Mapping[str, Array] = FrozenRows(core.vertices, c[: len(core.vertices)])
    centres = dict(zip(core.circles, c[len(core.vertices) :], strict=True))
    radii = dict(zip(core.circles, pose.g[problem.structure.radius].tolist(), strict=True))
    if graph is core:
        return Lifted(vertices, centres, radii)
    vertices = dict(vertices)
    up = up_direction(core, problem, pose)
    for revolution in graph.revolutions.values():
        missing = [v for v in revolution.profile if v not in core.vertices]
        pixels = np.array([graph.vertices[v] for v in missing]).reshape(-1, 2)
        seen = (pixels - np.array(graph.principal_point_px)) / problem.px_per_unit
        in_cam = np.hstack([seen / np.exp(pose.log_focal), np.ones((len(seen), 1))])
        side = in_side_plane(in_cam @ pose.R, centres[revolution.ground], up)
        vertices |= dict(zip(missing, side, strict=True))
    # In the sketch's own order.
    return Lifted({v: vertices[v] for v in graph.vertices}, centres, radii)


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
