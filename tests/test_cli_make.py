"""The command line against its contract: files, exit status, one line for bad input."""

from __future__ import annotations

import dataclasses
import json
import re
import struct
import subprocess
import sys
from pathlib import Path

import ezdxf
import numpy as np
import pytest
import shapely
from PIL import Image
from scenes import box, loose_house, photograph, wedge

from incontext.solver import save_sketch
from incontext.solver.graph import Photo
from incontext.workbench.cli import main, name_of

LASER = {"dxf", "svg", "step", "plates.json"}
PRINT = {"stl", "3mf", "step"}
BOTH = {"solution.json", "png"}


@pytest.fixture
def sketch(tmp_path) -> Path:
    """A box of 200 x 150 x 120 mm in a folder of its own, with its photo."""
    return write_sketch(tmp_path / "in", box())


def write_sketch(folder: Path, shape, file: str | None = "photo.png", **changes) -> Path:
    folder.mkdir(exist_ok=True)
    graph = photograph(shape, np.random.default_rng(1)).graph
    graph = dataclasses.replace(graph, photo=Photo(file, 1600, 1200), **changes)
    if file == "photo.png":
        Image.new("RGB", (1600, 1200), (120, 130, 140)).save(folder / file)
    path = folder / "desk box.sketch.json"
    save_sketch(graph, path)
    return path


def files_in(folder: Path) -> set[str]:
    return {path.name.removeprefix("desk box.") for path in folder.iterdir()}


def run(capsys, *arguments: object) -> tuple[int, str, list[str]]:
    status = main([str(argument) for argument in arguments])
    caught = capsys.readouterr()
    assert "Traceback" not in caught.err
    return status, caught.out, caught.err.splitlines()


def test_make_writes_plates_by_default(sketch, tmp_path, capsys):
    out = tmp_path / "new" / "folder"
    status, printed, complaints = run(capsys, "make", sketch, "--out", out, "--kerf", 0.1)
    assert (status, complaints) == (0, [])
    assert files_in(out) == LASER | BOTH
    assert {Path(line).name for line in printed.splitlines()} == {p.name for p in out.iterdir()}

    plates = json.loads((out / "desk box.plates.json").read_text(encoding="utf-8"))["plates"]
    assert len(plates) == 6
    assert set(plates[0]) == {
        "id", "faces", "thickness_mm", "outline", "holes", "world_from_plate",
    }  # fmt: skip
    volume = sum(shapely.Polygon(p["outline"], p["holes"]).area * 3 for p in plates)
    assert volume == pytest.approx(200 * 150 * 120 - 194 * 144 * 114, rel=1e-6)
    for plate in plates:
        turn = np.array(plate["world_from_plate"])[:3, :3]
        np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-9)
        assert np.linalg.det(turn) == pytest.approx(1.0)

    document = ezdxf.readfile(out / "desk box.dxf")
    assert len(document.modelspace().query('LWPOLYLINE[layer=="CUT_OUTER"]')) == 6
    with Image.open(out / "desk box.png") as picture:
        assert picture.format == "PNG"
    solution = json.loads((out / "desk box.solution.json").read_text(encoding="utf-8"))
    assert solution["status"] == "converged"


def test_make_print_writes_a_solid(sketch, tmp_path, capsys):
    out = tmp_path / "out"
    status, _, complaints = run(capsys, "make", sketch, "--out", out, "--print", "--wall", 4)
    assert (status, complaints) == (0, [])
    assert files_in(out) == PRINT | BOTH
    data = (out / "desk box.stl").read_bytes()
    count = struct.unpack("<I", data[80:84])[0]
    assert (len(data), count) == (84 + 50 * count, 24)


def test_make_both_keeps_two_steps_apart(sketch, tmp_path, capsys):
    out = tmp_path / "out"
    assert run(capsys, "make", sketch, "--out", out, "--print", "--laser")[0] == 0
    assert files_in(out) == LASER | PRINT | BOTH | {"solid.step"}


def test_the_same_sketch_gives_the_same_drawings(sketch, tmp_path, capsys):
    for name in ("one", "two"):
        assert run(capsys, "make", sketch, "--out", tmp_path / name)[0] == 0
    for ending in LASER | {"png"}:
        one, two = ((tmp_path / n / f"desk box.{ending}").read_bytes() for n in ("one", "two"))
        assert one == two, ending


