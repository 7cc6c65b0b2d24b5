"""The dimensions of a lifted model as properties: lengths, diameters, heights and angles.

What the sketch says of an edge drives and can be typed; every other dimension shows what came out,
for reading only. A typed value is written into the sketch, where it is one more annotation or a
new number in an old one. A value that an expression or a spreadsheet gives stays with the model: it
takes the place of the sketch's own at each recompute, and nothing is written upstream. So do
angles other than right ones, for which sketches have no words.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import host
from ..problems import in_words, known_problems
from . import pipeline
from .dimension_names import (
    ANGLE,
    DIAMETER,
    HEIGHT,
    Dimension,
    dimension_named,
    driving,
    is_dimension,
    measured,
    said,
)
from .dimension_words import Words
from .methods import source_of
from .model_angles import in_order, said_angles, say_angles, text_of
from .properties import Editor
from .proxy import is_edited

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution
    from .model_angles import Corner

DRIVING, SHOWN, ANGLES = "Dimensions", "Shown dimensions", "Shown dimensions: angles"


def driven_text(obj: Any) -> str:
    """The source of a lifted model: its photo sketch's text with what expressions give, its method.

    Raises
    ------
    SketchError
        Where the text is no sketch, or an expression gives a size that cannot be.
    """
    text, sizes = obj.PhotoSketch.Sketch, _given(obj)
    angles = {d.ids: sizes.pop(d) for d in list(sizes) if d.prefix == ANGLE}
    if sizes:
        graph = pipeline.graph_of(text)
        # What an expression gave to an element that is gone is taken away after the solve.
        there = tuple(pair for pair in sizes.items() if _is_there(graph, pair[0]))
        text = pipeline.resized_text(text, there) if there else text
    return source_of(text, obj.Method, text_of(_angles(obj, angles)))


def _given(obj: Any) -> dict[Dimension, float]:
    """What expressions give."""
    bound = {name: dimension_named(name) for name in sorted(_bound_names(obj))}
    return {
        dimension: float(getattr(obj, name).Value)
        for name, dimension in bound.items()
        if dimension is not None and name in obj.PropertiesList
    }


def _angles(obj: Any, given: Mapping[tuple[str, ...], float]) -> dict[Corner, float]:
    """The angles that are said of the model, by a person or by an expression."""
    said_of_it = said_angles(obj)
    if not (said_of_it or given):
        return {}
    from ...solver.said_angles import need_angle

    graph = pipeline.graph_of(obj.PhotoSketch.Sketch)
    bound = {(first, second): angle for (first, second), angle in given.items()}
    found = in_order(graph, {**said_of_it, **bound})
    for corner, angle_deg in found.items():
        need_angle(graph, corner, angle_deg)
    return found


def _is_there(graph: Any, dimension: Dimension) -> bool:
    if dimension.prefix == HEIGHT:
        return dimension.ids[0] in graph.vertices or dimension.ids[0] in graph.circles
    elements = graph.circles if dimension.prefix == DIAMETER else graph.edges
    return all(id_ in elements for id_ in dimension.ids)


def show_dimensions(obj: Any, graph: SketchGraph, solution: Solution) -> None:
    """Give a lifted model the properties of its dimensions, with their values after a solve."""
    said_here, bound = _said_here(obj, graph), _bound_names(obj)
    drives, sizes = driving_and_measured(obj, graph, solution)
    _remove_others(obj, {dimension.name for dimension in sizes})
    there, words = set(obj.PropertiesList), Words(graph, solution)
    for dimension, size in sizes.items():
        name = dimension.name
        # Right angles are said in the sketch, by dozens.
        typed = dimension in (said_here if dimension.prefix == ANGLE else drives)
        is_driving = typed or name in bound
        group = _group_of(dimension, is_driving)
        if name not in there:
            kind = "App::PropertyAngle" if dimension.prefix == ANGLE else "App::PropertyLength"
            obj.addProperty(kind, name, group)
        _dress(obj, name, group, words.of(dimension, is_driving))
        value = drives.get(dimension, size)
        if name not in bound and getattr(obj, name).Value != value:
            setattr(obj, name, value)


def driving_and_measured(
    obj: Any, graph: SketchGraph, solution: Solution
) -> tuple[dict[Dimension, float], dict[Dimension, float]]:
    """What a lifted model and its sketch say of dimensions, and what all came out as."""
    said_here = _said_here(obj, graph)
    return driving(graph) | said_here, measured(graph, solution, (d.ids for d in said_here))


def _said_here(obj: Any, graph: SketchGraph) -> dict[Dimension, float]:
    """The angles that a lifted model says of corners that are there."""
    angles = in_order(graph, said_angles(obj))
    return {Dimension(ANGLE, corner): angle for corner, angle in angles.items()}


def _group_of(dimension: Dimension, is_driving: bool) -> str:
    if is_driving:
        return DRIVING
    # A sketch has dozens of angles, nearly all of them right: they would hide the sizes.
    return ANGLES if dimension.prefix == ANGLE else SHOWN


def take_edit(obj: Any, name: str) -> None:
    """Write a typed dimension into the sketch; what cannot be is told, and nothing is written.

    Does nothing for whatever is no edit of a person's or script's: results of a recompute or of an
    expression, undo, and opening a document.
    """
    dimension = dimension_named(name)
    if dimension is None or obj.PhotoSketch is None or not is_edited(obj):
        return
    if name in _bound_names(obj):
        return
    try:
        if _is_there(pipeline.graph_of(obj.PhotoSketch.Sketch), dimension):
            drive(obj, dimension, getattr(obj, name).Value)
    except known_problems() as error:
        host.report(f"{obj.Label}: {in_words(error)}")


def drive(obj: Any, dimension: Dimension, value: float | None) -> None:
    """Say a dimension, in mm or degrees; None lets it follow again.

    Sizes and right angles are said in the model's sketch, other angles of the model.

    Raises
    ------
    SketchError
        Where the value cannot be, or there are no words for it.
    """
    from ...solver.serialise import sketch_to_text

    graph = pipeline.graph_of(obj.PhotoSketch.Sketch)
    if dimension.prefix == ANGLE and _drive_angle(obj, graph, dimension, value):
        return
    if driving(graph).get(dimension) != value:
        obj.PhotoSketch.Sketch = sketch_to_text(said(graph, dimension, value))


def _drive_angle(obj: Any, graph: SketchGraph, dimension: Dimension, value: float | None) -> bool:
    """Say or free an angle of the model; False where that is the sketch's to do."""
    from ...solver.dimensions.angles import RIGHT_DEG, with_angle

    first, second = dimension.ids
    (corner,) = in_order(graph, {(first, second): 0.0}) or [(first, second)]
    said_here = in_order(graph, said_angles(obj))
    if corner not in said_here and value in (None, RIGHT_DEG):
        return False
    if value is None:
        del said_here[corner]
    elif said_here.get(corner) != value:
        said_here = with_angle(graph, said_here, corner, value)
    say_angles(obj, said_here)
    return True


def _bound_names(obj: Any) -> set[str]:
    return {path.lstrip(".") for path, _ in obj.ExpressionEngine if is_dimension(path.lstrip("."))}


def _remove_others(obj: Any, names: set[str]) -> None:
    """Take the properties of elements away that are there no more."""
    for name in obj.PropertiesList:
        ours = is_dimension(name) and obj.getGroupOfProperty(name) in (DRIVING, SHOWN, ANGLES)
        if ours and name not in names:
            obj.removeProperty(name)


def _dress(obj: Any, name: str, group: str, words: str) -> None:
    if obj.getGroupOfProperty(name) != group:
        obj.setGroupOfProperty(name, group)
    if obj.getDocumentationOfProperty(name) != words:
        obj.setDocumentationOfProperty(name, words)
    obj.setEditorMode(name, int(Editor.CHANGEABLE if group == DRIVING else Editor.READ_ONLY))
