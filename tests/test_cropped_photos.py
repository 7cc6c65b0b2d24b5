"""What is said of photos that may have been cropped."""

from __future__ import annotations

from dataclasses import replace

import pytest

from incontext.solver import load_sketch, save_sketch, solve
from incontext.solver.camera import Camera
from incontext.solver.graph import Photo, SketchGraph
from incontext.solver.perspective.vanishing_points import Traced, traced_lines
from incontext.workbench.cli import main
from incontext.workbench.cropped_photos import may_be_cropped, perspective_notes
from incontext.workbench.examples import example_path
from incontext.workbench.panels.traced_texts import words_of


def tidy(principal_px):
    """The desk tidy over its cropped photo, with or without where it looked."""
    graph = load_sketch(example_path("desk_tidy"))
    return replace(graph, photo=replace(graph.photo, principal_point_px=principal_px))


@pytest.mark.parametrize(
    ("size_px", "said"),
    [
        ((1600, 1200), False),
        ((1200, 1600), False),
        ((4000, 2250), False),
        ((3000, 2000), False),
        ((2000, 2000), False),
        # 4:3 in whole px, as cameras round it.
        ((4032, 3024), False),
        ((1600, 1100), True),
        ((1100, 1600), True),
        ((1600, 500), True),
    ],
)
def test_shapes_of_cameras_are_known_either_way_up(size_px, said):
    assert bool(may_be_cropped(SketchGraph(photo=Photo("a.jpg", *size_px)))) is said


def test_where_a_photo_looked_is_not_asked_twice():
    photo = Photo("a.jpg", 1600, 1100)
    (note,) = may_be_cropped(SketchGraph(photo=photo))
    assert "1600 x 1100 px" in note
    assert may_be_cropped(SketchGraph(photo=replace(photo, principal_point_px=(9.0, 9.0)))) == ()
    camera = Camera(900.0, (800, 550), [[1, 0, 0], [0, 0, -1], [0, 1, 0]], [0, 500, 2000])
    assert may_be_cropped(SketchGraph(photo=photo, camera=camera)) == ()
    assert may_be_cropped(SketchGraph()) == ()


def test_it_is_said_once_where_the_lines_tell_it_better():
    graph = SketchGraph(photo=Photo("a.jpg", 1600, 1100))
    told = Traced({}, (), ("The photo may be cropped: it looks towards 1, 2 px.",))
    assert perspective_notes(graph, told) == told.notes
    other = Traced({}, (), ("The traced line e1 is 9.0 px off.",))
    assert perspective_notes(graph, other) == (*other.notes, *may_be_cropped(graph))


@pytest.mark.parametrize(("principal_px", "said"), [(None, True), ((950.0, 460.0), False)])
def test_the_panel_and_the_commands_say_it(principal_px, said, tmp_path, capsys):
    """One paperback does not tell it by its lines, but without it sizes are 9 % off."""
    graph = tidy(principal_px)
    solution = solve(graph)
    assert not any("cropped" in note for note in traced_lines(graph, solution).notes)
    assert ("1600 x 1100 px" in words_of(graph, solution)[0]) is said
    save_sketch(graph, tmp_path / "tidy.sketch.json")
    for command in ("camera", "check"):
        main([command, str(tmp_path / "tidy.sketch.json")])
        assert ("1600 x 1100 px" in capsys.readouterr().out) is said
