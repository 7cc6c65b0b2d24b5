"""The camera out of photos: the marker found by itself, rectangles by four rough corners."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from rectangles import PHOTO, SMALL, camera_at, corners_mm, seen
from scipy.ndimage import gaussian_filter, shift

from incontext.solver import SketchError
from incontext.workbench import marker_finding, marker_quads
from incontext.workbench.marker_finding import camera_of_corners, marker_corners, seen_corners

SQUARE = (100.0, 100.0)


def camera_of_photo(photo, grey, size_mm, corners_px=None, **how):
    return camera_of_corners(photo, seen_corners(photo, grey, corners_px, **how), size_mm)


@pytest.mark.parametrize("seed", range(2))
def test_the_marker_is_found_by_itself_and_gives_the_camera(seed):
    pytest.importorskip("cv2")
    rng = np.random.default_rng(seed)
    focal = rng.uniform(700, 1000)
    camera = camera_at(
        rng.uniform(25, 60),
        rng.uniform(-180, 180),
        rng.uniform(0.5, 0.8) * focal,
        focal,
        photo=SMALL,
    )
    found = camera_of_photo(SMALL, seen(camera, SMALL, rng), SQUARE)
    true = camera.project(corners_mm(SQUARE))
    ways = [np.abs(np.roll(found.view.corners_px, k, axis=0) - true).max() for k in range(4)]
    assert min(ways) < 0.2
    assert len(found.seen.sides) == 4
    assert found.view.size_sigma < 0.02
    height = found.view.camera.position_mm[2] / camera.position_mm[2]
    assert height == pytest.approx(1, abs=0.02)
    assert found.view.camera.focal_px == pytest.approx(focal, rel=4 * found.view.focal_sigma)


def test_rough_clicks_on_a_sheet_of_paper_do_as_well():
    rng = np.random.default_rng(8)
    camera = camera_at(40, -70, 700, 900, photo=SMALL)
    size = (160.0, 180.0)
    clicks = camera.project(corners_mm(size)) + rng.uniform(-3, 3, (4, 2))
    found = camera_of_photo(SMALL, seen(camera, SMALL, rng, paper_mm=size), size, clicks)
    assert len(found.seen.sides) == 4
    assert not found.notes
    assert set(found.view.size_mm) == set(size)
    assert found.view.camera.position_mm[2] == pytest.approx(camera.position_mm[2], rel=0.02)
    as_told = camera_of_photo(SMALL, None, size, clicks)
    assert not as_told.seen.sides
    assert as_told.view.size_sigma > 2 * found.view.size_sigma


def test_clicks_on_the_marker_are_known_to_be_on_it():
    pytest.importorskip("cv2")
    rng = np.random.default_rng(11)
    camera = camera_at(40, -70, 500, 900, photo=SMALL)
    grey = seen(camera, SMALL, rng)
    for size, is_marker in ((SQUARE, True), ((130.0, 130.0), False)):
        clicks = camera.project(corners_mm(size)) + rng.uniform(-3, 3, (4, 2))
        assert seen_corners(SMALL, grey, clicks).is_marker is is_marker
    assert seen_corners(SMALL, grey, None).is_marker


def test_corners_are_taken_as_they_are_where_no_edges_are_seen():
    rng = np.random.default_rng(8)
    camera = camera_at(40, -70, 500, 900, photo=SMALL)
    corners = camera.project(corners_mm(SQUARE))
    blank = np.full((600, 800), 128.0)
    found = camera_of_photo(SMALL, blank, SQUARE, corners)
    assert marker_finding.NOT_SEEN in found.notes
    np.testing.assert_allclose(np.sort(found.view.corners_px, 0), np.sort(corners, 0))
    exactly = camera_of_photo(SMALL, seen(camera, SMALL, rng), SQUARE, corners + 2, exactly=True)
    assert not exactly.seen.sides
    assert not exactly.seen.notes


def test_a_photo_without_marker_says_so():
    pytest.importorskip("cv2")
    with pytest.raises(SketchError, match="no marker is seen"):
        marker_corners(np.full((300, 400), 200.0))
    with pytest.raises(SketchError, match="without the photo"):
        camera_of_photo(PHOTO, None, SQUARE)


def test_two_markers_are_one_too_many():
    pytest.importorskip("cv2")
    camera = camera_at(60, -90, 600, 900, photo=SMALL)
    one = seen(camera, SMALL, np.random.default_rng(1))
    with pytest.raises(SketchError, match="2 markers"):
        marker_corners(np.hstack([one, one]))


def test_exif_is_used_where_it_is_there():
    rng = np.random.default_rng(4)
    camera = camera_at(85, -90, 700, 900, photo=SMALL)
    grey = seen(camera, SMALL, rng)
    corners = camera.project(corners_mm(SQUARE))
    alone = camera_of_photo(SMALL, grey, SQUARE, corners)
    told = camera_of_photo(replace(SMALL, focal_px=905.0), grey, SQUARE, corners)
    assert alone.view.focal_from == "usual"
    assert told.view.focal_from == "photo"
    assert told.view.focal_sigma < 0.2 * alone.view.focal_sigma


def noisy(grey, rng):
    return gaussian_filter(grey, 1.0) + rng.normal(0, 40, grey.shape)


def dark(grey, rng):
    return 0.12 * grey + rng.normal(0, 4, grey.shape)


def half_in_soft_shade(grey, rng):
    across = np.arange(grey.shape[1]) - grey.shape[1] / 2
    return grey * (0.5 + 0.5 / (1 + np.exp(-across / 12.0)))


@pytest.mark.parametrize("spoilt", [noisy, dark, half_in_soft_shade])
def test_the_marker_is_found_in_bad_light(spoilt):
    pytest.importorskip("cv2")
    rng = np.random.default_rng(3)
    camera = camera_at(40, -70, 420, 900, photo=SMALL)
    grey = np.clip(spoilt(seen(camera, SMALL, rng), rng), 0, 255)
    found = camera_of_photo(SMALL, grey, SQUARE)
    assert len(found.seen.sides) == 4
    assert found.view.camera.position_mm[2] == pytest.approx(camera.position_mm[2], rel=0.03)


def test_a_corner_that_is_covered_is_where_the_sides_meet():
    pytest.importorskip("cv2")
    rng = np.random.default_rng(3)
    camera = camera_at(40, -70, 420, 900, photo=SMALL)
    grey, corners = seen(camera, SMALL, rng), camera.project(corners_mm(SQUARE))
    y, x = np.mgrid[: grey.shape[0], : grey.shape[1]]
    grey[np.hypot(x - corners[0, 0], y - corners[0, 1]) < 9] = 150.0
    found = camera_of_photo(SMALL, grey, SQUARE)
    ways = [np.abs(np.roll(found.view.corners_px, k, axis=0) - corners).max() for k in range(4)]
    assert min(ways) < 0.5


@pytest.mark.parametrize("size", [(297.0, 210.0), (85.60, 53.98)])
def test_a_wrong_size_is_told_and_counted_as_unsure(size):
    """Four corners of a square nearly are those of an oblong, seen by another camera."""
    rng = np.random.default_rng(5)
    camera = camera_at(35, -60, 420, 900, photo=SMALL)
    grey, corners = seen(camera, SMALL, rng), camera.project(corners_mm(SQUARE))
    right = camera_of_photo(SMALL, grey, SQUARE, corners)
    assert not right.view.is_off
    wrong = camera_of_photo(SMALL, grey, size, corners).view
    assert wrong.is_off
    assert wrong.focal_sigma > 5 * right.view.focal_sigma
    assert any("check the size" in note for note in wrong.notes)


def in_hard_shade(grey, corners, rng):
    """A straight shadow's edge across the marker."""
    v, u = np.mgrid[: grey.shape[0], : grey.shape[1]] + 0.5
    middle, way = corners.mean(axis=0), rng.uniform(0, 2 * np.pi)
    across = (u - middle[0]) * np.cos(way) + (v - middle[1]) * np.sin(way)
    return np.where(across > rng.uniform(-30, 30), grey, rng.uniform(0.12, 0.5) * grey)


