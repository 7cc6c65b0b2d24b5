"""The shipped examples: what each is called, what is made of it and how, what must come out.

Terms
-----
example
    A folder of ``resources/examples``: photo, sketch, ``example.json`` (this), and ``truth.json``,
    which no program but tests and the benchmark may look at.
in front
    Outlines of what stands before the new object in the photo, for pictures of it in its place.
facts
    What comes out, as numbers with one relative tolerance.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import host

if TYPE_CHECKING:
    from .fabrication.settings import PlateSettings, ShellSettings

#: In the order of the menu and the gallery.
EXAMPLES = (
    "bookshelf",
    "organizer",
    "desk_tidy",
    "teapot_lid",
    "cup_saucer",
    "scissors_cover",
    "chair_box",
)
SKETCH_ENDING = ".sketch.json"
#: How the command line calls the settings that examples choose.
_OPTIONS = {
    "thickness_mm": "--thickness",
    "finger_mm": "--finger",
    "wall_mm": "--wall",
    "side": "--side",
    "open_end": "--open",
}


@dataclass(frozen=True, slots=True)
class Example:
    """One example.

    Parameters
    ----------
    name : str
        Of its folder and files.
    title : str
    about : str
        One paragraph for people.
    is_printed : bool
        One hollow solid for a 3D printer; else plates for a laser cutter.
    material : str
    settings : mapping
        Fields of `PlateSettings` or `ShellSettings` that are not as usual.
    light_in_cam : (x, y, z)
        Where the photo's light comes from: right, down and forward, as seen from the camera.
    in_front : tuple of outlines
        Each a list of places in the photo, px.
    facts : mapping
        ``tolerance`` (relative), ``size_mm``, and ``plates``, ``joints``, ``cut_length_mm`` or
        ``volume_mm3``.
    """

    name: str
    title: str
    about: str
    is_printed: bool
    material: str
    settings: Mapping[str, Any]
    light_in_cam: tuple[float, float, float]
    in_front: tuple[tuple[tuple[float, float], ...], ...]
    facts: Mapping[str, Any]

    @property
    def sketch_path(self) -> Path:
        """The sketch file."""
        return example_path(self.name)

    @property
    def truth(self) -> dict[str, Any]:
        """What the photo really shows: for checking only."""
        found: dict[str, Any] = _read(self.sketch_path.with_name("truth.json"))
        return found

    @property
    def options(self) -> list[str]:
        """The words after ``incontext make SKETCH`` that make it."""
        words = ["--print" if self.is_printed else "--laser"]
        for field, value in self.settings.items():
            words += [_OPTIONS[field], str(value)]
        return words

    def plate_settings(self) -> PlateSettings:
        """For plates (`SettingsError` where they cannot be)."""
        from .fabrication.settings import PlateSettings

        return PlateSettings(**self.settings)

    def shell_settings(self) -> ShellSettings:
        """For a print (`SettingsError` where they cannot be)."""
        from .fabrication.settings import ShellSettings

        return ShellSettings(**self.settings)


def example_path(name: str) -> Path:
    """The sketch file of an example."""
    return Path(host.resource("examples", name, name + SKETCH_ENDING))


def load_example(name: str) -> Example:
    """An example by its name."""
    told = _read(example_path(name).with_name("example.json"))
    outlines = tuple(
        tuple((float(u), float(v)) for u, v in ring) for ring in told.pop("in_front", ())
    )
    x, y, z = told.pop("light_in_cam")
    return Example(name=name, light_in_cam=(x, y, z), in_front=outlines, **told)


def _read(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8"))
