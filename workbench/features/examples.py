"""Sketch files and examples as document objects."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .. import host
from ..examples import SKETCH_ENDING, load_example
from ..wording import in_language
from .lifted_model import make_lifted_model
from .photo_sketch import make_photo_sketch
from .plate_set import make_plate_set
from .shelled_solid import make_shelled_solid

#: How the objects call the settings that examples choose.
_PROPERTIES = {
    "thickness_mm": "Thickness",
    "finger_mm": "FingerWidth",
    "wall_mm": "Wall",
    "side": "Side",
    "open_end": "OpenEnd",
}


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
        host.warn(in_language(problem))
    name = label or path.name.removesuffix(SKETCH_ENDING)
    return make_photo_sketch(document, sketch_to_text(graph), photo, name)


def make_example(document: Any, name: str) -> tuple[Any, Any, Any]:
    """An example, all the way: photo sketch, lifted model, and plate set or shelled solid."""
    example = load_example(name)
    label = host.translate("InContext", "Photo sketch")
    sketch = import_sketch(document, example.sketch_path, label)
    model = make_lifted_model(document, sketch)
    make = make_shelled_solid if example.is_printed else make_plate_set
    product = make(document, model)
    for field, value in example.settings.items():
        setattr(product, _PROPERTIES[field], value)
    document.recompute()
    return sketch, model, product
