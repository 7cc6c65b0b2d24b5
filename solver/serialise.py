"""The sketch file and the solution file: text to frozen values and back.

Every error names what is wrong, where, and what to try. Unknown keys and newer versions are errors,
so that nothing a newer program wrote is silently lost.
"""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

from .errors import SketchError, SketchFileError, SketchFormatError
from .files import write_files
from .graph import SketchGraph
from .reading.parsing import graph_from_json
from .reading.solution_parsing import solution_from_json
from .solution import Solution

#: A sketch larger than this is not opened.
MAX_BYTES = 50_000_000
SKETCH_SUFFIX = ".sketch.json"


def load_sketch(path: str | Path) -> SketchGraph:
    """Read a sketch file.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    SketchGraph

    Raises
    ------
    SketchError
        For every way in which the file cannot be used.
    """
    return sketch_from_text(_read(Path(path)))


def sketch_from_text(text: str) -> SketchGraph:
    """The graph that a sketch file's text says; raises SketchError."""
    if len(text) > MAX_BYTES:
        # A document may hold any text.
        raise SketchFormatError(
            f"the sketch is larger than {MAX_BYTES // 1_000_000} MB", (), "a smaller sketch"
        )
    return graph_from_json(_parse(text))


def sketch_to_text(graph: SketchGraph) -> str:
    """The text of a sketch file."""
    return _dump(graph.to_json())


def save_sketch(graph: SketchGraph, path: str | Path) -> None:
    """Write a sketch file, whole or not at all; raises SketchFileError."""
    write_files({Path(path): sketch_to_text(graph).encode()})


def load_solution(path: str | Path) -> Solution:
    """Read a solution file; raises SketchError."""
    return solution_from_text(_read(Path(path)))


def solution_from_text(text: str) -> Solution:
    """The solution that a solution file's text says; raises SketchError."""
    return solution_from_json(_parse(text))


def solution_to_text(solution: Solution) -> str:
    """The text of a solution file."""
    return _dump(solution.to_json())


def save_solution(solution: Solution, path: str | Path) -> None:
    """Write a solution file, whole or not at all; raises SketchFileError."""
    write_files({Path(path): solution_to_text(solution).encode()})


def _read(path: Path) -> str:
    if path.is_dir():
        raise SketchFileError(
            f"{path} is a folder, not a file", (), f"a file in it, *{SKETCH_SUFFIX}"
        )
    try:
        with path.open("rb") as file:
            data = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise SketchFileError(f"cannot read {path}: {reason}", (), "check the name") from error
    if len(data) > MAX_BYTES:
        raise SketchFileError(
            f"{path} is larger than {MAX_BYTES // 1_000_000} MB", (), "a sketch file"
        )
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise SketchFormatError(
            f"{path} is not UTF-8 text (byte {error.start})", (), "a sketch file, saved as UTF-8"
        ) from error


def _parse(text: str) -> Any:
    if not text.strip():
        raise SketchFormatError("the file is empty", (), "save the sketch again")
    try:
        # NaN and Infinity are read, so that the refusal can name the place where they stand.
        return json.loads(text, parse_constant=float, object_pairs_hook=_no_twins)
    except json.JSONDecodeError as error:
        cut_off = error.pos >= len(text.rstrip()) or error.msg.startswith("Unterminated")
        remedy = "the whole file: this one is cut off" if cut_off else "correct the text there"
        raise SketchFormatError(
            f"not JSON: {error.msg} at line {error.lineno}, column {error.colno}", (), remedy
        ) from error
    except SketchError:
        raise
    except RecursionError as error:
        raise SketchFormatError("nested too deeply to be a sketch", (), "a sketch file") from error
    except ValueError as error:  # e.g. an integer with more digits than Python reads
        raise SketchFormatError(f"not JSON: {error}", (), "ordinary numbers") from error


def _no_twins(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    body = dict(pairs)
    if len(body) != len(pairs):
        twins = sorted(key for key, n in Counter(key for key, _ in pairs).items() if n > 1)
        raise SketchFormatError("a key stands twice in one object", twins[:5], "keep one of them")
    return body


def _dump(body: dict[str, Any]) -> str:
    return json.dumps(body, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