def behind_blinds(grey, corners, rng):
    """Stripes of shade."""
    v, u = np.mgrid[: grey.shape[0], : grey.shape[1]] + 0.5
    way = rng.uniform(0, 2 * np.pi)
    across = (u * np.cos(way) + v * np.sin(way)) / rng.uniform(60, 100)
    return np.where(across % 1 > 0.5, grey, 0.4 * grey)


def under_a_lamp(grey, corners, rng):
    """A spot of glare that hides a part of the pattern."""
    v, u = np.mgrid[: grey.shape[0], : grey.shape[1]] + 0.5
    at = corners.mean(axis=0) + rng.uniform(-40, 40, 2)
    far = np.hypot(u - at[0], v - at[1])
    return grey + 250 * np.exp(-(far**2) / (2 * 35.0**2))


@pytest.mark.parametrize("spoil", [in_hard_shade, behind_blinds, under_a_lamp])
@pytest.mark.parametrize("seed", range(3))
def test_the_marker_is_found_where_light_cuts_into_it(spoil, seed):
    pytest.importorskip("cv2")
    rng = np.random.default_rng(seed)
    camera = camera_at(rng.uniform(30, 70), rng.uniform(-180, 180), 420, 900, photo=SMALL)
    grey, corners = seen(camera, SMALL, rng), camera.project(corners_mm(SQUARE))
    grey = np.clip(spoil(grey, corners, rng), 0, 255)
    found = camera_of_photo(SMALL, grey, SQUARE)
    ways = [np.abs(np.roll(found.view.corners_px, k, axis=0) - corners).max() for k in range(4)]
    assert min(ways) < max(0.3, 4 * found.seen.sigma_px)
    assert min(ways) < 2
    sure = 4 * found.view.focal_sigma
    assert found.view.camera.focal_px == pytest.approx(900, rel=sure)


