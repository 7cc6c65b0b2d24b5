"""What the document keeps of the rectangle that told the camera."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
from rectangles import PHOTO, camera_at

from incontext.solver.graph import SketchGraph
from incontext.workbench.features.known_rectangle import marker_text, rectangle_of
from incontext.workbench.features.photo_change import _marker_text, with_photo

CORNERS = ((100.0, 300.0), (300.0, 310.0), (260.0, 200.0), (120.0, 195.0))
TEXT = marker_text(CORNERS, (297.0, 210.0))


def test_the_text_says_corners_and_size():
    assert rectangle_of(TEXT) == (CORNERS, (297.0, 210.0))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "nonsense",
        "[]",
        "null",
        "{}",
        '{"corners_px": 3, "size_mm": [1, 2]}',
        '{"corners_px": [[1, 2], [3, 4], [5, 6]], "size_mm": [1, 2]}',
        '{"corners_px": [[1, 2], [3, 4], [5, 6], [7, NaN]], "size_mm": [1, 2]}',
    ],
)
def test_what_a_script_may_have_written_is_none(text):
    assert rectangle_of(text) is None


def test_the_camera_goes_with_a_larger_copy_of_the_photo_and_not_with_another_photo():
    camera = camera_at(40, -70, 500, 1500)
    graph = SketchGraph(photo=PHOTO, camera=camera)
    document = SimpleNamespace(Marker=TEXT)
    larger = with_photo(graph, "large.jpg", (3200, 2400), None)
    assert larger.camera.focal_px == 2 * camera.focal_px
    corners, size_mm = rectangle_of(_marker_text(document, graph, larger))
    assert corners == tuple((2 * u, 2 * v) for u, v in CORNERS)
    assert size_mm == (297.0, 210.0)
    other = with_photo(graph, "other.jpg", (1000, 1000), None)
    assert other.camera is None
    assert _marker_text(document, graph, other) == ""
