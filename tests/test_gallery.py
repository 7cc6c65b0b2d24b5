"""The gallery: its light, its table, and that what is in the repository is of today's examples."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from incontext.solver import load_sketch
from incontext.workbench.examples import EXAMPLES, load_example
from incontext.workbench.fabrication.rendering import Scene, View
from incontext.workbench.gallery.lighting import lit
from incontext.workbench.gallery.outcome import cut_length_mm, gestures, outcome
from incontext.workbench.gallery.panels import (
    HIGH_PX,
    SMALL_PX,
    overview,
    panels,
    strip,
    window_around,
)
from incontext.workbench.gallery.table import bench_lines, facts_lines

DOCS = Path(__file__).parent.parent / "resources" / "docs"
#: A square of 40 mm, 20 mm above the ground, and a small one on the ground, seen from above.
ROOF = np.array([[-20, -20, 20], [20, -20, 20], [20, 20, 20], [-20, 20, 20.0]])
FLOOR = ROOF * [0.1, 0.1, 0.0]
DOWN = np.array([[1.0, 0, 0], [0, -1, 0], [0, 0, -1]])


def scene_of(*squares):
    triangles = [square[[a, b, c]] for square in squares for a, b, c in ((0, 1, 2), (0, 2, 3))]
    faces = np.repeat(np.arange(1, len(squares) + 1), 2).astype(np.int32)
    return Scene(np.array(triangles), faces, np.full((len(triangles), 3), 200.0))


@pytest.fixture(scope="module")
def shelf():
    return outcome(load_example("bookshelf"))


@pytest.fixture(scope="module")
def pictures(shelf):
    return panels(shelf)


def test_object_is_where_the_camera_sees_it_and_throws_a_shadow_away_from_the_light():
    view = View(np.array([0.0, 0, 500]), DOWN, 480.0, np.array([100.0, 100]))
    page = Image.new("RGB", (200, 200), "white")
    # Light from the left: x to the right, y down and z forward in the camera.
    found = np.asarray(lit(scene_of(FLOOR, ROOF), view, page, (-1.0, 0.0, -0.6)).convert("L"), int)
    changed = np.abs(found - 255) > 3
    assert changed[81:119, 81:119].all()
    left, right = found[100, 40:75], found[100, 125:160]
    assert right.min() < left.min() - 20
    # What is far away is as it was.
    assert found[:20].min() > 245


def test_what_lies_below_another_thing_is_darker():
    view = View(np.array([0.0, 0, 500]), DOWN, 480.0, np.array([100.0, 100]))
    page = Image.new("RGB", (200, 200), "white")
    open_ = np.asarray(lit(scene_of(FLOOR), view, page, (0.0, 0.0, -1.0)).convert("L"), int)
    aside = ROOF + np.array([18.0, 0, 0])
    under = np.asarray(lit(scene_of(FLOOR, aside), view, page, (1.0, 0.0, -1.0)).convert("L"), int)
    assert under[100, 98] < open_[100, 98] - 10


def test_strip_shows_five_pictures_side_by_side(pictures):
    found = pictures
    assert [picture.height for picture in found] == [HIGH_PX] * 5
    row = strip(found)
    assert row.width > sum(picture.width for picture in found)
    in_place, photo = np.asarray(found[3], int), np.asarray(found[0], int)
    share = (np.abs(in_place - photo).max(axis=2) > 25).mean()
    assert 0.03 < share < 0.4


def test_books_stay_in_front_of_the_shelf(shelf, pictures):
    found = pictures
    (ring,) = shelf.example.in_front
    u, v = (np.mean(ring, axis=0) * HIGH_PX / 1200).astype(int)
    spot = (slice(v - 8, v + 8), slice(u - 8, u + 8))
    assert np.abs(np.asarray(found[3], int)[spot] - np.asarray(found[0], int)[spot]).max() < 25


def test_facts_of_the_bookshelf(shelf):
    assert shelf.facts["plates"] == 6
    assert cut_length_mm(shelf.sheets) == pytest.approx(7006, rel=0.01)
    (row,) = list(facts_lines([shelf]))[2:]
    assert "6 plates, 11 joints" in row
    assert shelf.checks[0].standing.stands


def test_gestures_are_lines_clicks_and_faces():
    shelf = load_sketch(load_example("bookshelf").sketch_path)
    # 20 lines, four clicks for the ground, two for faces left out, one length, and right angles.
    assert 20 + 4 + 2 + 2 < gestures(shelf) < 45
    saucer = load_sketch(load_example("cup_saucer").sketch_path)
    assert gestures(saucer) == 3 + 2


def test_bench_names_every_example_and_the_papers_users():
    *lines, _, first, second = bench_lines()
    assert "a marker of 100 mm" in first
    assert float(second.split("at most ")[1].split()[0]) < 2
    rows = [line for line in lines if not line.startswith(" ")][3:]
    assert [row.split()[0] for row in rows] == list(EXAMPLES)
    assert any("-8 to +4 %" in line for line in lines)
    off = [float(line.split("%")[0].split()[-1]) for line in lines[3:]]
    assert max(map(abs, off[:2])) < 5
    assert len(off) == len(lines) - 3


def test_overview_shows_objects_in_rows():
    page = overview([Image.new("RGB", (40, 30), "grey")] * 6)
    assert page.width > 3 * SMALL_PX[0]
    assert 2 * SMALL_PX[1] < page.height < 3 * SMALL_PX[1]
    with Image.open(DOCS / "gallery" / "overview.jpg") as shown:
        assert shown.size == page.size


@pytest.mark.parametrize("middle", [(800, 600), (30, 40), (1590, 20), (900, 1190)])
def test_close_up_is_a_part_of_the_photo_around_the_object(middle):
    seen = np.array([[-60.0, -40], [60, 40]]) + middle
    left, top, wide, high = window_around(seen, (1600, 1200))
    assert min(left, top) >= 0
    assert np.all(np.add((left, top), (wide, high)) <= (1600, 1200))
    assert wide == pytest.approx(4 / 3 * high, rel=0.02)
    inside = np.clip(seen, 0, (1600, 1200))
    assert np.all(inside >= (left, top))
    assert np.all(inside <= (left + wide, top + high))


def test_gallery_in_the_repository_has_every_example():
    page = (DOCS / "gallery.md").read_text(encoding="utf-8")
    for name in EXAMPLES:
        example = load_example(name)
        assert f"## {example.title}" in page
        assert example.about in page
        with Image.open(DOCS / "gallery" / f"{name}.jpg") as picture:
            assert picture.height == HIGH_PX
