"""Which annotation would help most where freedoms are left."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from ..annotations import Parallel, RightAngle, SymmetryPlane
from ..graph import SketchGraph
from ..values import Array
from .freedoms import Freedoms

#: A corner further than this from a right angle (cosine) is hardly meant to be one.
NEARLY_SQUARE = 0.35
#: What changes an angle by less than this does not fix it.
LEAST_GAIN = 1e-3
#: An edge shorter than this part of the distance has no direction.
LEAST_LENGTH = 1e-9
#: Of a tangle not all corners are looked at.
MAX_CORNERS = 2000


def says_directions(graph: SketchGraph) -> bool:
    """Whether anything says what is square or parallel; equal lengths alone fix no camera."""
    kinds = (RightAngle, Parallel, SymmetryPlane)
    return any(isinstance(a, kinds) for a in graph.annotations.values())


def busiest_vertex(graph: SketchGraph) -> str | None:
    """Where most edges meet; the one that was drawn first of equals."""
    met = dict.fromkeys(graph.vertices, 0)
    for ends in graph.edges.values():
        for v in ends:
            met[v] += 1
    best = max(met, key=lambda v: met[v], default=None)
    return best if best is not None and met[best] > 1 else None


def most_helpful_corner(
    graph: SketchGraph, X: Array, open_: Freedoms
) -> tuple[str, str, str] | None:
    """The corner that a right angle would fix most: vertex and two edges.

    Parameters
    ----------
    graph : SketchGraph
    X : (n, 3) array
        The vertices as found, in the camera's frame.
    open_ : Freedoms

    Returns
    -------
    vertex, edge, edge, or None where no corner that looks square moves.
    """
    index = {v: i for i, v in enumerate(graph.vertices)}
    best, found = LEAST_GAIN, None
    for k, (v, e, f) in enumerate(_corners(graph)):
        if k == MAX_CORNERS:
            break
        ends = [next(w for w in graph.edges[edge] if w != v) for edge in (e, f)]
        u, w = (X[index[end]] - X[index[v]] for end in ends)
        lengths = [float(np.linalg.norm(x)) for x in (u, w)]
        if min(lengths) < LEAST_LENGTH * float(np.abs(X[:, 2]).max()):
            continue
        cosine = float(u @ w) / (lengths[0] * lengths[1])
        if abs(cosine) > NEARLY_SQUARE:
            continue
        du, dw = (open_.moves[:, index[end]] - open_.moves[:, index[v]] for end in ends)
        turned = (du @ w + dw @ u) / (lengths[0] * lengths[1])
        turned -= cosine * (du @ u / lengths[0] ** 2 + dw @ w / lengths[1] ** 2)
        gain = float(np.linalg.norm(turned))
        if gain > best * (1 + 1e-6):
            best, found = gain, (v, e, f)
    return found


def _corners(graph: SketchGraph) -> Iterator[tuple[str, str, str]]:
    """Where two edges meet and no right angle is said to be."""
    said = {frozenset(a.between) for a in graph.annotations.values() if isinstance(a, RightAngle)}
    at: dict[str, list[str]] = {v: [] for v in graph.vertices}
    for edge, ends in graph.edges.items():
        for v in ends:
            at[v].append(edge)
    for v, edges in at.items():
        for e, f in combinations(edges, 2):
            if frozenset((e, f)) not in said:
                yield v, e, f
