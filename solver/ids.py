"""Ids of elements: new ones, and whether they are there."""

from __future__ import annotations

from collections.abc import Iterable

from .errors import SketchReferenceError


def fresh_id(letter: str, taken: Iterable[str]) -> str:
    """The letter and a number above all numbers in use with it."""
    numbers = [id_[len(letter) :] for id_ in taken if id_.startswith(letter)]
    return f"{letter}{max((int(n) for n in numbers if _is_number(n)), default=0) + 1}"


def _is_number(text: str) -> bool:
    # Longer ones are somebody's names: counting on from them would make them longer still.
    return text.isascii() and text.isdigit() and len(text) < 9


def need(ids: Iterable[str], there: Iterable[str]) -> None:
    """Raise SketchReferenceError where some ids are not there."""
    missing = sorted(set(ids) - set(there))
    if missing:
        raise SketchReferenceError("there is no such element in the sketch", missing)
