"""Progress of slow solves, and the line that shows it."""

from __future__ import annotations

import io

import numpy as np
import pytest
from scenes import box, photograph

from incontext.solver import solve
from incontext.solver.reference import METHODS, Limits
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
