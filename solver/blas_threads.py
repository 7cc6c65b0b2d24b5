"""One thread for linear algebra while a sketch is solved.

OpenBLAS shares even an inverse of 13 x 13 among its threads, which then wait for one another: on a
busy machine with two cores a solve took 2 to 6 times as long (`resources/docs/measured.md`). Its
matrices are small: one thread is best. Other linear algebra than OpenBLAS is left as it is.
"""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from threading import Lock
from types import TracebackType

import numpy as np
import scipy

#: Names that builds of OpenBLAS give to their functions.
_NAMES = tuple(
    f"{before}openblas_%s_num_threads{after}"
    for before in ("", "scipy_")
    for after in ("", "64_", "_64", "_64_")
)

_Get = Callable[[], int]
_Set = Callable[[int], object]


class OneBlasThread:
    """A context, from as many threads of the program as like; the last one out puts back."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._inside = 0
        self._before: list[tuple[_Set, int]] = []

    def __enter__(self) -> None:
        with self._lock:
            self._inside += 1
            if self._inside == 1:
                self._before = [(put, get()) for get, put in _openblas()]
                for put, count in self._before:
                    if count > 1:
                        put(1)

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        with self._lock:
            self._inside -= 1
            if self._inside == 0:
                for put, count in self._before:
                    if count > 1:
                        put(count)


one_blas_thread = OneBlasThread()


@lru_cache(maxsize=1)
def _openblas() -> list[tuple[_Get, _Set]]:
    """How to ask each loaded OpenBLAS for its number of threads, and how to set it."""
    found = []
    for path in _libraries():
        try:
            library = ctypes.CDLL(path)
        except OSError:
            continue  # not for this program after all
        for name in _NAMES:
            get, put = (getattr(library, name % verb, None) for verb in ("get", "set"))
            if get is not None and put is not None:
                get.restype, put.argtypes, put.restype = ctypes.c_int, [ctypes.c_int], None
                found.append((get, put))
                break
    return found


def _libraries() -> list[str]:
    """Files of OpenBLAS that this program has loaded."""
    maps = Path("/proc/self/maps")
    if maps.exists():
        files = {
            line.split(maxsplit=5)[-1] for line in maps.read_text().splitlines() if "/" in line
        }
        return sorted(file for file in files if "openblas" in Path(file).name)
    # Elsewhere only what comes with numpy and scipy: that surely is loaded.
    homes = [Path(str(package.__file__)).parent for package in (np, scipy)]
    folders = [home / ".dylibs" for home in homes]
    folders += [home.parent / f"{home.name}.libs" for home in homes]
    pattern = "*openblas*.dylib" if sys.platform == "darwin" else "*openblas*.dll"
    return sorted(str(file) for folder in folders for file in folder.glob(pattern))
