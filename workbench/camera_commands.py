"""``incontext marker`` and ``incontext camera``: a marker to print, and the camera from it."""

from __future__ import annotations

import argparse
import math
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ..solver.graph import Photo, SketchGraph
    from ..solver.values import Array
    from .marker_finding import Found

#: Pictures, by the endings of their names; all else is taken for a sketch.
_PICTURES = {".jpg", ".jpeg", ".png", ".tif", ".tiff", ".bmp", ".webp"}


def add_marker(commands: Any) -> None:
    """Declare ``marker``."""
    text = "Write a marker to print: it gives the camera and the scale of photos that it is in."
    command = commands.add_parser("marker", help="write a marker to print", description=text)
    add = command.add_argument
    add("--out", metavar="FILE", type=Path, required=True, help="a .pdf or .svg file")
    add("--size", metavar="MM", type=float, default=100.0, help="of the black square (100)")
    command.set_defaults(run=_marker)


def add_camera(commands: Any) -> None:
    """Declare ``camera``."""
    text = (
        "Find the camera from a marker, or any rectangle of known size, that lies on the ground. "
        "For a sketch, it is written into it; for a photo, a new sketch is written with -o, else "
        "the camera is printed. Without --size, a sketch's lines traced on real things (its "
        "construction geometry) are judged one by one, and the camera that they lead to is said."
    )
    command = commands.add_parser(
        "camera", help="find the camera from a marker in the photo", description=text
    )
    add = command.add_argument
    add("input", metavar="PHOTO|SKETCH", type=Path, help="a picture or a .sketch.json file")
    add(
        "--size",
        metavar="MM",
        type=_size,
        help="of the marker's black square, or both sides of a rectangle: 100, 297x210, A4, A5, "
        "letter, card",
    )
    add(
        "--corners",
        metavar="U,V",
        type=_point,
        nargs=4,
        help="the rectangle's four corners in the upright photo, px, in any order; without them "
        "the printed marker is looked for (needs opencv-python-headless)",
    )
    add(
        "--exactly",
        action="store_true",
        help="take the corners as they are told, and nothing of what is drawn",
    )
    add("--focal", metavar="PX", type=float, help="focal length (else from EXIF, else found)")
    add(
        "--middle",
        metavar="U,V",
        type=_point,
        help="where the axis of view meets a photo that was cropped, px (else its middle)",
    )
    add("-o", "--output", metavar="FILE", type=Path, help="the sketch file to write")
    command.set_defaults(run=_camera)


def _size(text: str) -> tuple[float, float]:
    from ..solver.perspective.marker import RECTANGLES

    for name, sides in RECTANGLES.items():
        if text.lower() == name.lower():
            return sides
    try:
        sides = [float(side) for side in text.lower().replace("×", "x").split("x")]
    except ValueError:
        sides = []
    if len(sides) not in (1, 2):
        names = ", ".join(RECTANGLES)
        raise argparse.ArgumentTypeError(f"{text!r} is no size like 100, 297x210 or {names}")
    return (sides[0], sides[-1])


def _point(text: str) -> tuple[float, float]:
    try:
        u, v = (float(part) for part in text.split(","))
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"{text!r} is no place like 812,402.5") from error
    return (u, v)


def _marker(arguments: argparse.Namespace) -> int:
    from ..solver.files import write_files
    from .marker_sheet import marker_file

    write_files({arguments.out: marker_file(arguments.out, arguments.size)})
    print(arguments.out)
    return 0


def _camera(arguments: argparse.Namespace) -> int:
    from ..solver.errors import SketchError
    from ..solver.files import write_files
    from ..solver.perspective.refining import refined_camera
    from ..solver.serialise import sketch_to_text
    from .marker_finding import camera_of_corners, seen_corners

    is_photo = arguments.input.suffix.lower() in _PICTURES
    if arguments.size is None:
        return _judge_lines(arguments.input, is_photo=is_photo)
    graph, grey = (_of_photo if is_photo else _of_sketch)(arguments.input)
    photo = _photo_of(graph, arguments.focal, arguments.middle)
    try:
        seen = seen_corners(photo, grey, arguments.corners, exactly=arguments.exactly)
    except ModuleNotFoundError as error:
        raise SketchError(
            f"the marker is found by OpenCV, which is not installed ({error.name})",
            (),
            "pip install opencv-python-headless, or tell the four --corners",
        ) from error
    found = camera_of_corners(photo, seen, arguments.size)
    graph = replace(graph, photo=photo)
    refined = None if arguments.exactly else refined_camera(graph, found.view)
    graph = replace(graph, camera=refined or found.view.camera)
    output = arguments.output or (None if is_photo else arguments.input)
    if output is None:
        print(_camera_text(graph))
    else:
        write_files({output: sketch_to_text(graph).encode()})
    # What is printed may be read by a program: words go beside it.
    words = camera_words(found, photo)
    if refined is not None:
        words.append(f"together with the drawing: {refined.focal_px:.0f} px focal length")
    for line in words:
        print(line, file=sys.stderr if output is None else sys.stdout)
    return 0


