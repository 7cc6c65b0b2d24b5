"""Rectangles packed into bins: maximal free rectangles, best short side first.

Several orders are tried and the one with the fewest bins (then the emptiest last one) is kept.
Where the area alone would need fewer bins, the emptiest one and some others are packed anew, again
and again in other orders: what is no worse is kept.

Sources: J. Jylänki, A Thousand Ways to Pack the Bin (2010), MAXRECTS-BSSF; G. Schrimpf et al.,
Record breaking optimization results using the ruin and recreate principle (2000).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

Rect = tuple[float, float, float, float]  # x, y, width, height
_EPS = 1e-9
#: How often bins are packed anew; three times as often saves one more bin of seventy.
_TRIES = 200
#: How many full bins go with the emptiest one, at most.
_MOST_FULL = 3
#: How far an order strays from the largest first: the standard deviation of the size's logarithm.
_STRAY = 0.4


@dataclass(frozen=True, slots=True)
class Place:
    """Where a rectangle lies: its bin, its lower left corner, and whether it is turned."""

    sheet: int
    x: float
    y: float
    turned: bool


def pack(
    sizes: Sequence[tuple[float, float]], room: tuple[float, float], *, turnable: bool = True
) -> list[Place]:
    """Places for rectangles, each of which fits into a bin on its own.

    Parameters
    ----------
    sizes : sequence of (width, height)
    room : (width, height)
        Of a bin.
    turnable : bool
        False where rectangles must lie as they are (grain).

    Returns
    -------
    list of Place
        In the order of `sizes`.
    """
    keys = (
        lambda n: (-sizes[n][0] * sizes[n][1], n),
        lambda n: (-max(sizes[n]), n),
        lambda n: (-min(sizes[n]), n),
        lambda n: (-sizes[n][0] - sizes[n][1], n),
    )
    turns = (False, True) if turnable else (False,)
    results = [_packed(sizes, sorted(range(len(sizes)), key=key), room, turns) for key in keys]
    best = min(results, key=lambda places: _waste(places, sizes))
    return _refined(best, sizes, room, turns)


def _refined(
    places: list[Place],
    sizes: Sequence[tuple[float, float]],
    room: tuple[float, float],
    turns: Sequence[bool],
) -> list[Place]:
    """Places in fewer bins, where some bins packed anew leave one out."""
    areas = np.array([width * height for width, height in sizes])
    needed = math.ceil(float(areas.sum()) / (room[0] * room[1]) - _EPS)
    rng = np.random.default_rng(0)
    for _ in range(_TRIES):
        filled = np.bincount([place.sheet for place in places], areas)
        if len(filled) <= needed:
            break
        emptiest, *others = np.argsort(filled).tolist()
        count = min(len(others), int(rng.integers(1, _MOST_FULL + 1)))
        opened = [emptiest, *rng.choice(others, count, replace=False).tolist()]
        taken = [n for n, place in enumerate(places) if place.sheet in opened]
        order = np.argsort(-areas[taken] * np.exp(_STRAY * rng.normal(size=len(taken)))).tolist()
        anew = _packed([sizes[n] for n in taken], order, room, turns)
        if max(place.sheet for place in anew) >= len(opened):
            continue
        changed = list(places)
        for n, place in zip(taken, anew, strict=True):
            changed[n] = replace(place, sheet=opened[place.sheet])
        after = np.bincount([place.sheet for place in changed], areas)
        fullest = np.argsort(-after, kind="stable").tolist()
        changed = [replace(place, sheet=fullest.index(place.sheet)) for place in changed]
        after = np.sort(after[after > 0])[::-1]
        if (len(after), after.min()) <= (len(filled), filled.min()):
            places = changed
    return places


def _waste(places: Sequence[Place], sizes: Sequence[tuple[float, float]]) -> tuple[int, float]:
    last = max(place.sheet for place in places)
    used = [
        place.y + (size[0] if place.turned else size[1])
        for place, size in zip(places, sizes, strict=True)
        if place.sheet == last
    ]
    return last, max(used)


def _packed(
    sizes: Sequence[tuple[float, float]],
    order: Sequence[int],
    room: tuple[float, float],
    turns: Sequence[bool],
) -> list[Place]:
    places: dict[int, Place] = {}
    bins: list[list[Rect]] = []
    for n in order:
        best = _best(bins, sizes[n], turns)
        if best is None:
            bins.append([(0.0, 0.0, room[0] + _EPS, room[1] + _EPS)])
            best = _best(bins, sizes[n], turns)
        if best is None:
            raise ValueError(f"rectangle {n} of {sizes[n]} does not fit into {room}")
        places[n] = best
        width, height = sizes[n][::-1] if best.turned else sizes[n]
        bins[best.sheet] = _without(bins[best.sheet], (best.x, best.y, width, height))
    return [places[n] for n in range(len(sizes))]


def _best(
    bins: Sequence[Sequence[Rect]], size: tuple[float, float], turns: Sequence[bool]
) -> Place | None:
    """The tightest place in the first bin that has one."""
    for number, free in enumerate(bins):
        found = []
        for x, y, width, height in free:
            for turned in turns:
                w, h = size[::-1] if turned else size
                spare = sorted((width - w, height - h))
                if spare[0] >= -_EPS:
                    found.append((round(spare[0], 6), round(spare[1], 6), y, x, turned))
        if found:
            *_, y, x, turned = min(found)
            return Place(number, x, y, turned)
    return None


def _without(free: Sequence[Rect], used: Rect) -> list[Rect]:
    """The maximal free rectangles after one more place is used."""
    x, y, width, height = used
    result: list[Rect] = []
    for fx, fy, fw, fh in free:
        right, top = fx + fw, fy + fh
        apart_x = x >= right - _EPS or x + width <= fx + _EPS
        if apart_x or y >= top - _EPS or y + height <= fy + _EPS:
            result.append((fx, fy, fw, fh))
            continue
        result += [
            (fx, fy, x - fx, fh),
            (x + width, fy, right - x - width, fh),
            (fx, fy, fw, y - fy),
            (fx, y + height, fw, top - y - height),
        ]
    result = sorted({rect for rect in result if rect[2] > _EPS and rect[3] > _EPS})
    return [a for a in result if not any(_holds(b, a) for b in result if b != a)]


def _holds(outer: Rect, inner: Rect) -> bool:
    return (
        outer[0] <= inner[0] + _EPS
        and outer[1] <= inner[1] + _EPS
        and outer[0] + outer[2] >= inner[0] + inner[2] - _EPS
        and outer[1] + outer[3] >= inner[1] + inner[3] - _EPS
    )
