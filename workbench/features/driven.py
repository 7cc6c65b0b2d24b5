"""The sketch as its lifted model takes it: with what expressions and the model's own angles say.

Terms
-----
driven
    With these said. Nothing of it is ever written into the sketch.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..problems import known_problems
from . import pipeline
from .dimension_names import (
    ANGLE,
    DIAMETER,
    HEIGHT,
    Dimension,
    dimension_named,
    is_dimension,
    said,
)
from .methods import OURS, source_of
from .model_angles import in_order, said_angles, text_of

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ...solver.graph import SketchGraph
    from .model_angles import Corner


def driven_text(model: Any) -> str:
    """The source of a lifted model: its photo sketch's text, driven, and its method.

    Raises
    ------
    SketchError
        Where the text is no sketch, or an expression gives a size that cannot be.
    """
    return _source(model, model.PhotoSketch.Sketch, model.Method)


def shown_source(model: Any | None, sketch_text: str) -> str:
    """The source of what the tab of a sketch shows: by the solver's own method, which is quick.

    Parameters
    ----------
    model : lifted model or None
        The one that the sketch is shown for. Where that says what cannot be, the sketch is shown
        as it is.
    sketch_text : str
    """
    try:
        return sketch_text if model is None else _source(model, sketch_text, OURS)
    except known_problems():
        return sketch_text


def driven_graph(model: Any | None, graph: SketchGraph) -> SketchGraph:
    """The graph of `shown_source`, with angles among its annotations; it cannot be saved so."""
    if model is None:
        return graph
    from ...solver.said_angles import with_angles

    try:
        sizes, angles = _said_beside(model, graph)
        for dimension, value in sizes:
            graph = said(graph, dimension, value)
        return with_angles(graph, angles)
    except known_problems():
        return graph


def bound_names(model: Any) -> set[str]:
    """Names of the dimensions that expressions give."""
    paths = (path.lstrip(".") for path, _ in model.ExpressionEngine)
    return {path for path in paths if is_dimension(path)}


def is_there(graph: SketchGraph, dimension: Dimension) -> bool:
    """Whether the elements that a dimension is of are in the graph."""
    if dimension.prefix == HEIGHT:
        return dimension.ids[0] in graph.vertices or dimension.ids[0] in graph.circles
    elements = graph.circles if dimension.prefix == DIAMETER else graph.edges
    return all(id_ in elements for id_ in dimension.ids)


def _source(model: Any, text: str, method: str) -> str:
    if not (bound_names(model) or said_angles(model)):
        return source_of(text, method)
    sizes, angles = _said_beside(model, pipeline.graph_of(text))
    text = pipeline.resized_text(text, sizes) if sizes else text
    return source_of(text, method, text_of(angles))


def _said_beside(
    model: Any, graph: SketchGraph
) -> tuple[tuple[tuple[Dimension, float], ...], dict[Corner, float]]:
    """What a model says beside its sketch: sizes, and angles by corner."""
    given = _given(model)
    angles = {d.ids: given.pop(d) for d in list(given) if d.prefix == ANGLE}
    # What an expression gave to an element that is gone is taken away after the solve.
    sizes = tuple(pair for pair in given.items() if is_there(graph, pair[0]))
    return sizes, _angles(model, graph, angles)


def _given(model: Any) -> dict[Dimension, float]:
    """What expressions give."""
    bound = {name: dimension_named(name) for name in sorted(bound_names(model))}
    return {
        dimension: float(getattr(model, name).Value)
        for name, dimension in bound.items()
        if dimension is not None and name in model.PropertiesList
    }


def _angles(
    model: Any, graph: SketchGraph, given: Mapping[tuple[str, ...], float]
) -> dict[Corner, float]:
    """The angles that are said of the model, by a person or by an expression."""
    from ...solver.said_angles import need_angle

    bound = {(first, second): angle for (first, second), angle in given.items()}
    found = in_order(graph, {**said_angles(model), **bound})
    for corner, angle_deg in found.items():
        need_angle(graph, corner, angle_deg)
    return found
