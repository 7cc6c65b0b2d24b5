"""What a person should know of plates that were made, a line each."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from .joints import Joint
from .near_borders import slots_near_borders
from .plates import Joined


def notes_of(joined: Joined) -> tuple[str, ...]:
    """A line for each unusual joint, for fingers made wider, slots near borders and voids."""
    unusual = tuple(joint.words for joint in joined.joints if joint.reason)
    unusual += tuple(_widened_words([joint for joint in joined.joints if joint.widened]))
    near = slots_near_borders(joined.plates, joined.joints)
    return (*unusual, *near, *(_void_words(ids, size) for ids, size in joined.empty_mm3.items()))


def _widened_words(joints: Iterable[Joint]) -> Iterator[str]:
    """One line for each width that is not as wished, with the first joint that has it."""
    found: dict[float, list[Joint]] = {}
    for joint in joints:
        found.setdefault(joint.meeting.least_mm, []).append(joint)
    for least, same in found.items():
        where = ", ".join(same[0].meeting.name)
        rest = f" and {len(same) - 1} more" if len(same) > 1 else ""
        yield (
            f"{where}{rest}: fingers of {same[0].finger_mm:g} mm would not hold, they are "
            f"{least:g} mm wide or wider"
        )


def _void_words(face_ids: Iterable[str], volume_mm3: float) -> str:
    """One line about space that no plate can fill."""
    return (
        f"{', '.join(face_ids)} meet in a point: {volume_mm3:.1f} mm3 stay empty there, which "
        "square cuts cannot fill"
    )
