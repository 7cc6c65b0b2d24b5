"""Faces found in 3D."""

from __future__ import annotations

import numpy as np
import pytest
from scenes import (
    bookshelf,
    box,
    hexagonal_box,
    house,
    l_shape,
    organizer,
    photograph,
    staircase,
    v,
    wedge,
)
from scipy.spatial.transform import Rotation

from incontext.solver import faces, solve
from incontext.solver.faces import find_faces


def found_loops(shape, move=lambda X: X):
    X = move(shape.X)
    vertices = {v(i): x for i, x in enumerate(X)}
    edges = {f"e{k}": (v(a), v(b)) for k, (a, b) in enumerate(shape.edges)}
    return find_faces(vertices, edges)


@pytest.mark.parametrize(
    "make", [box, l_shape, wedge, house, staircase, hexagonal_box, organizer, bookshelf]
)
def test_the_faces_of_a_shape_are_found(make):
    shape = make()
    faces = found_loops(shape)
    wanted = {frozenset(v(i) for i in loop) for loop in shape.loops}
    assert {frozenset(face.loop) for face in faces.values()} == wanted
    assert list(faces) == [f"f{k}" for k in range(1, len(faces) + 1)]


def test_faces_do_not_depend_on_the_frame():
    shape = house()
    R = Rotation.from_rotvec([0.4, 1.3, -0.2]).as_matrix()
    turned = found_loops(shape, lambda X: 0.01 * X @ R.T + 5)
    assert [f.loop[0] for f in turned.values()] == [f.loop[0] for f in found_loops(shape).values()]


def test_loops_run_along_edges():
    shape = organizer(3, 2)
    joined = {frozenset((v(a), v(b))) for a, b in shape.edges}
    for face in found_loops(shape).values():
        sides = zip(face.loop, face.loop[1:] + face.loop[:1], strict=True)
        assert all(frozenset(side) in joined for side in sides)


def test_a_window_is_a_hole_and_a_face():
    square = np.array([[0, 0], [10, 0], [10, 10], [0, 10]], dtype=float)
    window = np.array([[3, 3], [6, 3], [6, 7], [3, 7]], dtype=float)
    flat = np.vstack([square, window])
    vertices = {v(i): np.array([x, 1.0, y]) for i, (x, y) in enumerate(flat)}
    rings = [(0, 1, 2, 3), (4, 5, 6, 7)]
    edges = {
        f"e{r}{k}": (v(ring[k - 1]), v(ring[k])) for r, ring in enumerate(rings) for k in range(4)
    }
    faces = list(find_faces(vertices, edges).values())
    assert [len(face.holes) for face in faces] == [1, 0]
    assert set(faces[0].holes[0]) == {"v4", "v5", "v6", "v7"}


def test_a_solve_looks_for_faces_when_they_are_asked_for(monkeypatch):
    looked = []
    find = faces.find_faces
    monkeypatch.setattr(faces, "find_faces", lambda *given: looked.append(1) or find(*given))
    solution = solve(photograph(box(), np.random.default_rng(1)).graph)
    assert not looked
    assert len(solution.faces) == 6
    assert len(looked) == 1


def test_dead_ends_and_open_chains_are_no_faces():
    vertices = {
        v(i): np.array(p, dtype=float) for i, p in enumerate([(0, 0, 0), (1, 0, 0), (1, 1, 0)])
    }
    assert find_faces(vertices, {"e0": ("v0", "v1"), "e1": ("v1", "v2")}) == {}
    assert find_faces({}, {}) == {}
