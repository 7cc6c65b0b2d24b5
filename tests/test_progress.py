"""Progress of slow solves, and the line that shows it."""

from __future__ import annotations

import io
from dataclasses import replace

import numpy as np
import pytest
from scenes import box, house, l_shape, organizer, photograph, tapered_tray, wedge

from incontext.solver import solve, wishes
from incontext.solver.diagnosis import clashes, suspects
from incontext.solver.full import FullProblem
from incontext.solver.graph import SketchGraph
from incontext.solver.reference import METHODS, Limits
from incontext.solver.solution import Status
from incontext.solver.starting import floating
from incontext.solver.synthetic import LID, photograph_turned, random_lid
from incontext.solver.synthetic.planting import planted, planted_diameter
from incontext.solver.synthetic.shapes import Shape
from incontext.workbench import progress_line
from incontext.workbench.progress_line import ProgressLine

GRAPH = photograph(box(), np.random.default_rng(0)).graph
HASTY = Limits(evaluations_per_dimension=5, restarts=2)


def assert_goes_forward(told):
    fractions = [done for done, _ in told]
    assert fractions == sorted(fractions)
    assert all(0 <= done <= 1 for done in fractions)
    assert all(what for _, what in told)


def test_a_solve_tells_how_far_it_is():
    told = []
    solve(GRAPH, progress=lambda done, what: told.append((done, what)))
    assert len(told) >= 3
    assert_goes_forward(told)


@pytest.mark.parametrize("method", METHODS)
def test_reference_methods_tell_how_far_they_are(method):
    told = []
    METHODS[method](GRAPH, limits=HASTY, progress=lambda done, what: told.append((done, what)))
    assert told
    assert_goes_forward(told)


def planted_in(shape: Shape, kind: str) -> SketchGraph:
    rng = np.random.default_rng(0)
    graph = planted(photograph(shape, rng, noise=0.01), rng, kind)
    assert graph is not None
    return graph


def with_few_annotations(shape: Shape, part: float) -> SketchGraph:
    rng = np.random.default_rng(1)
    graph = photograph(shape, rng, noise=0.01).graph
    kept = {k: a for k, a in graph.annotations.items() if rng.random() < part}
    return replace(graph, annotations=kept)


def false_diameter() -> SketchGraph:
    rng = np.random.default_rng(0)
    lid = random_lid(rng)
    return planted_diameter(photograph_turned(lid, rng, noise=0.01)[0], lid, rng)


#: What a solve may have to do, each in its own way.
PATHS = {
    "parts that float": lambda: with_few_annotations(tapered_tray(), 1.0),
    "few annotations": lambda: with_few_annotations(house(), 0.3),
    "begun from guesses": lambda: with_few_annotations(organizer(3, 2), 0.4),
    "a false annotation": lambda: planted_in(wedge(), "equal_length"),
    "a clash": lambda: planted_in(l_shape(), "parallel"),
    "a wished length": lambda: planted_in(box(), "length"),
    "circles": lambda: photograph_turned(LID, np.random.default_rng(0), noise=0.01)[0],
    "a wished diameter": false_diameter,
}


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize("twin", [False, True])
def test_each_way_of_solving_tells_and_stops_at_once(path, twin, monkeypatch):
    """Next to nothing is worked out once somebody wants it to stop, whenever that is."""
    graph = PATHS[path]()
    told: list[tuple[float, str]] = []
    asked = [0]

    def never() -> bool:
        asked[0] += 1
        return False

    solve(graph, stop=never, progress=lambda done, what: told.append((done, what)), twin=twin)
    assert_goes_forward(told)
    assert told[-1][0] == 1
    assert len(told) >= 3 + asked[0] // 200

    wanted, work = [False], [0]
    for owner, name in WORK:
        monkeypatch.setattr(owner, name, counted(getattr(owner, name), wanted, work))
    for part in (0.0, 0.1, 0.35, 0.65, 0.95):
        left, work[0] = int(part * asked[0]), 0
        wanted[0] = False

        def stop() -> bool:
            nonlocal left
            left -= 1
            wanted[0] = left < 0
            return wanted[0]

        solution = solve(graph, stop=stop, twin=twin)
        assert solution.status is Status.NOT_CONVERGED
        assert "Stopped" in solution.message
        assert work[0] <= MOST_WORK, (part, work[0])


#: What takes long in a solve, and how often it may still be done after a stop.
WORK = (
    (FullProblem, "evaluate"),
    (floating._Search, "linearised"),
    (suspects._Springs, "_energy"),
    (wishes, "gentlest_step"),
    (clashes, "build_structure"),
)
MOST_WORK = 10


def counted(function, wanted, work):
    def call(*args, **kwargs):
        work[0] += wanted[0]
        return function(*args, **kwargs)

    return call


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(("out", "shown"), [(Terminal(), True), (io.StringIO(), False)])
def test_the_line_is_shown_on_a_terminal_only(out, shown, monkeypatch):
    monkeypatch.setattr(progress_line, "PATIENCE_S", 0.0)
    line = ProgressLine(out)
    line.tell(0.4, "full optimization")
    assert ("40 %  full optimization" in out.getvalue()) is shown
    line.clear()
    assert out.getvalue().rstrip("\r").endswith(" ") is shown


def test_what_is_quick_says_nothing():
    out = Terminal()
    line = ProgressLine(out)
    line.tell(0.4, "reasoning")
    line.clear()
    assert out.getvalue() == ""
