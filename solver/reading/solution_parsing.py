"""A solution out of plain JSON values."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..errors import SketchFormatError, SketchReferenceError
from ..graph import Face
from ..solution import FORMAT, MAX_MM, VERSION, Report, Residual, Solution, SolvedCircle, Status
from . import json_reading as read
from .parsing import MAX_EDGES, camera_from_json

#: What a solution of the largest sketch has, its mirrored copies included; and one line of text.
MAX_ENTRIES = 10 * MAX_EDGES
MAX_TEXT = 2_000

_KEYS = (
    "format", "version", "sketch_digest", "status", "message", "vertices", "edges", "faces",
    "circles", "camera", "scale_assumed", "report",
)  # fmt: skip
_REPORT_KEYS = (
    "degrees_of_freedom", "residuals", "reprojection_px", "conflicts", "iterations", "solve_ms",
)  # fmt: skip


def solution_from_json(value: Any) -> Solution:
    """The solution that a solution file's JSON says; raises SketchError."""
    body = read.an_object(value, "the solution")
    read.check_header(body, FORMAT, VERSION)
    read.check_keys(body, "the solution", _KEYS)
    try:
        status = Status(body["status"])
    except ValueError as error:
        raise SketchFormatError(
            f"status cannot be {str(body['status'])[:40]!r}", (), ", ".join(s.value for s in Status)
        ) from error
    solution = Solution(
        sketch=_text(body["sketch_digest"], "sketch_digest"),
        status=status,
        message=_text(body["message"], "message"),
        vertices_mm=_items(body["vertices"], "vertices", _position),
        edges=_items(body["edges"], "edges", _ends),
        faces=_items(body["faces"], "faces", _face),
        circles=_items(body["circles"], "circles", _circle),
        camera=None if body["camera"] is None else camera_from_json(body["camera"], MAX_MM),
        scale_assumed=read.a_bool(body["scale_assumed"], "scale_assumed"),
        report=_report(body["report"]),
    )
    _check_references(solution)
    return solution


def _check_references(solution: Solution) -> None:
    """Refuse edges and faces of vertices that are not there."""
    named: list[tuple[str, tuple[str, ...], int]] = [
        (f"edge {id_}", ends, 2) for id_, ends in solution.edges.items()
    ]
    for id_, face in solution.faces.items():
        named += [(f"face {id_}", loop, 3) for loop in face.loops]
    for place, ids, at_least in named:
        missing = [v for v in ids if v not in solution.vertices_mm]
        if missing:
            raise SketchReferenceError(
                f"{place[:50]} names a vertex that is not there", missing[:5], "solve again"
            )
        if len(ids) < at_least or len(set(ids)) < len(ids):
            raise SketchFormatError(
                f"{place[:50]} has too few vertices, or one twice", (), "solve again"
            )


def _text(value: Any, place: str) -> str:
    if not isinstance(value, str) or len(value) > MAX_TEXT or not value.isprintable():
        raise SketchFormatError(f"{place} is not a line of text", (), "solve again")
    return value


def _items(value: Any, place: str, item: Any) -> dict[str, Any]:
    # Ids of mirrored copies hold an '@', which drawn ids must not.
    entries = read.an_object(value, place)
    if len(entries) > MAX_ENTRIES:
        raise SketchFormatError(f"more than {MAX_ENTRIES} {place}", (), "a smaller sketch")
    return {_id(key, place): item(entry, f"{place}.{key}") for key, entry in entries.items()}


def _id(key: str, place: str) -> str:
    if not 0 < len(key) <= MAX_TEXT or not key.isprintable():
        raise SketchFormatError(f"{place}.{key[:12]} is not an id", (), "a short text")
    return key


def _position(value: Any, place: str) -> Any:
    entries = read.a_list(value, place, 3, 3)
    return np.array([read.a_number(x, place, limit=MAX_MM) for x in entries])


def _names(value: Any, place: str) -> tuple[str, ...]:
    entries = read.a_list(value, place)
    if not all(isinstance(entry, str) for entry in entries):
        raise SketchFormatError(f"{place} is not a list of ids", (), '["v1", "v2"]')
    return tuple(_id(entry, place) for entry in entries)


def _ends(value: Any, place: str) -> tuple[str, str]:
    v, w = _names(read.a_list(value, place, 2, 2), place)
    return (v, w)


def _face(value: Any, place: str) -> Face:
    body = read.an_object(value, place)
    read.check_keys(body, place, ("loop",), ("holes", "included", "thickness_mm"))
    thickness = body.get("thickness_mm")
    return Face(
        _names(body["loop"], place),
        tuple(_names(hole, place) for hole in read.a_list(body.get("holes", []), place)),
        read.a_bool(body.get("included", True), place),
        None if thickness is None else read.a_number(thickness, place, above=0.0),
    )


def _circle(value: Any, place: str) -> SolvedCircle:
    body = read.an_object(value, place)
    read.check_keys(body, place, ("center", "radius_mm"))
    return SolvedCircle(
        _position(body["center"], place), read.a_number(body["radius_mm"], place, limit=MAX_MM)
    )


def _residual(value: Any, place: str) -> Residual:
    body = read.an_object(value, place)
    read.check_keys(body, place, ("value", "unit"))
    return Residual(read.a_number(body["value"], place, limit=1e300), _text(body["unit"], place))


def _count(value: Any, place: str) -> int:
    number = read.a_number(value, place)
    if number < 0 or number != int(number):
        raise SketchFormatError(f"{place} cannot be {number:g}", (), "a whole number")
    return int(number)


def _report(value: Any) -> Report:
    body = read.an_object(value, "report")
    read.check_keys(body, "report", _REPORT_KEYS)
    return Report(
        degrees_of_freedom=_count(body["degrees_of_freedom"], "degrees_of_freedom"),
        residuals=_items(body["residuals"], "residuals", _residual),
        reprojection_px=_items(
            body["reprojection_px"],
            "reprojection_px",
            lambda v, p: read.a_number(v, p, limit=1e300),
        ),
        conflicts=_names(body["conflicts"], "conflicts"),
        iterations=_count(body["iterations"], "iterations"),
        solve_ms=read.a_number(body["solve_ms"], "solve_ms", limit=MAX_MM),
    )
