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


@dataclass(frozen=True, slots=True, eq=False)
class Slopes:
    """Derivatives of the supports of k circles in j directions.

    Parameters
    ----------
    by_centre, by_normal : (k, j, 3) arrays
    by_radius, by_log_focal : (k, j) arrays
    """

    by_centre: Array
    by_normal: Array
    by_radius: Array
    by_log_focal: Array


@dataclass(frozen=True, slots=True, eq=False)
class Support:
    """Supports of k circles in j directions, in the letters of `circle_support`.

    Parameters
    ----------
    h : (k, j) array
    visible : bool
        False where a circle reaches the eye's plane; the values then mean nothing.
    p : (2, k, j) array
        Without its last number, 0.
    C : (3, k, 1) array
    n : (3,) array
    r : (k, 1) array
    Cp, n_p : (k, j) arrays
        Products C . p and n . p.
    a, b, root : (k, j) arrays
    c : (k, 1) array
    """

    h: Array
    visible: bool
    p: Array
    C: Array
    n: Array
    r: Array
    Cp: Array
    n_p: Array
    a: Array
    b: Array
    c: Array
    root: Array

    def slopes(self) -> Slopes:
        """Derivatives: h by a, b and c, and these by what they are made of."""
        a, b, c, root, Cp, n_p = self.a, self.b, self.c, self.root, self.Cp, self.n_p
        Cz, nz = self.C[2], float(self.n[2])
        ha, hb, hc = (1 + a / root) / c, -0.5 / root, -(a + root) / c**2 - b / (2 * root * c)
        by_centre, by_normal = np.empty((2, *a.shape, 3))
        along = ha * Cz + 2 * hb * Cp
        by_centre[..., 0], by_centre[..., 1] = along * self.p
        by_centre[..., 2] = ha * Cp + 2 * hc * Cz
        along = self.r**2 * (ha * nz + 2 * hb * n_p)
        by_normal[..., 0], by_normal[..., 1] = along * self.p
        by_normal[..., 2] = self.r**2 * (ha * n_p + 2 * hc * nz)
        square = (self.p**2).sum(axis=0)
        by_radius = ha * n_p * nz - hb * (square - n_p**2) - hc * (1 - nz**2)
        return Slopes(by_centre, by_normal, 2 * self.r * by_radius, ha * a + 2 * hb * b)


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
    p = focal * q.transpose(2, 0, 1)
    centre, radius = C.T[:, :, None], r[:, None]
    Cp, n_p = centre[0] * p[0] + centre[1] * p[1], n[0] * p[0] + n[1] * p[1]
    Cz, nz, R2 = centre[2], float(n[2]), radius**2
    a = Cp * Cz + R2 * nz * n_p
    b = Cp**2 - R2 * ((p**2).sum(axis=0) - n_p**2)
    c = Cz**2 - R2 * (1 - nz**2)
    square = a**2 - b * c
    visible = bool((c > 0).all() and (square > 0).all() and (Cz > 0).all())
    root = np.sqrt(np.maximum(square, 1e-300))
    c = np.where(c > 0, c, 1.0)
    return Support((a + root) / c, visible, p, centre, n, radius, Cp, n_p, a, b, c, root)
