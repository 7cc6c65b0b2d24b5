"""Lens distortion, told by lines on straight things that bend in the photo.

Terms
-----
bend
    How far the middle of a line is from between its ends, px.
k
    Radial distortion, see `radial`.
to tell
    A line tells the k with which it is straight, and that k's standard error.

The plumb-line method (D. C. Brown, Close-range camera calibration, 1971): that k is sought with
which lines are straight. Lines are those that are drawn, as the photo shows them, and the photo's
own long edges. Some are bent themselves, or found beside: that k counts with which most agree.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..solver.graph import SketchGraph
from ..solver.values import Array
from .long_edges import long_edges
from .plumb_lines import followed
from .radial import MOST_K, Radial

#: How far from the drawn line it is looked for, in parts of the photo's longer side, and px.
_REACH, _LEAST_REACH_PX = 0.012, 4.0
#: The photo's own edges are looked for so near to where they were seen, px.
_OWN_REACH_PX = 3.0
#: Edges as near to another one as this are the same, px.
_SAME_PX = 8.0
#: No thing, and no photo of one, is straighter than this, px.
_CROOKED_PX = 0.25
#: Lines agree within so many standard errors.
_AGREED = 3.0
#: A k that is so many standard errors from 0, and bends a line by so much, is a lens's.
_SIGNIFICANT, _LEAST_BEND_PX = 4.0, 1.0
#: Neighbouring points see the same pixels: about every third tells something new.
_ALIKE = 3.0


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
        How far each drawn line bends that is seen.
    edges_bend_px : float
        How far the photo's own edges bend that agree, at most.
    is_agreed : bool
        Whether most lines that could tell agree, and tell it without any one of them too.
    left_out : tuple of lines
        Those drawn that do not agree: they are bent themselves, or found beside.
    """

    principal_px: Array
    half_diagonal_px: float
    k: float
    sigma: float
    bends_px: Mapping[str, float]
    edges_bend_px: float = 0.0
    is_agreed: bool = True
    left_out: tuple[str, ...] = ()

    @property
    def worst(self) -> tuple[str, float]:
        """The drawn line that bends most, of those that agree where they do, and by how much.

        It has no name where only the photo's own edges bend to be seen.
        """
        told = {
            e: b for e, b in self.bends_px.items() if not self.is_agreed or e not in self.left_out
        }
        name = max(told, key=lambda e: told[e], default="")
        if name and (told[name] > _LEAST_BEND_PX or told[name] >= self.edges_bend_px):
            return name, told[name]
        return "", self.edges_bend_px

    @property
    def distorts(self) -> bool:
        """Whether the lines bend as lenses bend them, by more than chance does."""
        sure = abs(self.k) > _SIGNIFICANT * self.sigma
        return sure and self.is_agreed and self.worst[1] > _LEAST_BEND_PX

    @property
    def notes(self) -> tuple[str, ...]:
        """What a person should know, a sentence each."""
        if not self.distorts:
            return ()
        name, bend_px = self.worst
        lines = f"Lines on straight things bend by up to {bend_px:.1f} px ({name})"
        edges = f"Long edges in the photo bend by up to {bend_px:.1f} px"
        return (
            f"{lines if name else edges}: the lens distorts, by {100 * abs(self.k):.1f} % at the "
            "photo's corners: straighten the photo.",
        )

    def straightened(self, points_px: Array) -> Array:
        """Where points (..., 2) of the photo belong."""
        return self._radial.straightened(points_px, self.k)

    def bent(self, points_px: Array) -> Array:
        """Where points (..., 2) of the straight photo are seen; the inverse of `straightened`."""
        return self._radial.bent(points_px, self.k)

    @property
    def _radial(self) -> Radial:
        return Radial(self.principal_px, self.half_diagonal_px)


@dataclass(frozen=True, slots=True, eq=False)
class PlumbLine:
    """An edge of the photo, and what it tells.

    Parameters
    ----------
    points_px : (n, 2) array
    k : float
    sigma : float
        Infinite where a lens would not bend it.
    bend_px : float
    """

    points_px: Array
    k: float
    sigma: float
    bend_px: float


def lens_of(
    grey: Array,
    lines_px: Mapping[str, tuple[Array, Array]],
    principal_px: Array | None = None,
    edges: Sequence[PlumbLine] | None = None,
) -> Lens | None:
    """The lens, from lines drawn along straight things and the photo's own long edges.

    Parameters
    ----------
    grey : (height, width) array
        The photo's brightness.
    lines_px : mapping of name to two ends
        As drawn; the photo puts them right.
    principal_px : (2,) array, optional
        By default the photo's middle.
    edges : sequence of PlumbLine, optional
        The photo's, where they are known from before.

    Returns
    -------
    Lens or None
        None where no line is to be seen.
    """
    radial = Radial.of(grey, principal_px)
    reach_px = max(_LEAST_REACH_PX, _REACH * max(grey.shape))
    found = {e: _plumb_line(grey, ends, reach_px, radial) for e, ends in lines_px.items()}
    drawn = {e: line for e, line in found.items() if line is not None}
    edges = edges_of(grey, principal_px) if edges is None else edges
    own = [edge for edge in edges if not _is_among(edge, [*drawn.values()])]
    lines = [*drawn.values(), *own]
    if not lines:
        return None
    ks, sigmas = np.array([(line.k, line.sigma) for line in lines]).T
    kept = _agreed(ks, sigmas)
    k, sigma = _joint(ks[kept], sigmas[kept])
    bends = {e: line.bend_px for e, line in drawn.items()}
    most = max(
        (e.bend_px for e, agrees in zip(own, kept[len(drawn) :], strict=True) if agrees),
        default=0.0,
    )
    out = tuple(e for e, agrees in zip(drawn, kept[: len(drawn)], strict=True) if not agrees)
    sure = _is_agreed(ks, sigmas, kept)
    return Lens(radial.principal_px, radial.half_diagonal_px, k, sigma, bends, most, sure, out)


