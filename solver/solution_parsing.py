"""A solution out of plain JSON values."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import json_reading as read
from .errors import SketchFormatError
from .graph import Face
from .parsing import camera_from_json
from .solution import FORMAT, MAX_MM, VERSION, Report, Residual, Solution, SolvedCircle, Status

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
            f"status is {str(body['status'])[:40]!r}", (), ", ".join(s.value for s in Status)
        ) from error
    return Solution(
        sketch_digest=str(body["sketch_digest"]),
        status=status,
        message=str(body["message"]),
        vertices_mm=_items(body["vertices"], "vertices", _position),
        edges=_items(body["edges"], "edges", _ends),
        faces=_items(body["faces"], "faces", _face),
        circles=_items(body["circles"], "circles", _circle),
        camera=None if body["camera"] is None else camera_from_json(body["camera"], MAX_MM),
        scale_assumed=read.a_bool(body["scale_assumed"], "scale_assumed"),
        report=_report(body["report"]),
    )


def _items(value: Any, place: str, item: Any) -> dict[str, Any]:
    # Ids of mirrored copies hold an '@', which drawn ids must not.
    return {
        key: item(entry, f"{place}.{key[:40]}")
        for key, entry in read.an_object(value, place).items()
    }


def _position(value: Any, place: str) -> Any:
    entries = read.a_list(value, place, 3, 3)
    return np.array([read.a_number(x, place, limit=MAX_MM) for x in entries])


def _names(value: Any, place: str) -> tuple[str, ...]:
    entries = read.a_list(value, place)
    if not all(isinstance(entry, str) for entry in entries):
        raise SketchFormatError(f"{place} is not a list of ids", (), '["v1", "v2"]')
    return tuple(entries)


def _ends(value: Any, place: str) -> tuple[str, str]:
    v, w = _names(read.a_list(value, place, 2, 2), place)
    return (v, w)


def _face(value: Any, place: str) -> Face:
    body = read.an_object(value, place)
    read.check_keys(body, place, ("loop",), ("holes", "included", "thickness_mm"))
    thickness = body.get("thickness_mm")
    return Face(
        _names(body["loop"], place),
        tuple(_names(hole, place) for hole in body.get("holes", [])),
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
    return Residual(read.a_number(body["value"], place, limit=1e300), str(body["unit"]))


def _report(value: Any) -> Report:
    body = read.an_object(value, "report")
    read.check_keys(body, "report", _REPORT_KEYS)
    return Report(
        degrees_of_freedom=int(read.a_number(body["degrees_of_freedom"], "degrees_of_freedom")),
        residuals=_items(body["residuals"], "residuals", _residual),
        reprojection_px=_items(
            body["reprojection_px"],
            "reprojection_px",
            lambda v, p: read.a_number(v, p, limit=1e300),
        ),
        conflicts=_names(body["conflicts"], "conflicts"),
        iterations=int(read.a_number(body["iterations"], "iterations")),
        solve_ms=read.a_number(body["solve_ms"], "solve_ms", limit=MAX_MM),
    )
