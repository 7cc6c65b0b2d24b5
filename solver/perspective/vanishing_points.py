"""What lines traced on real things say of the perspective, line by line.

Terms
-----
traced line
    A construction edge: it runs along something that really is in the photo.
vanishing point
    Where lines that are parallel in space meet in the photo.
bundle
    Traced lines that are parallel in space.

The interpretation plane of a line, through the eye, has the normal N; a direction V in space runs
along the line where N . V = 0. With a standard error s of each drawn end the residual has the
variance s^2 (|(q x V)_xy|^2 + |(p x V)_xy|^2) / |p x q|^2, p and q being the rays of the ends.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..camera import Camera
from ..geometry import cross
from ..graph import SketchGraph
from ..problem import TRACED_SIGMA_PX
from ..solution import Solution
from ..values import Array
from .cropping import ViewMiddle, view_middle

#: Directions in space this near to each other (sine) are one.
SAME_DIRECTION = 1e-6
#: A line this many standard errors off is worth a word, if it is off by so many px as well.
FAR_OFF, LEAST_OFF_PX = 4.0, 3.0
#: A bundle that tells its direction less surely than this says nothing of it, rad.
TELLS_NOTHING_RAD = 0.1


@dataclass(frozen=True, slots=True)
class TracedLine:
    """How a traced line agrees with the solution.

    Parameters
    ----------
    bundle : int
        Lines of one number are parallel in space.
    off_px : float
        How far its drawn ends are from the line through their middle to the vanishing point.
    off_rad : float
        The angle between the two.
    off_sigmas : float
        The same in standard errors of a drawn line.
    """

    bundle: int
    off_px: float
    off_rad: float
    off_sigmas: float


@dataclass(frozen=True, slots=True)
class Bundle:
    """Traced lines that are parallel in space.

    Parameters
    ----------
    edges : tuple of edge ids
    sigma_rad : float
        How surely the drawn lines alone tell where they meet, as an angle at the eye; infinite
        for a single line.
    """

    edges: tuple[str, ...]
    sigma_rad: float

    @property
    def says_nothing(self) -> bool:
        """Whether several lines are too nearly parallel in the photo to tell where they meet."""
        return len(self.edges) > 1 and self.sigma_rad > TELLS_NOTHING_RAD


@dataclass(frozen=True, slots=True)
class Traced:
    """All traced lines of a sketch, judged by its solution.

    Parameters
    ----------
    lines : mapping of edge id to TracedLine
    bundles : tuple of Bundle
    notes : tuple of str
        What a person should know, a sentence each.
    """

    lines: Mapping[str, TracedLine]
    bundles: tuple[Bundle, ...]
    notes: tuple[str, ...]


def traced_lines(graph: SketchGraph, solution: Solution) -> Traced:
    """Judge the traced lines of a sketch by its solution.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
        Of that sketch; one without a camera judges nothing.

    Returns
    -------
    Traced
    """
    camera = solution.camera
    edges, drawn, along = _traced(graph, solution)
    if camera is None or not len(drawn):
        return Traced({}, (), ())
    V = along @ camera.rotation_cam_from_world.T
    numbers = _bundles_of(along)
    N, sigma = _planes(drawn, V, camera)
    off = np.sum(N * V, axis=1)
    angle = _off_rad(drawn, V, camera)
    length = np.linalg.norm(drawn[:, 1] - drawn[:, 0], axis=1)
    lines = {
        e: TracedLine(
            numbers[k],
            float(length[k] / 2 * np.sin(angle[k])),
            float(angle[k]),
            float(abs(off[k]) / sigma[k]),
        )
        for k, e in enumerate(edges)
    }
    bundles = []
    for number in sorted(set(numbers)):
        own = [k for k, n in enumerate(numbers) if n == number]
        bundles.append(
            Bundle(tuple(edges[k] for k in own), _unsureness(N[own], sigma[own], V[own]))
        )
    # Where the photo was cropped, that is what puts lines off.
    notes = _of_cropping(graph, drawn, along, numbers, camera) or _notes(graph, lines, bundles)
    return Traced(lines, tuple(bundles), notes)


def _of_cropping(
    graph: SketchGraph, drawn: Array, along: Array, numbers: list[int], camera: Camera
) -> tuple[str, ...]:
    """Whether the lines tell that the photo was cropped, which nobody has said."""
    if graph.photo is None or graph.photo.principal_point_px:
        return ()
    taken = np.array(graph.principal_point_px)
    if graph.camera is not None and not np.allclose(graph.camera.principal_point_px, taken):
        return ()
    found = view_middle(drawn, along, numbers, camera)
    longer = max(graph.photo.width_px, graph.photo.height_px)
    if found is None or not found.is_elsewhere(taken, longer):
        return ()
    (u, v), (x, y) = found.principal_px.round(), taken.round()
    return (
        f"The traced lines meet as in a cropped photo: it was taken towards {u:.0f}, {v:.0f} px, "
        f"not {x:.0f}, {y:.0f} px: say so in the photo's camera, or use the whole photo.",
    )


def traced_middle(graph: SketchGraph, solution: Solution) -> ViewMiddle | None:
    """Where the axis of view meets the photo, as the traced lines tell it.

    None where they do not: no three directions square to each other with two lines each.
    """
    _, drawn, along = _traced(graph, solution)
    if solution.camera is None or not len(drawn):
        return None
    return view_middle(drawn, along, _bundles_of(along), solution.camera)


def _traced(graph: SketchGraph, solution: Solution) -> tuple[list[str], Array, Array]:
    """Traced lines: ids, ends in the photo (k, 2, 2), directions in space (k, 3)."""
    edges = [e for e in graph.construction if e in graph.edges and e in solution.edges]
    ends = [graph.edges[e] for e in edges]
    X = np.array([[solution.vertices_mm[v] for v in pair] for pair in ends]).reshape(-1, 2, 3)
    drawn = np.array([[graph.vertices[v] for v in pair] for pair in ends]).reshape(-1, 2, 2)
    long = np.linalg.norm(drawn[:, 1] - drawn[:, 0], axis=1) > TRACED_SIGMA_PX
    edges = [e for e, is_long in zip(edges, long.tolist(), strict=True) if is_long]
    along = X[long, 1] - X[long, 0]
    along = along / np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-300)
    return edges, drawn[long], along


def _bundles_of(along: Array) -> list[int]:
    """The number of each line's bundle."""
    firsts: list[Array] = []
    numbers = []
    for d in along:
        near = [k for k, f in enumerate(firsts) if np.linalg.norm(cross(d, f)) < SAME_DIRECTION]
        if not near:
            firsts.append(d)
        numbers.append(near[0] if near else len(firsts) - 1)
    return numbers


