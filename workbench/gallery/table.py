"""The gallery's table: what each example should be, and what came out."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from ...solver import load_sketch, solve
from ...solver.annotations import Length
from ...solver.camera import Camera
from ...solver.perspective.marker import camera_from_rectangle
from ...solver.perspective.rectangle_reading import on_ground
from ...solver.perspective.refining import refined_camera
from ...solver.solution import Solution
from ...solver.values import Array
from ..examples import EXAMPLES, load_example
from .outcome import Outcome, gestures_in_words, solved

#: A marker that could have lain in front of the books, mm, and how well corners are found.
MARKER_MM, MARKER_AT_MM, CORNER_PX = 100.0, (100.0, -110.0, 0.0), 0.15
#: One line: what, found, true, the difference in parts, and what the paper's users had.
Row = tuple[str, float, float, float, str]


def comparisons(name: str, solution: Solution, truth: dict[str, Any]) -> list[Row]:
    """Found beside true, for what an example has of existing things."""
    rows = _COMPARED[name](solution, truth) if name in _COMPARED else []
    return [(what, found, true, found / true - 1, users) for what, found, true, users in rows]


def bench_lines() -> Iterator[str]:
    """The lines that ``incontext bench`` prints of the shipped examples."""
    yield "The shipped examples, from their sketches (see the gallery): found beside true."
    yield "Gestures by rule; in brackets as replayed with mouse and keys, typed letters counted."
    row = "{:<16} {:>7} {:>8}  {:<34} {:>7} {:>7} {:>7}  {}"
    yield row.format("example", "time", "gestures", "what", "found", "true", "off", "paper's users")
    for name in EXAMPLES:
        example = load_example(name)
        graph, solution, ms = solved(example)
        began = (name, f"{ms:.0f} ms", gestures_in_words(name, graph))
        for what, found, true, off, users in comparisons(name, solution, example.truth):
            measured = (f"{found:.4g}", f"{true:.4g}", f"{100 * off:+.1f} %")
            yield row.format(*began, what, *measured, users).rstrip()
            began = ("", "", "")
    yield ""
    yield from _marker_lines()


def _marker_lines() -> Iterator[str]:
    """The bookshelf with a marker of 100 mm on the desk, where no length is told."""
    offs = 100 * np.abs(with_marker(10))
    yield "The bookshelf's inside, had a marker of 100 mm lain on the desk (corners to 0.15 px,"
    yield (
        "10 draws, camera by marker and drawing together): both proportions off by at most "
        f"{offs.max():.1f} %, median {np.median(offs):.1f} %."
    )


def with_marker(draws: int) -> Array:
    """How far the bookshelf's proportions are off, in parts, (draws, 2)."""
    example = load_example("bookshelf")
    graph, told = load_sketch(example.sketch_path), example.truth["camera"]
    said = {id_: a for id_, a in graph.annotations.items() if not isinstance(a, Length)}
    graph = replace(graph, annotations=said)
    camera = Camera(
        told["focal_px"],
        told["principal_point_px"],
        told["rotation_cam_from_world"],
        told["translation_cam_from_world_mm"],
    )
    corners = np.column_stack([on_ground((MARKER_MM, MARKER_MM)), np.zeros(4)]) + MARKER_AT_MM
    rng, found = np.random.default_rng(7), []
    for _ in range(draws):
        seen = camera.project(corners) + rng.normal(0, CORNER_PX, (4, 2))
        assert graph.photo is not None
        view = camera_from_rectangle(
            graph.photo, seen, (MARKER_MM, MARKER_MM), corner_sigma_px=CORNER_PX
        )
        refined = refined_camera(graph, view)
        assert refined is not None
        solution = solve(replace(graph, camera=refined))
        rows = comparisons("bookshelf", solution, example.truth)
        found.append([off for *_, off, _ in rows])
    return np.array(found)


