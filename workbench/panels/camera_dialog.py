"""A small window on the photo's camera: its focal length, and where it looked."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import FreeCADGui

from .. import host
from ..canvas.qt import QtGui
from ..features import photo_camera, pipeline
from ..features.known_rectangle import rectangle_of
from ..features.photo_camera import PhotoCamera
from ..problems import in_words, known_problems
from .asking import shown
from .messages import tell
from .waiting import busy

if TYPE_CHECKING:
    from ...solver.perspective.cropping import ViewMiddle

_DIGITS = 1


class CameraDialog(QtGui.QDialog):
    """Shows what is known of a photo sketch's camera, and takes what a person knows better.

    Parameters
    ----------
    obj : FreeCAD document object
        A photo sketch with a photo.
    """

    def __init__(self, obj: Any) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self._obj = obj
        self._graph = pipeline.graph_of(obj.Sketch)
        assert self._graph.photo is not None
        self._photo = self._graph.photo
        self._px_per_mm = photo_camera.px_per_mm(obj, self._graph)
        self._by_lines: ViewMiddle | None = self._middle_by_lines()
        self.setWindowTitle(host.translate("InContext", "Camera of the photo"))
        self._build()
        told = photo_camera.told_camera(self._graph)
        if told.focal_px is not None:
            self.focal_field.setText(f"{self._in_mm(told.focal_px):.4g}")
        self._show_middle(told.middle_px)

    def show_until_answered(self) -> None:
        """Show it, and write what it says."""
        if not shown(self):
            return
        try:
            with busy():
                photo_camera.set_photo_camera(self._obj, self.camera)
        except known_problems() as error:
            tell(in_words(error))

    @property
    def camera(self) -> PhotoCamera:
        """What it says.

        Raises
        ------
        ValueError
            Where something in it is no number.
        """
        text = self.focal_field.text().strip()
        focal_px = None
        if text:
            focal_px = _number(text) * self._px_per_mm
            if not focal_px > 0:
                raise ValueError(text)
        u, v = (_number(field.text()) for field in (self.u_field, self.v_field))
        is_middle = (
            max(abs(u - self._photo.width_px / 2), abs(v - self._photo.height_px / 2)) < 0.05
        )
        return PhotoCamera(focal_px, None if is_middle else (u, v))

    @property
    def words(self) -> str:
        """What is said of it."""
        return self._words.text()

    def _in_mm(self, focal_px: float) -> float:
        return focal_px / self._px_per_mm

    def _middle_by_lines(self) -> ViewMiddle | None:
        try:
            return photo_camera.middle_by_lines(self._obj, self._graph)
        except known_problems():
            # Of the sketch itself its tab says what is wrong.
            return None

    def _build(self) -> None:
        self.focal_field = QtGui.QLineEdit()
        self.focal_field.setPlaceholderText(host.translate("InContext", "not known"))
        self.focal_field.setMaximumWidth(150)
        focal = QtGui.QHBoxLayout()
        focal.addWidget(self.focal_field)
        focal.addWidget(QtGui.QLabel(host.translate("InContext", "mm (35 mm equivalent)")), 1)
        self.u_field, self.v_field = QtGui.QLineEdit(), QtGui.QLineEdit()
        middle = QtGui.QHBoxLayout()
        for field, words in ((self.u_field, "px right,"), (self.v_field, "px down")):
            field.setMaximumWidth(70)
            middle.addWidget(field)
            middle.addWidget(QtGui.QLabel(host.translate("InContext", words)))
        middle.addStretch(1)
        form = QtGui.QFormLayout()
        form.addRow(host.translate("InContext", "Focal length"), focal)
        form.addRow(host.translate("InContext", "It looked towards"), middle)
        form.addRow("", self._choices())
        self._words = QtGui.QLabel(self._said())
        self._words.setWordWrap(True)
        self._words.setMinimumWidth(380)
        both = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel
        self._buttons = QtGui.QDialogButtonBox(both)
        self._buttons.accepted.connect(self.accept)
        self._buttons.rejected.connect(self.reject)
        layout = QtGui.QVBoxLayout(self)
        layout.setSpacing(12)
        layout.addLayout(form)
        layout.addWidget(self._words)
        layout.addWidget(self._buttons)
        for field in (self.focal_field, self.u_field, self.v_field):
            field.textChanged.connect(self._look)

    def _choices(self) -> QtGui.QWidget:
        """What fills the fields in."""
        self.middle_button = QtGui.QPushButton(host.translate("InContext", "Photo's middle"))
        self.middle_button.clicked.connect(lambda: self._show_middle(None))
        self.lines_button = QtGui.QPushButton(host.translate("InContext", "By the traced lines"))
        self.lines_button.setEnabled(self._by_lines is not None)
        self.lines_button.clicked.connect(self._take_lines)
        self.refine_button = QtGui.QPushButton(host.translate("InContext", "Refine by the drawing"))
        self.refine_button.setVisible(self._can_refine())
        self.refine_button.clicked.connect(self._refine)
        row = QtGui.QWidget()
        layout = QtGui.QHBoxLayout(row)
        layout.setContentsMargins(0, 0, 0, 0)
        for button in (self.middle_button, self.lines_button, self.refine_button):
            button.setAutoDefault(False)
            layout.addWidget(button)
        layout.addStretch(1)
        return row

    def _can_refine(self) -> bool:
        """Whether a rectangle tells the camera, and something is drawn."""
        graph = self._graph
        is_told = graph.camera is not None and rectangle_of(self._obj.Marker) is not None
        return is_told and bool(graph.edges or graph.circles)

    def _said(self) -> str:
        """What is known, and how to go on where the photo seems cropped."""
        found = [photo_camera.cropping_words(self._obj, self._graph)]
        if self._by_lines is not None:
            (u, v), sigma = self._by_lines.principal_px, self._by_lines.sigma_px
            words = host.translate(
                "InContext",
                "The traced lines say: towards {0:.0f}, {1:.0f} px, good to {2:.0f} px.",
            )
            found.append(words.format(u, v, sigma))
        elif found[0]:
            found.append(
                host.translate(
                    "InContext",
                    "Say where the middle of the whole photo was; or trace a box in the photo "
                    "(key B, then X), and its lines tell it.",
                )
            )
        if self._graph.camera is not None:
            words = host.translate("InContext", "The rectangle tells {0:.0f} mm.")
            found.append(words.format(self._in_mm(self._graph.camera.focal_px)))
        usual = host.translate(
            "InContext", "A photo that was not cropped looks towards its middle."
        )
        return "\n".join(filter(None, found)) or usual

    def _show_middle(self, middle_px: tuple[float, float] | None) -> None:
        u, v = middle_px or (self._photo.width_px / 2, self._photo.height_px / 2)
        for field, value in ((self.u_field, u), (self.v_field, v)):
            field.setText(f"{round(value, _DIGITS):g}")

    def _take_lines(self) -> None:
        assert self._by_lines is not None
        u, v = self._by_lines.principal_px.tolist()
        self._show_middle((u, v))

    def _refine(self) -> None:
        """Write the camera that rectangle and drawing tell together."""
        before = self._graph.camera
        try:
            with busy():
                is_refined = photo_camera.refine_camera(self._obj)
        except known_problems() as error:
            tell(in_words(error))
            return
        self._graph = pipeline.graph_of(self._obj.Sketch)
        words = host.translate("InContext", "Rectangle and drawing do not agree: check both.")
        if is_refined and before is not None and self._graph.camera is not None:
            cameras = (before, self._graph.camera)
            words = host.translate(
                "InContext", "The focal length was {0:.1f} mm and is {1:.1f} mm."
            )
            words = words.format(*(self._in_mm(camera.focal_px) for camera in cameras))
        self._words.setText(words)

    def _look(self, *_: object) -> None:
        try:
            is_said = self.camera is not None
        except ValueError:
            is_said = False
        self._buttons.button(QtGui.QDialogButtonBox.Ok).setEnabled(is_said)


def _number(text: str) -> float:
    # Some write a comma.
    return float(text.strip().replace(",", "."))
