"""Modified Lipson optimisation as printed in [Lau10], section 4.2.

Quotations are from that section. Where the paper is silent or misprinted, a reading is chosen:

==========================  ====================================================================
the paper                   the reading here
==========================  ====================================================================
unit of length (silent)     drawing units: the drawn diagonal is 100 (`drawing`)
parallel term               printed as 1 / (angle - 90)^2: smallest, not zero, for parallels and
                            infinite at right angles; read as (angle to being parallel)^2
GSL's Nelder-Mead           scipy's, begun with the same kind of simplex (x0, x0 + step_i e_i)
first simplex (silent)      depths and coordinates 10 units, camera: `common.camera_steps`
termination (silent)        `common.Limits`: evaluations per dimension, size of the simplex
"randomly re-initialize"    uniform within half the drawing's diagonal before and behind
mirrored depths (silent)    depths z and -z have the same energy: the shape seen from above its
                            ground is taken
ground (4.2 uses, 3.2 says  between the two steps the shape is moved so that the ground vertices'
how)                        best plane is z = 0, the object above it, and they are put into it
first camera (silent)       looks along the depth axis, as far off as its focal length, so that
                            depth 0 is seen where it was drawn; the focal length is the photo's
                            if told, else 0.8 of its longer side
camera (4.3)                the second method, no marker: its seven numbers are unknowns
weights "until we reach 0"  0.4, 0.3, 0.2, 0.1 and then 0.001: at 0 nothing holds the model to
                            the drawing, and equal lengths shrink it to a point
order of quadrilaterals     grown from the first rectangle: a corner whose three others are known
("stored in advance")       is completed, else the next vertex of the fullest rectangle is free
lengths (3.2)               set the size of the finished shape
on_face (not in [Lau10])    as a right angle between the face's normal and the line to the vertex
==========================  ====================================================================

Circles, surfaces of revolution and symmetry planes are not given here.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..graph import SketchGraph
from ..solution import Solution
from ..values import Array, Progress, Stop
from .common import (
    Found,
    Limits,
    Reference,
    View,
    Watch,
    camera_steps,
    nelder_mead,
    view_along_z,
    watched_by,
)
from .drawing import DIAGONAL, Drawing, read_drawing
from .energies import IntArray
from .placing import onto_ground, run

#: "we start with a weight of 0.4 and lower this by 0.1 each time until we reach 0"; see above.
PROJECTION_WEIGHTS = (0.4, 0.3, 0.2, 0.1, 0.001)
#: First steps of depths and coordinates, drawing units.
STEP = 0.1 * DIAGONAL
#: How much of all the work the initial optimizations are said to be.
INITIAL_SHARE = 0.8


def solve(
    graph: SketchGraph,
    *,
    limits: Limits | None = None,
    stop: Stop | None = None,
    progress: Progress | None = None,
) -> Solution:
    """Lift a sketch graph as [Lau10] does.

    Parameters
    ----------
    graph : SketchGraph
    limits : Limits, optional
        Where the searches end.
    stop : callable, optional
        Asked every few evaluations; True ends the solve at once, with what there is.
    progress : callable, optional
        Told how far the solve is (0 to 1) and what is being done.

    Returns
    -------
    Solution
        ``converged`` where every annotation holds within 1 degree and 1 % of the size.
    """
    limits = limits or Limits()
    watch = watched_by(stop, progress)

    def method(drawing: Drawing) -> Reference:
        depths, spent = initial_optimization(drawing, limits, watch)
        return full_optimization(drawing, depths, limits, watch, spent)

    return run("lau2010", graph, method)


# --- initial optimization ---------------------------------------------------------------------


def initial_optimization(drawing: Drawing, limits: Limits, watch: Watch) -> tuple[Array, int]:
    """ "The initial step finds only the depth of each 3D vertex."

    Returns
    -------
    (n,) array
        Depths, drawing units.
    int
        Evaluations that it took.
    """

    def energy(depths: Array) -> float:
        # "The other two components take the 2D values from the user-drawn sketch."
        return drawing.constraints.energy(np.column_stack([drawing.p, depths]))

    n = len(drawing.p)
    step = np.full(n, STEP)
    # "We initialize depth values to 0."
    share = INITIAL_SHARE / (n + 1)
    words = "initial optimization"
    first = nelder_mead(energy, np.zeros(n), step, limits, watch.part(0.0, share, words))
    best, spent = first, first.evaluations
    # "Given this solution, we iterate through each vertex and randomly re-initialize its depth, and
    # perform an initial optimization for each case. We choose the best result among all cases."
    rng = np.random.default_rng(limits.seed)
    for i in range(n if limits.restarts is None else min(n, limits.restarts)):
        if watch.stop():
            break
        part = watch.part((i + 1) * share, share, f"{words}, vertex {i + 1} of {n}")
        depths = first.x.copy()
        depths[i] = rng.uniform(-DIAGONAL / 2, DIAGONAL / 2)
        case = nelder_mead(energy, depths, step, limits, part)
        spent += case.evaluations
        best = min(best, case, key=lambda found: found.energy)
    return best.x, spent


# --- reduced dimensions -----------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class Dimensions:
    """The reduced dimensions of the full optimisation ([Lau10] Figure 5, right).

    Parameters
    ----------
    of_vertex : tuple of int
        Dimensions of each vertex: 3, 2 on the ground, 0 where it is completed.
    completions : tuple of (corner, a, b, c)
        "The order of quadrilaterals": corner = a + c - b.
    expand : (3 n, k) array
        From the unknowns to all coordinates: the completions in their order, as one matrix.
    chosen : (k,) int array
        The coordinate that each unknown is.
    """

    of_vertex: tuple[int, ...]
    completions: tuple[tuple[int, int, int, int], ...]
    expand: Array
    chosen: IntArray

    def vertices(self, unknowns: Array) -> Array:
        """All vertices (n, 3); those with zero dimensions "are generated from the others"."""
        return np.asarray((self.expand @ unknowns).reshape(-1, 3))


def reduce_dimensions(drawing: Drawing) -> Dimensions:
    """Ground vertices get two dimensions, completed corners of right-angled quadrilaterals none."""
    n = len(drawing.p)
    completions = _order_of_quadrilaterals(drawing)
    completed = {corner for corner, *_ in completions}
    ground = set(drawing.ground)
    of_vertex = tuple(0 if i in completed else 2 if i in ground else 3 for i in range(n))
    chosen = np.array([3 * i + k for i in range(n) for k in range(of_vertex[i])], dtype=np.int64)
    expand = np.zeros((n, 3, len(chosen)))
    expand.reshape(3 * n, -1)[chosen, np.arange(len(chosen))] = 1.0
    for corner, a, b, c in completions:
        expand[corner] = expand[a] + expand[c] - expand[b]
    return Dimensions(of_vertex, completions, expand.reshape(3 * n, -1), chosen)


def dimensions_of(graph: SketchGraph) -> dict[str, int]:
    """The number at each vertex in [Lau10]'s Figure 5, by vertex id."""
    return dict(zip(graph.vertices, reduce_dimensions(read_drawing(graph)).of_vertex, strict=True))


