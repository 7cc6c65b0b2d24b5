"""Which parameter numbers are shown, and when they are counted again."""

from dataclasses import replace

from incontext.solver.annotations import Ground
from incontext.solver.editing.elements import move_vertices
from incontext.tests.canvas.test_tools import SQUARE
from incontext.workbench.canvas.numbers import Numbers


def test_numbers_are_counted_on_demand_and_not_while_a_vertex_moves():
    counted = []

    def count(graph):
        counted.append(graph)
        return dict.fromkeys(graph.vertices, 3)

    numbers = Numbers()
    numbers.count = count
    assert numbers.of(SQUARE) == {}
    numbers.toggle()
    assert numbers.of(SQUARE) == {"v1": 3, "v2": 3, "v3": 3, "v4": 3}
    numbers.of(move_vertices(SQUARE, {"v1": (0, 0)}))
    assert len(counted) == 1
    numbers.of(replace(SQUARE, annotations={"a1": Ground(("v1",))}))
    assert len(counted) == 2
    numbers.toggle()
    assert numbers.of(SQUARE) == {}
