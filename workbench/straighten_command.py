"""``incontext straighten``: a photo without its lens's distortion, and the sketch over it."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ..solver.graph import SketchGraph
    from .lens import Lens


def add_straighten(commands: Any) -> None:
    """Declare ``straighten``."""
    text = (
        "Take the lens's distortion out of a sketch's photo. Lines traced on straight things (its "
        "construction geometry) tell how the lens bends them. Writes the straight photo, and the "
        "sketch over it."
    )
    command = commands.add_parser(
        "straighten", help="take the lens's distortion out of a photo", description=text
    )
    add = command.add_argument
    add("sketch", metavar="SKETCH", type=Path, help="a .sketch.json file with its photo")
    add("-o", "--output", metavar="SKETCH", type=Path, required=True, help="the sketch to write")
    command.set_defaults(run=_straighten)


def _straighten(arguments: argparse.Namespace) -> int:
    import io

    import numpy as np
    from PIL import Image

    from ..solver import load_sketch
    from ..solver.errors import SketchError
    from ..solver.files import write_files
    from ..solver.serialise import sketch_to_text
    from .lens import straight_picture, straightened_sketch
    from .photos import load_photo

    graph = load_sketch(arguments.sketch)
    picture, problem = load_photo(graph, arguments.sketch)
    if picture is None or problem:
        raise SketchError(problem or "the sketch has no photo", (), "the photo beside the sketch")
    lens = lens_of_sketch(graph, arguments.sketch)
    if lens is None:
        raise SketchError(
            "no traced line is seen in the photo",
            (),
            "draw construction lines along straight things, near the photo's borders",
        )
    if not lens.distorts:
        print(f"nothing to straighten: lines bend by {lens.bends_px[lens.worst]:.1f} px at most")
        return 0
    straight = Image.fromarray(straight_picture(np.asarray(picture), lens))
    data = io.BytesIO()
    straight.save(data, "JPEG", quality=95)
    name = f"{arguments.output.name.removesuffix('.json').removesuffix('.sketch')}.straight.jpg"
    sketch = sketch_to_text(straightened_sketch(graph, lens, name)).encode()
    write_files({arguments.output.with_name(name): data.getvalue(), arguments.output: sketch})
    for note in lens.notes:
        print(note)
    if graph.camera is not None:
        print("note: the camera was that of the bent photo; find it again")
    return 0


def lens_of_sketch(graph: SketchGraph, path: Path) -> Lens | None:
    """The lens as a sketch's traced lines tell it; None where they are not to be seen."""
    import numpy as np

    from .lens import lens_of, traced_ends
    from .photos import grey_of, load_photo

    lines = traced_ends(graph)
    picture, problem = load_photo(graph, path) if lines else (None, "")
    if picture is None or problem:
        return None
    return lens_of(grey_of(picture), lines, np.array(graph.principal_point_px))
