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


def test_freecad_reads_every_field_of_our_metadata_as_it_is_meant():
    import ast
    import xml.etree.ElementTree as ElementTree

    space = "{https://wiki.freecad.org/Package_Metadata}"
    package = ElementTree.parse(ROOT / "package.xml").getroot()
    told = {child.tag.removeprefix(space): child for child in package}
    read = FreeCAD.Metadata(str(ROOT / "package.xml"))
    names = ["name", "version", "description", "icon"]
    # FreeCAD 0.20 reads no date.
    names += ["date"] if hasattr(read, "Date") else []
    for name in names:
        assert getattr(read, name.capitalize()) == told[name].text
    (person,) = read.Maintainer
    maintainer = told["maintainer"]
    assert person == {"name": maintainer.text, "email": maintainer.get("email")}
    (licence,) = read.License
    assert licence == {"name": told["license"].text, "file": "LICENSE"}
    assert (ROOT / licence["file"]).is_file()
    urls = {url.get("type"): url.text for url in package.findall(f"{space}url")}
    assert {url["type"]: url["location"] for url in read.Urls} == urls
    branches = {url["type"]: url.get("branch", "") for url in read.Urls}
    assert branches["repository"] == "main"

    (workbench,) = read.Content["workbench"]
    own = package.find(f"{space}content/{space}workbench")
    classes = [
        n.name for n in ast.parse((ROOT / "InitGui.py").read_text()).body if hasattr(n, "name")
    ]
    assert [workbench.Classname] == classes
    assert workbench.Subdirectory == "./"
    assert (workbench.Name, workbench.Icon) == (read.Name, read.Icon)
    assert read.Tag == [tag.text for tag in package.findall(f"{space}tag")]
    depends = [one.text for one in package.findall(f"{space}depend")]
    assert [one["package"] for one in read.Depend] == depends
    assert depends
    assert own.find(f"{space}classname").text == workbench.Classname
    assert read.FreeCADMin.startswith("0.20")
    assert (ROOT / workbench.Icon).is_file()
    assert workbench.FreeCADMin.startswith("0.20")
    assert read.supportsCurrentFreeCAD()
    assert workbench.supportsCurrentFreeCAD()
