"""Shapes whose lines leave the camera loose: begun from cameras that fit the lines as well."""

from __future__ import annotations

import numpy as np
import pytest

from incontext.solver import solve
from incontext.solver.initial import views
from incontext.solver.problem import build_problem
from incontext.solver.starting.drawn_lines import Agreement, drawn_lines, gathered
from incontext.solver.starting.turned_views import STEPS, turned_views
from incontext.solver.structure import build_structure
from incontext.solver.synthetic import FAMILIES, Hand, Views, photograph

EYE_LEVEL = Views(elevation_deg=(0.0, 2.0), azimuth_deg=(-91.0, -89.0))
HEXAGONAL = list(FAMILIES).index("hexagonal box")


def hexagonal(run: int):
    """Drawn at eye level: only the vertical and one level direction tell the view."""
    rng = np.random.default_rng([run, HEXAGONAL])
    shape = FAMILIES["hexagonal box"](rng)
    return photograph(shape, rng, hand=Hand(0.005), views=EYE_LEVEL, focal_known=True)


@pytest.mark.parametrize("run", [6065, 6082])
def test_a_hexagonal_box_at_eye_level_is_found(run):
    photo = hexagonal(run)
    solution = solve(photo.graph)
    assert solution.message == "Solved."
    assert photo.error(solution.vertices_mm) < 0.03


def test_cameras_are_turned_by_standard_errors():
    # By k of them the sum of squares grows by k^2 times what each spare line has.
    problem = build_problem(hexagonal(0).graph, build_structure(hexagonal(0).graph))
    best = next(views(problem))
    lines = drawn_lines(problem)
    agreement = Agreement(gathered(lines, lines.lengths(), best.log_focal))
    turned = list(turned_views(problem, best.R, best.log_focal))
    assert len(turned) == len(STEPS)
    for k, (R, log_focal) in zip(STEPS, turned, strict=True):
        assert log_focal == best.log_focal
        grown = agreement.costs(R[None], log_focal)[0] / best.misfit - 1
        assert grown == pytest.approx(k * k / (len(lines) - 3), rel=0.4)
