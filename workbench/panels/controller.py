"""Keeps a tab and its photo sketch together: edits go to the document, its changes come back."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import host
from ..canvas.photo import PhotoError, load_photo
from ..canvas.solved import Solved
from ..canvas.view import sketch_size
from ..features import pipeline
from ..features.lifted_model import is_lifted_model
from ..features.plate_set import is_plate_set
from ..features.shelled_solid import is_shelled_solid
from ..problems import known_problems
from .sketch_tab import SketchTab

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution
    from ..canvas.qt import QtGui


class SketchController:
    """One photo sketch and its tab. The document is the truth, the tab shows it."""

    def __init__(self, obj: Any) -> None:
        self.obj = obj
        self.document_name = obj.Document.Name
        graph = pipeline.graph_of(obj.Sketch)
        self.tab = SketchTab(graph, _photo_of(obj), obj.Label)
        self.tab.view.graph_edited.connect(self.write)
        self.tab.view.undo_asked.connect(self.undo)
        self.tab.view.redo_asked.connect(self.redo)
        self._solved: Solved | None = None
        self.show_outcome()

    def write(self, graph: SketchGraph, words: str) -> None:
        """Put an edited graph into the document, as one step to undo, and recompute."""
        from ...solver.serialise import sketch_to_text

        graph = self._with_new_faces(graph)
        document = self.obj.Document
        with host.transaction(document, host.translate("InContext", words)):
            self.obj.Sketch = sketch_to_text(graph)
            document.recompute()

    def _with_new_faces(self, graph: SketchGraph) -> SketchGraph:
        """The graph with the faces that came with an edit, where it lists its faces."""
        from ...solver.listing import with_new_faces
        from ...solver.serialise import sketch_to_text

        if graph.faces is None:
            return graph
        try:
            sides = (pipeline.graph_of(self.obj.Sketch), graph)
            before, after = ((g, pipeline.solution_of(sketch_to_text(g))) for g in sides)
            return with_new_faces(before, after)
        except known_problems():
            # What it is will be told when the document is recomputed.
            return graph

    def undo(self) -> None:
        """Undo the document's last step, whatever it was."""
        if self.obj.Document.UndoCount:
            self.obj.Document.undo()

    def redo(self) -> None:
        """Redo the document's last undone step."""
        if self.obj.Document.RedoCount:
            self.obj.Document.redo()

    def on_changed(self, name: str) -> None:
        """A property of the photo sketch changed: show it."""
        if name == "Label":
            self.tab.setWindowTitle(self.obj.Label)
        elif name == "Sketch":
            self._show_sketch()
        elif name == "Photo":
            size = sketch_size(self.tab.view.graph)
            self.tab.view.set_photo(_photo_of(self.obj), size)

    def _show_sketch(self) -> None:
        try:
            self.tab.view.set_graph(pipeline.graph_of(self.obj.Sketch))
        except known_problems() as error:
            # A script may write anything: the tab goes on showing the last sketch.
            self.tab.show_outcome(str(error), good=False)

    def show_outcome(self) -> None:
        """Say in the tab's bar how the last recompute of what depends on the sketch went."""
        solution = self._solution()
        self._show_findings(solution)
        objects = [self.obj, *_dependents(self.obj)]
        bad = [o.Message for o in objects if o.Status not in ("", "ready", "converged", "made")]
        if not bad and solution is not None and solution.status.value != "converged":
            bad = [solution.message]
        if bad:
            self.tab.show_outcome(bad[0], good=False)
            return
        words = [o.Message for o in objects[1:]]
        if not words:
            words = [self.obj.Message if solution is None else solution.message]
        joined = " \N{MIDDLE DOT} ".join(w.rstrip(".") for w in words if w)
        self.tab.show_outcome(joined, good=True)

    def _solution(self) -> Solution | None:
        """The sketch lifted to 3D, also before there is an object for it; None for nothing."""
        try:
            graph = pipeline.graph_of(self.obj.Sketch)
            if not graph.edges and not graph.circles:
                return None
            return pipeline.solution_of(self.obj.Sketch)
        except known_problems():
            # The photo sketch itself says it, in its message.
            return None

    def _show_findings(self, solution: Solution | None) -> None:
        self._take_solved(solution)
        if solution is None:
            self.tab.view.set_findings((), ())
        else:
            self.tab.view.set_findings(solution.report.loose, solution.report.conflicts)

    def _take_solved(self, solution: Solution | None) -> None:
        """Give the tools the last good solution; an unfinished edit does not take it away."""
        if solution is not None and solution.status.value == "converged":
            self._solved = Solved(pipeline.graph_of(self.obj.Sketch), solution)
        elif solution is None:
            self._solved = None
        self.tab.view.set_solved(self._solved)


def _dependents(obj: Any) -> list[Any]:
    """The lifted models of a photo sketch, then what is made of them."""
    models = [o for o in obj.InList if is_lifted_model(o)]
    made = [o for model in models for o in model.InList if is_plate_set(o) or is_shelled_solid(o)]
    return models + made


def _photo_of(obj: Any) -> QtGui.QImage | None:
    if not obj.Photo:
        return None
    try:
        return load_photo(obj.Photo)
    except PhotoError as error:
        host.report(error)
        return None
