"""Makes the pictures of resources/docs/tools.md anew: python tests/tool_pictures.py

Every tool at work over the example's photo, painted by the sketch tab itself.
"""

from __future__ import annotations

import io
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
EXAMPLE = ROOT / "resources" / "examples" / "bookshelf"
FOLDER = ROOT / "resources" / "docs" / "tools"
SIZE = (440, 330)
COLOURS = 160
#: What is looked at, photo px: left, top, width, height.
SHELF = (440.0, 190.0, 720.0, 790.0)
MUG = (330.0, 440.0, 300.0, 260.0)
TABLE = (130.0, 210.0, 1030.0, 770.0)
MARKER_VIEW = (840.0, 720.0, 600.0, 440.0)
#: The mug in the photo: centres and half widths of its base and rim, and of a knob over it.
BASE, RIM, KNOB = (484, 645, 55, 24), (472, 536, 59, 24), (469, 489, 17, 7)


class Picture:
    """A sketch tab at which a hand points."""

    def __init__(self, graph, area, *, solved=True):
        from PySide import QtCore

        from incontext.solver import solve
        from incontext.workbench.canvas.photo import load_photo
        from incontext.workbench.canvas.solved import Solved
        from incontext.workbench.canvas.view import SketchView

        self.graph = graph
        self.view = SketchView(graph, load_photo(EXAMPLE / "desk.jpg"))
        self.view.resize(*SIZE)
        self.view.show()
        self.view.fitInView(QtCore.QRectF(*area), QtCore.Qt.KeepAspectRatio)
        if solved:
            self.view.set_solved(Solved(graph, solve(graph)))
        self.place = (0.0, 0.0)

    def _event(self, kind, button, buttons):
        from PySide import QtCore, QtGui

        position = QtCore.QPointF(self.view.mapFromScene(QtCore.QPointF(*self.place)))
        event = QtGui.QMouseEvent(kind, position, position, button, buttons, QtCore.Qt.NoModifier)
        QtGui.QApplication.sendEvent(self.view.viewport(), event)

    def move(self, place):
        from PySide import QtCore

        self.place = place
        self._event(QtCore.QEvent.MouseMove, QtCore.Qt.NoButton, QtCore.Qt.NoButton)
        return self

    def press(self, place):
        from PySide import QtCore

        self.move(place)
        self._event(QtCore.QEvent.MouseButtonPress, QtCore.Qt.LeftButton, QtCore.Qt.LeftButton)
        return self

    def click(self, place):
        from PySide import QtCore

        self.press(place)
        self._event(QtCore.QEvent.MouseButtonRelease, QtCore.Qt.LeftButton, QtCore.Qt.NoButton)
        return self

    def drag(self, start, end):
        self.press(start).click(end)
        return self

    def use(self, tool):
        self.view.use_tool(tool)
        return self

    def middle(self, *vertices):
        places = [self.graph.vertices[v] for v in vertices]
        return tuple(sum(axis) / len(places) for axis in zip(*places, strict=True))

    def save(self, name):
        """Paint it, with the pointer, in few colours: the page stays small."""
        from PIL import Image
        from PySide import QtCore, QtGui

        QtGui.QApplication.processEvents()
        pixmap = self.view.grab()
        self._paint_pointer(pixmap)
        buffer = QtCore.QBuffer()
        buffer.open(QtCore.QIODevice.WriteOnly)
        pixmap.save(buffer, "PNG")
        image = Image.open(io.BytesIO(bytes(buffer.data()))).convert("RGB")
        few = image.quantize(COLOURS, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
        few.save(FOLDER / f"{name}.png", optimize=True)
        self.view.close()

    def _paint_pointer(self, pixmap):
        from PySide import QtCore, QtGui

        at = self.view.mapFromScene(QtCore.QPointF(*self.place))
        arrow = [(0, 0), (0, 17), (4, 13), (7, 20), (10, 19), (7, 12), (12, 12)]
        painter = QtGui.QPainter(pixmap)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setPen(QtGui.QPen(QtGui.QColor("#ffffff"), 1.2))
        painter.setBrush(QtGui.QColor("#000000"))
        painter.drawPolygon(
            QtGui.QPolygonF([QtCore.QPointF(at.x() + x, at.y() + y) for x, y in arrow])
        )
        painter.end()


def box_around(u, v, half_width, half_height):
    """Two opposite corners of the box around an ellipse."""
    return (u - half_width, v - half_height), (u + half_width, v + half_height)


def drawing_tools(shelf):
    """The tools that draw."""
    from incontext.solver.graph import SketchGraph

    empty = SketchGraph(photo=shelf.photo)
    half = replace(shelf, faces=None, annotations={})
    p = Picture(half, SHELF, solved=False).use("select")
    p.click(p.middle("v5", "v6")).move(shelf.vertices["v10"]).save("select")
    p = Picture(shelf, SHELF).use("line")
    p.click(p.middle("v2", "v6"))
    u, v = p.middle("v3", "v7")
    p.move((u - 45, v + 26)).save("line")
    for tool, opposite in (("rectangle", (-150, 130, 0)), ("square", (-180, -170, 0))):
        p = Picture(shelf, TABLE).use(tool)
        solved = p.view._drawing.solved
        corner = solved.solution.vertices_mm["v1"]
        start, end = solved.on_photo(
            [np.add(corner, offset) for offset in ((-40, -20, 0), opposite)]
        )
        p.press(start).move(end).save(tool)
    p = Picture(empty, SHELF, solved=False).use("box")
    for name in ("v1", "v2", "v3", "v7", "v6"):
        p.click(shelf.vertices[name])
    p.move(shelf.vertices["v5"]).save("box")
    start, end = box_around(*RIM)
    Picture(empty, MUG, solved=False).use("circle").press(start).move(end).save("circle")
    p = Picture(empty, MUG, solved=False).use("revolution")
    for circle in (BASE, RIM, KNOB):
        p.drag(*box_around(*circle))
    for place in ((531, 536), (520, 512), (488, 503)):
        p.click(place)
    p.move((486, 489)).save("revolution")


def annotating_tools(shelf):
    """The tools that say what is true."""
    plain = replace(shelf, faces=None, annotations={})
    p = Picture(plain, SHELF, solved=False).use("right_angle")
    p.click(p.middle("v1", "v2", "v3", "v4")).move(p.middle("v2", "v3", "v7", "v6")).save(
        "right_angle"
    )
    p = Picture(plain, SHELF, solved=False).use("parallel")
    p.click(p.middle("v1", "v5")).click(p.middle("v2", "v6")).move(p.middle("v3", "v7")).save(
        "parallel"
    )
    p = Picture(plain, SHELF, solved=False).use("equal_length")
    p.click(p.middle("v1", "v2")).move(p.middle("v5", "v6")).save("equal_length")
    p = Picture(plain, SHELF, solved=False).use("ground")
    p.click(p.middle("v1", "v2"))
    p.move(p.middle("v1", "v2", "v3", "v4")).save("ground")
    p = Picture(replace(shelf, annotations=_without_length(shelf)), SHELF).use("length")
    p.click(p.middle("v1", "v2"))
    p.view._editor.setText("21 cm")
    p.save("length")
    p = Picture(shelf, SHELF).use("symmetry_plane")
    p.move(p.middle("v9", "v10")).save("symmetry_plane")
    p = Picture(shelf, SHELF).use("on_face")
    p.click(shelf.vertices["v6"]).move(p.middle("v3", "v4", "v8", "v7")).save("on_face")
    p = Picture(shelf, SHELF).use("thickness")
    p.click(p.middle("v5", "v6", "v7", "v8"))
    p.view._editor.setText("6")
    p.save("thickness")
    p = Picture(shelf, SHELF).use("leave_out")
    p.move(p.middle("v5", "v6", "v10", "v9")).save("leave_out")


def camera_tool(shelf):
    """The tool that finds the camera, at a marker on the table."""
    from incontext.solver.graph import SketchGraph

    p = Picture(SketchGraph(photo=shelf.photo), MARKER_VIEW, solved=False)
    image, corners = _with_marker()
    p.view.set_photo(image, (1600.0, 1200.0))
    p.use("camera")
    for corner in corners[:3]:
        p.click(tuple(corner))
    p.move(tuple(corners[3])).save("camera")


def _with_marker():
    """The example's photo with a printed marker in it, and where its corners are seen."""
    import json

    from PySide import QtCore, QtGui

    from incontext.solver.camera import Camera
    from incontext.workbench.canvas.photo import load_photo
    from incontext.workbench.marker_sheet import FIELDS, PATTERN

    told = json.loads((EXAMPLE / "truth.json").read_text())["camera"]
    del told["image_size_px"]
    # Fields of the marker on the table, its middle there, turned a little.
    turn = np.radians(20.0)
    along = np.array([np.cos(turn), np.sin(turn), 0.0]) * 100.0 / FIELDS
    across = np.array([-np.sin(turn), np.cos(turn), 0.0]) * 100.0 / FIELDS
    corner = np.array([345.0, 25.0, 0.0]) - FIELDS / 2 * (along + across)
    square = [(0, 0), (FIELDS, 0), (FIELDS, FIELDS), (0, FIELDS)]
    seen = Camera(**told).project([corner + x * along + y * across for x, y in square])
    polygons = [
        QtGui.QPolygonF([QtCore.QPointF(float(x), float(y)) for x, y in places])
        for places in (square, seen)
    ]
    way = QtGui.QTransform()
    assert QtGui.QTransform.quadToQuad(*polygons, way)
    image = load_photo(EXAMPLE / "desk.jpg").convertToFormat(QtGui.QImage.Format_RGB32)
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setTransform(way)
    painter.fillRect(QtCore.QRectF(-1.5, -1.5, FIELDS + 3, FIELDS + 3), QtGui.QColor("#f1efe9"))
    painter.fillRect(QtCore.QRectF(0, 0, FIELDS, FIELDS), QtGui.QColor("#26241f"))
    fields = QtGui.QPainterPath()
    for row, line in enumerate(reversed(PATTERN)):
        for column in (k for k, bit in enumerate(line) if bit == "1"):
            fields.addRect(1 + column, 1 + row, 1, 1)
    painter.fillPath(fields.simplified(), QtGui.QColor("#f1efe9"))
    painter.end()
    return image, seen.tolist()


def _without_length(shelf):
    return {id_: a for id_, a in shelf.annotations.items() if a.kind != "length"}


def pictures(arguments) -> int:
    """Make all of them; runs inside FreeCAD."""
    from incontext.solver import load_sketch

    shelf = load_sketch(EXAMPLE / "bookshelf.sketch.json")
    FOLDER.mkdir(exist_ok=True)
    drawing_tools(shelf)
    annotating_tools(shelf)
    camera_tool(shelf)
    return 0


def main() -> int:
    """Start FreeCAD for it."""
    from incontext.workbench.launch import Launch, run

    with tempfile.TemporaryDirectory(prefix="incontext-pictures-") as home:
        call = "incontext.tests.tool_pictures:pictures"
        return run(Launch(call=call, home=Path(home), window=True, own_screen=True))


if __name__ == "__main__":
    sys.exit(main())
