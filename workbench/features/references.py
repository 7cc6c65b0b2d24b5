"""What is built on an edge or face of a plate stays on it when its shape is counted anew.

FreeCAD knows edges by their numbers. Where a size changes, a plate may get more or fewer fingers,
and its later edges, and those of the plates after it, get other numbers. Each thing that others
are built on is looked for in the new shape, and written to them by its new number.

Terms
-----
element
    An edge, face or vertex.
sides
    The directions in which the faces around an element look: what tells a finger's left flank
    from its right one.
anchored
    Measured from the border, or the middle, of the plate that is nearest: a finger at the right
    end stays there when the plate gets longer.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import Any

import FreeCAD

from .. import host

_NUMBERED = re.compile(r"(?<![A-Za-z])(Edge|Face|Vertex)(\d+)$")
_LISTS = {"Edge": "Edges", "Face": "Faces", "Vertex": "Vertexes"}
_LINKS = re.compile(r"App::PropertyX?LinkSub(List)?(Child|Global|Hidden)?$")
_FILLETS = "Part::PropertyFilletEdges"
#: Faces look in one direction where the cosine is over this.
_ALIKE = 0.999
_DIGITS = 4

#: The new number of an element by its kind and old number; None where it is gone.
Renumber = Callable[[str, int], int | None]
Point = tuple[float, float, float]


@dataclass(frozen=True)
class _Element:
    low: Point
    high: Point
    sides: frozenset[Point]


class _Plate:
    """The elements of one plate's solid, in the plate's own frame."""

    def __init__(self, solid: Any) -> None:
        self.counts = {kind: len(getattr(solid, name)) for kind, name in _LISTS.items()}
        self._solid = solid

    @cached_property
    def _local(self) -> Any:
        solid = self._solid.copy()
        solid.Placement = FreeCAD.Placement()
        return solid

    @cached_property
    def size(self) -> Point:
        """Of the plate, mm."""
        _, high = _ends(self._local.Vertexes)
        return high

    @cached_property
    def _sides(self) -> dict[tuple[Point, Point], set[Point]]:
        """The directions of the faces around edges and vertices, by where these are."""
        found: dict[tuple[Point, Point], set[Point]] = {}
        for face in self._local.Faces:
            direction = _rounded(face.normalAt(0, 0))
            for part in (*face.Edges, *face.Vertexes):
                found.setdefault(_ends(part.Vertexes), set()).add(direction)
        return found

    def elements(self, kind: str) -> list[_Element]:
        """All of a kind, in the order of their numbers."""
        found = []
        for shape in getattr(self._local, _LISTS[kind]):
            low, high = _ends(shape.Vertexes)
            sides = {_rounded(shape.normalAt(0, 0))} if kind == "Face" else self._sides[low, high]
            found.append(_Element(low, high, frozenset(sides)))
        return found

    def number_in(self, other: _Plate, kind: str, number: int) -> int | None:
        """The number, from 0, that an element has in this plate after a change."""
        if self.counts[kind] == other.counts[kind]:
            return number
        old = self.elements(kind)[number]
        offsets = [
            (self._off(old, new, other.size), k)
            for k, new in enumerate(other.elements(kind))
            if _look_alike(old.sides, new.sides)
        ]
        return min(offsets)[1] if offsets else None

    def _off(self, old: _Element, new: _Element, new_size: Point) -> float:
        """How far two elements are from each other, each measured from where it is anchored."""
        total = 0.0
        for was, now in ((old.low, new.low), (old.high, new.high)):
            for x, y, size, other in zip(was, now, self.size, new_size, strict=True):
                third = min(2, int(3 * x / size)) if size else 0
                total += abs((x - third * size / 2) - (y - third * other / 2))
        return total


def _ends(vertexes: Iterable[Any]) -> tuple[Point, Point]:
    points = [_rounded(vertex.Point) for vertex in vertexes]
    return _corner(min, points), _corner(max, points)


def _corner(which: Callable[[Iterable[float]], float], points: list[Point]) -> Point:
    x, y, z = (which(axis) for axis in zip(*points, strict=True))
    return x, y, z


def _rounded(vector: Any) -> Point:
    x, y, z = (round(value, _DIGITS) + 0.0 for value in vector)
    return x, y, z


def _look_alike(one: frozenset[Point], two: frozenset[Point]) -> bool:
    return len(one) == len(two) and all(
        any(sum(x * y for x, y in zip(a, b, strict=True)) > _ALIKE for b in two) for a in one
    )


def renumbering(
    before: Any, after: Any, ids_before: Sequence[str], ids_after: Sequence[str]
) -> Renumber | None:
    """How the elements of a compound of plates are counted anew.

    Parameters
    ----------
    before, after : FreeCAD shapes
        One solid a plate.
    ids_before, ids_after : sequence of str
        The plates' ids in the order of the solids.

    Returns
    -------
    callable or None
        None where all numbers stay.
    """
    old, new = ([_Plate(solid) for solid in shape.Solids] for shape in (before, after))
    if len(old) != len(ids_before) or len(new) != len(ids_after):
        # Of an older version, which did not know whose they are.
        ids_before = ids_after = range(len(old)) if len(old) == len(new) else ()
    same_plates = list(ids_before) == list(ids_after)
    if not ids_before or (same_plates and [p.counts for p in old] == [p.counts for p in new]):
        return None
    places = {id_: k for k, id_ in enumerate(ids_after)}

    def renumber(kind: str, number: int) -> int | None:
        ends = list(accumulate(plate.counts[kind] for plate in old))
        k = bisect_left(ends, number)
        if k == len(old) or ids_before[k] not in places:
            return None
        place = places[ids_before[k]]
        found = old[k].number_in(new[place], kind, number - 1 - (ends[k] - old[k].counts[kind]))
        ahead = sum(plate.counts[kind] for plate in new[:place])
        return None if found is None else 1 + ahead + found

    return renumber


#: What to write where: a document object, a property, its new value.
Writing = tuple[Any, str, Any]


def new_references(obj: Any, renumber: Renumber) -> list[Writing]:
    """What everything that is built on elements of a document object must name from now on.

    Parameters
    ----------
    obj : FreeCAD document object
        With its old shape: FreeCAD 1.0 and later change the names as soon as it has a new one, and
        know nothing of fingers.
    renumber : callable
    """
    found: list[Writing] = []
    for other in set(obj.InList):
        lost = False
        for name in other.PropertiesList:
            kind = other.getTypeIdOfProperty(name)
            if kind == _FILLETS and getattr(other, "Base", None) == obj:
                value, gone = _fillets(getattr(other, name), renumber)
            elif _LINKS.match(kind):
                value, gone = _links(getattr(other, name), obj, renumber)
            else:
                continue
            lost |= gone
            if value is not None:
                found.append((other, name, value))
        if lost:
            words = host.translate(
                "InContext",
                "{0}: an edge or face of {1} that it was built on is gone: choose another",
            )
            host.warn(words.format(other.Label, obj.Label))
    return found


def _fillets(edges: list[Any], renumber: Renumber) -> tuple[Any, bool]:
    """The edges of a fillet or chamfer, None where none is left; whether one is gone."""
    found = {renumber("Edge", number): sizes for number, *sizes in edges}
    lost = found.pop(None, None) is not None
    return [(number, *sizes) for number, sizes in found.items()] or None, lost


def _links(value: Any, obj: Any, renumber: Renumber) -> tuple[Any, bool]:
    """Links to elements, None where they are to other objects; whether one is gone."""
    pairs = value if isinstance(value, list) else [value] if value else []
    if all(linked != obj for linked, _ in pairs):
        return None, False
    lost, new = False, []
    for linked, subs in pairs:
        names = (subs,) if isinstance(subs, str) else tuple(subs)
        if linked == obj:
            now = [renamed(name, renumber) for name in names]
            lost |= None in now
            # Nothing at all would be the whole object.
            names = tuple(dict.fromkeys(name for name in now if name is not None)) or names
        new.append((linked, names))
    return new if isinstance(value, list) else new[0], lost


def renamed(name: str, renumber: Renumber) -> str | None:
    """A name such as ``Edge12`` by its new number; all else stays; None where it is gone."""
    found = _NUMBERED.search(name)
    if found is None:
        return name
    number = renumber(found[1], int(found[2]))
    return None if number is None else f"{name[: found.start()]}{found[1]}{number}"


def show_plates(obj: Any, shape: Any, ids: Sequence[str]) -> None:
    """Give a document object its new plates; what is built on them follows."""
    before, writings = obj.Shape, []
    if obj.InList and not before.isNull():
        renumber = renumbering(before, shape, obj.PlateIds, ids)
        writings = [] if renumber is None else new_references(obj, renumber)
    obj.Shape = shape
    if tuple(obj.PlateIds) != tuple(ids):
        obj.PlateIds = list(ids)
    for other, name, value in writings:
        setattr(other, name, value)
