"""What a person should know of plates that were made, a line each."""

from __future__ import annotations

from collections.abc import Iterable

from .near_borders import slots_near_borders
from .plates import Joined


def notes_of(joined: Joined) -> tuple[str, ...]:
    """One line for each unusual joint, each slot too near to a border and each void."""
    unusual = tuple(joint.words for joint in joined.joints if joint.reason)
    near = slots_near_borders(joined.plates, joined.joints)
    return (*unusual, *near, *(_void_words(ids, size) for ids, size in joined.empty_mm3.items()))


def _void_words(face_ids: Iterable[str], volume_mm3: float) -> str:
    """One line about space that no plate can fill."""
    return (
        f"{', '.join(face_ids)} meet in a point: {volume_mm3:.1f} mm3 stay empty there, which "
        "square cuts cannot fill"
    )
