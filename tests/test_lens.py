"""Lens distortion: said where straight things bend, and taken out."""

from __future__ import annotations

import json

import numpy as np
import pytest
from PIL import Image
from rectangles import SMALL, camera_at, corners_mm, seen
from scipy.ndimage import gaussian_filter, map_coordinates

from incontext.solver import load_sketch, save_sketch
from incontext.solver.graph import Ellipse, Photo, SketchGraph
from incontext.workbench.cli import main
from incontext.workbench.examples import EXAMPLES, example_path
from incontext.workbench.lens import Lens, lens_of, traced_ends
from incontext.workbench.photos import grey_of, load_photo
from incontext.workbench.radial import Radial
from incontext.workbench.straight_photo import straight_picture, straightened_sketch
from incontext.workbench.straighten_command import lens_of_sketch

CAMERA = camera_at(50, -75, 560, 900, photo=SMALL)
PAPER = (300.0, 280.0)
MIDDLE, HALF = np.array([400.0, 300.0]), 500.0


def drawn_corners(bend, size, rng):
    """Where a person clicks corners in a photo that bends so."""
    lens = Lens(MIDDLE, HALF, bend, 0.0, {})
    return lens.bent(CAMERA.project(corners_mm(size))) + rng.uniform(-1.5, 1.5, (4, 2))


def lines_of(bend, rng):
    found = {}
    for name, size in (("paper", PAPER), ("marker", (100.0, 100.0))):
        c = drawn_corners(bend, size, rng)
        found |= {f"{name}{k}": (c[k], c[(k + 1) % 4]) for k in range(4)}
    return found


@pytest.mark.parametrize("bend", [0.0, 0.04, -0.05])
def test_the_distortion_is_found_to_a_tenth_of_a_percent(bend):
    rng = np.random.default_rng(3)
    lens = lens_of(seen(CAMERA, SMALL, rng, paper_mm=PAPER, bend=bend), lines_of(bend, rng))
    assert lens.k == pytest.approx(bend, abs=1e-3)
    assert lens.sigma < 5e-3
    assert lens.distorts == (bend != 0)
    assert bool(lens.notes) == (bend != 0)


def test_a_small_marker_in_the_middle_tells_nothing_but_the_photo_does():
    rng = np.random.default_rng(3)
    grey = seen(CAMERA, SMALL, rng, paper_mm=PAPER, bend=0.04)
    lines = {n: ends for n, ends in lines_of(0.04, rng).items() if n.startswith("marker")}
    assert not lens_of(grey, lines, edges=()).distorts
    lens = lens_of(grey, lines)
    assert lens.k == pytest.approx(0.04, abs=2e-3)
    assert lens.worst[0] == ""
    assert lens.notes[0].startswith("Long edges in the photo bend by up to 2.")
    assert lens_of(np.full((600, 800), 99.0), lines) is None
    noise = lens_of(120 + rng.normal(0, 4, (600, 800)), lines)
    assert noise is None or not noise.distorts


def test_one_bent_thing_is_no_lens():
    rng = np.random.default_rng(3)
    grey = seen(CAMERA, SMALL, rng, paper_mm=PAPER)
    # A bowl's rim along the foot of the photo, which somebody took for straight.
    u, v = np.meshgrid(np.arange(800) + 0.5, np.arange(600) + 0.5)
    grey[v > 560 + 6 * ((u - 400) / 300) ** 2] = 20.0
    rim = (np.array([100.0, 566.0]), np.array([700.0, 566.0]))
    alone = lens_of(grey, {"rim": rim}, edges=())
    assert alone.bends_px["rim"] > 4
    assert not alone.distorts
    lens = lens_of(grey, lines_of(0.0, rng) | {"rim": rim})
    assert lens.worst[0] == "rim"
    assert not lens.distorts


def bent_example(name, k):
    """The grey photo of an example through a lens, and what is traced in it."""
    path = example_path(name)
    graph = load_sketch(path)
    grey = grey_of(load_photo(graph, path)[0]).astype(float)
    radial = Radial.of(grey, graph.principal_point_px)
    u, v = np.meshgrid(*(np.arange(n) + 0.5 for n in grey.shape[::-1]))
    at = radial.straightened(np.stack([u, v], axis=-1), k) - 0.5
    bent = map_coordinates(grey, [at[..., 1], at[..., 0]], order=1, mode="nearest")
    lines = {e: radial.bent(np.array(ends), k) for e, ends in traced_ends(graph).items()}
    return bent, lines, radial.principal_px


@pytest.mark.parametrize("name", EXAMPLES)
def test_a_photo_of_a_pinhole_camera_has_no_lens_to_straighten(name):
    sketch = example_path(name)
    lens = lens_of_sketch(load_sketch(sketch), sketch)
    assert not lens.distorts
    assert abs(lens.k) < 0.005