def test_sheets_and_sides(sketch, tmp_path, capsys):
    out = tmp_path / "out"
    options = ["--sheet", "260x220", "--sheet-files", "--side", "outside", "--thickness", 4]
    assert run(capsys, "make", sketch, "--out", out, *options, "--play", 0.1)[0] == 0
    assert {"dxf", "desk box-2.dxf"} <= files_in(out)


def test_solve_writes_beside_the_sketch_or_where_told(sketch, tmp_path, capsys):
    assert run(capsys, "solve", sketch) == (0, "", [])
    beside = sketch.with_name("desk box.solution.json")
    told = tmp_path / "deep" / "s.json"
    assert run(capsys, "solve", sketch, "-o", told, "--method", "ours")[0] == 0
    one, two = (json.loads(p.read_text(encoding="utf-8")) for p in (beside, told))
    assert one["vertices"] == two["vertices"]


def test_check_says_nothing_about_a_good_sketch(sketch, capsys):
    assert run(capsys, "check", sketch) == (0, "", [])


def test_check_finds_errors_and_warnings(tmp_path, capsys):
    bad = write_sketch(tmp_path / "bad", box(), vertices={}, edges={}, annotations={})
    status, printed, complaints = run(capsys, "check", bad)
    assert (status, complaints) == (2, [])
    assert printed.startswith("error: ")
    warned = write_sketch(tmp_path / "warned", box().without("length"))
    status, printed, _ = run(capsys, "check", warned)
    assert status == 0
    assert all(line.startswith("warning: ") for line in printed.splitlines())
    assert printed


def test_a_sketch_without_a_size_is_made_with_a_warning(tmp_path, capsys):
    path = write_sketch(tmp_path / "in", box().without("length"))
    status, _, complaints = run(capsys, "make", path, "--out", tmp_path / "out")
    assert status == 0
    assert len(complaints) == 1
    assert "100 mm" in complaints[0]


PHOTOS = ["gone.jpg", "../photo.png", "/etc/passwd", "C:\\photo.png", "..\\photo.png", "broken.png"]


@pytest.mark.parametrize(
    ("command", "file"),
    [("make", "broken.png"), *((command, f) for command in ("solve", "check") for f in PHOTOS)],
)
def test_a_photo_that_cannot_be_had_is_a_warning(tmp_path, capsys, command, file):
    Image.new("RGB", (1600, 1200)).save(tmp_path / "photo.png")
    sketch = write_sketch(tmp_path / "in", box(), file)
    (tmp_path / "in" / "broken.png").write_bytes(b"no picture")
    if command == "make":
        status, _, lines = run(capsys, command, sketch, "--out", tmp_path / "out")
    else:
        status, printed, lines = run(capsys, command, sketch)
        lines += printed.splitlines()
    assert status == 0
    if file != "broken.png" or command == "make":
        assert len(lines) == 1
        assert "warning" in lines[0]
        assert file.replace("\\", "/").rsplit("/", 1)[-1] in lines[0]


def test_a_link_that_leads_out_of_the_folder_is_not_followed(tmp_path, capsys):
    Image.new("RGB", (1600, 1200)).save(tmp_path / "secret.png")
    sketch = write_sketch(tmp_path / "in", box(), "link.png")
    (tmp_path / "in" / "link.png").symlink_to(tmp_path / "secret.png")
    _, _, lines = run(capsys, "solve", sketch)
    assert "outside" in lines[0]


GOOD = "<sketch>"
BAD_ARGUMENTS = [
    [],
    ["fold"],
    ["make", GOOD],
    ["make", "gone.sketch.json", "--out", "out"],
    ["solve", "gone.sketch.json"],
    ["check", "gone.sketch.json"],
    ["solve", GOOD, "--method", "magic"],
    ["make", GOOD, "--out", "out", "--thickness", "thick"],
    ["make", GOOD, "--out", "out", "--thickness", "0"],
    ["make", GOOD, "--out", "out", "--thickness", "nan"],
    ["make", GOOD, "--out", "out", "--thickness", "100"],
    ["make", GOOD, "--out", "out", "--kerf", "-1"],
    ["make", GOOD, "--out", "out", "--kerf", "6"],
    ["make", GOOD, "--out", "out", "--play", "inf"],
    ["make", GOOD, "--out", "out", "--finger", "0"],
    ["make", GOOD, "--out", "out", "--sheet", "600"],
    ["make", GOOD, "--out", "out", "--sheet", "axb"],
    ["make", GOOD, "--out", "out", "--sheet", "100x100"],
    ["make", GOOD, "--out", "out", "--sheet", "0x100"],
    ["make", GOOD, "--out", "out", "--side", "left"],
    ["make", GOOD, "--out", "out", "--print", "--wall", "0"],
    ["make", GOOD, "--out", "out", "--print", "--wall", "90"],
    ["make", GOOD, "--out", "out", "--colour", "red"],
]


