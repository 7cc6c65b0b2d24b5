"""Errors about making things: what cannot be made, of which faces or plates, what to try."""

from __future__ import annotations

from collections.abc import Iterable


class FabricationError(ValueError):
    """A model or setting of which nothing can be made.

    Parameters
    ----------
    what : str
        What is wrong, one short clause.
    ids : iterable of str
        The faces, plates or edges at fault; may be empty.
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
        return " ".join(f"{self.what}{where}{remedy}".split())


class NotRightAngledError(FabricationError):
    """The faces fit no common set of right-angled axes."""


class SettingsError(FabricationError):
    """A setting that is out of range."""
