"""How fast ours is: from nothing, after a change, while a vertex is dragged; and the ratios.

Terms
-----
from nothing
    A sketch never seen: the reasoning about its annotations, the camera, the shape, the report.
faces
    What looking for the faces in 3D takes then, which is done when they are first asked for.
known
    The same where nothing but positions is new: the reasoning is kept.
structure
    The reasoning about annotations alone, without the drawing.
change
    One annotation is taken away; the last solution is the start.
dragged
    One vertex moves by a pixel or so, again and again.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...solver import solve
from ...solver.dragging import begin_drag, drag
from ...solver.graph import SketchGraph
from ...solver.problem import build_problem
from ...solver.reference import METHODS, Limits
from ...solver.structure import build_structure
from ...solver.synthetic import Shape, organizer, photograph, table
from ...solver.values import forget_kept
from . import solvespace
from .options import MakeShape, organizer_of_200_vertices, organizer_of_500_vertices

COLUMNS = "{:<15} {:>5} {:>7} {:>13} {:>7} {:>7} {:>10} {:>7} {:>8}"
NOISE = 0.005
MOVES = 4
#: Of so many tries the fastest counts: the others tell what else the machine had to do.
TRIES = 5
#: What takes so many times as long as ours is not waited for.
ENOUGH = 1500


def organizer_of_50_vertices() -> Shape:
    """4 times 4 compartments."""
    return organizer(4, 4)


def organizer_of_98_vertices() -> Shape:
    """6 times 6 compartments."""
    return organizer(6, 6)


def organizer_of_990_vertices() -> Shape:
    """32 times 14 compartments."""
    return organizer(32, 14)


#: Of one kind, so that their growth tells something.
GROWING: tuple[MakeShape, ...] = (
    organizer_of_50_vertices,
    organizer_of_98_vertices,
    organizer_of_200_vertices,
    organizer_of_500_vertices,
    organizer_of_990_vertices,
)
COMPARED: tuple[MakeShape, ...] = (table, organizer_of_200_vertices, organizer_of_500_vertices)


@dataclass(frozen=True, slots=True)
class Times:
    """Medians over some views, ms."""

    from_nothing: float
    faces: float
    known: float
    structure: float
    change: float
    dragged: float


def speed(shapes: tuple[MakeShape, ...], runs: int) -> Iterator[str]:
    """The lines of the section, each as soon as it is known.

    Parameters
    ----------
    shapes : tuple of callables
        Of all kinds; those of which growth and ratios are told come by themselves.
    runs : int
        Views of each shape.
    """
    yield ""
    yield f"ours, processor's ms: medians over {runs} views, each the fastest of {TRIES} tries; the"
    yield "camera unknown. from nothing: never seen before, the reasoning about the annotations"
    yield "included; faces: looking for them in 3D then, when they are asked for; known: only"
    yield "positions are new; structure: the reasoning alone; change: an annotation taken away,"
    yield "from the last solution; dragged: a vertex moves."
    yield ""
    names = ("from nothing", "faces", "known", "structure", "change", "dragged")
    yield COLUMNS.format("shape", "vert.", "noise", *names)
    measured: dict[tuple[str, float], Times] = {}
    for make in dict.fromkeys((*shapes, *COMPARED, *GROWING)):
        shape = make()
        for noise in (0.0, NOISE):
            times = measured[shape.name, noise] = measure(shape, noise, runs)
            yield _line(shape, noise, times)
    yield ""
    yield from _growth(measured)
    yield ""
    yield from _ratios(measured, runs)


def _line(shape: Shape, noise: float, t: Times) -> str:
    figures = (t.from_nothing, t.faces, t.known, t.structure, t.change, t.dragged)
    told = [f"{figure:.2f}" for figure in figures]
    return COLUMNS.format(shape.name, len(shape.X), f"{100 * noise:g} %", *told)


def measure(shape: Shape, noise: float, runs: int) -> Times:
    """Time everything on some views of a shape."""
    rows = []
    for run in range(runs):
        graph = photograph(shape, np.random.default_rng([7, run]), noise=noise).graph
        rows.append(np.min([_times(graph) for _ in range(TRIES)], axis=0))
    return Times(*np.median(rows, axis=0).tolist())


def _times(graph: SketchGraph) -> tuple[float, ...]:
    new = _new(graph)
    structure, _ = _timed(lambda: _reason(new))
    seen = _new(graph)
    from_nothing, solution = _timed(lambda: solve(seen))
    faces, _ = _timed(lambda: len(solution.faces))
    known, _ = _timed(lambda: solve(_moved(seen, 0.0)))
    fewer = dict(graph.annotations)
    fewer.popitem()
    changed = replace(graph, annotations=fewer)
    change, _ = _timed(lambda: solve(changed, start=solution))
    state, moves = begin_drag(graph, solution), []
    for k in range(MOVES):
        moved = _moved(graph, k + 1.0)
        ms, state = _timed(lambda: drag(state, moved))  # noqa: B023
        moves.append(ms)
    return from_nothing, faces, known, structure, change, float(np.median(moves))


def _timed(work: Callable[[], Any]) -> tuple[float, Any]:
    began = time.process_time()
    result = work()
    return (time.process_time() - began) * 1e3, result


def _new(graph: SketchGraph) -> SketchGraph:
    """The same as never seen before: nothing that was worked out from it is kept."""
    forget_kept()
    return replace(
        graph,
        vertices=dict(graph.vertices),
        edges=dict(graph.edges),
        annotations=dict(graph.annotations),
        faces=None if graph.faces is None else dict(graph.faces),
    )


def _moved(graph: SketchGraph, by_px: float) -> SketchGraph:
    first = next(iter(graph.vertices))
    u, v = graph.vertices[first]
    return replace(graph, vertices={**graph.vertices, first: (u + by_px, v + by_px / 2)})


def _reason(graph: SketchGraph) -> None:
    build_problem(graph, build_structure(graph))


def _growth(measured: dict[tuple[str, float], Times]) -> Iterator[str]:
    """The exponents of the vertices' number, by least squares."""
    shapes = [make() for make in GROWING]
    n = np.log([len(shape.X) for shape in shapes])
    for noise in (0.0, NOISE):
        found = [measured[shape.name, noise] for shape in shapes]
        slopes = [
            float(np.polyfit(n, np.log(ms), 1)[0])
            for ms in ([t.from_nothing for t in found], [t.known for t in found])
        ]
        yield (
            f"growth, organizers of {len(shapes[0].X)} to {len(shapes[-1].X)} vertices, "
            f"{100 * noise:g} % noise: n^{slopes[0]:.2f} from nothing, n^{slopes[1]:.2f} known"
        )