@pytest.mark.parametrize(
    ("name", "k"), [("teapot_lid", 0.1), ("chair_box", -0.1), ("chair_box", 0.04)]
)
def test_a_photo_with_few_traced_lines_tells_its_lens(name, k):
    lens = lens_of(*bent_example(name, k))
    assert lens.k == pytest.approx(k, abs=0.005)
    assert "the lens distorts" in lens.notes[0]


def test_a_traced_line_is_named_where_it_bends():
    lens = lens_of(*bent_example("teapot_lid", -0.1))
    assert lens.worst[0] == "e1"
    # It is followed beyond its ends, along the joint between the tiles.
    assert lens.bends_px["e1"] > 5


def test_curved_things_that_do_not_agree_are_no_lens():
    u, v = np.meshgrid(np.arange(800) + 0.5, np.arange(600) + 0.5)
    rng = np.random.default_rng(2)
    for _ in range(6):
        grey = 120 + rng.normal(0, 2, u.shape)
        for x, y, r in rng.uniform([0, 0, 90], [800, 600, 400], (5, 3)):
            grey[np.hypot(u - x, v - y) < r] += rng.choice([-50, 50])
        lens = lens_of(gaussian_filter(grey, 0.8), {})
        assert lens is None or not lens.distorts


def test_the_straight_picture_is_that_of_a_straight_lens():
    rng = np.random.default_rng(5)
    bent = seen(CAMERA, SMALL, rng, paper_mm=PAPER, noise=0.0, bend=0.05)
    straight = seen(CAMERA, SMALL, rng, paper_mm=PAPER, noise=0.0)
    lens = Lens(MIDDLE, HALF, 0.05, 0.0, {})
    found = straight_picture(np.stack([bent] * 3, axis=-1).astype(np.uint8), lens)
    off = np.abs(found[100:500, 150:650, 1].astype(float) - straight[100:500, 150:650])
    # Light falls by the place in the picture, so flat parts differ by a few levels.
    assert np.quantile(off, 0.99) < 20
    before = np.abs(bent[100:500, 150:650] - straight[100:500, 150:650])
    assert off.mean() < 0.5 * before.mean()


def test_the_sketch_moves_with_its_photo():
    lens = Lens(MIDDLE, HALF, 0.05, 0.0, {})
    round_ = Ellipse(((100.0, 100.0), (140.0, 100.0)), ((120.0, 90.0), (120.0, 110.0)))
    graph = SketchGraph(
        photo=Photo("a.jpg", 800, 600),
        vertices={"v1": (400.0, 300.0), "v2": (0.0, 0.0)},
        circles={"c1": round_},
        camera=CAMERA,
    )
    moved = straightened_sketch(graph, lens, "b.jpg")
    assert moved.vertices["v1"] == (400.0, 300.0)
    np.testing.assert_allclose(moved.vertices["v2"], [-20.0, -15.0])
    middle = np.mean(moved.circles["c1"].a, axis=0)
    np.testing.assert_allclose(middle, np.mean(moved.circles["c1"].b, axis=0))
    assert moved.camera is None
    assert moved.photo.file == "b.jpg"


def test_the_command_writes_a_straight_photo_and_sketch(tmp_path, capsys):
    rng = np.random.default_rng(3)
    grey = seen(CAMERA, SMALL, rng, paper_mm=PAPER, bend=0.05)
    Image.fromarray(grey.astype(np.uint8)).save(tmp_path / "desk.jpg", quality=95)
    c = drawn_corners(0.05, PAPER, rng)
    graph = SketchGraph(
        photo=Photo("desk.jpg", 800, 600),
        vertices={f"v{k}": tuple(p) for k, p in enumerate(c.tolist())},
        edges={f"e{k}": (f"v{k}", f"v{(k + 1) % 4}") for k in range(4)},
        construction=("e0", "e1", "e2", "e3"),
    )
    save_sketch(graph, tmp_path / "desk.sketch.json")
    out = tmp_path / "straight.sketch.json"
    main(["check", str(tmp_path / "desk.sketch.json")])
    assert "the lens distorts" in capsys.readouterr().out
    assert main(["straighten", str(tmp_path / "desk.sketch.json"), "-o", str(out)]) == 0
    assert "the lens distorts" in capsys.readouterr().out
    body = json.loads(out.read_text())
    assert (tmp_path / body["photo"]["file"]).is_file()
    found = np.array([*load_sketch(out).vertices.values()])
    np.testing.assert_allclose(found, CAMERA.project(corners_mm(PAPER)), atol=3)
    assert main(["straighten", str(out), "-o", str(tmp_path / "again.sketch.json")]) == 0
    assert "nothing to straighten" in capsys.readouterr().out
