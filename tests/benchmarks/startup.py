"""What this addon adds to FreeCAD's start: the same FreeCAD with and without it, in turns.

    .venv/bin/python tests/benchmarks/startup.py [RUNS]

Prints processor time, which others on the machine disturb least, and the least of all runs.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

from incontext.workbench.launch import ROOT

#: Leaves as soon as everything is there, in the console and in the window; well if the addon is
#: there, or not, as it should be.
SCRIPT = "import os, sys\nos._exit(0 if ('incontext' in sys.modules) == {} else 3)\n"
SCREEN = ["xvfb-run", "--auto-servernum", "--server-args=-screen 0 1600x900x24 -dpi 96"]
COMMANDS = {"console": ["freecadcmd"], "window": [*SCREEN, "freecad"]}


def seconds(command: list[str], home: Path) -> float:
    """The processor's time for one start."""
    script = home / "leave.py"
    script.write_text(SCRIPT.format((home / "Mod" / "InContext").is_symlink()))
    environment = {**os.environ, "FREECAD_USER_HOME": str(home), "XDG_CONFIG_HOME": str(home)}
    environment["QTWEBENGINE_DISABLE_SANDBOX"] = "1"
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(
        [*command, str(script)],
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        check=True,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def homes(folder: Path) -> dict[str, Path]:
    """Two user folders of FreeCAD, one of them with this addon."""
    found = {name: folder / name for name in ("without", "with")}
    for home in found.values():
        (home / "Mod").mkdir(parents=True)
    (found["with"] / "Mod" / "InContext").symlink_to(ROOT, target_is_directory=True)
    return found


def main(runs: int) -> None:
    """Print one line for the console and one for the window."""
    for kind, command in COMMANDS.items():
        with tempfile.TemporaryDirectory(prefix="incontext-start-") as folder:
            places = homes(Path(folder))
            # The first start writes settings.
            for home in places.values():
                seconds(command, home)
            least = dict.fromkeys(places, float("inf"))
            for _ in range(runs):
                for name, home in places.items():
                    least[name] = min(least[name], seconds(command, home))
        added, plain = least["with"] - least["without"], least["without"]
        print(
            f"{kind}: {plain:.2f} s without, {least['with']:.2f} s with: "
            f"{1000 * added:+.0f} ms, {100 * added / plain:+.1f} %"
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 5)
