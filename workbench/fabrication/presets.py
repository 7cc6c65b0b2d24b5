"""Names and colours of layers, as shops and programs want them.

A preset is a JSON file. Ours lie in ``resources/presets/shops``; a person's own is given by its
path, or put beside ours.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .errors import SettingsError

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "presets" / "shops"
#: What paths are for, in the order in which a machine should work.
PURPOSES = ("ENGRAVE", "CUT_INNER", "CUT_OUTER", "SHEET", "SCALE")
DXF_VERSIONS = ("R2000", "R12")
DEFAULT = "plain"
_REMEDY = 'like {"name": "My shop", "layers": {"CUT_OUTER": {"name": "Cut", "rgb": "#ff0000"}}}'


@dataclass(frozen=True, slots=True)
class Layer:
    """A layer: its name in files, AutoCAD's colour index for DXF, hexadecimal for SVG and PDF.

    `shown` is false where the shop wants no such layer in its files.
    """

    name: str
    aci: int
    rgb: str
    shown: bool = True


@dataclass(frozen=True, slots=True)
class Preset:
    """What a shop or program wants in its files.

    Parameters
    ----------
    id, name : str
    layers : mapping of purpose to Layer
    dxf : str
        One of `DXF_VERSIONS`; old programs read R12 only.
    lines : bool
        True makes every path of the DXF single lines, for programs that know no polylines.
    """

    id: str
    name: str
    layers: Mapping[str, Layer]
    dxf: str = "R2000"
    lines: bool = False


#: Where a preset says nothing.
PLAIN = {
    "ENGRAVE": Layer("ENGRAVE", 5, "#0000ff"),
    "CUT_INNER": Layer("CUT_INNER", 6, "#ff00ff"),
    "CUT_OUTER": Layer("CUT_OUTER", 1, "#ff0000"),
    "SHEET": Layer("SHEET", 8, "#808080"),
    "SCALE": Layer("SCALE", 9, "#808080"),
}


def preset_names() -> tuple[str, ...]:
    """The names by which presets can be asked for."""
    return tuple(sorted({DEFAULT, *(path.stem for path in FOLDER.glob("*.json"))}))


def load_preset(name: str) -> Preset:
    """A preset by its name or path.

    Parameters
    ----------
    name : str
        One of `preset_names`, or the path of a JSON file.

    Returns
    -------
    Preset

    Raises
    ------
    SettingsError
        Where there is none, or it says something that cannot be.
    """
    path = Path(name) if name.endswith(".json") else FOLDER / f"{name}.json"
    if not name.endswith(".json") and name not in preset_names():
        raise SettingsError(
            f"there is no preset {name!r}", (), f"{', '.join(preset_names())} or a .json file"
        )
    if name == DEFAULT and not path.is_file():
        return Preset(DEFAULT, "Plain", PLAIN)
    try:
        body = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise SettingsError(
            f"the preset {path.name} cannot be read: {error}", (), _REMEDY
        ) from None
    if not isinstance(body, dict) or not isinstance(body.get("layers"), dict):
        raise SettingsError(f"the preset {path.name} has no layers", (), _REMEDY)
    unknown = set(body["layers"]) - set(PURPOSES)
    if unknown:
        raise SettingsError(
            f"the preset {path.name} names unknown layers", sorted(unknown), ", ".join(PURPOSES)
        )
    layers = {
        purpose: _layer(path.name, purpose, body["layers"].get(purpose, {})) for purpose in PURPOSES
    }
    dxf, lines = body.get("dxf", DXF_VERSIONS[0]), body.get("lines", False)
    if dxf not in DXF_VERSIONS or type(lines) is not bool:
        raise SettingsError(
            f"the preset {path.name} asks for a DXF that we do not write",
            (),
            'dxf "R2000" or "R12", lines true or false',
        )
    return Preset(path.stem, str(body.get("name", path.stem)), layers, dxf, lines)


def _layer(file: str, purpose: str, body: Any) -> Layer:
    plain = PLAIN[purpose]
    known = {"name", "aci", "rgb", "shown"}
    if not isinstance(body, dict) or set(body) - known:
        raise SettingsError(
            f"the preset {file} says something unknown of a layer",
            (purpose,),
            ", ".join(sorted(known)),
        )
    layer = Layer(
        body.get("name", plain.name),
        body.get("aci", plain.aci),
        body.get("rgb", plain.rgb),
        body.get("shown", True),
    )
    sound = (
        isinstance(layer.name, str)
        and re.fullmatch(r"[\w $-]{1,60}", layer.name)
        and type(layer.aci) is int
        and 1 <= layer.aci <= 255
        and isinstance(layer.rgb, str)
        and re.fullmatch(r"#[0-9a-fA-F]{6}", layer.rgb)
        and type(layer.shown) is bool
    )
    if not sound:
        raise SettingsError(
            f"the preset {file} has a wrong name or colour",
            (purpose,),
            "a name, aci from 1 to 255, rgb like #ff0000",
        )
    return layer
