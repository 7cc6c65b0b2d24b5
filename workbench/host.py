"""The one seam to FreeCAD: messages, translation, preferences, paths, transactions.

Everything here also works without FreeCAD, so that whatever uses it can be tested in plain
Python: messages then go to standard error, preferences live in a dictionary.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar

try:
    import FreeCAD
except ImportError:
    FreeCAD = None

T = TypeVar("T")
#: Asked now and then by what takes long; told how far it is (0 to 1), and what is being done.
Stop = Callable[[], bool]
Progress = Callable[[float, str], None]
Work = Callable[[Stop, Progress], T]

#: The addon's own folder.
ROOT = Path(__file__).resolve().parent.parent

_PREFERENCES = "User parameter:BaseApp/Preferences/Mod/InContext"


#: Under what our translations are filed. One for all: a word of ours means one thing.
CONTEXT = "InContext"


def translate(_: str, text: str) -> str:
    """The text in the person's language, or as it stands where there is no translation.

    Parameters
    ----------
    _ : str
        Where the text is from, as FreeCAD's tools read it; our own are all filed together.
    text : str
    """
    if FreeCAD is None or not hasattr(FreeCAD, "Qt"):
        return text
    return str(FreeCAD.Qt.translate(CONTEXT, text))


def load_translations() -> None:
    """Make our languages known to FreeCAD's window."""
    import FreeCADGui

    FreeCADGui.addLanguagePath(resource("translations"))
    FreeCADGui.updateLocale()


def resource(*parts: str) -> str:
    """Path of a file under `resources/`."""
    return str(ROOT.joinpath("resources", *parts))


def icon(name: str) -> str:
    """Path of an icon, named without its ending."""
    return resource("icons", f"{name}.svg")


def python_command() -> str:
    """The Python to name in a command for people; inside FreeCAD `sys.executable` is FreeCAD."""
    return f"python{sys.version_info.major}.{sys.version_info.minor}"


def user_folder() -> str:
    """Where a person's own files for FreeCAD lie; the current folder outside FreeCAD."""
    return "." if FreeCAD is None else str(FreeCAD.getUserAppDataDir())


def packages_folder() -> str:
    """Where FreeCAD looks for packages that a person installs."""
    if FreeCAD is None:
        return "."
    folder = Path(FreeCAD.getUserAppDataDir()) / "AdditionalPythonPackages"
    # From 0.21 on there is one folder for each Python version.
    py = folder / f"py{sys.version_info.major}{sys.version_info.minor}"
    new = tuple(int(part) for part in FreeCAD.Version()[:2]) >= (0, 21)
    return str(py if new else folder)


@contextmanager
def own_packages_first() -> Iterator[None]:
    """Import from the folder of installed packages first meanwhile.

    FreeCAD searches it last; cadquery needs a newer pyparsing than Debian 12's Python has.
    """
    folder = packages_folder()
    if folder not in sys.path:
        yield
        return
    place = sys.path.index(folder)
    sys.path.insert(0, sys.path.pop(place))
    try:
        yield
    finally:
        sys.path.remove(folder)
        sys.path.insert(place, folder)


def note(text: str) -> None:
    """Say something in the report view that needs no action."""
    _print("PrintMessage", text)


def warn(text: str) -> None:
    """Say in the report view that something may not be as meant."""
    _print("PrintWarning", text)


def report(problem: object) -> None:
    """Say in the report view what went wrong: an exception or a sentence.

    Only the words are shown, no traceback: what is reported here is for people.
    """
    _print("PrintError", str(problem) or type(problem).__name__)


def _print(method: str, text: str) -> None:
    # The one-argument form is the only one that FreeCAD 0.20 and 1.x share.
    line = f"{translate('InContext', 'Modeling in Context')}: {text}\n"
    if FreeCAD is None:
        sys.stderr.write(line)
    else:
        getattr(FreeCAD.Console, method)(line)


def work(words: str, job: Work[T]) -> T | None:
    """Do what takes long: before a person's eyes where there is a window that knows how.

    Parameters
    ----------
    words : str
        What is going on.
    job : callable
        Takes whether to stop, and whom to tell how far it is.

    Returns
    -------
    What the job gave; None where a person stopped it.
    """
    if _workers:
        return _workers[-1](words, job)
    return job(lambda: False, lambda done, what: None)


#: Who does work before a person's eyes; the panels enter theirs.
_workers: list[Callable[[str, Any], Any]] = []


def set_worker(worker: Callable[[str, Any], Any]) -> None:
    """From now on work is done by this."""
    _workers[:] = [worker]


def has_window() -> bool:
    """True where FreeCAD runs with its window, false in the console and outside FreeCAD."""
    return FreeCAD is not None and bool(FreeCAD.GuiUp)


class _Memory:
    """Stands in for FreeCAD's parameter group outside it: the same calls on a dictionary."""

    def __init__(self) -> None:
        self._values: dict[str, Any] = {}

    def _get(self, name: str, default: Any) -> Any:
        return self._values.get(name, default)

    def _set(self, name: str, value: Any) -> None:
        self._values[name] = value

    GetString = GetFloat = GetInt = GetBool = _get
    SetString = SetFloat = SetInt = SetBool = _set


_MEMORY = _Memory()


def preferences() -> Any:
    """The addon's preferences: an object with FreeCAD's `GetFloat`, `SetFloat` and so on."""
    return _MEMORY if FreeCAD is None else FreeCAD.ParamGet(_PREFERENCES)


@contextmanager
def transaction(document: Any, name: str) -> Iterator[None]:
    """One undoable step of a document: kept when all went well, taken back when not."""
    document.openTransaction(name)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
