"""The solution: the sketch lifted to 3D, and how well it went."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

import numpy as np

from .camera import Camera
from .graph import Face, SketchGraph, face_to_json
from .values import Array, frozen_array, frozen_mapping, frozen_rows, rows_of

FORMAT = "incontext/solution"
VERSION = 1
#: A solution has no numbers beyond this: a thousand kilometres.
MAX_MM = 1e9


class Status(StrEnum):
    """How a solve ended."""

    CONVERGED = "converged"
    NOT_CONVERGED = "not_converged"
    UNDERDETERMINED = "underdetermined"
    CONFLICTING = "conflicting"


@dataclass(frozen=True, slots=True)
class Residual:
    """How far an annotation is from being true, in its own unit."""

    value: float
    unit: str


class Residuals(Mapping[str, Residual]):
    """Residuals by annotation id, held as arrays: a sketch has thousands, and few are looked at.

    Parameters
    ----------
    ids : tuple of str
    values : (n,) array
    units : tuple of str
    """

    __slots__ = ("_ids", "_numbers", "_place", "_units")

    def __init__(self, ids: tuple[str, ...], values: Array, units: tuple[str, ...]) -> None:
        self._ids, self._units = ids, units
        self._numbers = frozen_array(values)
        self._place: dict[str, int] | None = None

    def __getitem__(self, id_: str) -> Residual:
        if self._place is None:
            self._place = {name: k for k, name in enumerate(self._ids)}
        return self._at(self._place[id_])

    def _at(self, k: int) -> Residual:
        return Residual(float(self._numbers[k]), self._units[k])

    def __iter__(self) -> Iterator[str]:
        return iter(self._ids)

    def __len__(self) -> int:
        return len(self._ids)

    def above(self, limit: float) -> dict[str, Residual]:
        """Those whose value is above a limit, whatever their unit."""
        chosen = np.flatnonzero(self._numbers > limit).tolist()
        return {self._ids[k]: self._at(k) for k in chosen}


@dataclass(frozen=True, slots=True)
class SolvedCircle:
    """A horizontal circle in the world."""

    center_mm: Array
    radius_mm: float


@dataclass(frozen=True, slots=True)
class Report:
    """What the solver found out besides the shape.

    Parameters
    ----------
    degrees_of_freedom : int
        Freedoms that neither the drawing nor the annotations fix (overall size not counted).
    loose : tuple of vertex ids
        The vertices which those freedoms move.
    residuals : mapping of annotation id to Residual
    reprojection_px : mapping of vertex id to px
        Distance between the drawn and the projected position.
    conflicts : tuple of annotation ids
        Annotations that cannot all hold or contradict the drawing, the likeliest culprit first.
    iterations : int
    solve_ms : float
    focal_assumed : bool
        True where the drawing does not tell the focal length and a usual one was assumed.
    size_sigma : mapping of edge id to float
        Standard error of each edge's length relative to all others', in parts. Empty where
        something is left free.
    unsure : bool
        True where sizes are so uncertain that the shape may be quite different.
    """

    degrees_of_freedom: int = 0
    loose: tuple[str, ...] = ()
    residuals: Mapping[str, Residual] = field(default_factory=lambda: frozen_mapping({}))
    reprojection_px: Mapping[str, float] = field(default_factory=lambda: frozen_mapping({}))
    conflicts: tuple[str, ...] = ()
    iterations: int = 0
    solve_ms: float = 0.0
    focal_assumed: bool = False
    size_sigma: Mapping[str, float] = field(default_factory=lambda: frozen_mapping({}))
    unsure: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """The lifted shape.

    Parameters
    ----------
    sketch : SketchGraph or str
        The graph that was solved, or its digest where only that is known (read from a file).
    status : Status
    message : str
        One sentence for people.
    vertices_mm : mapping of vertex id to (3,) array
        World positions; mirrored vertices included (``v3@a5``).
    edges : mapping of edge id to (vertex id, vertex id)
    faces : mapping of face id to Face
        Where the sketch lists none, they are looked for when they are first asked for.
    circles : mapping of circle id to SolvedCircle
    camera : Camera or None
    scale_assumed : bool
        True where nothing fixed the size: then the longest edge is 100 mm.
    report : Report
    """

    sketch: SketchGraph | str
    status: Status
    message: str
    vertices_mm: Mapping[str, Array] = field(default_factory=dict)
    edges: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    faces: Mapping[str, Face] = field(default_factory=dict)
    circles: Mapping[str, SolvedCircle] = field(default_factory=dict)
    camera: Camera | None = None
    scale_assumed: bool = False
    report: Report = field(default_factory=Report)

    def __post_init__(self) -> None:
        object.__setattr__(self, "vertices_mm", frozen_rows(self.vertices_mm))
        for name in ("edges", "faces", "circles"):
            object.__setattr__(self, name, frozen_mapping(getattr(self, name)))

    @property
    def sketch_digest(self) -> str:
        """Digest of the graph that was solved; worked out when asked for, as few ask."""
        return self.sketch if isinstance(self.sketch, str) else self.sketch.digest

    @property
    def is_bounded(self) -> bool:
        """Whether all numbers are finite, and positions such that a program can work with them."""
        positions = [c.center_mm for c in self.circles.values()]
        numbers = [*(c.radius_mm for c in self.circles.values())]
        if self.camera is not None:
            positions += [self.camera.translation_cam_from_world_mm]
            numbers += [self.camera.focal_px, *self.camera.principal_point_px.tolist()]
        # Not so for NaN either.
        bounded = bool((np.abs(rows_of(self.vertices_mm)) <= MAX_MM).all())
        bounded = bounded and bool((np.abs(np.array(positions, dtype=float)) <= MAX_MM).all())
        bounded = bounded and all(abs(x) <= MAX_MM for x in numbers)
        return bounded and bool(np.isfinite([*self.report.reprojection_px.values()]).all())

    def to_json(self) -> dict[str, Any]:
        """The solution as it stands in the file."""
        report = self.report
        return {
            "format": FORMAT,
            "version": VERSION,
            "sketch_digest": self.sketch_digest,
            "status": self.status.value,
            "message": self.message,
            "vertices": {id_: x.tolist() for id_, x in self.vertices_mm.items()},
            "edges": {id_: list(ends) for id_, ends in self.edges.items()},
            "faces": {id_: face_to_json(f) for id_, f in self.faces.items()},
            "circles": {
                id_: {"center": c.center_mm.tolist(), "radius_mm": c.radius_mm}
                for id_, c in self.circles.items()
            },
            "camera": None if self.camera is None else self.camera.to_json(),
            "scale_assumed": self.scale_assumed,
            "report": {
                "degrees_of_freedom": report.degrees_of_freedom,
                "residuals": {
                    id_: {"value": r.value, "unit": r.unit} for id_, r in report.residuals.items()
                },
                "reprojection_px": dict(report.reprojection_px),
                "conflicts": list(report.conflicts),
                "iterations": report.iterations,
                "solve_ms": report.solve_ms,
            },
        }
