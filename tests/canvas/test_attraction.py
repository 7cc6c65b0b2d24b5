"""The grid on the ground and the edges of the photo: where they lead the pen."""

import math
from pathlib import Path

import numpy as np
import pytest

from incontext.solver import load_sketch, solve
from incontext.solver.graph import SketchGraph
from incontext.tests.canvas.test_tools import Hand
from incontext.workbench.canvas.ground_grid import ground_grid, nice_below
from incontext.workbench.canvas.perspective import on_plane
from incontext.workbench.canvas.photo_edges import Patch, photo_snap
from incontext.workbench.canvas.snapping import SnapKind
from incontext.workbench.canvas.solved import Solved

SHELF = load_sketch(Path(__file__).parent.parent / "data" / "shelf.sketch.json")
SIDE = 50


@pytest.fixture(scope="module")
def solved():
    return Solved(SHELF, solve(SHELF))


@pytest.fixture
def grid(solved):
    return ground_grid(solved.solution.camera, solved.solution.vertices_mm.values())


def on_ground(grid, place_px):
    return on_plane(grid.camera, place_px, np.zeros(3), np.array([0.0, 0.0, 1.0]))


@pytest.mark.parametrize(("length", "nice"), [(37, 20), (50, 50), (9.9, 5), (0.3, 0.2), (100, 100)])
def test_spacing_is_a_number_that_people_count_by(length, nice):
    assert nice_below(length) == pytest.approx(nice)


def test_lines_lie_on_the_ground_about_the_object(grid, solved):
    fine, strong = grid.lines_px
    assert len(strong) < len(fine) < 80
    for start, end in (*fine, *strong):
        places = np.array([on_ground(grid, p)[:2] for p in (start, end)]) / grid.spacing_mm
        constant = abs(places[0] - places[1]).argmin()
        assert places[0, constant] == pytest.approx(places[1, constant], abs=1e-6)
        assert places[0, constant] == pytest.approx(round(places[0, constant]), abs=1e-6)
    middle = np.mean([solved.solution.vertices_mm[v] for v in ("v0", "v1", "v2", "v3")], axis=0)
    assert (grid.first * grid.spacing_mm < middle[:2]).all()
    assert (grid.last * grid.spacing_mm > middle[:2]).all()


def test_pen_sticks_to_crossings_then_to_lines(grid):
    cell = np.rint((grid.first + grid.last) / 2)
    crossing = grid._px(cell)
    at = grid.snap((crossing[0] + 2, crossing[1] + 1), 5.0)
    assert (at.kind, at.point_px, at.guide) == (SnapKind.GRID, pytest.approx(crossing), None)
    half = grid._px(np.add(cell, (0.5, 0.0)))
    at = grid.snap((half[0] + 0.3, half[1] + 1.0), 2.0)
    assert on_ground(grid, at.point_px)[1] == pytest.approx(cell[1] * grid.spacing_mm, abs=1e-6)
    assert at.guide is not None
    middle = grid._px(np.add(cell, (0.5, 0.5)))
    assert grid.snap(middle, 1.0) is None
    assert grid.snap(grid._px(grid.last + 2), 5.0) is None


def test_no_grid_where_the_ground_is_not_seen_from_above(solved):
    camera = solved.solution.camera
    from_below = type(camera)(
        camera.focal_px,
        camera.principal_point_px,
        camera.rotation_cam_from_world,
        -camera.translation_cam_from_world_mm,
    )
    assert ground_grid(from_below, solved.solution.vertices_mm.values()) is None
    assert ground_grid(camera, []).spacing_mm > 0


def test_rectangle_on_the_grid_has_whole_spacings(solved, grid):
    hand = Hand(SHELF, "rectangle")
    hand.drawing.set_solved(solved)
    hand.drawing.attraction.grid_shown = True
    assert hand.drawing.grid.spacing_mm == grid.spacing_mm
    start = np.array([grid.last[0] - 2, grid.first[1] + 1])
    ends = [grid._px(start), grid._px(np.add(start, (-2, 1)))]
    hand.drag(*((u + 1.5, v - 1.0) for u, v in ends))
    new = [v for v in hand.graph.vertices if v not in SHELF.vertices]
    places = [on_ground(grid, hand.graph.vertices[v])[:2] / grid.spacing_mm for v in new]
    assert len(places) == 4
    assert np.array(places) == pytest.approx(np.rint(places), abs=1e-4)


def patch(paint, noise=3.0):
    """A window of a photo with its corner at (100, 200), two px of the photo for one of it."""
    down, across = np.mgrid[0:SIDE, 0:SIDE] + 0.5
    grey = paint(across, down) + np.random.default_rng(5).normal(0, noise, (SIDE, SIDE))
    return Patch(grey, (100.0, 200.0), 2.0)


HERE = (100.0 + SIDE, 200.0 + SIDE)


@pytest.mark.parametrize("degrees", [0, 17, 45, 77, 90, 133])
def test_pen_sticks_to_a_straight_edge_within_a_fraction_of_a_px(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def step(x, y):
        return 80 + 90 / (1 + np.exp(-((x - 25) * c + (y - 25) * s - 3.3) / 0.6))

    at = photo_snap(patch(step), HERE, 18.0)
    off = (at.point_px[0] - HERE[0]) * c + (at.point_px[1] - HERE[1]) * s
    assert (at.kind, off) == (SnapKind.PHOTO_EDGE, pytest.approx(6.6, abs=0.3))


def test_pen_sticks_to_a_corner():
    at = photo_snap(patch(lambda x, y: np.where((x > 28) & (y > 22), 180.0, 80.0)), HERE, 18.0)
    assert at.kind is SnapKind.PHOTO_CORNER
    assert at.point_px == pytest.approx((156.0, 244.0), abs=0.5)


@pytest.mark.parametrize(
    "paint",
    [
        lambda x, y: 100.0 + 0 * x,
        lambda x, y: np.where(np.hypot(x - 25, y - 12) < 12, 180.0, 80.0),
        lambda x, y: np.where(x > 48, 180.0, 80.0),
    ],
    ids=["noise", "a small round thing", "too far away"],
)
def test_nothing_attracts_where_no_straight_edge_is_near(paint):
    assert photo_snap(patch(paint), HERE, 18.0) is None


def test_edges_of_the_photo_attract_only_when_asked_to():
    hand = Hand(SketchGraph(), "line")
    window = patch(lambda x, y: np.where(x > 28, 180.0, 80.0))
    hand.drawing.attraction.patch = lambda place, reach: window
    hand.drawing.move(hand.at(*HERE))
    assert hand.drawing.preview.snap.kind is SnapKind.FREE
    hand.drawing.attraction.photo_edges = True
    hand.drawing.move(hand.at(HERE[0] + 1, HERE[1]))
    assert hand.drawing.preview.snap.kind is SnapKind.PHOTO_EDGE
    hand.click(*HERE)
    hand.click(HERE[0], HERE[1] + 30)
    assert [u for u, _ in hand.graph.vertices.values()] == pytest.approx([156, 156], abs=0.5)


def test_a_dragged_vertex_sticks_too():
    hand = Hand(SHELF)
    window = patch(lambda x, y: np.where(x > 28, 180.0, 80.0))
    hand.drawing.attraction.patch = lambda place, reach: window
    hand.drawing.attraction.photo_edges = True
    hand.drag(SHELF.vertices["v8"], HERE)
    assert hand.graph.vertices["v8"] == pytest.approx((156.0, HERE[1]), abs=0.6)
