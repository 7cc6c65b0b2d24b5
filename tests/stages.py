"""Runs every check in stages, names each, and fails if one fails or finds nothing to run.

python tests/stages.py            the stages of `make test`
python tests/stages.py lint types some of all stages
python tests/stages.py all        all, with other versions of FreeCAD, Python, numpy and scipy
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from incontext.workbench.launch import Launch, LaunchError, run

ROOT = Path(__file__).resolve().parent.parent
#: Another addon with folders named like ours, always there when we run inside FreeCAD.
DECOY = ROOT / "tests" / "freecad" / "decoy_addon"
#: The status of roots.py where a root cannot be had, and the variable that lets this pass: some
#: machines allow no root in them. It is said aloud all the same.
CANNOT = 77
MAY_MISS = "INCONTEXT_ROOTS_MAY_MISS"
#: pytest's status for "no tests were collected" is 5, so an empty stage fails as well.
PYTEST = ["-p", "no:cacheprovider", "--quiet"]
#: FreeCAD's own import hooks are older than Python's present way.
FREECADS_OWN = ["-W", "ignore::ImportWarning"]
INSIDE = ["tests/freecad", "tests/canvas"]
#: The oldest numpy and scipy that the solver is for are those of this system's own Python.
SYSTEM_PYTHON = "/usr/bin/python3"
TEST_TOOLS = ("pytest", "hypothesis")


def lint() -> int:
    """Style and layout of the source."""
    return _python("ruff", "check", ".") or _python("ruff", "format", "--check", ".")


def types() -> int:
    """Types of the solver and of fabrication."""
    # mypy does not see through an editable install's import hook: show it a folder by our name.
    return _python("mypy", environment={"MYPYPATH": str(_by_our_name())})


def python() -> int:
    """Tests in plain Python."""
    return _python("pytest", "--quiet")


def console() -> int:
    """Tests inside FreeCAD's console."""
    return _inside(window=False)


def window() -> int:
    """Tests inside FreeCAD's window, on a screen of its own."""
    return _inside(window=True)


def solver() -> int:
    """Tests of the solver, with whatever Python this is."""
    return _python("pytest", *PYTEST, *_solver_tests())


def oldest() -> int:
    """Tests of the solver with this system's own numpy and scipy."""
    tools = ROOT / "build" / "test-tools"
    if not (tools / "pytest").is_dir():
        packages = ("--target", str(tools), *TEST_TOOLS)
        if _python("pip", "install", "-qq", "--disable-pip-version-check", *packages):
            return 1
    environment = {**os.environ, "PYTHONPATH": f"{_by_our_name()}:{tools}"}
    command = [SYSTEM_PYTHON, "-m", "pytest", *PYTEST, *_solver_tests()]
    return subprocess.run(command, cwd=ROOT, env=environment, check=False).returncode


def freecad_1_0() -> int:
    """Tests inside FreeCAD 1.0, and those of the solver with the Python it has."""
    return _in_root("1.0")


def freecad_1_1() -> int:
    """Tests inside FreeCAD 1.1, and those of the solver with the Python it has."""
    return _in_root("1.1")


#: The stages of `make test`.
USUAL: tuple[Callable[[], int], ...] = (lint, types, python, console, window)
#: They run at the same time, each on a core of its own.
IN_ROOTS: tuple[Callable[[], int], ...] = (freecad_1_0, freecad_1_1)
STAGES: dict[str, Callable[[], int]] = {
    stage.__name__: stage for stage in (*USUAL, solver, oldest, *IN_ROOTS)
}


def _python(module: str, *arguments: str, environment: Mapping[str, str] | None = None) -> int:
    command = [sys.executable, "-m", module, *arguments]
    return subprocess.run(
        command, cwd=ROOT, env={**os.environ, **(environment or {})}, check=False
    ).returncode


def _by_our_name() -> Path:
    """A folder in which this checkout is called `incontext`."""
    path = ROOT / "build" / "types"
    path.mkdir(parents=True, exist_ok=True)
    (path / "incontext").unlink(missing_ok=True)
    (path / "incontext").symlink_to(ROOT, target_is_directory=True)
    return path


def _solver_tests() -> list[str]:
    """The test files that concern the solver alone."""
    others = ("workbench", "trimesh", "slvs", "from test_cli")
    files = sorted((ROOT / "tests").glob("test_*.py"))
    texts = {file: file.read_text(encoding="utf-8") for file in files}
    return [str(file) for file, text in texts.items() if not any(o in text for o in others)]


def _in_root(version: str) -> int:
    """The tests in another FreeCAD; that it cannot be had is a failure, told in words."""
    command = [sys.executable, "tests/roots.py", "run", version, "python3", "tests/stages.py"]
    as_root = [] if os.geteuid() == 0 else ["sudo", "--preserve-env"]
    if as_root and shutil.which("sudo") is None:
        print("only root can make and enter roots, and there is no sudo")
        return CANNOT
    # The window's tests are those of the console and more.
    stages = ("solver", "window")
    there = subprocess.Popen(
        [*as_root, *command, *stages],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    for line in there.stdout:
        print(f"[{version}] {line}", end="", flush=True)
    return there.wait()


def _inside(*, window: bool) -> int:
    folders = [str(ROOT / folder) for folder in INSIDE]
    with tempfile.TemporaryDirectory(prefix="incontext-freecad-") as home:
        launch = Launch(
            call="pytest:main",
            home=Path(home),
            arguments=[*PYTEST, *FREECADS_OWN, "--rootdir", str(ROOT), *folders],
            window=window,
            # In a root there is a screen already.
            own_screen=window and "INCONTEXT_ROOT" not in os.environ,
            addons=(DECOY,),
        )
        try:
            return run(launch)
        except LaunchError as error:
            print(error)
            return 1


def _run(name: str) -> int:
    print(f"== {name}: {STAGES[name].__doc__}", flush=True)
    return STAGES[name]()


def main(names: list[str]) -> int:
    """Run the named stages, or all, each whatever became of the others."""
    names = list(STAGES) if names == ["all"] else names or [stage.__name__ for stage in USUAL]
    unknown = [name for name in names if name not in STAGES]
    if unknown:
        print(f"no such stage: {', '.join(unknown)}; there are: {', '.join(STAGES)}")
        return 2
    in_roots = [name for name in names if STAGES[name] in IN_ROOTS]
    statuses = {name: _run(name) for name in names if name not in in_roots}
    with ThreadPoolExecutor(len(IN_ROOTS)) as pool:
        statuses |= dict(zip(in_roots, pool.map(_run, in_roots), strict=True))
    missed = [n for n, s in statuses.items() if s == CANNOT and os.environ.get(MAY_MISS)]
    failed = [n for n, s in statuses.items() if s != 0 and n not in missed]
    if missed:
        print(f"== NOT TESTED, for this machine cannot make their roots: {', '.join(missed)}")
    passed = "== all other stages passed" if missed else "== all stages passed"
    print(f"== failed: {', '.join(failed)}" if failed else passed)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
