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
    by_centre, by_normal : (3, k, j) arrays
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
    square : (k, j) array
        Of p.
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
    square: Array
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
        Cz, nz, square = self.C[2], float(self.n[2]), self.square
        half = 0.5 / root
        ha, hc = (1 + a / root) / c, -(a + root) / c**2 - b * (half / c)
        by_centre, by_normal = np.empty((2, 3, *a.shape))
        # With hb = -half; the derivative by the focal length is that by p.
        along = ha * Cz - 2 * half * Cp
        np.multiply(along, self.p, out=by_centre[:2])
        by_centre[2] = ha * Cp + 2 * hc * Cz
        along = ha * nz - 2 * half * n_p
        np.multiply(along, self.p, out=by_normal[:2])
        by_normal[2] = ha * n_p + 2 * hc * nz
        by_normal *= self.r**2
        by_radius = ha * n_p * nz + half * (square - n_p**2) - hc * (1 - nz**2)
        return Slopes(by_centre, by_normal, 2 * self.r * by_radius, ha * a - 2 * half * b)


def ellipse_support(va: Array, vb: Array, centre: Array, q: Array) -> Array:
    """Support of an ellipse from its semi-axes: q . c + sqrt((q . va)^2 + (q . vb)^2)."""
    return np.asarray(q @ centre + np.hypot(q @ va, q @ vb))


def circle_support(C: Array, r: Array, n: Array, p: Array) -> Support:
    """Support of the images of circles, from the dual conic.

    With e = (0, 0, 1), M = C C^T - r^2 (I - n n^T), a = p^T M e, b = p^T M p, c = e^T M e:
    h = (a + sqrt(a^2 - b c)) / c.

    Parameters
    ----------
    C : (3, k) array
        Centres in the camera frame.
    r : (k,) array
    n : (3,) array
        Common unit normal in the camera frame.
    p : (2, k, j) array
        Unit directions in the image, times the focal length; with a third number, 0.
    """
    centre, radius = C[:, :, None], r[:, None]
    nx, ny, nz = n.tolist()
    Cp, n_p = centre[0] * p[0] + centre[1] * p[1], nx * p[0] + ny * p[1]
    Cz, R2, squares = centre[2], radius**2, p[0] ** 2 + p[1] ** 2
    a = Cp * Cz + (R2 * nz) * n_p
    b = Cp**2 - R2 * (squares - n_p**2)
    c = Cz**2 - R2 * (1 - nz**2)
    square = a**2 - b * c
    visible = all(float(depths.min()) > 0 for depths in (Cz, c, square))
    root = np.sqrt(np.maximum(square, 1e-300))
    if not visible:
        c = np.where(c > 0, c, 1.0)
    return Support((a + root) / c, visible, p, squares, centre, n, radius, Cp, n_p, a, b, c, root)
