"""Shapes of random sizes: the families of `shapes`, so that figures speak of no single one."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np

from .shapes import (
    Shape,
    bookshelf,
    box,
    compartments,
    hexagonal_box,
    house,
    l_shape,
    staircase,
    table,
    tapered_tray,
    wedge,
)
from .turned import Turned

Draw = Callable[[np.random.Generator], Shape]


def _cube(rng: np.random.Generator) -> Shape:
    a = rng.uniform(40, 300)
    return box(a, a, a, "cube")


def _box(rng: np.random.Generator) -> Shape:
    return box(*rng.uniform(80, 240, 3))


def _l(rng: np.random.Generator) -> Shape:
    w, h, d = rng.uniform(120, 250, 3)
    return l_shape(w, h, rng.uniform(0.25, 0.6) * h, rng.uniform(0.25, 0.6) * w, d)


def _bookshelf(rng: np.random.Generator) -> Shape:
    w, d, h = rng.uniform(150, 350), rng.uniform(120, 250), rng.uniform(180, 400)
    return bookshelf(w, d, h, rng.uniform(0.35, 0.8) * h)


def _organizer_6(rng: np.random.Generator) -> Shape:
    return compartments(rng.uniform(45, 95, 3), rng.uniform(45, 95, 2), rng.uniform(50, 130))


def _organizer_24(rng: np.random.Generator) -> Shape:
    return compartments(rng.uniform(35, 75, 6), rng.uniform(35, 75, 4), rng.uniform(40, 130))


def _table(rng: np.random.Generator) -> Shape:
    w, d, h = rng.uniform(400, 800), rng.uniform(300, 600), rng.uniform(200, 450)
    return table(w, d, h, rng.uniform(25, 60), rng.uniform(0.15, 0.6) * h)


def _wedge(rng: np.random.Generator) -> Shape:
    return wedge(rng.uniform(100, 220), rng.uniform(60, 160), rng.uniform(80, 200))


def _hexagonal_box(rng: np.random.Generator) -> Shape:
    return hexagonal_box(rng.uniform(60, 120), rng.uniform(60, 200))


def _house(rng: np.random.Generator) -> Shape:
    w, d, wall = rng.uniform(100, 220), rng.uniform(100, 260), rng.uniform(70, 160)
    return house(w, d, wall, wall + rng.uniform(0.25, 0.7) * w)


def _staircase(rng: np.random.Generator) -> Shape:
    steps = int(rng.integers(2, 6))
    return staircase(steps, rng.uniform(35, 70), rng.uniform(25, 60), rng.uniform(80, 220))


def _tapered_tray(rng: np.random.Generator) -> Shape:
    w, d, h = rng.uniform(100, 260), rng.uniform(80, 200), rng.uniform(40, 120)
    return tapered_tray(w, d, h, rng.uniform(0.2, 0.7) * h, rng.uniform(0.2, 0.7) * h)


#: The families of straight-edged shapes, by name.
FAMILIES: Mapping[str, Draw] = MappingProxyType(
    {
        "cube": _cube,
        "box": _box,
        "L": _l,
        "bookshelf": _bookshelf,
        "organizer 6": _organizer_6,
        "organizer 24": _organizer_24,
        "table": _table,
        "wedge": _wedge,
        "hexagonal box": _hexagonal_box,
        "house": _house,
        "staircase": _staircase,
        "tapered tray": _tapered_tray,
    }
)


def random_lid(rng: np.random.Generator) -> Turned:
    """A lid: a wide ground circle, and a narrower bottom and top circle above it."""
    ground = rng.uniform(50, 90)
    bottom, top = ground * rng.uniform(0.5, 0.9), ground * rng.uniform(0.15, 0.45)
    low = rng.uniform(0.6, 1.6) * ground
    high = low + rng.uniform(0.3, 0.8) * ground
    between = (rng.uniform(top, bottom), rng.uniform(low, high))
    circles = ((ground, 0.0), (bottom, low), (top, high))
    return Turned("lid", circles, ((bottom, low), between, (top, high)))
