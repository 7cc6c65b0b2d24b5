"""Rectangles on the ground as cameras see them: exactly, and as photos with noise and blur."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter

from incontext.solver.camera import Camera
from incontext.solver.graph import Photo
from incontext.workbench.marker_sheet import FIELDS, PATTERN

PHOTO = Photo(None, 1600, 1200)
SMALL = Photo(None, 800, 600)


def camera_at(
    elevation_deg: float,
    azimuth_deg: float,
    distance_mm: float,
    focal_px: float,
    *,
    roll_deg: float = 0.0,
    photo: Photo = PHOTO,
) -> Camera:
    """A camera that looks at the world's origin."""
    e, a, r = np.radians([elevation_deg, azimuth_deg, roll_deg])
    back = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    R = np.array([right, -np.cross(back, right), -back])
    roll = np.array([[np.cos(r), -np.sin(r), 0], [np.sin(r), np.cos(r), 0], [0, 0, 1]])
    principal = photo.principal_point_px or (photo.width_px / 2, photo.height_px / 2)
    R = roll @ R
    return Camera(focal_px, np.array(principal), R, -R @ (distance_mm * back))


def corners_mm(size_mm: tuple[float, float]) -> np.ndarray:
    """Counterclockwise as seen from above, the first at (-x, -y)."""
    half = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) / 2
    return half * [*size_mm, 0.0]


def turned_alike(camera: Camera, found: Camera) -> np.ndarray:
    """The found rotation, by quarter turns about the vertical as near as can be to the true one."""
    quarter = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    turns = [np.linalg.matrix_power(quarter, k) for k in range(4)]
    ways = [found.rotation_cam_from_world @ turn for turn in turns]
    return min(ways, key=lambda R: float(np.abs(R - camera.rotation_cam_from_world).max()))


def seen(
    camera: Camera,
    photo: Photo,
    rng: np.random.Generator,
    *,
    size_mm: float = 100.0,
    paper_mm: tuple[float, float] = (160.0, 180.0),
    noise: float = 3.0,
    blur_px: float = 0.8,
    bend: float = 0.0,
) -> np.ndarray:
    """A photo (height, width) of the printed marker on a grey table, in uneven light.

    Parameters
    ----------
    bend : float
        Radial distortion: what is at r is seen at r (1 - bend r^2), in half diagonals.
    """
    fine = 2
    w, h = photo.width_px, photo.height_px
    u, v = np.meshgrid((np.arange(w * fine) + 0.5) / fine, (np.arange(h * fine) + 0.5) / fine)
    off_u, off_v = u - w / 2, v - h / 2
    longer = 1 + bend * (off_u**2 + off_v**2) / (w**2 + h**2) * 4
    u, v = w / 2 + off_u * longer, h / 2 + off_v * longer
    R = camera.rotation_cam_from_world
    t = camera.translation_cam_from_world_mm
    K = np.diag([camera.focal_px, camera.focal_px, 1.0])
    K[:2, 2] = camera.principal_point_px
    G = np.linalg.inv(K @ np.column_stack([R[:, 0], R[:, 1], t]))
    x, y, depth = np.einsum("ij,jvu->ivu", G, np.stack([u, v, np.ones_like(u)]))
    x, y = x / depth / size_mm, y / depth / size_mm
    shade = np.full(x.shape, 110.0)
    shade[(np.abs(x) < paper_mm[0] / size_mm / 2) & (np.abs(y) < paper_mm[1] / size_mm / 2)] = 215
    column, row = (np.floor((s + 0.5) * FIELDS).astype(int) for s in (x, -y))
    inside = (column >= 0) & (column < FIELDS) & (row >= 0) & (row < FIELDS)
    fields = np.full((FIELDS, FIELDS), 35.0)
    fields[1:-1, 1:-1] = np.where(np.array([[b == "1" for b in line] for line in PATTERN]), 215, 35)
    shade[inside] = fields[row[inside], column[inside]]
    shade *= 0.75 + 0.4 * u / w
    shade = shade.reshape(h, fine, w, fine).mean(axis=(1, 3))
    picture = gaussian_filter(shade, blur_px) + rng.normal(0, noise, shade.shape)
    return np.clip(np.rint(picture), 0, 255)
