"""All files of one order, as bytes: nothing is written here."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..solver.graph import SketchGraph
from ..solver.model import Model, build_model
from ..solver.solution import Solution
from .fabrication.plates import Plate, make_plates
from .fabrication.settings import PlateSettings, ShellSettings

if TYPE_CHECKING:
    from PIL import Image

    from .fabrication.rendering import Scene


@dataclass(frozen=True, slots=True)
class Order:
    """What is to be made.

    Parameters
    ----------
    name : str
        What stands before the endings.
    plates : PlateSettings or None
    shell : ShellSettings or None
        At least one of the two.
    sheet_files : bool
        One DXF for each sheet instead of one for all.
    """

    name: str
    plates: PlateSettings | None
    shell: ShellSettings | None = None
    sheet_files: bool = False


def made_files(
    graph: SketchGraph, solution: Solution, photo: Image.Image | None, order: Order
) -> dict[str, bytes]:
    """The files of an order.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
        Converged.
    photo : PIL.Image.Image or None
    order : Order

    Returns
    -------
    dict of file name to bytes

    Raises
    ------
    SketchError, FabricationError
        Where nothing can be made of it.
    """
    from .fabrication.picture import caption_of, picture_png

    thickness = order.plates.thickness_mm if order.plates else 3.0
    model = build_model(solution, thickness, graph.revolutions)
    files: dict[str, bytes] = {}
    shown: tuple[str, Scene] | None = None
    if order.plates is not None:
        plates = make_plates(model, order.plates)
        files |= _plate_files(plates, order.plates, order)
        shown = _plates_shown(plates)
    if order.shell is not None:
        ending = "solid.step" if order.plates is not None else "step"
        scene = _solid(model, order.shell, files, order.name, ending)
        shown = shown or ("Solid", scene)
    if shown is not None:
        what, scene = shown
        caption = caption_of(what, scene.triangles_mm)
        files[f"{order.name}.png"] = picture_png(graph, solution, scene, photo, caption)
    return files


def _plate_files(
    plates: Sequence[Plate], settings: PlateSettings, order: Order
) -> dict[str, bytes]:
    from .fabrication.dxf import dxf_bytes
    from .fabrication.plates_json import plates_json_bytes
    from .fabrication.sheets import lay_out
    from .fabrication.solids import plates_step_bytes
    from .fabrication.svg import svg_bytes

    name = order.name
    sheets = lay_out(plates, settings)
    if order.sheet_files:
        drawings = {
            f"{name}{'' if n == 1 else f'-{n}'}.dxf": dxf_bytes([sheet])
            for n, sheet in enumerate(sheets, start=1)
        }
    else:
        drawings = {f"{name}.dxf": dxf_bytes(sheets)}
    return {
        **drawings,
        f"{name}.svg": svg_bytes(sheets),
        f"{name}.step": plates_step_bytes(plates, name),
        f"{name}.plates.json": plates_json_bytes(plates),
    }


def _plates_shown(plates: Sequence[Plate]) -> tuple[str, Scene]:
    from .fabrication.rendering import plates_scene

    count = len(plates)
    return f"{count} plate{'' if count == 1 else 's'}", plates_scene(plates)


def _solid(
    model: Model, settings: ShellSettings, files: dict[str, bytes], name: str, ending: str
) -> Scene:
    """Add the files of the hollow solid; how it looks is returned."""
    from .fabrication.meshes import mesh_of, stl_bytes, threemf_bytes
    from .fabrication.rendering import mesh_scene
    from .fabrication.shell import shell_solid
    from .fabrication.solids import shape_step_bytes

    solid = shell_solid(model, settings)
    mesh = mesh_of(solid)
    files[f"{name}.stl"] = stl_bytes(mesh)
    files[f"{name}.3mf"] = threemf_bytes(mesh, name)
    files[f"{name}.{ending}"] = shape_step_bytes(solid, name)
    return mesh_scene(mesh.vertices_mm, mesh.triangles)
