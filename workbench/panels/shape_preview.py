"""The lifted shape in the 3D view while the sketch is still in the hand, and nothing is stored.

Terms
-----
stand-ins
    Objects made of the sketch; they are not shown meanwhile, being of a moment ago.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

import FreeCADGui
import numpy as np

from ..canvas.lifted import ring_mm

if TYPE_CHECKING:
    from ...solver.graph import Revolution, SketchGraph
    from ...solver.solution import Solution

FACE = (0.62, 0.77, 0.93)
EDGE = (0.10, 0.35, 0.70)
TRANSPARENCY = 0.45
EDGE_PX = 2.0
#: Coin's mark for the end of a polygon or polyline, and its choice of no child.
END, NOTHING = -1, -1


class ShapePreview:
    """Nodes of Coin in the 3D view of a document."""

    def __init__(self, document_name: str) -> None:
        from pivy import coin

        self._document_name = document_name
        self._root = coin.SoSeparator()
        self._points = coin.SoCoordinate3()
        self._faces = coin.SoIndexedFaceSet()
        self._lines = coin.SoIndexedLineSet()
        self._joined: tuple[list[list[int]], list[list[int]]] = ([], [])
        self._hidden: list[tuple[Any, int]] = []
        # Nothing to click, and out of the way of FreeCAD's own highlighting.
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        for node in (pick, self._points, _faces(coin, self._faces), _lines(coin, self._lines)):
            self._root.addChild(node)

    def show(self, graph: SketchGraph, solution: Solution, stand_ins: Iterable[Any]) -> None:
        """Show a graph's solution in place of objects."""
        scene = self._scene()
        if scene is None:
            return
        if scene.findChild(self._root) < 0:
            scene.addChild(self._root)
        self._fill(solution, graph.revolutions.values())
        if not self._hidden:
            switches = [obj.ViewObject.SwitchNode for obj in stand_ins]
            # Not by the objects' visibility: that would be an edit of the document.
            self._hidden = [(switch, switch.whichChild.getValue()) for switch in switches]
        for switch, _ in self._hidden:
            switch.whichChild.setValue(NOTHING)

    def hide(self) -> None:
        """Show the objects again, and no preview."""
        for switch, child in self._hidden:
            switch.whichChild.setValue(child)
        self._hidden = []
        scene = self._scene()
        if scene is not None and scene.findChild(self._root) >= 0:
            scene.removeChild(self._root)

    @property
    def is_shown(self) -> bool:
        """Whether it stands in the 3D view."""
        scene = self._scene()
        return scene is not None and scene.findChild(self._root) >= 0

    def _scene(self) -> Any:
        view = view_3d_of(self._document_name)
        return None if view is None else view.getSceneGraph()

    def _fill(self, solution: Solution, revolutions: Iterable[Revolution]) -> None:
        index = {v: k for k, v in enumerate(solution.vertices_mm)}
        points = [x.tolist() for x in solution.vertices_mm.values()]
        lines = [[index[v] for v in ends] for ends in solution.edges.values()]
        for circle in solution.circles.values():
            ring = ring_mm(circle).tolist()
            lines.append(list(range(len(points), len(points) + len(ring))))
            points += ring
        loops = [f.loop for f in solution.faces.values() if f.included]
        faces = [[index[v] for v in loop] for loop in loops if index.keys() >= set(loop)]
        for rings in _turned(solution, revolutions):
            faces += _between(rings, len(points))
            points += [point for ring in rings for point in ring]
        if not np.isfinite(np.array(points)).all():
            return
        set_values(self._points.point, points)
        if (faces, lines) != self._joined:
            # In the middle of a drag places change alone.
            self._joined = (faces, lines)
            set_values(self._faces.coordIndex, _ended(faces))
            set_values(self._lines.coordIndex, _ended(lines))


def _turned(
    solution: Solution, revolutions: Iterable[Revolution]
) -> Iterator[list[list[list[float]]]]:
    """The rings of each solved surface of revolution, mm; a side still being drawn goes straight
    on to the top circle."""
    from ...solver.model import turned_profile
    from ...solver.solution import SolvedCircle

    for turned in revolutions:
        circles, side = {turned.bottom, turned.top}, {*turned.profile}
        if solution.circles.keys() >= circles and solution.vertices_mm.keys() >= side:
            surface = turned_profile(turned, solution)
            yield [
                ring_mm(SolvedCircle(np.array([*surface.axis_mm, height]), radius)).tolist()
                for radius, height in surface.profile_rz_mm.tolist()
            ]


def _between(rings: list[list[list[float]]], first: int) -> list[list[int]]:
    """The faces between rings of which the points are counted from `first`."""
    around = len(rings[0])
    starts = range(first, first + around * (len(rings) - 1), around)
    lower = [start + k for start in starts for k in range(around - 1)]
    return [[k, k + 1, k + 1 + around, k + around] for k in lower]


def view_3d_of(document_name: str) -> Any:
    """The first 3D view of a document; None where there is none."""
    try:
        document = FreeCADGui.getDocument(document_name)
    except NameError:
        # FreeCAD's word for a document that is on its way out.
        return None
    views = document.mdiViewsOfType("Gui::View3DInventor")
    return views[0] if views else None


def _faces(coin: Any, shape: Any) -> Any:
    branch, hints, material = coin.SoSeparator(), coin.SoShapeHints(), coin.SoMaterial()
    # Faces are looked at from both sides, and need not be convex.
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.faceType = coin.SoShapeHints.UNKNOWN_FACE_TYPE
    material.diffuseColor = FACE
    material.emissiveColor = tuple(0.35 * part for part in FACE)
    material.transparency = TRANSPARENCY
    # Behind the edges, which lie in the faces.
    offset = coin.SoPolygonOffset()
    for node in (hints, material, offset, shape):
        branch.addChild(node)
    return branch


def _lines(coin: Any, shape: Any) -> Any:
    branch, light, colour = coin.SoSeparator(), coin.SoLightModel(), coin.SoBaseColor()
    style = coin.SoDrawStyle()
    light.model = coin.SoLightModel.BASE_COLOR
    colour.rgb = EDGE
    style.lineWidth = EDGE_PX
    for node in (light, colour, style, shape):
        branch.addChild(node)
    return branch


def _ended(chains: list[list[int]]) -> list[int]:
    return [k for chain in chains for k in (*chain, END)]


def set_values(field: Any, values: list[Any]) -> None:
    """All values of a field of Coin's, at one notice."""
    field.setNum(len(values))
    if values:
        field.setValues(0, len(values), values)