def _judge_lines(path: Path, *, is_photo: bool) -> int:
    """Say what the traced lines of a sketch tell, and how well each agrees."""
    from ..solver import load_sketch, solve
    from ..solver.errors import SketchError
    from ..solver.perspective.vanishing_points import traced_lines
    from .cropped_photos import perspective_notes
    from .straighten_command import lens_of_sketch

    if is_photo:
        raise SketchError("of a photo alone the size is asked", (), "--size 100")
    graph = load_sketch(path)
    solution = solve(graph)
    traced = traced_lines(graph, solution)
    if solution.camera is None or not traced.lines:
        raise SketchError(
            "no line is traced on a real thing, or the sketch cannot be solved",
            (),
            "construction lines along what is in the photo, or --size of a rectangle",
        )
    print(f"camera: {solution.camera.focal_px:.0f} px focal length; {solution.message}")
    for bundle in traced.bundles:
        sure = math.degrees(bundle.sigma_rad)
        told = f"tell their direction to {sure:.1f} degrees" if sure < 90 else "tell no direction"
        print(f"{', '.join(bundle.edges)}: {told}")
        for edge in bundle.edges:
            line = traced.lines[edge]
            print(f"  {edge}: {line.off_px:.1f} px, {math.degrees(line.off_rad):.2f} degrees off")
    lens = lens_of_sketch(graph, path)
    for note in (*perspective_notes(graph, traced), *(() if lens is None else lens.notes)):
        print(f"note: {note}")
    return 0


def _camera_text(graph: SketchGraph) -> str:
    import json

    assert graph.camera is not None
    return json.dumps(graph.camera.to_json(), indent=1)


def _of_photo(path: Path) -> tuple[SketchGraph, Array | None]:
    from ..solver.errors import SketchFileError
    from ..solver.graph import Photo, SketchGraph
    from .exif import focal_length_px
    from .photos import grey_of, read_upright

    picture, problem = read_upright(path)
    if picture is None:
        raise SketchFileError(problem, (), "a JPEG or PNG file")
    photo = Photo(path.name, *picture.size, focal_px=focal_length_px(path))
    return SketchGraph(photo=photo), grey_of(picture)


def _of_sketch(path: Path) -> tuple[SketchGraph, Array | None]:
    from ..solver import load_sketch
    from .exif import focal_length_px
    from .photos import grey_of, load_photo, photo_path

    graph = load_sketch(path)
    picture, problem = load_photo(graph, path)
    if problem:
        print(f"warning: {problem}", file=sys.stderr)
    file = photo_path(graph, path)[0]
    if graph.photo is not None and graph.photo.focal_px is None and file is not None:
        graph = replace(graph, photo=replace(graph.photo, focal_px=focal_length_px(file)))
    told = None if graph.photo is None else (graph.photo.width_px, graph.photo.height_px)
    # A photo of another size would put the corners elsewhere.
    return graph, grey_of(picture) if picture is not None and picture.size == told else None


def _photo_of(
    graph: SketchGraph, focal_px: float | None, middle_px: tuple[float, float] | None
) -> Photo:
    from ..solver.errors import SketchError

    if graph.photo is None:
        raise SketchError("the sketch has no photo", (), "a sketch with one, or the photo itself")
    if focal_px is not None and not focal_px > 0:
        raise SketchError(f"a focal length of {focal_px:g} px is none", (), "a number above 0")
    photo = graph.photo
    return replace(
        photo,
        focal_px=photo.focal_px if focal_px is None else focal_px,
        principal_point_px=photo.principal_point_px if middle_px is None else middle_px,
    )


def camera_words(found: Found, photo: Photo) -> list[str]:
    """What was found, a line each: the camera, how exact it is, what to mind."""
    view = found.view
    focal_35mm = view.camera.focal_px / max(photo.width_px, photo.height_px) * 36
    height = float(view.camera.position_mm[2])
    seen = "corners found in the photo" if found.seen.sides else "corners as told"
    return [
        f"camera: {focal_35mm:.0f} mm equivalent ({view.camera.focal_px:.0f} px, good to "
        f"{100 * view.focal_sigma:.1f} %), {height:.0f} mm above the ground",
        f"{seen}, met to {view.misfit_px:.2f} px; heights beside it are good to "
        f"{100 * view.size_sigma:.1f} %",
        *(f"note: {note}" for note in found.notes),
    ]