def _rays(points_px: Array, camera: Camera) -> Array:
    """Directions (..., 3) in the camera frame, z = 1."""
    plane = (points_px - camera.principal_point_px) / camera.focal_px
    return np.concatenate([plane, np.ones((*plane.shape[:-1], 1))], axis=-1)


def _planes(drawn: Array, V: Array, camera: Camera) -> tuple[Array, Array]:
    """Unit normals (k, 3) of the interpretation planes, and the standard errors of N . V."""
    rays = _rays(drawn, camera)
    p, q = rays[:, 0], rays[:, 1]
    normal = cross(p, q)
    size = np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    spread = np.hypot(
        np.linalg.norm(cross(p, V)[:, :2], axis=1), np.linalg.norm(cross(q, V)[:, :2], axis=1)
    )
    sigma = TRACED_SIGMA_PX / camera.focal_px * spread / size
    return normal / size[:, None], np.maximum(sigma, 1e-300)


def _off_rad(drawn: Array, V: Array, camera: Camera) -> Array:
    """Angles in the photo between the drawn lines and the way to their vanishing points."""
    middle = _rays(drawn.mean(axis=1), camera)
    way = V[:, :2] - middle[:, :2] * V[:, 2:]
    line = drawn[:, 1] - drawn[:, 0]
    sine = line[:, 0] * way[:, 1] - line[:, 1] * way[:, 0]
    return np.asarray(np.arctan2(np.abs(sine), np.abs(np.sum(line * way, axis=1))))


def _unsureness(N: Array, sigma: Array, V: Array) -> float:
    """The largest standard error of the direction in which drawn lines meet, rad."""
    signs = np.sign(V @ V[0])
    direction = (V * signs[:, None]).mean(axis=0)
    across = np.linalg.svd(direction[None])[2][1:]
    weighed = (N @ across.T) / sigma[:, None]
    least = float(np.linalg.eigvalsh(weighed.T @ weighed)[0])
    return float(1 / np.sqrt(least)) if least > 1e-12 else float("inf")


def _notes(
    graph: SketchGraph, lines: Mapping[str, TracedLine], bundles: list[Bundle]
) -> tuple[str, ...]:
    notes = []
    far = {
        e: line
        for e, line in lines.items()
        if line.off_sigmas > FAR_OFF and line.off_px > LEAST_OFF_PX
    }
    if far:
        worst = max(far, key=lambda e: far[e].off_sigmas)
        line = far[worst]
        notes.append(
            f"The traced line {worst} is {line.off_px:.1f} px "
            f"({np.degrees(line.off_rad):.1f} degrees) off the perspective of the rest: check it."
        )
    if len(far) > 1 and graph.photo is not None and graph.photo.principal_point_px is None:
        notes.append(
            "Several traced lines are off: where the photo was cropped, use the whole photo, or "
            "say where it looked in the photo's camera."
        )
    told = graph.camera is not None or (
        graph.photo is not None and graph.photo.focal_px is not None
    )
    idle = [bundle for bundle in bundles if bundle.says_nothing]
    if idle and not told and not any(_tells(bundle) for bundle in bundles):
        names = [e for bundle in idle for e in bundle.edges][:6]
        listed = f"{', '.join(names[:-1])} and {names[-1]}"
        notes.append(
            f"The traced lines {listed} are too nearly parallel in the photo to tell where they "
            "meet: trace others further apart, or use a marker."
        )
    return tuple(notes)


def _tells(bundle: Bundle) -> bool:
    return len(bundle.edges) > 1 and not bundle.says_nothing
