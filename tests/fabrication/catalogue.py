"""The shapes on which plates, files and prints are checked, with what makes each of them hard."""

from collections.abc import Callable
from dataclasses import dataclass

from incontext.solver.model import Model

from . import shapes, slanted


@dataclass(frozen=True)
class Entry:
    """A shape and its difficulties."""

    make: Callable[..., Model]
    traits: frozenset[str]


def _entry(make: Callable[..., Model], *traits: str) -> Entry:
    return Entry(make, frozenset(traits))


def unequal_box(**options) -> Model:
    thickness = {"bottom": 6, "top": 4, "front": 3, "back": 3, "left": 5, "right": 2}
    return shapes.box(thickness=thickness, **options)


def chevron(**options) -> Model:
    plan = [(0, 0), (60, 40), (120, 0), (130, 70), (60, 100), (0, 60)]
    return shapes.model(shapes.prism(plan, 60), **options)


def leaning_pyramid(**options) -> Model:
    base, tip = [(0, 0, 0), (150, 0, 0), (140, 110, 0), (10, 90, 0)], (60, 40, 95)
    loops = {"bottom": base}
    for n in range(4):
        loops[f"s{n + 1}"] = [base[n], base[(n + 1) % 4], tip]
    return shapes.model(loops, **options)


CATALOGUE = {
    "box": _entry(shapes.box),
    "unequal box": _entry(unequal_box, "unequal"),
    "bookshelf": _entry(shapes.bookshelf, "partition"),
    "organizer": _entry(shapes.organizer_8, "partition"),
    "divided shelf": _entry(shapes.divided_shelf, "partition"),
    "magazine file": _entry(shapes.magazine_file),
    "table tray": _entry(shapes.table_tray, "holes"),
    "l box": _entry(shapes.l_box, "concave"),
    "chevron": _entry(chevron, "concave", "angle"),
    "leaning pyramid": _entry(leaning_pyramid, "angle", "valence 4"),
    "hexagon with shelf": _entry(slanted.hexagon_with_shelf, "angle", "partition"),
    "crossed": _entry(slanted.crossed, "angle", "partition"),
    "leaning, unequal": _entry(slanted.leaning_unequal, "angle", "partition", "unequal"),
    "shelf and divider": _entry(slanted.shelf_and_divider, "angle", "partition"),
}


def having(trait: str) -> list[str]:
    """The names of the shapes with a difficulty."""
    return [name for name, entry in CATALOGUE.items() if trait in entry.traits]
