"""Annotations taken away: what is left free, against the rank of everything that was said."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from scenes import SHAPES, Views, box, l_shape, photograph

from incontext.solver import solve
from incontext.solver.annotations import EqualLength, Ground, Length, RightAngle
from incontext.solver.energies import ENERGIES
from incontext.solver.problem import leftover_constraints
from incontext.solver.solution import Status
from incontext.solver.structure import build_structure


def independent_structure(graph):
    """As if no annotation shared any coordinate: all of them are left over as constraints."""
    tied = build_structure(graph)
    n = len(graph.vertices)
    return replace(
        tied,
        edge_axis=np.full_like(tied.edge_axis, -1),
        edge_across=np.zeros_like(tied.edge_across),
        coordinate=np.arange(3 * n).reshape(n, 3),
        n_coordinates=3 * n,
        balances=tied.balances[:0],
        balance_owners=(),
        vertical=None,
        has_axes=False,
    )


def rows_of_everything(graph, solution) -> np.ndarray:
    """Derivatives of the projection and of all annotations, by positions and focal length."""
    camera = solution.camera
    X = np.array([solution.vertices_mm[v] for v in graph.vertices])
    X = X @ camera.rotation_cam_from_world.T + camera.translation_cam_from_world_mm
    X = X / X[:, 2].mean()
    n = len(X)
    seen = np.zeros((2 * n, 3 * n + 1))
    for i, (x, y, z) in enumerate(X):
        seen[2 * i, [3 * i, 3 * i + 2]] = 1 / z, -x / z**2
        seen[2 * i + 1, [3 * i + 1, 3 * i + 2]] = 1 / z, -y / z**2
        # By the logarithm of the focal length.
        seen[[2 * i, 2 * i + 1], -1] = x / z, y / z
    parts = [seen]
    for block in leftover_constraints(graph, independent_structure(graph)):
        extra = () if block.wanted is None else (block.wanted,)
        at = ENERGIES[block.energy](X, block.items, *extra)
        H = np.zeros((len(at.residual), 3 * n + 1))
        for k in range(3):
            np.add.at(H, (at.row, 3 * at.vertex + k), at.value[:, k])
        parts.append(H)
    if solution.report.focal_assumed:
        parts.append(np.eye(3 * n + 1)[-1:])
    return np.vstack(parts)


def null_space(A: np.ndarray) -> np.ndarray:
    A = np.vstack([A, np.zeros((max(0, A.shape[1] - len(A)), A.shape[1]))])
    _, s, Vt = np.linalg.svd(A, full_matrices=False)
    return Vt[s <= 1e-9 * s[0]]


def free_and_loose(graph, solution) -> tuple[int, set[str]]:
    """Freedoms but for the overall size, and what they move against the largest part."""
    null = null_space(rows_of_everything(graph, solution))
    camera = solution.camera
    X = np.array([solution.vertices_mm[v] for v in graph.vertices])
    depth = (X @ camera.rotation_cam_from_world.T + camera.translation_cam_from_world_mm)[:, 2]
    motion = null[:, 2:-1:3] / (depth / depth.mean())
    U, s, _ = np.linalg.svd(motion.T, full_matrices=False)
    steps = np.round(U[:, s > 1e-9 * s[0]], 5)
    _, part, sizes = np.unique(steps, axis=0, return_inverse=True, return_counts=True)
    part = part.reshape(-1)
    largest = part[int(np.argmax(sizes[part]))]
    names = zip(graph.vertices, part, strict=True)
    return len(null) - 1, {v for v, p in names if p != largest}


@pytest.mark.parametrize("seed", range(40))
def test_freedoms_equal_the_truth(seed):
    rng = np.random.default_rng(seed)
    make = SHAPES[seed % len(SHAPES)]
    photo = photograph(make(), rng, noise=(0.0, 0.005)[seed % 2])
    part = rng.uniform(0.3, 1.0)
    kept = {k: a for k, a in photo.graph.annotations.items() if rng.random() < part}
    graph = replace(photo.graph, annotations=kept)
    solution = solve(graph)
    assert solution.status is not Status.NOT_CONVERGED
    free, loose = free_and_loose(graph, solution)
    assert solution.report.degrees_of_freedom == free
    if free:
        assert solution.status is not Status.CONVERGED
        assert set(solution.report.loose) == loose


def test_true_annotations_are_seldom_blamed_when_few_are_left():
    blamed = 0
    for seed in range(18):
        rng = np.random.default_rng(100 + seed)
        photo = photograph(SHAPES[seed % 9](), rng)
        kept = {k: a for k, a in photo.graph.annotations.items() if rng.random() < 0.6}
        blamed += bool(solve(replace(photo.graph, annotations=kept)).report.conflicts)
    assert blamed <= 1


def test_a_complete_sketch_has_no_freedom():
    graph = photograph(box(), np.random.default_rng(0)).graph
    solution = solve(graph)
    assert free_and_loose(graph, solution) == (0, set())
    assert solution.report.degrees_of_freedom == 0


def kept_of(photo, *kinds):
    said = {k: a for k, a in photo.graph.annotations.items() if isinstance(a, kinds)}
    return replace(photo.graph, annotations=said)


def test_what_says_no_direction_asks_for_right_angles():
    photo = photograph(box(), np.random.default_rng(0), noise=0.005)
    equal = {"q": EqualLength(("e0", "e2")), "r": EqualLength(("e1", "e3"))}
    for graph in (kept_of(photo), replace(photo.graph, annotations=equal)):
        solution = solve(graph)
        assert solution.status is Status.UNDERDETERMINED
        assert "nothing is said to be square or parallel; begin with right angles at v0" in (
            solution.message
        )
        assert "focal length" in solution.message


@pytest.mark.parametrize("seed", range(4))
def test_the_corner_that_is_named_takes_a_freedom_away(seed):
    rng = np.random.default_rng(seed)
    photo = photograph(l_shape(), rng, noise=0.005)
    graph = kept_of(photo, Ground, Length)
    for id_, a in photo.graph.annotations.items():
        before = solve(graph)
        if "would help most" in before.message:
            break
        graph = replace(graph, annotations={**graph.annotations, id_: a})
    e, f, v = re.search(r"If (\w+) and (\w+) are square at (\w+)", before.message).groups()
    more = {**graph.annotations, "named": RightAngle(v, (e, f))}
    after = solve(replace(graph, annotations=more))
    assert after.report.degrees_of_freedom < before.report.degrees_of_freedom


def test_an_untold_focal_length_is_said_whatever_else_is():
    views = Views(elevation_deg=(0.5, 1.0), azimuth_deg=(-90.2, -89.8))
    for seed in range(4):
        photo = photograph(box(), np.random.default_rng(seed), noise=0.005, views=views)
        solution = solve(photo.graph)
        assert solution.report.focal_assumed
        assert "focal length" in solution.message
