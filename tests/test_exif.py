"""The focal length out of EXIF."""

import math

import pytest
from PIL import Image

from incontext.workbench.exif import focal_length_px, photo_data


def photo(path, focal_35mm=None, size=(400, 300), written=None):
    exif = Image.Exif()
    if focal_35mm is not None:
        exif.get_ifd(0x8769)[0xA405] = focal_35mm
    if written is not None:
        exif.get_ifd(0x8769).update(zip((0xA002, 0xA003), written, strict=True))
    Image.new("RGB", size).save(path, exif=exif)
    return path


def test_focal_length_gives_the_angle_of_view_of_the_small_frame(tmp_path):
    focal = focal_length_px(photo(tmp_path / "a.jpg", 28))
    across = 2 * math.degrees(math.atan(250 / focal))
    assert across == pytest.approx(75.4, abs=0.1)


def test_larger_photo_of_the_same_lens(tmp_path):
    small = focal_length_px(photo(tmp_path / "a.jpg", 28))
    large = focal_length_px(photo(tmp_path / "b.jpg", 28, size=(800, 600)))
    assert large == pytest.approx(2 * small)


def test_photo_of_any_size_without_a_warning(tmp_path, monkeypatch):
    path = photo(tmp_path / "a.jpg", 28)
    usual = focal_length_px(path)
    # As large to Pillow as one of 200 megapixels is to its usual bound.
    monkeypatch.setattr(Image, "MAX_IMAGE_PIXELS", 400 * 300 // 3)
    assert focal_length_px(path) == usual
    assert Image.MAX_IMAGE_PIXELS == 400 * 300 // 3


@pytest.mark.parametrize("written", [None, 0])
def test_lens_that_is_not_known(tmp_path, written):
    assert focal_length_px(photo(tmp_path / "a.jpg", written)) is None


def test_file_that_is_no_photo(tmp_path):
    (tmp_path / "a.jpg").write_bytes(b"nothing")
    assert focal_length_px(tmp_path / "a.jpg") is None


def test_cropping_leaves_the_focal_length_in_px(tmp_path):
    whole = photo_data(photo(tmp_path / "a.jpg", 28, (400, 300), (400, 300)))
    cropped = photo_data(photo(tmp_path / "b.jpg", 28, (300, 300), (400, 300)))
    assert whole.whole_size_px is None
    assert cropped.whole_size_px == (400, 300)
    assert cropped.focal_px == pytest.approx(whole.focal_px)


@pytest.mark.parametrize("size", [(200, 150), (300, 400), (4000, 3000)])
def test_smaller_turned_or_larger_photos_are_not_cropped(tmp_path, size):
    data = photo_data(photo(tmp_path / "a.jpg", 28, size, (400, 300)))
    assert data.whole_size_px is None
    assert not data.has_unusual_shape


@pytest.mark.parametrize(("size", "is_unusual"), [((400, 300), False), ((470, 300), True)])
def test_no_camera_takes_photos_of_any_shape(tmp_path, size, is_unusual):
    assert photo_data(photo(tmp_path / "a.jpg", 28, size)).has_unusual_shape == is_unusual
