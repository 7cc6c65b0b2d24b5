"""One selection for the sketch and the 3D view: the same ids, lit in both.

What is selected in the sketch is painted over the 3D view, whichever object is shown there; what
is clicked on a lifted model is selected in the sketch, and of a plate the faces it is made of.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import FreeCAD
import FreeCADGui

from ..canvas.lifted import ring_mm
from ..canvas.selection import Selection
from ..features.lifted_model import is_lifted_model
from ..features.plate_set import is_plate_set, plates_of
from . import open_tabs
from .shape_preview import set_values, view_3d_of

if TYPE_CHECKING:
    from ...solver.solution import Solution

COLOUR = (0.0, 0.76, 0.82)
LINE_PX, POINT_PX = 4.0, 9.0
#: Two places are one within this part of the object's size.
SAME = 1e-4


class SelectionOverlay:
    """Nodes of Coin that stand over everything else in a document's 3D view."""

    def __init__(self, document_name: str) -> None:
        from pivy import coin

        self._document_name = document_name
        self._root = coin.SoAnnotation()
        pick, light, colour = coin.SoPickStyle(), coin.SoLightModel(), coin.SoBaseColor()
        style = coin.SoDrawStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        light.model = coin.SoLightModel.BASE_COLOR
        colour.rgb = COLOUR
        style.lineWidth, style.pointSize = LINE_PX, POINT_PX
        self._ends, self._lines = coin.SoCoordinate3(), coin.SoLineSet()
        self._places, self._points = coin.SoCoordinate3(), coin.SoPointSet()
        nodes = (pick, light, colour, style, self._ends, self._lines, self._places, self._points)
        for node in nodes:
            self._root.addChild(node)

    def show(self, chosen: Selection, solution: Solution | None) -> None:
        """Light what is selected; `chosen` with all that its annotations name."""
        view = view_3d_of(self._document_name)
        if view is None:
            return
        scene = view.getSceneGraph()
        lines, points = ([], []) if solution is None else _places_of(chosen, solution)
        set_values(self._ends.point, [point for line in lines for point in line])
        set_values(self._lines.numVertices, [len(line) for line in lines])
        set_values(self._places.point, points)
        self._points.numPoints.setValue(len(points))
        is_there = scene.findChild(self._root) >= 0
        if (lines or points) and not is_there:
            scene.addChild(self._root)
        elif is_there and not (lines or points):
            scene.removeChild(self._root)


_Place = list[float]


def _places_of(chosen: Selection, solution: Solution) -> tuple[list[list[_Place]], list[_Place]]:
    """Lines and points of what is selected, mm."""
    at, edges, circles = solution.vertices_mm, solution.edges, solution.circles
    lines = [[at[v].tolist() for v in edges[e]] for e in sorted(chosen.edges) if e in edges]
    lines += [ring_mm(circles[c]).tolist() for c in sorted(chosen.circles) if c in circles]
    return lines, [at[v].tolist() for v in sorted(chosen.vertices) if v in at]


def ids_of(shape: Any, solution: Solution) -> Selection:
    """What of a sketch a vertex, an edge or a face of its lifted model is."""
    places = [tuple(vertex.Point) for vertex in shape.Vertexes]
    size = max((math.dist(a, b) for a in places for b in places), default=0.0)
    everything = solution.vertices_mm.values()
    size = max(size, max((float(abs(x).max()) for x in everything), default=0.0))
    near = SAME * size
    at = solution.vertices_mm.items()
    vertices = {v for v, x in at if any(math.dist(x, place) < near for place in places)}
    edges = {e for e, ends in solution.edges.items() if vertices.issuperset(ends)}
    if shape.ShapeType == "Vertex":
        return Selection(vertices=frozenset(vertices))
    return Selection(edges=frozenset(edges))


def faces_of_plate(plates: Any, element: str) -> tuple[str, ...]:
    """The faces of the sketch that the plate is made of to which an element of the shape belongs.

    Parameters
    ----------
    plates : plate set
    element : str
        FreeCAD's name, such as ``Face12``.
    """
    wanted = plates.Shape.getElement(element)
    kind = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes"}[wanted.ShapeType]
    for solid, plate in zip(plates.Shape.Solids, plates_of(plates), strict=True):
        if any(part.isSame(wanted) for part in getattr(solid, kind)):
            return tuple(plate.face_ids)
    return ()


def edges_of_faces(faces: Iterable[str], solution: Solution) -> Selection:
    """The edges around some faces; of what is mirrored those that it is the image of."""
    around = {
        frozenset(pair)
        for face in faces
        if face in solution.faces
        for loop in solution.faces[face].loops
        for pair in pairwise((*loop, loop[0]))
    }
    edges = [e for e, ends in solution.edges.items() if frozenset(ends) in around]
    return Selection(edges=frozenset(e.split("@")[0] for e in edges))


class _Observer:
    """Hears of selections in FreeCAD, which calls these by name."""

    def addSelection(self, document: str, name: str, element: str, _: Any) -> None:  # noqa: N802
        """Something was selected."""
        obj = FreeCAD.getDocument(document).getObject(name)
        if obj is None or not element or not (is_lifted_model(obj) or is_plate_set(obj)):
            return
        model = obj.LiftedModel if is_plate_set(obj) else obj
        for controller in open_tabs.open_tabs():
            if model is not None and controller.obj is model.PhotoSketch and controller.lift:
                solution, view = controller.lift[1], controller.tab.view
                if obj is model:
                    meant = ids_of(obj.Shape.getElement(element), solution)
                else:
                    meant = edges_of_faces(faces_of_plate(obj, element), solution)
                view.select(view.selection.united(meant))

    def clearSelection(self, document: str) -> None:  # noqa: N802
        """Nothing is selected any more, in a document, or where none is named in any."""
        for controller in open_tabs.open_tabs():
            if document in ("", controller.document_name) and controller.tab.view.selection:
                controller.tab.view.select(Selection())


_OBSERVER = _Observer()
_started: list[_Observer] = []


def start_listening() -> None:
    """Hear of selections from now on."""
    if not _started:
        _started.append(_OBSERVER)
        FreeCADGui.Selection.addObserver(_OBSERVER)
