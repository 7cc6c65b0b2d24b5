"""Plates of right-angled walls that end at an opening which leans: cut back behind its plane.

Terms
-----
opening
    A face left out. One that leans to the walls' axes cuts them at an angle, and a square cut
    along the drawn edge would stick out of it by a part of the thickness.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from shapely.geometry import Polygon

from ...solver.model import Model
from ...solver.values import Array
from .enclosed import enclosed, plane_axes
from .frame import Frame, snapped
from .sides import face_sides
from .slanted_walls import SlantedWall
from .trimming import on_its_side, trimmed_at_openings
from .walls import Wall


def behind_openings(
    model: Model,
    frame: Frame,
    openings: Sequence[str],
    walls: Sequence[Wall],
    placed: Sequence[SlantedWall],
    side: str,
) -> list[Polygon]:
    """The outlines of plates that stick out of no opening.

    Parameters
    ----------
    model : Model
    frame : Frame
    openings : sequence of face ids
    walls : sequence of Wall
    placed : sequence of SlantedWall
        The plates of the walls, their outlines as rings.
    side : str
        Where the material of outer walls lies.

    Returns
    -------
    list of Polygon
        In the plates' own coordinates.
    """
    to_world = frame.world_from_frame()
    vertices = {v: to_world[:3, :3] @ p + to_world[:3, 3] for v, p in snapped(model, frame).items()}
    loops = {id_: (face.loop, *face.holes) for id_, face in model.faces.items()}
    rings = {
        id_: tuple(np.array([vertices[v] for v in loop]) for loop in face)
        for id_, face in loops.items()
    }
    sides = face_sides(rings, list(rings))
    outer = {id_: face for id_, face in loops.items() if sides[id_]}
    outlines = [Polygon(plate.rings[0], plate.rings[1:]) for plate in placed]
    drawn = enclosed(outer, vertices, sides)
    if side == "inside" and drawn is not None:
        return on_its_side(placed, outlines, drawn, side)
    order = sorted(range(len(walls)), key=lambda n: walls[n].side == 0)
    first = sum(1 for wall in walls if wall.side != 0)
    planes = [_opening(rings[id_][0], sides[id_]) for id_ in openings if sides[id_]]
    cut = trimmed_at_openings(
        [placed[n] for n in order], planes, [outlines[n] for n in order], first
    )
    return [cut[order.index(n)] for n in range(len(walls))]


def _opening(loop: Array, side: int) -> SlantedWall:
    """An opening as a wall without thickness."""
    along, across, normal = plane_axes(loop)
    place = np.eye(4)
    place[:3, :3] = np.array([along, across * side, normal * side]).T
    place[:3, 3] = loop[0]
    flat = (loop - loop[0]) @ place[:3, :2]
    return SlantedWall((), 0.0, place, (flat,))
