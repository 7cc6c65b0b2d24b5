"""The picture: right size, the sketch on the left, the plates on the right."""

import io

import numpy as np
import pytest
from fabrication import shapes
from PIL import Image

from incontext.solver.annotations import Ground, RightAngle
from incontext.solver.graph import Ellipse, Photo, SketchGraph
from incontext.solver.solution import Solution, Status
from incontext.workbench.fabrication import make_plates
from incontext.workbench.fabrication.picture import BLUE, GREEN, caption_of, picture_png
from incontext.workbench.fabrication.rendering import plates_scene, render

GRAPH = SketchGraph(
    photo=Photo("desk.jpg", 400, 300),
    vertices={"v1": (100, 200), "v2": (300, 210), "v3": (120, 60)},
    edges={"e1": ("v1", "v2"), "e2": ("v1", "v3"), "e3": ("v2", "v3")},
    circles={"c1": Ellipse(((40, 60), (90, 60)), ((65, 50), (65, 70)))},
    annotations={"a1": RightAngle("v1", ("e1", "e2")), "a2": Ground(("v1", "v2"))},
    construction=("e3",),
)
SOLUTION = Solution("", Status.CONVERGED, "")


@pytest.fixture(scope="module")
def scene():
    return plates_scene(make_plates(shapes.bracket()))


def counted(image, colour):
    return int((np.abs(np.asarray(image, dtype=int) - colour).max(axis=2) < 12).sum())


@pytest.mark.parametrize("photo", [None, Image.new("RGB", (400, 300), (200, 180, 160))])
def test_the_sketch_is_left_and_the_plates_are_right(scene, photo):
    caption = caption_of("2 plates", scene.triangles_mm)
    assert caption == "2 plates, 100 x 60 x 70 mm"
    image = Image.open(io.BytesIO(picture_png(GRAPH, SOLUTION, scene, photo, caption)))
    left = image.crop((0, 0, image.width - 768, image.height))
    right = image.crop((image.width - 768, 0, image.width, image.height))
    assert counted(left, BLUE) > 500
    assert counted(left, GREEN) > 20
    assert counted(right, BLUE) == 0
    assert (np.asarray(right, dtype=int).min(axis=2) < 200).mean() > 0.1


def test_a_sketch_without_a_photo(scene):
    graph = SketchGraph(vertices=GRAPH.vertices, edges=GRAPH.edges)
    assert picture_png(graph, SOLUTION, scene, None, "x").startswith(b"\x89PNG")


def test_the_same_scene_gives_the_same_picture(scene):
    one, two = (render(scene, None, (120, 120)) for _ in range(2))
    assert one.tobytes() == two.tobytes()


def test_the_whole_object_is_in_the_picture(scene):
    image = np.asarray(render(scene, None, (200, 160)), dtype=int)
    border = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]])
    assert border.min() > 200
