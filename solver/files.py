"""Writing files so that nothing half-written ever stands under a final name."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from .errors import SketchFileError


def write_files(contents: Mapping[Path, bytes]) -> None:
    """Write several files, all or none.

    Each is written beside its final place; only when all of them are whole are they renamed.

    Parameters
    ----------
    contents : mapping of path to bytes
        Folders are made where they are missing.

    Raises
    ------
    SketchFileError
        Where a folder or file cannot be written; no final file was touched.
    """
    staged: list[tuple[str, Path]] = []
    path = Path()
    try:
        for path, data in contents.items():
            path.parent.mkdir(parents=True, exist_ok=True)
            if path.is_dir():
                raise IsADirectoryError(21, "is a folder")
            handle, name = tempfile.mkstemp(prefix=".", suffix=path.suffix, dir=path.parent)
            staged.append((name, path))
            with os.fdopen(handle, "wb") as file:
                file.write(data)
            os.chmod(name, 0o666 & ~_umask())
        for name, path in staged:
            os.replace(name, path)
    except OSError as error:
        for name, _ in staged:
            with suppress(OSError):
                os.unlink(name)
        reason = error.strerror or str(error)
        raise SketchFileError(
            f"cannot write {path}: {reason}", (), "another folder, or check its permissions"
        ) from error


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
