"""Photos as people see them."""

import struct
import time
import zlib
from pathlib import Path

import pytest
from PIL import Image
from PySide import QtCore, QtGui

from incontext.workbench.canvas import photo_loading
from incontext.workbench.canvas.photo import (
    LARGE_PX,
    PhotoError,
    load_photo,
    photo_size,
    readable_formats,
)
from incontext.workbench.canvas.photo_giving import photo_in
from incontext.workbench.canvas.photo_item import PhotoItem
from incontext.workbench.canvas.photo_loading import PhotoLoading

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


def test_what_is_no_photo_is_told_with_what_would_be(tmp_path):
    path = tmp_path / "photo.webp"
    path.write_bytes(b"RIFF....WEBPVP8 ")
    with pytest.raises(PhotoError, match=r"read here are .*JPEG.*PNG"):
        photo_size(path)
    assert {"BMP", "JPEG", "PNG"} <= set(readable_formats())


@pytest.mark.parametrize("read", [load_photo, photo_size])
def test_what_would_fill_the_machine_is_refused(tmp_path, read):
    head = struct.pack(">IIBBBBB", 60_000, 60_000, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", head), (b"IDAT", zlib.compress(bytes(1000))), (b"IEND", b""))
    data = b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        for kind, body in chunks
    )
    path = tmp_path / "bomb.png"
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + data)
    with pytest.raises(PhotoError, match="3600 megapixels, more than 200"):
        read(path)


@pytest.mark.parametrize("width", [60, 6000])
def test_size_is_that_of_the_upright_photo(tmp_path, width):
    path = tmp_path / "held sideways.jpg"
    exif = Image.Exif()
    exif[ORIENTATION] = TURNED_RIGHT
    Image.new("RGB", (width, width // 2), "white").save(path, exif=exif)
    assert photo_size(path) == (width // 2, width)


@pytest.fixture
def large(tmp_path):
    """A photo too large to be read at once: red left, white right, held sideways."""
    path = tmp_path / "large.jpg"
    exif = Image.Exif()
    exif[ORIENTATION] = TURNED_RIGHT
    image = Image.new("RGB", (6400, 4000), "white")
    image.paste("red", (0, 0, 3200, 4000))
    image.save(path, exif=exif, quality=60)
    assert LARGE_PX < 6400 * 4000
    return path


def wait_for(is_so):
    end = time.monotonic() + 20
    while not is_so():
        assert time.monotonic() < end
        QtGui.QApplication.processEvents()


def test_large_photo_comes_small_first(large):
    loading, came = PhotoLoading(), []
    loading.came.connect(came.append)
    loading.load(large)
    wait_for(lambda: len(came) == 3)
    assert [max(image.width(), image.height()) for image in came] == [
        *photo_loading.COPIES_PX,
        6400,
    ]
    for image in came:
        # Turned upright: red is above.
        assert image.pixelColor(image.width() // 2, image.height() // 4).green() < 60
        assert image.pixelColor(image.width() // 2, 3 * image.height() // 4).green() > 200


def test_unreadable_large_photo_is_told(tmp_path):
    path = tmp_path / "cut off.jpg"
    path.write_bytes(b"not a photo")
    loading, failed = PhotoLoading(), []
    loading.failed.connect(failed.append)
    loading.load(path)
    wait_for(lambda: failed)
    assert "cut off.jpg" in failed[0]


def test_photo_not_wanted_any_more_does_not_come(large):
    loading, came = PhotoLoading(), []
    loading.came.connect(came.append)
    loading.load(large)
    loading.stop()
    end = time.monotonic() + 0.5
    while time.monotonic() < end:
        QtGui.QApplication.processEvents()
    assert came == []


def test_item_paints_the_level_that_is_just_enough():
    levels = [QtGui.QImage(side, side, QtGui.QImage.Format_RGB32) for side in (800, 50, 200)]
    for image, colour in zip(levels, ("red", "green", "blue"), strict=True):
        image.fill(QtGui.QColor(colour))
    item = PhotoItem()
    item.show_levels(levels, (800.0, 800.0))
    assert [level.width() for level in item.levels] == [50, 200, 800]
    for zoom, colour in ((0.05, "green"), (0.2, "blue"), (3.0, "red")):
        surface = QtGui.QImage(100, 100, QtGui.QImage.Format_RGB32)
        painter = QtGui.QPainter(surface)
        painter.scale(zoom, zoom)
        item.paint(painter, None)
        painter.end()
        assert surface.pixelColor(10, 10) == QtGui.QColor(colour)


def test_photo_is_found_in_what_is_dropped():
    file, picture, text = QtCore.QMimeData(), QtCore.QMimeData(), QtCore.QMimeData()
    file.setUrls([QtCore.QUrl.fromLocalFile("/photos/desk.jpg")])
    picture.setImageData(QtGui.QImage(4, 3, QtGui.QImage.Format_RGB32))
    text.setText("desk.jpg")
    assert photo_in(file) == Path("/photos/desk.jpg")
    assert photo_in(picture).width() == 4
    assert photo_in(text) is None
