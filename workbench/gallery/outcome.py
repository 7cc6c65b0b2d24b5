"""What comes of an example: made once, measured, and compared with what is expected of it.

Terms
-----
gesture
    What a hand does at once to draw and annotate the sketch anew: a line dragged, a circle dragged,
    a face clicked for its four right angles, a click, a length typed.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from ...solver import load_sketch, solve
from ...solver.annotations import Ground, RightAngle
from ...solver.graph import SketchGraph
from ...solver.model import Model, build_model
from ...solver.solution import Solution
from ...solver.values import Array, forget_kept
from ..examples import Example
from ..fabrication.meshes import Mesh, mesh_of
from ..fabrication.plates import Joined, joined_plates
from ..fabrication.sheets import Sheet, lay_out
from ..fabrication.shell import shell_solid

if TYPE_CHECKING:
    from ..fabrication.checking import Check

#: What it took with real mouse and keys in FreeCAD, each key and each typed letter counted: tools
#: chosen, drawn, annotated, made. The lid is like the example's, on a table instead of tiles; the
#: organizer is without the notes beside it, its own width given instead.
REPLAYED = {
    "bookshelf": 39,
    "organizer": 36,
    "desk_tidy": 74,
    "teapot_lid": 19,
    "cup_saucer": 17,
    "scissors_cover": 50,
    "chair_box": 44,
}
#: A picture needs no finer triangles.
_PICTURE_MM = 0.2


@dataclass(frozen=True, slots=True, eq=False)
class Outcome:
    """An example, solved and made.

    Parameters
    ----------
    example : Example
    graph : SketchGraph
    solution : Solution
    model : Model
    solve_ms : float
        Of the processor, from nothing.
    facts : dict
        As in `Example.facts`.
    joined : Joined or None
    sheets : tuple of Sheet
    mesh : Mesh or None
    """

    example: Example
    graph: SketchGraph
    solution: Solution
    model: Model
    solve_ms: float
    facts: dict[str, Any]
    joined: Joined | None = None
    sheets: tuple[Sheet, ...] = ()
    mesh: Mesh | None = None
    checks: tuple[Check, ...] = field(default=())


def solved(example: Example) -> tuple[SketchGraph, Solution, float]:
    """The sketch, its solution, and the processor's time, ms, from nothing."""
    graph = load_sketch(example.sketch_path)
    solve(graph)  # everything is imported before the clock runs
    forget_kept()
    began = time.process_time()
    solution = solve(graph)
    return graph, solution, (time.process_time() - began) * 1e3


def outcome(example: Example) -> Outcome:
    """Solve and make an example.

    Raises
    ------
    SketchError, FabricationError
        Where nothing can be made of it.
    """
    from ..checked import plates_check, print_check

    graph, solution, ms = solved(example)
    if example.is_printed:
        model = build_model(solution, 3.0, graph.made_revolutions)
        shell = example.shell_settings()
        solid = shell_solid(model, shell)
        mesh = mesh_of(solid, _PICTURE_MM)
        facts = {"size_mm": _size(mesh.vertices_mm), "volume_mm3": solid.Volume()}
        check = print_check(mesh, model, graph, solution, shell.least_wall_mm)
        return Outcome(example, graph, solution, model, ms, facts, mesh=mesh, checks=(check,))
    settings = example.plate_settings()
    model = build_model(solution, settings.thickness_mm, graph.made_revolutions)
    joined = joined_plates(model, settings)
    sheets = tuple(lay_out(joined.plates, settings))
    corners = [
        np.column_stack(
            [plate.outline, np.full(len(plate.outline), z), np.ones(len(plate.outline))]
        )
        @ plate.world_from_plate.T
        for plate in joined.plates
        for z in (0.0, plate.thickness_mm)
    ]
    facts = {
        "size_mm": _size(np.concatenate(corners)[:, :3]),
        "plates": len(joined.plates),
        "joints": len(joined.joints),
        "cut_length_mm": cut_length_mm(sheets),
    }
    check = plates_check(joined, model, graph, solution)
    return Outcome(example, graph, solution, model, ms, facts, joined, sheets, checks=(check,))


def _size(points: Array) -> list[float]:
    return [float(side) for side in np.ptp(points, axis=0)]


def cut_length_mm(sheets: tuple[Sheet, ...]) -> float:
    """The length of all cut paths."""
    rings = (ring for sheet in sheets for part in sheet.parts for ring in (part.outer, *part.inner))
    return float(
        sum(np.linalg.norm(b - a) for ring in rings for a, b in pairwise([*ring, ring[0]]))
    )


def gestures(graph: SketchGraph) -> int:
    """How many gestures a person needs: a drag for each line and circle, and clicks."""
    drawn = len(graph.edges) + len(graph.circles)
    angles = {
        (a.at, frozenset(a.between))
        for a in graph.annotations.values()
        if isinstance(a, RightAngle)
    }
    clicks = 0
    for corners in _quadrilaterals(graph):
        if corners & angles and corners <= angles | corners and len(corners & angles) >= 3:
            clicks += 1
            angles -= corners
    clicks += len(angles)
    for annotation in graph.annotations.values():
        if isinstance(annotation, Ground):
            clicks += len(annotation.vertices)
        elif not isinstance(annotation, RightAngle):
            # The things that are meant, one after the other, and Enter.
            clicks += 1 + len(getattr(annotation, "edges", ("",)))
    left_out = [face for face in (graph.faces or {}).values() if not face.included]
    return drawn + clicks + len(left_out)


def gestures_in_words(name: str, graph: SketchGraph) -> str:
    """How many by the rule of `gestures`, and where they were replayed, how many it took."""
    replayed = REPLAYED.get(name)
    return str(gestures(graph)) + ("" if replayed is None else f" ({replayed})")


def _quadrilaterals(graph: SketchGraph) -> Iterator[set[tuple[str, frozenset[str]]]]:
    """The four corners of each drawn face with four sides, as right angles name them."""
    edge_at = {frozenset(ends): id_ for id_, ends in graph.edges.items()}
    near: dict[str, set[str]] = {}
    for v, w in graph.edges.values():
        near.setdefault(v, set()).add(w)
        near.setdefault(w, set()).add(v)
    seen = set()
    for a in near:
        for b in near[a]:
            for c in near[b] - {a}:
                for d in (near[c] & near[a]) - {b}:
                    loop = (a, b, c, d)
                    if frozenset(loop) in seen:
                        continue
                    seen.add(frozenset(loop))
                    yield {
                        (v, frozenset((edge_at[frozenset((u, v))], edge_at[frozenset((v, w))])))
                        for u, v, w in zip((d, a, b, c), loop, (b, c, d, a), strict=True)
                    }
