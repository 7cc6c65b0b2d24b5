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
        "Take the lens's distortion out of a sketch's photo. Its long edges, and lines traced on "
        "straight things (construction geometry), tell how the lens bends them. Writes the "
        "straight photo, and the sketch over it."
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
    from .photos import load_photo
    from .straight_photo import straight_picture, straightened_sketch

    graph = load_sketch(arguments.sketch)
    picture, problem = load_photo(graph, arguments.sketch)
    if picture is None or problem:
        raise SketchError(problem or "the sketch has no photo", (), "the photo beside the sketch")
    lens = lens_of_sketch(graph, arguments.sketch)
    if lens is None:
        raise SketchError(
            "no straight edge is seen in the photo",
            (),
            "draw construction lines along straight things, near the photo's borders",
        )
    if not lens.distorts:
        print(f"nothing to straighten: lines bend by {lens.worst[1]:.1f} px at most")
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
    """The lens as a sketch's photo tells it; None where no long edge is to be seen."""
    import numpy as np

    from .lens import lens_of, traced_ends
    from .photos import grey_of, load_photo

    picture, problem = load_photo(graph, path)
    if picture is None or problem:
        return None
    return lens_of(grey_of(picture), traced_ends(graph), np.array(graph.principal_point_px))
