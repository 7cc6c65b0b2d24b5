"""Pictures like Figures 8 and 9 of [Lau10]: the same inputs, the methods side by side."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...solver import solve
from ...solver.reference import METHODS, Limits
from ...solver.synthetic import Photograph, bookshelf, box, l_shape, photograph, table
from ...solver.values import Array

if TYPE_CHECKING:
    from PIL import Image

CELL, MARGIN, LABEL = 360, 40, 24
INK, PAPER = (20, 40, 90), (255, 255, 255)
#: The result is shown turned so far from the photo's direction, degrees, to show its depth.
TURNED_DEG = 35.0
LIMITS = Limits(evaluations_per_dimension=200)

Edges = Sequence[tuple[int, int]]


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
    return _cell(_from_the_side(X, photo), photo.shape.edges, f"{name}: error {percent:.2g} %")


def _from_the_side(X: Array, photo: Photograph) -> Array:
    """Orthographic image of the result, brought to the truth's frame and turned about z."""
    X = X - X.mean(axis=0)
    truth = photo.shape.X - photo.shape.X.mean(axis=0)
    U, _, Vt = np.linalg.svd(X.T @ truth)
    X = X @ (U @ np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))]) @ Vt)
    c, s = np.cos(np.radians(TURNED_DEG)), np.sin(np.radians(TURNED_DEG))
    about_z = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    return np.asarray((X @ about_z.T @ photo.camera.rotation_cam_from_world.T)[:, :2])


def _cell(points: Array, edges: Edges, label: str) -> Image.Image:
    from PIL import Image, ImageDraw

    fine = 3  # drawn larger and scaled down, for smooth lines
    low, size = points.min(axis=0), max(float(np.ptp(points, axis=0).max()), 1e-9)
    inner = CELL - 2 * MARGIN
    middle = (size - np.ptp(points, axis=0)) / 2
    at = (MARGIN + inner * (points - low + middle) / size) * fine
    image = Image.new("RGB", (CELL * fine, CELL * fine), PAPER)
    draw = ImageDraw.Draw(image)
    for a, b in edges:
        draw.line([*map(float, at[a]), *map(float, at[b])], fill=INK, width=2 * fine)
    image = image.resize((CELL, CELL), Image.Resampling.LANCZOS)
    ImageDraw.Draw(image).text((MARGIN / 2, CELL - LABEL), label, fill=INK)
    return image


def _sheet(rows: Sequence[Sequence[Image.Image]]) -> Image.Image:
    from PIL import Image

    sheet = Image.new("RGB", (CELL * len(rows[0]), CELL * len(rows)), PAPER)
    for j, row in enumerate(rows):
        for i, cell in enumerate(row):
            sheet.paste(cell, (i * CELL, j * CELL))
    return sheet
