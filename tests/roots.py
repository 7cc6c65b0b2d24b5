"""Newer FreeCADs than this system's, each in a folder with a whole newer Debian in it.

python tests/roots.py make                 all roots, as far as they are missing or stale
python tests/roots.py run 1.1 COMMAND...   a command there, in a copy of this checkout

Terms
-----
root
    The folder of one release of Debian with its FreeCAD and our Python packages. Kept in the
    person's cache folder (INCONTEXT_ROOTS names another one) and made again when what it was
    made from has changed.
enter
    Run in a root: by chroot, with /proc, /dev and an empty /tmp mounted for that one run only.
    Where the machine refuses mounts it is done without them.
"""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parent.parent
#: What a root has besides a minimal Debian; a change makes the roots again.
PACKAGES = (
    "freecad",
    "openbox",
    "xdotool",
    "imagemagick",
)
#: What is added to a root that is there already, in seconds: a change makes no root again.
ADDED = (
    # FreeCAD's FEM meshes by it.
    "gmsh",
    # What the window for missing packages runs.
    "python3-pip",
)
#: Python packages that only check the source: not needed in a root.
SOURCE_CHECKERS = ("ruff", "mypy")
#: Where the Python packages lie in a root: apart from Debian's own, and before them.
SITE = "/opt/incontext-packages"
#: The script that debootstrap uses for releases it has never heard of.
DEBOOTSTRAP_SCRIPT = "/usr/share/debootstrap/scripts/sid"
SCREEN = ("-screen", "0", "1600x900x24", "-dpi", "96")
ATTEMPTS = 3
PAUSE_S = 20.0
NEEDED_GB = 6
#: Folders of a checkout that are made from its files.
NOT_COPIED = (".git", ".venv", "build", "__pycache__", ".*_cache", ".hypothesis", "*.egg-info")

MOUNT = """
mount --rbind /dev "$0/dev" && mount -t proc proc "$0/proc" && mount -t tmpfs tmpfs "$0/tmp"
"""
ENTER = 'exec chroot "$0" "$@"'


#: Status where a root cannot be made or entered, as testing tools have it for what they skip.
CANNOT = 77


class RootError(RuntimeError):
    """A root could not be made or entered; says what to try."""


@dataclass(frozen=True, slots=True)
class Root:
    """One FreeCAD and the release of Debian that has it."""

    freecad: str
    suite: str
    more: tuple[str, ...] = ()

    @property
    def folder(self) -> Path:
        """Where the root lies."""
        return roots_folder() / self.suite

    @property
    def site(self) -> Path:
        """Its Python packages, seen from outside."""
        return self.folder / SITE.lstrip("/")


#: Qt 6 reads SVG icons by a package of its own.
ROOTS = (Root("1.0", "trixie"), Root("1.1", "forky", ("qt6-svg-plugins",)))


def roots_folder() -> Path:
    """The cache of all roots."""
    chosen = os.environ.get("INCONTEXT_ROOTS")
    cache = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    return Path(chosen) if chosen else cache / "incontext" / "roots"


def ensure(root: Root) -> None:
    """Make a root as far as it is missing or stale.

    Raises
    ------
    RootError
        Where that cannot be done.
    """
    if os.geteuid() != 0:
        raise RootError("only root can make and enter roots; try: make test-matrix")
    roots_folder().mkdir(parents=True, exist_ok=True)
    with _alone(root):
        if _stamp(root, "system") != _system_recipe(root):
            _make_system(root)
            _set_stamp(root, "system", _system_recipe(root))
        if _stamp(root, "added") != " ".join(ADDED):
            _retried(f"{root.suite}: {' and '.join(ADDED)}", lambda: _install(root, ADDED))
            _set_stamp(root, "added", " ".join(ADDED))
        if _stamp(root, "python") != _python_recipe():
            _install_python(root)
            _set_stamp(root, "python", _python_recipe())


def run(root: Root, command: Sequence[str]) -> int:
    """Run a command in a root, in a copy of this checkout; gives its exit status.

    The checkout is the package `incontext` there.
    """
    with (
        tempfile.TemporaryDirectory(prefix="incontext-", dir=root.folder / "srv") as place,
        _screen() as display,
    ):
        copy = Path(place) / "incontext"
        shutil.copytree(CHECKOUT, copy, symlinks=True, ignore=shutil.ignore_patterns(*NOT_COPIED))
        inside = f"/{copy.relative_to(root.folder)}"
        settings = {
            "DISPLAY": display,
            "HOME": "/root",
            "INCONTEXT_PACKAGES": SITE,
            "INCONTEXT_ROOT": root.freecad,
            "LANG": "C.UTF-8",
            "PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
            "PYTHONDONTWRITEBYTECODE": "1",
            "PYTHONPATH": f"{SITE}:{Path(inside).parent}",
        }
        words = [f"{name}={value}" for name, value in settings.items()]
        script = f'cd "{inside}" && exec "$@"'
        entered = [*_enter(root), "env", "-i", *words, "sh", "-c", script, "sh", *command]
        return subprocess.run(entered, check=False).returncode


