"""What is painted, looked at px by px."""

from dataclasses import replace
from itertools import combinations, pairwise

import pytest
from PySide import QtGui

from incontext.solver.annotations import Ground, Length, Parallel, RightAngle
from incontext.solver.graph import Ellipse, Face, SketchGraph
from incontext.workbench.canvas import overlay, previews, style
from incontext.workbench.canvas.marks import marks_of
from incontext.workbench.canvas.preview import Preview
from incontext.workbench.canvas.scene import Findings, Scene
from incontext.workbench.canvas.selection import Selection
from incontext.workbench.canvas.snapping import Snap, SnapKind

SQUARE = {"v1": (40.0, 40.0), "v2": (160.0, 40.0), "v3": (160.0, 160.0), "v4": (40.0, 160.0)}


@pytest.fixture
def graph():
    edges = {"e1": ("v1", "v2"), "e2": ("v2", "v3"), "e3": ("v3", "v4"), "e4": ("v4", "v1")}
    return SketchGraph(vertices=SQUARE, edges=edges)


def painted(graph, findings=None, preview=None, selection=None, numbers=None):
    image = QtGui.QImage(200, 200, QtGui.QImage.Format_RGB32)
    image.fill(QtGui.QColor("#808080"))
    painter = QtGui.QPainter(image)
    findings = findings or Findings()
    places = dict(graph.vertices)
    scene = Scene(graph, marks_of(graph), places, {}, findings, numbers=numbers or {})
    work = previews.Work(preview or Preview(), selection or Selection(), lambda point: point)
    previews.paint_below(painter, scene, work)
    overlay.paint(painter, scene)
    previews.paint_above(painter, scene, work)
    painter.end()
    return image


def has(image, colour, x, y, reach=1):
    """Whether a colour is at a place or within reach of it."""
    return any(
        image.pixelColor(x + i, y + j) == QtGui.QColor(colour)
        for i in range(-reach, reach + 1)
        for j in range(-reach, reach + 1)
    )


def test_edge_is_blue_with_a_white_casing(graph):
    image = painted(graph)
    assert has(image, style.EDGE, 100, 40)
    assert image.pixelColor(100, 41).lightness() > 180
    assert image.pixelColor(100, 48) == QtGui.QColor("#808080")


def test_construction_is_dashed(graph):
    image = painted(replace(graph, construction=("e1",)))
    row = [image.pixelColor(x, 40).lightness() for x in range(60, 140)]
    dashes = [light < 170 for light in row]
    assert 5 < sum(a != b for a, b in pairwise(dashes)) < 40
    assert not any(has(image, style.EDGE, x, 40) for x in range(60, 140))


def test_ground_vertices_are_green(graph):
    image = painted(replace(graph, annotations={"a1": Ground(("v3", "v4"))}))
    assert has(image, style.GROUND, 160, 160)
    assert has(image, style.VERTEX, 40, 40)


def test_vertex_under_the_pointer_lights_up(graph):
    lit = Preview(lit=Selection(vertices=frozenset(("v1",))))
    assert has(painted(graph, preview=lit), style.HOVER, 40, 40)


def test_selected_edges_have_a_halo(graph):
    image = painted(graph, selection=Selection(edges=frozenset(("e1",))))
    assert has(image, style.SELECTED, 100, 43)
    assert not has(image, style.SELECTED, 100, 157)


def test_loose_vertices_are_orange_and_conflicts_red(graph):
    graph = replace(graph, annotations={"a1": RightAngle("v1", ("e1", "e4"))})
    findings = Findings(frozenset(("v3",)), frozenset(("a1", "gone")))
    image = painted(graph, findings)
    assert has(image, style.LOOSE, 160, 160)
    assert has(image, style.CONFLICT, 51, 51)
    red = image.pixelColor(100, 43)
    assert red.red() > red.green() + 60


MARKED = [SnapKind.VERTEX, SnapKind.AXIS_END, SnapKind.MIDPOINT, SnapKind.EDGE, SnapKind.CROSSING]


def test_each_snap_has_a_shape_of_its_own(graph):
    shapes = [marked(graph, kind) for kind in MARKED]
    assert all(len(shape) > 10 for shape in shapes)
    assert all(one != other for one, other in combinations(shapes, 2))


def marked(graph, kind):
    """The px about a place that are painted for a snap to it."""
    image = painted(graph, preview=Preview(snap=Snap(kind, (100.0, 100.0))))
    return {
        (x, y)
        for x in range(85, 116)
        for y in range(85, 116)
        if image.pixelColor(x, y) == QtGui.QColor(style.SNAP)
    }


def test_preview_shows_bands_boxes_and_corners_and_nothing_of_what_is_gone(graph):
    preview = Preview(
        strokes=(((60.0, 100.0), (140.0, 100.0)),),
        corners=(("v1", "v2", "v4"), ("v1", "v2", "gone")),
        box=((150.0, 150.0), (60.0, 120.0)),
    )
    image = painted(graph, preview=preview)
    assert any(has(image, style.EDGE, x, 100) for x in range(60, 140))
    assert has(image, style.HOVER_LINE, 54, 54)
    assert image.pixelColor(100, 130) != QtGui.QColor("#808080")


def test_right_angle_stands_at_its_corner(graph):
    image = painted(replace(graph, annotations={"a1": RightAngle("v1", ("e1", "e4"))}))
    inside = 40 + int(style.RIGHT_ANGLE_PX)
    assert has(image, style.ANNOTATION, inside, inside)
    assert not has(image, style.ANNOTATION, 160 - int(style.RIGHT_ANGLE_PX), inside)


def test_length_stands_outside_on_white(graph):
    image = painted(replace(graph, annotations={"a1": Length("e3", 240.0)}))
    below = [image.pixelColor(x, y) for x in range(80, 120) for y in range(168, 188)]
    assert QtGui.QColor("#ffffff") in below
    assert any(c.red() > 180 and c.green() < 90 for c in below)


def test_faces_left_out_are_hatched(graph):
    loop = ("v1", "v2", "v3", "v4")
    plain = painted(replace(graph, faces={"f1": Face(loop)}))
    hatched = painted(replace(graph, faces={"f1": Face(loop, included=False)}))
    assert plain.pixelColor(100, 100) == QtGui.QColor("#808080")
    inner = [hatched.pixelColor(x, 100) for x in range(60, 140)]
    assert len({c.name() for c in inner}) > 1


def test_circle_is_painted(graph):
    from incontext.workbench.canvas.view import SketchView

    circle = Ellipse(((60.0, 100.0), (140.0, 100.0)), ((100.0, 80.0), (100.0, 120.0)))
    view = SketchView(replace(graph, circles={"c1": circle}))
    view.resize(400, 400)
    image = view.grab().toImage()
    place = view.mapFromScene(100, 120)
    assert has(image, style.EDGE, place.x(), place.y(), reach=2)


def test_parameter_numbers_stand_beside_their_vertices(graph):
    image = painted(graph, numbers={"v3": 2, "v4": 0})
    assert has(image, style.NUMBER, 172, 143, reach=4)
    assert has(image, style.NO_NUMBER, 52, 143, reach=4)
    assert not has(image, style.NUMBER, 172, 30, reach=8)


def test_groups_differ_by_colour_and_by_number(graph):
    said = {"a1": Parallel(("e1", "e3")), "a2": Parallel(("e2", "e4"))}
    image = painted(replace(graph, annotations=said))
    first, second = style.GROUPS[:2]
    assert has(image, first, 100, 40, reach=4)
    assert has(image, second, 160, 100, reach=6)
    assert not has(image, second, 100, 40, reach=8)