@pytest.mark.parametrize("arguments", BAD_ARGUMENTS, ids=" ".join)
def test_bad_input_is_one_line_and_leaves_nothing(sketch, tmp_path, capsys, monkeypatch, arguments):
    monkeypatch.chdir(tmp_path)
    before = sorted(tmp_path.rglob("*"))
    status, printed, complaints = run(
        capsys, *(str(sketch) if word == GOOD else word for word in arguments)
    )
    assert (status, printed) == (2, "")
    assert len(complaints) == 1
    assert len(complaints[0]) > 15
    assert sorted(tmp_path.rglob("*")) == before


BAD_TEXTS = {
    "empty": "",
    "no json": "{",
    "a list": "[]",
    "another format": '{"format": "x", "version": 1}',
    "newer": '{"format": "incontext/sketch", "version": 99}',
    "latin": "é".encode("latin-1"),
}


@pytest.mark.parametrize("text", BAD_TEXTS.values(), ids=BAD_TEXTS.keys())
@pytest.mark.parametrize("command", ["make", "solve", "check"])
def test_bad_files(tmp_path, capsys, text, command):
    path = tmp_path / "bad.sketch.json"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    more = ["--out", tmp_path / "out"] if command == "make" else []
    status, _, complaints = run(capsys, command, path, *more)
    assert (status, len(complaints)) == (2, 1)
    assert [p.name for p in tmp_path.iterdir()] == ["bad.sketch.json"]


def test_a_model_of_which_nothing_can_be_made(tmp_path, capsys):
    path = write_sketch(tmp_path / "in", wedge(), faces={})
    status, _, complaints = run(capsys, "make", path, "--out", tmp_path / "out")
    assert (status, len(complaints)) == (2, 1)
    assert not (tmp_path / "out").exists()


def test_a_bad_solve_still_writes_its_solution(tmp_path, capsys):
    path = write_sketch(tmp_path / "in", box(), annotations={})
    out = tmp_path / "out"
    status, _, complaints = run(capsys, "make", path, "--out", out)
    assert (status, len(complaints)) == (3, 1)
    assert files_in(out) == {"solution.json"}
    assert run(capsys, "solve", path)[0] == 3
    solution = json.loads(path.with_name("desk box.solution.json").read_text(encoding="utf-8"))
    assert solution["status"] != "converged"


def test_a_folder_that_cannot_be_made(sketch, tmp_path, capsys):
    (tmp_path / "file").write_text("")
    status, _, complaints = run(capsys, "make", sketch, "--out", tmp_path / "file" / "out")
    assert (status, len(complaints)) == (2, 1)


def test_names():
    assert name_of(Path("a/b.sketch.json")) == "b"
    assert name_of(Path("b.json")) == "b"
    assert name_of(Path("b")) == "b"


def test_help_does_not_wait_for_libraries():
    code = (
        "import sys; from incontext.workbench.cli import main; main(['make', '--help']);"
        "assert not {'numpy', 'shapely', 'cadquery', 'PIL'} & set(sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True, timeout=60
    )
    assert "--thickness MM" in done.stdout


def test_as_a_module(sketch):
    command = [sys.executable, "-m", "incontext.workbench", "check", str(sketch)]
    assert subprocess.run(command, check=False, timeout=60).returncode == 0


def test_a_loop_that_is_not_flat_is_named_where_a_print_lacks_its_face(tmp_path, capsys):
    sketch, out = tmp_path / "house.sketch.json", tmp_path / "out"
    save_sketch(loose_house(0.004, slope_told=True), sketch)
    status, _, complaints = run(capsys, "make", sketch, "--out", out, "--print")
    assert (status, files_in(out) if out.exists() else set()) == (2, set())
    (line,) = complaints
    assert "the faces do not close" in line
    assert re.search(r"the loop v0 v1 v2 v3 v4 is 0\.[12]\d mm from flat, and so no face", line)
