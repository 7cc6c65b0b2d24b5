"""Shapes whose truth is known, and photographs of them as sketch graphs: the solver's own."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from incontext.solver.annotations import Length, Parallel, RightAngle
from incontext.solver.graph import SketchGraph
from incontext.solver.synthetic import *  # noqa: F403
from incontext.solver.synthetic import house, photograph, v

#: Round the two gables of `loose_house`.
GABLES = (frozenset(v(k) for k in range(5)), frozenset(v(k) for k in range(5, 10)))


def loose_house(noise: float, *, slope_told: bool) -> SketchGraph:
    """A drawn house: annotated walls, a level ridge, perhaps a slope of the roof."""
    shape = house()
    peaks = frozenset((v(3), v(8)))
    edge = {frozenset(map(v, pair)): f"e{k}" for k, pair in enumerate(shape.edges)}
    roof = {e for ends, e in edge.items() if ends & peaks}
    said = {
        key: a
        for key, a in shape.annotations.items()
        if not (isinstance(a, RightAngle) and roof.intersection(a.between))
    }
    said["ridge"] = Parallel((edge[peaks], edge[frozenset((v(0), v(5)))]))
    if slope_told:
        said["slope"] = Length(edge[frozenset((v(2), v(3)))], 100.0)
    told = replace(shape, annotations=said)
    return photograph(told, np.random.default_rng(1), noise=noise).graph
