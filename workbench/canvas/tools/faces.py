"""What is said of faces by a click in one ([Lau10] 3.2): left out, how thick."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ....solver.editing.listing import is_made, set_included
from .. import stops
from ..plane import Point, middle
from ..preview import Preview
from ..questions import About, Question
from ..solved import NO_FACES, face_at, outline
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ..drawing import Drawing


class FaceTool(Tool):
    """Takes the face around the pointer whose middle is the nearest."""

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._face: str | None = None

    def stops(self, reach_px: float) -> list[Point]:
        """See `Tool`."""
        return stops.faces(self.drawing.places, self.drawing.faces)

    def preview(self) -> Preview:
        """See `Tool`."""
        faces = self.drawing.faces
        if self._face not in faces:
            return Preview()
        return Preview(areas=(outline(self.drawing.places, faces[self._face].loop),))

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        self._face = face_at(self.drawing.places, self.drawing.faces, pointer.point_px)

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._face is not None and self._face in self.drawing.faces:
            self._take(self._face)

    def _take(self, face: str) -> None:
        raise NotImplementedError


class LeaveOutTool(FaceTool):
    """Leaves a face out: an open side, nothing is made of it. A second click makes it again."""

    NAME = "leave_out"
    KEY = "O"
    TITLE = "Leave out"

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if not self.drawing.faces:
            return NO_FACES
        return "Click in the middle of a face that stays open; click again to close it"

    def _take(self, face: str) -> None:
        graph = self.drawing.committed
        choice = self.drawing.choice(face)
        opens = is_made(graph, face, choice.found)
        changed = set_included(graph, choice, not opens)
        self.drawing.commit(changed, "Leave face out" if opens else "Include face")


class ThicknessTool(FaceTool):
    """Asks for the thickness of the face that is clicked."""

    NAME = "thickness"
    KEY = "T"
    TITLE = "Thickness"

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if not self.drawing.faces:
            return NO_FACES
        return "Click in the middle of a face, type its thickness and Enter; empty: as the others"

    def _take(self, face: str) -> None:
        said = self.drawing.faces[face]
        at = middle(outline(self.drawing.places, said.loop))
        self.drawing.ask(Question(About.FACE, face, at, said.thickness_mm))
