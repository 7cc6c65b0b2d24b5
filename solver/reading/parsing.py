"""A sketch graph out of plain JSON values; every reference is checked."""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterable, Sized
from dataclasses import fields
from typing import Any

import numpy as np

from ..annotations import ANNOTATIONS, Annotation, RightAngle, targets_of
from ..camera import Camera
from ..errors import SketchError, SketchFormatError, SketchReferenceError
from ..graph import FORMAT, VERSION, Ellipse, Face, Photo, Revolution, SketchGraph
from . import json_reading as read

MAX_EDGES = 20_000
#: What belongs to a sketch with so many edges.
MAX_OF = {
    "vertices": 2 * MAX_EDGES,
    "edges": MAX_EDGES,
    "circles": 1_000,
    "revolutions": 1_000,
    "faces": MAX_EDGES,
    "annotations": 5 * MAX_EDGES,
}
MAX_PHOTO_PX = 100_000

_KEYS = ("format", "version", "photo", "vertices", "edges")
_OPTIONAL = ("circles", "revolutions", "faces", "annotations", "construction", "camera")


def graph_from_json(value: Any) -> SketchGraph:
    """The graph that a sketch file's JSON says.

    Raises
    ------
    SketchError
        For every way in which the values cannot be a sketch.
    """
    body = read.an_object(value, "the sketch")
    read.check_header(body, FORMAT, VERSION)
    read.check_keys(body, "the sketch", _KEYS, _OPTIONAL)
    for key, most in MAX_OF.items():
        _check_size(key, body.get(key, ()), most)
    graph = SketchGraph(
        photo=None if body["photo"] is None else _photo(body["photo"]),
        vertices=read.by_id(body["vertices"], "vertices", read.a_point),
        edges=read.by_id(body["edges"], "edges", _edge),
        circles=read.by_id(body.get("circles", {}), "circles", _circle),
        revolutions=read.by_id(body.get("revolutions", {}), "revolutions", _revolution),
        faces=_faces(body["faces"]) if "faces" in body else None,
        annotations=read.by_id(body.get("annotations", {}), "annotations", _annotation),
        construction=read.ids(body.get("construction", []), "construction"),
        camera=None if body.get("camera") is None else camera_from_json(body["camera"]),
    )
    check_references(graph)
    return graph


def check_references(graph: SketchGraph) -> None:
    """Refuse a graph whose elements name others that are not there, or make no sense together.

    Raises
    ------
    SketchError
    """
    for key, most in MAX_OF.items():
        _check_size(key, getattr(graph, key) or (), most)
    _check_edges(graph)
    _check_circles(graph)
    for id_, face in (graph.faces or {}).items():
        _check_face(graph, id_, face)
    for id_, annotation in graph.annotations.items():
        _check_annotation(graph, id_, annotation)
    both = sorted(set(graph.edges) & set(graph.circles))
    if both:
        raise SketchError("an edge and a circle share an id", both, "rename one of them")
    drawn = {*graph.edges, *graph.circles}
    _need(graph.construction, drawn, "edge or circle", "construction")


def _check_size(key: str, elements: Any, most: int) -> None:
    if isinstance(elements, Sized) and len(elements) > most:
        raise SketchError(f"more than {most} {key}", (), "a smaller sketch")


def camera_from_json(value: Any, limit: float = read.MAX_NUMBER) -> Camera:
    """A camera with numbers up to a limit; raises SketchFormatError."""
    body = read.an_object(value, "camera")
    keys = (
        "focal_px",
        "principal_point_px",
        "rotation_cam_from_world",
        "translation_cam_from_world_mm",
    )
    read.check_keys(body, "camera", keys)
    rows = [
        _vector(row, f"camera.{keys[2]}", 2.0) for row in read.a_list(body[keys[2]], keys[2], 3, 3)
    ]
    rotation = np.array(rows)
    if np.abs(rotation @ rotation.T - np.eye(3)).max() > 1e-6 or np.linalg.det(rotation) < 0:
        raise SketchFormatError(
            f"camera.{keys[2]} is not a rotation", (), "three perpendicular rows of length 1"
        )
    return Camera(
        read.a_number(body["focal_px"], "camera.focal_px", above=0.0, limit=limit),
        np.array(read.a_point(body[keys[1]], f"camera.{keys[1]}")),
        rotation,
        np.array(_vector(body[keys[3]], f"camera.{keys[3]}", limit)),
    )


def _vector(value: Any, place: str, limit: float) -> list[float]:
    entries = read.a_list(value, place, 3, 3)
    return [read.a_number(x, place, limit=limit) for x in entries]


def _photo(value: Any) -> Photo:
    body = read.an_object(value, "photo")
    read.check_keys(
        body, "photo", ("file", "width_px", "height_px"), ("focal_px", "principal_point_px")
    )
    file = body["file"]
    if file is not None and not (isinstance(file, str) and file.isprintable()):
        raise SketchFormatError("photo.file is not a name", (), "the photo's file name, or null")
    sizes = []
    for key in ("width_px", "height_px"):
        size = read.a_number(body[key], f"photo.{key}", above=0.0, limit=MAX_PHOTO_PX)
        if size != int(size):
            raise SketchFormatError(
                f"photo.{key} cannot be {size:g}", (), "a whole number of pixels"
            )
        sizes.append(int(size))
    focal, middle = body.get("focal_px"), body.get("principal_point_px")
    return Photo(
        body["file"],
        sizes[0],
        sizes[1],
        None if focal is None else read.a_number(focal, "photo.focal_px", above=0.0),
        None if middle is None else read.a_point(middle, "photo.principal_point_px"),
    )


