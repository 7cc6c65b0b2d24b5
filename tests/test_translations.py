"""Every text for people has a German and a Japanese translation, and the files are up to date."""

from __future__ import annotations

import ast
import re
import runpy
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "resources" / "translations"
LANGUAGES = ("de", "ja")
RELEASE = runpy.run_path(str(FOLDER / "release.py"))
FOLDERS = ("canvas", "panels", "commands", "features")
SOURCES = sorted(p for folder in FOLDERS for p in (ROOT / "workbench" / folder).rglob("*.py"))
SOURCES += [ROOT / "InitGui.py", ROOT / "workbench" / "problems.py"]

#: Of what has a space or begins like a sentence, these are for programs.
NOT_FOR_PEOPLE = re.compile(
    r"I, \w|[A-Z]+|\*\..*|.*(\(\?P<|::|__|\\).*|[A-Z][a-z]+([A-Z][A-Za-z]*)+|border: .*|#.*"
    r"|InContext.*|User parameter:.*|<\?xml.*",
    re.DOTALL,
)
#: Names of properties, of FreeCAD's, Qt's and Coin's own things.
_NAMES = """
    Label Sketch Undo Redo Perspective Separator Pixmap Accel Checkable Restore Width Depth Height
    Dimensions Model Result Side Joints Play Kerf Cutting Preset Sheets Margin Spacing Grain Files
    Exploded Fit Assembly Status Message Wall Proxy Shell Solid Printer Tolerance Bed Object Hidden
    Base Custom Vertex Vertexes Edge Edges Face Faces
    Marker Check Checked Things Fits Stands Standing Overlap Support Visibility Plays
"""
NAMES = {*_NAMES.split(), "Method", "Shown dimensions", "Shown dimensions: angles"}
#: Methods are called as in the papers, and documents store their names.
NAMES |= {"Modified Lipson", "Lau 2010", "Lipson 1996"}


def no_texts(tree: ast.Module) -> set[int]:
    """Docstrings, other bare strings, and the fixed parts of f-strings."""
    bare = {id(n.value) for n in ast.walk(tree) if isinstance(n, ast.Expr)}
    return bare | {id(v) for n in ast.walk(tree) if isinstance(n, ast.JoinedStr) for v in n.values}


def texts_of(path: Path) -> Iterator[str]:
    """Strings of a source file that look like words for people."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    skipped = no_texts(tree)
    for node in ast.walk(tree):
        if not isinstance(node, ast.Constant) or id(node) in skipped:
            continue
        text = node.value
        if not isinstance(text, str) or text in NAMES or NOT_FOR_PEOPLE.fullmatch(text):
            continue
        if " " in text.strip() or (len(text) > 2 and text.isalpha() and text[0].isupper()):
            yield text


def translations(language: str) -> dict[str, str]:
    messages = RELEASE["messages_in"](FOLDER / f"InContext_{language}.ts")
    return {source: text for (context, source), text in messages.items() if context == "InContext"}


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_is_translated(language):
    known = translations(language)
    wanted = {text: path.name for path in SOURCES for text in texts_of(path)}
    assert len(wanted) > 150
    assert {t: name for t, name in wanted.items() if not known.get(t)} == {}


@pytest.mark.parametrize("language", LANGUAGES)
def test_translations_have_the_same_places(language):
    for source, text in translations(language).items():
        places = [sorted(re.findall(r"\{[^}]*\}", words)) for words in (source, text)]
        assert places[0] == places[1], source


@pytest.mark.parametrize("language", LANGUAGES)
def test_compiled_file_is_that_of_its_source(language):
    messages = RELEASE["messages_in"](FOLDER / f"InContext_{language}.ts")
    compiled = (FOLDER / f"InContext_{language}.qm").read_bytes()
    assert compiled == RELEASE["qm_of"](messages), "run resources/translations/release.py"


def sentences_of(path: Path) -> Iterator[str]:
    """Sentences that a module of the solver puts together, a number in each of their places."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    skipped = no_texts(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            words = "".join(v.value if isinstance(v, ast.Constant) else "7" for v in node.values)
        elif isinstance(node, ast.Constant) and id(node) not in skipped:
            words = node.value if isinstance(node.value, str) else ""
        else:
            continue
        if words.endswith(".") and " " in words.strip():
            yield words.strip()


@pytest.mark.parametrize(
    "name",
    ["two_step", "on_found_faces", "perspective/vanishing_points", "perspective/marker", "blaming"],
)
def test_what_the_solver_says_of_a_sketch_is_known_to_the_wording(name, monkeypatch):
    from incontext.workbench import host
    from incontext.workbench.panels.wording import in_language

    monkeypatch.setattr(host, "translate", lambda _, text: f"<{text}>")
    found = list(sentences_of(ROOT / "solver" / f"{name}.py"))
    assert found
    missing = "with it the drawing is missed by 7 px, without it by 7 px"
    # What stands in the places of some are the module's own clauses, or an ending.
    clauses = {": 7.": f": {missing}.", "hold7:": "hold:"}
    for place, clause in clauses.items():
        found = [words.replace(place, clause) for words in found]
    found = [f"7 freedoms left{w[1:]}" if w.startswith("7: ") else w for w in found]
    found = [words.removeprefix("7 ") if words.startswith("7 If") else words for words in found]
    assert [words for words in found if in_language(words).count("<") < words.count(". ") + 1] == []
