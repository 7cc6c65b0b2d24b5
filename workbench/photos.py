"""The photo that a sketch names: found beside the sketch, upright, never outside its folder."""

from __future__ import annotations

from pathlib import Path, PureWindowsPath
from typing import TYPE_CHECKING

from ..solver.graph import SketchGraph

if TYPE_CHECKING:
    from PIL import Image

    from ..solver.values import Array


def photo_path(graph: SketchGraph, sketch: Path) -> tuple[Path | None, str]:
    """Where the photo of a sketch lies.

    Parameters
    ----------
    graph : SketchGraph
    sketch : Path
        The sketch's own file.

    Returns
    -------
    path : Path or None
        None where there is no photo to be had.
    problem : str
        Why, in one line; empty where all is well (or the sketch names no photo).
    """
    if graph.photo is None or not graph.photo.file:
        return None, ""
    name = graph.photo.file
    # Judged by both systems' rules: a sketch made on one is opened on the other.
    foreign = PureWindowsPath(name)
    if foreign.drive or foreign.root or ".." in foreign.parts or "\0" in name:
        return None, f"the photo {name!r} lies outside the sketch's folder and is not opened"
    path = sketch.parent / name
    try:
        if not path.is_file():
            return None, f"the photo {name!r} is not there; it is left out"
        if not path.resolve().is_relative_to(sketch.parent.resolve()):
            return None, f"the photo {name!r} lies outside the sketch's folder and is not opened"
    except OSError as error:
        return None, f"the photo {name!r} cannot be opened: {error.strerror or error}"
    return path, ""


def photo_problem(graph: SketchGraph, sketch: Path) -> str:
    """What is wrong with a sketch's photo, in one line; empty where nothing is."""
    return photo_path(graph, sketch)[1]


def load_photo(graph: SketchGraph, sketch: Path) -> tuple[Image.Image | None, str]:
    """The photo of a sketch, upright.

    Returns
    -------
    photo : PIL.Image.Image or None
    problem : str
        In one line; empty where all is well. The photo may be there none the less.
    """
    path, problem = photo_path(graph, sketch)
    if path is None or graph.photo is None:
        return None, problem
    photo, problem = read_upright(path)
    if photo is None:
        return None, problem
    told = (graph.photo.width_px, graph.photo.height_px)
    if photo.size != told:
        size = f"{photo.size[0]} x {photo.size[1]}"
        return photo, f"the photo is {size} px, the sketch says {told[0]} x {told[1]}"
    return photo, ""


def read_upright(path: Path) -> tuple[Image.Image | None, str]:
    """A photo file, upright.

    Returns
    -------
    photo : PIL.Image.Image or None
    problem : str
        Why there is none, in one line.
    """
    import warnings

    from PIL import Image, ImageOps

    try:
        with warnings.catch_warnings():
            # A photo large enough to be an attack is refused, not warned of.
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            with Image.open(path) as file:
                return ImageOps.exif_transpose(file).convert("RGB"), ""
    except (
        OSError,
        ValueError,
        SyntaxError,
        Image.DecompressionBombError,
        Image.DecompressionBombWarning,
    ) as error:
        reason = "it is no picture" if "cannot identify" in str(error) else str(error)
        return None, f"the photo {path.name!r} cannot be read: {reason}"


def grey_of(photo: Image.Image) -> Array:
    """A photo's brightness, (height, width), 0 to 255."""
    import numpy as np

    return np.asarray(photo.convert("L"), dtype=np.float64)
