"""How large the area is that a sketch is drawn on; no Qt."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph

#: Without a photo, the sketch lies on an empty area at least this large, px.
LEAST_SIZE = (800.0, 600.0)


def sketch_size(graph: SketchGraph) -> tuple[float, float]:
    """The photo's size as the sketch knows it; without a photo, room for the drawing."""
    if graph.photo is not None:
        return (float(graph.photo.width_px), float(graph.photo.height_px))
    us = [u for u, _ in graph.vertices.values()]
    vs = [v for _, v in graph.vertices.values()]
    return (max(us, default=0.0) + 50.0, max(vs, default=0.0) + 50.0) if us else LEAST_SIZE