def edges_of(grey: Array, principal_px: Array | None = None) -> tuple[PlumbLine, ...]:
    """The photo's own long edges, wherever a lens would bend them."""
    radial = Radial.of(grey, principal_px)
    found: list[PlumbLine] = []
    for ends in long_edges(grey):
        line = _plumb_line(grey, ends, _OWN_REACH_PX, radial)
        if line is not None and not _is_among(line, found):
            found.append(line)
    return tuple(found)


def _plumb_line(
    grey: Array, ends_px: tuple[Array, Array], reach_px: float, radial: Radial
) -> PlumbLine | None:
    points = followed(grey, *ends_px, reach_px, radial)
    return _told(points, radial) if len(points) else None


def _is_among(line: PlumbLine, lines: Sequence[PlumbLine]) -> bool:
    """Whether it is one of these, or runs beside one."""
    middle = line.points_px[len(line.points_px) // 2]
    near = (np.linalg.norm(other.points_px - middle, axis=1).min() for other in lines)
    return any(px < _SAME_PX for px in near)


def _agreed(ks: Array, sigmas: Array) -> Array:
    """Which lines one k makes straight: the most that any does, of 0 and those that lines tell."""
    usual = np.abs(ks) < MOST_K
    ways = [usual & (np.abs(ks - k) < _AGREED * sigmas) for k in (0.0, *ks)]
    kept = max(ways, key=np.sum)
    for _ in range(3):
        if not kept.any():
            break
        k, _ = _joint(ks[kept], sigmas[kept])
        kept = usual & (np.abs(ks - k) < _AGREED * sigmas)
    return np.asarray(kept)


def _joint(ks: Array, sigmas: Array) -> tuple[float, float]:
    """The k of several lines, and its standard error by what they tell and how they differ."""
    weights = sigmas**-2.0
    if not weights.sum() > 0:
        return 0.0, np.inf
    k = float(weights @ ks / weights.sum())
    differ = float(weights @ (ks - k) ** 2) / max(1, len(ks) - 1)
    return k, float(np.sqrt(max(1.0, differ) / weights.sum()))


def _is_agreed(ks: Array, sigmas: Array, kept: Array) -> bool:
    """Whether most lines that could tell this k from none agree on it, whichever is taken away."""
    k, _ = _joint(ks[kept], sigmas[kept])
    could = _AGREED * sigmas < abs(k)
    if 2 * (kept & could).sum() <= could.sum():
        return False
    which = np.flatnonzero(kept)
    rests = [
        _joint(ks[rest], sigmas[rest]) for rest in (np.delete(which, n) for n in range(len(which)))
    ]
    return all(own * k > 0 and abs(own) > _SIGNIFICANT * sigma for own, sigma in rests)


def _told(points_px: Array, radial: Radial) -> PlumbLine:
    """What an edge tells, by the points on it."""
    k, sigma = _distortion((points_px - radial.principal_px) / radial.half_diagonal_px)
    bow_px = abs(float(radial.bow(points_px[0], points_px[-1], np.array([0.5]))[0]))
    crooked = _CROOKED_PX / bow_px if bow_px > 0 else np.inf
    return PlumbLine(points_px, k, float(np.hypot(sigma, crooked)), _bend(points_px))


def _bend(points: Array) -> float:
    """How far a line bends between its ends, px."""
    middle = points.mean(axis=0)
    along = np.linalg.svd(points - middle, full_matrices=False)[2][0]
    t = (points - middle) @ along
    off = (points - middle) @ [-along[1], along[0]]
    curve = np.polynomial.Polynomial.fit(t, off, 2)
    ends = curve(np.array([t.min(), t.max()])).mean()
    return abs(float(curve((t.min() + t.max()) / 2) - ends))


def _distortion(line: Array) -> tuple[float, float]:
    """k and its standard error, from points on a line in half diagonals about the middle."""
    k, step = 0.0, 1e-4
    normal = _straight(line)[1]
    for _ in range(12):
        r = _crookedness(line, k, normal)
        slope = _crookedness(line, k + step, normal) - _crookedness(line, k - step, normal)
        slope = slope / (2 * step)
        squares = max(float(slope @ slope), 1e-300)
        change = -float(slope @ r) / squares
        k = float(np.clip(k + change, -MOST_K, MOST_K))
        if abs(change) < 1e-9:
            break
    r = _crookedness(line, k, normal)
    spare = max(1.0, len(r) / _ALIKE - 3)
    return k, float(np.sqrt(float(r @ r) / spare / squares))


def _crookedness(line: Array, k: float, like: Array) -> Array:
    """How far all points are from their line, once straightened."""
    moved = Radial(np.zeros(2), 1.0).straightened(line, k)
    middle, normal = _straight(moved)
    return np.asarray((moved - middle) @ (normal * np.sign(normal @ like)))


def _straight(points: Array) -> tuple[Array, Array]:
    """Middle and normal of the line through points."""
    middle = points.mean(axis=0)
    return middle, np.asarray(np.linalg.svd(points - middle, full_matrices=False)[2][1])


def traced_ends(graph: SketchGraph) -> dict[str, tuple[Array, Array]]:
    """The ends of all edges traced on real things, px."""
    edges = [e for e in graph.construction if e in graph.edges]
    places = {v: np.array(p, dtype=float) for v, p in graph.vertices.items()}
    return {e: (places[graph.edges[e][0]], places[graph.edges[e][1]]) for e in edges}
