"""A bookshelf drawn over its photo by the gestures of a hand, without a screen, and lifted."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from incontext.solver import load_sketch, solve
from incontext.solver.graph import SketchGraph
from incontext.workbench.canvas.drawing import Listener
from incontext.workbench.canvas.tool_at_work import ToolAtWork
from incontext.workbench.canvas.tools.base import Pointer

EXAMPLES = Path(__file__).parents[2] / "resources" / "examples"
#: Around the bottom, around the top, the four uprights, then the shelf between them.
LOOPS = ("v1 v2 v3 v4 v1", "v9 v10 v11 v12 v9")
UPRIGHTS = ("v1 v9", "v2 v10", "v3 v11", "v4 v12")
SHELF = "v5 v6 v7 v8 v5"


def test_bookshelf_drawn_by_hand_lifts_as_the_example_does():
    example = load_sketch(EXAMPLES / "bookshelf" / "bookshelf.sketch.json")
    asked, gestures = [], []
    drawing = ToolAtWork(SketchGraph(photo=example.photo), Listener(asked=asked.append))

    def at(*vertices):
        return Pointer(tuple(np.mean([example.vertices[v] for v in vertices], axis=0)), 9.0)

    def click(*vertices):
        gestures.append(vertices)
        for event in (drawing.move, drawing.press, drawing.release):
            event(at(*vertices))

    def drag(start, end):
        gestures.append((start, end))
        drawing.press(at(start))
        drawing.move(at(end))
        drawing.release(at(end))

    def take(tool):
        gestures.append(tool)
        drawing.use(tool)

    take("line")
    # The shelf's corners lie on the uprights, which are split there.
    for line in (*LOOPS, *UPRIGHTS, SHELF):
        for start, end in pairwise(line.split()):
            drag(start, end)
    take("right_angle")
    for face in example.faces.values():
        click(*face.loop)
    take("ground")
    click(*LOOPS[0].split()[:-1])
    take("length")
    click("v1", "v2")
    drawing.answer(asked[0], 210.0)

    solution, expected = solve(drawing.graph), solve(example)
    assert solution.status.value == "converged", solution.message
    assert size_of(solution) == pytest.approx(size_of(expected), rel=0.01)
    assert len(solution.faces) == len(example.faces)
    # And "210" typed, with Enter.
    assert len(gestures) + 4 <= 40


def size_of(solution):
    """Width, depth and height, mm."""
    return np.ptp(np.array(list(solution.vertices_mm.values())), axis=0)
