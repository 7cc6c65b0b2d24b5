"""Objects lit and shaded: soft light from many directions, shadows on themselves and the ground.

Terms
-----
depth map
    For each pixel the nearest surface; seen from the eye it says what is seen, seen from a lamp
    (from infinitely far) what is lit.
key, sky
    The strong light, from a small patch of directions; and the weak one from everywhere above.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageFilter

from ...solver.values import Array
from ..fabrication.rendering import OUTLINE, Scene, View, outlines, rasterised, triangle_normals

#: Each pixel is drawn as so many by so many.
FINE = 2
_KEY, _SKY = 5, 26
#: A depth map from a lamp has so many pixels along its longer side.
_MAP = 300
_KEY_SPREAD = 0.13
_KEY_SHARE, _SKY_SHARE = 0.60, 0.50
_GROUND_DARK = 0.7
#: Points are looked up so many of the map's pixels before their surface.
_BEFORE_PX = 1.5


@dataclass(frozen=True, slots=True, eq=False)
class _Seen:
    """What each pixel shows: the triangle's number (-1: none) and where it is in the world."""

    triangles: NDArray[np.int32]
    points_mm: Array


def lit(
    scene: Scene,
    view: View,
    background: Image.Image,
    light_in_cam: tuple[float, float, float],
    *,
    shadow: float = 3.0,
) -> Image.Image:
    """The scene over a background, with its shadow on what it stands on.

    Parameters
    ----------
    scene : Scene
    view : View
        Into the background's pixels.
    background : PIL.Image.Image
        A photo, or a plain page.
    light_in_cam : (x, y, z)
        Where the strong light comes from: right, down and forward, as seen from the camera.
    shadow : float
        How far from the scene's middle there is ground for its shadow, in parts of its size.

    Returns
    -------
    PIL.Image.Image
        Of the background's size.
    """
    size = (background.width * FINE, background.height * FINE)
    fine = View(view.eye_mm, view.rotation_cam_from_world, view.scale * FINE, view.shift * FINE)
    seen = _look(scene, fine, size)
    lamps = [(way, share, _LampMap(scene, way)) for way, share in _lamps(view, light_in_cam)]
    page = np.asarray(background.resize(size, Image.Resampling.BICUBIC), dtype=float).copy()
    page *= _ground(scene, fine, size, lamps, shadow)[..., None]
    covered = seen.triangles >= 0
    page[covered] = _shaded(scene, seen, lamps)[covered]
    edges = outlines(np.where(covered, scene.faces[seen.triangles], 0))
    page[edges] = 0.45 * page[edges] + 0.55 * np.array(OUTLINE)
    picture = Image.fromarray(np.clip(page, 0, 255).astype(np.uint8))
    return picture.resize(background.size, Image.Resampling.BOX)


def _lamps(view: View, light_in_cam: tuple[float, float, float]) -> list[tuple[Array, float]]:
    """Directions towards the light, and what each gives; the shares of each kind sum up to 1."""
    key = view.rotation_cam_from_world.T @ np.array(light_in_cam)
    key[2] = max(float(key[2]), 0.45 * float(np.linalg.norm(key)))
    key /= np.linalg.norm(key)
    found = [
        (_unit(key + _KEY_SPREAD * spot), _KEY_SHARE / _KEY) for spot in _spiral(_KEY, lowest=-1.0)
    ]
    sky = _spiral(_SKY, lowest=0.06)
    total = float(sum(way[2] for way in sky))
    return found + [(way, _SKY_SHARE * float(way[2]) / total) for way in sky]


def _spiral(count: int, lowest: float) -> list[Array]:
    """Directions spread evenly over the part of the sphere above a height."""
    height = lowest + (1 - lowest) * (np.arange(count) + 0.5) / count
    turn = np.pi * (1 + 5**0.5) * np.arange(count)
    flat = np.sqrt(1 - height**2)
    return list(np.column_stack([flat * np.cos(turn), flat * np.sin(turn), height]))


def _unit(way: Array) -> Array:
    return np.asarray(way / np.linalg.norm(way))


