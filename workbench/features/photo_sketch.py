"""The photo sketch: one photo and what was drawn over it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .. import host
from ..problems import in_words, known_problems
from . import pipeline
from .properties import OUTCOME, Editor, Property, fail, set_outcome
from .proxy import Proxy, is_of_type

TYPE = "InContext::PhotoSketch"


class PhotoSketch(Proxy):
    """Holds the photo itself and the sketch as text; everything else follows from these two."""

    TYPE = TYPE
    PROPERTIES = (
        Property(
            "App::PropertyFileIncluded", "Photo", "Sketch", "The photo, kept inside the document"
        ),
        Property(
            "App::PropertyString",
            "Sketch",
            "Sketch",
            "What was drawn over the photo, as the text of a sketch file",
            # Thousands of characters: nothing to read or type in the property editor.
            editor=Editor.HIDDEN,
        ),
        Property(
            "App::PropertyString",
            "Marker",
            "Sketch",
            "What in the photo tells the camera: four corners in px, and the sides in mm",
            editor=Editor.HIDDEN,
        ),
        *OUTCOME,
    )

    def execute(self, obj: Any) -> None:
        """See whether the text is a sketch, and say what is wrong if not."""
        try:
            graph = pipeline.graph_of(obj.Sketch)
        except known_problems() as error:
            fail(obj, "unreadable", in_words(error))
            return
        if graph.vertices or graph.circles:
            words = host.translate("InContext", "{} vertices, {} edges, {} annotations")
            counts = (len(graph.vertices), len(graph.edges), len(graph.annotations))
            set_outcome(obj, "ready", words.format(*counts))
        else:
            set_outcome(obj, "ready", host.translate("InContext", "nothing is drawn yet"))


def make_photo_sketch(
    document: Any, sketch_text: str, photo: str | Path | None = None, label: str = ""
) -> Any:
    """A photo sketch in the document.

    Parameters
    ----------
    document : FreeCAD document
    sketch_text : str
        The text of a sketch file.
    photo : path or None
        The image file, which is copied into the document.
    label : str, optional
        What it is called; FreeCAD 1.1 would not give a label back that it had before.

    Returns
    -------
    FreeCAD document object
    """
    obj = document.addObject("App::FeaturePython", "PhotoSketch")
    PhotoSketch(obj)
    obj.Label = label or host.translate("InContext", "Photo sketch")
    if photo is not None:
        obj.Photo = str(photo)
    obj.Sketch = sketch_text
    if host.has_window():
        from .view_providers import PhotoSketchView

        PhotoSketchView(obj.ViewObject)
    return obj


def is_photo_sketch(obj: Any) -> bool:
    """True for photo sketches."""
    return is_of_type(obj, TYPE)
