"""All files of one order, as bytes: nothing is written here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from ..solver.graph import SketchGraph
from ..solver.model import Model, build_model
from ..solver.solution import Solution
from .checked import plates_check, print_check
from .fabrication.fits import effects
from .fabrication.notes import notes_of
from .fabrication.plates import Joined, Plate, joined_plates
from .fabrication.settings import PlateSettings, ShellSettings, ShopSettings, bed_note

if TYPE_CHECKING:
    from PIL import Image

    from .fabrication.assembly import Step
    from .fabrication.checking import Check
    from .fabrication.meshes import Mesh
    from .fabrication.rendering import Scene
    from .fabrication.sheets import Sheet


@dataclass(frozen=True, slots=True)
class Extras:
    """Files that are made only where they are asked for.

    Parameters
    ----------
    pdf : bool
        NAME.pdf: the sheets in true size.
    parts : bool
        NAME.parts.csv: the parts list.
    coupon : bool
        NAME.coupon.dxf and .svg: the fit test with these settings.
    assembly : bool
        NAME.assembly.txt, the order of putting together, and NAME.exploded.png.
    """

    pdf: bool = False
    parts: bool = False
    coupon: bool = False
    assembly: bool = False


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
    shop : ShopSettings
    extras : Extras
    """

    name: str
    plates: PlateSettings | None
    shell: ShellSettings | None = None
    sheet_files: bool = False
    shop: ShopSettings = field(default_factory=ShopSettings)
    extras: Extras = field(default_factory=Extras)


@dataclass(frozen=True, slots=True)
class Made:
    """The files by name, what a person should know about them, and more for who asks.

    Parameters
    ----------
    files : mapping of file name to bytes
    notes : tuple of str
        Joints that are not what they usually are, a print larger than the bed, what it runs into.
    details : tuple of str
        What each setting does in millimetres, all joints, how it fits and stands, the order of
        putting together.
    """

    files: Mapping[str, bytes]
    notes: tuple[str, ...]
    details: tuple[str, ...]


def made(graph: SketchGraph, solution: Solution, photo: Image.Image | None, order: Order) -> Made:
    """Make what is ordered.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
        Converged.
    photo : PIL.Image.Image or None
    order : Order

    Returns
    -------
    Made

    Raises
    ------
    SketchError, FabricationError
        Where nothing can be made of it.
    """
    from .fabrication.picture import caption_of, picture_png
    from .fabrication.rendering import mesh_scene

    thickness = order.plates.thickness_mm if order.plates else 3.0
    model = build_model(solution, thickness, graph.made_revolutions)
    files: dict[str, bytes] = {}
    notes: list[str] = []
    details: list[str] = []
    shown: tuple[str, Scene] | None = None
    if order.plates is not None:
        joined = joined_plates(model, order.plates)
        files |= _plate_files(joined, order.plates, order)
        notes += notes_of(joined)
        steps, locked = _steps(joined.plates, strict=order.extras.assembly)
        notes += locked
        details += [*effects(order.plates), *(joint.words for joint in joined.joints)]
        check = plates_check(joined, model, graph, solution)
        notes += check.problems
        details += check.lines
        if order.extras.assembly:
            files |= _assembly_files(joined.plates, steps, order.name)
            details += [step.words for step in steps]
        shown = _plates_shown(joined.plates)
    if order.shell is not None:
        ending = "solid.step" if order.plates is not None else "step"
        mesh, note = _solid(model, order.shell, files, order.name, ending)
        notes += [note] if note else []
        check = print_check(mesh, model, graph, solution, order.shell.least_wall_mm)
        notes += check.problems
        details += check.lines
        shown = shown or ("Solid", mesh_scene(mesh.vertices_mm, mesh.triangles))
    if shown is not None:
        what, scene = shown
        caption = caption_of(what, scene.triangles_mm)
        files[f"{order.name}.png"] = picture_png(graph, solution, scene, photo, caption)
    return Made(files, tuple(notes), tuple(details))


def _plate_files(joined: Joined, settings: PlateSettings, order: Order) -> dict[str, bytes]:
    from .fabrication.dxf import dxf_bytes
    from .fabrication.marks import edge_marks
    from .fabrication.plates_json import plates_json_bytes
    from .fabrication.presets import load_preset
    from .fabrication.sheets import lay_out
    from .fabrication.solids import plates_step_bytes
    from .fabrication.svg import svg_bytes

    name, plates, preset = order.name, joined.plates, load_preset(order.shop.preset)
    sheets = lay_out(plates, settings, edge_marks(plates, joined.joints), joined.joints)
    if order.sheet_files:
        drawings = {
            f"{name}{'' if n == 1 else f'-{n}'}.dxf": dxf_bytes([sheet], preset)
            for n, sheet in enumerate(sheets, start=1)
        }
    else:
        drawings = {f"{name}.dxf": dxf_bytes(sheets, preset)}
    return {
        **drawings,
        f"{name}.svg": svg_bytes(sheets, preset),
        f"{name}.step": plates_step_bytes(plates, name),
        f"{name}.plates.json": plates_json_bytes(plates),
        **extra_files(plates, sheets, settings, order),
    }


