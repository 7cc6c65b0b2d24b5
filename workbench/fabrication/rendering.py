"""Shaded pictures of flat-faced bodies: a z-buffer in numpy, outlines where faces change.

Terms
-----
scene
    Triangles in the world, each with the number of the flat face it belongs to and its colour.
view
    What turns world points into picture positions and depths.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFilter

from ...solver.camera import Camera
from ...solver.union_find import UnionFind
from ...solver.values import Array
from .meshes import PLASTIC
from .plates import Plate

WOOD = (233, 203, 158)
BURNT = (150, 106, 66)
#: Facets that meet at less than about 15 degrees belong to one curved face.
CREASE_COSINE = 0.966
OUTLINE = (74, 56, 40)
#: Each pixel is drawn as so many by so many.
SUPERSAMPLING = 3


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """What is to be shown.

    Parameters
    ----------
    triangles_mm : (n, 3, 3) array
    faces : (n,) array of int
        Numbers of flat faces, from 1; an outline is drawn where the number changes.
    colours : (n, 3) array
        0 to 255.
    """

    triangles_mm: Array
    faces: NDArray[np.int32]
    colours: Array


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """A perspective view from `eye_mm`, fitted into a picture."""

    eye_mm: Array
    rotation_cam_from_world: Array
    scale: float
    shift: Array

    def project(self, points: Array) -> tuple[Array, Array]:
        """Picture positions (n, 2), px, and depths (n,), mm, of world points."""
        in_cam = (points - self.eye_mm) @ self.rotation_cam_from_world.T
        return in_cam[:, :2] / in_cam[:, 2:] * self.scale + self.shift, in_cam[:, 2]


def plates_scene(plates: Sequence[Plate]) -> Scene:
    """Plates as wood with burnt edges."""
    from .prisms import prism

    triangles, owners, colours = [], [], []
    for number, plate in enumerate(plates):
        mesh = prism(plate.polygon, 0.0, plate.thickness_mm).to_mesh64()
        local = np.asarray(mesh.vert_properties)[:, :3][np.asarray(mesh.tri_verts, dtype=int)]
        flat = np.ptp(local[:, :, 2], axis=1) < 1e-9
        place = plate.world_from_plate
        triangles.append(local @ place[:3, :3].T + place[:3, 3])
        owners.append(np.full(len(local), number))
        colours.append(np.where(flat[:, None], WOOD, BURNT))
    return _scene(np.concatenate(triangles), np.concatenate(owners), np.concatenate(colours))


def mesh_scene(vertices_mm: Array, triangles: NDArray[np.int32]) -> Scene:
    """A printed solid as plastic; facets of a curved surface are one face."""
    corners = vertices_mm[triangles]
    faces = _smooth_faces(triangles, triangle_normals(corners))
    return Scene(corners, faces + 1, np.tile(np.asarray(PLASTIC, dtype=float), (len(corners), 1)))


def _smooth_faces(triangles: NDArray[np.int32], normals: Array) -> NDArray[np.int32]:
    """Number the triangles by face: neighbours across an edge without a crease are one."""
    sets = UnionFind(len(triangles))
    across: dict[tuple[int, int], int] = {}
    for t, (a, b, c) in enumerate(triangles.tolist()):
        for ends in ((a, b), (b, c), (c, a)):
            other = across.setdefault((min(ends), max(ends)), t)
            if other != t and normals[t] @ normals[other] > CREASE_COSINE:
                sets.union(t, other)
    _, faces = np.unique(sets.labels(), return_inverse=True)
    return np.asarray(faces.reshape(-1), dtype=np.int32)


def _scene(triangles: Array, owners: NDArray[np.int_], colours: Array) -> Scene:
    normals = triangle_normals(triangles)
    at = np.einsum("ij,ij->i", normals, triangles[:, 0])
    keys = np.column_stack([owners, np.round(normals, 3), np.round(at, 2)])
    _, faces = np.unique(keys, axis=0, return_inverse=True)
    numbers = faces.reshape(-1).astype(np.int32) + 1
    return Scene(triangles, numbers, np.asarray(colours, dtype=float))


def triangle_normals(triangles: Array) -> Array:
    """Unit normals (n, 3) of triangles (n, 3, 3)."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.asarray(normals / np.where(lengths > 0, lengths, 1.0))


def fitted_view(points_mm: Array, camera: Camera | None, size_px: tuple[int, int]) -> View:
    """The camera's view (or one from the front, right and above), zoomed onto the points."""
    middle = (points_mm.min(axis=0) + points_mm.max(axis=0)) / 2
    reach = float(np.linalg.norm(np.ptp(points_mm, axis=0)))
    if camera is not None:
        eye, rotation = np.array(camera.position_mm), np.array(camera.rotation_cam_from_world)
        in_front = ((points_mm - eye) @ rotation[2]).min() > 0.05 * reach
    if camera is None or not in_front:
        eye = middle + 2.6 * reach * np.array([0.45, -0.72, 0.53])
        rotation = _looking(middle - eye)
    raw = View(eye, rotation, 1.0, np.zeros(2))
    flat, _ = raw.project(points_mm)
    low, high = flat.min(axis=0), flat.max(axis=0)
    scale = float(np.min(np.array(size_px) * 0.84 / np.maximum(high - low, 1e-9)))
    shift = np.array(size_px) / 2 - scale * (low + high) / 2
    return View(eye, rotation, scale, shift)


