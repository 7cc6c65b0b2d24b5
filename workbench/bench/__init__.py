"""The benchmark: ours beside the paper's method, Lipson's and SolveSpace's, all in one run.

Terms
-----
case
    One shape with one amount of noise; its views are the same for every method.
success
    The shape is right within 3 %: RMS over its vertices after the best similarity, in parts of its
    diameter.
"""

from .accuracy import study
from .options import Options
from .pictures import write_pictures
from .running import bench
from .timing import speed

__all__ = ["Options", "bench", "speed", "study", "write_pictures"]
