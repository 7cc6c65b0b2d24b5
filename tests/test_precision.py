"""Standard errors: what the drawing alone tells of the focal length."""

from __future__ import annotations

import numpy as np
import pytest
from scenes import FAMILIES, Hand, Views, photograph

from incontext.solver import solve
from incontext.solver.diagnosis import standard_errors
from incontext.solver.full import FullProblem
from incontext.solver.least_squares import minimise
from incontext.solver.lifting import lift
from incontext.solver.problem import build_problem
from incontext.solver.starting.focal_prior import usual_prior
from incontext.solver.structure import build_structure

AFAR = Views(fov_deg=(3.0, 8.0))


def from_afar(family: str, run: int):
    rng = np.random.default_rng([run, list(FAMILIES).index(family)])
    return photograph(FAMILIES[family](rng), rng, hand=Hand(0.003), views=AFAR)


@pytest.mark.parametrize(
    ("family", "run"), [("organizer 6", 4000), ("table", 4003), ("organizer 24", 4004)]
)
def test_what_was_expected_does_not_make_the_focal_length_surer(family, run):
    graph = from_afar(family, run).graph
    problem = build_problem(graph, build_structure(graph))
    begun = lift(graph, problem.structure, None).minimum.x
    free = FullProblem(problem, None)
    x = minimise(free, begun, enough=1e-12).x
    expected = free.with_prior(usual_prior(free, x))
    drawn_nearer = minimise(expected, x, enough=1e-12).x
    assert drawn_nearer.log_focal < x.log_focal
    alone = standard_errors(free, x).log_focal
    assert standard_errors(expected, drawn_nearer).log_focal == pytest.approx(alone, rel=0.25)


@pytest.mark.parametrize(("family", "run"), [("organizer 6", 4000), ("organizer 24", 4004)])
def test_from_afar_it_is_said_that_the_focal_length_is_not_told(family, run):
    solution = solve(from_afar(family, run).graph)
    assert solution.report.focal_assumed
    assert "focal length" in solution.message
