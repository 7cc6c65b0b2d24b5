"""What holds for every print, judged by other means than those that made it."""

from __future__ import annotations

from collections.abc import Iterator
from unittest import mock

import manifold3d as m3
import numpy as np
import shapely
from fabrication.bodies import drawn_body

from incontext.solver.model import Model, ModelFace
from incontext.workbench.fabrication import ShellSettings, shell, shell_solid
from incontext.workbench.fabrication.enclosed import enclosed, plane_axes
from incontext.workbench.fabrication.frame import newell
from incontext.workbench.fabrication.meshes import mesh_of
from incontext.workbench.fabrication.sides import face_sides

#: So many walls from all faces nothing is filled.
FAR = 4.0
#: So many walls around an opening its rim reaches.
RIM = 1.5


def broken_print(model: Model, settings: ShellSettings) -> Iterator[str]:
    """Each law that a print breaks."""
    with mock.patch.object(shell, "_bead", wraps=shell._bead) as bead:
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
    corners = mesh.vertices_mm
    for (edge, radius), _ in bead.call_args_list:  # thicker there, with corners of its own
        way = edge[1] - edge[0]
        share = np.clip((corners - edge[0]) @ way / (way @ way), 0.0, 1.0)
        away = np.linalg.norm(corners - edge[0] - np.outer(share, way), axis=1)
        corners = corners[away > 2 * radius]
    yield from _of_thickness(model, settings, corners, 1e-5 * size)
    yield from _of_slabs(model, settings, body_)
    yield from _of_hollow(model, settings, body_)
    drawn = drawn_body(model)
    if drawn is None or settings.side == "middle":
        return
    wrong = body_ - drawn if settings.side == "inside" else body_ ^ drawn
    loops = {id_: (f.loop_mm, *f.holes_mm) for id_, f in model.faces.items()}
    parted = any(side == 0 for side in face_sides(loops, list(loops)).values())
    # Partitions lie within, whichever side the wall is on.
    if (settings.side == "inside" or not parted) and wrong.volume() > 1e-6 * size**3:
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
    least = settings.wall_mm / (2 if settings.side == "middle" else 1)
    on, gaps = np.full(len(corners), np.inf), np.full(len(corners), np.inf)
    for id_, face in model.faces.items():
        gap = _distances(face, corners)
        normal = newell(face.loop_mm) / np.linalg.norm(newell(face.loop_mm))
        off = np.abs((corners - face.loop_mm[0]) @ normal)
        if sides[id_] == 0:  # a partition's own corners: `_of_slabs` holds them to its slab
            own = (np.abs(off - settings.wall_mm / 2) < near) & (gap < 2 * settings.wall_mm)
            on = np.where(own, 0.0, on)
            continue
        # The rim of an opening lies in its plane, beside it too, or square: `_of_slabs` holds the
        # walls there to what stands on their faces.
        off = gap if face.included else np.where(gap < RIM * least, 0.0, off)
        on = np.minimum(on, off)
        gaps = np.minimum(gaps, gap) if face.included else gaps
    thin = (gaps < least - near) & (on > near)
    if thin.any():
        yield f"a wall is {gaps[thin].min():.4g} mm thick instead of {least:.4g}"


def _of_slabs(model: Model, settings: ShellSettings, print_: m3.Manifold) -> Iterator[str]:
    """All that lies straight over a face, up to its wall's thickness, is filled.

    Of a partition this is half a wall on both sides, within the drawn faces. Outside of them walls
    end at the planes of openings.
    """
    loops = {id_: (f.loop_mm, *f.holes_mm) for id_, f in model.faces.items()}
    sides = face_sides(loops, list(loops))
    skin = {id_: (f.loop, *f.holes) for id_, f in model.faces.items() if sides[id_]}
    drawn = enclosed(skin, model.vertices_mm, sides)
    if drawn is None:
        return
    mouths, windows = [], []
    for id_ in (id_ for id_ in skin if not model.faces[id_].included):
        mouth, loop = model.faces[id_], model.faces[id_].loop_mm
        inwards = sides[id_] * newell(loop) / np.linalg.norm(newell(loop))
        beside = [f for f in skin if model.faces[f].included]
        off = [np.abs((model.faces[f].loop_mm - loop[0]) @ inwards).max() for f in beside]
        if min(off, default=1.0) < 1e-4:
            windows.append(_slab(mouth, -settings.wall_mm, settings.wall_mm))
        else:
            mouths.append((set(mouth.loop), inwards, float(inwards @ loop[0])))
    for id_, face in model.faces.items():
        if not face.included:
            continue
        halved = settings.side == "middle" or not sides[id_]
        reach = settings.wall_mm / (2 if halved else 1)
        slab = _slab(face, -reach, reach)
        within, beyond = slab ^ drawn, m3.Manifold()
        if sides[id_]:
            within = _slab(face, *sorted([0.0, sides[id_] * reach])) ^ drawn
            beyond = _slab(face, *sorted([0.0, -sides[id_] * reach])) - drawn
        for window in windows:
            within, beyond = within - window, beyond - window
        for corners, inwards, limit in mouths:
            if not corners.isdisjoint(face.loop):
                beyond = beyond.trim_by_plane(inwards, limit)
        asked = {"inside": [within], "outside": [beyond], "middle": [within, beyond]}
        for part in asked[settings.side] if sides[id_] else [within]:
            lacks = (part - print_).volume()
            if lacks > 1e-4 * slab.volume():
                yield f"{id_} lacks {lacks:.3g} mm3 of its {slab.volume():.6g} mm3"


def _of_hollow(model: Model, settings: ShellSettings, print_: m3.Manifold) -> Iterator[str]:
    """Far from all faces nothing is filled.

    Mitres of two faces end within `FAR` walls where the angle between them is above 30 degrees.
    """
    points = np.array(list(model.vertices_mm.values()))
    low, size = points.min(axis=0), np.ptp(points, axis=0)
    grid = np.array(np.meshgrid(*3 * [(np.arange(12) + 0.5) / 12])).reshape(3, -1).T
    spots = low + grid * size
    gaps = np.min([_distances(face, spots) for face in model.faces.values()], axis=0)
    far = spots[gaps > FAR * settings.wall_mm]
    full = [spot for spot in far if _crossings(print_, spot, float(2 * size.max())) % 2]
    if full:
        yield f"{np.round(full[0], 2).tolist()} is filled, far from all faces"


def _crossings(body: m3.Manifold, spot: np.ndarray, reach: float) -> int:
    """How often a way out of a body, along no axis, crosses its surface."""
    way = np.array([0.613, 0.377, 0.694])
    return len(body.ray_cast(spot, spot + reach * way / np.linalg.norm(way)))


def _slab(face: ModelFace, low_mm: float, high_mm: float) -> m3.Manifold:
    """What lies straight over a face, from `low_mm` to `high_mm` along its loop's normal."""
    axes = plane_axes(face.loop_mm)
    rings = [((ring - face.loop_mm[0]) @ axes[:2].T) for ring in (face.loop_mm, *face.holes_mm)]
    flat = m3.CrossSection(rings, m3.FillRule.EvenOdd)
    slab = flat.extrude(high_mm - low_mm).translate([0.0, 0.0, low_mm])
    return slab.transform(np.column_stack([axes.T, face.loop_mm[0]]))


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
