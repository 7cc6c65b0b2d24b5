"""Synthetic scenes: shapes whose truth is known, photographs of them, and noise.

The tests and the benchmark measure on them; the solver itself never looks here.
"""

from .photographs import (
    HEIGHT,
    WIDTH,
    Noise,
    Photograph,
    photograph,
    random_camera,
    shape_error,
    with_noise,
)
from .shapes import (
    SHAPES,
    Shape,
    bookshelf,
    box,
    from_loops,
    hexagonal_box,
    house,
    l_shape,
    organizer,
    prism,
    staircase,
    table,
    v,
    wedge,
)
from .turned import LID, Turned, image_ellipse, photograph_turned

__all__ = [
    "HEIGHT",
    "LID",
    "SHAPES",
    "WIDTH",
    "Noise",
    "Photograph",
    "Shape",
    "Turned",
    "bookshelf",
    "box",
    "from_loops",
    "hexagonal_box",
    "house",
    "image_ellipse",
    "l_shape",
    "organizer",
    "photograph",
    "photograph_turned",
    "prism",
    "random_camera",
    "shape_error",
    "staircase",
    "table",
    "v",
    "wedge",
    "with_noise",
]
