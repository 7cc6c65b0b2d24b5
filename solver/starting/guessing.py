"""What a drawing suggests where the annotations leave much open: good for a beginning, no more.

Few annotations share few coordinates, and the rest is then a matter of many curved constraints that
no step from afar meets. Most things that people draw have three directions, though: a view in which
most drawn lines run along one of three perpendicular axes tells which edges those are. Solved with
that said as well, the shape is near; then everything guessed is taken back.

Terms
-----
guess
    Parallels and right angles that nobody annotated but the drawing agrees with.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from ..annotations import Annotation, Parallel, RightAngle
from ..geometry import cross, diagonal
from ..graph import SketchGraph
from ..ids import fresh_id
from ..initial import FOCAL_GUESSES, LOG_FOCAL_RANGE, USUAL_LOG_FOCAL, VIEWS
from ..problem import Problem
from ..structure import build_structure
from ..values import Array, IntArray
from .focal_prior import USUAL_SIGMA

#: Views that are looked at closely, and guesses that are told.
MAX_VIEWS, MAX_GUESSES = 12, 4
#: Of a tangle nothing is guessed.
MAX_EDGES = 600
#: A line further than this from an axis (sine) is along none; wider while the view is coarse.
COARSE, FINE = 0.15, 0.05
REFINEMENTS = 12
#: An edge may lean by this angle (rad), and by what a hand strays at its ends, in parts of the
#: drawing's diagonal.
LEAN, STRAY = 0.035, 0.015
#: How far drawn lines lean (rad), against which the usual focal length is weighed.
USUAL_LEAN = 0.015
MOST_LEAN = 0.25
#: An axis is told from another one where that fits so many times worse.
TOLD_APART = 2.0


def guesses(graph: SketchGraph, problem: Problem) -> Iterator[SketchGraph]:
    """The graph with more annotations, the likeliest guess first.

    Parameters
    ----------
    graph : SketchGraph
    problem : Problem
        Of the graph as it is.
    """
    if not 0 < len(problem.ends) <= MAX_EDGES:
        return
    drawn = _drawn_lines(problem)
    told: list[frozenset[tuple[int, int]]] = []
    for R, log_focal in _views(drawn, problem.log_focal_prior):
        axis = _axes(drawn, problem, R, log_focal)
        key = _without_names(axis)
        if key in told or len(told) == MAX_GUESSES:
            continue
        told.append(key)
        more = _saying(graph, problem, axis, drawn)
        if len(more.annotations) > len(graph.annotations):
            yield more


@dataclass(frozen=True, slots=True, eq=False)
class _Lines:
    """Lines (m, 3) through drawn edges, their lengths, and how far each may lean (rad)."""

    lines: Array
    lengths: Array
    tolerance: Array

    def sines(self, R: Array, log_focal: float) -> Array:
        """Of the angle between each line's plane and each axis, (m, 3)."""
        return np.asarray(self.normals(np.array([log_focal]))[0] @ R)

    def normals(self, log_focals: Array) -> Array:
        """Of the lines' planes in the frames of k cameras, (k, m, 3)."""
        N = np.repeat(self.lines[None], len(log_focals), axis=0)
        N[..., :2] *= np.exp(log_focals)[:, None, None]
        return np.asarray(N / np.maximum(np.linalg.norm(N, axis=2), 1e-300)[..., None])


def _drawn_lines(problem: Problem) -> _Lines:
    p, q = (problem.points[problem.ends[:, k]] for k in (0, 1))
    ones = np.ones((len(p), 1))
    lengths = np.linalg.norm(q - p, axis=1)
    stray = STRAY * diagonal(problem.points) / np.maximum(lengths, 1e-300)
    lines = cross(np.hstack([p, ones]), np.hstack([q, ones]))
    return _Lines(lines, lengths, np.minimum(LEAN + stray, MOST_LEAN))


def _views(drawn: _Lines, known: float | None) -> list[tuple[Array, float]]:
    """Cameras in which most of what is drawn runs along the axes, best first."""
    scored = []
    for log_focal in FOCAL_GUESSES if known is None else (known,):
        N = drawn.normals(np.array([log_focal]))[0] / COARSE
        least = np.minimum.reduce([np.abs(N @ VIEWS[..., k].T) for k in range(3)])
        costs = drawn.lengths @ np.minimum(least**2, 1.0)
        scored += [(float(costs[i]), i, log_focal) for i in np.argsort(costs)[:MAX_VIEWS].tolist()]
    best = sorted(scored)[:MAX_VIEWS]
    R, log_focals = VIEWS[[i for _, i, _ in best]], np.array([f for _, _, f in best])
    return _refined(drawn, R, log_focals, known)