def _looking(way: Array) -> Array:
    forward = way / np.linalg.norm(way)
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right = right / np.linalg.norm(right)
    return np.array([right, np.cross(forward, right), forward])


def render(scene: Scene, camera: Camera | None, size_px: tuple[int, int]) -> Image.Image:
    """The scene on white, with a soft shadow on the ground.

    Parameters
    ----------
    scene : Scene
    camera : Camera or None
    size_px : (width, height)

    Returns
    -------
    PIL.Image.Image
    """
    large = (size_px[0] * SUPERSAMPLING, size_px[1] * SUPERSAMPLING)
    points = scene.triangles_mm.reshape(-1, 3)
    view = fitted_view(points, camera, large)
    page = np.asarray(_shadow(scene, view, large), dtype=float)
    colours, faces = _painted(scene, view, large)
    page = np.where(faces[..., None] > 0, colours, page)
    page[outlines(faces)] = OUTLINE
    image = Image.fromarray(np.clip(page, 0, 255).astype(np.uint8))
    return image.resize(size_px, Image.Resampling.BOX)


def _painted(scene: Scene, view: View, size: tuple[int, int]) -> tuple[Array, NDArray[np.int32]]:
    """Colour and face number of the nearest triangle at each pixel."""
    normals = triangle_normals(scene.triangles_mm)
    middles = scene.triangles_mm.mean(axis=1)
    facing = np.einsum("ij,ij->i", normals, view.eye_mm - middles) > 0
    shaded = scene.colours * _brightness(normals, view)[:, None]
    flat, depth = view.project(scene.triangles_mm.reshape(-1, 3))
    flat, depth = flat.reshape(-1, 3, 2), depth.reshape(-1, 3)
    nearest = np.zeros((size[1], size[0]))  # 1 / depth, larger is nearer
    colours = np.zeros((size[1], size[0], 3))
    faces = np.zeros((size[1], size[0]), dtype=np.int32)
    for n in np.flatnonzero(facing).tolist():
        window, inside, inverse = rasterised(flat[n], 1.0 / depth[n], size)
        if window is None:
            continue
        won = inside & (inverse > nearest[window])
        nearest[window][won] = inverse[won]
        colours[window][won] = shaded[n]
        faces[window][won] = scene.faces[n]
    return colours, faces


def _brightness(normals: Array, view: View) -> Array:
    """Light from above, left behind the viewer, and a weaker one from the right."""
    light = view.rotation_cam_from_world.T @ np.array([-0.35, -0.25, -0.55])
    light = light / np.linalg.norm(light) + np.array([0.0, 0.0, 0.75])
    light = light / np.linalg.norm(light)
    fill = view.rotation_cam_from_world.T @ np.array([0.9, -0.1, -0.4])
    fill = fill / np.linalg.norm(fill)
    key, soft = np.clip(normals @ light, 0.0, 1.0), np.clip(normals @ fill, 0.0, 1.0)
    return np.asarray(np.minimum(0.70 + 0.31 * key + 0.14 * soft, 1.02))


def rasterised(
    corners: Array, inverse: Array, size: tuple[int, int]
) -> tuple[tuple[slice, slice] | None, NDArray[np.bool_], Array]:
    """The window of pixels around a triangle, which are inside, and their 1 / depth."""
    low = np.maximum(np.floor(corners.min(axis=0)).astype(int), 0)
    high = np.minimum(np.ceil(corners.max(axis=0)).astype(int) + 1, size)
    (ax, ay), (bx, by), (cx, cy) = corners.tolist()
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if (low >= high).any() or abs(area) < 1e-9:
        return None, np.zeros(0, dtype=bool), np.zeros(0)
    x = np.arange(low[0], high[0])[None, :] + 0.5
    y = np.arange(low[1], high[1])[:, None] + 0.5
    b = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
    c = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
    inside = (b >= -1e-9) & (c >= -1e-9) & (b + c <= 1 + 1e-9)
    # 1 / depth is linear in the picture.
    depth = inverse[0] + b * (inverse[1] - inverse[0]) + c * (inverse[2] - inverse[0])
    return (slice(low[1], high[1]), slice(low[0], high[0])), inside, depth


def outlines(faces: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Pixels at which the face changes, thickened to about one pixel of the final picture."""
    change = np.zeros(faces.shape, dtype=bool)
    across = faces[:, 1:] != faces[:, :-1]
    down = faces[1:] != faces[:-1]
    change[:, 1:] |= across
    change[:, :-1] |= across
    change[1:] |= down
    change[:-1] |= down
    return change


def _shadow(scene: Scene, view: View, size: tuple[int, int]) -> Image.Image:
    """The scene's shadow on the ground, soft, on white."""
    page = Image.new("L", size, 255)
    ground = float(scene.triangles_mm[..., 2].min())
    if view.eye_mm[2] > ground + 1e-6:
        points = scene.triangles_mm.reshape(-1, 3).copy()
        height = points[:, 2] - ground
        points[:, :2] += height[:, None] * np.array([0.22, 0.12])
        points[:, 2] = ground
        flat, depth = view.project(points)
        drawing = ImageDraw.Draw(page)
        for corners, near in zip(
            flat.reshape(-1, 3, 2), depth.reshape(-1, 3).min(axis=1), strict=True
        ):
            if near > 0:
                drawing.polygon([(x, y) for x, y in corners.tolist()], fill=214)
        page = page.filter(ImageFilter.GaussianBlur(7 * SUPERSAMPLING))
    return page.convert("RGB")
