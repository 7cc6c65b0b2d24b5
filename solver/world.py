"""From object axes to the world, and the gauge said aloud.

The drawing and the annotations leave the world's frame open; it is chosen so:

- z is up and the ground is z = 0; without ground vertices the lowest vertex is at z = 0;
- x runs along the horizontal object axis that points most to the right in the photo, y away from
  the camera;
- the smallest x and y of the vertices are 0; a surface of revolution has its axis there;
- the size follows from the lengths and diameters; without any the longest edge is 100 mm.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .full import Pose
from .geometry import cross
from .graph import SketchGraph
from .problem import Problem
from .topology import MAX_KEPT, Topology, topology_of
from .values import Array, FrozenRows, IntArray, rows_of

ASSUMED_LONGEST_MM = 100.0
#: A length and a known camera that differ by less than this part agree.
AGREE = 1e-9
#: A direction with this cosine to the upward one tells nothing of what is level.
MOSTLY_UP = 1 - 1e-9
#: An object whose middle is so little above its ground, in parts of its size, is flat.
FLAT = 1e-9
#: Where the upward direction points downwards in the photo by so much (cosine), the camera was
#: upside down.
UPSIDE_DOWN = 0.3
#: What is deeper in the ground than this part of the object's size is not there by chance.
SUNK = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class Placement:
    """The move from object axes (eye at the origin) to the world.

    ``x_world = scale * rotation_world_from_object @ c + translation_mm``. `camera_off_mm` is how
    far that puts a known camera from where it was said to be.
    """

    rotation_world_from_object: Array
    scale: float
    translation_mm: Array
    scale_assumed: bool
    camera_kept: bool = False
    camera_off_mm: float = 0.0

    def to_world(self, c: Array) -> Array:
        """World positions (n, 3), mm."""
        return np.asarray(
            self.scale * (c @ self.rotation_world_from_object.T) + self.translation_mm
        )

    def all_to_world(self, points: Mapping[str, Array]) -> FrozenRows:
        """World positions of named points, mm."""
        return FrozenRows(points, self.to_world(rows_of(points)))


def up_direction(graph: SketchGraph, problem: Problem, pose: Pose) -> Array:
    """The upward direction in object axes, (3,).

    Square to the ground, towards the rest of the object (for a flat object, towards the camera);
    without ground vertices the object axis that points most upwards in the photo.
    """
    ground = _ground_indices(topology_of(graph))
    vertical = problem.structure.vertical
    if problem.up_in_cam is not None and vertical is not None:
        return np.asarray(np.eye(3)[vertical] * np.sign(pose.R[:, vertical] @ problem.up_in_cam))
    if vertical is None and len(ground) < 3:
        return _most_upright(problem, pose)
    if vertical is not None and not len(ground):
        return np.asarray(np.eye(3)[vertical] * (-1.0 if pose.R[1, vertical] > 0 else 1.0))
    if vertical is not None:
        heights = pose.g[problem.structure.coordinate[:, vertical]]
        level = float(heights[ground].sum()) / len(ground)
        rise = float(heights.sum()) / len(heights) - level
        flat = abs(rise) <= FLAT * float(np.abs(pose.g).max())
        return np.asarray(np.eye(3)[vertical] * (1.0 if (-level if flat else rise) >= 0 else -1.0))
    c = pose.g[problem.structure.coordinate]
    middle = c[ground].mean(axis=0)
    normal = np.linalg.svd(c[ground] - middle)[2][2]
    height = (c - c[ground].mean(axis=0)) @ normal
    mean = float(height.mean())
    if abs(mean) <= FLAT * float(np.abs(c).max(initial=0.0)):
        mean = float(-(c[ground].mean(axis=0) @ normal))
    return np.asarray(normal if mean >= 0 else -normal)


def _most_upright(problem: Problem, pose: Pose) -> Array:
    if not problem.structure.has_axes:
        return np.asarray(pose.R.T @ np.array([0.0, -1.0, 0.0]))
    # Cameras are held level: the vertical shows no lean to the side.
    k = int(np.argmax(np.abs(pose.R[1]) - 2 * np.abs(pose.R[0])))
    return np.asarray(np.eye(3)[k] * -np.sign(pose.R[1, k]))


def camera_above_ground(graph: SketchGraph, problem: Problem, pose: Pose) -> bool:
    """Whether the camera looks at the object from above, as people take photos."""
    up = up_direction(graph, problem, pose)
    ground = _ground_indices(topology_of(graph))
    vertical = problem.structure.vertical
    if len(ground) and vertical is not None:
        level = pose.g[problem.structure.coordinate[ground, vertical]].sum()
        return float(level * up[vertical]) < 0
    if len(ground) >= 3:
        c = pose.g[problem.structure.coordinate]
        return float(-(c[ground].mean(axis=0) @ up)) > 0
    return float(pose.R[2] @ up) < 0


def nothing_sinks(graph: SketchGraph, problem: Problem, pose: Pose) -> bool:
    """Whether all of the object is above the ground, within what drawing errors may do."""
    ground = ground_indices(graph)
    if not ground:
        return True
    c = pose.g[problem.structure.coordinate]
    height = (c - c[ground].mean(axis=0)) @ up_direction(graph, problem, pose)
    return float(height.min()) > -SUNK * float(np.ptp(c, axis=0).max())


def is_upright(graph: SketchGraph, problem: Problem, pose: Pose) -> bool:
    """Whether what stands on the ground does not stand on its head in the photo.

    Seen from far above either is fine.
    """
    if not ground_indices(graph):
        return True
    return float(pose.R[1] @ up_direction(graph, problem, pose)) < UPSIDE_DOWN


def lean(graph: SketchGraph, problem: Problem, pose: Pose) -> float:
    """How far the object's middle is from above the middle of its stand, in parts of its height.

    Things that stand do not lean over; 0 where nothing stands on the ground.
    """
    ground = ground_indices(graph)
    c = pose.g[problem.structure.coordinate]
    if not ground or len(ground) == len(c):
        return 0.0
    up = up_direction(graph, problem, pose)
    offset = c.mean(axis=0) - c[ground].mean(axis=0)
    height = float(offset @ up)
    return float(np.linalg.norm(offset - height * up)) / max(abs(height), 1e-300)


def ground_indices(graph: SketchGraph) -> list[int]:
    """Indices of the points on the ground: annotated vertices, ground circles' centres."""
    return list(_ground_indices(topology_of(graph)).tolist())


