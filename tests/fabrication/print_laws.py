"""What holds for every print, judged by other means than those that made it."""

from __future__ import annotations

from collections.abc import Iterator

import manifold3d as m3
import numpy as np
import shapely
from fabrication.bodies import drawn_body

from incontext.solver.model import Model, ModelFace
from incontext.workbench.fabrication import ShellSettings, shell_solid
from incontext.workbench.fabrication.enclosed import enclosed, plane_axes
from incontext.workbench.fabrication.frame import newell
from incontext.workbench.fabrication.meshes import mesh_of
from incontext.workbench.fabrication.sides import face_sides


def broken_print(model: Model, settings: ShellSettings) -> Iterator[str]:
    """Each law that a print breaks."""
    solid = shell_solid(model, settings)
    mesh = mesh_of(solid, settings.tolerance_mm)
    body_ = m3.Manifold(m3.Mesh64(mesh.vertices_mm, mesh.triangles.astype(np.uint64)))
    size = float(np.ptp(mesh.vertices_mm, axis=0).max())
    low = mesh.vertices_mm.min(axis=0)
    beside = m3.Manifold.cube([1.0] * 3).translate(low - 10.0)
    # A boolean counts what lies in itself once only.
    if abs((body_ + beside).volume() - 1.0 - body_.volume()) > 1e-6 * body_.volume() + 1e-9:
        yield "the surface passes through itself"
    if len(body_.decompose()) != 1 and not any(f.included for f in model.faces.values()):
        yield "the print is in pieces"
    yield from _of_thickness(model, settings, mesh.vertices_mm, 1e-5 * size)
    yield from _of_partitions(model, settings, body_)
    drawn = drawn_body(model)
    if drawn is None or settings.side == "middle":
        return
    wrong = body_ - drawn if settings.side == "inside" else body_ ^ drawn
    if wrong.volume() > 1e-6 * size**3:
        yield f"{wrong.volume():.3g} mm3 lie on the wrong side"
    closed = all(face.included for face in model.faces.values())
    hull = m3.Manifold.hull_points(np.array(list(model.vertices_mm.values())))
    if closed and abs(hull.volume() - drawn.volume()) < 1e-9 * hull.volume():
        yield from _of_convex_print(model, settings, body_.volume(), hull)


def _of_thickness(
    model: Model, settings: ShellSettings, corners: np.ndarray, near: float
) -> Iterator[str]:
    """Corners of a print lie on the drawn faces, or a wall or more away from those made."""
    loops = {id_: (f.loop_mm, *f.holes_mm) for id_, f in model.faces.items()}
    sides = face_sides(loops, list(loops))
    on, gaps = np.full(len(corners), np.inf), np.full(len(corners), np.inf)
    for id_, face in model.faces.items():
        gap = _distances(face, corners)
        normal = newell(face.loop_mm) / np.linalg.norm(newell(face.loop_mm))
        off = np.abs((corners - face.loop_mm[0]) @ normal)
        if sides[id_] == 0:  # a partition's own corners: `_of_partitions` holds them to its slab
            own = (np.abs(off - settings.wall_mm / 2) < near) & (gap < 2 * settings.wall_mm)
            on = np.where(own, 0.0, on)
            continue
        if face.included:
            on = np.minimum(on, _off_rims(model, face, corners))
        # The rim of an opening lies in its plane, beside it too.
        off = gap if face.included else off
        on = np.minimum(on, off)
        gaps = np.minimum(gaps, gap) if face.included else gaps
    least = settings.wall_mm / (2 if settings.side == "middle" else 1)
    thin = (gaps < least - near) & (on > near)
    if thin.any():
        yield f"a wall is {gaps[thin].min():.4g} mm thick instead of {least:.4g}"


def _off_rims(model: Model, face: ModelFace, points: np.ndarray) -> np.ndarray:
    """How far points lie from the planes square to a face in its edges at openings."""
    off = np.full(len(points), np.inf)
    normal = newell(face.loop_mm) / np.linalg.norm(newell(face.loop_mm))
    mouths = [
        {v, loop[n - 1]}
        for other in model.faces.values()
        for loop in (other.loop, *other.holes)
        for n, v in enumerate(loop)
        if not other.included
    ]
    for loop in (face.loop, *face.holes):
        for n, v in enumerate(loop):
            if {v, loop[n - 1]} in mouths:
                a, b = model.vertices_mm[loop[n - 1]], model.vertices_mm[v]
                along = (b - a) / np.linalg.norm(b - a)
                heights = (points - a) @ along
                within = (heights > -1e-6) & (heights < np.linalg.norm(b - a) + 1e-6)
                beside = np.abs((points - a) @ np.cross(along, normal))
                off = np.minimum(off, np.where(within, beside, np.inf))
    return off


def _of_partitions(model: Model, settings: ShellSettings, print_: m3.Manifold) -> Iterator[str]:
    """Half a wall on both sides of each partition is filled, within the drawn faces."""
    loops = {id_: (f.loop_mm, *f.holes_mm) for id_, f in model.faces.items()}
    sides = face_sides(loops, list(loops))
    skin = {id_: (f.loop, *f.holes) for id_, f in model.faces.items() if sides[id_]}
    drawn = enclosed(skin, model.vertices_mm, sides)
    if drawn is None:
        return
    for id_, face in model.faces.items():
        if sides[id_] or not face.included:
            continue
        axes = plane_axes(face.loop_mm)
        rings = [((ring - face.loop_mm[0]) @ axes[:2].T) for ring in loops[id_]]
        flat = m3.CrossSection(rings, m3.FillRule.EvenOdd)
        slab = flat.extrude(settings.wall_mm).translate([0.0, 0.0, -settings.wall_mm / 2])
        slab = slab.transform(np.column_stack([axes.T, face.loop_mm[0]]))
        lacks = ((slab ^ drawn) - print_).volume()
        if lacks > 1e-4 * slab.volume():
            yield f"{id_} lacks {lacks:.3g} mm3 of its {slab.volume():.6g} mm3"


def _distances(face: ModelFace, points: np.ndarray) -> np.ndarray:
    """How far points lie from a face."""
    normal = newell(face.loop_mm) / np.linalg.norm(newell(face.loop_mm))
    along = face.loop_mm[1] - face.loop_mm[0]
    along = along / np.linalg.norm(along)
    axes = np.array([along, np.cross(normal, along)])
    flat = [(ring - face.loop_mm[0]) @ axes.T for ring in (face.loop_mm, *face.holes_mm)]
    spots = shapely.points((points - face.loop_mm[0]) @ axes.T)
    beside = shapely.distance(shapely.Polygon(flat[0], flat[1:]), spots)
    return np.hypot(beside, (points - face.loop_mm[0]) @ normal)


def _of_convex_print(
    model: Model, settings: ShellSettings, volume: float, hull: m3.Manifold
) -> Iterator[str]:
    """The wall of a convex body lies between two sets of half-spaces."""
    move = -settings.wall_mm if settings.side == "inside" else settings.wall_mm
    middle = np.mean(list(model.vertices_mm.values()), axis=0)
    other = m3.Manifold.cube([1e5] * 3, center=True).translate(middle)
    for face in model.faces.values():
        normal = newell(face.loop_mm) / np.linalg.norm(newell(face.loop_mm))
        normal = normal if normal @ (face.loop_mm[0] - middle) > 0 else -normal
        other = other.trim_by_plane(-normal, float(-normal @ face.loop_mm[0]) - move)
    wanted = abs(hull.volume() - other.volume())
    if abs(volume - wanted) > 1e-5 * wanted:
        yield f"the wall has {volume:.6g} mm3 instead of {wanted:.6g}"
