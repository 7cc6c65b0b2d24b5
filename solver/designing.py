"""Sizes said of the new object under a camera that tells the scale: they change that size alone.

A camera known from a marker tells how big everything is. So no size is needed to set the scale, and
one that is said is a wish: the shape is what the drawing shows without it, stretched to it, and
stands where it was drawn. What was measured on a traced thing is no wish: it sets the scale, before
the camera's height does.
"""

from __future__ import annotations

from collections.abc import Callable

from .blaming import GROSS_RMS, Blame, blame_for_wishes, drawing_rms, is_settled
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
    """The annotations that say sizes of the new object, where a known camera tells the scale."""
    if graph.camera is None or graph.camera.position_mm[2] <= 0 or not ground_indices(graph):
        return ()
    return tuple(id_ for id_, is_traced in sizes_of(graph).items() if not is_traced)


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


def stretched(
    graph: SketchGraph, structure: Structure, drawn: Lifted, stop: Stop
) -> Lifted | None:
    """The shape that is drawn, with the sizes of the new object."""
    problem, x = drawn.problem, drawn.minimum.x
    if problem.up_in_cam is None or graph.camera is None or not is_settled(drawn):
        return None
    if freedoms(drawn.full, x, [*graph.vertices, *graph.circles]).count:
        return None
    by_camera = not any(sizes_of(graph).values())
    eye_mm = float(graph.camera.position_mm[2]) if by_camera else None
    return fulfilled(graph, structure, drawn, stop, eye_mm=eye_mm)


def _changed_by(
    graph: SketchGraph, sizes: tuple[str, ...], drawn: Lifted, found: Lifted
) -> Blame | None:
    """What is said where the sizes are far from those that are drawn."""
    least = max(GROSS_RMS, WORTH_A_WORD * drawing_rms(drawn))
    return blame_for_wishes(graph, sizes, found) if drawing_rms(found) > least else None
