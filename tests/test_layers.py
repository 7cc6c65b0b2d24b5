"""Who may import whom, read from the source.

``solver <- fabrication <- features <- panels, commands <- InitGui``; the solver's data side
``<- canvas <- panels``. The solver never sees Qt, FreeCAD or cadquery; fabrication never sees Qt or
FreeCAD; the canvas never sees FreeCAD.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
SOURCES = sorted(
    path
    for folder in ("solver", "workbench")
    for path in (ROOT / folder).rglob("*.py")
    if "__pycache__" not in path.parts
)
PLAIN_NAMES = {"solver", "workbench", "tests", "resources"}
FREECAD = {"FreeCAD", "FreeCADGui", "Part", "Mesh", "Sketcher", "Draft", "Import", "pivy"}
QT = {"PySide", "PySide2", "PySide6", "PyQt5", "PyQt6", "shiboken2", "shiboken6"}
HEAVY = {"numpy", "scipy", "cadquery", "shapely", "ezdxf", "manifold3d", "lib3mf", "PIL", "OCP"}

#: What each layer may use of the others, and of FreeCAD and Qt. "core" is workbench/*.py.
ALLOWED = {
    "solver": {"solver"},
    "fabrication": {"solver", "fabrication"},
    "core": {"solver", "fabrication", "core"},
    "features": {"solver", "fabrication", "core", "features", "FreeCAD"},
    "canvas": {"solver", "canvas", "Qt"},
    "panels": {"solver", "core", "features", "canvas", "panels", "FreeCAD", "Qt"},
    "commands": {"solver", "core", "features", "canvas", "panels", "commands", "FreeCAD"},
}
#: Modules of workbench/ that stand at FreeCAD's door.
DOORS = {
    "workbench/host.py": {"FreeCAD"},
    "workbench/inside.py": {"FreeCAD", "Qt"},
    "workbench/demo.py": {"FreeCAD", "features", "panels", "commands"},
}
#: The canvas knows graphs, not how they are solved.
DATA_SIDE = {
    "annotations",
    "camera",
    "errors",
    "graph",
    "serialise",
    "solution",
    "values",
    "editing",
    "geometry",
    "counts",
}


def layer_of(name: str) -> str | None:
    """The layer of a module inside `incontext`, by its dotted name."""
    parts = name.split(".")
    if parts[1:2] == ["solver"]:
        return "solver"
    if parts[1:2] != ["workbench"]:
        return None
    return parts[2] if len(parts) > 2 and parts[2] in ALLOWED else "core"


def dotted(path: Path) -> str:
    """The dotted name of a source file."""
    parts = list(path.relative_to(ROOT).with_suffix("").parts)
    return ".".join(["incontext", *(parts[:-1] if parts[-1] == "__init__" else parts)])


def package_of(path: Path) -> str:
    """The package that a source file's relative imports start from."""
    return ".".join(["incontext", *path.relative_to(ROOT).parts[:-1]])


def imports_of(path: Path) -> Iterator[tuple[ast.stmt, str]]:
    """Every import in a file, wherever it stands, as an absolute dotted name."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node, alias.name
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level:
                package = package_of(path).split(".")
                base = ".".join([*package[: len(package) - node.level + 1], *filter(None, [base])])
            yield node, base
            # `from . import x` names a module that the base alone does not show.
            yield from ((node, f"{base}.{alias.name}") for alias in node.names)


def kinds_of(name: str) -> set[str]:
    """What an import reaches: a layer, FreeCAD, Qt; nothing for other packages."""
    top = name.split(".")[0]
    if top == "incontext":
        layer = layer_of(name)
        # `from .. import host` yields the package itself too, which says nothing.
        is_package = name in ("incontext", "incontext.workbench")
        return {layer} if layer and not is_package else set()
    return {"FreeCAD"} if top in FREECAD else {"Qt"} if top in QT else set()


def allowed_for(path: Path) -> set[str]:
    """What a file may reach."""
    layer = layer_of(dotted(path))
    return ALLOWED[layer] | DOORS.get(path.relative_to(ROOT).as_posix(), set())


def relative(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def type_checking_lines(path: Path) -> set[int]:
    """Lines that only a type checker sees."""
    lines: set[int] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            lines |= {
                line for stmt in node.body for line in range(stmt.lineno, stmt.end_lineno + 1)
            }
    return lines


@pytest.mark.parametrize("path", SOURCES, ids=relative)
def test_imports_keep_to_their_layer(path):
    reached = {(name, kind) for _, name in imports_of(path) for kind in kinds_of(name)}
    forbidden = {(name, kind) for name, kind in reached if kind not in allowed_for(path)}
    assert not forbidden


@pytest.mark.parametrize("path", SOURCES, ids=relative)
def test_no_plain_names_and_no_absolute_ones_of_our_own(path):
    tops = {name.split(".")[0] for node, name in imports_of(path) if not getattr(node, "level", 0)}
    assert not tops & PLAIN_NAMES
    assert "incontext" not in tops


@pytest.mark.parametrize("path", [p for p in SOURCES if "canvas" in p.parts], ids=relative)
def test_canvas_knows_the_solvers_data_side_only(path):
    used = {
        name.split(".")[2] for _, name in imports_of(path) if name.startswith("incontext.solver.")
    }
    assert used <= DATA_SIDE


@pytest.mark.parametrize("path", [p for p in SOURCES if "canvas" in p.parts], ids=relative)
def test_canvas_has_qt_through_one_door(path):
    if path.name != "qt.py":
        assert not {name for _, name in imports_of(path) if "Qt" in kinds_of(name)}


def is_at_start(path: Path) -> bool:
    """Whether FreeCAD's start, or opening a document, loads the file."""
    layer = layer_of(dotted(path))
    return layer in ("features", "commands") or relative(path) in ("workbench/host.py",)


@pytest.mark.parametrize("path", [p for p in SOURCES if is_at_start(p)], ids=relative)
def test_nothing_heavy_at_the_top_of_what_the_start_loads(path):
    hidden = type_checking_lines(path)
    top = ast.parse(path.read_text(encoding="utf-8")).body
    lines = {node.lineno for node in top if isinstance(node, ast.Import | ast.ImportFrom)} - hidden
    names = {name for node, name in imports_of(path) if node.lineno in lines}
    assert not {name for name in names if name.split(".")[0] in HEAVY}
    assert not {name for name in names if layer_of(name) in ("solver", "fabrication")}


@pytest.mark.parametrize("name", ["Init.py", "InitGui.py"])
def test_start_files_import_only_what_is_always_there(name):
    # Relative names mean nothing in text that FreeCAD runs.
    tops = {module.split(".")[0] for _, module in imports_of(ROOT / name)}
    assert tops <= {"importlib", "os", "sys", "FreeCAD", "FreeCADGui", "incontext"}


def test_every_source_has_a_layer():
    assert len(SOURCES) > 40
    assert all(layer_of(dotted(path)) for path in SOURCES)
