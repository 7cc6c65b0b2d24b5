"""What a lift makes evident, and taking it."""

from dataclasses import replace

import numpy as np
import pytest

from incontext.solver import solve
from incontext.solver.annotations import Ground, Parallel, RightAngle
from incontext.solver.graph import SketchGraph
from incontext.solver.solution import Solution, Status
from incontext.solver.synthetic import box, photograph
from incontext.tests.scenes import GABLES, loose_house
from incontext.workbench.canvas.evident import evident, still_open, taken


@pytest.fixture(scope="module")
def drawn():
    """A box, drawn with a hand's error."""
    return photograph(box(), np.random.default_rng(5), noise=0.004).graph


def lifted(graph, positions):
    """A solution with vertices at given places."""
    return Solution(graph.digest, Status.UNDERDETERMINED, "", positions, graph.edges)


@pytest.fixture
def crooked(drawn):
    """A box of which one corner is a hand's breadth off, without annotations."""
    places = {f"v{k}": np.add(x, (0, 0, 10)) for k, x in enumerate(box().X)}
    places["v6"] = places["v6"] + (1.0, 2.0, 2.0)
    places["v0"] = places["v0"] - (0, 0, 1.0)
    bare = replace(drawn, annotations={})
    return bare, lifted(bare, places)


def test_what_holds_exactly_is_not_said_again(drawn):
    assert evident(drawn, solve(drawn)) == ()


def test_right_angles_that_nearly_hold_are_suggested_where_the_corner_is_off(crooked):
    found = [a for a in evident(*crooked) if isinstance(a, RightAngle)]
    assert found
    near = {"v6", *(w for e in crooked[0].edges.values() if "v6" in e for w in e)}
    near |= {"v0", *(w for e in crooked[0].edges.values() if "v0" in e for w in e)}
    assert {a.at for a in found} <= near
    assert len(set(found)) == len(found)


@pytest.mark.parametrize("turned", [False, True])
def test_a_line_in_pieces_has_one_right_angle_at_a_vertex(turned):
    pieces = {"e1": ("v1", "v2"), "e2": ("v3", "v2") if turned else ("v2", "v3")}
    drawn = {"v1": (0, 0), "v2": (10, 0), "v3": (30, 0), "v4": (10.4, 9)}
    graph = SketchGraph(vertices=drawn, edges={**pieces, "e3": ("v2", "v4")})
    places = {v: np.array((*p, 0.0)) for v, p in drawn.items()}
    found = evident(graph, lifted(graph, places))
    (angle,) = (a for a in found if isinstance(a, RightAngle))
    assert angle.at == "v2"
    # Said of either piece, it is said of both.
    for piece in pieces:
        said = replace(graph, annotations={"a1": RightAngle("v2", (piece, "e3"))})
        assert not any(isinstance(a, RightAngle) for a in evident(said, lifted(said, places)))


def test_lowest_vertices_are_suggested_as_the_ground(crooked):
    (ground,) = (a for a in evident(*crooked) if isinstance(a, Ground))
    assert set(ground.vertices) == {"v0", "v1", "v2", "v3"}


def test_vertex_nearly_on_the_ground_is_suggested(crooked):
    graph, solution = crooked
    said = replace(graph, annotations={"a1": Ground(("v1", "v2", "v3"))})
    down = {v: x - (0, 0, 10) for v, x in solution.vertices_mm.items()}
    found = evident(said, lifted(said, down))
    assert Ground(("v0",)) in found
    after = taken(said, [a for a in found if isinstance(a, Ground)])
    assert after.annotations["a1"].vertices == ("v1", "v2", "v3", "v0")


def test_parallels_come_as_one_group(crooked):
    graph, solution = crooked
    # Sheared: no right angles, and the uprights nearly parallel.
    shear = np.array([[1, 0.6, 0.5], [0, 1, 0.4], [0, 0, 1]])
    leaning = {v: shear @ x for v, x in solution.vertices_mm.items()}
    found = evident(graph, lifted(graph, leaning))
    groups = [a for a in found if isinstance(a, Parallel)]
    assert groups
    edges = [e for a in groups for e in a.edges]
    assert len(edges) == len(set(edges))


def test_nothing_is_evident_where_annotations_disagree(crooked):
    graph, solution = crooked
    assert evident(graph, replace(solution, status=Status.CONFLICTING)) == ()
    assert evident(graph, replace(solution, vertices_mm={})) == ()


def test_what_is_taken_or_gone_is_no_suggestion_any_more(crooked):
    graph, solution = crooked
    found = evident(graph, solution)
    first = found[0]
    assert still_open(graph, found) == found
    assert first not in still_open(taken(graph, (first,)), found)
    assert still_open(taken(graph, found), found) == ()
    smaller = replace(graph, vertices={}, edges={})
    assert still_open(smaller, found) == ()


def test_right_angles_that_make_a_loop_flat_go_before_it():
    graph = loose_house(0.004, slope_told=True)
    found = evident(graph, solve(graph))
    assert found
    assert all(isinstance(a, RightAngle) for a in found)
    after = solve(taken(graph, found))
    assert len(after.faces) == 7


def test_nearly_flat_loops_are_suggested_and_listed_once_taken():
    graph = loose_house(0.004, slope_told=False)
    found = evident(graph, solve(graph))
    assert {frozenset(flat.loop) for flat in found} == set(GABLES)
    after = taken(graph, found)
    assert len(after.faces) == 7
    assert still_open(graph, found) == found
    assert still_open(after, found) == ()
    walls = dict(list(graph.edges.items())[1:])
    assert still_open(replace(graph, edges=walls, annotations={}), found) == ()
    assert evident(after, solve(after)) == ()
