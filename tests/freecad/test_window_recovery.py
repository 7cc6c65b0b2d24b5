"""What was committed when FreeCAD is killed is offered at its next start, whole."""

import json
import zipfile
from pathlib import Path

import FreeCAD
import pytest
from PySide import QtGui

from incontext.tests.freecad.hands import pump, wait_until
from incontext.workbench.launch import Launch, LaunchError, run
from incontext.workbench.panels import recovery
from incontext.workbench.panels.tabs import show_tab

CALL = "incontext.tests.freecad.fresh_process:"


def test_nothing_committed_is_lost_when_freecad_is_killed(hands, tmp_path, photo_path):
    before, after = tmp_path / "before.json", tmp_path / "after.json"
    # While we wait for them, the others would wait for what we have in the clipboard.
    QtGui.QApplication.clipboard().clear()
    # What is unsaved lies where the system keeps what is temporary.
    places = {"TMPDIR": str(tmp_path), "TEMP": str(tmp_path)}
    first = Launch(
        CALL + "draw_and_be_killed",
        tmp_path / "home",
        [str(before), str(photo_path)],
        window=True,
        environment=places,
    )
    with pytest.raises(LaunchError, match="without an answer"):
        run(first)
    drawn = json.loads(before.read_text())
    assert drawn["undo"] == ["Draw line", "Draw rectangle"]
    second = Launch(
        CALL + "recover", tmp_path / "home", [str(after)], window=True, environment=places
    )
    assert run(second) == 0
    found = json.loads(after.read_text())
    assert found["sketch"] == drawn["sketch"]
    assert found["photo_bytes"] == drawn["photo_bytes"] == photo_path.stat().st_size
    assert (found["proxy"], found["label"]) == ("PhotoSketch", "Killed")


@pytest.fixture
def copy(shelf, document, window):
    """Where the copy of the shelf's document is, its tab open."""
    show_tab(shelf[0])
    pump(0.5)
    return Path(document.TransientDir) / recovery.COPY


def stored(copy):
    with zipfile.ZipFile(copy) as archive:
        assert archive.testzip() is None
        return archive.read("Document.xml").decode()


def has_sketch(copy, text):
    return recovery.with_sketches(stored(copy), {"PhotoSketch": text}) == stored(copy)


def test_copy_follows_each_step_undo_and_the_model(copy, shelf, document):
    from incontext.workbench.panels.open_tabs import open_tabs

    controller, text = open_tabs()[0], shelf[0].Sketch
    controller.tab.view._drawing.select_all()
    controller.tab.view._drawing.push((5.0, 0.0))
    assert shelf[0].Sketch != text
    wait_until(lambda: copy.exists() and has_sketch(copy, shelf[0].Sketch))
    controller.undo()
    assert shelf[0].Sketch == text
    wait_until(lambda: has_sketch(copy, text))
    shelf[2].Thickness = 7
    wait_until(lambda: 'value="7.0' in stored(copy))
    assert document.FileName == ""


@pytest.fixture
def done(monkeypatch):
    """What the keeper does: a word each time, with its outcome where it patches."""
    done = []
    keeping, patching = recovery.keeping, recovery.patching

    def noting_keep(document):
        done.append("kept")
        return keeping(document)

    def noting_patch(document):
        patch = patching(document)
        return lambda: done.append(patch()) or done[-1]

    monkeypatch.setattr(recovery, "keeping", noting_keep)
    monkeypatch.setattr(recovery, "patching", noting_patch)
    return done


def test_slow_document_is_patched_at_once_and_written_when_the_hand_rests(
    copy, shelf, document, monkeypatch, done
):
    monkeypatch.setattr(recovery, "PATIENCE_S", 0.0)
    monkeypatch.setattr(recovery, "REST_MS", 300)
    recovery.keeping(document)()
    done.clear()
    text = json.dumps({**json.loads(shelf[0].Sketch), "construction": ["e0"]})
    shelf[0].Sketch = text
    wait_until(lambda: done)
    assert done == [True]
    assert has_sketch(copy, text)
    names = zipfile.ZipFile(copy).namelist()
    assert names[0] == "Document.xml"
    assert "shelf.jpg" in names
    wait_until(lambda: done == [True, "kept"])
    pump(0.3)
    FreeCAD.closeDocument(FreeCAD.openDocument(str(copy)).Name)
    document.recompute()


def test_a_large_photo_is_put_in_by_a_thread(copy, shelf, document, monkeypatch):
    monkeypatch.setattr(recovery, "LARGE_BYTES", 100)
    photo = Path(shelf[0].Photo)
    before = photo.read_bytes()
    finish = recovery.keeping(document)
    assert photo.read_bytes() == before
    assert sorted(photo.parent.glob("shelf*")) == [photo]
    written = photo.parent / recovery._PART
    with zipfile.ZipFile(written) as archive:
        assert len(archive.read("shelf.jpg")) < 100
    assert finish() is None
    assert not written.exists()
    with zipfile.ZipFile(copy) as archive:
        assert archive.read("shelf.jpg") == before
    opened = FreeCAD.openDocument(str(copy))
    assert Path(opened.PhotoSketch.Photo).read_bytes() == before
    FreeCAD.closeDocument(opened.Name)


def test_nothing_is_kept_where_a_person_wants_no_recovery(shelf, document, window):
    preferences = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document")
    preferences.SetBool("RecoveryEnabled", False)
    assert recovery.keeping(document)() is None
    preferences.SetBool("RecoveryEnabled", True)
    assert not (Path(document.TransientDir) / recovery.COPY).exists()
    assert not recovery.patching(document)()


def test_a_patch_puts_in_any_text_and_only_in_its_place():
    content = (
        '<Object name="A"><Property name="Sketch" type="x">'
        '<String value="old"/></Property></Object>'
        '<Object name="B" Extensions="True">\n<Property name="Sketch" type="x" status="1">\n'
        ' <String value="other"/></Property></Object>'
    )
    changed = recovery.with_sketches(content, {"B": 'a "b" <c>\n&'})
    assert changed == content.replace('"other"', '"a &quot;b&quot; &lt;c&gt;&#10;&amp;"')
    assert recovery.with_sketches(content, {"C": ""}) is None
