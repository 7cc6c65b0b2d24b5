"""A seeded slice of the study, with bounds that a step back would break."""

from __future__ import annotations

import numpy as np
import pytest
from scenes import FAMILIES, Hand

from incontext.workbench import cli
from incontext.workbench.bench import study as study_lines
from incontext.workbench.bench.accuracy import (
    AFAR,
    FRONTAL,
    FRONTAL_BOXES,
    PERSON,
    RIGHT,
    ROLLED,
    WRONG_BASIN,
    Case,
    run,
)
from incontext.workbench.bench.turned_study import turned_errors


@pytest.mark.parametrize("case", [Case("exact"), Case("rolled", views=ROLLED)], ids=str)
def test_exact_drawings_give_the_exact_shape(case):
    found = run(case, 2)
    assert found.errors.max() < 1e-8
    assert found.worst_angle_deg < 1e-9


def test_exact_drawings_from_afar_give_the_exact_shape():
    assert run(Case("from afar", views=AFAR), 1).errors.max() < 1e-8


def test_careless_drawings_end_near_the_truth():
    found = run(Case("1 %", Hand(0.01)), 2)
    assert found.over(WRONG_BASIN) == 0
    assert found.over(RIGHT) <= 12
    assert 100 * np.median(found.errors) < 1.2


def test_a_known_focal_length_helps_careless_drawings():
    found = run(Case("1 %, EXIF", Hand(0.01), focal_known=True), 2)
    assert found.over(RIGHT) <= 8
    assert 100 * np.median(found.errors) < 1.1


@pytest.mark.parametrize("told", [{}, {"focal_known": True}, {"traced": "aligned"}], ids=str)
def test_a_persons_drawings_are_never_taken_for_another_shape(told):
    found = run(Case("person", PERSON, **told), 1)
    assert found.over(WRONG_BASIN) == 0
    assert np.quantile(found.errors, 0.9) < (0.04 if told else 0.06)


def test_frontal_views_need_the_focal_length_from_exif():
    hand = Hand(0.005)
    known = run(Case("frontal", hand, FRONTAL, True, families=FRONTAL_BOXES), 12)
    assert known.over(RIGHT) == 0
    assert not known.unsure.any()
    free = run(Case("frontal", hand, FRONTAL, families=FRONTAL_BOXES), 12)
    assert free.unsure[free.errors > 2 * WRONG_BASIN].all()
    assert free.unsure.mean() > 0.5


def test_lids_are_right():
    assert turned_errors(0.0, False, 6).max() < 1e-9
    assert np.mean(turned_errors(0.005, True, 12) < RIGHT) >= 0.9


def test_the_study_says_what_it_measured(monkeypatch):
    monkeypatch.setattr("incontext.workbench.bench.accuracy.NOISY_CASES", ())
    monkeypatch.setattr("incontext.workbench.bench.accuracy.PERSONS", ())
    monkeypatch.setattr("incontext.workbench.bench.accuracy.FRONTAL_CASES", ())
    monkeypatch.setattr("incontext.workbench.bench.accuracy.turned_lines", lambda runs: iter(()))
    lines = list(study_lines(1))
    assert any("100.0 % of 12 within 1e-8" in line for line in lines)
    assert len(FAMILIES) == 12


def test_the_command_prints_the_study(monkeypatch, capsys):
    monkeypatch.setattr("incontext.workbench.bench.study", lambda runs: iter([f"{runs} drawings"]))
    assert cli.main(["bench", "--study", "--runs", "3"]) == cli.OK
    assert capsys.readouterr().out == "3 drawings\n"