def _refined(
    drawn: _Lines, R: Array, log_focals: Array, known: float | None
) -> list[tuple[Array, float]]:
    """Iteratively reweighted least squares: lines along no axis lose their say. All at once."""
    # Careless lines say "from afar": what is usual has a say.
    expected = float(drawn.lengths.sum()) * (USUAL_LEAN / USUAL_SIGMA) ** 2
    usual = USUAL_LOG_FOCAL if known is None else known
    for width in np.geomspace(COARSE, FINE, REFINEMENTS):
        N = drawn.normals(log_focals)
        sines = N @ R
        axis = np.abs(sines).argmin(axis=2)
        r = np.take_along_axis(sines, axis[..., None], axis=2)
        J = _derivatives(N, np.take_along_axis(R.swapaxes(1, 2), axis[..., None], axis=1))
        if known is not None:
            J[..., 3] = 0.0
        weighed = (J * (drawn.lengths[:, None] / (1 + (r / width) ** 2) ** 2)).swapaxes(1, 2)
        A, b = weighed @ J, weighed @ r
        A[:, 3, 3] += expected
        b[:, 3, 0] += expected * (log_focals - usual)
        A += (1e-4 * np.trace(A, axis1=1, axis2=2) + 1e-300)[:, None, None] * np.eye(4)
        step = -np.linalg.solve(A, b)[..., 0]
        R = Rotation.from_rotvec(step[:, :3]).as_matrix() @ R
        log_focals = np.clip(log_focals + np.clip(step[:, 3], -0.3, 0.3), *LOG_FOCAL_RANGE)
    least = np.abs(drawn.normals(log_focals) @ R).min(axis=2) / FINE
    order = np.argsort(np.minimum(least**2, 1.0) @ drawn.lengths, kind="stable")
    return [(R[k], float(log_focals[k])) for k in order.tolist()]


def _derivatives(N: Array, D: Array) -> Array:
    """Of each line's sine to its axis D (k, m, 3), by a turn and the log focal length."""
    by_focal = N * np.array([1.0, 1.0, 0.0])
    by_focal -= N * np.einsum("kmi,kmi->km", N, by_focal)[..., None]
    return np.concatenate([cross(D, N), (by_focal * D).sum(axis=2, keepdims=True)], axis=2)


def _axes(drawn: _Lines, problem: Problem, R: Array, log_focal: float) -> IntArray:
    """The axis of each edge, -1 where that is open: whole classes, the longest drawn first."""
    directions = problem.structure.directions
    off = (drawn.sines(R, log_focal) / drawn.tolerance[:, None]) ** 2
    names, members = np.unique(directions.class_of, return_inverse=True)
    members = members.reshape(-1)
    total = np.bincount(members, drawn.lengths)
    axis_of: dict[int, int] = {}
    for c in np.argsort(-total).tolist():
        own = members == c
        misfit = np.sqrt(np.average(off[own], axis=0, weights=drawn.lengths[own] + 1e-300))
        across = directions.perpendicular.get(int(names[c]), ())
        taken = {axis_of[int(other)] for other in across if int(other) in axis_of}
        misfit[list(taken)] = np.inf
        best, second = np.sort(misfit)[:2]
        if best < 1 and second > TOLD_APART * best and second > 1:
            axis_of[int(names[c])] = int(np.argmin(misfit))
    return np.array([axis_of.get(int(c), -1) for c in directions.class_of], dtype=np.int64)


def _without_names(axis: IntArray) -> frozenset[tuple[int, int]]:
    """The same for all ways to number the axes."""
    first: dict[int, int] = {}
    renamed = ((e, first.setdefault(k, len(first))) for e, k in enumerate(axis.tolist()) if k >= 0)
    return frozenset(renamed)


def _saying(graph: SketchGraph, problem: Problem, axis: IntArray, drawn: _Lines) -> SketchGraph:
    """As much of it said as agrees with the annotations, the longest drawn edges first.

    Short edges are taken for others most easily.
    """
    order = np.argsort(-drawn.lengths)
    order = order[axis[order] >= 0]

    def saying(count: int) -> SketchGraph:
        some = np.full_like(axis, -1)
        some[order[:count]] = axis[order[:count]]
        return _with_axes(graph, problem, some)

    low, high = 0, len(order) + 1
    while high - low > 1:
        middle = (low + high) // 2 if high <= len(order) else len(order)
        if build_structure(saying(middle)).contradiction:
            high = middle
        else:
            low = middle
    return saying(low)


def _with_axes(graph: SketchGraph, problem: Problem, axis: IntArray) -> SketchGraph:
    """The graph with the edges of each axis said to be parallel, and square to the others."""
    edges = list(graph.edges)
    along = [[edges[i] for i in np.flatnonzero(axis == k).tolist()] for k in range(3)]
    said: list[Annotation] = [Parallel(tuple(group)) for group in along if len(group) > 1]
    said += _corners(graph, problem, axis)
    annotations = dict(graph.annotations)
    for annotation in said:
        annotations[fresh_id("guess", annotations)] = annotation
    return replace(graph, annotations=annotations)


def _corners(graph: SketchGraph, problem: Problem, axis: IntArray) -> Iterator[RightAngle]:
    """One right angle for each two axes whose edges meet somewhere."""
    names, edges = list(graph.vertices), list(graph.edges)
    at: dict[int, dict[int, int]] = {}
    for e, (v, w) in enumerate(problem.ends.tolist()):
        if axis[e] >= 0:
            at.setdefault(v, {})[int(axis[e])] = e
            at.setdefault(w, {})[int(axis[e])] = e
    for pair in ((0, 1), (0, 2), (1, 2)):
        for v, by_axis in at.items():
            if by_axis.keys() >= set(pair):
                first, second = (edges[by_axis[k]] for k in pair)
                yield RightAngle(names[v], (first, second))
                break
