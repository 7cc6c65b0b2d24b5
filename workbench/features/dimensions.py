"""The dimensions of a lifted model as properties: lengths of edges, diameters of circles.

What the sketch says of an edge drives and can be typed; every other dimension shows what came out,
for reading only. A typed value is written into the sketch, where it is one more annotation or a
new number in an old one. A value that an expression or a spreadsheet gives stays with the model: it
takes the place of the sketch's own at each recompute, and nothing is written upstream.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from .. import host
from ..problems import in_words, known_problems
from . import pipeline
from .properties import Editor

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution

DRIVING, SHOWN = "Dimensions", "Shown dimensions"
LENGTH, DIAMETER = "Length_", "Diameter_"
#: World axes by the words that people use for sizes along them.
_WORDS = ("Width", "Depth", "Height")


def property_name(prefix: str, id_: str) -> str:
    """The name of an element's property: ASCII, different for different ids.

    Parameters
    ----------
    prefix : str
        `LENGTH` or `DIAMETER`.
    id_ : str
    """
    safe = re.sub(r"[^A-Za-z0-9]", lambda m: "__" if m[0] == "_" else f"_x{ord(m[0]):x}_", id_)
    return prefix + safe


def is_dimension(name: str) -> bool:
    """Whether a property's name may be that of a dimension."""
    return name.startswith((LENGTH, DIAMETER))


def names_of(edges: Iterable[str], circles: Iterable[str]) -> dict[str, str]:
    """The properties of edges and circles: id by property name."""
    names = {property_name(LENGTH, id_): id_ for id_ in edges}
    return names | {property_name(DIAMETER, id_): id_ for id_ in circles}


def bound_sizes(obj: Any, graph: SketchGraph) -> dict[str, float]:
    """The dimensions that expressions give, in mm, by element."""
    bound = _bound_names(obj)
    names = names_of(graph.edges, graph.circles)
    return {
        id_: getattr(obj, name).Value
        for name, id_ in names.items()
        if name in bound and name in obj.PropertiesList
    }


def driven_text(obj: Any) -> str:
    """The sketch that a lifted model solves: its photo sketch's, with what expressions give.

    Raises
    ------
    SketchError
        Where the text is no sketch, or an expression gives a size that cannot be.
    """
    text = obj.PhotoSketch.Sketch
    if not _bound_names(obj):
        return text
    return pipeline.resized_text(text, tuple(bound_sizes(obj, pipeline.graph_of(text)).items()))


def show_dimensions(obj: Any, graph: SketchGraph, solution: Solution) -> None:
    """Give a lifted model the properties of its dimensions, with their sizes after a solve."""
    from ...solver.dimensions import driving_sizes_mm, sizes_mm

    names = names_of(solution.edges, solution.circles)
    said, sizes, bound = driving_sizes_mm(graph), sizes_mm(solution), _bound_names(obj)
    _remove_others(obj, names)
    there = set(obj.PropertiesList)
    for name, id_ in names.items():
        drives = id_ in said or name in bound
        if name not in there:
            obj.addProperty("App::PropertyLength", name, DRIVING if drives else SHOWN)
        _dress(obj, name, drives, _describe(id_, solution, drives))
        size = said.get(id_, sizes[id_])
        if name not in bound and getattr(obj, name).Value != size:
            setattr(obj, name, size)


def take_edit(obj: Any, name: str) -> None:
    """Write a typed dimension into the sketch; what cannot be is told, and nothing is written.

    Does nothing for whatever is no edit of a person's or script's: results of a recompute or of an
    expression, undo, and opening a document.
    """
    document = obj.Document
    if document is None or obj.PhotoSketch is None or _is_at_work(document):
        return
    if "Restore" in obj.State or name in _bound_names(obj):
        return
    text = obj.PhotoSketch.Sketch
    try:
        graph = pipeline.graph_of(text)
        id_ = names_of(graph.edges, graph.circles).get(name)
        if id_ is not None:
            drive(obj, id_, getattr(obj, name).Value)
    except known_problems() as error:
        host.report(f"{obj.Label}: {in_words(error)}")


def drive(obj: Any, id_: str, size_mm: float | None) -> None:
    """Say a size of an edge or a circle in a model's sketch; None lets it follow again.

    Raises
    ------
    SketchError
        Where the size cannot be.
    """
    from ...solver.dimensions import driving_sizes_mm, set_size
    from ...solver.serialise import sketch_to_text

    graph = pipeline.graph_of(obj.PhotoSketch.Sketch)
    if driving_sizes_mm(graph).get(id_) != size_mm:
        obj.PhotoSketch.Sketch = sketch_to_text(set_size(graph, id_, size_mm))


def edge_at(obj: Any, element: str) -> str | None:
    """The id of the drawn edge that an edge of the shape, such as ``Edge3``, lies on.

    None for edges of the mirrored half, and for what is no straight edge.
    """
    edge = obj.Shape.getElement(element)
    ends = [tuple(vertex.Point) for vertex in edge.Vertexes]
    solution = pipeline.solution_of(driven_text(obj))
    drawn = pipeline.graph_of(obj.PhotoSketch.Sketch).edges
    for id_ in drawn:
        v, w = (tuple(float(x) for x in solution.vertices_mm[u]) for u in solution.edges[id_])
        if _near(ends, [v, w]) or _near(ends, [w, v]):
            return id_
    return None


def _near(points: list[Any], others: list[Any]) -> bool:
    pairs = zip(points, others, strict=False)
    return len(points) == 2 and all(
        abs(a - b) < 1e-6 for p, q in pairs for a, b in zip(p, q, strict=True)
    )


def _is_at_work(document: Any) -> bool:
    """Whether FreeCAD itself is changing the document."""
    return document.Restoring or document.Recomputing or document.Transacting


def _bound_names(obj: Any) -> set[str]:
    return {path.lstrip(".") for path, _ in obj.ExpressionEngine if is_dimension(path.lstrip("."))}


def _remove_others(obj: Any, names: Mapping[str, str]) -> None:
    """Take the properties of elements away that are there no more."""
    for name in obj.PropertiesList:
        ours = is_dimension(name) and obj.getGroupOfProperty(name) in (DRIVING, SHOWN)
        if ours and name not in names:
            obj.removeProperty(name)


def _dress(obj: Any, name: str, drives: bool, words: str) -> None:
    group = DRIVING if drives else SHOWN
    if obj.getGroupOfProperty(name) != group:
        obj.setGroupOfProperty(name, group)
    if obj.getDocumentationOfProperty(name) != words:
        obj.setDocumentationOfProperty(name, words)
    obj.setEditorMode(name, int(Editor.CHANGEABLE if drives else Editor.READ_ONLY))


def _describe(id_: str, solution: Solution, drives: bool) -> str:
    if id_ in solution.circles:
        words = host.translate("InContext", "Diameter of circle {}").format(id_)
    else:
        v, w = solution.edges[id_]
        along = abs(solution.vertices_mm[w] - solution.vertices_mm[v])
        main = int(along.argmax())
        straight = along[main] > 0.999 * float((along**2).sum()) ** 0.5
        kind = _WORDS[main] if straight else "Length"
        words = host.translate("InContext", "{0}: edge {1}, from {2} to {3}").format(
            host.translate("InContext", kind), id_, v, w
        )
    role = (
        host.translate("InContext", "type a value or an expression")
        if drives
        else host.translate("InContext", "follows from the drawing and the other dimensions")
    )
    return f"{words}; {role}"
