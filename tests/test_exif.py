"""The focal length out of EXIF."""

import math

import pytest
from PIL import Image

from incontext.workbench.exif import focal_length_px


def photo(path, focal_35mm=None, size=(400, 300)):
    exif = Image.Exif()
    if focal_35mm is not None:
        exif.get_ifd(0x8769)[0xA405] = focal_35mm
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


@pytest.mark.parametrize("written", [None, 0])
def test_lens_that_is_not_known(tmp_path, written):
    assert focal_length_px(photo(tmp_path / "a.jpg", written)) is None


def test_file_that_is_no_photo(tmp_path):
    (tmp_path / "a.jpg").write_bytes(b"nothing")
    assert focal_length_px(tmp_path / "a.jpg") is None
