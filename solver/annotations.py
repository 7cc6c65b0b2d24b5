"""What a person says is true in 3D ([Lau10] 3.2), one frozen class a kind.

Terms
-----
arity
    How many elements an annotation names, at the least.
target
    The kind of element that a field names: ``vertex``, ``edge``, ``circle`` or ``face``.
unit
    The unit in which the residual of an annotation is told to people.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from operator import attrgetter
from typing import Any, ClassVar


@dataclass(frozen=True, slots=True)
class RightAngle:
    """Two edges meet at a vertex at 90 degrees."""

    kind: ClassVar[str] = "right_angle"
    unit: ClassVar[str] = "deg"
    targets: ClassVar[dict[str, str]] = {"at": "vertex", "between": "edge"}
    arity: ClassVar[dict[str, tuple[int, int | None]]] = {"between": (2, 2)}
    at: str
    between: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class EqualLength:
    """All named edges have one length."""

    kind: ClassVar[str] = "equal_length"
    unit: ClassVar[str] = "mm"
    targets: ClassVar[dict[str, str]] = {"edges": "edge"}
    arity: ClassVar[dict[str, tuple[int, int | None]]] = {"edges": (2, None)}
    edges: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Parallel:
    """All named edges have one direction."""

    kind: ClassVar[str] = "parallel"
    unit: ClassVar[str] = "deg"
    targets: ClassVar[dict[str, str]] = {"edges": "edge"}
    arity: ClassVar[dict[str, tuple[int, int | None]]] = {"edges": (2, None)}
    edges: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Ground:
    """The named vertices lie on the ground, z = 0."""

    kind: ClassVar[str] = "ground"
    unit: ClassVar[str] = "mm"
    targets: ClassVar[dict[str, str]] = {"vertices": "vertex"}
    arity: ClassVar[dict[str, tuple[int, int | None]]] = {"vertices": (1, None)}
    vertices: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class SymmetryPlane:
    """A plane through the midpoints of the named edges, which cross it at right angles.

    [Lau10] picks three or more midpoints; one edge already fixes the plane, so one is taken.
    """

    kind: ClassVar[str] = "symmetry_plane"
    unit: ClassVar[str] = "mm"
    targets: ClassVar[dict[str, str]] = {"midpoints_of": "edge"}
    arity: ClassVar[dict[str, tuple[int, int | None]]] = {"midpoints_of": (1, None)}
    midpoints_of: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Length:
    """The edge is so long."""

    kind: ClassVar[str] = "length"
    unit: ClassVar[str] = "mm"
    targets: ClassVar[dict[str, str]] = {"edge": "edge"}
    arity: ClassVar[dict[str, tuple[int, int | None]]] = {}
    edge: str
    length_mm: float


@dataclass(frozen=True, slots=True)
class Diameter:
    """The circle is so wide."""

    kind: ClassVar[str] = "diameter"
    unit: ClassVar[str] = "mm"
    targets: ClassVar[dict[str, str]] = {"circle": "circle"}
    arity: ClassVar[dict[str, tuple[int, int | None]]] = {}
    circle: str
    diameter_mm: float


@dataclass(frozen=True, slots=True)
class OnFace:
    """The vertex lies in the plane of the face."""

    kind: ClassVar[str] = "on_face"
    unit: ClassVar[str] = "mm"
    targets: ClassVar[dict[str, str]] = {"vertex": "vertex", "face": "face"}
    arity: ClassVar[dict[str, tuple[int, int | None]]] = {}
    vertex: str
    face: str


@dataclass(frozen=True, slots=True)
class Angle:
    """Two edges meet at a vertex at some angle; said to the solver, never in a sketch file."""

    kind: ClassVar[str] = "angle"
    unit: ClassVar[str] = "deg"
    targets: ClassVar[dict[str, str]] = {"at": "vertex", "between": "edge"}
    arity: ClassVar[dict[str, tuple[int, int | None]]] = {"between": (2, 2)}
    at: str
    between: tuple[str, ...]
    angle_deg: float


Annotation = (
    RightAngle
    | EqualLength
    | Parallel
    | Ground
    | SymmetryPlane
    | Length
    | Diameter
    | OnFace
    | Angle
)

#: Every kind of annotation by its name in the file.
ANNOTATIONS: dict[str, type[Annotation]] = {
    cls.kind: cls
    for cls in (
        RightAngle,
        EqualLength,
        Parallel,
        Ground,
        SymmetryPlane,
        Length,
        Diameter,
        OnFace,
    )
}

#: Those and what is only said to the solver.
SAID: dict[str, type[Annotation]] = {**ANNOTATIONS, Angle.kind: Angle}


def targets_of(annotation: Annotation) -> dict[str, tuple[str, ...]]:
    """The ids an annotation names, by kind of element.

    Returns
    -------
    dict
        ``{"edge": ("e1", "e2"), ...}``, kinds that are not named left out.
    """
    named: dict[str, tuple[str, ...]] = {}
    for field, target in annotation.targets.items():
        value = getattr(annotation, field)
        ids = value if isinstance(value, tuple) else (value,)
        named[target] = named.get(target, ()) + ids
    return named


def annotation_values(annotation: Annotation) -> tuple[Any, ...]:
    """The kind and what an annotation says, in the order of the file's keys."""
    values: tuple[Any, ...] = _VALUES[type(annotation)](annotation)
    return values


def annotation_to_json(annotation: Annotation) -> dict[str, Any]:
    """The annotation as it stands in the file."""
    names = _NAMES[type(annotation)]
    return {
        name: list(value) if isinstance(value, tuple) else value
        for name, value in zip(names, annotation_values(annotation), strict=True)
    }


_NAMES = {cls: ("kind", *(field.name for field in fields(cls))) for cls in ANNOTATIONS.values()}
_VALUES = {cls: attrgetter(*names) for cls, names in _NAMES.items()}