def extra_files(
    plates: Sequence[Plate], sheets: Sequence[Sheet], settings: PlateSettings, order: Order
) -> dict[str, bytes]:
    """The PDF, the parts list and the fit test, where they are asked for."""
    from .fabrication.parts import parts_csv_bytes, parts_list
    from .fabrication.pdf import pdf_bytes
    from .fabrication.presets import load_preset

    files, name, shop = {}, order.name, order.shop
    if order.extras.pdf:
        files[f"{name}.pdf"] = pdf_bytes(sheets, load_preset(shop.preset), shop.page)
    if order.extras.parts:
        files[f"{name}.parts.csv"] = parts_csv_bytes(parts_list(plates, sheets, shop))
    if order.extras.coupon:
        files |= coupon_files(settings, shop, name)
    return files


def coupon_files(settings: PlateSettings, shop: ShopSettings, name: str) -> dict[str, bytes]:
    """The fit test with these settings, as NAME.coupon.dxf and .svg."""
    from .fabrication.dxf import dxf_bytes
    from .fabrication.fits import coupon_sheets
    from .fabrication.presets import load_preset
    from .fabrication.svg import svg_bytes

    sheets, preset = coupon_sheets(settings), load_preset(shop.preset)
    return {
        f"{name}.coupon.dxf": dxf_bytes(sheets, preset),
        f"{name}.coupon.svg": svg_bytes(sheets, preset),
    }


def _steps(plates: Sequence[Plate], *, strict: bool) -> tuple[tuple[Step, ...], list[str]]:
    """How plates go together, and what to say where they do not; an error where it is asked for."""
    from .fabrication.assembly import LockedError, assembly_steps

    try:
        return assembly_steps(plates), []
    except LockedError as error:
        if strict:
            raise
        return (), [str(error)]


def _assembly_files(plates: Sequence[Plate], steps: Sequence[Step], name: str) -> dict[str, bytes]:
    from .fabrication.assembly import exploded
    from .fabrication.picture import scene_png
    from .fabrication.rendering import plates_scene

    lines = [f"{n}. {step.words}" for n, step in enumerate(steps, start=1)]
    return {
        f"{name}.assembly.txt": "\n".join([*lines, ""]).encode(),
        f"{name}.exploded.png": scene_png(plates_scene(exploded(plates, steps))),
    }


def _plates_shown(plates: Sequence[Plate]) -> tuple[str, Scene]:
    from .fabrication.rendering import plates_scene

    count = len(plates)
    return f"{count} plate{'' if count == 1 else 's'}", plates_scene(plates)


def _solid(
    model: Model, settings: ShellSettings, files: dict[str, bytes], name: str, ending: str
) -> tuple[Mesh, str]:
    """Add the files of the solid; its mesh, and what to say about it, are returned."""
    from .fabrication.meshes import mesh_of, stl_bytes, threemf_bytes
    from .fabrication.shell import shell_solid
    from .fabrication.solids import shape_step_bytes

    solid = shell_solid(model, settings)
    mesh = mesh_of(solid, settings.tolerance_mm)
    files[f"{name}.stl"] = stl_bytes(mesh)
    files[f"{name}.3mf"] = threemf_bytes(mesh, name)
    files[f"{name}.{ending}"] = shape_step_bytes(solid, name)
    x, y, z = np.ptp(mesh.vertices_mm, axis=0).tolist()
    note = bed_note((x, y, z), settings.bed_mm)
    return mesh, note


def checks(graph: SketchGraph, solution: Solution, order: Order) -> tuple[Check, ...]:
    """Check the plates, the print, or both.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
        Converged.
    order : Order

    Returns
    -------
    tuple of Check

    Raises
    ------
    SketchError, FabricationError
        Where nothing can be made.
    """
    from .fabrication.plates import joined_plates

    thickness = order.plates.thickness_mm if order.plates else 3.0
    model = build_model(solution, thickness, graph.made_revolutions)
    found = []
    if order.plates is not None:
        joined = joined_plates(model, order.plates)
        found.append(plates_check(joined, model, graph, solution))
    if order.shell is not None:
        from .fabrication.meshes import mesh_of
        from .fabrication.shell import shell_solid

        mesh = mesh_of(shell_solid(model, order.shell), order.shell.tolerance_mm)
        found.append(print_check(mesh, model, graph, solution, order.shell.least_wall_mm))
    return tuple(found)
