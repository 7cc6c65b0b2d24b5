"""Runs the methods on the same views and prints the table, line by line."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from ...solver import solve
from ...solver.reference import METHODS
from ...solver.synthetic import Photograph, Shape, box, photograph
from ...solver.values import forget_kept
from . import solvespace
from .options import Options

RIGHT = 0.03
OURS = "ours"
COLUMNS = "{:<15} {:>5} {:>7}  {:<11} {:>7} {:>10} {:>10} {:>9}"


@dataclass(frozen=True, slots=True)
class Outcome:
    """One solve: the shape's error in parts of its diameter (None: no result), and the time."""

    error: float | None
    ms: float


Method = Callable[[Photograph], Outcome]


def bench(options: Options) -> Iterator[str]:
    """The lines of the table, each as soon as it is known."""
    yield from _heading(options)
    yield COLUMNS.format("shape", "vert.", "noise", "method", "right", "error", "time", "x ours")
    _warm_up()
    for number, make in enumerate(options.shapes):
        shape = make()
        for noise in options.noises:
            photos = [_view(shape, number, run, noise) for run in range(options.runs)]
            yield from _lines(options, shape, noise, photos)


def _heading(options: Options) -> Iterator[str]:
    yield (
        f"{options.runs} random views a shape (elevation 15 to 50, field of view 25 to 65 degrees, "
        "camera unknown)."
    )
    yield "noise: RMS of each drawn vertex, in the sketch's diagonal. error, time: medians."
    yield "right: shape error below 3 % (RMS over the object's diameter, best similarity)."
    yield "x ours: how many times as long as ours. time: of the processor, the structure of the"
    yield "annotations included."
    for name, limits in (("", options.limits), ("from 20 vertices ", options.limits_for_many)):
        restarts = "every vertex" if limits.restarts is None else f"{limits.restarts} vertices"
        yield (
            f"lau2010, lipson1996: {name}at most {limits.evaluations_per_dimension} evaluations a "
            f"dimension, {restarts} re-initialised."
        )
    yield "So cut short they are faster than as printed, and wrong more often: `bench --speed`"
    yield "gives lau2010 its whole budget at 52 vertices."
    yield f"They get {options.slow_runs} view from {options.many_vertices} vertices on."
    yield solvespace.HEADING
    missing = solvespace.missing()
    if missing:
        yield missing
    yield ""


def _warm_up() -> None:
    """Have everything imported before the clock runs."""
    shape = box()
    solve(photograph(shape, np.random.default_rng(0)).graph)
    if not solvespace.missing():
        _slvs(shape, 1)


def _view(shape: Shape, number: int, run: int, noise: float) -> Photograph:
    # The camera is drawn before the noise: one view for all amounts of noise.
    return photograph(shape, np.random.default_rng([number, run]), noise=noise)


def _lines(options: Options, shape: Shape, noise: float, photos: list[Photograph]) -> Iterator[str]:
    ours_ms = None
    for name, method, n_photos in _methods(options, len(shape.X)):
        outcomes = [method(photo) for photo in photos[:n_photos]]
        ms = _median_ms(outcomes)
        ours_ms = ours_ms or ms
        yield _line(shape, f"{100 * noise:g} %", name, outcomes, ms / ours_ms)
    if noise == options.noises[0] and not solvespace.missing():
        outcomes = _slvs(shape, options.runs)
        yield _line(shape, "start", "slvs", outcomes, _median_ms(outcomes) / (ours_ms or 1.0))


def _methods(options: Options, n: int) -> Iterator[tuple[str, Method, int]]:
    yield OURS, _ours, options.runs
    if n < options.too_many_vertices:
        few = min(options.runs, options.slow_runs)
        for name in METHODS:
            yield (
                name,
                _reference(options, name),
                options.runs if n < options.many_vertices else few,
            )


def _ours(photo: Photograph) -> Outcome:
    # From nothing, the structure of the annotations included.
    forget_kept()
    began = time.process_time()
    solution = solve(photo.graph)
    ms = (time.process_time() - began) * 1e3
    return Outcome(photo.error(solution.vertices_mm) if solution.vertices_mm else None, ms)


def _reference(options: Options, name: str) -> Method:
    def method(photo: Photograph) -> Outcome:
        began = time.process_time()
        solution = METHODS[name](photo.graph, limits=options.limits_of(photo.shape))
        ms = (time.process_time() - began) * 1e3
        found = solution.vertices_mm
        return Outcome(photo.error(found) if found else None, ms)

    return method


def _slvs(shape: Shape, runs: int) -> list[Outcome]:
    task = solvespace.independent_constraints(shape)
    starts = [solvespace.displaced(shape, np.random.default_rng(run)) for run in range(runs)]
    return [Outcome(*solvespace.measure(task, shape, start)) for start in starts]


def _median_ms(outcomes: list[Outcome]) -> float:
    return float(np.median([o.ms for o in outcomes]))


def _line(shape: Shape, noise: str, name: str, outcomes: list[Outcome], ratio: float) -> str:
    errors = [np.inf if o.error is None else o.error for o in outcomes]
    right = sum(e < RIGHT for e in errors)
    error = float(np.median(errors))
    return COLUMNS.format(
        shape.name,
        len(shape.X),
        noise,
        name,
        f"{right}/{len(outcomes)}",
        f"{100 * error:.2g} %" if np.isfinite(error) else "none",
        in_words(_median_ms(outcomes)),
        f"{ratio:.3g}" if ratio < 1000 else f"{ratio:.0f}",
    )


def in_words(ms: float) -> str:
    """A time with its unit."""
    return f"{ms:.2f} ms" if ms < 1000 else f"{ms / 1000:.2f} s"
