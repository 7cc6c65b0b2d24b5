"""`make run`: the bookshelf example, in FreeCAD's window or, without one, into files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD

from .features import pipeline
from .features.examples import make_example
from .features.exports import export_plates
from .features.lifted_model import solution_of
from .features.plate_set import plates_of
from .problems import in_words, known_problems

EXAMPLE = "bookshelf"


def write(arguments: list[str]) -> int:
    """Make the example and write everything that comes of it into a folder.

    Parameters
    ----------
    arguments : list of str
        The folder.

    Returns
    -------
    int
        Exit status.
    """
    folder = Path(arguments[0])
    try:
        for path in _write(folder):
            print(f"  {path.name}")
    except known_problems() as error:
        print(f"The {EXAMPLE} example could not be made: {in_words(error)}")
        return 1
    print(f"in {folder}.")
    print("There is no display; with one, `make run` opens FreeCAD's window.")
    return 0


def _write(folder: Path) -> list[Path]:
    from ..solver import save_solution

    document = FreeCAD.newDocument(EXAMPLE)
    sketch, model, plate_set = _made(document)
    print(f"The {EXAMPLE} example, made by FreeCAD {'.'.join(FreeCAD.Version()[:2])}:")
    print(f"  {plate_set.PlateCount} plates, {plate_set.Shape.Volume / 1e3:.1f} cm3 of wood")
    written = list(export_plates(plate_set, folder, EXAMPLE))
    solution = folder / f"{EXAMPLE}.solution.json"
    save_solution(solution_of(model), solution)
    picture = folder / f"{EXAMPLE}.png"
    picture.write_bytes(_picture(sketch, plate_set))
    saved = folder / f"{EXAMPLE}.FCStd"
    document.saveAs(str(saved))
    return [saved, *written, picture, solution]


def _picture(sketch: Any, plate_set: Any) -> bytes:
    from PIL import Image, ImageOps

    from .fabrication.picture import caption_of, picture_png
    from .fabrication.rendering import plates_scene

    scene = plates_scene(plates_of(plate_set))
    caption = caption_of(plate_set.Message, scene.triangles_mm)
    with Image.open(sketch.Photo) as photo:
        graph, solution = pipeline.graph_of(sketch.Sketch), pipeline.solution_of(sketch.Sketch)
        return picture_png(
            graph, solution, scene, ImageOps.exif_transpose(photo).convert("RGB"), caption
        )


def _made(document: Any) -> tuple[Any, Any, Any]:
    from ..solver.errors import SketchError

    objects = make_example(document, EXAMPLE)
    for obj in objects[1:]:
        if obj.Shape.isNull():
            raise SketchError(f"{obj.Label}: {obj.Message}")
    return objects


def show(arguments: list[str]) -> int | None:
    """Open the example in FreeCAD's window, which stays open.

    Returns
    -------
    int or None
        Exit status where that failed.
    """
    import FreeCADGui

    from .commands.open_example import OpenExample

    FreeCADGui.activateWorkbench("InContextWorkbench")
    try:
        OpenExample().run()
    except known_problems() as error:
        print(f"The {EXAMPLE} example could not be made: {in_words(error)}")
        return 1
    return None
