"""Errors about making things: what cannot be made, of which faces or plates, what to try."""

from __future__ import annotations

from ...solver.errors import ReasonedError


class FabricationError(ReasonedError):
    """A model or setting of which nothing can be made; its ids are faces, plates or edges."""


class NotRightAngledError(FabricationError):
    """The faces fit no common set of right-angled axes."""


class SettingsError(FabricationError):
    """A setting that is out of range."""