def _edge(value: Any, place: str) -> tuple[str, str]:
    v, w = read.ids(value, place, 2, 2)
    return (v, w)


def _circle(value: Any, place: str) -> Ellipse:
    body = read.an_object(value, place)
    read.check_keys(body, place, ("a", "b"))
    axes = []
    for key in ("a", "b"):
        p, q = read.a_list(body[key], f"{place}.{key}", 2, 2)
        axes.append((read.a_point(p, f"{place}.{key}"), read.a_point(q, f"{place}.{key}")))
    return Ellipse(axes[0], axes[1])


def _revolution(value: Any, place: str) -> Revolution:
    body = read.an_object(value, place)
    keys = ("ground", "bottom", "top")
    read.check_keys(body, place, (*keys, "profile"))
    ground, bottom, top = (read.an_id(body[key], f"{place}.{key}") for key in keys)
    return Revolution(ground, bottom, top, read.ids(body["profile"], f"{place}.profile", 2))


def _faces(value: Any) -> dict[str, Face]:
    return read.by_id(value, "faces", _face, read.a_copy_id)


def _face(value: Any, place: str) -> Face:
    body = read.an_object(value, place)
    read.check_keys(body, place, ("loop",), ("holes", "included", "thickness_mm"))
    thickness = body.get("thickness_mm")
    holes = read.a_list(body.get("holes", []), f"{place}.holes")
    return Face(
        read.ids(body["loop"], f"{place}.loop", 3, one=read.a_copy_id),
        tuple(read.ids(hole, f"{place}.holes", 3, one=read.a_copy_id) for hole in holes),
        read.a_bool(body.get("included", True), f"{place}.included"),
        None if thickness is None else read.a_number(thickness, f"{place}.thickness_mm", above=0.0),
    )


def _annotation(value: Any, place: str) -> Annotation:
    body = read.an_object(value, place)
    kind = body.get("kind")
    cls = ANNOTATIONS.get(kind) if isinstance(kind, str) else None
    if cls is None:
        raise SketchFormatError(
            f"{place}.kind cannot be {str(kind)[:40]!r}", (), f"one of {', '.join(ANNOTATIONS)}"
        )
    names = [field.name for field in fields(cls)]
    read.check_keys(body, place, ("kind", *names))
    values: dict[str, Any] = {}
    for name in names:
        where = f"{place}.{name}"
        if name in cls.arity:
            values[name] = read.ids(body[name], where, *cls.arity[name])
        elif name in cls.targets:
            values[name] = read.an_id(body[name], where)
        else:
            values[name] = read.a_number(body[name], where, above=0.0)
    return cls(**values)


def _need(wanted: Iterable[str], there: Container[str], target: str, owner: str) -> None:
    missing = [id_ for id_ in wanted if id_ not in there]
    if missing:
        raise SketchReferenceError(
            f"{owner} names a {target} that is not there", missing[:5], "add it, or name another"
        )


def _check_edges(graph: SketchGraph) -> None:
    seen: dict[frozenset[str], str] = {}
    for id_, ends in graph.edges.items():
        _need(ends, graph.vertices, "vertex", f"edge {id_}")
        if ends[0] == ends[1]:
            raise SketchError("an edge begins and ends at one vertex", (id_,), "delete it")
        twin = seen.setdefault(frozenset(ends), id_)
        if twin != id_:
            raise SketchError("two edges join the same vertices", (twin, id_), "delete one")


def _check_circles(graph: SketchGraph) -> None:
    for id_, revolution in graph.revolutions.items():
        circles = (revolution.ground, revolution.bottom, revolution.top)
        _need(circles, graph.circles, "circle", f"revolution {id_}")
        _need(revolution.profile, graph.vertices, "vertex", f"revolution {id_}")


def _check_face(graph: SketchGraph, id_: str, face: Face) -> None:
    for loop in face.loops:
        drawn = [v for v in loop if v in graph.vertices or not graph.is_copy(v)]
        _need(drawn, graph.vertices, "vertex", f"face {id_}")
        twice = [v for v, count in Counter(loop).items() if count > 1]
        if twice:
            raise SketchError(f"face {id_} passes a vertex twice", twice, "split the face")


def _need_drawn(graph: SketchGraph, id_: str, faces: Iterable[str]) -> None:
    """Refuse to have a vertex on a face that is there only once the sketch is solved."""
    mirrored = sorted(set(faces) - set(graph.drawn_faces or {}))
    if mirrored:
        raise SketchError(
            f"annotation {id_} names a face with mirrored corners", mirrored, "draw its corners"
        )


def _check_annotation(graph: SketchGraph, id_: str, annotation: Annotation) -> None:
    there: dict[str, Container[str]] = {
        "vertex": graph.vertices,
        "edge": graph.edges,
        "circle": graph.circles,
    }
    for target, named in targets_of(annotation).items():
        if target == "face":
            # Faces that are found in 3D have their ids only after the solve.
            if graph.faces is not None:
                _need(named, graph.faces, target, f"annotation {id_}")
                _need_drawn(graph, id_, named)
            continue
        _need(named, there[target], target, f"annotation {id_}")
        if len(set(named)) != len(named):
            raise SketchError(f"annotation {id_} names one {target} twice", (id_,), "name it once")
    if isinstance(annotation, RightAngle):
        for edge in annotation.between:
            if annotation.at not in graph.edges[edge]:
                raise SketchError(
                    f"annotation {id_}: edge {edge} does not end at {annotation.at}",
                    (id_,),
                    "two edges that meet at the vertex",
                )