@contextlib.contextmanager
def _screen() -> Iterator[str]:
    """An X server of this system for a run in a root: Debian forky's own loses replies."""
    readable, writable = os.pipe()
    command = ["Xvfb", "-displayfd", str(writable), "-ac", *SCREEN]
    quiet = subprocess.DEVNULL
    server = subprocess.Popen(command, pass_fds=(writable,), stdout=quiet, stderr=quiet)
    os.close(writable)
    try:
        with os.fdopen(readable) as told:
            number = told.readline().strip()
        if not number:
            raise RootError("Xvfb did not start; try: make setup")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()


def _system_recipe(root: Root) -> str:
    return " ".join((root.suite, *PACKAGES, *root.more))


def _requirements() -> list[str]:
    """What the addon and its tests need, as pyproject.toml says."""
    project = tomllib.loads((CHECKOUT / "pyproject.toml").read_text())["project"]
    wanted = [*project["dependencies"], *project["optional-dependencies"]["test"]]
    return [name for name in wanted if not name.startswith(SOURCE_CHECKERS)]


def _python_recipe() -> str:
    lock = (CHECKOUT / "resources" / "requirements.lock").read_bytes()
    return f"{hashlib.sha256(lock).hexdigest()} {' '.join(_requirements())}"


def _stamp(root: Root, part: str) -> str:
    path = root.folder / f".incontext-{part}"
    return path.read_text() if path.is_file() else ""


def _set_stamp(root: Root, part: str, recipe: str) -> None:
    (root.folder / f".incontext-{part}").write_text(recipe)


