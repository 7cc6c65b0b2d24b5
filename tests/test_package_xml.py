"""package.xml says what FreeCAD's addon index asks for, each thing in its form and place.

Own rules, after the documentation of the format: which elements there are, how often, and what
may stand in them (`data/package.xsd`). The schema that FreeCAD's people publish
(Addon-Manifest-Schema) has another namespace, which FreeCAD up to 1.1 does not read; but for that
our file keeps to it as well: what it wants of the package itself, and versions of three numbers.
FreeCAD's own reader is asked in `freecad/test_startup.py`.
"""

from __future__ import annotations

import ast
import re
import subprocess
import tomllib
import xml.etree.ElementTree as ElementTree
from datetime import date
from pathlib import Path
from urllib.parse import urlsplit

import pytest

ROOT = Path(__file__).resolve().parent.parent
SPACE = "{https://wiki.freecad.org/Package_Metadata}"
MANY = None
#: How often each element stands in its parent, at the least and at the most.
PACKAGE = {
    "name": (1, 1),
    "description": (1, 1),
    "version": (1, 1),
    "date": (1, 1),
    "maintainer": (1, MANY),
    "author": (1, MANY),
    "license": (1, MANY),
    "url": (2, MANY),
    "icon": (1, 1),
    "tag": (3, MANY),
    "content": (1, 1),
    "freecadmin": (1, 1),
    "freecadmax": (0, 1),
    "pythonmin": (1, 1),
    "depend": (0, MANY),
}
WORKBENCH = {
    "name": (1, 1),
    "classname": (1, 1),
    "subdirectory": (1, 1),
    "icon": (0, 1),
    "freecadmin": (1, 1),
    "freecadmax": (0, 1),
    "pythonmin": (1, 1),
    "tag": (0, MANY),
    "depend": (0, MANY),
    "description": (0, 1),
}
URLS = {"website", "repository", "bugtracker", "readme", "documentation", "discussion", "zip"}
NUMBERS = re.compile(r"(0|[1-9]\d*)(\.(0|[1-9]\d*)){2}")


def name_of(element) -> str:
    assert element.tag.startswith(SPACE), element.tag
    return element.tag.removeprefix(SPACE)


def check_children(parent, rules) -> None:
    names = [name_of(child) for child in parent]
    assert set(names) <= set(rules)
    for name, (least, most) in rules.items():
        assert names.count(name) >= least, name
        assert most is MANY or names.count(name) <= most, name


def texts(parent, name) -> list[str]:
    return [child.text.strip() for child in parent.findall(SPACE + name)]


@pytest.fixture(scope="module")
def package():
    return ElementTree.parse(ROOT / "package.xml").getroot()


@pytest.fixture(scope="module")
def workbench(package):
    (content,) = package.findall(SPACE + "content")
    (child,) = list(content)
    assert name_of(child) == "workbench"
    return child


def test_each_element_is_known_and_there(package, workbench):
    assert name_of(package) == "package"
    assert package.attrib == {"format": "1"}
    check_children(package, PACKAGE)
    check_children(workbench, WORKBENCH)
    assert all((element.text or "").strip() for element in package if len(element) == 0)


def test_version_and_date_are_those_of_the_project(package):
    (version,), (day,) = texts(package, "version"), texts(package, "date")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert version == project["version"]
    assert re.fullmatch(r"\d+\.\d+\.\d+", version)
    assert date.fromisoformat(day)


def test_the_class_is_the_one_that_freecad_gets(workbench):
    body = ast.parse((ROOT / "InitGui.py").read_text(encoding="utf-8")).body
    assert texts(workbench, "classname") == [n.name for n in body if isinstance(n, ast.ClassDef)]
    assert texts(workbench, "subdirectory") == ["./"]


def test_versions_are_three_numbers_and_said_alike(package, workbench):
    for name in ("freecadmin", "pythonmin"):
        assert texts(package, name) == texts(workbench, name)
        assert all(NUMBERS.fullmatch(text) for text in texts(package, name))


def test_files_that_are_named_are_there(package, workbench):
    (licence,) = package.findall(SPACE + "license")
    assert re.fullmatch(r"[A-Za-z0-9.+-]+(-or-later|-only)?", licence.text)
    for file in (licence.get("file"), *texts(package, "icon"), *texts(workbench, "icon")):
        assert (ROOT / file).is_file()


def test_people_can_be_written_to(package):
    for person in package.findall(SPACE + "maintainer"):
        assert re.fullmatch(r"[^@\s]+@[^@\s]+\.[a-z]+", person.get("email"))


def test_addresses_have_the_form_that_the_addon_manager_takes(package):
    urls = {url.get("type"): url for url in package.findall(SPACE + "url")}
    assert {"repository", "readme"} <= set(urls) <= URLS
    for url in urls.values():
        parts = urlsplit(url.text)
        assert parts.scheme == "https"
        assert re.fullmatch(r"[a-z0-9.-]+\.[a-z]+", parts.netloc)
        assert not parts.query
    repository = urls["repository"]
    assert re.fullmatch(r"[\w./-]+", repository.get("branch"))
    assert len(urlsplit(repository.text).path.strip("/").split("/")) == 2
    assert urls["readme"].text.endswith("README.md")


def test_what_is_depended_on_is_what_the_project_needs(package):
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    needed = {re.split(r"[<>=!~ ;\[]", line)[0].lower() for line in project["dependencies"]}
    named = package.findall(SPACE + "depend")
    assert named
    assert {one.get("type") for one in named} == {"python"}
    assert {one.text.lower() for one in named} <= needed
    for text in texts(package, "tag"):
        assert text == text.lower()


#: Debian's own Python has lxml.
VALIDATE = """
import sys
from lxml import etree

schema = etree.XMLSchema(etree.parse(sys.argv[1]))
if not schema.validate(etree.fromstring(sys.stdin.buffer.read()).getroottree()):
    print(schema.error_log.last_error.message)
"""


def complaint(text: str) -> str:
    """What the schema has against a package.xml; empty where it is valid."""
    command = ["/usr/bin/python3", "-c", VALIDATE, str(ROOT / "tests" / "data" / "package.xsd")]
    run = subprocess.run(command, input=text.encode(), capture_output=True, check=True)
    return run.stdout.decode().strip()


@pytest.fixture(scope="module")
def written():
    return (ROOT / "package.xml").read_text(encoding="utf-8")


def test_it_is_valid_against_the_schema(written):
    assert complaint(written) == ""


@pytest.mark.parametrize(
    ("good", "bad"),
    [
        ('format="1"', 'format="2"'),
        ("<version>0.1.0", "<version>first"),
        ("<date>2026-", "<date>26-"),
        ('type="readme"', 'type="manual"'),
        ("<url", "<adress"),
        ('email="', 'email="not '),
        ("https://github.com/incontext/incontext<", "github.com/incontext<"),
        (' file="LICENSE"', ""),
        ("<icon>resources", "<icon>/resources"),
        ("<classname>In", "<classname>In Context."),
        ("<freecadmin>0.20.0", "<freecadmin>0.20 or so"),
        ('depend type="python"', 'depend type="pip"'),
    ],
)
def test_the_schema_refuses(written, good, bad):
    assert good in written
    broken = written.replace(good, bad)
    broken = broken.replace("</url>", "</adress>") if "adress" in bad else broken
    assert complaint(broken) != ""
