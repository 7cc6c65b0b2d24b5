"""Keeps a tab and its photo sketch together: edits go to the document, its changes come back.

While the hand is at work the shape follows in the tab and in the 3D view, and the document knows
nothing of it; the end of a gesture is one step of the document.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .. import host
from ..canvas.evident import evident
from ..canvas.extent import sketch_size
from ..canvas.lifted import LiftedView, lifted_view
from ..canvas.photo import LARGE_PX, PhotoError, load_photo, photo_size
from ..canvas.photo_loading import PhotoLoading
from ..canvas.solved import Solved
from ..features import pipeline
from ..features.driven import driven_graph, shown_source
from ..features.lifted_model import is_lifted_model
from ..features.photo_change import replace_photo
from ..features.plate_set import is_plate_set
from ..features.shelled_solid import is_shelled_solid
from ..problems import known_problems
from ..wording import in_language
from .camera_finding import CameraFinding
from .clipboard import photo_file
from .lifting import Lifting, lift_in_time
from .messages import tell
from .photo_plane import PhotoPlane
from .shape_preview import ShapePreview
from .sketch_tab import SketchTab
from .straightening import LensWatch
from .view_through import follow

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ...solver.camera import Camera
    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution
    from ..canvas.qt import QtGui

#: How long an edit of a sketch that lists its faces may wait for the solve that shows new ones.
PATIENCE_S = 0.5


class SketchController:
    """One photo sketch and its tab. The document is the truth, the tab shows it."""

    def __init__(self, obj: Any) -> None:
        self.obj = obj
        self.document_name = obj.Document.Name
        graph = pipeline.graph_of(obj.Sketch)
        self.tab = SketchTab(graph, None, obj.Label)
        self.photo_loading = PhotoLoading(self.tab)
        self.preview = ShapePreview(self.document_name)
        self.photo_plane = PhotoPlane(obj)
        self._camera: Camera | None = None
        self.lifting = Lifting(self.tab, self._driven)
        #: The last lift: what it is of, and what came of it.
        self.lift: tuple[SketchGraph, Solution] | None = None
        #: Told of every new lift.
        self.on_news: Callable[[], None] = lambda: None
        self._solved: Solved | None = None
        self.tab.view.painting.numbers.count = _parameters_of
        self.tab.view.graph_edited.connect(self.write)
        self.tab.view.undo_asked.connect(self.undo)
        self.tab.view.redo_asked.connect(self.redo)
        self.tab.view.graph_shown.connect(self._want)
        self.tab.view.photo_given.connect(self.take_photo)
        self.photo_loading.came.connect(self._take_photo_level)
        self.photo_loading.failed.connect(lambda words: host.report(in_language(words)))
        self.lifting.lifted.connect(self._show_lift)
        self.camera_finding = CameraFinding(obj, self.tab.view)
        self.lens_watch = LensWatch(obj, self.tab.view, lambda: self.on_news())
        self._show_photo()
        self.show_outcome()

    def write(self, graph: SketchGraph, words: str) -> None:
        """Put an edited graph into the document, as one step to undo, and recompute."""
        from ...solver.serialise import sketch_to_text

        graph = self._with_new_faces(graph)
        text = sketch_to_text(graph)
        self._lift_ahead(graph, self._source(text))
        document = self.obj.Document
        with host.transaction(document, host.translate("InContext", words)):
            self.obj.Sketch = text
            document.recompute()

    def _lift_ahead(self, graph: SketchGraph, source: str) -> None:
        """Have the solution ready that the recompute of a model asks for: it would wait for it."""
        if pipeline.known_solution_of(source) is None and self.models:
            solution = lift_in_time(graph, self._driven(graph), self.lift)
            if solution is not None:
                pipeline.remember_solution(source, solution)

    def _with_new_faces(self, graph: SketchGraph) -> SketchGraph:
        """The graph with the faces that came with an edit, where it lists its faces."""
        from ...solver.editing.listing import with_new_faces
        from ...solver.serialise import sketch_to_text

        stored = self._stored_graph()
        if graph.faces is None or stored is None or _bounds_the_same(stored, graph):
            return graph
        deadline = time.perf_counter() + PATIENCE_S
        solution = pipeline.lift(graph, stop=lambda: time.perf_counter() > deadline)
        if solution.status.value != "converged":
            # Its faces come with the edit that makes it solvable.
            return graph
        pipeline.remember_solution(sketch_to_text(graph), solution)
        known = self._known_solution()
        return with_new_faces((stored, known), (graph, solution))

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
            self._show_photo()
        elif name == "Marker":
            self.camera_finding.show()

    def take_photo(self, given: object) -> None:
        """Put a photo that was dropped or pasted under the sketch."""
        with photo_file(given) as path:
            try:
                replace_photo(self.obj, path, photo_size(path))
            except PhotoError as error:
                tell(str(error))

    def _show_photo(self) -> None:
        """Show the photo; a large one comes bit by bit."""
        view, path = self.tab.view, self.obj.Photo
        self.photo_loading.stop()
        size = sketch_size(view.graph)
        image = None
        try:
            width, height = photo_size(path) if path else (0, 0)
            if width * height > LARGE_PX:
                self.photo_loading.load(path)
            elif path:
                image = load_photo(path)
        except PhotoError as error:
            host.report(in_language(str(error)))
        view.set_photo(image, size)
        self.photo_plane.take_photo(image)
        self._stand_photo()

    def _take_photo_level(self, image: QtGui.QImage) -> None:
        is_first = not self.tab.view.has_photo
        self.tab.view.add_photo_level(image)
        if is_first:
            self.photo_plane.take_photo(image)
            self._stand_photo()

    def _stand_photo(self) -> None:
        """Put the photo behind the object in the 3D view."""
        graph, solution = self.lift or (self.tab.view.graph, None)
        # With a shape that is none yet it would wander about: then it stays where it was.
        if solution is None or solution.status.value == "converged":
            self.photo_plane.stand(graph, solution)
            self._follow(None if solution is None else solution.camera)

    def _follow(self, camera: Camera | None) -> None:
        """Where the 3D view looks through the photo, it goes on doing so."""
        before, self._camera = self._camera, camera or self._camera
        if before is not None and camera is not None and before is not camera:
            follow(self.obj.Document.Name, before, camera)

    def _show_sketch(self) -> None:
        try:
            graph = pipeline.graph_of(self.obj.Sketch)
            resized = sketch_size(graph) != sketch_size(self.tab.view.graph)
            self.tab.view.set_graph(graph)
            if resized and graph.photo is not None:
                self._show_photo()
        except known_problems() as error:
            # A script may write anything: the tab goes on showing the last sketch.
            self.tab.show_outcome(str(error), good=False)

    # The lift

    def _driven(self, graph: SketchGraph) -> SketchGraph:
        return driven_graph(next(iter(self.models), None), graph)

    def _source(self, text: str) -> str:
        return shown_source(next(iter(self.models), None), text)

    def _known_solution(self) -> Solution | None:
        return pipeline.known_solution_of(self._source(self.obj.Sketch))

    def _want(self, graph: SketchGraph) -> None:
        """Have the graph that is shown lifted."""
        if graph is self._stored_graph() and self._known_solution() is not None:
            self.show_outcome()
        elif graph.edges or graph.circles:
            self.lifting.want(graph, in_hand=self.tab.view.is_in_hand)
        else:
            self.lifting.forget()
            self._show_nothing()

    def _show_lift(self, graph: SketchGraph, solution: Solution) -> None:
        """Show a lift that has just come, of the document's sketch or of one in the hand."""
        self.lift = (graph, solution)
        if graph is self._stored_graph():
            pipeline.remember_solution(self._source(self.obj.Sketch), solution)
            self.show_outcome()
        else:
            self._show_solution(solution, in_hand=True)
            self._say(solution)
            self.on_news()

    def _show_solution(self, solution: Solution, *, in_hand: bool) -> None:
        view = self.tab.view
        view.set_lifted(lifted_view(solution))
        view.set_findings(solution.report.loose, solution.report.conflicts)
        made = _dependents(self.obj)
        if solution.vertices_mm and (in_hand or not made):
            graph = self.lift[0] if self.lift else view.graph
            self.preview.show(graph, solution, made)
        else:
            self.preview.hide()

    def _show_nothing(self) -> None:
        self.lift = self._solved = None
        self.tab.view.set_solved(None)
        self.tab.view.set_lifted(LiftedView())
        self.tab.view.set_suggestions(())
        self.tab.view.set_findings((), ())
        self.preview.hide()

    def _say(self, solution: Solution) -> None:
        self.tab.show_outcome(
            in_language(solution.message), good=solution.status.value == "converged"
        )

    def _stored_graph(self) -> SketchGraph | None:
        try:
            return pipeline.graph_of(self.obj.Sketch)
        except known_problems():
            # The photo sketch itself says it, in its message.
            return None

    def show_outcome(self) -> None:
        """Say in the tab's bar how the last recompute of what depends on the sketch went."""
        solution, graph = self._known_solution(), self._stored_graph()
        if solution is None or graph is None:
            # It comes when it is ready.
            self._want(self.tab.view.graph)
        else:
            self.lifting.take(graph, solution)
            self.lift = (graph, solution)
            self._take_solved(graph, solution)
            self._show_solution(solution, in_hand=False)
            self._stand_photo()
            self.tab.view.set_suggestions(evident(graph, solution))
        self._say_all(solution)
        self.on_news()

    def _say_all(self, solution: Solution | None) -> None:
        objects = [self.obj, *_dependents(self.obj)]
        bad = [o.Message for o in objects if o.Status not in ("", "ready", "converged", "made")]
        if not bad and solution is not None and solution.status.value != "converged":
            bad = [solution.message]
        if bad:
            self.tab.show_outcome(in_language(bad[0]), good=False)
            return
        words = [o.Message for o in objects[1:]]
        if not words:
            words = [self.obj.Message if solution is None else solution.message]
        words = [in_language(w) for w in words]
        good = solution is None or not solution.report.conflicts
        joined = " \N{MIDDLE DOT} ".join(w.rstrip(".\N{IDEOGRAPHIC FULL STOP}") for w in words if w)
        self.tab.show_outcome(joined, good=good)

    @property
    def models(self) -> list[Any]:
        """The lifted models of the sketch."""
        return [o for o in self.obj.InList if is_lifted_model(o)]

    def parameter_words(self) -> str:
        """How many numbers the solve has to find."""
        from ...solver import parameter_counts

        try:
            counts = parameter_counts(self.tab.view.graph)
        except known_problems():
            return ""
        if not counts.before:
            return ""
        words = host.translate("InContext", "Unknowns: {} before, {} with what is true")
        return words.format(counts.before, counts.after)

    def close(self) -> None:
        """The tab goes: leave nothing behind in the 3D view."""
        self.lifting.forget()
        self.photo_loading.stop()
        self.preview.hide()

    def _take_solved(self, graph: SketchGraph, solution: Solution) -> None:
        """Give the tools the last good solution; an unfinished edit does not take it away."""
        if solution.status.value == "converged":
            self._solved = Solved(graph, solution)
        self.tab.view.set_solved(self._solved)


def _bounds_the_same(one: SketchGraph, other: SketchGraph) -> bool:
    """Whether two graphs differ in nothing that makes faces: only in positions, say."""
    said = (one.edges, one.annotations, one.construction)
    return said == (other.edges, other.annotations, other.construction)


def _parameters_of(graph: SketchGraph) -> Mapping[str, int]:
    """How many parameters each vertex of a graph has."""
    from ...solver.counts import parameter_counts

    return parameter_counts(graph).of_vertex


def _dependents(obj: Any) -> list[Any]:
    """The lifted models of a photo sketch, then what is made of them."""
    models = [o for o in obj.InList if is_lifted_model(o)]
    made = [o for model in models for o in model.InList if is_plate_set(o) or is_shelled_solid(o)]
    return models + made