def facts_lines(outcomes: list[Outcome]) -> Iterator[str]:
    """The table of facts as Markdown."""
    yield "| | size, mm | made of | solve | gestures | measured, true |"
    yield "| --- | --- | --- | --- | --- | --- |"
    for made in outcomes:
        name, facts = made.example.name, made.facts
        size = " x ".join(f"{side:.0f}" for side in facts["size_mm"])
        if "plates" in facts:
            parts = f"{facts['plates']} plates, {facts['joints']} joints, "
            parts += f"{facts['cut_length_mm'] / 1000:.1f} m of cuts"
        else:
            parts = f"{facts['volume_mm3'] / 1000:.1f} cm3 of material"
        compared = [
            f"{what} {found:.4g}, {true:.4g} ({100 * off:+.1f} %)"
            for what, found, true, off, _ in comparisons(name, made.solution, made.example.truth)
        ]
        yield (
            f"| {made.example.title} | {size} | {parts} | {made.solve_ms:.0f} ms | "
            f"{gestures_in_words(name, made.graph)} | {'; '.join(compared)} |"
        )


Found = list[tuple[str, float, float, str]]


def _long(solution: Solution, a: str, b: str) -> float:
    return float(np.linalg.norm(solution.vertices_mm[b] - solution.vertices_mm[a]))


def _bookshelf(solution: Solution, truth: dict[str, Any]) -> Found:
    books, X, thickness = truth["books"], solution.vertices_mm, 3.0
    width, depth = _long(solution, "v1", "v2") - 2 * thickness, _long(solution, "v2", "v3")
    # The front is open; the shelf's face is its middle.
    depth, height = depth - thickness, float(X["v5"][2]) - 1.5 * thickness
    high = books["height_mm"]
    return [
        ("inside, height : length", height / depth, high / books["depth_mm"], "-8 to +4 %"),
        ("inside, height : width", height / width, high / books["width_mm"], "-20 to +11 %"),
    ]


def _organizer(solution: Solution, truth: dict[str, Any]) -> Found:
    high = float(solution.vertices_mm["t1"][2])
    notes = truth["notes"]
    return [
        ("traced notes, other side, mm", _long(solution, "t4", "t1"), notes["side_mm"], ""),
        ("traced notes, height, mm", high, notes["height_mm"], ""),
    ]


def _desk_tidy(solution: Solution, truth: dict[str, Any]) -> Found:
    high, book = float(solution.vertices_mm["t1"][2]), truth["book"]
    return [
        ("traced book, length, mm", _long(solution, "t2", "t3"), book["length_mm"], ""),
        ("traced book, height, mm", high, book["height_mm"], ""),
    ]


def _teapot_lid(solution: Solution, truth: dict[str, Any]) -> Found:
    rim = truth["teapot"]["rim_diameter_mm"]
    return [("lid and rim, diameter, mm", 2 * solution.circles["c2"].radius_mm, rim, "")]


def _cup_saucer(solution: Solution, truth: dict[str, Any]) -> Found:
    assert solution.camera is not None
    foot, focal = truth["cup"]["foot_diameter_mm"], truth["camera"]["focal_px"]
    return [
        ("flat and cup's foot, diameter, mm", 2 * solution.circles["c2"].radius_mm, foot, ""),
        ("focal length by the marker, px", solution.camera.focal_px, focal, ""),
    ]


def _scissors_cover(solution: Solution, truth: dict[str, Any]) -> Found:
    assert solution.camera is not None
    return [
        ("focal length by A5, px", solution.camera.focal_px, truth["camera"]["focal_px"], ""),
    ]


def _chair_box(solution: Solution, truth: dict[str, Any]) -> Found:
    deep = truth["chair"]["legs_depth_mm"]
    return [("traced legs, depth, mm", _long(solution, "g1", "g3"), deep, "")]


_COMPARED: dict[str, Callable[[Solution, dict[str, Any]], Found]] = {
    "bookshelf": _bookshelf,
    "organizer": _organizer,
    "desk_tidy": _desk_tidy,
    "teapot_lid": _teapot_lid,
    "cup_saucer": _cup_saucer,
    "scissors_cover": _scissors_cover,
    "chair_box": _chair_box,
}
