"""Materials and machines: values that belong together, taken from a drop-down, free to be edited.

A preset is a small JSON file in ``resources/presets/materials`` or ``machines``; a person's own lie
in the folders of the same names that `own_folder` tells. One with the name of another replaces it.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .. import host

#: What an object has where none was taken.
NONE = "-"
#: Properties with a drop-down, and the folder of their presets.
KINDS = {"Material": "materials", "Machine": "machines"}
#: Bytes of the largest file that is read.
MAX_BYTES = 20_000
#: What a preset may say, by the property that takes it.
LENGTHS = {
    "thickness_mm": "Thickness",
    "play_mm": "Play",
    "finger_mm": "FingerWidth",
    "kerf_mm": "Kerf",
    "margin_mm": "Margin",
    "spacing_mm": "Spacing",
    "tool_mm": "ToolDiameter",
    "wall_mm": "Wall",
    "least_wall_mm": "LeastWall",
    "tolerance_mm": "Tolerance",
}
SIZES = {"sheet_mm": ("SheetWidth", "SheetHeight"), "bed_mm": ("Bed",)}
OTHERS = {"cut_mm_s": "CuttingSpeed", "relief": "CornerRelief", "layers": "Preset"}
#: No length or speed is greater.
MOST = 1e5


@dataclass(frozen=True, slots=True)
class Preset:
    """One material or machine: its name, what it is for, and what it says."""

    name: str
    makes: str
    values: Mapping[str, Any]


def own_folder() -> Path:
    """Where a person's own presets lie, in folders named as ours."""
    return Path(host.user_folder()) / "InContext" / "presets"


def presets_of(kind: str, makes: str) -> dict[str, Preset]:
    """All presets by name.

    Parameters
    ----------
    kind : "Material" or "Machine"
    makes : "plates" or "print"

    A file that is none is told of in the report view, and left out.
    """
    found: dict[str, Preset] = {}
    for path in _files(KINDS[kind]):
        try:
            preset = read_preset(path)
        except (OSError, ValueError, RecursionError) as error:
            words = host.translate("InContext", "{0} is no preset: {1}")
            host.warn(words.format(path, error))
            continue
        if preset.makes == makes:
            found[preset.name] = preset
    return dict(sorted(found.items()))


def _files(folder: str) -> Iterator[Path]:
    for place in (Path(host.resource("presets")), own_folder()):
        yield from sorted((place / folder).glob("*.json"))


def read_preset(path: Path) -> Preset:
    """A preset from its file.

    Raises
    ------
    ValueError
        Where it is none; says why.
    OSError
    """
    if path.stat().st_size > MAX_BYTES:
        raise ValueError(f"more than {MAX_BYTES} bytes")
    body = json.loads(path.read_text(encoding="utf-8"))
    if not isinstance(body, dict):
        raise ValueError("it is no JSON object")
    name, makes = body.pop("name", None), body.pop("makes", None)
    if not isinstance(name, str) or not name.isprintable() or not 0 < len(name) <= 60:
        raise ValueError("it has no name of 1 to 60 letters")
    if makes not in ("plates", "print"):
        raise ValueError('"makes" says neither plates nor print')
    for key, value in body.items():
        _check(key, value)
    return Preset(name, makes, body)


def _check(key: str, value: Any) -> None:
    if key in LENGTHS or key == "cut_mm_s":
        sound = _is_number(value)
    elif key in SIZES:
        n = 2 if key == "sheet_mm" else 3
        sound = isinstance(value, list) and len(value) == n and all(map(_is_number, value))
    elif key == "relief":
        sound = value in ("none", "dogbone", "tbone")
    elif key == "layers":
        sound = isinstance(value, str) and len(value) < 200
    else:
        known = ", ".join((*LENGTHS, *SIZES, *OTHERS))
        raise ValueError(f"it says {key!r}, which is unknown; known are {known}")
    if not sound:
        raise ValueError(f"its {key} cannot be {value!r}"[:200])


def _is_number(value: Any) -> bool:
    return type(value) in (int, float) and 0 <= value <= MOST


def offer_presets(obj: Any, makes: str) -> None:
    """Fill the drop-downs; what an object has taken stays, though its file may be gone."""
    for kind in KINDS:
        taken = str(getattr(obj, kind) or NONE)
        names = [NONE, *presets_of(kind, makes)]
        names += [taken] if taken not in names else []
        if list(obj.getEnumerationsOfProperty(kind) or ()) != names:
            setattr(obj, kind, names)
            setattr(obj, kind, taken)


def take_preset(obj: Any, kind: str, makes: str) -> None:
    """Give an object the values of the preset that its drop-down names."""
    preset = presets_of(kind, makes).get(str(getattr(obj, kind)))
    for key, value in preset.values.items() if preset else ():
        for name, part in _values(key, value):
            if name in obj.PropertiesList:
                setattr(obj, name, part)


def _values(key: str, value: Any) -> list[tuple[str, Any]]:
    """Properties and their values."""
    if key == "sheet_mm":
        return list(zip(SIZES[key], map(float, value), strict=True))
    if key == "bed_mm":
        import FreeCAD

        return [("Bed", FreeCAD.Vector(*map(float, value)))]
    if key in LENGTHS:
        return [(LENGTHS[key], float(value))]
    return [(OTHERS[key], float(value) if key == "cut_mm_s" else value)]
