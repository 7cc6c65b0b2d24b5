"""FreeCAD shapes of lifted models and plates, built straight from their polygons.

Everything here is flat polygons, straight extrusions and turned polylines, so FreeCAD's own kernel
makes them exactly, and no shape has to cross over from another one.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import FreeCAD
import Part

if TYPE_CHECKING:
    from manifold3d import Manifold

    from ...solver.graph import Revolution, SketchGraph
    from ...solver.solution import Solution
    from ..fabrication.plates import Plate


def solution_shape(solution: Solution, graph: SketchGraph) -> Any:
    """A compound of the lifted faces, the edges that belong to none of them, circles, and surfaces.

    Faces left out and things traced on the photo (construction) are not part of it. Slow methods
    leave faces that are not quite flat: of those the edges are shown.
    """
    parts, drawn = [], set()
    for face in (face for face in solution.faces.values() if face.included):
        try:
            parts.append(_face([_points(loop, solution) for loop in face.loops]))
        except Part.OCCError:
            continue
        drawn |= {_pair(loop[i - 1], loop[i]) for loop in face.loops for i in range(len(loop))}
    for id_, ends in solution.edges.items():
        # A mirrored edge `e7@a5` is construction where `e7` is.
        if id_.split("@")[0] not in graph.construction and _pair(*ends) not in drawn:
            parts.append(Part.makeLine(*_points(ends, solution)))
    for id_, circle in solution.circles.items():
        if id_.split("@")[0] not in graph.construction:
            center = FreeCAD.Vector(*(float(x) for x in circle.center_mm))
            parts.append(Part.makeCircle(float(circle.radius_mm), center))
    for revolution in graph.revolutions.values():
        if _is_there(revolution, solution):
            parts.append(_turned_surface(revolution, solution))
    return Part.makeCompound(parts)


def _is_there(revolution: Revolution, solution: Solution) -> bool:
    """Whether all of it is solved; slow methods leave circles out."""
    circles = {revolution.bottom, revolution.top}
    return solution.circles.keys() >= circles and solution.vertices_mm.keys() >= {
        *revolution.profile
    }


def _turned_surface(revolution: Revolution, solution: Solution) -> Any:
    """A surface of revolution, exact: cones, cylinders and rings; its seam is the drawn side."""
    import numpy as np

    from ...solver.model import turned_profile

    turned = turned_profile(revolution, solution)
    x, y = turned.axis_mm.tolist()
    offsets = [solution.vertices_mm[v][:2] - turned.axis_mm for v in revolution.profile]
    across = max(offsets, key=np.linalg.norm)
    turn_deg = float(np.degrees(np.arctan2(across[1], across[0])))
    rows = turned.profile_rz_mm.tolist()
    side = Part.makePolygon([FreeCAD.Vector(x + radius, y, height) for radius, height in rows])
    foot, up = FreeCAD.Vector(x, y, 0), FreeCAD.Vector(0, 0, 1)
    side.rotate(foot, up, turn_deg)
    return side.revolve(foot, up, 360)


def plates_shape(plates: Iterable[Plate]) -> Any:
    """A compound of plates as exact solids, each where it belongs in the assembled object."""
    return Part.makeCompound([plate_solid(plate) for plate in plates])


def plate_solid(plate: Plate) -> Any:
    """One plate: its outline with holes, extruded by its thickness, put in its place."""
    solid = flat_plate_solid(plate)
    rows = [float(value) for row in plate.world_from_plate for value in row]
    solid.Placement = FreeCAD.Placement(FreeCAD.Matrix(*rows))
    return solid


def flat_plate_solid(plate: Plate) -> Any:
    """One plate in its own frame."""
    loops = [plate.outline, *plate.holes]
    points = [[FreeCAD.Vector(float(x), float(y), 0) for x, y in loop] for loop in loops]
    # A plate's holes are wound against its outline: nothing need be sorted out, 50 times faster.
    face = Part.Face(_wires(points))
    return face.extrude(FreeCAD.Vector(0, 0, float(plate.thickness_mm)))


def straight_sides_first(solid: Any, plate: Plate) -> Any:
    """A flat plate whose straight sides come first, then its two faces, then the fingers.

    So edges and faces that are there whatever the number of fingers keep their numbers, also in
    views of a technical drawing.
    """
    hull = itertools.pairwise(plate.polygon.convex_hull.exterior.coords)
    # The middle finger of a side has the middle of the side: the length is asked for as well.
    straight = {_place([a, b]) for a, b in hull if _is_long(a, b, plate.size_mm)}
    ranks = [
        1
        if len(face.Vertexes) != 4 or abs(face.normalAt(0, 0).z) > 0.5
        else 0
        if _place([v.Point for v in face.Vertexes]) in straight
        else 2
        for face in solid.Faces
    ]
    if ranks == sorted(ranks):
        return solid
    faces = [solid.Faces[k] for k in sorted(range(len(ranks)), key=ranks.__getitem__)]
    return Part.Solid(Part.Shell(faces))


def _is_long(a: Any, b: Any, size: tuple[float, float]) -> bool:
    """At least half as long as the plate in that direction: no finger beside a cut off corner."""
    across, up = abs(b[0] - a[0]), abs(b[1] - a[1])
    return 2 * (across**2 + up**2) > across * size[0] + up * size[1]


def _place(points: list[Any]) -> tuple[float, ...]:
    """The box around points as seen from above."""
    across, up = [p[0] for p in points], [p[1] for p in points]
    return tuple(round(x, 4) for x in (min(across), max(across), min(up), max(up)))


def bodies_shape(bodies: Iterable[Manifold]) -> Any:
    """A compound of bodies of triangles, triangles of one plane made one face."""
    return Part.makeCompound([_body_shape(body) for body in bodies if not body.is_empty()])


def _body_shape(body: Manifold) -> Any:
    mesh = body.to_mesh64()
    points = [FreeCAD.Vector(*p) for p in mesh.vert_properties[:, :3].tolist()]
    triangles = [_face([[points[n] for n in t]]) for t in mesh.tri_verts.tolist()]
    return Part.makeSolid(Part.makeShell(triangles)).removeSplitter()


def _points(ids: Iterable[str], solution: Solution) -> list[Any]:
    return [FreeCAD.Vector(*(float(x) for x in solution.vertices_mm[v])) for v in ids]


def _face(loops: list[list[Any]]) -> Any:
    """A planar face; its outer loop first, then holes, wound any way."""
    wires = _wires(loops)
    if len(wires) == 1:
        return Part.Face(wires)
    return Part.makeFace(wires, "Part::FaceMakerCheese")


def _wires(loops: list[list[Any]]) -> list[Any]:
    return [Part.makePolygon([*loop, loop[0]]) for loop in loops]


def _pair(v: str, w: str) -> tuple[str, str]:
    return (v, w) if v < w else (w, v)
