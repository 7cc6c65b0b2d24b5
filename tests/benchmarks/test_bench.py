"""The benchmark's table and pictures, on the smallest shapes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image
from scenes import SHAPES, box, l_shape

from incontext.solver.reference import METHODS, Limits
from incontext.solver.synthetic import organizer
from incontext.workbench import cli
from incontext.workbench.bench import Options, bench, pictures, solvespace, write_pictures
from incontext.workbench.bench.options import cube
from incontext.workbench.bench.running import in_words
from incontext.workbench.bench.timing import speed

HASTY = Limits(evaluations_per_dimension=20, restarts=1)
SMALL = Options((cube, l_shape), noises=(0.0, 0.01), runs=1, limits=HASTY)

needs_slvs = pytest.mark.skipif(bool(solvespace.missing()), reason="slvs is not installed")


def rows(options: Options) -> list[list[str]]:
    lines = list(bench(options))
    return [line.split() for line in lines[lines.index("") + 2 :]]


def test_table_has_every_shape_noise_and_method():
    found = rows(SMALL)
    reference = [row for row in found if "slvs" not in row]
    assert len(reference) == 2 * 2 * (1 + len(METHODS))
    ours = [row for row in found if "ours" in row]
    assert all(row[-6] == "1/1" for row in ours)
    assert all(row[-1] == "1" for row in ours)
    assert {row[0] for row in found} == {"cube", "L"}


@needs_slvs
def test_table_has_one_line_of_slvs_for_each_shape():
    assert len([row for row in rows(SMALL) if "slvs" in row]) == 2


def test_table_does_without_slvs(monkeypatch):
    monkeypatch.setattr(solvespace.importlib.util, "find_spec", lambda name: None)
    lines = list(bench(replace(SMALL, shapes=(cube,), noises=(0.0,))))
    assert any("not installed" in line for line in lines)
    assert not any(line.startswith("cube") and "slvs" in line for line in lines)


def test_table_is_the_same_apart_from_times():
    options = replace(SMALL, shapes=(cube,))

    def told() -> list[list[str]]:
        return [row[:-3] for row in rows(options)]  # without the time, its unit and the ratio

    assert told() == told()


@needs_slvs
@pytest.mark.parametrize("make", SHAPES, ids=[make().name for make in SHAPES])
def test_picked_constraints_are_independent_and_hold_on_the_truth(make):
    shape = make()
    task = solvespace.independent_constraints(shape)
    J = np.array([solvespace._row(shape.X, c) for c in task.constraints])
    J = J / np.linalg.norm(J, axis=1)[:, None]
    assert np.linalg.matrix_rank(J) == len(J)
    start = solvespace.displaced(shape, np.random.default_rng(0))
    error, _ = solvespace.measure(task, shape, start)
    assert error is not None
    assert error < 0.03


def test_a_box_needs_all_but_its_level_moves_and_two_sizes():
    # 24 numbers: two shifts and a turn on the ground, width and height are left free by one length.
    task = solvespace.independent_constraints(box())
    assert len(task.constraints) == 24 - 3 - 2


def test_speed_tells_times_growth_and_ratios(monkeypatch):
    of_speed = "incontext.workbench.bench.timing"
    monkeypatch.setattr(f"{of_speed}.table", l_shape)
    monkeypatch.setattr(f"{of_speed}.GROWING", (l_shape, organizer))
    monkeypatch.setattr(f"{of_speed}.COMPARED", (l_shape,))
    monkeypatch.setattr(f"{of_speed}.ENOUGH", 1)
    lines = list(speed((cube,), 1))
    for name in ("cube", "L", "organizer 6"):
        rows = [line[len(name) :].split() for line in lines if line.startswith(f"{name} ")]
        assert [row[1] for row in rows] == ["0", "0.5"]
        assert all(float(ms) > 0 for row in rows for ms in row[-5:])
    assert sum(line.startswith("growth") for line in lines) == 2
    (paper,) = (line for line in lines if line.startswith("lau2010"))
    assert "stopped" in paper
    assert sum(line.startswith("slvs") for line in lines) == 1


@pytest.mark.parametrize(("ms", "text"), [(0.5, "0.50 ms"), (2500.0, "2.50 s")])
def test_times_have_their_unit(ms, text):
    assert in_words(ms) == text


def test_pictures_are_written(tmp_path, monkeypatch):
    monkeypatch.setattr(pictures, "LIMITS", HASTY)
    for path in write_pictures(tmp_path / "bench"):
        with Image.open(path) as image:
            assert image.width > 1000
            assert len(image.getcolors(1 << 20)) > 10


def test_the_command_refuses_no_runs_in_one_line(capsys):
    assert cli.main(["bench", "--runs", "0"]) == cli.BAD_INPUT
    assert len(capsys.readouterr().err.splitlines()) == 1


def test_the_command_prints_the_table(monkeypatch, capsys):
    monkeypatch.setattr(Options, "quick", staticmethod(lambda: replace(SMALL, shapes=(cube,))))
    assert cli.main(["bench", "--quick", "--runs", "1"]) == cli.OK
    assert "lipson1996" in capsys.readouterr().out
