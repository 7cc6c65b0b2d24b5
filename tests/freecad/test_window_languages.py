"""The workbench in German and Japanese, as FreeCAD's window loads it."""

import FreeCADGui
import pytest
from PySide import QtGui

from incontext.tests.freecad.hands import pump, wait_until
from incontext.workbench import host
from incontext.workbench.wording import CLAUSES, SENTENCES, in_language


@pytest.fixture
def language():
    yield FreeCADGui.setLocale
    FreeCADGui.setLocale("English")
    pump()


@pytest.mark.parametrize(
    ("name", "line", "freedoms"),
    [
        ("German", "Linie zeichnen", "Noch 2 Freiheiten: bitte einen rechten Winkel, eine "),
        ("Japanese", "線を描く", "自由度が 2 残っています。v1、v2"),
        ("English", "Draw line", "2 freedoms left: add a right angle"),
    ],
)
def test_words_are_in_the_persons_language(language, name, line, freedoms):
    language(name)
    assert host.translate("InContext", "Draw line") == line
    words = "2 freedoms left: add a right angle, parallel or ground vertex at v1, v2 and v3."
    assert in_language(words)[:16] == freedoms.replace("、v2", ", v2")[:16]
    assert "v3" in in_language(words)


def test_sentences_of_the_solver_are_known_in_german(language):
    language("German")
    said = (
        "a4, a1 and a2 cannot all hold: take one of them away.",
        "Solved, but a3 contradicts the drawing: with it the drawing is missed by 12 px, "
        "without it by 1.5 px.",
        "a3 cannot hold together with a1 and a2: try removing a3.",
        "Solved. Its sizes are unsure: mark more, give a length, or trace something real in the "
        "photo.",
    )
    for words in said:
        german = in_language(words)
        assert german != words
        assert "und" in german or "and" not in german
    assert "a1 und a2" in in_language(said[2])
    assert in_language("Something new.") == "Something new."


def test_errors_say_in_japanese_what_is_wrong_where_and_what_to_try(language):
    language("Japanese")
    thick = "the wall of 9 mm is too thick: the shape measures 12 mm here (f1, f2)"
    assert in_language(f"{thick}; try: a thinner wall") == (
        "壁 9 mm は厚すぎます。形はここで 12 mm です (f1, f2)。対処: 壁を薄くする"
    )
    many = "more than 9 pairs of edges meet (e1); try: list the faces in the sketch"
    assert in_language(f"Solved. No faces were looked for: {many}.").endswith(
        "面は探しませんでした: 9 組を超える辺が交わっています (e1)。対処: スケッチに面を列挙する。"
    )
    assert in_language("something new (f1); try: something else") == (
        "something new (f1)。対処: something else"
    )


def test_every_reason_comes_back_from_its_pattern():
    for source in CLAUSES:
        words = source.replace("{}", "7")
        assert in_language(f"{words} (f1, f2); try: {words}") == f"{words} (f1, f2); try: {words}"


def test_every_sentence_comes_back_from_its_pattern():
    for source in SENTENCES:
        words = source.replace("{0}", "a1").replace("{1}", "a2").replace("{}", "7")
        assert in_language(words) == words


def shown_words(window, name):
    """What a command's action says: its text, and what it does."""
    (action,) = {a for a in window.findChildren(QtGui.QAction) if a.objectName() == name}
    return action.text(), action.toolTip()


def test_buttons_and_menus_follow_the_language_at_once(language, window):
    toolbars = [bar for bar in window.findChildren(QtGui.QToolBar) if bar.windowTitle()]
    (tools,) = (bar for bar in toolbars if bar.windowTitle() == "Sketch tools")
    menus = [action for action in window.menuBar().actions() if "Context" in action.text()]
    assert [menu.text() for menu in menus] == ["Modeling in &Context"]
    english = shown_words(window, "InContext_FixLength")
    assert english[0] == "Fix or free size"
    for name, text in (
        ("German", "Maß festlegen oder freigeben"),
        ("Japanese", "寸法を固定または解除"),
    ):
        language(name)
        wait_until(lambda text=text: shown_words(window, "InContext_FixLength")[0] == text)
        assert shown_words(window, "InContext_FixLength")[1] != english[1]
        assert tools.windowTitle() == host.translate("InContext", "Sketch tools")
        line = shown_words(window, "InContext_ToolLine")
        assert line[0] == host.translate("InContext", "Line")
        examples = host.translate("InContext", "Bookshelf")
        assert shown_words(window, "InContext_ExampleBookshelf")[0] == examples
    language("English")
    wait_until(lambda: shown_words(window, "InContext_FixLength") == english)
    assert tools.windowTitle() == "Sketch tools"
