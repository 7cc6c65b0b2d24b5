"""Pictures like Figures 8 and 9 of [Lau10]: the same inputs, the methods side by side."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...solver import solve
from ...solver.reference import METHODS, Limits
from ...solver.synthetic import Photograph, bookshelf, box, l_shape, photograph, table
from ...solver.values import Array

if TYPE_CHECKING:
    from PIL import Image

CELL, MARGIN, LABEL = 360, 44, 30
INK, PAPER = (20, 40, 90), (255, 255, 255)
#: Faces, and the edges behind them.
FACE, BEHIND = (232, 239, 250), (186, 197, 220)
#: An edge of a face is not behind it, within so much of the object's size.
NEAR = 0.012
FINE = 3  # drawn larger and scaled down, for smooth lines
#: The result is shown turned so far from the photo's direction, degrees, to show its depth.
TURNED_DEG = 35.0
LIMITS = Limits(evaluations_per_dimension=200)

Edges = Sequence[tuple[int, int]]
Faces = Sequence[Sequence[int]]


def write_pictures(folder: Path) -> list[Path]:
    """Write figure8.png and figure9.png; gives their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for name, make in (("figure8.png", figure_8), ("figure9.png", figure_9)):
        make().save(folder / name)
        written.append(folder / name)
    return written


def figure_8() -> Image.Image:
    """Each column one careless sketch; below it Lipson's, the paper's and our result."""
    shapes = (box(100, 100, 100, "cube"), l_shape(), bookshelf())
    photos = [photograph(s, np.random.default_rng(k), noise=0.005) for k, s in enumerate(shapes)]
    rows = [[_drawn(photo) for photo in photos]]
    for name in ("lipson1996", "lau2010"):
        rows.append(
            [
                _lifted(photo, METHODS[name](photo.graph, limits=LIMITS).vertices_mm, name)
                for photo in photos
            ]
        )
    rows.append([_lifted(photo, solve(photo.graph).vertices_mm, "ours") for photo in photos])
    return _sheet(rows)


def figure_9() -> Image.Image:
    """(a) an inconsistent sketch, (b) its precise shape; (c) a table's sketch, (d) its shape."""
    photos = [
        photograph(l_shape(), np.random.default_rng(3), noise=0.025),
        photograph(table(), np.random.default_rng(1), noise=0.005),
    ]
    cells = []
    for photo, (drawn, lifted) in zip(photos, (("(a)", "(b)"), ("(c)", "(d)")), strict=True):
        cells.append(_drawn(photo, f"{drawn} sketch"))
        cells.append(_lifted(photo, solve(photo.graph).vertices_mm, f"{lifted} ours"))
    return _sheet([cells])


def _drawn(photo: Photograph, label: str = "sketch") -> Image.Image:
    points = np.array(list(photo.graph.vertices.values()))
    return _cell(points, photo.shape.edges, label)


def _lifted(photo: Photograph, vertices_mm: Mapping[str, Array], name: str) -> Image.Image:
    if not vertices_mm:
        return _cell(np.zeros((1, 2)), (), f"{name}: no result")
    X = np.array(list(vertices_mm.values()))
    percent = 100 * photo.error(vertices_mm)
    turned = _from_the_side(X, photo)
    label = f"{name}: error {percent:.2g} %"
    return _cell(turned, photo.shape.edges, label, photo.shape.loops)


def _from_the_side(X: Array, photo: Photograph) -> Array:
    """The result brought to the truth's frame and turned about z, in the camera's axes (n, 3)."""
    X = X - X.mean(axis=0)
    truth = photo.shape.X - photo.shape.X.mean(axis=0)
    U, _, Vt = np.linalg.svd(X.T @ truth)
    X = X @ (U @ np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))]) @ Vt)
    c, s = np.cos(np.radians(TURNED_DEG)), np.sin(np.radians(TURNED_DEG))
    about_z = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    return np.asarray(X @ about_z.T @ photo.camera.rotation_cam_from_world.T)


def _cell(points: Array, edges: Edges, label: str, faces: Faces = ()) -> Image.Image:
    """A drawing (n, 2) or a solid (n, 3), whose faces hide what is behind them, and its label."""
    from PIL import Image, ImageDraw

    plane = points[:, :2]
    low, extent = plane.min(axis=0), np.ptp(plane, axis=0)
    size = max(float(extent.max()), 1e-9)
    inner = CELL - 2 * MARGIN
    at = (MARGIN + inner * (plane - low + (size - extent) / 2) / size - [0, MARGIN / 3]) * FINE
    depth = points[:, 2] / size if points.shape[1] > 2 else np.zeros(len(points))
    nearest = _nearest(at, depth, faces)
    pixels = np.where(np.isfinite(nearest)[..., None], FACE, PAPER).astype(np.uint8)
    image = Image.fromarray(pixels)
    draw = ImageDraw.Draw(image)
    for colour, seen in ((BEHIND, False), (INK, True)):
        for a, b in edges:
            for p, q in _stretches(at[[a, b]], depth[[a, b]], nearest, seen=seen):
                draw.line([*map(float, p), *map(float, q)], fill=colour, width=2 * FINE)
    small = image.resize((CELL, CELL), Image.Resampling.LANCZOS)
    draw, font = ImageDraw.Draw(small), _font()
    left = (CELL - draw.textlength(label, font=font)) / 2
    draw.text((left, CELL - LABEL), label, fill=INK, font=font)
    return small


def _font() -> Any:
    from PIL import ImageFont

    try:
        return ImageFont.load_default(15)
    except TypeError:  # before Pillow 10.1 it has one size
        return ImageFont.load_default()


def _nearest(at: Array, depth: Array, faces: Faces) -> Array:
    """Depth of the nearest face at each pixel, infinite where there is none."""
    from PIL import Image, ImageDraw

    nearest = np.full((CELL * FINE, CELL * FINE), np.inf)
    v, u = np.mgrid[: CELL * FINE, : CELL * FINE]
    for loop in map(list, faces):
        mask = Image.new("1", nearest.shape)
        ImageDraw.Draw(mask).polygon([(float(x), float(y)) for x, y in at[loop]], fill=1)
        corners = np.column_stack([at[loop], np.ones(len(loop))])
        a, b, c = np.linalg.lstsq(corners, depth[loop], rcond=None)[0]
        inside = np.asarray(mask)
        nearest[inside] = np.minimum(nearest, a * u + b * v + c)[inside]
    return nearest


def _stretches(
    at: Array, depth: Array, nearest: Array, *, seen: bool
) -> Iterator[tuple[Array, Array]]:
    """Pieces of an edge that are in front of all faces, or those that are not."""
    t = np.linspace(0, 1, max(2, int(np.linalg.norm(at[1] - at[0]) / FINE)))
    points = at[0] + t[:, None] * (at[1] - at[0])
    middle = (points[1:] + points[:-1]) / 2
    u, v = np.clip(np.round(middle).astype(int), 0, CELL * FINE - 1).T
    z = depth[0] + (t[1:] + t[:-1]) / 2 * (depth[1] - depth[0])
    in_front = z <= nearest[v, u] + NEAR
    for k in np.flatnonzero(in_front == seen):
        yield points[k], points[k + 1]


def _sheet(rows: Sequence[Sequence[Image.Image]]) -> Image.Image:
    from PIL import Image

    sheet = Image.new("RGB", (CELL * len(rows[0]), CELL * len(rows)), PAPER)
    for j, row in enumerate(rows):
        for i, cell in enumerate(row):
            sheet.paste(cell, (i * CELL, j * CELL))
    return sheet
