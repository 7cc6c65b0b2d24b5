"""A photo, and the sketch over it, without the lens's distortion."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.ndimage import map_coordinates

from ..solver.graph import Ellipse, SketchGraph
from ..solver.values import Array
from .lens import Lens

#: Rows that are straightened at a time.
_STRIP = 256


def straight_picture(picture: Array, lens: Lens) -> Array:
    """A photo without its lens's distortion, of the same size.

    Parameters
    ----------
    picture : (height, width, ...) array of uint8
    lens : Lens

    Returns
    -------
    array of the same shape and kind
    """
    height, width = picture.shape[:2]
    layers = picture.reshape(height, width, -1)
    straight = np.empty_like(layers)
    # In strips: the places of all px at once would fill the memory.
    for top in range(0, height, _STRIP):
        rows = np.arange(top, min(top + _STRIP, height))
        u, v = np.meshgrid(np.arange(width) + 0.5, rows + 0.5)
        seen = lens.bent(np.stack([u, v], axis=-1)) - 0.5
        at = np.array([seen[..., 1], seen[..., 0]])
        for c in range(layers.shape[2]):
            moved = map_coordinates(layers[..., c], at, order=1, mode="nearest", output=float)
            straight[rows, :, c] = np.clip(np.rint(moved), 0, 255)
    return straight.reshape(picture.shape)


def straightened_sketch(graph: SketchGraph, lens: Lens, file: str | None) -> SketchGraph:
    """The sketch over the straightened photo.

    A known camera was that of the bent one, and is forgotten.

    Parameters
    ----------
    graph : SketchGraph
    lens : Lens
    file : str or None
        The straightened photo's name.
    """
    moved = lens.straightened(np.array([*graph.vertices.values()], dtype=float).reshape(-1, 2))
    photo = graph.photo
    return replace(
        graph,
        photo=None if photo is None else replace(photo, file=file),
        vertices=dict(zip(graph.vertices, map(tuple, moved.tolist()), strict=True)),
        circles={c: _straightened_ellipse(e, lens) for c, e in graph.circles.items()},
        camera=None,
    )


def _straightened_ellipse(ellipse: Ellipse, lens: Lens) -> Ellipse:
    a, b = (lens.straightened(np.array(axis)) for axis in (ellipse.a, ellipse.b))
    # Its two axes go on having one middle.
    b = b - b.mean(axis=0) + a.mean(axis=0)
    (a0, a1), (b0, b1) = ([(float(u), float(v)) for u, v in axis.tolist()] for axis in (a, b))
    return Ellipse((a0, a1), (b0, b1))
