"""From what a reference method found to a solution: onto the ground, to size, and judged."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..annotations import Length
from ..camera import Camera
from ..errors import SketchError
from ..faces import find_faces
from ..graph import Face, SketchGraph
from ..residuals import annotation_residuals
from ..solution import Report, Residual, Solution, Status
from ..values import Array
from .common import FAR, Reference, View
from .drawing import DIAGONAL, Drawing, read_drawing, unknown_annotations

#: An annotation holds within these; a simplex search comes no nearer than its patience allows.
ANGLE_TOLERANCE_DEG = 1.0
LENGTH_TOLERANCE = 0.01  # in parts of the object's size
ASSUMED_LONGEST_MM = 100.0
#: A drawing missed by more than this (RMS, in parts of its diagonal) was not lifted.
LOST = 0.05
#: A drawing unit that counts more mm than this: an edge of given length has shrunk to nothing.
COLLAPSED = 1e9


@dataclass(frozen=True, slots=True, eq=False)
class Move:
    """A rigid move: ``x_new = rotation @ x + translation``."""

    rotation: Array
    translation: Array

    def points(self, X: Array) -> Array:
        """Moved points (n, 3)."""
        return np.asarray(X @ self.rotation.T + self.translation)

    def view(self, view: View) -> View:
        """The same camera, told in the new frame."""
        return View(
            self.rotation @ view.position + self.translation,
            view.rotation @ self.rotation.T,
            view.focal,
        )


def onto_ground(drawing: Drawing, X: Array, view: View) -> Move:
    """The move that lays the ground vertices on z = 0 ([Lau10] 3.2, Ground Vertices).

    Their plane is the best one, the rest of the object is above it. Without three ground vertices
    upwards is the edge direction that points most upwards in the photo.
    """
    ground = list(drawing.ground)
    up = _upright_edge(drawing, X, view)
    if len(ground) >= 3:
        middle = X[ground].mean(axis=0)
        spread, axes = np.linalg.svd(X[ground] - middle)[1:]
        if spread[1] > 1e-6 * max(float(spread[0]), 1e-300):
            height = float(((X - middle) @ axes[2]).mean())
            flat = abs(height) < 1e-9 * float(np.abs(X - middle).max())
            side = float((view.position - middle) @ axes[2]) if flat else height
            up = axes[2] if side >= 0 else -axes[2]
    right = view.rotation[0] - (view.rotation[0] @ up) * up
    right = right / max(float(np.linalg.norm(right)), 1e-300)
    rotation = np.array([right, np.cross(up, right), up])
    turned = X @ rotation.T
    lowest = turned.min(axis=0)
    if ground:
        lowest[2] = turned[ground, 2].mean()
    return Move(rotation, -lowest)


def _upright_edge(drawing: Drawing, X: Array, view: View) -> Array:
    index = {v: i for i, v in enumerate(drawing.graph.vertices)}
    upwards = -view.rotation[1]
    best = upwards
    steepest = 0.0
    for v, w in drawing.graph.edges.values():
        vec = X[index[w]] - X[index[v]]
        vec = vec / max(float(np.linalg.norm(vec)), 1e-300)
        # Cameras are held level: the vertical shows no lean to the side.
        steep = float(vec @ upwards)
        score = abs(steep) - 2 * abs(float(vec @ view.rotation[0]))
        if score > steepest:
            steepest, best = score, vec * np.sign(steep)
    return np.asarray(best)


def run(name: str, graph: SketchGraph, method: Callable[[Drawing], Reference]) -> Solution:
    """Run a reference method and describe what it found; always returns a solution."""
    began = time.perf_counter()
    if graph.circles or graph.revolutions:
        ids = ", ".join([*graph.circles, *graph.revolutions][:4])
        text = f"{name} is given here for straight edges only, without {ids}: take method ours."
        return Solution(graph, Status.NOT_CONVERGED, text)
    if nothing := _nothing_to_lift(graph):
        return Solution(graph, Status.UNDERDETERMINED, nothing)
    drawing = read_drawing(graph)
    solution = _described(name, drawing, method(drawing))
    elapsed = (time.perf_counter() - began) * 1e3
    return replace(solution, report=replace(solution.report, solve_ms=elapsed))


def _nothing_to_lift(graph: SketchGraph) -> str:
    if not graph.edges:
        return "The sketch has no edges: draw the object's edges over the photo."
    pixels = np.array(list(graph.vertices.values()))
    spread = np.linalg.svd(pixels - pixels.mean(axis=0), compute_uv=False)
    if len(pixels) < 3 or spread[1] <= 1e-6 * max(float(spread[0]), 1e-300):
        return "All vertices lie on one line: draw edges in at least two directions."
    return ""


def _described(name: str, drawing: Drawing, found: Reference) -> Solution:
    graph = drawing.graph
    move = _squared(drawing, found)
    X, view = move.points(found.X), move.view(found.view)
    X[list(drawing.ground), 2] = 0.0  # "we project the remaining ones to the ground"
    scale, assumed = _scale(drawing, X)
    if not (np.isfinite(X).all() and scale < COLLAPSED):
        return Solution(graph, Status.NOT_CONVERGED, f"{name} shrank the shape to nothing.")
    vertices = dict(zip(graph.vertices, scale * X, strict=True))
    camera = _camera(drawing, view, scale)
    faces = _faces(graph, vertices)
    residuals = annotation_residuals(graph, vertices, faces, {})
    unmet = _unmet(residuals, float(np.ptp(scale * X)))
    off = np.linalg.norm(_seen(view, X) - drawing.p, axis=1)
    missed = float(np.sqrt(np.mean(off**2))) / DIAGONAL
    status, message = _verdict(name, graph, unmet, missed)
    return Solution(
        graph,
        status,
        message,
        vertices,
        graph.edges,
        faces,
        camera=camera,
        scale_assumed=assumed,
        report=Report(
            residuals=residuals,
            reprojection_px=dict(
                zip(graph.vertices, (drawing.px_per_unit * off).tolist(), strict=True)
            ),
            conflicts=(),
            iterations=found.evaluations,
        ),
    )


def _seen(view: View, X: Array) -> Array:
    """Where the camera sees the vertices, drawing units; far off where it cannot."""
    seen = view.project(X)
    return np.full((len(X), 2), FAR) if seen is None else seen


def _squared(drawing: Drawing, found: Reference) -> Move:
    """Onto the ground, and x along the level edge that points most to the right in the photo."""
    move = onto_ground(drawing, found.X, found.view)
    X, view = move.points(found.X), move.view(found.view)
    index = {v: i for i, v in enumerate(drawing.graph.vertices)}
    best, x_axis = 0.0, np.array([1.0, 0.0, 0.0])
    for v, w in drawing.graph.edges.values():
        vec = X[index[w]] - X[index[v]]
        vec = vec / max(float(np.linalg.norm(vec)), 1e-300)
        if abs(float(vec[2])) < 0.05 and abs(float(vec @ view.rotation[0])) > best:
            best = abs(float(vec @ view.rotation[0]))
            x_axis = vec * np.sign(vec @ view.rotation[0])
    yaw = -np.arctan2(x_axis[1], x_axis[0])
    c, s = np.cos(yaw), np.sin(yaw)
    about_z = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    translation = about_z @ move.translation
    turned = found.X @ (about_z @ move.rotation).T + translation
    translation[:2] -= turned.min(axis=0)[:2]
    return Move(about_z @ move.rotation, translation)


def _scale(drawing: Drawing, X: Array) -> tuple[float, bool]:
    """Size from the lengths ([Lau10] 3.2, Dimensions), a fair mean where they disagree."""
    graph = drawing.graph
    at = dict(zip(graph.vertices, X, strict=True))
    length = {e: float(np.linalg.norm(at[w] - at[v])) for e, (v, w) in graph.edges.items()}
    given = [
        a.length_mm / max(length[a.edge], 1e-300)
        for a in graph.annotations.values()
        if isinstance(a, Length)
    ]
    if given:
        return float(np.exp(np.mean(np.log(given)))), False
    return ASSUMED_LONGEST_MM / max(*length.values(), 1e-300), True


def _camera(drawing: Drawing, view: View, scale: float) -> Camera:
    return Camera(
        focal_px=view.focal * drawing.px_per_unit,
        principal_point_px=np.array(drawing.graph.principal_point_px),
        rotation_cam_from_world=view.rotation,
        translation_cam_from_world_mm=-view.rotation @ (scale * view.position),
    )


def _faces(graph: SketchGraph, vertices: dict[str, Array]) -> dict[str, Face]:
    if graph.faces is not None:
        return dict(graph.drawn_faces or {})
    try:
        return find_faces(vertices, graph.edges)
    except SketchError:
        return {}


def _unmet(residuals: Mapping[str, Residual], size_mm: float) -> list[str]:
    limit = {"deg": ANGLE_TOLERANCE_DEG, "mm": LENGTH_TOLERANCE * size_mm}
    off = {id_: r.value / limit[r.unit] for id_, r in residuals.items()}
    return sorted((id_ for id_, value in off.items() if not value <= 1.0), key=lambda i: -off[i])


def _verdict(name: str, graph: SketchGraph, unmet: list[str], missed: float) -> tuple[Status, str]:
    ignored = unknown_annotations(graph)
    failures = []
    if unmet:
        failures.append(
            f"{len(unmet)} annotations do not hold within {ANGLE_TOLERANCE_DEG:g} degree or "
            f"{100 * LENGTH_TOLERANCE:g} % of the size (worst: {', '.join(unmet[:3])})"
        )
    if missed > LOST:
        failures.append(f"the drawing is missed by {100 * missed:.0f} % of its diagonal")
    if ignored:
        failures.append(f"it does not know {', '.join(ignored[:4])}")
    if failures:
        return Status.NOT_CONVERGED, f"{name}: {'; '.join(failures)}."
    if graph.camera is not None:
        return Status.CONVERGED, f"Solved by {name}, which found a camera of its own."
    return Status.CONVERGED, f"Solved by {name}."
