"""From what older versions stored to what this one reads.

Each migration takes an object from one version to the next and is never removed: a document saved
by any version opens for ever.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .. import host

#: The step that leads from a version to the next; versions without one need none.
MIGRATIONS: dict[int, Callable[[Any], None]] = {}


def migrate(obj: Any, stored: int, current: int) -> None:
    """Bring an object from its stored version to the current one, a step at a time."""
    if stored > current:
        host.warn(
            host.translate(
                "InContext",
                "{} was saved by a newer version of this addon; what it added is left as it is",
            ).format(obj.Label)
        )
    for version in range(stored, current):
        step = MIGRATIONS.get(version)
        if step is not None:
            step(obj)
