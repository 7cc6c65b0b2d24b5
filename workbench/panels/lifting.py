"""Lifts a sketch again and again while a hand is at work, and never makes it wait.

Terms
-----
wanted
    The graph that was asked for last; older ones are forgotten.
in hand
    A graph in the middle of a drag. It is lifted from the last shape, which takes a millisecond.
driven
    A graph with what is said beside it, as it is solved.
at once
    A solve inside the event loop, ended after a blink; most are. What is not done by then goes
    on in a thread: a thread from the start would cost every painting its turns at Python's lock.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from ..canvas.qt import QtCore
from ..features import pipeline
from ..problems import known_problems

if TYPE_CHECKING:
    from ...solver import Drag
    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution

#: A solve may keep the hand waiting so long, in processor time: two pictures at 30 a second.
#: By the clock, one busy moment of the machine would send every later solve into a thread.
BLINK_S = 0.06
#: Qt's priority for events to come before others; a number, which all bindings take.
ABOVE_PAINTING = 1
#: How often a thread is asked whether it is done.
POLL_MS = 15
#: A solve of a drawing that has changed since is not worth more than this.
STALE_S = 0.5


class _Job:
    """One solve in a thread, of a graph that is driven."""

    def __init__(self, graph: SketchGraph, driven: SketchGraph) -> None:
        self.graph = graph
        self._driven = driven
        self.solution: Solution | None = None
        self.took_s = 0.0
        self.began = time.perf_counter()
        self._unwanted = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        began = time.thread_time()
        self.solution = _lift(self._driven, self._unwanted.is_set)
        self.took_s = time.thread_time() - began

    @property
    def is_done(self) -> bool:
        return not self._thread.is_alive()

    @property
    def was_stopped(self) -> bool:
        return self._unwanted.is_set()

    def stop(self) -> None:
        self._unwanted.set()


class _Late:
    """Ends a solve at a deadline in the thread's processor time, and remembers it."""

    def __init__(self, deadline_s: float) -> None:
        self._deadline_s = deadline_s
        self.said_so = False

    def __call__(self) -> bool:
        self.said_so = self.said_so or time.thread_time() > self._deadline_s
        return self.said_so


