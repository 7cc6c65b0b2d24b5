"""Sketch files and examples as document objects."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .. import host
from .lifted_model import make_lifted_model
from .photo_sketch import make_photo_sketch
from .plate_set import make_plate_set

SKETCH_ENDING = ".sketch.json"


def example_path(name: str) -> Path:
    """The sketch file of an example."""
    return Path(host.resource("examples", name, name + SKETCH_ENDING))


def import_sketch(document: Any, path: Path, label: str = "") -> Any:
    """A photo sketch from a sketch file; its photo is looked for beside it.

    Parameters
    ----------
    document : FreeCAD document
    path : Path
    label : str, optional
        What it is called; the file's name by default.

    Returns
    -------
    FreeCAD document object

    Raises
    ------
    SketchError
        Where the file cannot be used.
    """
    from ...solver import load_sketch
    from ...solver.serialise import sketch_to_text
    from ..photos import photo_path

    graph = load_sketch(path)
    photo, problem = photo_path(graph, path)
    if problem:
        host.warn(problem)
    name = label or path.name.removesuffix(SKETCH_ENDING)
    return make_photo_sketch(document, sketch_to_text(graph), photo, name)


def make_example(document: Any, name: str) -> tuple[Any, Any, Any]:
    """An example, all the way to its plates: photo sketch, lifted model, plate set."""
    label = host.translate("InContext", "Photo sketch")
    sketch = import_sketch(document, example_path(name), label)
    model = make_lifted_model(document, sketch)
    plates = make_plate_set(document, model)
    document.recompute()
    return sketch, model, plates