def test_what_is_like_the_marker_but_another_one_is_not_taken_for_it():
    cv2 = pytest.importorskip("cv2")
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    square = np.array([[70, 70], [250, 80], [240, 260], [60, 250]], np.float32)
    for number in range(50):
        drawn = cv2.aruco.generateImageMarker(dictionary, number, 60)
        drawn = cv2.copyMakeBorder(drawn, 10, 10, 10, 10, cv2.BORDER_CONSTANT, value=(255,))
        inner = np.array([[10, 10], [70, 10], [70, 70], [10, 70]], np.float32)
        to_photo = cv2.getPerspectiveTransform(inner, square)
        grey = cv2.warpPerspective(drawn, to_photo, (320, 320), borderValue=(160,))
        light = np.log(grey + 6.0).astype(np.float32)
        alike = marker_quads.likeness(light, square.astype(float))
        assert (alike > marker_quads.ALIKE) == (number == 0)


@pytest.mark.parametrize("seed", range(4))
def test_a_shaken_photo_is_told_and_gives_the_camera_all_the_same(seed):
    rng = np.random.default_rng(seed)
    camera = camera_at(rng.uniform(30, 60), rng.uniform(-180, 180), 420, 900, photo=SMALL)
    grey, corners = seen(camera, SMALL, rng), camera.project(corners_mm(SQUARE))
    sharp = camera_of_photo(SMALL, grey, SQUARE, corners)
    assert not sharp.seen.notes
    way, px = rng.uniform(0, np.pi), 13
    steps = np.linspace(-px / 2, px / 2, 27)
    grey = np.mean(
        [shift(grey, (t * np.sin(way), t * np.cos(way)), order=1) for t in steps], axis=0
    )
    found = camera_of_photo(SMALL, grey, SQUARE, corners)
    assert any("blurred there" in note for note in found.notes)
    assert found.seen.sigma_px > 1.5 * sharp.seen.sigma_px
    ways = [np.abs(np.roll(found.view.corners_px, k, axis=0) - corners).max() for k in range(4)]
    assert min(ways) < min(1.0, 3 * found.seen.sigma_px)
    sure = 3 * found.view.focal_sigma
    assert found.view.camera.focal_px == pytest.approx(900, rel=sure)
