"""What the tools work on, without Qt: the graph, what is selected, what is known of it.

Terms
-----
committed
    The graph as the document has it; between press and release the shown graph may differ.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ...solver.editing import rounds
from ...solver.editing.annotating import set_length
from ...solver.editing.elements import delete, toggle_construction
from ...solver.editing.listing import Choice, set_thickness
from ...solver.graph import Face, Point, SketchGraph
from .attraction import Attraction
from .ground_grid import GroundGrid
from .marks import Marks, marks_of
from .questions import About, KnownRectangle, Question
from .selection import Selection
from .snapping import Snap
from .solved import Solved, face_choices, places


def _nothing(*_: object) -> None:
    """Nobody listens."""


@dataclass(slots=True)
class Listener:
    """Who is told: of an edit, of anything to be painted anew, of what is to be asked.

    And of a rectangle of known size in the photo; None has the printed marker looked for.
    """

    edited: Callable[[SketchGraph, str], None] = _nothing
    changed: Callable[[], None] = _nothing
    asked: Callable[[Question], None] = _nothing
    rectangle_told: Callable[[KnownRectangle | None], None] = _nothing


class Drawing:
    """What the tools work on.

    Parameters
    ----------
    graph : SketchGraph
    listener : Listener
    """

    def __init__(self, graph: SketchGraph, listener: Listener) -> None:
        self._listener = listener
        self._committed = self._graph = graph
        self._selection = Selection()
        self._solved: Solved | None = None
        #: What attracts the pen besides the drawing.
        self.attraction = Attraction()
        self._marked: tuple[object, Marks] | None = None
        self._rectangle: KnownRectangle | None = None

    @property
    def graph(self) -> SketchGraph:
        """The graph as it is shown, in the middle of a drag too."""
        return self._graph

    @property
    def committed(self) -> SketchGraph:
        """The graph as the document has it."""
        return self._committed

    def replace_graph(self, graph: SketchGraph) -> None:
        """Take the document's graph."""
        self._committed = self._graph = graph
        self.select(self._selection)

    # For tools

    def show(self, graph: SketchGraph) -> None:
        """Show a graph that is not committed yet."""
        self._graph = graph
        self._listener.changed()

    def give_up(self) -> None:
        """Show the committed graph again."""
        self.show(self._committed)

    def commit(self, graph: SketchGraph, words: str) -> None:
        """Make a graph the document's; `words` name the step in the undo list."""
        changed = graph != self._committed
        # An equal one is the same: what asks whether an edit is going on asks for identity.
        self._graph = graph if changed else self._committed
        if changed:
            self._committed = graph
            self._listener.edited(graph, words)
        self._listener.changed()

    @property
    def selection(self) -> Selection:
        """What is selected."""
        return self._selection

    def select(self, selection: Selection) -> None:
        """Select something else; what is not there is left out."""
        self._selection = Selection(
            selection.vertices & set(self._graph.vertices),
            selection.edges & set(self._graph.edges),
            selection.circles & set(self._graph.circles),
            selection.annotations & set(self._graph.annotations),
        )
        self._listener.changed()

    @property
    def marks(self) -> Marks:
        """The marks of the graph's annotations, which stay the same while it is dragged."""
        graph = self._graph
        said = (graph.annotations, graph.edges, graph.faces)
        if self._marked is None or self._marked[0] != said:
            self._marked = (said, marks_of(graph))
        return self._marked[1]

    @property
    def grid(self) -> GroundGrid | None:
        """The grid on the ground, where it is shown and the perspective is known."""
        return self.attraction.grid(self._graph, self._solved)

    def attracted(self, found: Snap, reach_px: float) -> Snap:
        """Where a press lands: as the drawing has it, or where something else attracts it."""
        return self.attraction.attract(found, reach_px, self.grid)

    @property
    def rectangle(self) -> KnownRectangle | None:
        """What on the ground tells the camera, as far as it is known."""
        return self._rectangle

    def set_rectangle(self, rectangle: KnownRectangle | None) -> None:
        """Take the document's."""
        self._rectangle = rectangle
        self._listener.changed()

    def tell_rectangle(self, rectangle: KnownRectangle | None) -> None:
        """Have the camera found from it; None has the printed marker looked for."""
        self._listener.rectangle_told(rectangle)

    def ask(self, question: Question) -> None:
        """Have a person asked."""
        self._listener.asked(question)

    @property
    def solved(self) -> Solved | None:
        """The last good solution; the drawing may have gone on since."""
        return self._solved

    @property
    def faces(self) -> dict[str, Face]:
        """The faces of which something can be said, see `solved.face_choices`."""
        at, faces = self.places, face_choices(self._committed, self._solved)
        return {id_: f for id_, f in faces.items() if all(at.keys() >= {*p} for p in f.loops)}

    @property
    def places(self) -> dict[str, Point]:
        """Where all vertices are, see `solved.places`."""
        return places(self._graph, self._solved)

    def choice(self, face: str) -> Choice:
        """A face of `faces`, of which something is to be said."""
        if self._solved is None:
            return Choice(face, {}, {})
        return Choice(face, self._solved.found, self._solved.solution.vertices_mm)

    # For the view

    def set_solved(self, solved: Solved | None) -> None:
        """Take another solution."""
        self._solved = solved
        self._listener.changed()

    def delete(self) -> None:
        """Take away what is selected."""
        chosen = self._selection
        if chosen and self._graph is self._committed:
            smaller = delete(
                self._graph,
                vertices=chosen.vertices,
                edges=chosen.edges,
                circles=chosen.circles,
                annotations=chosen.annotations,
            )
            self.select(Selection())
            self.commit(smaller, "Delete")

    def select_all(self) -> None:
        """Select everything."""
        graph = self._graph
        vertices, edges, circles = map(frozenset, (graph.vertices, graph.edges, graph.circles))
        self.select(Selection(vertices, edges, circles=circles))

    def moved(self, by_px: Point) -> SketchGraph:
        """The committed graph with what is selected moved by so much."""
        graph, chosen = self._committed, self._selection
        held = chosen.vertices.union(*(graph.edges[e] for e in chosen.edges))
        places = {v: graph.vertices[v] for v in held}
        moved = {v: (u + by_px[0], w + by_px[1]) for v, (u, w) in places.items()}
        circles = {c: rounds.shifted(graph.circles[c], by_px) for c in chosen.circles}
        return rounds.move(graph, moved, circles)

    def push(self, by_px: Point) -> None:
        """Move what is selected by so much."""
        if self._graph is self._committed:
            self.commit(self.moved(by_px), "Move")

    def toggle_construction(self) -> None:
        """Make the selected edges and circles construction, or part of the object again."""
        chosen = sorted(self._selection.edges | self._selection.circles)
        if chosen and self._graph is self._committed:
            self.commit(toggle_construction(self._graph, chosen), "Change construction")

    def answer(self, question: Question, length_mm: float | None) -> None:
        """Say how long, how wide or how thick something is; None takes it back."""
        graph, target = self._committed, question.target
        if question.about is About.EDGE and target in graph.edges:
            self.commit(set_length(graph, target, length_mm), "Set length")
        elif question.about is About.CIRCLE and target in graph.circles:
            self.commit(rounds.set_diameter(graph, target, length_mm), "Set diameter")
        elif question.about is About.FACE and target in self.faces:
            thicker = set_thickness(graph, self.choice(target), length_mm)
            self.commit(thicker, "Set thickness")
