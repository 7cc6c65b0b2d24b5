"""The printed marker, read back by others: OpenCV, poppler, librsvg."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image

from incontext.solver import SketchError
from incontext.workbench.marker_sheet import marker_file

PER_MM = 5
DPI = 127


def rendered(path: Path) -> np.ndarray:
    """The page as another program draws it, PER_MM px a mm."""
    png = path.with_suffix(".png")
    if path.suffix == ".svg":
        command = ["rsvg-convert", "-d", str(DPI), "-p", str(DPI), str(path), "-o", str(png)]
    else:
        command = [
            "pdftoppm",
            "-r",
            str(DPI),
            "-png",
            "-singlefile",
            str(path),
            str(path.with_suffix("")),
        ]
    if shutil.which(command[0]) is None:
        pytest.skip(f"{command[0]} is not installed")
    subprocess.run(command, check=True, timeout=60)
    with Image.open(png) as picture:
        return np.asarray(picture.convert("L"), dtype=float)


@pytest.mark.parametrize("ending", [".svg", ".pdf"])
@pytest.mark.parametrize("size_mm", [40.0, 150.0])
def test_the_printed_square_has_its_size(tmp_path, ending, size_mm):
    path = tmp_path / f"marker{ending}"
    path.write_bytes(marker_file(path, size_mm))
    page = rendered(path)
    # Poppler rounds the page up.
    assert (np.array(page.shape) - (297 * PER_MM, 210 * PER_MM)).tolist() in ([0, 0], [1, 1])
    dark = page < 128
    # The widest dark row is the square's; the scale's line is 100 mm.
    widths = dark.sum(axis=1)
    rows = np.flatnonzero(widths >= PER_MM * size_mm - 2)
    columns = np.flatnonzero(dark[rows[2]])
    assert np.ptp(columns) + 1 == pytest.approx(PER_MM * size_mm, abs=1.5)
    left = columns[0]
    square = dark[:, left + 2]
    assert square.sum() >= PER_MM * size_mm - 1.5
    foot = np.flatnonzero(widths >= 100 * PER_MM - 2)[-1]
    bar = np.flatnonzero(dark[foot])
    assert (np.ptp(bar) + 1) / PER_MM == pytest.approx(100.0, abs=0.3)


@pytest.mark.parametrize("ending", [".svg", ".pdf"])
def test_opencv_reads_the_printed_marker(tmp_path, ending):
    cv2 = pytest.importorskip("cv2")
    path = tmp_path / f"marker{ending}"
    path.write_bytes(marker_file(path, 80.0))
    page = rendered(path).astype(np.uint8)
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    corners, names, _ = cv2.aruco.ArucoDetector(dictionary).detectMarkers(page)
    assert names.ravel().tolist() == [0]
    sides = np.linalg.norm(np.diff(corners[0][0], axis=0, append=corners[0][0][:1]), axis=1)
    np.testing.assert_allclose(sides, 80 * PER_MM, atol=2.5)
    # Not turned: the pattern is the one that the dictionary draws.
    assert corners[0][0][0].tolist() == corners[0][0].min(axis=0).tolist()


def test_the_size_is_said_and_the_paper_grows():
    text = marker_file(Path("a.svg"), 62.5).decode()
    root = ElementTree.fromstring(text)
    assert root.get("width") == "210mm"
    assert "62.5 mm" in text
    assert "100 mm" in text
    large = ElementTree.fromstring(marker_file(Path("a.svg"), 300.0).decode())
    assert float(re.match(r"[\d.]+", large.get("width"))[0]) > 300


def test_the_same_bytes_every_time():
    for name in ("a.svg", "a.pdf"):
        assert marker_file(Path(name)) == marker_file(Path(name))


@pytest.mark.parametrize(
    ("name", "size_mm", "says"),
    [("a.png", 100.0, "neither"), ("a.svg", 3.0, "3 mm"), ("a.svg", float("nan"), "nan")],
)
def test_what_cannot_be_printed(name, size_mm, says):
    with pytest.raises(SketchError, match=says):
        marker_file(Path(name), size_mm)
