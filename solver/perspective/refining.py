"""The camera of a rectangle and of the drawing together.

A small marker tells the focal length to a few per cent only. The object that is drawn beside it
tells it as well: so the rectangle is traced as what is really there, with its corners, its right
angles and its sides, and everything is solved at once.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..annotations import Annotation, Ground, Length, RightAngle
from ..camera import Camera
from ..graph import SketchGraph
from ..solution import Status
from ..two_step import solve
from .marker import RectangleView

#: Between the parts of names that no sketch has.
_OWN = "rectangle"


def refined_camera(graph: SketchGraph, view: RectangleView) -> Camera | None:
    """The camera that rectangle and drawing tell together, in the rectangle's world.

    Parameters
    ----------
    graph : SketchGraph
        Its own camera, if any, is left aside.
    view : RectangleView
        The rectangle in the graph's photo.

    Returns
    -------
    Camera or None
        None where they do not agree, or nothing is drawn.
    """
    if not graph.edges and not graph.circles:
        return None
    corners = _free_names(graph)
    solution = solve(_with_rectangle(graph, view, corners))
    if solution.status is not Status.CONVERGED or solution.camera is None:
        return None
    found = np.array([solution.vertices_mm[name] for name in corners])
    return _in_rectangles_world(solution.camera, found, view.corners_mm)


def _free_names(graph: SketchGraph) -> tuple[str, ...]:
    taken = {*graph.vertices, *graph.edges, *graph.annotations}
    own = _OWN
    while any(name.startswith(own) for name in taken):
        own += "_"
    return tuple(f"{own}{k}" for k in range(4))


def _with_rectangle(
    graph: SketchGraph, view: RectangleView, corners: tuple[str, ...]
) -> SketchGraph:
    """The graph with the rectangle as construction geometry, and without a camera."""
    sides = [f"{name}_side" for name in corners]
    ends = {side: (corners[k], corners[(k + 1) % 4]) for k, side in enumerate(sides)}
    said: dict[str, Annotation] = {
        f"{name}_angle": RightAngle(name, (sides[k - 1], sides[k]))
        for k, name in enumerate(corners)
    }
    for side, length in zip(sides, view.size_mm, strict=False):
        said[f"{side}_length"] = Length(side, length)
    on_ground = {v for a in graph.annotations.values() if isinstance(a, Ground) for v in a.vertices}
    others = {id_: a for id_, a in graph.annotations.items() if not isinstance(a, Ground)}
    said[f"{corners[0]}_ground"] = Ground((*sorted(on_ground), *corners))
    places = dict(zip(corners, ((u, v) for u, v in view.corners_px.tolist()), strict=True))
    return replace(
        graph,
        vertices={**graph.vertices, **places},
        edges={**graph.edges, **ends},
        annotations={**others, **said},
        construction=(*graph.construction, *sides),
        camera=None,
    )


def _in_rectangles_world(camera: Camera, found: np.ndarray, told: np.ndarray) -> Camera:
    """The same camera where the corners that were found are those that are told.

    Parameters
    ----------
    camera : Camera
    found, told : (4, 3) arrays
        Both on the ground, counterclockwise as seen from above, of one size.
    """
    middle = found.mean(axis=0)
    a, b = (found - middle)[:, :2].ravel(), told[:, :2]
    sine = float(a @ np.column_stack([-b[:, 1], b[:, 0]]).ravel())
    cosine = float(a @ b.ravel())
    size = float(np.hypot(sine, cosine))
    c, s = cosine / size, sine / size
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    R = camera.rotation_cam_from_world
    return replace(
        camera,
        rotation_cam_from_world=R @ turn,
        translation_cam_from_world_mm=R @ middle + camera.translation_cam_from_world_mm,
    )
