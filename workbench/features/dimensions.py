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
    Dimension,
    dimension_named,
    driving,
    is_dimension,
    measured,
    said,
)
from .dimension_words import Words
from .driven import bound_names, is_there
from .model_angles import in_order, said_angles, say_angles
from .properties import Editor
from .proxy import is_edited

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution

DRIVING, SHOWN, ANGLES = "Dimensions", "Shown dimensions", "Shown dimensions: angles"


def show_dimensions(obj: Any, graph: SketchGraph, solution: Solution) -> None:
    """Give a lifted model the properties of its dimensions, with their values after a solve."""
    said_here, bound = _said_here(obj, graph), bound_names(obj)
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
    if name in bound_names(obj):
        return
    try:
        if is_there(pipeline.graph_of(obj.PhotoSketch.Sketch), dimension):
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
