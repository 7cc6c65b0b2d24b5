"""Annotations that do not hold in the result."""

from __future__ import annotations

from collections.abc import Mapping

from ..geometry import diagonal
from ..solution import Residual, Residuals
from ..values import Array

#: Residuals above this are not zero: degrees, or parts of the object's size.
HELD_TOLERANCE = 1e-7


def unmet_annotations(residuals: Mapping[str, Residual], size_mm: float) -> tuple[str, ...]:
    """Annotations that do not hold, the worst first."""

    def badness(residual: Residual) -> float:
        # What has no size at all is wrong by any length.
        return residual.value / (max(size_mm, 1e-300) if residual.unit == "mm" else 57.3)

    if isinstance(residuals, Residuals):
        # Most hold to the last digits: look at the others only.
        residuals = residuals.above(HELD_TOLERANCE * min(size_mm, 57.3))
    bad = {id_: badness(r) for id_, r in residuals.items() if badness(r) > HELD_TOLERANCE}
    return tuple(sorted(bad, key=lambda id_: (-bad[id_], id_)))


def size_of(X: Array) -> float:
    """The object's size: the diagonal of its bounding box, mm."""
    return diagonal(X)
