"""Lens distortion, told by lines on straight things that bend in the photo, and taken out of it.

Terms
-----
bend
    How far the middle of a line is from between its ends, px.
k
    Radial distortion: what is seen at r from the principal point belongs at r (1 + k r^2), r in
    half diagonals of the photo; negative for pincushions, positive for barrels.

The plumb-line method (D. C. Brown, Close-range camera calibration, 1971): that k is sought with
which all lines are straight.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from scipy.ndimage import map_coordinates

from ..solver.graph import Ellipse, SketchGraph
from ..solver.values import Array
from .photo_lines import found_line

#: A line is looked for in so many pieces, at least so long, px.
_PIECES, _LEAST_PIECE_PX = 6, 24.0
#: So many points make a line, and so many lines tell k.
_LEAST_POINTS = 24
#: How far from the drawn line a bent one is looked for, in parts of the photo's longer side.
_REACH = 0.012
#: A k that is so many standard errors from 0, and bends a line by so much, is a lens's.
_SIGNIFICANT, _LEAST_BEND_PX = 4.0, 1.0
#: A line of which more of the bend than this is left by the lens that all tell is bent itself.
_LEFT = 0.3
#: Neighbouring points see the same pixels: about every third tells something new.
_ALIKE = 3.0
#: No usual lens bends more: beyond, the inverse would fold over.
_MOST = 0.3
#: Rows that are straightened at a time.
_STRIP = 256


@dataclass(frozen=True, slots=True, eq=False)
class Lens:
    """What lines in the photo say of its lens.

    Parameters
    ----------
    principal_px : (2,) array
    half_diagonal_px : float
    k : float
    sigma : float
        Its standard error.
    bends_px : mapping of line to px
        How far each line bends.
    is_agreed : bool
        Whether it makes most lines straight, and is told without any one of these too.
    left_out : tuple of lines
        Those that it does not make straight: they are bent themselves, or found beside.
    """

    principal_px: Array
    half_diagonal_px: float
    k: float
    sigma: float
    bends_px: Mapping[str, float]
    is_agreed: bool = True
    left_out: tuple[str, ...] = ()

    @property
    def worst(self) -> str:
        """The line that bends most, of those that tell where they do."""
        told = [line for line in self.bends_px if not (self.is_agreed and line in self.left_out)]
        return max(told, key=lambda line: self.bends_px[line])

    @property
    def distorts(self) -> bool:
        """Whether the lines bend as lenses bend them, by more than chance does."""
        sure = _is_sure(self.k, self.sigma)
        return sure and self.is_agreed and self.bends_px[self.worst] > _LEAST_BEND_PX

    @property
    def notes(self) -> tuple[str, ...]:
        """What a person should know, a sentence each."""
        if not self.distorts:
            return ()
        return (
            f"Lines on straight things bend by up to {self.bends_px[self.worst]:.1f} px "
            f"({self.worst}): the lens distorts, by {100 * abs(self.k):.1f} % at the photo's "
            "corners: straighten the photo.",
        )

    def straightened(self, points_px: Array) -> Array:
        """Where points (..., 2) of the photo belong."""
        return _moved(points_px, self.principal_px, self.half_diagonal_px, self.k)

    def bent(self, points_px: Array) -> Array:
        """Where points (..., 2) of the straight photo are seen; the inverse of `straightened`."""
        off = (np.asarray(points_px, dtype=float) - self.principal_px) / self.half_diagonal_px
        right = np.linalg.norm(off, axis=-1)
        r = right.copy()
        for _ in range(12):
            r = r - (r * (1 + self.k * r**2) - right) / (1 + 3 * self.k * r**2)
        factor = np.where(right > 0, r / np.maximum(right, 1e-300), 1.0)
        return np.asarray(self.principal_px + off * factor[..., None] * self.half_diagonal_px)


def lens_of(
    grey: Array, lines_px: Mapping[str, tuple[Array, Array]], principal_px: Array | None = None
) -> Lens | None:
    """The lens, from lines drawn along straight things.

    Parameters
    ----------
    grey : (height, width) array
        The photo's brightness.
    lines_px : mapping of name to two ends
        As drawn; the photo puts them right.
    principal_px : (2,) array, optional
        By default the photo's middle.

    Returns
    -------
    Lens or None
        None where no line is to be seen.
    """
    height, width = grey.shape
    principal = np.array([width / 2, height / 2]) if principal_px is None else principal_px
    reach_px = max(4.0, _REACH * max(width, height))
    found = {name: _points_on(grey, *ends, reach_px) for name, ends in lines_px.items()}
    seen = {name: points for name, points in found.items() if len(points) >= _LEAST_POINTS}
    if not seen:
        return None
    half = float(np.hypot(width, height)) / 2
    lines = [(p - principal) / half for p in seen.values()]
    bends = {name: _bend(points) for name, points in seen.items()}
    kept = _together_straight(lines, half)
    own = [line for line, is_kept in zip(lines, kept, strict=True) if is_kept]
    k, sigma = _distortion(own or lines)
    agreed = len(own) > len(lines) / 2 and _is_sure(k, sigma) and _is_agreed(own, k, half)
    out = tuple(name for name, is_kept in zip(seen, kept, strict=True) if not is_kept)
    return Lens(np.asarray(principal, dtype=float), half, k, sigma, bends, agreed, out)


def _together_straight(lines: list[Array], half_px: float) -> list[bool]:
    """Which lines one lens makes straight: the most that any does, of those that lines tell."""
    told = [0.0, _distortion(lines)[0], *(_distortion([line])[0] for line in lines)]
    ways = [[_is_straight(line, k, half_px) for line in lines] for k in told]
    kept = max(ways, key=sum)
    for _ in range(3):
        own = [line for line, is_kept in zip(lines, kept, strict=True) if is_kept]
        if not own:
            break
        k = _distortion(own)[0]
        kept = [_is_straight(line, k, half_px) for line in lines]
    return kept


def _is_straight(line: Array, k: float, half_px: float) -> bool:
    before, after = (half_px * _bend(_moved(line, np.zeros(2), 1.0, by)) for by in (0.0, k))
    return after < max(_LEAST_BEND_PX / 2, _LEFT * before)


def _is_sure(k: float, sigma: float) -> bool:
    return abs(k) > _SIGNIFICANT * sigma


def _is_agreed(lines: list[Array], k: float, half_px: float) -> bool:
    """Whether lines bend by the lens: one that found another edge bends by itself."""
    if not all(_is_straight(line, k, half_px) for line in lines):
        return False
    others = [[*lines[:n], *lines[n + 1 :]] for n in range(len(lines))]
    return len(lines) > 1 and all(_says_so(rest, k) for rest in others)


def _says_so(lines: list[Array], k: float) -> bool:
    """Whether some lines tell by themselves that there is a distortion to the same side."""
    own, sigma = _distortion(lines)
    return own * k > 0 and _is_sure(own, sigma)


def _points_on(grey: Array, p: Array, q: Array, reach_px: float) -> Array:
    """Points (n, 2) of the edge near a drawn line, which may bend."""
    p, q = np.asarray(p, dtype=float), np.asarray(q, dtype=float)
    length = float(np.linalg.norm(q - p))
    pieces = int(np.clip(length // _LEAST_PIECE_PX, 1, _PIECES))
    if length < _LEAST_PIECE_PX:
        return np.zeros((0, 2))
    cuts = p + np.outer(np.linspace(0.03, 0.97, pieces + 1), q - p)
    found = [found_line(grey, a, b, reach_px) for a, b in pairwise(cuts)]
    points = np.vstack([np.zeros((0, 2)), *(f.points_px for f in found if f is not None)])
    return _together(points, p, q)


def _together(points: Array, p: Array, q: Array) -> Array:
    """Those points that lie on one smooth curve: a piece may have found another edge."""
    length = float(np.linalg.norm(q - p))
    along = (q - p) / length
    t = (points - p) @ along / length
    off = (points - p) @ [-along[1], along[0]]
    kept = np.ones(len(points), dtype=bool)
    for _ in range(6):
        if kept.sum() < _LEAST_POINTS:
            return np.zeros((0, 2))
        curve = np.polynomial.Polynomial.fit(t[kept], off[kept], 2)
        miss = np.abs(off - curve(t))
        limit = 3 * max(1.4826 * float(np.median(miss[kept])), 0.1)
        fewer = miss <= limit
        if bool((fewer == kept).all()):
            break
        kept = fewer
    # What is left has to reach over most of the line: a short piece shows no bend.
    return points[kept] if np.ptp(t[kept]) > 0.6 else np.zeros((0, 2))


def _bend(points: Array) -> float:
    """How far a line bends between its ends, px."""
    middle = points.mean(axis=0)
    along = np.linalg.svd(points - middle, full_matrices=False)[2][0]
    t = (points - middle) @ along
    off = (points - middle) @ [-along[1], along[0]]
    curve = np.polynomial.Polynomial.fit(t, off, 2)
    ends = curve(np.array([t.min(), t.max()])).mean()
    return abs(float(curve((t.min() + t.max()) / 2) - ends))


def _distortion(lines: list[Array]) -> tuple[float, float]:
    """k and its standard error, from points on lines in half diagonals."""
    k, step = 0.0, 1e-4
    normals = [_straight(points)[1] for points in lines]
    for _ in range(12):
        r = _crookedness(lines, k, normals)
        slope = _crookedness(lines, k + step, normals) - _crookedness(lines, k - step, normals)
        slope = slope / (2 * step)
        squares = max(float(slope @ slope), 1e-300)
        change = -float(slope @ r) / squares
        k = float(np.clip(k + change, -_MOST, _MOST))
        if abs(change) < 1e-9:
            break
    r = _crookedness(lines, k, normals)
    spare = max(1.0, len(r) / _ALIKE - 2 * len(lines) - 1)
    return k, float(np.sqrt(float(r @ r) / spare / squares))


def _crookedness(lines: list[Array], k: float, normals: list[Array]) -> Array:
    """How far all points are from their lines, once straightened."""
    found = []
    for points, like in zip(lines, normals, strict=True):
        moved = _moved(points, np.zeros(2), 1.0, k)
        middle, normal = _straight(moved)
        found.append((moved - middle) @ (normal * np.sign(normal @ like)))
    return np.concatenate(found)


def _straight(points: Array) -> tuple[Array, Array]:
    """Middle and normal of the line through points."""
    middle = points.mean(axis=0)
    return middle, np.asarray(np.linalg.svd(points - middle, full_matrices=False)[2][1])


def _moved(points: Array, principal: Array, half: float, k: float) -> Array:
    off = (np.asarray(points, dtype=float) - principal) / half
    r2 = np.sum(off**2, axis=-1, keepdims=True)
    return np.asarray(principal + off * (1 + k * r2) * half)


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


def traced_ends(graph: SketchGraph) -> dict[str, tuple[Array, Array]]:
    """The ends of all edges traced on real things, px."""
    edges = [e for e in graph.construction if e in graph.edges]
    places = {v: np.array(p, dtype=float) for v, p in graph.vertices.items()}
    return {e: (places[graph.edges[e][0]], places[graph.edges[e][1]]) for e in edges}
