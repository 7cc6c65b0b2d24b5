"""The geometric energies ([Lau10] 4.2), one a file, and the registry that tests walk.

Terms
-----
residual r
    Zero where the annotation holds; free of units: it does not change when the shape is moved,
    turned or scaled.
triplets
    The Jacobian's entries (row, vertex, d r / d x_vertex): rows (t,), vertices (t,), values (t, 3).

Every energy is a function of the vertex positions X (n, 3) and of an index array with one row for
each residual or block of residuals. Laws, tested for each: zero on the truth; the Jacobian equals
the central difference; unchanged by a move of the gauge.
"""

from collections.abc import Callable

from .angle import angle
from .base import Linearised
from .length_ratio import length_ratio
from .parallel import parallel
from .planarity import planarity
from .right_angle import right_angle
from .symmetry import symmetry

#: Energies by name; each takes (X, index array[, wanted lengths or angles]).
ENERGIES: dict[str, Callable[..., Linearised]] = {
    "right_angle": right_angle,
    "angle": angle,
    "parallel": parallel,
    "length_ratio": length_ratio,
    "planarity": planarity,
    "symmetry": symmetry,
}

__all__ = [
    "ENERGIES",
    "Linearised",
    "angle",
    "length_ratio",
    "parallel",
    "planarity",
    "right_angle",
    "symmetry",
]
