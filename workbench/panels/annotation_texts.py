"""What annotations say, in a person's words: pure, no Qt."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import host
from ..canvas.lengths import exact_text

if TYPE_CHECKING:
    from ...solver.annotations import Annotation
    from ...solver.solution import Residual

#: What a kind is called, and its icon.
KINDS: dict[str, tuple[str, str]] = {
    "right_angle": ("Right angle", "InContext_ToolRightAngle"),
    "equal_length": ("Equal lengths", "InContext_ToolEqualLength"),
    "parallel": ("Parallel", "InContext_ToolParallel"),
    "ground": ("On the ground", "InContext_ToolGround"),
    "symmetry_plane": ("Symmetry plane", "InContext_ToolSymmetryPlane"),
    "length": ("Length", "InContext_ToolLength"),
    "diameter": ("Diameter", "InContext_ToolCircle"),
    "on_face": ("On a face", "InContext_ToolOnFace"),
}
#: Below this a residual is noise of the arithmetic, in degrees as in mm.
NOTHING = 0.005
#: So many ids are named; more would fill the line.
NAMED = 4


def kind_words(kind: str) -> str:
    """What a kind of annotation is called."""
    return host.translate("InContext", KINDS[kind][0])


def kind_icon(kind: str) -> str:
    """Path of a kind's icon."""
    return host.icon(KINDS[kind][1])


def words_of(annotation: Annotation) -> str:
    """An annotation in a line: what it is, and of what."""
    # A corner says enough; its edges would only lengthen the line.
    corner = getattr(annotation, "at", "")
    ids = (corner,) if corner else named_by(annotation)
    # Ids first: where the panel is narrow they are what must be read, the icon tells the kind.
    return f"{_ids(ids)}  {kind_words(annotation.kind)}"


def named_by(annotation: Annotation) -> tuple[str, ...]:
    """The ids that an annotation names, for a person."""
    from ...solver.annotations import targets_of

    return tuple(id_ for ids in targets_of(annotation).values() for id_ in ids)


def _ids(ids: tuple[str, ...]) -> str:
    shown = ", ".join(ids[:NAMED])
    return shown if len(ids) <= NAMED else f"{shown}, \N{HORIZONTAL ELLIPSIS}"


def size_mm(annotation: Annotation) -> float | None:
    """The size that an annotation drives; None where it drives none."""
    for name in ("length_mm", "diameter_mm"):
        if hasattr(annotation, name):
            return float(getattr(annotation, name))
    return None


def size_text(annotation: Annotation) -> str:
    """The size that an annotation drives, to be edited; empty where it drives none."""
    size = size_mm(annotation)
    return "" if size is None else exact_text(size)


def residual_text(residual: Residual | None) -> str:
    """How far an annotation is from being true; empty where it is true or unknown."""
    if residual is None or residual.value < NOTHING:
        return ""
    unit = "\N{DEGREE SIGN}" if residual.unit == "deg" else f" {residual.unit}"
    return f"{residual.value:.2f}{unit}" if residual.value < 100 else f"{residual.value:.0f}{unit}"
