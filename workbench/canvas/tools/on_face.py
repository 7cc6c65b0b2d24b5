"""Vertices that touch a face without being one of its corners."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ....solver.annotations import OnFace
from ....solver.editing.annotating import annotate
from ....solver.editing.elements import delete
from ....solver.editing.listing import with_list
from .. import stops
from ..hit_testing import vertex_at
from ..preview import Preview
from ..selection import Selection
from ..solved import NO_FACES, face_at, outline
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ....solver.graph import Face
    from ..drawing import Drawing
    from ..plane import Point


class OnFaceTool(Tool):
    """Says that a vertex touches a face: a click on the vertex, one in the face."""

    NAME = "on_face"
    KEY = "H"
    TITLE = "On face"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._vertex: str | None = None
        self._lit: str | None = None
        self._face: str | None = None

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if self._vertex is None:
            return "Click a vertex that touches a face"
        if not self._faces():
            return NO_FACES
        return "Click in the middle of the face that it touches; Esc to give up"

    def _faces(self) -> dict[str, Face]:
        """The drawn faces that the vertex is no corner of."""
        faces, drawn = self.drawing.faces, self.drawing.graph.vertices.keys()
        return {
            id_: face
            for id_, face in faces.items()
            if all(self._vertex not in loop and drawn >= set(loop) for loop in face.loops)
        }

    def stops(self, reach_px: float) -> list[Point]:
        """See `Tool`."""
        graph = self.drawing.graph
        return (
            stops.vertices(graph)
            if self._vertex is None
            else stops.faces(graph.vertices, self._faces())
        )

    def preview(self) -> Preview:
        """See `Tool`."""
        faces = self._faces()
        lit = Selection(vertices=frozenset(filter(None, (self._vertex, self._lit))))
        if self._face not in faces:
            return Preview(lit=lit)
        return Preview(
            lit=lit, areas=(outline(self.drawing.graph.vertices, faces[self._face].loop),)
        )

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        graph, place = self.drawing.graph, pointer.point_px
        self._face = self._lit = None
        if self._vertex is None:
            self._lit = vertex_at(graph, place, 1.5 * pointer.reach_px)
        else:
            self._face = face_at(graph.vertices, self._faces(), place)

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._vertex is None:
            self._vertex = self._lit
            self._lit = None
        elif self._face is not None:
            self._say(self._vertex, self._face)
            self.cancel()

    def _say(self, vertex: str, face: str) -> None:
        graph = with_list(self.drawing.committed, self.drawing.choice(face))
        marked, id_ = annotate(graph, OnFace(vertex, face))
        if marked is graph:
            self.drawing.commit(delete(graph, annotations=(id_,)), "Remove on face")
        else:
            self.drawing.commit(marked, "Mark on face")

    def cancel(self) -> bool:
        """See `Tool`."""
        begun = self._vertex is not None
        self._vertex = self._lit = self._face = None
        return begun

    def graph_replaced(self) -> None:
        """See `Tool`: the vertex is still meant, if it is there."""
        self._lit = self._face = None
        if self._vertex not in self.drawing.graph.vertices:
            self._vertex = None
