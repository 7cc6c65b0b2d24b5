"""Why nothing whole is left of a plate: which plates take what is missing, at which edges."""

from __future__ import annotations

from collections.abc import Sequence

import shapely
from shapely.geometry import Polygon

from .errors import FabricationError
from .joints import JointPlan
from .overlays import sides_mm


class CutUpError(FabricationError):
    """A plate that others cut into pieces, or take.

    Parameters
    ----------
    what : str
    face_ids : tuple of str
        The plate's faces.
    others : sequence of str
        The plates that do it.
    edge_ids : sequence of str
        The edges between them all.
    chosen : sequence of str
        Where the person chose joints of them.
    """

    def __init__(
        self,
        what: str,
        face_ids: tuple[str, ...],
        others: Sequence[str] = (),
        edge_ids: Sequence[str] = (),
        chosen: Sequence[str] = (),
    ) -> None:
        self.face_ids, self.others = face_ids, tuple(others)
        remedy = "thinner plates, or more room between these faces"
        if chosen:
            remedy = f"another joint at {', '.join(chosen)}, or thinner plates"
        super().__init__(what, (*face_ids[:1], *others, *edge_ids), remedy)

    def blaming(self, plan: JointPlan) -> CutUpError:
        """The same with the edges where it happens, and where the person chose joints there."""
        plates = (self.face_ids[0], *self.others)
        edges, chosen = plan.edges_between(plates), plan.chosen_between(plates)
        return CutUpError(self.what, self.face_ids, self.others, edges, chosen)


def cut_up(
    face_ids: tuple[str, ...],
    whole: Polygon,
    parts: Sequence[Polygon],
    others: Sequence[str],
    thickness_mm: float,
) -> CutUpError:
    """Why a plate is not in one piece.

    Parameters
    ----------
    face_ids : tuple of str
    whole : Polygon
        Its face.
    parts : sequence of Polygon
        What is left of it, the largest first.
    others : sequence of str
        Other plates that lie in `missing`.
    thickness_mm : float
        Of the thickest of them all.
    """
    name = face_ids[0]
    if parts:
        gap = parts[0].distance(parts[1])
        what = (
            f"plates of {thickness_mm:g} mm cut {name} into {len(parts)} pieces {gap:.1f} mm apart"
        )
    else:
        wide = sides_mm(whole)[0]
        what = f"plates of {thickness_mm:g} mm leave nothing of {name}, {wide:.1f} mm wide"
    return CutUpError(what, face_ids, others)


def missing(whole: Polygon, parts: Sequence[Polygon]) -> shapely.Geometry:
    """Where a plate's pieces come nearest to one another; all of it where there are none."""
    if not parts:
        return whole
    gap = max(parts[0].distance(parts[1]), 1e-3)
    return parts[0].buffer(gap).intersection(parts[1].buffer(gap))
