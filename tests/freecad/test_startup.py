"""What FreeCAD's start costs, and whose modules are ours."""

import json
import sys
from pathlib import Path

import FreeCAD
import pytest

from incontext.workbench import host
from incontext.workbench.launch import ROOT, Launch, run

HEAVY = {"numpy", "scipy", "cadquery", "OCP", "shapely", "ezdxf", "matplotlib"}


@pytest.mark.parametrize("window", [False, True])
def test_start_loads_nothing_heavy(window, tmp_path):
    if window and not FreeCAD.GuiUp:
        pytest.skip("needs the window stage's screen")
    launch = Launch(
        call="incontext.tests.freecad.fresh_process:loaded_modules",
        home=tmp_path / "home",
        arguments=[str(tmp_path / "answer.json")],
        window=window,
    )
    assert run(launch) == 0
    loaded = set(json.loads((tmp_path / "answer.json").read_text()))
    assert "incontext" in loaded
    assert not HEAVY & loaded
    assert not {name for name in loaded if name.startswith("incontext.solver")}


def test_modules_are_ours_beside_an_addon_with_the_same_names():
    assert any(Path(p, "workbench", "__init__.py").is_file() and "decoy" in p for p in sys.path)
    assert Path(host.__file__).resolve() == ROOT / "workbench" / "host.py"
    assert "workbench" not in sys.modules
    assert "solver" not in sys.modules


def test_two_other_addons_with_our_names_change_nothing(shelf, document, tmp_path):
    """Whichever of them comes first on the path, and though one loads its own `solver`."""
    path, answer = tmp_path / "shelf.FCStd", tmp_path / "answer.json"
    document.saveCopy(str(path))
    launch = Launch(
        call="incontext.tests.freecad.fresh_process:reopen",
        home=tmp_path / "home",
        arguments=[str(answer), str(path)],
        window=False,
        addons=tuple(ROOT / "tests" / "freecad" / name for name in ("decoy_addon", "decoy_again")),
    )
    assert run(launch) == 0
    found = json.loads(answer.read_text())
    assert all(name.startswith("incontext.workbench.features.") for name in found["modules"])
    assert found["recomputed"]["volume"] == pytest.approx(found["stored"]["volume"], rel=1e-9)


def test_own_packages_come_before_those_of_the_system():
    import pyparsing

    assert tuple(int(part) for part in pyparsing.__version__.split(".")[:2]) >= (3, 1)


def test_freecad_understands_our_metadata():
    import ast

    metadata = FreeCAD.Metadata(str(ROOT / "package.xml"))
    (workbench,) = metadata.Content["workbench"]
    classes = [
        n.name for n in ast.parse((ROOT / "InitGui.py").read_text()).body if hasattr(n, "name")
    ]
    assert [workbench.Classname] == classes
    assert workbench.Subdirectory == "./"
    assert metadata.supportsCurrentFreeCAD()
    assert (ROOT / workbench.Icon).is_file()
    assert (ROOT / metadata.License[0]["file"]).is_file()
