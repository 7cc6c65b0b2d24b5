"""What is left open, what disagrees, and how sure the result is."""

from .again import pose_near
from .blame import Reading, contradicts, convict
from .clashes import clashing_annotations, find_clash, without
from .freedoms import Freedoms, freedoms
from .precision import focal_sigma
from .suspects import Relaxed, leftover_suspects, relax
from .unmet import size_of, unmet_annotations

__all__ = [
    "Freedoms",
    "Reading",
    "Relaxed",
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
    "unmet_annotations",
    "without",
]
