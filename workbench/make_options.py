"""The options of ``incontext make``: declared once, and turned into settings."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .fabrication.settings import PlateSettings, ShellSettings, ShopSettings
    from .making import Order


def add_make_options(command: argparse.ArgumentParser) -> None:
    """Declare all options of ``make``."""
    command.add_argument(
        "--out", metavar="DIR", type=Path, required=True, help="folder for the files"
    )
    command.add_argument(
        "--explain",
        action="store_true",
        help="say what each setting does in mm, each joint, how it fits and stands",
    )
    add_settings(command)


def add_settings(command: argparse.ArgumentParser) -> None:
    """Declare the options that say what is made and how."""
    _add_kind(command)
    _add_joints(command.add_argument_group("plates"))
    _add_cutting(command.add_argument_group("cutting"))
    _add_files(command.add_argument_group("more files"))
    _add_printing(command.add_argument_group("printing"))


def _add_kind(command: argparse.ArgumentParser) -> None:
    add = command.add_argument
    add("--laser", action="store_true", help="finger-jointed plates (the default)")
    add("--print", action="store_true", dest="printed", help="a hollow solid")
    add(
        "--side",
        metavar="SIDE",
        default="inside",
        help="where the material lies: inside the drawn faces (default), outside, middle",
    )


def _add_joints(group: argparse._ArgumentGroup) -> None:
    add = group.add_argument
    add("--thickness", metavar="MM", type=float, default=3.0, help="of the stock (3)")
    add("--play", metavar="MM", type=float, default=0.0, help="clearance in the joints (0)")
    add("--finger", metavar="MM", type=float, default=12.0, help="wished width of a finger (12)")
    add(
        "--joint",
        metavar="EDGE=KIND",
        action="append",
        default=[],
        dest="joints",
        help="another joint at an edge, or between two faces: e5=butt, or "
        "f1:f2=finger,finger=8,play=0.1,owner=f1; kinds: auto, finger, butt, half_lap, tab_slot, "
        "none; may be repeated",
    )


def _add_cutting(group: argparse._ArgumentGroup) -> None:
    add = group.add_argument
    add("--kerf", metavar="MM", type=float, default=0.0, help="full width of the beam (0)")
    add(
        "--relief",
        metavar="KIND",
        default="none",
        help="room for a round cutter in inner corners: none (default), dogbone, tbone",
    )
    add("--tool", metavar="MM", type=float, default=3.0, help="diameter of the round cutter (3)")
    add(
        "--sheet",
        metavar="WxH",
        type=_sheet,
        help="size of the stock (the smallest usual sheet that holds every plate)",
    )
    add("--margin", metavar="MM", type=float, default=5.0, help="free border of a sheet (5)")
    add("--spacing", metavar="MM", type=float, default=3.0, help="between two plates (3)")
    add(
        "--grain",
        metavar="WAY",
        default="free",
        help="where up lies on the sheet: x, y or free (default)",
    )
    add("--sheet-files", action="store_true", help="one DXF a sheet: NAME.dxf, NAME-2.dxf, ...")
    add(
        "--preset",
        metavar="SHOP",
        default="plain",
        help="layers and colours: plain (default), cut-only, epilog, lightburn, meerk40t, ponoko, "
        "simple (DXF R12, single lines), or your own .json file",
    )


def _add_files(group: argparse._ArgumentGroup) -> None:
    add = group.add_argument
    add("--pdf", action="store_true", help="NAME.pdf: the sheets in true size")
    add("--page", metavar="SIZE", help="tile the PDF on pages: A4, A3, letter")
    add("--parts", action="store_true", help="NAME.parts.csv: sizes, lengths, times, prices")
    add("--speed", metavar="MM/S", type=float, default=10.0, help="of cutting (10), for the time")
    add("--price", metavar="NUMBER", type=float, help="of a sheet, for the parts list")
    add("--coupon", action="store_true", help="NAME.coupon.dxf: a fit test with these settings")
    add(
        "--assembly",
        action="store_true",
        help="NAME.assembly.txt and NAME.exploded.png: how it goes together",
    )


def _add_printing(group: argparse._ArgumentGroup) -> None:
    add = group.add_argument
    add("--wall", metavar="MM", type=float, default=2.0, help="wall of the hollow solid (2)")
    add("--solid", action="store_true", help="no hollow at all")
    add(
        "--least-wall",
        metavar="MM",
        type=float,
        default=0.4,
        help="refuse thinner walls (0.4)",
    )
    add(
        "--tolerance",
        metavar="MM",
        type=float,
        default=0.02,
        help="how far triangles may leave curves (0.02)",
    )
    add("--bed", metavar="XxYxZ", type=_bed, help="say so where the print is larger than this")
    add(
        "--open",
        metavar="END",
        default="wider",
        dest="open_end",
        help="open end of a turned solid: wider (default), bottom, top, both, none",
    )


def _sheet(text: str) -> tuple[float, float]:
    width, height = _sizes(text, 2, "600x400")
    return width, height


def _bed(text: str) -> tuple[float, float, float]:
    x, y, z = _sizes(text, 3, "250x210x210")
    return x, y, z


def _sizes(text: str, count: int, like: str) -> list[float]:
    try:
        sizes = [float(part) for part in text.lower().replace("×", "x").split("x")]
    except ValueError:
        sizes = []
    if len(sizes) != count:
        raise argparse.ArgumentTypeError(f"{text!r} is no size like {like}")
    return sizes


def order_of(arguments: argparse.Namespace, name: str) -> Order:
    """What the options order.

    Parameters
    ----------
    arguments : argparse.Namespace
    name : str
        What stands before the endings.

    Returns
    -------
    Order

    Raises
    ------
    SettingsError
        Where an option cannot be.
    """
    from .fabrication.settings import ShopSettings
    from .making import Extras, Order

    laser = arguments.laser or not arguments.printed
    extras = Extras(
        pdf=arguments.pdf or arguments.page is not None,
        parts=arguments.parts or arguments.price is not None,
        coupon=arguments.coupon,
        assembly=arguments.assembly,
    )
    # A setting of the printer stops no laser, nor the other way round.
    return Order(
        name,
        _plate_settings(arguments) if laser else None,
        _shell_settings(arguments) if arguments.printed else None,
        arguments.sheet_files,
        _shop_settings(arguments) if laser else ShopSettings(),
        extras,
    )


def _shop_settings(arguments: argparse.Namespace) -> ShopSettings:
    from .fabrication.presets import load_preset
    from .fabrication.settings import ShopSettings

    load_preset(arguments.preset)
    return ShopSettings(
        preset=arguments.preset,
        page=arguments.page,
        cut_mm_s=arguments.speed,
        sheet_price=arguments.price,
    )


def _plate_settings(arguments: argparse.Namespace) -> PlateSettings:
    from .fabrication.joints import JointChoice
    from .fabrication.settings import PlateSettings

    return PlateSettings(
        thickness_mm=arguments.thickness,
        side=arguments.side,
        finger_mm=arguments.finger,
        play_mm=arguments.play,
        kerf_mm=arguments.kerf,
        sheet_mm=arguments.sheet,
        margin_mm=arguments.margin,
        spacing_mm=arguments.spacing,
        relief=arguments.relief,
        tool_mm=arguments.tool,
        grain=arguments.grain,
        joints=tuple(JointChoice.parse(text) for text in arguments.joints),
    )


def _shell_settings(arguments: argparse.Namespace) -> ShellSettings:
    from .fabrication.settings import ShellSettings

    return ShellSettings(
        wall_mm=arguments.wall,
        side=arguments.side,
        open_end=arguments.open_end,
        solid=arguments.solid,
        least_wall_mm=arguments.least_wall,
        tolerance_mm=arguments.tolerance,
        bed_mm=arguments.bed,
    )
