"""What is loose or too thin: plates that hardly hang together, walls that no nozzle prints.

Terms
-----
held
    Joined by fingers, tabs or half-laps; a butt joint holds by glue alone.
bridge
    What is left between two parts of a plate, if it is narrower than the plate is thick.
line width
    Of a printer: what is narrower is not printed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.union_find import UnionFind
from .joints import Joint
from .parts_in_space import Part, corners
from .plates import Joined, Plate

#: At so many heights a print is looked at.
SLICES = 40


def loose_plates(joined: Joined) -> tuple[str, ...]:
    """One line for each plate that few joints hold, and for parts that nothing joins."""
    plates = joined.plates
    if len(plates) < 2:
        return ()
    lines = list(_pieces(joined))
    for plate in plates:
        joints = [j for j in joined.joints if _has(j, plate) and j.kind != "none"]
        firm = [j for j in joints if j.kind != "butt"]
        if joints and not firm:
            where = _edges(joints)
            lines.append(f"{plate.id} is held by glue alone ({where})")
        elif len(joints) == 1:
            lines.append(f"{plate.id} is held by one joint only ({_edges(joints)}); glue it")
    return tuple(lines)


def _has(joint: Joint, plate: Plate) -> bool:
    return bool({*joint.meeting.one, *joint.meeting.two} & {*plate.face_ids})


def _edges(joints: Iterable[Joint]) -> str:
    return ", ".join(dict.fromkeys(" ".join(j.meeting.name) for j in joints))


def _pieces(joined: Joined) -> Iterable[str]:
    """What to say where joints do not hold all plates together."""
    home = {f: n for n, plate in enumerate(joined.plates) for f in plate.face_ids}
    sets = UnionFind(len(joined.plates))
    for joint in joined.joints:
        if joint.kind != "none":
            sets.union(home[joint.meeting.one[0]], home[joint.meeting.two[0]])
    groups: dict[int, list[str]] = {}
    for n, label in enumerate(sets.labels()):
        groups.setdefault(label, []).append(joined.plates[n].id)
    if len(groups) > 1:
        said = "; ".join(", ".join(group) for group in groups.values())
        yield f"nothing joins these to one another: {said}"


def thin_plates(plates: Iterable[Plate]) -> tuple[str, ...]:
    """One line for each plate with a bridge narrower than its thickness."""
    lines = []
    for plate in plates:
        t = plate.thickness_mm
        for width in (t / 4, t / 2, t):
            thinned = plate.polygon.buffer(-width / 2, join_style="mitre")
            parts = [p for p in shapely.get_parts(thinned) if p.area > t * t]
            if len(parts) > 1:
                x, y = _between(parts, plate.polygon)
                lines.append(
                    f"{plate.id} is thinner than {width:.2g} mm about ({x:.0f}, {y:.0f}) mm from "
                    f"its corner: it breaks there"
                )
                break
    return tuple(lines)


def _between(parts: Sequence[Polygon], whole: Polygon) -> tuple[float, float]:
    """The middle of the bridge between the first part and what is nearest to it."""
    rest = shapely.union_all(parts[1:])
    line = shapely.shortest_line(parts[0], rest)
    middle = shapely.intersection(line, whole).centroid
    return float(middle.x), float(middle.y)


def thin_walls(part: Part, line_mm: float) -> tuple[str, ...]:
    """One line where a print has walls that are narrower than its printer's line.

    Parameters
    ----------
    part : Part
    line_mm : float
        Width of the line.

    Returns
    -------
    tuple of str
        Empty, or one that says from which height to which.
    """
    heights = corners([part.body])[:, 2]
    low, high = float(heights.min()), float(heights.max())
    thin = [z for z in np.linspace(low, high, SLICES + 2)[1:-1] if _is_thin(part, z, line_mm)]
    if not thin:
        return ()
    return (
        f"walls are thinner than the printer's line of {line_mm:g} mm from {thin[0] - low:.1f} to "
        f"{thin[-1] - low:.1f} mm above the lowest point: they are not printed there",
    )


def _is_thin(part: Part, height: float, line_mm: float) -> bool:
    rings = [Polygon(ring) for ring in part.body.slice(height).to_polygons() if len(ring) > 2]
    area = shapely.Polygon()
    for ring in rings:
        area = area.symmetric_difference(ring.buffer(0))
    # Narrower by a little: walls as wide as the line are printed.
    half = 0.49 * line_mm
    printed = area.buffer(-half, join_style="mitre").buffer(1.05 * half, join_style="mitre")
    lost = area.difference(printed)
    # The tips of sharp corners are always lost; walls are longer.
    return any(p.area > 4 * line_mm**2 for p in shapely.get_parts(lost))
