"""Errors about sketches: what is wrong, where (ids), what to try.

Members also inherit the builtin that they resemble, so that ``except ValueError`` works where the
project's own names are not known.
"""

from __future__ import annotations

from collections.abc import Iterable


class ReasonedError(ValueError):
    """What is wrong, where, and what to try, in one line.

    Parameters
    ----------
    what : str
        What is wrong, one short clause.
    ids : iterable of str
        The elements at fault, as they stand in the sketch; may be empty.
    remedy : str
        What to try.
    """

    def __init__(self, what: str, ids: Iterable[str] = (), remedy: str = "") -> None:
        self.what = what
        self.ids = tuple(ids)
        self.remedy = remedy
        super().__init__(str(self))

    def __str__(self) -> str:
        where = f" ({', '.join(self.ids)})" if self.ids else ""
        remedy = f"; try: {self.remedy}" if self.remedy else ""
        # One line for a terminal: names out of a file may hold line breaks.
        return " ".join(f"{self.what}{where}{remedy}".split())


class SketchError(ReasonedError):
    """A sketch that cannot be used."""


class SketchFileError(SketchError, OSError):
    """The file cannot be read or written."""

    __str__ = SketchError.__str__


class SketchFormatError(SketchError):
    """The text is not a sketch: not JSON, a wrong type, an unknown key, a number out of range."""


class SketchVersionError(SketchFormatError):
    """The sketch was written by a newer version."""


class SketchReferenceError(SketchError, KeyError):
    """An element names another one that is not there."""

    __str__ = SketchError.__str__
