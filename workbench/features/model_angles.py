"""Angles that a lifted model says of its corners: they stand with the model, not in the sketch.

A sketch file knows right angles only. Other ones are a matter of the model: kept in a property of
it as JSON, ``[["e1", "e2", 60.0]]``, and said to the solver beside the sketch.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from .properties import Editor, Property

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph

Corner = tuple[str, str]

SAID = Property(
    "App::PropertyString",
    "SaidAngles",
    "Model",
    "The angles that are said of this model's corners: two edges and the degrees between them",
    editor=Editor.HIDDEN,
)
#: More corners than these no sketch has.
MAX_SAID = 40_000
#: Longer ones are none of ours.
MAX_TEXT = 4_000_000


def said_angles(obj: Any) -> Mapping[Corner, float]:
    """What a lifted model says of its corners, degrees.

    Raises
    ------
    SketchError
        Where the property's text is none of ours.
    """
    return angles_of(obj.SaidAngles) if SAID.name in obj.PropertiesList else {}


def say_angles(obj: Any, angles_deg: Mapping[Corner, float]) -> None:
    """Have a lifted model say these angles, and no others."""
    text = text_of(angles_deg)
    if obj.SaidAngles != text:
        obj.SaidAngles = text


def text_of(angles_deg: Mapping[Corner, float]) -> str:
    """Angles as text in one line; empty where none is said."""
    return json.dumps([[*corner, a] for corner, a in angles_deg.items()]) if angles_deg else ""


def angles_of(text: str) -> dict[Corner, float]:
    """Angles from their text.

    Raises
    ------
    SketchError
        Where it is none.
    """
    if not text:
        return {}
    from ...solver.errors import SketchFormatError
    from ...solver.reading.json_reading import a_list, a_number, an_id

    try:
        body = json.loads(text[:MAX_TEXT])
    except (ValueError, RecursionError) as error:
        raise SketchFormatError("the model's angles are no JSON", (), "say them anew") from error
    found: dict[Corner, float] = {}
    for k, one in enumerate(a_list(body, SAID.name, 0, MAX_SAID)):
        place = f"{SAID.name}[{k}]"
        first, second, angle_deg = a_list(one, place, 3, 3)
        corner = (an_id(first, place), an_id(second, place))
        found[corner] = a_number(angle_deg, place)
    return found


def in_order(graph: SketchGraph, angles_deg: Mapping[Corner, float]) -> dict[Corner, float]:
    """Angles of corners that are there, each corner's edges in the order of the graph."""
    order = {edge: k for k, edge in enumerate(graph.edges)}
    found: dict[Corner, float] = {}
    for corner, angle_deg in angles_deg.items():
        first, second = sorted(corner, key=lambda edge: order.get(edge, -1))
        if first != second and _meet(graph, first, second):
            found[(first, second)] = angle_deg
    return found


def _meet(graph: SketchGraph, first: str, second: str) -> bool:
    there = first in graph.edges and second in graph.edges
    return there and bool(set(graph.edges[first]) & set(graph.edges[second]))
