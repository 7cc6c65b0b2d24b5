"""Two readings of one drawing."""

from __future__ import annotations

import numpy as np
import pytest
from asserts import assert_annotations_hold
from scenes import Views, box, l_shape, photograph

from incontext.solver import save_sketch, solve
from incontext.solver.solution import Status
from incontext.workbench import cli

AFAR = Views(fov_deg=(2.0, 4.0))


def floating_in_the_air(make, views, *, noise=0.005, seed=0):
    shape = make().without("ground")
    return photograph(shape, np.random.default_rng(seed), noise=noise, views=views)


@pytest.mark.parametrize("make", [box, l_shape])
@pytest.mark.parametrize("seed", range(3))
def test_without_ground_and_perspective_there_are_two_readings(make, seed):
    photo = floating_in_the_air(make, AFAR, seed=seed)
    both = solve(photo.graph), solve(photo.graph, twin=True)
    for solution in both:
        assert solution.status is Status.CONVERGED
        assert_annotations_hold(solution, 200.0)
    # What is nearest in one is farthest in the other.
    depth = [
        s.camera.rotation_cam_from_world[2] @ np.array(list(s.vertices_mm.values())).T for s in both
    ]
    assert np.corrcoef(depth)[0, 1] < -0.9


def test_most_views_from_afar_are_told_as_twofold():
    told = [
        "fits as well" in solve(floating_in_the_air(make, AFAR, seed=seed).graph).message
        for make in (box, l_shape)
        for seed in range(6)
    ]
    assert sum(told) >= 9


def test_one_of_both_readings_is_the_truth():
    photo = floating_in_the_air(l_shape, AFAR, noise=0.002)
    errors = [photo.error(solve(photo.graph, twin=twin).vertices_mm) for twin in (False, True)]
    assert min(errors) < 0.05
    assert max(errors) > 0.2


def test_perspective_decides():
    photo = floating_in_the_air(l_shape, Views(fov_deg=(55.0, 65.0)), noise=0.001)
    solution = solve(photo.graph)
    assert solution.message == "Solved."
    assert photo.error(solution.vertices_mm) < 0.03


def test_the_ground_decides():
    photo = photograph(box(), np.random.default_rng(0), noise=0.005, views=AFAR)
    solution = solve(photo.graph)
    assert "fits as well" not in solution.message
    other = solve(photo.graph, twin=True)
    assert other.camera.position_mm[2] < 0 < solution.camera.position_mm[2]


def test_the_command_gives_the_twin(tmp_path):
    photo = floating_in_the_air(box, AFAR)
    sketch = tmp_path / "box.sketch.json"
    save_sketch(photo.graph, sketch)
    written = []
    for flags in ([], ["--twin"]):
        assert cli.main(["solve", str(sketch), *flags]) == cli.OK
        written.append((tmp_path / "box.solution.json").read_text())
    assert written[0] != written[1]
