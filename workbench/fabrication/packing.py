"""Rectangles packed into bins: maximal free rectangles, best short side first.

Source: J. Jylänki, A Thousand Ways to Pack the Bin (2010), MAXRECTS-BSSF. Several orders are
tried and the one with the fewest bins (then the emptiest last one) is kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

Rect = tuple[float, float, float, float]  # x, y, width, height
_EPS = 1e-9


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
    return min(results, key=lambda places: _waste(places, sizes))


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