class Lifting(QtCore.QObject):
    """Solves the wanted graph.

    Parameters
    ----------
    parent : QObject or None
    driven : callable
        Gives a graph with what is said beside it.

    Signals
    -------
    lifted(object, object)
        A graph, and its Solution. In the middle of a drag it may be one from a moment ago, with
        the same edges and annotations as the wanted one.
    """

    lifted = QtCore.Signal(object, object)

    def __init__(
        self,
        parent: QtCore.QObject | None = None,
        driven: Callable[[SketchGraph], SketchGraph] = lambda graph: graph,
    ) -> None:
        super().__init__(parent)
        self._driven = driven
        self._wanted: SketchGraph | None = None
        self._job: _Job | None = None
        self._last: tuple[SketchGraph, Solution] | None = None
        self._in_hand = False
        self._drag: Drag | None = None
        self._is_slow = False
        self._is_told = False
        self._poll = QtCore.QTimer(self)
        self._poll.setInterval(POLL_MS)
        self._poll.timeout.connect(self._look)

    def want(self, graph: SketchGraph, *, in_hand: bool = False) -> None:
        """Ask for the solution of a graph; what was asked for before is not wanted any more.

        Parameters
        ----------
        graph : SketchGraph
        in_hand : bool
            True in the middle of a drag: a quick answer from the last shape is good enough.
        """
        if self._last is not None and not _is_alike(self._last[0], graph):
            self._is_slow = False
        self._wanted, self._in_hand = graph, in_hand
        if self._job is not None:
            self._stop_if_stale(self._job)
        else:
            self._soon()

    def _soon(self) -> None:
        """Begin when what is going on now is done, and before anything is painted."""
        if not self._is_told:
            self._is_told = True
            begin = QtCore.QEvent(QtCore.QEvent.User)
            QtCore.QCoreApplication.postEvent(self, begin, ABOVE_PAINTING)

    def event(self, event: QtCore.QEvent) -> bool:
        """Begin."""
        if event.type() == QtCore.QEvent.User:
            self._is_told = False
            self._begin()
            return True
        return super().event(event)

    def take(self, graph: SketchGraph, solution: Solution) -> None:
        """Somebody else has solved the graph: nothing more is wanted."""
        self.forget()
        self._last, self._drag = (graph, solution), None
        self._is_slow = solution.report.solve_ms > 1e3 * BLINK_S

    def forget(self) -> None:
        """Want nothing."""
        self._wanted = None
        if self._job is not None:
            self._job.stop()

    @property
    def is_busy(self) -> bool:
        """Whether a solution is still to come."""
        return self._wanted is not None

    def _begin(self) -> None:
        """Solve at once where that will do, else begin in a thread."""
        graph = self._wanted
        if graph is None or self._job is not None:
            return
        if self._in_hand and self._last is not None and _is_alike(self._last[0], graph):
            self._follow(graph, self._last)
            return
        self._drag = None
        if not self._is_slow:
            began = time.thread_time()
            late = _Late(began + BLINK_S)
            solution = _lift(self._driven(graph), late)
            self._is_slow = time.thread_time() - began > BLINK_S
            if not late.said_so:
                self._deliver(graph, solution)
                return
        self._job = _Job(graph, self._driven(graph))
        self._poll.start()

    def _follow(self, graph: SketchGraph, last: tuple[SketchGraph, Solution]) -> None:
        """A few steps from the last shape; what is to be known of a drag is found at its start."""
        if self._drag is None:
            self._drag = pipeline.begin_drag(self._driven(last[0]), last[1])
        self._drag = pipeline.drag(self._drag, self._driven(graph))
        self._deliver(graph, self._drag.solution)

    def _look(self) -> None:
        job = self._job
        if job is None:
            self._poll.stop()
            return
        self._stop_if_stale(job)
        if not job.is_done:
            return
        self._poll.stop()
        self._job = None
        if not job.was_stopped:
            self._is_slow = job.took_s > BLINK_S
            if self._wanted is not None and _is_alike(job.graph, self._wanted):
                self._deliver(job.graph, job.solution)
        if self._wanted is not None:
            self._soon()

    def _stop_if_stale(self, job: _Job) -> None:
        wanted = self._wanted
        if wanted is job.graph:
            return
        old = time.perf_counter() - job.began > STALE_S
        if wanted is None or old or not _is_alike(job.graph, wanted):
            job.stop()

    def _deliver(self, graph: SketchGraph, solution: Solution | None) -> None:
        if graph is self._wanted:
            self._wanted = None
        if solution is not None:
            solution = replace(solution, sketch=graph)
            self._last = (graph, solution)
            self.lifted.emit(graph, solution)


def _lift(
    graph: SketchGraph, stop: Callable[[], bool], start: Solution | None = None
) -> Solution | None:
    """The graph in 3D; None where that cannot be told, which the photo sketch itself then says."""
    try:
        return pipeline.lift(graph, stop, start)
    except known_problems():
        return None


def lift_in_time(
    graph: SketchGraph, driven: SketchGraph, last: tuple[SketchGraph, Solution] | None
) -> Solution | None:
    """A solution for a document that is about to be recomputed; None where none came in time.

    From nothing where that takes a blink; else from the last shape, which the hand has led there:
    a good shape is the same one then, to the last digits.
    """
    known = last[1] if last is not None and _is_alike(last[0], graph) else None
    for start in (None,) if known is None else (None, known):
        late = _Late(time.thread_time() + BLINK_S)
        solution = _lift(driven, late, start)
        if not late.said_so:
            return None if solution is None else replace(solution, sketch=graph)
    return None


def _is_alike(a: SketchGraph, b: SketchGraph) -> bool:
    """Whether two graphs differ in positions only."""
    return a is b or (
        a.annotations == b.annotations
        and a.edges == b.edges
        and a.circles.keys() == b.circles.keys()
        and a.vertices.keys() == b.vertices.keys()
    )