def _look(scene: Scene, view: View, size: tuple[int, int]) -> _Seen:
    """What is seen from the eye."""
    flat, depth = view.project(scene.triangles_mm.reshape(-1, 3))
    flat, depth = flat.reshape(-1, 3, 2), depth.reshape(-1, 3)
    nearest, number = _depth_map(flat, 1.0 / depth, size)
    x, y = np.meshgrid(np.arange(size[0]) + 0.5, np.arange(size[1]) + 0.5)
    rays = np.dstack(
        [(x - view.shift[0]) / view.scale, (y - view.shift[1]) / view.scale, x * 0 + 1]
    )
    far = np.divide(1.0, nearest, out=np.zeros_like(nearest), where=nearest > 0)
    points = view.eye_mm + (rays * far[..., None]) @ view.rotation_cam_from_world
    return _Seen(number, points)


def _depth_map(
    flat: Array, nearness: Array, size: tuple[int, int]
) -> tuple[Array, NDArray[np.int32]]:
    """Nearness (0: nothing) and number of the nearest triangle at each pixel."""
    nearest = np.zeros((size[1], size[0]))
    number = np.full((size[1], size[0]), -1, dtype=np.int32)
    for n in np.flatnonzero((nearness > 0).all(axis=1)).tolist():
        window, inside, mine = rasterised(flat[n], nearness[n], size)
        if window is None:
            continue
        won = inside & (mine > nearest[window])
        nearest[window][won] = mine[won]
        number[window][won] = n
    return nearest, number


class _LampMap:
    """What a lamp sees of a scene: its depth map, and the test whether points are lit."""

    def __init__(self, scene: Scene, way: Array) -> None:
        side = np.cross(way, [1.0, 0.0, 0.0] if abs(way[0]) < 0.9 else [0.0, 1.0, 0.0])
        side /= np.linalg.norm(side)
        self._axes = np.array([side, np.cross(way, side), way])
        # What looks away from the lamp hides nothing that what looks at it does not.
        facing = triangle_normals(scene.triangles_mm) @ way > 0
        placed = scene.triangles_mm[facing].reshape(-1, 3) @ self._axes.T
        self._low, high = placed.min(axis=0), placed.max(axis=0)
        self._scale = _MAP / float(max(high[:2] - self._low[:2]))
        self._size = tuple((np.ceil((high - self._low)[:2] * self._scale) + 1).astype(int).tolist())
        flat = (placed[:, :2] - self._low[:2]) * self._scale
        nearness = 1.0 + placed[:, 2] - self._low[2]
        reach = float(np.linalg.norm(high - self._low))
        self._slack = 0.004 * reach
        self._nearest, _ = _depth_map(flat.reshape(-1, 3, 2), nearness.reshape(-1, 3), self._size)

    def lights(self, points_mm: Array, normals: Array | None = None) -> Array:
        """1 where points (n, 3) are lit, 0 where something is in between.

        With normals, points of a surface: a little before it, so that it throws no shadow on
        itself where the map is too coarse for its slope.
        """
        if normals is not None:
            points_mm = points_mm + normals * (_BEFORE_PX / self._scale)
        placed = points_mm @ self._axes.T - self._low
        at = np.floor(placed[:, :2] * self._scale).astype(int)
        inside = ((at >= 0) & (at < self._size)).all(axis=1)
        found = np.ones(len(points_mm))
        x, y = at[inside].T
        hidden = self._nearest[y, x] > 1.0 + placed[inside, 2] + self._slack
        found[inside] = np.where(hidden, 0.0, 1.0)
        return found


Lamps = list[tuple[Array, float, _LampMap]]