@lru_cache(maxsize=MAX_KEPT)
def _ground_indices(topology: Topology) -> IntArray:
    stand = {r.ground for r in topology.revolutions.values()}
    circles = [len(topology.vertices) + topology.circles[c] for c in stand]
    return np.array(sorted([*topology.ground.tolist(), *circles]), dtype=np.int64)


@dataclass(frozen=True, slots=True, eq=False)
class Lifted:
    """The lifted shape in object axes, the eye at the origin, of free size.

    Parameters
    ----------
    vertices, centres : mappings of id to (3,) array
    radii : mapping of circle id to float
    """

    vertices: Mapping[str, Array]
    centres: Mapping[str, Array]
    radii: Mapping[str, float]


def place(
    graph: SketchGraph, core: SketchGraph, problem: Problem, pose: Pose, lifted: Lifted
) -> Placement:
    """Choose the world's frame and size.

    Parameters
    ----------
    graph : SketchGraph
        The whole sketch, whose lengths set the size.
    core : SketchGraph
        The part of it that the problem and the pose speak of.
    problem : Problem
    pose : Pose
    lifted : Lifted
        The whole shape.
    """
    if problem.up_in_cam is not None and ground_indices(core):
        return _place_under_camera(graph, core, problem, pose, lifted)
    W = _axes(problem, pose, up_direction(core, problem, pose))
    scale, assumed = _scale(graph, core, lifted)
    points = rows_of(lifted.vertices)
    if lifted.centres:
        points = np.vstack([points, rows_of(lifted.centres)])
    turned = scale * (points @ W.T)
    lowest = turned.min(axis=0)
    ground = ground_indices(core)
    if ground:
        on_ground = pose.g[problem.structure.coordinate][ground]
        lowest[2] = scale * float((on_ground @ W[2]).mean())
    if graph.revolutions:
        # What was turned stands on the world's own axis.
        first = next(iter(graph.revolutions.values()))
        lowest[:2] = scale * (W @ lifted.centres[first.ground])[:2]
    return Placement(W, scale, -lowest, assumed)


