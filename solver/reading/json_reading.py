"""Reading JSON values with errors that name the place.

Terms
-----
place
    Where a value stands, as a person would say it: ``vertices.v1``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

from ..errors import SketchFormatError, SketchVersionError

#: Positions and lengths beyond this are no drawing.
MAX_NUMBER = 1e6
#: Larger ones are not even written down.
MAX_WRITTEN = 1e300
MAX_ID_LENGTH = 40

T = TypeVar("T")


def an_object(value: Any, place: str) -> dict[str, Any]:
    """A JSON object."""
    if not isinstance(value, dict):
        raise SketchFormatError(f"{place} is {_name(value)}, not an object", (), "{...}")
    return value


def a_list(value: Any, place: str, at_least: int = 0, at_most: int | None = None) -> list[Any]:
    """A JSON list of a given size."""
    if not isinstance(value, list):
        raise SketchFormatError(f"{place} is {_name(value)}, not a list", (), "[...]")
    if len(value) < at_least or (at_most is not None and len(value) > at_most):
        wanted = str(at_least) if at_most == at_least else f"at least {at_least}"
        raise SketchFormatError(f"{place} has {len(value)} entries", (), f"{wanted} entries")
    return value


def a_number(
    value: Any, place: str, *, above: float = -math.inf, limit: float = MAX_NUMBER
) -> float:
    """A finite JSON number, above `above`, of a size that a drawing can have."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise SketchFormatError(f"{place} is {_name(value)}, not a number", (), "a number")
    # Integers of hundreds of digits are no floats, not even to be written.
    if isinstance(value, float) and not math.isfinite(value):
        raise SketchFormatError(f"{place} is not finite", (), "a finite number")
    if abs(value) > limit:
        size = f"{value:.3g}" if abs(value) < MAX_WRITTEN else "beyond all measure"
        raise SketchFormatError(f"{place} is {size}, too large", (), f"a number up to {limit:.0e}")
    if not value > above:
        raise SketchFormatError(f"{place} cannot be {value:g}", (), f"a number above {above:g}")
    return float(value)


def a_point(value: Any, place: str) -> tuple[float, float]:
    """A photo position [u, v]."""
    u, v = a_list(value, place, 2, 2)
    return (a_number(u, place), a_number(v, place))


def an_id(value: Any, place: str) -> str:
    """A short id: printable, no white space, no ``@`` (mirrored copies use it)."""
    if not isinstance(value, str):
        raise SketchFormatError(f"{place} is {_name(value)}, not an id", (), 'a short text, "v1"')
    if not 0 < len(value) <= MAX_ID_LENGTH:
        raise SketchFormatError(
            f"{place}: an id has 1 to {MAX_ID_LENGTH} characters", (value[:12],), "a short id"
        )
    # Of all white space only the plain space counts as printable.
    if "@" in value or " " in value or not value.isprintable():
        raise SketchFormatError(
            f"{place}: an id has no spaces, control characters or '@'", (value,), "letters, digits"
        )
    return value


def a_copy_id(value: Any, place: str) -> str:
    """An id, or that of a mirrored copy: ids with ``@`` between them."""
    if not isinstance(value, str):
        return an_id(value, place)
    return "@".join(an_id(part, place) for part in value.split("@"))


def ids(
    value: Any,
    place: str,
    at_least: int = 0,
    at_most: int | None = None,
    one: Callable[[Any, str], str] = an_id,
) -> tuple[str, ...]:
    """A list of ids; `one` reads each."""
    return tuple(
        one(v, f"{place}[{i}]") for i, v in enumerate(a_list(value, place, at_least, at_most))
    )


def a_bool(value: Any, place: str) -> bool:
    """true or false."""
    if not isinstance(value, bool):
        raise SketchFormatError(f"{place} cannot be {_name(value)}", (), "true or false")
    return value


def by_id(
    value: Any,
    place: str,
    read: Callable[[Any, str], T],
    one: Callable[[Any, str], str] = an_id,
) -> dict[str, T]:
    """An object of elements by id; `one` reads each id."""
    items = an_object(value, place)
    return {one(key, place): read(item, f"{place}.{key}") for key, item in items.items()}


def check_keys(
    body: dict[str, Any], place: str, needed: Iterable[str], allowed: Iterable[str] = ()
) -> None:
    """Refuse keys that are missing and keys that nobody knows."""
    needed = tuple(needed)
    missing = [key for key in needed if key not in body]
    if missing:
        raise SketchFormatError(f"{place} lacks {', '.join(missing)}", (), "add it")
    known = {*needed, *allowed}
    unknown = [key for key in body if key not in known]
    if unknown:
        raise SketchFormatError(
            f"{place} has an unknown key {unknown[0][:40]!r}",
            (),
            f"one of {', '.join(sorted(known))}",
        )


def check_header(body: dict[str, Any], wanted: str, version: int) -> None:
    """Refuse other formats and newer versions."""
    found = body.get("format")
    if found != wanted:
        raise SketchFormatError(
            f"format cannot be {str(found)[:40]!r}", (), f"a file of format {wanted!r}"
        )
    number = body.get("version")
    if isinstance(number, bool) or not isinstance(number, int) or number < 1:
        raise SketchFormatError(
            f"version cannot be {str(number)[:20]!r}", (), f"a version from 1 to {version}"
        )
    if number > version:
        raise SketchVersionError(
            f"version {number} is newer than this program, which knows {version}",
            (),
            "update Modeling in Context",
        )


def _name(value: Any) -> str:
    names = {dict: "an object", list: "a list", str: "text", bool: "true/false", type(None): "null"}
    return names.get(type(value), "a number")