def _shaded(scene: Scene, seen: _Seen, lamps: Lamps) -> Array:
    """The colour of each pixel that shows the scene."""
    covered = seen.triangles >= 0
    points = seen.points_mm[covered]
    numbers = seen.triangles[covered]
    flat = triangle_normals(scene.triangles_mm)[numbers]
    normals = _smooth_normals(scene, numbers, points)
    light = np.zeros(len(points))
    for way, share, lamp in lamps:
        facing = normals @ way
        light += share * np.clip(facing, 0, None) ** 0.8 * lamp.lights(points, flat)
    # What is thrown back by the ground and the room.
    light += 0.34 + 0.06 * np.clip(-normals[:, 2], 0, None)
    page = np.zeros((*covered.shape, 3))
    page[covered] = scene.colours[numbers] * (np.minimum(light, 1.25) ** 0.75)[:, None] * 1.02
    return page


def _smooth_normals(scene: Scene, numbers: NDArray[np.int32], points_mm: Array) -> Array:
    """The normals at points of triangles, as of the curved face that these stand for, (n, 3)."""
    corners = np.round(scene.triangles_mm.reshape(-1, 3), 4)
    a, b, c = scene.triangles_mm[:, 0], scene.triangles_mm[:, 1], scene.triangles_mm[:, 2]
    weighed = np.repeat(np.cross(b - a, c - a), 3, axis=0)
    keys = np.column_stack([np.repeat(scene.faces, 3), corners])
    _, vertex = np.unique(keys, axis=0, return_inverse=True)
    vertex = vertex.reshape(-1)
    total = np.column_stack([np.bincount(vertex, weighed[:, k]) for k in range(3)])
    total /= np.maximum(np.linalg.norm(total, axis=1), 1e-12)[:, None]
    at = total[vertex].reshape(-1, 3, 3)
    u, v, w = ((t[numbers]) for t in (b - a, c - a, a))
    w = points_mm - w
    uu, uv, vv = (np.einsum("ij,ij->i", p, q) for p, q in ((u, u), (u, v), (v, v)))
    uw, vw = (np.einsum("ij,ij->i", p, w) for p in (u, v))
    size = np.maximum(uu * vv - uv * uv, 1e-12)
    s, t = (vv * uw - uv * vw) / size, (uu * vw - uv * uw) / size
    shares = np.clip(np.column_stack([1 - s - t, s, t]), 0, 1)
    normals = np.einsum("ij,ijk->ik", shares, at[numbers])
    return np.asarray(normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-12)[:, None])


def _ground(scene: Scene, view: View, size: tuple[int, int], lamps: Lamps, shadow: float) -> Array:
    """How much light reaches the ground at each pixel, in parts of what it was."""
    level = float(scene.triangles_mm[..., 2].min())
    step = 4 * FINE
    x, y = np.meshgrid(np.arange(0, size[0] + step, step), np.arange(0, size[1] + step, step))
    rays = np.dstack(
        [(x - view.shift[0]) / view.scale, (y - view.shift[1]) / view.scale, x * 0 + 1]
    )
    ways = rays @ view.rotation_cam_from_world
    with np.errstate(divide="ignore", invalid="ignore"):
        far = (level - view.eye_mm[2]) / ways[..., 2]
    reach = float(np.linalg.norm(np.ptp(scene.triangles_mm.reshape(-1, 3), axis=0)))
    middle = scene.triangles_mm.reshape(-1, 3).mean(axis=0)
    spots = view.eye_mm + ways * np.where(np.isfinite(far), far, -1.0)[..., None]
    away = np.linalg.norm(spots - middle, axis=-1) / reach
    near = (far > 0) & (away < shadow)
    dark = np.zeros(far.shape)
    for way, share, lamp in lamps:
        dark[near] += share * float(way[2]) * (1 - lamp.lights(spots[near]))
    # Where the ground ends, the shadow ends softly.
    dark *= np.clip((shadow - away) / 0.15, 0, 1)
    most = sum(share * float(way[2]) for way, share, _ in lamps)
    picture = Image.fromarray((255 * (1 - _GROUND_DARK * dark / most)).astype(np.uint8))
    soft = picture.filter(ImageFilter.GaussianBlur(1.5))
    large = soft.resize((dark.shape[1] * step, dark.shape[0] * step), Image.Resampling.BICUBIC)
    return np.asarray(large, dtype=float)[: size[1], : size[0]] / 255