def _order_of_quadrilaterals(drawing: Drawing) -> tuple[tuple[int, int, int, int], ...]:
    """Which corner is completed from which three others, in a valid order."""
    waiting = list(drawing.rectangles)
    known: set[int] = set()
    order: list[tuple[int, int, int, int]] = []
    while waiting:
        fullest = max(waiting, key=lambda loop: len(known & set(loop)))
        missing = [i for i in range(4) if fullest[i] not in known]
        if len(missing) == 1:
            i = missing[0]
            a, b, c = (fullest[(i + k) % 4] for k in (1, 2, 3))
            order.append((fullest[i], a, b, c))
        if len(missing) <= 1:
            waiting.remove(fullest)
        if missing:
            known.add(fullest[missing[0]])
    return tuple(order)


# --- full optimization ------------------------------------------------------------------------


def full_optimization(
    drawing: Drawing,
    depths: Array,
    limits: Limits,
    watch: Watch,
    spent: int = 0,
) -> Reference:
    """ "Both geometric and projection constraints", from the result of the initial step."""
    X, view = _standing(drawing, depths)
    dimensions = reduce_dimensions(drawing)
    unknowns = X.reshape(-1)[dimensions.chosen]
    for k, weight in enumerate(PROJECTION_WEIGHTS):
        share = (1 - INITIAL_SHARE) / len(PROJECTION_WEIGHTS)
        words = f"full optimization, weight {weight:g}"
        part = watch.part(INITIAL_SHARE + k * share, share, words)
        # "running the full optimization multiple times with the previous solution as the starting
        # point and gradually lowering the weight on the projection constraint works well"
        found = _full_once(drawing, dimensions, unknowns, view, weight, limits, part)
        unknowns, view = found.x[:-7], view.moved(found.x[-7:])
        spent += found.evaluations
        if watch.stop():
            break
    return Reference(dimensions.vertices(unknowns), view, spent)


def _full_once(
    drawing: Drawing,
    dimensions: Dimensions,
    unknowns: Array,
    view: View,
    weight: float,
    limits: Limits,
    watch: Watch,
) -> Found:
    def energy(x: Array) -> float:
        X = dimensions.vertices(x[:-7])
        projection = view.moved(x[-7:]).projection_energy(X, drawing.p)
        return drawing.constraints.energy(X) + weight * projection

    x0 = np.concatenate([unknowns, np.zeros(7)])
    step = np.concatenate([np.full(len(unknowns), STEP), camera_steps(drawing)])
    return nelder_mead(energy, x0, step, limits, watch)


def _standing(drawing: Drawing, depths: Array) -> tuple[Array, View]:
    """The shape of the initial step on the ground, seen from above, and its camera."""
    twins = []
    for sign in (1.0, -1.0):
        X = np.column_stack([drawing.p, sign * depths])
        view = view_along_z(drawing.focal + max(0.0, -float(X[:, 2].min())))
        move = onto_ground(drawing, X, view)
        X, view = move.points(X), move.view(view)
        X[list(drawing.ground), 2] = 0.0
        twins.append((X, view))
    looks_down = [float(view.rotation[2, 2]) for _, view in twins]
    return twins[int(np.argmin(looks_down))]
