"""What is left open, what disagrees, and how sure the result is."""

from .again import KnownShape, pose_in, pose_near
from .blame import LEAST_NOTICEABLE, MAX_TRIED, Reading, as_well, best_first, contradicts, convict
from .clashes import Clash, clashing_annotations, disagree, find_clash, without
from .freedoms import Freedoms, freedoms
from .helpful import busiest_vertex, most_helpful_corner, says_directions
from .precision import UNSURE_SIZE_SIGMA, StandardErrors, focal_sigma, standard_errors
from .reliefs import reliefs
from .suspects import (
    MANY_UNKNOWNS,
    MAX_UNKNOWNS,
    Relaxed,
    beginnings,
    false_together,
    leftover_suspects,
    relax,
    spring_stiffness,
)
from .undecided import is_undecided
from .unmet import size_of, unmet_annotations

__all__ = [
    "LEAST_NOTICEABLE",
    "MANY_UNKNOWNS",
    "MAX_TRIED",
    "MAX_UNKNOWNS",
    "UNSURE_SIZE_SIGMA",
    "Clash",
    "Freedoms",
    "KnownShape",
    "Reading",
    "Relaxed",
    "StandardErrors",
    "as_well",
    "beginnings",
    "best_first",
    "busiest_vertex",
    "clashing_annotations",
    "contradicts",
    "convict",
    "disagree",
    "false_together",
    "find_clash",
    "focal_sigma",
    "freedoms",
    "is_undecided",
    "leftover_suspects",
    "most_helpful_corner",
    "pose_in",
    "pose_near",
    "relax",
    "reliefs",
    "says_directions",
    "size_of",
    "spring_stiffness",
    "standard_errors",
    "unmet_annotations",
    "without",
]
