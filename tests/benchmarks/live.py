"""How fast the shape follows the hand, in FreeCAD's window: one line for each sketch.

    python tests/benchmarks/live.py

A vertex is dragged by mouse events. A frame is one move of the mouse until the sketch is lifted
and both the photo's tab and the 3D view are painted. The processor's time is what the window's own
thread needs for it, whatever else the machine does.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path

FRAMES = 120
STEP_PX = 4
SEED = 7


def measure(_: list[str]) -> int:
    """Inside FreeCAD: print the figures."""
    from incontext.solver.synthetic import bookshelf, organizer, table

    print("sketch         vertices  median ms  95 % ms  frames/s  processor ms")
    for shape in (bookshelf(), table(), organizer(5, 4)):
        print(_line(shape), flush=True)
    return 0


def _line(shape) -> str:
    import FreeCAD
    import numpy as np

    from incontext.solver.serialise import sketch_to_text
    from incontext.solver.synthetic import photograph
    from incontext.workbench.features.photo_sketch import make_photo_sketch
    from incontext.workbench.panels.tabs import show_tab
    from incontext.workbench.panels.tiling import show_side_by_side

    graph = photograph(shape, np.random.default_rng(SEED), noise=0.003).graph
    document = FreeCAD.newDocument("Live")
    sketch = make_photo_sketch(document, sketch_to_text(graph))
    document.recompute()
    controller = show_tab(sketch)
    show_side_by_side(controller)
    took = _drag(controller)
    FreeCAD.closeDocument(document.Name)
    _work(0.3)
    clock, processor = zip(*took, strict=True)
    middle, late = np.percentile(clock, (50, 95))
    rate = len(took) / sum(clock) * 1e3
    return (
        f"{shape.name:<14} {len(graph.vertices):>8} {middle:10.1f} {late:8.1f} {rate:9.0f} "
        f"{np.median(processor):13.1f}"
    )


def _work(seconds: float) -> None:
    from PySide import QtGui

    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents()


def _drag(controller) -> list[tuple[float, float]]:
    """Milliseconds that each frame took, by the clock and of the processor's time."""
    from PySide import QtCore, QtGui

    Qt, view = QtCore.Qt, controller.tab.view
    _work(1.0)
    lifts: list[object] = []
    controller.lifting.lifted.connect(lambda *_: lifts.append(None))
    start = view.mapFromScene(QtCore.QPointF(*next(iter(view.graph.vertices.values()))))

    def mouse(kind, place, button, buttons) -> None:
        where = QtCore.QPointF(place)
        on_screen = QtCore.QPointF(view.viewport().mapToGlobal(place))
        event = QtGui.QMouseEvent(kind, where, on_screen, button, buttons, Qt.NoModifier)
        QtGui.QApplication.sendEvent(view.viewport(), event)

    mouse(QtCore.QEvent.MouseButtonPress, start, Qt.LeftButton, Qt.LeftButton)
    took = []
    for k in range(FRAMES):
        away = STEP_PX * min(k + 1, FRAMES - k)
        before, began, worked = len(lifts), time.perf_counter(), time.thread_time()
        place = start + QtCore.QPoint(away // 4, away)
        mouse(QtCore.QEvent.MouseMove, place, Qt.NoButton, Qt.LeftButton)
        while len(lifts) == before:
            QtGui.QApplication.processEvents()
        # What was asked to be painted anew.
        QtGui.QApplication.processEvents()
        took.append(((time.perf_counter() - began) * 1e3, (time.thread_time() - worked) * 1e3))
    mouse(QtCore.QEvent.MouseButtonRelease, start, Qt.LeftButton, Qt.NoButton)
    return took


def main() -> int:
    """Start FreeCAD on a screen of its own and measure there."""
    from incontext.workbench.launch import Launch, run

    with tempfile.TemporaryDirectory(prefix="incontext-live-") as home:
        # A script of its own: the tests' folder is no package.
        launch = Launch(
            call="incontext.tests.benchmarks.live:measure",
            home=Path(home),
            window=True,
            own_screen=True,
            environment={"OPENBLAS_NUM_THREADS": os.environ.get("OPENBLAS_NUM_THREADS", "1")},
        )
        return run(launch)


if __name__ == "__main__":
    sys.exit(main())
