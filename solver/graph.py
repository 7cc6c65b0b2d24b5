"""The sketch graph: what was drawn, as one frozen value ([Lau10] 4.1).

Terms
-----
vertex, edge, circle, face
    Elements of the drawing, each with a short id that runs all the way to the plates.
construction
    Edges and circles traced on things that really are in the photo.
loop
    A closed chain of vertex ids; neighbours (the last and the first too) are joined by edges.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import chain
from typing import Any

import numpy as np

from .annotations import Annotation, SymmetryPlane, annotation_to_json, annotation_values
from .camera import Camera
from .values import Array, FrozenDict, IntArray, frozen_array, frozen_mapping, kept

FORMAT = "incontext/sketch"
VERSION = 1

#: Between the id of what is mirrored and that of its symmetry plane.
COPY_SIGN = "@"

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Photo:
    """The one input image; only its size, and its focal length if known, matter to the solver."""

    file: str | None
    width_px: int
    height_px: int
    focal_px: float | None = None
    principal_point_px: Point | None = None


@dataclass(frozen=True, slots=True)
class Ellipse:
    """A drawn circle: antipodal points on the major (a) and minor (b) axis, px ([Lau10] 4.1)."""

    a: tuple[Point, Point]
    b: tuple[Point, Point]


@dataclass(frozen=True, slots=True)
class Revolution:
    """Three circles on one vertical axis, and the profile from bottom to top ([Lau10] 3.1)."""

    ground: str
    bottom: str
    top: str
    profile: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Face:
    """A planar polygon: its outer loop, its holes, whether it is made, and how thick."""

    loop: tuple[str, ...]
    holes: tuple[tuple[str, ...], ...] = ()
    included: bool = True
    thickness_mm: float | None = None

    @property
    def loops(self) -> tuple[tuple[str, ...], ...]:
        """The outer loop, then the holes."""
        return (self.loop, *self.holes)


def _empty() -> Mapping[str, Any]:
    return frozen_mapping({})


@dataclass(frozen=True, slots=True, eq=False)
class SketchGraph:
    """Vertices, edges, circles, faces and annotations as drawn.

    Two graphs are equal when they say the same, which `digest` tells.

    Parameters
    ----------
    photo : Photo or None
    vertices : mapping of id to (u, v), px
    edges : mapping of id to (vertex id, vertex id)
    circles, revolutions, annotations : mappings by id
    faces : mapping by id, or None where faces are to be found in 3D
    construction : tuple of edge and circle ids
    camera : Camera or None
        The camera where it is known beforehand.
    """

    photo: Photo | None = None
    vertices: Mapping[str, Point] = field(default_factory=_empty)
    edges: Mapping[str, tuple[str, str]] = field(default_factory=_empty)
    circles: Mapping[str, Ellipse] = field(default_factory=_empty)
    revolutions: Mapping[str, Revolution] = field(default_factory=_empty)
    faces: Mapping[str, Face] | None = None
    annotations: Mapping[str, Annotation] = field(default_factory=_empty)
    construction: tuple[str, ...] = ()
    camera: Camera | None = None

    def __post_init__(self) -> None:
        for name in ("vertices", "edges", "circles", "revolutions", "annotations", "faces"):
            value = getattr(self, name)
            if value is not None:
                object.__setattr__(self, name, frozen_mapping(value))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SketchGraph) and self.digest == other.digest

    def __hash__(self) -> int:
        return hash(self.digest)

    @property
    def digest(self) -> str:
        """SHA-256 of what the graph says, hexadecimal; independent of the order of ids."""
        rest = _digest_of_rest(
            self.photo,
            self.edges,
            self.circles,
            self.revolutions,
            self.faces,
            self.annotations,
            self.construction,
            self.camera,
        )
        names, order = _sorted_names(tuple(self.vertices))
        places = self.positions_px[order].astype("<f8")
        said = hashlib.sha256(rest.encode())
        said.update(names)
        said.update(places.tobytes())
        return said.hexdigest()

    @property
    def traced_revolutions(self) -> dict[str, Revolution]:
        """The surfaces of revolution both of whose ends are construction: there already."""
        traced = set(self.construction)
        return {id_: r for id_, r in self.revolutions.items() if {r.bottom, r.top} <= traced}

    @property
    def made_revolutions(self) -> dict[str, Revolution]:
        """The other surfaces of revolution, which are part of the new object."""
        traced = self.traced_revolutions
        return {id_: r for id_, r in self.revolutions.items() if id_ not in traced}

    @property
    def positions_px(self) -> Array:
        """Where the vertices are drawn, in their order, (n, 2); read-only."""
        return _positions_px(self.vertices)

    @property
    def drawn_faces(self) -> Mapping[str, Face] | None:
        """The listed faces all of whose corners are drawn; None where faces are found in 3D.

        The others have corners such as ``v3@a5``, which a symmetry plane makes.
        """
        return None if self.faces is None else _drawn(self.faces, tuple(self.vertices))

    def is_copy(self, vertex: str) -> bool:
        """Whether an id such as ``v3@a5`` can be that of a copy of a drawn vertex."""
        drawn, *planes = vertex.split(COPY_SIGN)
        there = self.annotations
        kinds = {there[plane].kind if plane in there else "" for plane in planes}
        return drawn in self.vertices and kinds == {SymmetryPlane.kind}

    def annotations_of(self, kind: str) -> dict[str, Annotation]:
        """The annotations of one kind, by id."""
        return {id_: a for id_, a in self.annotations.items() if a.kind == kind}

    def edge_between(self, v: str, w: str) -> str | None:
        """The edge that joins two vertices, if one does."""
        for id_, ends in self.edges.items():
            if ends in ((v, w), (w, v)):
                return id_
        return None

    @property
    def principal_point_px(self) -> Point:
        """Where the axis of view meets the photo: as told, else the middle.

        Without a photo, the middle of the drawing stands in for it.
        """
        if self.camera is not None:
            u, v = self.camera.principal_point_px
            return (float(u), float(v))
        if self.photo is None:
            ends = [p for c in self.circles.values() for p in (*c.a, *c.b)]
            if not self.vertices and not ends:
                return (0.0, 0.0)
            us, vs = zip(*self.vertices.values(), *ends, strict=True)
            return ((min(us) + max(us)) / 2, (min(vs) + max(vs)) / 2)
        if self.photo.principal_point_px is not None:
            return self.photo.principal_point_px
        return (self.photo.width_px / 2, self.photo.height_px / 2)

    def to_json(self) -> dict[str, Any]:
        """The graph as it stands in the file (plain dicts, lists, numbers)."""
        body: dict[str, Any] = {
            "format": FORMAT,
            "version": VERSION,
            "photo": _photo_to_json(self.photo),
            "vertices": {id_: list(p) for id_, p in self.vertices.items()},
            "edges": {id_: list(ends) for id_, ends in self.edges.items()},
            "circles": {
                id_: {"a": [list(p) for p in c.a], "b": [list(p) for p in c.b]}
                for id_, c in self.circles.items()
            },
            "revolutions": {
                id_: {
                    "ground": r.ground,
                    "bottom": r.bottom,
                    "top": r.top,
                    "profile": list(r.profile),
                }
                for id_, r in self.revolutions.items()
            },
        }
        if self.faces is not None:
            body["faces"] = {id_: face_to_json(f) for id_, f in self.faces.items()}
        body["annotations"] = {id_: annotation_to_json(a) for id_, a in self.annotations.items()}
        body["construction"] = list(self.construction)
        body["camera"] = None if self.camera is None else self.camera.to_json()
        return body


@kept
def _positions_px(vertices: Mapping[str, Point]) -> Array:
    numbers = np.fromiter(chain.from_iterable(vertices.values()), float, 2 * len(vertices))
    return frozen_array(numbers, (-1, 2))


@kept
def _drawn(faces: Mapping[str, Face], vertices: tuple[str, ...]) -> Mapping[str, Face]:
    there = frozenset(vertices)
    drawn = {id_: f for id_, f in faces.items() if all(there.issuperset(p) for p in f.loops)}
    return faces if len(drawn) == len(faces) else FrozenDict(drawn)


@kept
def _sorted_names(names: tuple[str, ...]) -> tuple[bytes, IntArray]:
    """The sorted names as a text, and which comes first."""
    order = sorted(range(len(names)), key=names.__getitem__)
    return json.dumps([names[i] for i in order]).encode(), np.array(order, dtype=np.int64)


@kept
def _digest_of_rest(
    photo: Photo | None,
    edges: Mapping[str, tuple[str, str]],
    circles: Mapping[str, Ellipse],
    revolutions: Mapping[str, Revolution],
    faces: Mapping[str, Face] | None,
    annotations: Mapping[str, Annotation],
    construction: tuple[str, ...],
    camera: Camera | None,
) -> str:
    """SHA-256 of all but the vertices, which a drag moves."""
    told = [
        _photo_to_json(photo),
        sorted(edges.items()),
        sorted((id_, c.a, c.b) for id_, c in circles.items()),
        sorted((id_, r.ground, r.bottom, r.top, r.profile) for id_, r in revolutions.items()),
        None if faces is None else {id_: face_to_json(f) for id_, f in faces.items()},
        [(id_, annotation_values(annotations[id_])) for id_ in sorted(annotations)],
        sorted(construction),
        None if camera is None else camera.to_json(),
    ]
    return hashlib.sha256(json.dumps(told, sort_keys=True).encode()).hexdigest()


def _photo_to_json(photo: Photo | None) -> dict[str, Any] | None:
    if photo is None:
        return None
    body: dict[str, Any] = {
        "file": photo.file,
        "width_px": photo.width_px,
        "height_px": photo.height_px,
    }
    if photo.focal_px is not None:
        body["focal_px"] = photo.focal_px
    if photo.principal_point_px is not None:
        body["principal_point_px"] = list(photo.principal_point_px)
    return body


def face_to_json(face: Face) -> dict[str, Any]:
    """A face as it stands in the sketch and the solution file."""
    body: dict[str, Any] = {
        "loop": list(face.loop),
        "holes": [list(hole) for hole in face.holes],
        "included": face.included,
    }
    if face.thickness_mm is not None:
        body["thickness_mm"] = face.thickness_mm
    return body
