"""The camera from a rectangle of known size: exact, as sure as it says, and honest where unsure."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from rectangles import PHOTO, camera_at, corners_mm, turned_alike
from scenes import box, photograph_exactly, v

from incontext.solver import SketchError, solve
from incontext.solver.graph import Photo
from incontext.solver.perspective.marker import RECTANGLES, camera_from_rectangle
from incontext.solver.perspective.plane_pose import PlanePose, Sight

SQUARE = (100.0, 100.0)
EXACT_PX = 0.01


def random_camera(rng, size, photo=PHOTO):
    return camera_at(
        rng.uniform(20, 70),
        rng.uniform(-180, 180),
        rng.uniform(3, 6) * max(size),
        rng.uniform(900, 2600),
        roll_deg=rng.uniform(-10, 10),
        photo=photo,
    )


@pytest.mark.parametrize("size", [SQUARE, *RECTANGLES.values()], ids=str)
def test_exact_corners_give_the_camera_exactly(size):
    rng = np.random.default_rng(3)
    for _ in range(5):
        camera = random_camera(rng, size)
        corners = camera.project(corners_mm(size))[rng.permutation(4)]
        view = camera_from_rectangle(PHOTO, corners, size, corner_sigma_px=EXACT_PX)
        assert view.focal_from == "corners"
        assert view.camera.focal_px == pytest.approx(camera.focal_px, rel=1e-9)
        near = camera.translation_cam_from_world_mm
        np.testing.assert_allclose(
            view.camera.translation_cam_from_world_mm, near, atol=1e-9 * near[2]
        )
        np.testing.assert_allclose(
            turned_alike(camera, view.camera), camera.rotation_cam_from_world, atol=1e-9
        )


@pytest.mark.parametrize("size", [SQUARE, RECTANGLES["A4"], RECTANGLES["A4"][::-1]], ids=str)
def test_the_frame_is_the_rectangles(size):
    camera = camera_at(40, -70, 900, 1500)
    view = camera_from_rectangle(
        PHOTO, camera.project(corners_mm(size))[[2, 0, 3, 1]], size, corner_sigma_px=EXACT_PX
    )
    np.testing.assert_allclose(view.camera.project(view.corners_mm), view.corners_px, atol=1e-6)
    ahead = view.camera.project([[0, 0, 0], [1, 0, 0], [0, 0, 1]])
    assert ahead[1, 0] > ahead[0, 0], "x points right"
    assert ahead[2, 1] < ahead[0, 1], "z points up"
    # Seen from -70 degrees, the world's own x points right: nothing has been turned.
    assert view.size_mm == size


def test_told_focal_length_settles_what_corners_leave_open():
    """Seen square-on, any focal length explains the corners."""
    camera = camera_at(89.9, -90, 800, 1500)
    corners = camera.project(corners_mm(SQUARE))
    alone = camera_from_rectangle(PHOTO, corners, SQUARE)
    assert alone.focal_from == "usual"
    assert alone.focal_sigma > 0.2
    assert "square-on" in alone.notes[0]
    told = camera_from_rectangle(replace(PHOTO, focal_px=1500.0), corners, SQUARE)
    assert told.focal_from == "photo"
    assert told.camera.focal_px == pytest.approx(1500, rel=1e-6)
    assert told.camera.position_mm[2] == pytest.approx(800, rel=1e-3)
    assert [note for note in told.notes if "straight above" in note] == list(told.notes)


def test_a_cropped_photo():
    photo = Photo(None, 1200, 1200, principal_point_px=(400.0, 700.0))
    camera = camera_at(35, 20, 500, 1500, photo=photo)
    view = camera_from_rectangle(
        photo, camera.project(corners_mm(SQUARE)), SQUARE, corner_sigma_px=EXACT_PX
    )
    assert view.camera.focal_px == pytest.approx(1500, rel=1e-9)
    assert view.camera.principal_point_px.tolist() == [400.0, 700.0]


def draws(camera, size, sigma_px, photo=PHOTO, runs=300):
    rng = np.random.default_rng(11)
    exact = camera.project(corners_mm(size))
    for _ in range(runs):
        corners = exact + rng.normal(0, sigma_px, (4, 2))
        yield camera_from_rectangle(photo, corners, size, corner_sigma_px=sigma_px)


@pytest.mark.parametrize("told", [False, True])
def test_errors_are_at_the_cramer_rao_floor(told):
    """The scatter of the estimates is what the inverse of the Fisher information says."""
    sigma_px = 0.3
    camera = camera_at(35, -60, 420, 1500)
    photo = replace(PHOTO, focal_px=1500.0) if told else PHOTO
    R, t = camera.rotation_cam_from_world, camera.translation_cam_from_world_mm / 100
    truth = PlanePose(R, t, float(np.log(1500 / 800)))
    plane = corners_mm(SQUARE)[:, :2] / 100
    floor = Sight(plane, truth.project(plane), sigma_px / 800).covariance(truth)
    views = list(draws(camera, SQUARE, sigma_px, photo, runs=80))
    if not told:
        scatter = np.std([np.log(view.camera.focal_px) for view in views])
        assert scatter == pytest.approx(np.sqrt(floor[6, 6]), rel=0.25)
        assert np.mean([view.focal_sigma for view in views]) == pytest.approx(scatter, rel=0.25)
    heights = np.array([view.camera.position_mm[2] / camera.position_mm[2] for view in views])
    assert np.std(heights) < (0.01 if told else 1.2 * np.sqrt(floor[6, 6]))
    assert np.mean(heights) == pytest.approx(1, abs=3 * np.std(heights) / np.sqrt(len(views)))


def test_a_height_measured_beside_it_is_as_exact_as_it_says():
    sigma_px = 0.5
    camera = camera_at(35, -60, 500, 1500)
    foot, top = camera.project([[0, 0, 0], [0, 0, 100]])
    found, said = [], []
    for view in draws(camera, SQUARE, sigma_px, runs=50):
        found.append(height_of(view.camera, foot, top))
        said.append(view.size_sigma)
    assert np.std(found) / 100 == pytest.approx(np.mean(said), rel=0.25)
    assert np.std(found) < 2.0


def height_of(camera, foot, top):
    """Of an upright edge that stands where the camera sees its foot on the ground."""
    rays = np.array([[*(p - camera.principal_point_px) / camera.focal_px, 1] for p in (foot, top)])
    rays = rays @ camera.rotation_cam_from_world
    eye = camera.position_mm
    on_ground = eye - rays[0] * eye[2] / rays[0, 2]
    A = np.column_stack([[0, 0, 1], -rays[1]])
    return np.linalg.lstsq(A, eye - on_ground, rcond=None)[0][0]


def test_a_far_rectangle_of_known_focal_length_may_lean_either_way():
    photo = replace(PHOTO, focal_px=1500.0)
    camera = camera_at(45, -80, 5000, 1500)
    corners = camera.project(corners_mm(SQUARE))
    view = camera_from_rectangle(photo, corners, SQUARE, corner_sigma_px=1.0)
    assert view.twin is not None
    assert any("leans" in note for note in view.notes)
    # Of the two, that in which things stand upright in the photo.
    up, down = (c.rotation_cam_from_world[1, 2] for c in (view.camera, view.twin))
    assert up < 0 < down
    assert view.camera.position_mm[2] == pytest.approx(camera.position_mm[2], rel=0.05)
    near = camera_at(45, -80, 400, 1500)
    corners = near.project(corners_mm(SQUARE))
    assert camera_from_rectangle(photo, corners, SQUARE, corner_sigma_px=1.0).twin is None


def test_which_side_is_longer_may_be_open():
    camera = camera_at(20, -90, 30000, 1500 * 6)
    size = RECTANGLES["A4"]
    view = camera_from_rectangle(PHOTO, camera.project(corners_mm(size)), size, corner_sigma_px=1.5)
    assert view.sides_unsure == any("longer" in note for note in view.notes)
    assert view.sides_unsure


GOOD = [(500.0, 500.0), (900.0, 520.0), (950.0, 800.0), (450.0, 790.0)]


@pytest.mark.parametrize(
    ("corners", "size", "says"),
    [
        (GOOD[:3], SQUARE, "four corners"),
        ([*GOOD[:3], (np.nan, 1.0)], SQUARE, "four corners"),
        ([*GOOD[:3], GOOD[0]], SQUARE, "one place"),
        ([(100, 100), (200, 200), (300, 300), (400, 400)], SQUARE, "no rectangle"),
        ([(100, 100), (500, 100), (300, 200), (300, 500)], SQUARE, "no rectangle"),
        (GOOD, (100.0, 0.0), "is none"),
        (GOOD, (np.inf, 10.0), "is none"),
        (GOOD, (1000.0, 10.0), "px off any rectangle"),
    ],
)
def test_what_is_no_rectangle_is_refused_in_one_line(corners, size, says):
    with pytest.raises(SketchError, match=says) as caught:
        camera_from_rectangle(PHOTO, corners, size)
    assert "try:" in str(caught.value)


@pytest.mark.parametrize("told", [False, True])
def test_with_the_camera_of_a_marker_dimensions_are_within_two_percent(told):
    """Nothing else gives a length: a box that is drawn with 2 px of error beside the marker."""
    rng = np.random.default_rng(5)
    shape = box().without("length")
    X = shape.X - [100.0, 75.0, 0.0]
    worst = []
    for _ in range(12):
        focal = rng.uniform(1100, 2000)
        camera = camera_at(rng.uniform(25, 45), rng.uniform(-130, -50), 0.8 * focal, focal)
        marker = corners_mm(SQUARE) + np.array([0.0, -150.0, 0.0])
        photo = replace(PHOTO, focal_px=focal * 1.005 if told else None)
        seen = camera.project(marker) + rng.normal(0, 0.15, (4, 2))
        view = camera_from_rectangle(photo, seen, SQUARE, corner_sigma_px=0.15)
        graph = photograph_exactly(replace(shape, X=X), camera)
        places = np.array([*graph.vertices.values()]) + rng.normal(0, 1.0, (len(X), 2))
        drawn = dict(zip(graph.vertices, map(tuple, places.tolist()), strict=True))
        graph = replace(graph, photo=photo, vertices=drawn, camera=view.camera)
        solution = solve(graph)
        assert not solution.scale_assumed
        found = np.array([solution.vertices_mm[v(i)] for i in range(8)])
        worst.append(np.abs(np.ptp(found, axis=0) / np.ptp(X, axis=0) - 1).max())
    assert np.median(worst) < 0.02
