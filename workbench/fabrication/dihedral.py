"""The joint of two plates at any angle: how far a finger reaches and how far a notch cuts back.

Terms
-----
theta
    Interior dihedral angle, rad: how far it is from one plate to the other through the inside.
x
    Distance into a plate, in its plane, from the line in which the outer faces meet.
tip, notch
    Where the plate's finger ends, and how far it is cut back for the other's finger, as x.

A beam cuts square to the sheet, so off 90 degrees a little void cannot be avoided. These rules
never stick out and never overlap.
"""

from __future__ import annotations

import math

#: Outside these angles no fingers are cut: the lower plate covers the edge (a butt joint).
FINGERS_FROM_RAD = math.radians(30.0)
FINGERS_TO_RAD = math.radians(150.0)


def tip_and_notch(theta: float, own: float, other: float) -> tuple[float, float]:
    """Where a plate's finger ends and how deep its notches are.

    Parameters
    ----------
    theta : float
        Interior dihedral angle, rad, in (0, 2 pi); beyond pi the edge is concave.
    own, other : float
        Thickness of this plate and of the other one, mm.

    Returns
    -------
    tip, notch : float
        mm from the edge into the plate; negative beyond the edge (concave edges).
    """
    if theta > math.pi:
        folded = 2 * math.pi - theta
        tip, notch = tip_and_notch(folded, own, other)
        # Seen from behind it is a convex joint whose line lies so far beyond the drawn one.
        beyond = (other + own * math.cos(folded)) / math.sin(folded)
        return tip - beyond, notch - beyond
    sine, cosine = math.sin(theta), math.cos(theta)
    if abs(cosine) < 1e-12:
        return 0.0, other
    if cosine > 0:
        return own * cosine / sine, (other + own * cosine) / sine
    if -other * cosine > own:
        return 0.0, own * sine / -cosine
    return 0.0, other * sine