def _place_under_camera(
    graph: SketchGraph, core: SketchGraph, problem: Problem, pose: Pose, lifted: Lifted
) -> Placement:
    """The world is the known camera's; its height over the ground tells the size.

    Given lengths come first; where they disagree with it the camera is put higher or lower.
    """
    assert problem.camera is not None
    W = problem.camera.rotation_cam_from_world.T @ pose.R
    below = -float((pose.g[problem.structure.coordinate][ground_indices(core)] @ W[2]).mean())
    eye = problem.camera.position_mm
    scale, assumed = _scale_of(core, lifted)
    if below > 0 and float(eye[2]) > 0:
        by_camera = float(eye[2]) / below
        if assumed:
            return Placement(W, by_camera, eye, False, True)
        if abs(scale - by_camera) <= AGREE * by_camera:
            return Placement(W, scale, eye, False, True)
    scale, assumed = _scale(graph, core, lifted)
    moved = np.array([eye[0], eye[1], scale * below])
    return Placement(W, scale, moved, assumed, camera_off_mm=float(abs(moved[2] - eye[2])))


def _axes(problem: Problem, pose: Pose, up: Array) -> Array:
    """Rows: the world's x, y, z in object axes."""
    x = right = pose.R[0]
    if problem.structure.has_axes:
        options = [s * np.eye(3)[k] for k in range(3) for s in (1.0, -1.0)]
        level = [o for o in options if abs(float(o @ up)) < 0.5]
        # None is level where the ground is oblique to all of them.
        x = max(level, key=lambda o: float(o @ right), default=right)
    if abs(float(x @ up)) > MOSTLY_UP:
        # The ground was drawn upright: any level direction will do.
        x = pose.R[1]
    for _ in range(2):  # once leaves rounding errors where x is nearly up
        x = x - (x @ up) * up
        x = x / np.linalg.norm(x)
    y = cross(up, x)
    return np.array([x, y, up])


def _scale(graph: SketchGraph, core: SketchGraph, lifted: Lifted) -> tuple[float, bool]:
    """By what is said of the core, or else of all: profiles follow the core's sizes."""
    scale, assumed = _scale_of(core, lifted)
    return (scale, assumed) if graph is core or not assumed else _scale_of(graph, lifted)


def _scale_of(graph: SketchGraph, lifted: Lifted) -> tuple[float, bool]:
    """Millimetres in one of the shape's units, and whether that is only assumed."""
    said = topology_of(graph).by_kind
    given = [(_length(graph, lifted, a.edge), a.length_mm) for _, a in said["length"]]
    given += [(2 * lifted.radii[a.circle], a.diameter_mm) for _, a in said["diameter"]]
    if given:
        drawn, wanted = np.array(given).T
        weight = drawn / wanted
        if not float(np.sum(weight**2)) > 0:
            return 1.0, False
        # Exact for one length or lengths in proportion, a fair mean for others.
        return float(np.sum(weight) / np.sum(weight**2)), False
    longest = max((2 * r for r in lifted.radii.values()), default=0.0)
    if graph.edges:
        ends = rows_of(lifted.vertices)[topology_of(graph).ends]
        along = ends[:, 1] - ends[:, 0]
        longest = math.sqrt(float(np.einsum("ei,ei->e", along, along).max()))
    return (ASSUMED_LONGEST_MM / longest if longest > 0 else 1.0), True


def _length(graph: SketchGraph, lifted: Lifted, edge: str) -> float:
    v, w = graph.edges[edge]
    return math.dist(lifted.vertices[v].tolist(), lifted.vertices[w].tolist())