def _ratios(measured: dict[tuple[str, float], Times], runs: int) -> Iterator[str]:
    shape = table()
    yield _paper(shape, measured[shape.name, 0.0].from_nothing)
    if solvespace.missing():
        yield solvespace.missing()
        return
    for make in COMPARED:
        shape = make()
        ms = solvespace.median_ms(shape, min(runs, 3))
        exact, noisy = (measured[shape.name, noise] for noise in (0.0, NOISE))
        yield (
            f"slvs, {len(shape.X)} vertices (start 0.1 % off, hand-picked constraints, no camera): "
            f"{ms:.1f} ms; ours from nothing, structure included: {ms / exact.from_nothing:.3g} "
            f"times faster, {ms / noisy.from_nothing:.3g} with {100 * NOISE:g} % noise; known: "
            f"{ms / exact.known:.3g} times, {ms / noisy.known:.3g} with noise"
        )


def _paper(shape: Shape, ours_ms: float) -> str:
    """The paper's method with its whole budget, as far as it is waited for."""
    graph = photograph(shape, np.random.default_rng([7, 0])).graph
    deadline = time.process_time() + ENOUGH * ours_ms / 1e3
    stopped = []

    def stop() -> bool:
        late = time.process_time() > deadline
        if late:
            stopped.append(late)
        return late

    limits = Limits()
    ms, _ = _timed(lambda: METHODS["lau2010"](graph, limits=limits, stop=stop))
    how = f"stopped after {ms / 1e3:.0f} s, more than" if stopped else f"{ms / 1e3:.1f} s,"
    return (
        f"lau2010, {len(shape.X)} vertices ({limits.evaluations_per_dimension} evaluations a "
        f"dimension, every vertex re-initialised): {how} {ms / ours_ms:.0f} times ours"
    )
