"""Photos as people see them."""

import pytest
from PIL import Image

from incontext.workbench.canvas.photo import PhotoError, load_photo

ORIENTATION = 0x0112
TURNED_RIGHT = 6


def test_photo_is_turned_upright(tmp_path):
    path = tmp_path / "held sideways.jpg"
    image = Image.new("RGB", (60, 40), "white")
    image.paste("red", (0, 0, 20, 40))
    exif = Image.Exif()
    exif[ORIENTATION] = TURNED_RIGHT
    image.save(path, exif=exif, quality=95)
    photo = load_photo(path)
    assert (photo.width(), photo.height()) == (40, 60)
    assert photo.pixelColor(20, 5).red() > 200
    assert photo.pixelColor(20, 5).green() < 60
    assert photo.pixelColor(20, 50).green() > 200


def test_wrong_ending_does_no_harm(tmp_path):
    path = tmp_path / "really a png.jpg"
    Image.new("RGB", (8, 8)).save(path, format="PNG")
    assert load_photo(path).width() == 8


@pytest.mark.parametrize("content", [b"", b"not a photo"])
def test_what_is_no_photo_is_told(tmp_path, content):
    path = tmp_path / "photo.jpg"
    path.write_bytes(content)
    with pytest.raises(PhotoError, match=r"cannot read the photo photo\.jpg"):
        load_photo(path)
