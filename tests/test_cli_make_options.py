"""Every option of make: what it changes, and one line for what cannot be."""

from __future__ import annotations

import csv

import pytest
from PIL import Image
from scenes import box
from test_cli_make import BOTH, LASER, PRINT, files_in, run, write_sketch


@pytest.fixture
def sketch(tmp_path):
    return write_sketch(tmp_path / "in", box())


def test_all_extra_files(sketch, tmp_path, capsys):
    out = tmp_path / "out"
    status, _, complaints = run(
        capsys, "make", sketch, "--out", out, "--page", "A4", "--price", 4.5, "--coupon",
        "--assembly", "--preset", "lightburn", "--relief", "tbone", "--tool", 2, "--grain", "y",
    )  # fmt: skip
    assert (status, complaints) == (0, [])
    more = {"pdf", "parts.csv", "coupon.dxf", "coupon.svg", "assembly.txt", "exploded.png"}
    assert files_in(out) == LASER | BOTH | more
    steps = (out / "desk box.assembly.txt").read_text(encoding="utf-8").splitlines()
    assert len(steps) == 6
    assert steps[0].startswith("1. begin with f")
    rows = list(
        csv.DictReader((out / "desk box.parts.csv").read_text(encoding="utf-8").splitlines())
    )
    assert rows[-1]["kind"] == "total"
    assert float(rows[-1]["price"]) == 4.5 * sum(row["kind"] == "sheet" for row in rows)
    assert "C02" in (out / "desk box.dxf").read_text(encoding="cp1252")
    with Image.open(out / "desk box.exploded.png") as picture:
        assert picture.size == (1200, 900)


def test_explain_says_sizes_and_joints(sketch, tmp_path, capsys):
    status, printed, complaints = run(
        capsys, "make", sketch, "--out", tmp_path / "out", "--explain", "--kerf", 0.2, "--play", 0.1
    )
    assert (status, complaints) == (0, [])
    assert "slot: 12.1 x 3.1 mm, its cut path 11.9 x 2.9 mm" in printed
    assert printed.count("finger between") == 12


def test_joints_by_edge(sketch, tmp_path, capsys):
    out = tmp_path / "out"
    status, printed, complaints = run(
        capsys, "make", sketch, "--out", out, "--explain", "--joint", "e1=butt", "--joint",
        "e2=finger,finger=8",
    )  # fmt: skip
    assert (status, complaints) == (0, [])
    assert printed.count("butt between") == 1
    assert "e1: butt between" in printed


def test_what_is_not_usual_is_noted(sketch, tmp_path, capsys):
    status, _, complaints = run(
        capsys, "make", sketch, "--out", tmp_path / "out", "--thickness", 35
    )
    assert status == 0
    assert complaints
    assert all(line.startswith("note: ") and "fingers need" in line for line in complaints)


def test_prints(sketch, tmp_path, capsys):
    out = tmp_path / "out"
    status, _, complaints = run(
        capsys, "make", sketch, "--out", out, "--print", "--solid", "--bed", "120x120x120"
    )
    assert status == 0
    assert files_in(out) == PRINT | BOTH
    assert complaints == [
        "note: the print is 150 x 200 x 120 mm, larger than the printer's 120 x 120 x 120 mm; "
        "try: a larger printer, or several parts"
    ]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--joint", "e1=glue"], "there is no joint 'glue' (e1)"),
        (["--joint", "e99=butt"], "no two plates meet there (e99)"),
        (["--joint", "e1=half_lap"], "no half lap joint can be made"),
        (["--relief", "round"], "there is no corner relief 'round'"),
        (["--relief", "dogbone", "--tool", 16], "no room for a cutter of 16 mm"),
        (["--grain", "up"], "there is no grain 'up'"),
        (["--preset", "fast"], "there is no preset 'fast'"),
        (["--page", "A9"], "there is no page 'A9'"),
        (["--speed", 0], "cutting speed is 0 mm/s"),
        (["--price", -1], "price of a sheet is -1"),
        (["--margin", -1], "margin is -1 mm"),
        (["--print", "--wall", 0.2], "thinner than the least wall of 0.4 mm"),
        (["--print", "--wall", 70], "the shape measures 120 mm here"),
        (["--print", "--tolerance", 0], "tolerance is 0 mm"),
        (["--bed", "200x200"], "'200x200' is no size like 250x210x210"),
    ],
)
def test_one_line_for_what_cannot_be(sketch, tmp_path, capsys, options, words):
    status, _, complaints = run(capsys, "make", sketch, "--out", tmp_path / "out", *options)
    assert (status, len(complaints)) == (2, 1)
    assert words in complaints[0]
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("kind", "other"),
    [
        ("--laser", ("--wall", 0.1, "--open", "left", "--least-wall", -1)),
        ("--print", ("--kerf", 77, "--finger", 0, "--joint", "glue", "--preset", "nobody")),
    ],
)
def test_settings_of_the_other_machine_stop_nothing(sketch, tmp_path, capsys, kind, other):
    out = tmp_path / "out"
    status, _, _ = run(capsys, "make", sketch, "--out", out, kind, *other)
    assert status == 0
    assert files_in(out) == (LASER if kind == "--laser" else PRINT) | BOTH
    both = run(capsys, "make", sketch, "--out", out, "--laser", "--print", *other)
    assert both[0] == 2
    assert len(both[2]) == 1
