"""What traced lines say of the perspective, line by line."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from rectangles import camera_at
from scenes import Views, bookshelf, box, photograph, photograph_exactly, with_traced_box

from incontext.solver import save_sketch, solve
from incontext.solver.perspective.vanishing_points import FAR_OFF, traced_lines
from incontext.workbench.cli import main
from incontext.workbench.panels.traced_texts import words_of


def scene(seed=2, trace_px=0.0, **views):
    rng = np.random.default_rng(seed)
    photo = photograph(box(), rng, views=Views(**views))
    return with_traced_box(photo, rng, trace_px=trace_px).graph


def test_exact_lines_are_exactly_on():
    graph = scene()
    traced = traced_lines(graph, solve(graph))
    assert len(traced.lines) == 12
    assert sorted(len(bundle.edges) for bundle in traced.bundles) == [4, 4, 4]
    assert max(line.off_px for line in traced.lines.values()) < 1e-6
    assert traced.notes == ()


def test_residuals_are_those_of_the_tracing():
    """With errors of the size that is expected, few lines are more than two errors off."""
    off = []
    for seed in range(6):
        graph = scene(seed, trace_px=1.5 * np.sqrt(2))
        off += [line.off_sigmas for line in traced_lines(graph, solve(graph)).lines.values()]
    # The solution has taken some of the errors up.
    assert 0.3 < np.sqrt(np.mean(np.square(off))) < 1.1
    assert np.mean(np.array(off) > 2) < 0.05
    assert max(off) < FAR_OFF


def test_a_line_drawn_wrong_is_named():
    graph = scene()
    edge = graph.construction[5]
    a, b = graph.edges[edge]
    (u, v), (x, y) = graph.vertices[a], graph.vertices[b]
    # A line of its own beside it: no other edge moves with it.
    vertices = {**graph.vertices, "l1": (u + 4, v + 9), "l2": (x - 4, y - 9)}
    edges = {**graph.edges, "loose": ("l1", "l2")}
    longer = replace(
        graph, vertices=vertices, edges=edges, construction=(*graph.construction, "loose")
    )
    solution = solve(graph)
    told = {**solution.vertices_mm, "l1": solution.vertices_mm[a], "l2": solution.vertices_mm[b]}
    judged = traced_lines(
        longer, replace(solution, vertices_mm=told, edges={**solution.edges, "loose": ("l1", "l2")})
    )
    length = np.hypot(x - u - 8, y - v - 18)
    line = judged.lines["loose"]
    assert line.off_px == pytest.approx(length / 2 * np.sin(line.off_rad))
    assert line.off_sigmas > FAR_OFF
    assert "The traced line loose is" in judged.notes[0]


def test_lines_that_are_nearly_parallel_say_nothing():
    """From far away with a long lens; EXIF would tell instead."""
    graph = scene(0, trace_px=1.0, fov_deg=(1.0, 1.2))
    solution = solve(graph)
    traced = traced_lines(graph, solution)
    assert all(bundle.says_nothing for bundle in traced.bundles)
    assert any("too nearly parallel" in note for note in traced.notes)
    told = replace(graph, photo=replace(graph.photo, focal_px=80000.0))
    assert not any("parallel" in note for note in traced_lines(told, solution).notes)
    near = scene(0, trace_px=1.0, fov_deg=(60.0, 65.0))
    assert not all(bundle.says_nothing for bundle in traced_lines(near, solve(near)).bundles)


def test_the_panel_says_it_in_a_sentence():
    graph = scene(trace_px=1.0)
    words, each = words_of(graph, solve(graph))
    assert words.startswith("12 traced lines, the worst (te")
    assert each.count("\n") == 11
    assert words_of(replace(graph, construction=()), solve(graph)) == ("", "")


def test_a_sketch_without_traced_lines_has_nothing_to_say():
    graph = replace(scene(), construction=())
    assert traced_lines(graph, solve(graph)).lines == {}


def cropped(crop_px, rng, noise_px=0.5):
    """A shelf traced all over a photo of which the left and the top were cut away."""
    shape = bookshelf()
    middle = (shape.X.min(axis=0) + shape.X.max(axis=0)) / 2
    camera = camera_at(35, -50, 550, 900)
    graph = photograph_exactly(replace(shape, X=shape.X - middle), camera)
    drawn = np.array([*graph.vertices.values()]) - crop_px
    drawn = drawn + rng.normal(0, noise_px, drawn.shape)
    return replace(
        graph,
        photo=replace(graph.photo, width_px=1600 - crop_px[0], height_px=1200 - crop_px[1]),
        vertices=dict(zip(graph.vertices, map(tuple, drawn.tolist()), strict=True)),
        construction=tuple(graph.edges),
    )


def test_a_cropped_photo_is_told_by_its_lines():
    rng = np.random.default_rng(4)
    graph = cropped((300, 150), rng)
    (note,) = traced_lines(graph, solve(graph)).notes
    assert "cropped" in note
    u, v = map(float, re.search(r"towards (\d+), (\d+) px", note).groups())
    assert np.hypot(u - 500, v - 450) < 40
    told = replace(graph, photo=replace(graph.photo, principal_point_px=(500.0, 450.0)))
    assert traced_lines(told, solve(told)).notes == ()
    whole = cropped((0, 0), rng)
    assert traced_lines(whole, solve(whole)).notes == ()


def test_the_command_says_it_line_by_line(tmp_path, capsys):
    path = tmp_path / "desk.sketch.json"
    graph = scene(trace_px=1.0)
    save_sketch(graph, path)
    assert main(["camera", str(path)]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed[0].startswith("camera: ")
    assert sum(line.startswith("  te") for line in printed) == 12
    save_sketch(replace(graph, construction=()), path)
    assert main(["camera", str(path)]) == 2
    assert "try:" in capsys.readouterr().err
