"""Shapes put together by cutting space with planes, each from a seed: for the hunt.

Every body is a convex cell or cells, given as half-spaces; faces come from clipping large squares.
"""

from __future__ import annotations

import numpy as np

Loops = dict[str, list[tuple[float, float, float]]]
Spaces = list[tuple[np.ndarray, float]]


def clipped(normal: np.ndarray, limit: float, spaces: Spaces) -> np.ndarray:
    """What of a plane ``normal @ x = limit`` lies in half-spaces ``n @ x <= d``."""
    helper = np.eye(3)[int(np.abs(normal).argmin())]
    u = np.cross(helper, normal) / np.linalg.norm(np.cross(helper, normal))
    v = np.cross(normal, u)
    ring = [limit * normal + 1e4 * (a * u + b * v) for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    for other, most in spaces:
        heights = [float(other @ p) - most for p in ring]
        kept = []
        for k, p in enumerate(ring):
            before, high, low = ring[k - 1], heights[k], heights[k - 1]
            if (high > 0) != (low > 0):
                kept.append(before + (p - before) * low / (low - high))
            if high <= 0:
                kept.append(p)
        ring = kept
    apart = [p for k, p in enumerate(ring) if np.linalg.norm(p - ring[k - 1]) > 1e-6]
    return np.array(apart).reshape(-1, 3)


def cell(spaces: Spaces) -> Loops:
    """The faces of a convex cell."""
    loops: Loops = {}
    for n, (normal, limit) in enumerate(spaces):
        ring = clipped(normal, limit, spaces[:n] + spaces[n + 1 :])
        if len(ring) > 2:
            loops[f"c{n}"] = [(x, y, z) for x, y, z in np.round(ring, 9).tolist()]
    return loops


def _upright(turn: float, limit: float) -> tuple[np.ndarray, float]:
    return np.array([np.cos(turn), np.sin(turn), 0.0]), limit


def _floor_and_lid(height: float) -> Spaces:
    return [(np.array([0.0, 0.0, -1.0]), 0.0), (np.array([0.0, 0.0, 1.0]), height)]


def halved(rng: np.random.Generator) -> tuple[Loops, dict]:
    """A convex cell with partitions that lean any way."""
    count = int(rng.integers(4, 7))
    turns = 2 * np.pi * (np.arange(count) + rng.uniform(-0.2, 0.2, count)) / count
    spaces = [_upright(turn, float(rng.uniform(55, 100))) for turn in turns]
    leans = rng.uniform(-0.3, 0.3, count)
    spaces = [
        (np.array([*(n[:2] * np.cos(a)), np.sin(a)]), d)
        for (n, d), a in zip(spaces, leans, strict=True)
    ]
    spaces += _floor_and_lid(float(rng.uniform(50, 110)))
    loops = cell(spaces)
    for k in range(int(rng.integers(1, 3))):
        way = rng.normal(size=3) * [1.0, 1.0, 0.4]
        way /= np.linalg.norm(way)
        ring = clipped(way, float(way @ [0.0, 0.0, 40.0] + rng.uniform(-15, 15)), spaces)
        if len(ring) > 2 and k == 0:
            loops["cut"] = [(x, y, z) for x, y, z in ring.tolist()]
    return loops, {}


def plus(rng: np.random.Generator) -> tuple[Loops, dict]:
    """Over a plus sign, four arms of four lengths, a hole in one end and in the top."""
    w, h = float(rng.uniform(45, 60)), float(rng.uniform(40, 90))
    a, b, c, d = (w / 2 + float(rng.uniform(35, 80)) for _ in range(4))
    g = w / 2
    plan = [
        (g, -b), (g, -g), (a, -g), (a, g), (g, g), (g, d), (-g, d), (-g, g), (-c, g), (-c, -g),
        (-g, -g), (-g, -b),
    ]  # fmt: skip
    loops: Loops = {
        "bottom": [(x, y, 0.0) for x, y in plan],
        "top": [(x, y, h) for x, y in plan],
    }
    for n, (x, y) in enumerate(plan):
        u, v = plan[(n + 1) % len(plan)]
        loops[f"w{n}"] = [(x, y, 0.0), (u, v, 0.0), (u, v, h), (x, y, h)]
    hole = [(-8.0, -7.0, h), (9.0, -7.0, h), (9.0, 8.0, h), (-8.0, 8.0, h)]
    return loops, {"holes": {"top": [hole]}}


def fan(rng: np.random.Generator) -> tuple[Loops, dict]:
    """Three to five upright partitions that meet in one line, in a prism around it."""
    count, h = int(rng.integers(3, 6)), float(rng.uniform(40, 100))
    turns = 2 * np.pi * (np.arange(count) + rng.uniform(-0.15, 0.15, count)) / count
    corners = [(float(rng.uniform(70, 120)) * np.array([np.cos(t), np.sin(t)])) for t in turns]
    plan = [(float(x), float(y)) for x, y in corners]
    loops: Loops = {
        "bottom": [(x, y, 0.0) for x, y in plan],
        "top": [(x, y, h) for x, y in plan],
    }
    for n, (x, y) in enumerate(plan):
        u, v = plan[(n + 1) % count]
        loops[f"w{n}"] = [(x, y, 0.0), (u, v, 0.0), (u, v, h), (x, y, h)]
        at = float(rng.uniform(0.3, 0.7))
        p, q = x + at * (u - x), y + at * (v - y)
        loops[f"fan{n}"] = [(0.0, 0.0, 0.0), (p, q, 0.0), (p, q, h), (0.0, 0.0, h)]
    return loops, {}


def pencil(rng: np.random.Generator) -> tuple[Loops, dict]:
    """A prism with a tip off its middle: five to seven faces meet there."""
    count = int(rng.integers(5, 8))
    turns = 2 * np.pi * (np.arange(count) + rng.uniform(-0.2, 0.2, count)) / count
    plan = [(float(x), float(y)) for x, y in 90 * np.column_stack([np.cos(turns), np.sin(turns)])]
    h = float(rng.uniform(30, 80))
    tip = (*rng.uniform(-25, 25, 2).tolist(), h + float(rng.uniform(35, 110)))
    loops: Loops = {"bottom": [(x, y, 0.0) for x, y in plan]}
    for n, (x, y) in enumerate(plan):
        u, v = plan[(n + 1) % count]
        loops[f"w{n}"] = [(x, y, 0.0), (u, v, 0.0), (u, v, h), (x, y, h)]
        loops[f"t{n}"] = [(x, y, h), (u, v, h), tip]
    return loops, {}
