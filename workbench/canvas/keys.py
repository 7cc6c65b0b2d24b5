"""What keys mean over the sketch."""

from __future__ import annotations

from .key_cursor import FAST_PX, FINE_PX, STEP_PX
from .qt import QtCore, QtGui
from .tools import KEYS

_Qt = QtCore.Qt

#: Without Shift, Ctrl or Alt.
_PLAIN = {
    _Qt.Key_Escape: "escape",
    _Qt.Key_Return: "enter",
    _Qt.Key_Enter: "enter",
    _Qt.Key_Delete: "delete",
    _Qt.Key_Backspace: "delete",
    _Qt.Key_X: "construction",
    _Qt.Key_N: "numbers",
    _Qt.Key_K: "grid",
    _Qt.Key_I: "photo_edges",
    _Qt.Key_Space: "pan",
    _Qt.Key_F: "fit",
    _Qt.Key_Y: "suggestions",
    _Qt.Key_Home: "fit",
    **{getattr(_Qt, f"Key_{letter}"): letter for letter in KEYS},
}

#: Shift makes these keys on some keyboards.
_ZOOMS = {
    _Qt.Key_Plus: "zoom_in",
    _Qt.Key_Equal: "zoom_in",
    _Qt.Key_Minus: "zoom_out",
    _Qt.Key_Underscore: "zoom_out",
}

#: Where arrow keys push what is selected: right and down, in px of the screen.
ARROWS = {
    _Qt.Key_Left: (-1, 0),
    _Qt.Key_Right: (1, 0),
    _Qt.Key_Up: (0, -1),
    _Qt.Key_Down: (0, 1),
}
#: With Shift so many times as far.
FAR_PUSH = 10


def push_of(event: QtGui.QKeyEvent) -> tuple[int, int] | None:
    """How far an arrow key pushes, in px of the screen; None for other keys."""
    return _by_arrows(event, {_Qt.NoModifier: 1, _Qt.ShiftModifier: FAR_PUSH})


def step_of(event: QtGui.QKeyEvent) -> tuple[int, int] | None:
    """How far an arrow key moves the keyboard's cursor, in px of the screen."""
    plain, fast, fine = STEP_PX, FAST_PX, FINE_PX
    return _by_arrows(
        event, {_Qt.NoModifier: plain, _Qt.ShiftModifier: fast, _Qt.ControlModifier: fine}
    )


def _by_arrows(
    event: QtGui.QKeyEvent, steps: dict[_Qt.KeyboardModifier, int]
) -> tuple[int, int] | None:
    way = ARROWS.get(event.key())
    modifiers = event.modifiers() & ~_Qt.KeypadModifier
    found = next((size for held, size in steps.items() if held == modifiers), None)
    return None if way is None or found is None else (found * way[0], found * way[1])


def begins_number(event: QtGui.QKeyEvent) -> bool:
    """Whether a key begins a number; some keyboards make digits with Shift."""
    plain = not event.modifiers() & ~(_Qt.ShiftModifier | _Qt.KeypadModifier)
    return plain and event.text() in set("0123456789.,")


def meaning(event: QtGui.QKeyEvent) -> str:
    """What a key means, a tool's letter for a tool; nothing where it is not ours."""
    if event.matches(QtGui.QKeySequence.Undo):
        return "undo"
    # The system's own key for it, or Ctrl+Y, which many expect.
    control = event.modifiers() == _Qt.ControlModifier
    if event.matches(QtGui.QKeySequence.Redo) or (control and event.key() == _Qt.Key_Y):
        return "redo"
    if event.matches(QtGui.QKeySequence.SelectAll):
        return "all"
    if event.matches(QtGui.QKeySequence.Paste):
        return "paste"
    if step_of(event) is not None:
        return "push"
    if event.key() in (_Qt.Key_Tab, _Qt.Key_Backtab):
        away = _Qt.ControlModifier | _Qt.AltModifier | _Qt.MetaModifier
        return "" if event.modifiers() & away else "next"
    if event.key() == _Qt.Key_Space and event.modifiers() in (
        _Qt.ShiftModifier,
        _Qt.ControlModifier,
    ):
        return "click"
    if event.key() in _ZOOMS and not event.modifiers() & _Qt.ControlModifier:
        return _ZOOMS[event.key()]
    # The number pad's Enter says that it lies there.
    plain = event.modifiers() in (_Qt.NoModifier, _Qt.KeypadModifier)
    return _PLAIN.get(event.key(), "") if plain else ""
