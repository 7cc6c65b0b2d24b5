"""Existing things added to a sketch: boxes traced exactly where they are."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from incontext.solver import solve
from incontext.solver.annotations import Ground, Parallel, RightAngle
from incontext.solver.graph import SketchGraph
from incontext.solver.synthetic import box


def with_block(graph: SketchGraph, low, size, name: str = "b") -> SketchGraph:
    """The sketch with a box that stands on the ground, parallel to the object's first edge.

    Parameters
    ----------
    graph : SketchGraph
        Of something whose first edge runs along the world's x.
    low, size : (x, y) and (w, d, h)
        Where the box stands in the solved world, and how large it is, mm.
    name : str
        What its ids begin with.
    """
    solution = solve(graph)
    real = box(*size)
    drawn = solution.camera.project(real.X - real.X.min(axis=0) + (*low, 0.0))
    first = min(graph.edges, key=lambda e: _off_x(solution, graph.edges[e]))
    edges = {f"{name}e{k}": (f"{name}{a}", f"{name}{b}") for k, (a, b) in enumerate(real.edges)}
    along = next(e for e, (a, b) in zip(edges, real.edges, strict=True) if _is_x(real, a, b))
    said = {f"{name}p": Parallel((first, along))}
    for id_, a in real.annotations.items():
        if isinstance(a, RightAngle):
            said[name + id_] = RightAngle(name + a.at[1:], tuple(f"{name}{e}" for e in a.between))
        elif isinstance(a, Ground):
            said[name + id_] = Ground(tuple(name + v[1:] for v in a.vertices))
    points = {f"{name}{k}": (float(u), float(v)) for k, (u, v) in enumerate(drawn)}
    return replace(
        graph,
        vertices={**graph.vertices, **points},
        edges={**graph.edges, **edges},
        annotations={**graph.annotations, **said},
        construction=(*graph.construction, *edges),
    )


def _off_x(solution, ends) -> float:
    way = solution.vertices_mm[ends[1]] - solution.vertices_mm[ends[0]]
    return float(np.hypot(way[1], way[2]) / np.linalg.norm(way))


def _is_x(real, a: int, b: int) -> bool:
    return bool(np.abs(real.X[a] - real.X[b])[1:].max() < 1e-9)
