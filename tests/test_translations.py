"""Every text for people has a German and a Japanese translation, and the files are up to date."""

from __future__ import annotations

import ast
import builtins
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
_WORDING = ("problems", "wording", "reasons", "made_lines", "file_reasons")
SOURCES += [ROOT / "InitGui.py", *(ROOT / "workbench" / f"{name}.py" for name in _WORDING)]

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
    [
        "two_step",
        "telling",
        "on_found_faces",
        "perspective/vanishing_points",
        "perspective/marker",
        "blaming",
        "editing/nearly_flat",
    ],
)
def test_what_the_solver_says_of_a_sketch_is_known_to_the_wording(name, monkeypatch):
    from incontext.workbench import host
    from incontext.workbench.wording import in_language

    monkeypatch.setattr(host, "translate", lambda _, text: f"<{text}>")
    found = list(sentences_of(ROOT / "solver" / f"{name}.py"))
    assert found
    missing = "with it the drawing is missed by 7 px, without it by 7 px"
    # What stands in the places of some are the module's own clauses, or an ending.
    clauses = {": 7.": f": {missing}.", "hold7:": "hold:"}
    for place, clause in clauses.items():
        found = [words.replace(place, clause) for words in found]
    found = [f"7 freedoms left{w[1:]}" if w.startswith("7: ") else w for w in found]
    found = [
        words.removeprefix("7 ") if words.startswith(("7 If", "7 Not", "7 Where")) else words
        for words in found
    ]
    assert [words for words in found if in_language(words).count("<") < words.count(". ") + 1] == []


def words_of(node: ast.expr) -> str:
    """The text of a string, a number in each of its places; empty for anything else."""
    if isinstance(node, ast.JoinedStr):
        return "".join(v.value if isinstance(v, ast.Constant) else "7" for v in node.values)
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ""


#: Python's own errors are no words for people.
PYTHONS = {name for name in dir(builtins) if name.endswith("Error")}


def errors_of(path: Path) -> Iterator[str]:
    """What a module's errors say is wrong, and what to try."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call):
            name = getattr(node.func, "id", "")
            if name.endswith("Error") and name not in PYTHONS:
                yield from filter(None, map(words_of, node.args))


@pytest.fixture
def marked(monkeypatch):
    """What is translated stands in angles."""
    from incontext.workbench import host
    from incontext.workbench.wording import in_language

    monkeypatch.setattr(host, "translate", lambda _, text: f"<{text}>")
    return in_language


#: Data, and commands of the command line, which speaks English.
NO_WORDS = re.compile(r"[\W\d]*|\{.*|\[.*|.* --\w+.*")


@pytest.mark.parametrize("folder", ["solver", "workbench/fabrication", "workbench/canvas"])
def test_what_errors_say_is_known_to_the_wording(folder, marked):
    modules = [p for p in (ROOT / folder).rglob("*.py") if "synthetic" not in p.parts]
    said = [(path.name, words) for path in modules for words in errors_of(path)]
    assert said
    unknown = [(n, w) for n, w in said if not NO_WORDS.fullmatch(w) and "<" not in marked(w)]
    assert unknown == []


@pytest.mark.parametrize(
    ("module", "names"),
    [
        ("joints", ("why_no_fingers",)),
        ("assembly", ("words",)),
        ("fits", ("effects", "cutting_effects")),
        ("fit", ("words",)),
        ("standing", ("words",)),
        ("checking", ("lines",)),
        ("weak_spots", ("loose_plates", "_pieces", "thin_plates", "thin_walls")),
        ("../photos", ("photo_path", "load_photo", "read_upright")),
    ],
)
def test_lines_about_what_is_made_are_known_to_the_wording(module, names, marked):
    tree = ast.parse((ROOT / "workbench" / "fabrication" / f"{module}.py").read_text("utf-8"))
    functions = [n for n in ast.walk(tree) if isinstance(n, ast.FunctionDef) and n.name in names]
    assert {f.name for f in functions} == set(names)
    skipped = no_texts(tree)
    found = []
    for node in (node for function in functions for node in ast.walk(function)):
        words = "" if id(node) in skipped else words_of(node) if isinstance(node, ast.expr) else ""
        # Parts of lines, with joints of their own, are tried as wholes elsewhere.
        if len(words.split()) > 3 and not words.startswith((";", " (")):
            found.append(words.replace("it stands7:", "it stands:"))
    assert found
    assert [words for words in found if not marked(words).startswith("<")] == []


def test_whole_lines_are_translated_part_by_part(marked):
    joint = "e1, e2: half lap between f1 and f2 at 90 degrees (fingers would cut f1 into pieces)"
    assert marked(joint) == (
        "<e1, e2: <half lap> between f1 and f2 at 90 degrees (<fingers would cut f1 into pieces>)>"
    )
    fit = (
        "block e4 (which will stand 2.0 mm higher): fits, 3.0 mm from f2; "
        "room: 4.0 mm left, free back and up; one pixel of the photo is 0.3 mm there"
    )
    assert marked(fit) == (
        "<<<block e4> (which will stand 2.0 mm higher)>: fits, <3.0 mm from f2>; "
        "room: <4.0 mm left>, <free <back>> <and> <up>; one pixel of the photo is 0.3 mm there>"
    )
