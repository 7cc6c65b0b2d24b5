"""What is left open, what disagrees, and how sure the result is."""

from .again import pose_near
from .blame import Reading, contradicts, convict
from .clashes import clashing_annotations, find_clash, without
from .freedoms import Freedoms, freedoms
from .precision import UNSURE_SIZE_SIGMA, focal_sigma, size_sigmas
from .suspects import (
    MANY_UNKNOWNS,
    Relaxed,
    beginnings,
    leftover_suspects,
    relax,
    spring_stiffness,
)
from .unmet import size_of, unmet_annotations

__all__ = [
    "MANY_UNKNOWNS",
    "UNSURE_SIZE_SIGMA",
    "Freedoms",
    "Reading",
    "Relaxed",
    "beginnings",
    "clashing_annotations",
    "contradicts",
    "convict",
    "find_clash",
    "focal_sigma",
    "freedoms",
    "leftover_suspects",
    "pose_near",
    "relax",
    "size_of",
    "size_sigmas",
    "spring_stiffness",
    "unmet_annotations",
    "without",
]
