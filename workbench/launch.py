"""Starts FreeCAD with this addon, apart from the person's own FreeCAD, and waits for its answer.

Terms
-----
home
    FreeCAD's user folder for one launch: its settings and a link to this addon. The person's own
    settings are neither read nor written.
call
    ``module:function`` to run inside; it takes a list of strings and returns an exit status, or
    None to leave FreeCAD's window open.

FreeCAD's own chatter goes to a log file in the home; what the call prints goes to the terminal.
FreeCAD returns 0 after an exception in a script, so the true status comes back in a file.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
_WINDOW_NAMES = ("freecad", "FreeCAD")
_CONSOLE_NAMES = ("freecadcmd", "FreeCADCmd", "freecadcmd-python3")
_SCREEN = ["xvfb-run", "--auto-servernum", "--server-args=-screen 0 1600x900x24 -dpi 96"]


class LaunchError(RuntimeError):
    """FreeCAD could not be started, or ended without an answer."""


@dataclass(frozen=True, slots=True)
class Launch:
    """One run of FreeCAD.

    Parameters
    ----------
    call : str
        ``module:function``.
    home : Path
    arguments : sequence of str
    window : bool
        With FreeCAD's window rather than in the console.
    own_screen : bool
        On an X server of its own that nobody sees.
    addons : sequence of Path
        More addons to put beside this one.
    environment : mapping
        Added to the environment.
    """

    call: str
    home: Path
    arguments: Sequence[str] = ()
    window: bool = False
    own_screen: bool = False
    addons: Sequence[Path] = ()
    environment: Mapping[str, str] = field(default_factory=dict)


def run(launch: Launch) -> int:
    """Run FreeCAD once and wait for it.

    Returns
    -------
    int
        What the call returned; 0 where it left the window open and the person closed it.

    Raises
    ------
    LaunchError
        Where FreeCAD is missing or never came to the call; says where the log is.
    """
    command = _command(launch)
    _prepare_home(launch)
    result, log = launch.home / "result", launch.home / "freecad.log"
    result.unlink(missing_ok=True)
    terminal = os.dup(sys.stdout.fileno())
    sys.stdout.flush()
    try:
        with log.open("wb") as chatter:
            ended = subprocess.run(
                command,
                env=_environment(launch, result, terminal),
                stdin=subprocess.DEVNULL,
                stdout=chatter,
                stderr=subprocess.STDOUT,
                pass_fds=(terminal,),
                check=False,
            )
    finally:
        os.close(terminal)
    if not result.exists():
        tail = "".join(f"  {line}\n" for line in log.read_text(errors="replace").splitlines()[-15:])
        raise LaunchError(f"FreeCAD ended without an answer; its last words ({log}):\n{tail}")
    # A window that was left open may have crashed afterwards.
    return int(result.read_text()) or int(ended.returncode != 0)


def find_program(*, window: bool) -> str:
    """FreeCAD's program; `FREECAD` or `FREECADCMD` in the environment name another one."""
    chosen = os.environ.get("FREECAD" if window else "FREECADCMD")
    for name in (chosen,) if chosen else (_WINDOW_NAMES if window else _CONSOLE_NAMES):
        path = shutil.which(name)
        if path:
            return path
    raise LaunchError("FreeCAD is not installed; try: make setup")


def _command(launch: Launch) -> list[str]:
    program = find_program(window=launch.window)
    script = str(ROOT / "workbench" / "inside.py")
    return [*(_SCREEN if launch.own_screen else ()), program, script]


def _prepare_home(launch: Launch) -> None:
    mod = launch.home / "Mod"
    mod.mkdir(parents=True, exist_ok=True)
    for folder in (ROOT, *launch.addons):
        link = mod / ("InContext" if folder == ROOT else folder.name)
        if link.is_symlink():
            link.unlink()
        link.symlink_to(folder, target_is_directory=True)
    settings = launch.home / "user.cfg"
    if not settings.exists():
        shutil.copy(ROOT / "resources" / "presets" / "freecad-user.cfg", settings)


def _environment(launch: Launch, result: Path, terminal: int) -> dict[str, str]:
    environment = {**os.environ, **launch.environment}
    # Another Python's modules would come before FreeCAD's.
    for name in ("PYTHONHOME", "PYTHONPATH"):
        environment.pop(name, None)
    environment |= {
        "FREECAD_USER_HOME": str(launch.home),
        # Qt keeps the window's layout there, whatever FreeCAD's own home.
        "XDG_CONFIG_HOME": str(launch.home / "config"),
        "INCONTEXT_ARGUMENTS": json.dumps(list(launch.arguments)),
        "INCONTEXT_CALL": launch.call,
        # Already set where FreeCAD itself starts another FreeCAD.
        "INCONTEXT_PACKAGES": os.environ.get("INCONTEXT_PACKAGES") or sysconfig.get_path("purelib"),
        "INCONTEXT_RESULT": str(result),
        "INCONTEXT_TERMINAL": str(terminal),
    }
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        # FreeCAD's start page is a browser, which refuses to run as root otherwise.
        environment["QTWEBENGINE_DISABLE_SANDBOX"] = "1"
    return environment


def main() -> int:
    """Open the example: in FreeCAD's window where there is a display, else into files."""
    window = bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
    build = ROOT / "build"
    launch = Launch(
        call=f"incontext.workbench.demo:{'show' if window else 'write'}",
        home=build / "freecad-home",
        arguments=[str(build / "bookshelf")],
        window=window,
    )
    if window:
        print("Opening FreeCAD with the bookshelf example.", flush=True)
    try:
        return run(launch)
    except LaunchError as error:
        print(error, file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
