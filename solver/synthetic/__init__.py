"""Synthetic scenes: shapes whose truth is known, photographs of them, and noise.

The tests and the benchmark measure on them; the solver itself never looks here.
"""

from .cramer_rao import shape_error_floor, share_at_floor
from .photographs import (
    HEIGHT,
    WIDTH,
    Hand,
    Photograph,
    Views,
    photograph,
    photograph_exactly,
    random_camera,
    shape_error,
    with_noise,
)
from .random_shapes import FAMILIES, random_lid
from .shapes import (
    SHAPES,
    Shape,
    bookshelf,
    box,
    compartments,
    from_loops,
    hexagonal_box,
    house,
    l_shape,
    organizer,
    prism,
    staircase,
    table,
    tapered_tray,
    v,
    wedge,
)
from .tracing import with_traced_box
from .turned import LID, Turned, image_ellipse, photograph_turned

__all__ = [
    "FAMILIES",
    "HEIGHT",
    "LID",
    "SHAPES",
    "WIDTH",
    "Hand",
    "Photograph",
    "Shape",
    "Turned",
    "Views",
    "bookshelf",
    "box",
    "compartments",
    "from_loops",
    "hexagonal_box",
    "house",
    "image_ellipse",
    "l_shape",
    "organizer",
    "photograph",
    "photograph_exactly",
    "photograph_turned",
    "prism",
    "random_camera",
    "random_lid",
    "shape_error",
    "shape_error_floor",
    "share_at_floor",
    "staircase",
    "table",
    "tapered_tray",
    "v",
    "wedge",
    "with_noise",
    "with_traced_box",
]
