"""Problems a person can do something about, told in words; everything else is a bug and is raised.

Used as ``except known_problems() as error: host.report(in_words(error))``: the classes are looked
up only when something went wrong, so that nobody waits for the solver's import before that.
"""

from __future__ import annotations

from . import host
from .wording import in_language


class StoppedError(Exception):
    """A person did not wait for it."""

    def __str__(self) -> str:
        return host.translate("InContext", "stopped; recompute it to begin again")


def known_problems() -> tuple[type[Exception], ...]:
    """The exceptions that are about the sketch, the settings, a missing package, or a stop."""
    try:
        from ..solver.errors import SketchError
        from .fabrication.errors import FabricationError
    except ModuleNotFoundError:
        return (ModuleNotFoundError, StoppedError)
    return (SketchError, FabricationError, ModuleNotFoundError, StoppedError)


def in_words(error: BaseException) -> str:
    """What went wrong and what to try, in one or two sentences."""
    if isinstance(error, ModuleNotFoundError):
        package = (error.name or "?").split(".")[0]
        words = host.translate(
            "InContext",
            "the Python package {0} is missing; install it with FreeCAD's Addon Manager, or with: "
            "{1} -m pip install --target {2} {0}",
        )
        return words.format(package, host.python_command(), host.packages_folder())
    return in_language(str(error))
