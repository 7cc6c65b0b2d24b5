"""Fit, standing and weak spots of an object together: numbers, and a person's words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...solver.camera import Camera
from ...solver.model import Model
from .fit import Fit, fit_of
from .meshes import Mesh
from .parts_in_space import Part, plate_parts, print_part, ways_of
from .plates import Joined
from .standing import Standing, standing_of
from .things import Thing
from .weak_spots import loose_plates, thin_plates, thin_walls


@dataclass(frozen=True, slots=True, eq=False)
class Check:
    """What was found out about an object.

    Parameters
    ----------
    fits : tuple of Fit
        One for each existing thing.
    standing : Standing
    weak : tuple of str
        Loose and thin parts, one line each.
    """

    fits: tuple[Fit, ...]
    standing: Standing
    weak: tuple[str, ...]

    @property
    def good(self) -> bool:
        """Whether all things fit and the object stands."""
        return all(fit.fits for fit in self.fits) and self.standing.stands

    @property
    def problems(self) -> tuple[str, ...]:
        """What does not fit, or that it does not stand."""
        said = [fit.words for fit in self.fits if not fit.fits]
        return (*said, *(() if self.standing.stands else (self.standing.words,)))

    @property
    def lines(self) -> tuple[str, ...]:
        """All of it, one line each."""
        nothing = "nothing to fit to: trace what is there, and make it construction"
        fits = [fit.words for fit in self.fits] or [nothing]
        return (*fits, self.standing.words, *self.weak)


def check_plates(
    joined: Joined, model: Model, things: Sequence[Thing], camera: Camera | None
) -> Check:
    """Check plates, put together.

    Parameters
    ----------
    joined : Joined
    model : Model
        Of which the plates are.
    things : sequence of Thing
    camera : Camera or None
        For the names of directions.
    """
    weak = (*loose_plates(joined), *thin_plates(joined.plates))
    return _check(plate_parts(joined.plates), model, things, camera, weak)


def check_print(
    mesh: Mesh, model: Model, things: Sequence[Thing], camera: Camera | None, line_mm: float
) -> Check:
    """Check a print, as `check_plates` does; `line_mm` is the width of the printer's line."""
    part = print_part(mesh)
    return _check((part,), model, things, camera, thin_walls(part, line_mm))


def _check(
    parts: Sequence[Part],
    model: Model,
    things: Sequence[Thing],
    camera: Camera | None,
    weak: tuple[str, ...],
) -> Check:
    ways = ways_of(model, camera)
    return Check(fit_of(parts, things, ways), standing_of(parts, ways), weak)
