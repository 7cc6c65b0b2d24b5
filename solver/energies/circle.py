"""Circles: a horizontal circle's image against a drawn ellipse ([Lau10] 4.2, projection term).

The paper compares antipodal points on the axes. In perspective the axes of the image ellipse are
not images of diameters, so the comparison is made where it is exact: the tangent lines.

Terms
-----
support
    h(q) = max over the ellipse of q . (u, v), the distance of the tangent line with the outward
    normal q from the principal point.
dual conic
    The tangent lines l of the image satisfy l^T D l = 0 with
    D = K (C C^T - r^2 (I - n n^T)) K^T for a circle with centre C, radius r, normal n (camera
    frame), and K = diag(f, f, 1).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..values import Array

_E = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True, eq=False)
class Support:
    """Supports of k circles in j directions, and their derivatives.

    Parameters
    ----------
    h : (k, j) array
    by_centre, by_normal : (k, j, 3) arrays
    by_radius, by_log_focal : (k, j) arrays
    visible : bool
        False where a circle reaches the eye's plane; the values then mean nothing.
    """

    h: Array
    by_centre: Array
    by_normal: Array
    by_radius: Array
    by_log_focal: Array
    visible: bool


def ellipse_support(va: Array, vb: Array, centre: Array, q: Array) -> Array:
    """Support of an ellipse from its semi-axes: q . c + sqrt((q . va)^2 + (q . vb)^2)."""
    return np.asarray(q @ centre + np.hypot(q @ va, q @ vb))


def circle_support(C: Array, r: Array, n: Array, focal: float, q: Array) -> Support:
    """Support of the images of circles, from the dual conic.

    With p = (f q, 0), e = (0, 0, 1), M = C C^T - r^2 (I - n n^T), a = p^T M e, b = p^T M p,
    c = e^T M e: h = (a + sqrt(a^2 - b c)) / c.

    Parameters
    ----------
    C : (k, 3) array
        Centres in the camera frame.
    r : (k,) array
    n : (3,) array
        Common unit normal in the camera frame.
    focal : float
    q : (k, j, 2) array
        Unit directions in the image.
    """
    p = np.concatenate([focal * q, np.zeros((*q.shape[:2], 1))], axis=2)
    Cp, Ce = np.einsum("kji,ki->kj", p, C), C[:, None, 2]
    np_, ne = p @ n, n[2]
    R2 = (r**2)[:, None]
    a = Cp * Ce + R2 * np_ * ne
    b = Cp**2 - R2 * ((p**2).sum(axis=2) - np_**2)
    c = Ce**2 - R2 * (1 - ne**2)
    square = a**2 - b * c
    visible = bool((c > 0).all() and (square > 0).all() and (C[:, 2] > 0).all())
    s = np.sqrt(np.maximum(square, 1e-300))
    c = np.where(c > 0, c, 1.0)
    ha, hb, hc = (1 + a / s) / c, -0.5 / s, -(a + s) / c**2 - b / (2 * s * c)
    Ce3, Cp3, np3 = Ce[..., None], Cp[..., None], np_[..., None]
    by_centre = (
        ha[..., None] * (p * Ce3 + _E * Cp3)
        + hb[..., None] * (2 * p * Cp3)
        + hc[..., None] * (2 * _E * Ce3)
    )
    by_normal = R2[..., None] * (
        ha[..., None] * (p * ne + _E * np3)
        + hb[..., None] * (2 * p * np3)
        + hc[..., None] * (2 * _E * ne)
    )
    by_radius = (2 * r)[:, None] * (
        ha * np_ * ne - hb * ((p**2).sum(axis=2) - np_**2) - hc * (1 - ne**2)
    )
    return Support((a + s) / c, by_centre, by_normal, by_radius, ha * a + hb * 2 * b, visible)
