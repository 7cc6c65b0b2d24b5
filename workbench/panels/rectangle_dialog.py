"""A small window that asks what a rectangle in the photo is, and shows what follows from it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import host
from ..canvas.lengths import exact_text, parse_length
from ..canvas.qt import QtCore, QtGui
from ..canvas.questions import KnownRectangle
from ..problems import known_problems
from ..wording import in_language

if TYPE_CHECKING:
    from ...solver.graph import Photo
    from ..canvas.view import SketchView
    from ..marker_finding import Found, SeenCorners

#: What a rectangle may be, in order; the last two have sides of their own.
MARKER, OTHER = "Printed marker", "Something else"
PAPERS = {
    "A4 sheet": "A4",
    "A5 sheet": "A5",
    "Letter sheet": "letter",
    "Bank card": "card",
}
_LAST, _LAST_WIDTH, _LAST_HEIGHT = "RectangleKind", "RectangleWidth", "RectangleHeight"
#: Room between the window and the photo's edge, px.
_MARGIN = 16


class RectangleDialog(QtGui.QDialog):
    """Asks for the size; a grid on the ground in the photo shows at once what it leads to.

    Parameters
    ----------
    photo : Photo
    seen : SeenCorners
    view : SketchView
        Shows the grid.
    """

    def __init__(self, photo: Photo, seen: SeenCorners, view: SketchView) -> None:
        super().__init__(view.window())
        self._photo, self._seen, self._view = photo, seen, view
        self.found: Found | None = None
        self._had_grid = view.attraction.grid_shown
        self.setWindowTitle(host.translate("InContext", "Camera from a rectangle"))
        self._build()
        wanted = MARKER if seen.is_marker else host.preferences().GetString(_LAST, MARKER)
        names = [MARKER, *PAPERS, OTHER]
        self.kind.setCurrentIndex(names.index(wanted) if wanted in names else 0)
        self._names = names
        # As the photo has put them right.
        view.set_rectangle(KnownRectangle(tuple(map(tuple, seen.corners_px.tolist()))))
        self.kind.currentIndexChanged.connect(self._take_kind)
        for field in (self.width_field, self.height_field):
            field.textEdited.connect(self._look)
        self._take_kind()
        if not self._had_grid:
            view.toggle_grid()

    def _build(self) -> None:
        self.kind = QtGui.QComboBox()
        for name in (MARKER, *PAPERS, OTHER):
            self.kind.addItem(host.translate("InContext", name))
        self.width_field, self.height_field = QtGui.QLineEdit(), QtGui.QLineEdit()
        self._by = QtGui.QLabel("\N{MULTIPLICATION SIGN}")
        sides = QtGui.QHBoxLayout()
        sides.addWidget(self.width_field)
        sides.addWidget(self._by)
        sides.addWidget(self.height_field)
        form = QtGui.QFormLayout()
        form.addRow(host.translate("InContext", "It is"), self.kind)
        form.addRow(host.translate("InContext", "Size"), sides)
        self._words = QtGui.QLabel()
        self._words.setWordWrap(True)
        self._words.setMinimumWidth(340)
        self._words.setAlignment(QtCore.Qt.AlignTop | QtCore.Qt.AlignLeft)
        self._words.setMinimumHeight(5 * self._words.fontMetrics().lineSpacing())
        both = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel
        self._buttons = QtGui.QDialogButtonBox(both)
        self._buttons.accepted.connect(self.accept)
        self._buttons.rejected.connect(self.reject)
        layout = QtGui.QVBoxLayout(self)
        layout.setSpacing(10)
        layout.addLayout(form)
        layout.addWidget(self._words, 1)
        layout.addWidget(self._buttons)

    @property
    def words(self) -> str:
        """What is said of the camera."""
        return self._words.text()

    @property
    def size_mm(self) -> tuple[float, float]:
        """The two sides as they are said.

        Raises
        ------
        ValueError
            Where they are none.
        """
        width = parse_length(self.width_field.text())
        is_square = self._name() == MARKER
        return (width, width if is_square else parse_length(self.height_field.text()))

    def _name(self) -> str:
        return self._names[self.kind.currentIndex()]

    def _take_kind(self, *_: object) -> None:
        """Fill in the sides of what it is."""
        from ...solver.perspective.marker import RECTANGLES

        name, last = self._name(), host.preferences()
        if name in PAPERS:
            width, height = RECTANGLES[PAPERS[name]]
        else:
            width = last.GetFloat(_LAST_WIDTH, 100.0)
            height = last.GetFloat(_LAST_HEIGHT, 100.0)
        self.width_field.setText(exact_text(width))
        self.height_field.setText(exact_text(height))
        for field in (self.width_field, self.height_field):
            field.setReadOnly(name in PAPERS)
            field.setEnabled(name not in PAPERS)
        for widget in (self._by, self.height_field):
            widget.setVisible(name != MARKER)
        self._look()

    def _look(self, *_: object) -> None:
        """Find the camera and show it."""
        from ..marker_finding import camera_of_corners

        self.found = None
        try:
            self.found = camera_of_corners(self._photo, self._seen, self.size_mm)
            self._words.setText(self._said(self.found))
        except (ValueError, *known_problems()) as error:
            self._words.setText(host.translate("InContext", str(error)))
        self._view.show_camera(None if self.found is None else self.found.view.camera)
        self._buttons.button(QtGui.QDialogButtonBox.Ok).setEnabled(self.found is not None)

    def _said(self, found: Found) -> str:
        camera = found.view.camera
        focal_35mm = camera.focal_px / max(self._photo.width_px, self._photo.height_px) * 36
        height = float(camera.position_mm[2])
        words = host.translate(
            "InContext",
            "A lens of {0:.0f} mm (equivalent), {1:.0f} mm above the ground; heights are good to "
            "{2:.1f} %.",
        ).format(focal_35mm, height, 100 * found.view.size_sigma)
        return "\n".join([words, *map(in_language, found.notes)])

    def showEvent(self, event: QtGui.QShowEvent) -> None:  # noqa: N802  Qt's name
        """Stand aside: the photo is to be seen."""
        super().showEvent(event)
        area = self._view.viewport()
        corner = area.mapToGlobal(QtCore.QPoint(area.width() - self.width() - _MARGIN, _MARGIN))
        self.move(corner)

    def done(self, result: int) -> None:
        """Remember what was said; show the ground as it was."""
        if result and self.found is not None:
            width, height = self.size_mm
            chosen = host.preferences()
            chosen.SetString(_LAST, self._name())
            if self._name() not in PAPERS:
                chosen.SetFloat(_LAST_WIDTH, width)
                chosen.SetFloat(_LAST_HEIGHT, height)
        self._view.show_camera(None)
        if not self._had_grid:
            self._view.toggle_grid()
        super().done(result)
