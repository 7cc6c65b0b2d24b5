"""Sizes said of the new object where something real tells the scale: they change that alone.

A camera known from a marker, or a size measured on a traced thing, tells how big everything is. So
no size of the new object is needed for that, and one that is said is a wish: the shape is what the
drawing shows without it, stretched to it, and stands where it was drawn. Nor does it tell anything
of the camera. Where both are there, what was measured comes before the camera's height.
"""

from __future__ import annotations

from collections.abc import Callable

from .blaming import GROSS_RMS, Blame, blame_for_wishes
from .candidates import drawing_rms, is_settled
from .diagnosis import freedoms, without
from .graph import SketchGraph
from .lifting import Lifted
from .structure import Structure, build_structure
from .values import Stop
from .wishes import fulfilled, sizes_of
from .world import ground_indices

#: A drawing so many times further missed than without the sizes was changed by them.
WORTH_A_WORD = 1.5

#: Finds the shape of a graph, and what is to blame where it is missed.
Lifting = Callable[[SketchGraph, Structure], tuple[Lifted | None, Blame | None]]


def designed_sizes(graph: SketchGraph) -> tuple[str, ...]:
    """The annotations that say sizes of the new object, where something real tells the scale."""
    sizes = sizes_of(graph)
    if not any(sizes.values()) and _eye_mm(graph) is None:
        return ()
    return tuple(id_ for id_, is_traced in sizes.items() if not is_traced)


def _eye_mm(graph: SketchGraph) -> float | None:
    """How high over the ground a known camera is; None where that tells nothing."""
    if graph.camera is None or not ground_indices(graph):
        return None
    height_mm = float(graph.camera.position_mm[2])
    return height_mm if height_mm > 0 else None


def as_designed(
    graph: SketchGraph, structure: Structure, lift: Lifting, stop: Stop
) -> tuple[Lifted, Blame | None] | None:
    """The shape with sizes of the new object; None where none is said, or that is in doubt.

    Parameters
    ----------
    graph : SketchGraph
    structure : Structure
    lift : callable
        Finds the shape of a graph, and what is to blame where it is missed.
    stop : callable
    """
    sizes = designed_sizes(graph)
    if not sizes:
        return None
    plain = without(graph, *sizes)
    drawn, blamed = lift(plain, build_structure(plain))
    if drawn is None or (blamed is not None and not blamed.held) or stop():
        return None
    found = stretched(graph, structure, drawn, stop)
    if found is None or blamed is not None:
        return None if found is None else (found, blamed)
    return found, _changed_by(graph, sizes, drawn, found)


def stretched(graph: SketchGraph, structure: Structure, drawn: Lifted, stop: Stop) -> Lifted | None:
    """The shape that is drawn, with the sizes of the new object."""
    if not is_settled(drawn) or not drawn.above:
        return None
    if freedoms(drawn.full, drawn.minimum.x, [*graph.vertices, *graph.circles]).count:
        return None
    if any(sizes_of(graph).values()):
        return fulfilled(graph, structure, drawn, stop)
    eye_mm = None if drawn.problem.up_in_cam is None else _eye_mm(graph)
    return None if eye_mm is None else fulfilled(graph, structure, drawn, stop, eye_mm=eye_mm)


def _changed_by(
    graph: SketchGraph, sizes: tuple[str, ...], drawn: Lifted, found: Lifted
) -> Blame | None:
    """What is said where the sizes are far from those that are drawn."""
    least = max(GROSS_RMS, WORTH_A_WORD * drawing_rms(drawn))
    return blame_for_wishes(graph, sizes, found) if drawing_rms(found) > least else None
