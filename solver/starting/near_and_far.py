"""Near and far exchanged: the other beginning that a drawing seen from afar has (Necker)."""

from __future__ import annotations

import numpy as np

from ..full import FullProblem, Pose

#: The object axis along which the shape is mirrored.
_MIRRORED = np.diag([1.0, 1.0, -1.0])


def near_and_far_exchanged(full: FullProblem, x: Pose) -> Pose:
    """The pose mirrored in depth at its middle, along the ray through it.

    The shape is mirrored along one object axis, and the view with it, so that the frame stays
    right-handed and what holds in the shape's own frame holds there as well.
    """
    c = full.positions(x)
    middle = c.mean(axis=0)
    in_cam = x.R @ middle
    ray = in_cam / max(float(np.linalg.norm(in_cam)), 1e-300)
    R = (np.eye(3) - 2.0 * np.outer(ray, ray)) @ x.R @ _MIRRORED
    g = x.g.copy()
    g[full.coordinate] = (c - middle) @ _MIRRORED + in_cam @ R
    return Pose(R, x.log_focal, g)
