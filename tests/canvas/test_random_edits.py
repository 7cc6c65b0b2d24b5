"""Random sequences of gestures: the graph stays valid, undo and redo are exact, files the same.

The document's part, its list of steps to undo, is played by a list of graphs.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule

from incontext.solver import load_sketch, solve
from incontext.solver.graph import SketchGraph
from incontext.solver.reading.parsing import check_references
from incontext.solver.serialise import sketch_from_text, sketch_to_text
from incontext.workbench.canvas.drawing import Listener
from incontext.workbench.canvas.key_cursor import KeyCursor
from incontext.workbench.canvas.marks import marks_of
from incontext.workbench.canvas.said import on_photo, symbol_of
from incontext.workbench.canvas.solved import Solved
from incontext.workbench.canvas.tool_at_work import ToolAtWork
from incontext.workbench.canvas.tools import TOOLS
from incontext.workbench.canvas.tools.base import Pointer
from incontext.workbench.canvas.turning import rings_of

SHELF = Path(__file__).parent.parent / "data" / "shelf.sketch.json"
#: About the shelf, coarse enough for gestures to meet.
PLACES = st.tuples(st.integers(30, 50), st.integers(16, 44)).map(
    lambda p: (10.0 * p[0], 10.0 * p[1])
)
REACH_PX = 9.0
KEYS = ["enter", "escape", "delete", "select_all", "toggle_construction"]


def shelf():
    graph = replace(load_sketch(SHELF), faces=None)
    return graph, Solved(graph, solve(graph))


START, SOLVED = shelf()


class Hands(RuleBasedStateMachine):
    """A drawing, and the document's steps."""

    @initialize(from_nothing=st.booleans(), solved=st.booleans())
    def begin(self, from_nothing, solved):
        self.steps = [SketchGraph() if from_nothing else START]
        self.now = 0
        self.words, self.asked = [], []
        listener = Listener(self._edited, asked=self.asked.append)
        self.drawing = ToolAtWork(self.steps[0], listener)
        self.drawing.set_solved(SOLVED if solved else None)
        self.cursor = KeyCursor(self.drawing)

    def _edited(self, graph, words):
        assert graph != self.steps[self.now]
        assert words
        self.steps[self.now + 1 :] = [graph]
        self.now += 1
        # As the document gives it back: equal, but read from its text.
        self.drawing.replace_graph(sketch_from_text(sketch_to_text(graph)))

    def _pointer(self, place, shift=False, ctrl=False):
        return Pointer(place, REACH_PX, shift or ctrl, ctrl)

    @rule(name=st.sampled_from(sorted(TOOLS)))
    def take(self, name):
        self.drawing.use(name)
        assert name == self.drawing.tool.NAME

    @rule(place=PLACES, shift=st.booleans(), ctrl=st.booleans())
    def click(self, place, shift, ctrl):
        at = self._pointer(place, shift, ctrl)
        for event in (self.drawing.move, self.drawing.press, self.drawing.release):
            event(at)

    @rule(start=PLACES, end=PLACES, ctrl=st.booleans())
    def drag(self, start, end, ctrl):
        before = self.now
        self.drawing.press(self._pointer(start))
        self.drawing.move(self._pointer(end, ctrl=ctrl))
        self.drawing.release(self._pointer(end, ctrl=ctrl))
        # One gesture may end another one that was begun by clicks.
        assert self.now <= before + 2

    @rule(at=st.integers(0, 40), place=PLACES)
    def drag_a_vertex(self, at, place):
        vertices = list(self.drawing.graph.vertices.values())
        if vertices:
            self.drag(vertices[at % len(vertices)], place, False)

    @rule(place=PLACES)
    def press_and_never_release(self, place):
        self.drawing.press(self._pointer(place))

    @rule(what=st.sampled_from(KEYS))
    def key(self, what):
        before = self.now
        getattr(self.drawing, what)()
        assert self.now <= before + 1

    @rule(way=st.sampled_from([1, -1]), clicks=st.booleans())
    def tab(self, way, clicks):
        before = self.now
        place = self.cursor.go_on(way, self._pointer((0.0, 0.0)))
        if clicks and place is not None:
            self.cursor.click(self._pointer(place))
        # What was begun by clicks may be ended.
        assert self.now <= before + 2

    @rule()
    def switch_the_grid(self):
        attraction = self.drawing.attraction
        attraction.grid_shown = not attraction.grid_shown

    @rule(by_px=st.sampled_from([(1.0, 0.0), (-40.0, 30.0), (0.25, 0.25)]))
    def push(self, by_px):
        before = self.now
        self.drawing.push(by_px)
        assert self.now <= before + 1

    @precondition(lambda self: self.asked)
    @rule(length_mm=st.none() | st.floats(0.5, 900))
    def answer(self, length_mm):
        self.drawing.answer(self.asked.pop(), length_mm)

    @rule()
    def undo(self):
        if self.now:
            self.now -= 1
            self.drawing.replace_graph(self.steps[self.now])
            assert self.drawing.graph == self.steps[self.now]

    @rule()
    def redo(self):
        if self.now + 1 < len(self.steps):
            self.now += 1
            self.drawing.replace_graph(self.steps[self.now])
            assert self.drawing.graph == self.steps[self.now]

    @invariant()
    def the_document_has_what_is_committed(self):
        if hasattr(self, "drawing"):
            assert self.drawing.committed == self.steps[self.now]

    @invariant()
    def the_graph_is_valid_and_can_be_shown(self):
        if hasattr(self, "drawing"):
            graph = self.drawing.graph
            check_references(graph)
            marks_of(graph)
            rings_of(graph)
            places = on_photo(graph, self.drawing.marks, 1.0)
            assert all(symbol_of(places, id_) is not None for id_ in graph.annotations)
            assert self.drawing.preview is not None
            assert self.drawing.tool.hint
            chosen = self.drawing.selection
            assert chosen.edges <= set(graph.edges)
            assert chosen.circles <= set(graph.circles)

    @invariant()
    def it_is_the_same_when_it_is_opened_again(self):
        if hasattr(self, "drawing"):
            graph = self.drawing.committed
            assert sketch_from_text(sketch_to_text(graph)) == graph


TestRandomEdits = Hands.TestCase
TestRandomEdits.settings = settings(max_examples=40, stateful_step_count=40, deadline=None)