@contextlib.contextmanager
def _alone(root: Root) -> Iterator[None]:
    """One run at a time makes a root; others wait for it."""
    with (roots_folder() / f"{root.suite}.lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            print(f"Waiting for another run that makes the root of {root.suite}.", flush=True)
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _make_system(root: Root) -> None:
    """Debian and FreeCAD, made beside the old root, which goes at the end."""
    free_gb = shutil.disk_usage(roots_folder()).free / 1e9
    if free_gb < NEEDED_GB:
        raise RootError(
            f"{roots_folder()} has {free_gb:.1f} GB left, a root needs {NEEDED_GB}: free some, or "
            "set INCONTEXT_ROOTS to another folder"
        )
    print(f"Making the root of FreeCAD {root.freecad} (Debian {root.suite}); some minutes, once.")
    new = root.folder.with_name(f"{root.suite}.new")
    partial = Root(root.freecad, new.name)
    _retried(f"{root.suite}: a minimal Debian", lambda: _debootstrap(root, new))
    _borrow_settings(new)
    _retried(f"{root.suite}: FreeCAD", lambda: _install(partial, (*PACKAGES, *root.more)))
    _remove(root.folder)
    new.rename(root.folder)


def _install(root: Root, packages: Sequence[str]) -> None:
    """Packages of Debian, in a root that has one."""
    # Signatures are checked; a mirror that is some weeks behind will do.
    options = "-o Acquire::Retries=5 -o Acquire::Check-Valid-Until=false"
    options += " -o APT::Sandbox::User=root -o Dpkg::Use-Pty=0 -qq"
    install = f"install --yes --no-install-recommends {' '.join(packages)}"
    script = f"apt-get {options} update && apt-get {options} {install} && apt-get clean"
    quiet = ["env", "DEBIAN_FRONTEND=noninteractive"]
    _logged(root.folder, [*_enter(root), *quiet, "sh", "-c", script])


def _debootstrap(root: Root, folder: Path) -> None:
    _remove(folder)
    command = ["debootstrap", "--variant=minbase", "--include=ca-certificates", root.suite]
    command += [str(folder), _mirror(), DEBOOTSTRAP_SCRIPT]
    # In a mount namespace of its own: what it leaves mounted is gone with it.
    _logged(folder, [*(("unshare", "--mount") if _may_mount() else ()), *command])


def _mirror() -> str:
    """Where this system's own packages come from; INCONTEXT_MIRROR names another mirror."""
    chosen = os.environ.get("INCONTEXT_MIRROR")
    if chosen:
        return chosen
    command = ["apt-get", "indextargets", "--format", "$(ORIGIN)|$(LABEL)|$(SITE)"]
    listed = subprocess.run(command, capture_output=True, text=True, check=False).stdout
    for line in listed.splitlines():
        origin, label, site = line.split("|", 2)
        if (origin, label) == ("Debian", "Debian"):
            return site
    raise RootError(
        "this system's apt names no mirror of Debian; run `apt-get update`, or set "
        "INCONTEXT_MIRROR to the address of one"
    )


def _borrow_settings(folder: Path) -> None:
    """What this machine needs to reach the network: certificates, names, proxies of apt."""
    for name in ("etc/ssl/certs/ca-certificates.crt", "etc/resolv.conf", "etc/hosts"):
        if Path("/", name).is_file():
            (folder / name).unlink(missing_ok=True)
            shutil.copyfile(Path("/", name), folder / name)
    said = subprocess.run(
        ["apt-config", "dump", "Acquire"], capture_output=True, text=True, check=False
    ).stdout
    proxies = [line for line in said.splitlines() if "::Proxy" in line or "::CaInfo" in line]
    (folder / "etc/apt/apt.conf.d/90host").write_text("".join(f"{line}\n" for line in proxies))
    # Nothing that is installed may start a service.
    policy = folder / "usr/sbin/policy-rc.d"
    policy.write_text("#!/bin/sh\nexit 101\n")
    policy.chmod(0o755)


def _install_python(root: Root) -> None:
    """Our Python packages, fetched by this environment's pip, which has this machine's settings."""
    print(f"Fetching the Python packages for FreeCAD {root.freecad}: about 2 GB.", flush=True)
    version = (root.folder / "usr/bin/python3").resolve().name.removeprefix("python")
    _remove(root.site)
    command = [sys.executable, "-m", "pip", "install", "--quiet", "--no-input"]
    command += ["--disable-pip-version-check", "--target", str(root.site)]
    command += ["--only-binary=:all:", "--implementation", "cp", "--python-version", version]
    for platform in _platforms():
        command += ["--platform", platform]
    command += ["--constraint", str(CHECKOUT / "resources" / "requirements.lock")]
    command += _requirements()
    _retried(f"{root.suite}: Python packages", lambda: _logged(root.folder, command))


def _platforms() -> list[str]:
    """The names that wheels for Linux go by: for each version of glibc there is one."""
    machine = os.uname().machine
    return [f"manylinux_2_{minor}_{machine}" for minor in range(17, 41)] + [
        f"manylinux2014_{machine}"
    ]


def _enter(root: Root) -> list[str]:
    """What stands before a command that runs in a root."""
    folder = str(root.folder)
    if _may_mount():
        return ["unshare", "--mount", "sh", "-c", f"{MOUNT.strip()} && {ENTER}", folder]
    _stand_in_for_proc(root.folder)
    return ["sh", "-c", ENTER, folder]


def _may_mount() -> bool:
    probe = ["unshare", "--mount", "mount", "-t", "tmpfs", "tmpfs", "/mnt"]
    return subprocess.run(probe, capture_output=True, check=False).returncode == 0


def _stand_in_for_proc(folder: Path) -> None:
    """FreeCAD finds its own folder through /proc; without a mount one link does for that."""
    print(f"This machine refuses mounts: {folder} is used without /proc.", flush=True)
    link = folder / "proc" / "self" / "exe"
    if not (folder / "proc" / "version").exists() and not link.is_symlink():
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to("/usr/lib/freecad/bin/FreeCAD")


def _logged(folder: Path, command: Sequence[str]) -> None:
    """Run a command silently; where it fails, show the end of what it said."""
    log = folder.with_name(f"{folder.name}.log")
    with log.open("wb") as file:
        ended = subprocess.run(
            command, stdin=subprocess.DEVNULL, stdout=file, stderr=subprocess.STDOUT, check=False
        )
    if ended.returncode != 0:
        tail = "\n".join(log.read_text(errors="replace").splitlines()[-12:])
        raise RootError(f"{command[0]} failed with status {ended.returncode} ({log}):\n{tail}")


def _retried(what: str, job) -> None:
    """Do something that needs the network; mirrors are slow or away at times."""
    for attempt in range(1, ATTEMPTS + 1):
        began = time.monotonic()
        try:
            job()
        except RootError as error:
            if attempt == ATTEMPTS:
                raise RootError(
                    f"{what} could not be made in {ATTEMPTS} attempts. {error}"
                ) from None
            print(f"{what}: attempt {attempt} failed, once more in {PAUSE_S:.0f} s. {error}")
            time.sleep(PAUSE_S)
        else:
            print(f"  {what}: {time.monotonic() - began:.0f} s", flush=True)
            return


def _remove(folder: Path) -> None:
    if folder.exists():
        # Never into a mounted folder, should one be left over.
        subprocess.run(["rm", "-rf", "--one-file-system", str(folder)], check=True)


def main(arguments: list[str]) -> int:
    """Make the roots, or run something in one of them."""
    try:
        if arguments == ["make"]:
            for root in ROOTS:
                ensure(root)
            return 0
        if len(arguments) > 2 and arguments[0] == "run":
            root = next(r for r in ROOTS if r.freecad == arguments[1])
            ensure(root)
            return run(root, arguments[2:])
    except (RootError, OSError, subprocess.CalledProcessError) as error:
        print(error)
        return CANNOT
    print(__doc__)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
