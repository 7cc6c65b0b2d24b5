"""What is said of a sketch is seen in its picture: each kind where it belongs."""

import numpy as np
import pytest
from PIL import Image, ImageDraw

from incontext.solver.annotations import (
    Angle,
    Diameter,
    EqualLength,
    Length,
    OnFace,
    Parallel,
    RightAngle,
    SymmetryPlane,
)
from incontext.solver.graph import SketchGraph
from incontext.workbench.fabrication.annotation_marks import BLUE, PURPLE, RED, AnnotationMarks

#: A square with its corners from the upper left on, and a circle beside it.
AT = {
    f"v{k}": np.array(p, float)
    for k, p in enumerate([(100, 100), (300, 100), (300, 300), (100, 300)])
}
EDGES = {"e0": ("v0", "v1"), "e1": ("v1", "v2"), "e2": ("v2", "v3"), "e3": ("v3", "v0")}
ANGLES = np.linspace(0, 2 * np.pi, 60)
RING = np.column_stack([480 + 40 * np.cos(ANGLES), 200 + 20 * np.sin(ANGLES)])


def marked(*annotations, at=AT):
    """Where something is drawn, by colour: (n, 2) px."""
    graph = SketchGraph(edges=EDGES, annotations={f"a{k}": a for k, a in enumerate(annotations)})
    page = Image.new("RGB", (600, 400), "white")
    marks = AnnotationMarks(graph, ImageDraw.Draw(page), at, {"c1": RING}, 2)
    marks.below_lines()
    marks.on_lines()
    values = np.asarray(page, dtype=int)
    return {
        colour: np.argwhere((values == colour).all(axis=2))[:, ::-1]
        for colour in (BLUE, PURPLE, RED)
    }


@pytest.mark.parametrize(
    ("annotation", "colour", "around", "within"),
    [
        (RightAngle("v0", ("e0", "e3")), BLUE, (114, 114), 30),
        (EqualLength(("e0", "e1")), RED, (176, 100), 30),
        (SymmetryPlane(("e0",)), PURPLE, (200, 100), 20),
        (Length("e0", 150.0), RED, (200, 62), 90),
        (Length("e2", 12.5), RED, (200, 338), 90),
        (Angle("v1", ("e0", "e1"), 70.0), RED, (340, 70), 120),
        (OnFace("v3", "f1"), RED, (100, 300), 22),
        (Diameter("c1", 40.0), RED, (480, 258), 130),
    ],
)
def test_each_is_drawn_where_it_belongs(annotation, colour, around, within):
    drawn = marked(annotation)[colour]
    near = np.linalg.norm(drawn - around, axis=1) < within
    assert near.sum() > 15
    # Equal lengths and parallels are on every edge that they name.
    assert near.all() or isinstance(annotation, EqualLength)


def test_parallels_point_to_one_side_whichever_way_they_were_drawn():
    drawn = marked(Parallel(("e0", "e2")))[PURPLE].astype(float)
    above, below = (drawn[part] for part in (drawn[:, 1] < 200, drawn[:, 1] > 200))
    for arrow, middle in ((above, 100), (below, 300)):
        # The tip is on the line, the two ends of the arrow are beside and behind it.
        tip = arrow[np.abs(arrow[:, 1] - middle) < 3, 0].mean()
        assert tip > arrow[np.abs(arrow[:, 1] - middle) > 6, 0].mean()


def test_groups_are_told_apart_by_how_many_marks_they_have():
    one = marked(EqualLength(("e0", "e1")))[RED]
    two = marked(EqualLength(("e0", "e1")), EqualLength(("e0", "e1")))[RED]
    assert len(two) > 1.4 * len(one)


def test_a_size_stays_on_the_page():
    low = {v: p - (100, 100) for v, p in AT.items()}
    drawn = marked(Length("e0", 150.0), at=low)[RED]
    assert drawn.min() >= 0
    assert drawn[:, 1].max() < 60
    assert len(drawn) > 100


def test_nothing_said_is_nothing_drawn():
    assert not any(map(len, marked().values()))
