"""Documents from a stranger: whatever they hold, they open, recompute and say what is wrong."""

from __future__ import annotations

import json
import random
import re
import zipfile
from xml.sax.saxutils import quoteattr

import FreeCAD
import pytest

from incontext.solver.serialise import MAX_BYTES
from incontext.tests.fuzzing import broken_sketch, flipped

#: What our objects may say of how it went.
STATUSES = {
    "", "ready", "unreadable", "converged", "not_converged", "underdetermined", "conflicting",
    "not_made", "not_cut", "waiting", "no_model", "no_sketch", "made", "failed",
}  # fmt: skip
PROPERTY = 'name="{}" type="App::Property{}"'


def replaced(xml: str, name: str, kind: str, text: str) -> str:
    """The document's XML with another value of one string property, of the first that has it."""
    start = xml.index(PROPERTY.format(name, kind))
    value = xml.index('<String value="', start)
    end = xml.index("/>", value)
    return f"{xml[:value]}<String value={quoteattr(text)}{xml[end:]}"


def rewritten(path, target, change) -> None:
    """A copy of a document with its XML changed."""
    with zipfile.ZipFile(path) as source, zipfile.ZipFile(target, "w") as copy:
        for name in source.namelist():
            data = source.read(name)
            if name == "Document.xml":
                data = change(data.decode("utf-8")).encode("utf-8", errors="replace")
            copy.writestr(name, data)


def printable(text: str) -> str:
    """Without what no XML may hold."""
    return "".join(c for c in text if c.isprintable())


@pytest.fixture
def saved(shelf, document, tmp_path):
    path = tmp_path / "shelf.FCStd"
    document.saveCopy(str(path))
    return path


def open_and_recompute(path):
    """The statuses of its objects, and the volume of its plates."""
    document = FreeCAD.openDocument(str(path))
    try:
        for obj in document.Objects:
            obj.touch()
        document.recompute()
        statuses = [obj.Status for obj in document.Objects if hasattr(obj, "Status")]
        return statuses, document.getObject("PlateSet").Shape.Volume
    finally:
        FreeCAD.closeDocument(document.Name)


@pytest.mark.parametrize("seed", range(6))
def test_a_broken_sketch_leaves_the_last_shape(saved, tmp_path, seed):
    rng = random.Random(seed)
    target = tmp_path / "strange.FCStd"
    text, corners = printable(broken_sketch(rng)), printable(flipped(rng, '{"corners_px": [[1]]}'))

    def change(xml):
        xml = replaced(xml, "Sketch", "String", text)
        return replaced(xml, "Marker", "String", corners)

    rewritten(saved, target, change)
    before = set(tmp_path.iterdir())
    statuses, volume = open_and_recompute(target)
    assert len(statuses) == 3
    assert set(statuses) <= STATUSES
    assert volume > 0
    assert set(tmp_path.iterdir()) == before


def test_a_sketch_too_large_to_be_one_is_refused_in_words(shelf, document):
    sketch, _, plates = shelf
    volume = plates.Shape.Volume
    sketch.Sketch = " " * (MAX_BYTES + 1)
    document.recompute()
    assert sketch.Status == "unreadable"
    assert "50 MB" in sketch.Message
    assert plates.Shape.Volume == volume


def too_many_edges(text):
    body = json.loads(text)
    body["vertices"] = {f"v{k}": [k % 800, k % 600] for k in range(20_002)}
    body["edges"] = {f"e{k}": [f"v{k}", f"v{k + 1}"] for k in range(20_001)}
    return json.dumps(body)


def endless_brackets(text):
    return text.replace('"version": 1', f'"version": {100_000 * "["}')


def no_number(text):
    return text.replace('"version": 1', '"version": 1e999')


@pytest.mark.parametrize(
    ("change", "words"),
    [(too_many_edges, "20,?000"), (endless_brackets, "nested"), (no_number, "version")],
)
def test_each_limit_holds_in_a_document_too(shelf, document, change, words):
    """As `test_limits` has them for files."""
    sketch, _, plates = shelf
    volume, text = plates.Shape.Volume, change(sketch.Sketch)
    assert text != sketch.Sketch
    sketch.Sketch = text
    document.recompute()
    assert sketch.Status == "unreadable"
    assert re.search(words, sketch.Message), sketch.Message
    assert "\n" not in sketch.Message
    assert plates.Shape.Volume == volume


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("PlateIds", ["f1", "f1", "../x", ""]),
        ("JointChoices", ["e1=__import__('os')", "=" * 1000, "f1:f2=finger,finger=1e999"]),
        ("Preset", "../../../../etc/passwd"),
        ("PdfPage", "A4; rm"),
        ("FingerWidth", 1e-300),
        ("Thickness", 1e300),
        ("Kerf", 1e300),
    ],
)
def test_strange_properties_are_refused_in_words(shelf, document, name, value):
    _, _, plates = shelf
    volume = plates.Shape.Volume
    setattr(plates, name, value)
    document.recompute()
    assert plates.Status in STATUSES
    assert "\n" not in plates.Message
    assert plates.Shape.Volume == pytest.approx(volume, rel=0.2)
