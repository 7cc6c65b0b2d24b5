"""A photo that can be zoomed and panned; what is drawn over it comes in a subclass.

Terms
-----
photo position
    px of the upright photo, which are also the scene's coordinates.
screen position
    px of the view's surface.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import style
from .photo_giving import photo_in
from .photo_item import PhotoItem
from .qt import QtCore, QtGui, position_of

if TYPE_CHECKING:
    from .photo_edges import Patch
    from .plane import Point

_Qt = QtCore.Qt

ZOOM_STEP = 1.2
ZOOM_RANGE = (0.02, 60.0)
FIT_MARGIN = 0.02
#: Edges of the photo are looked for in a window of so many times the reach, at least so large.
WINDOW_REACHES = 2.5
LEAST_WINDOW_PX = 16.0


class PhotoView(QtGui.QGraphicsView):
    """A photo: the wheel zooms at the pointer, the middle button or Space pans.

    Signals
    -------
    photo_given(object)
        A photo was dropped or pasted: its Path, or a QImage.
    """

    photo_given = QtCore.Signal(object)

    def __init__(self, parent: QtGui.QWidget | None = None) -> None:
        super().__init__(parent)
        self._photo = PhotoItem()
        self._size = (800.0, 600.0)
        self._pan_from: QtCore.QPoint | None = None
        self._space_held = False
        self._fitted = True
        scene = QtGui.QGraphicsScene(self)
        scene.addItem(self._photo)
        self.setScene(scene)
        self.setBackgroundBrush(QtGui.QColor(style.OUTSIDE))
        self.setFrameShape(QtGui.QFrame.NoFrame)
        self.setMouseTracking(True)
        self.setAcceptDrops(True)
        self.setFocusPolicy(_Qt.StrongFocus)
        self.setHorizontalScrollBarPolicy(_Qt.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(_Qt.ScrollBarAlwaysOff)
        self.setTransformationAnchor(QtGui.QGraphicsView.AnchorUnderMouse)
        # What is drawn over the photo is one painting: parts of it cannot be redrawn alone.
        self.setViewportUpdateMode(QtGui.QGraphicsView.FullViewportUpdate)

    def set_photo(self, image: QtGui.QImage | None, size_px: tuple[float, float]) -> None:
        """Show a photo, or none, stretched to the size that the sketch was drawn on."""
        width, height = self._size = size_px
        self._photo.show_levels([] if image is None else [image], size_px)
        # Room around the photo, so that its corners can be brought to the middle.
        self.setSceneRect(-width, -height, 3 * width, 3 * height)

    def add_photo_level(self, image: QtGui.QImage) -> None:
        """Show the photo in more detail, as it comes."""
        self._photo.add_level(image, self._size)

    def grey_around(self, place_px: Point, reach_px: float) -> Patch | None:
        """The photo about a place, in which its edges are looked for."""
        # Zoomed in, a few px of the photo fill the reach: too few to tell a line.
        radius_px = max(WINDOW_REACHES * reach_px, LEAST_WINDOW_PX)
        return self._photo.grey_around(place_px, radius_px, self.zoom)

    @property
    def has_photo(self) -> bool:
        """Whether something of a photo is shown."""
        return bool(self._photo.levels)

    def set_photo_strength(self, strength: float) -> None:
        """Fade the photo: 1 shows it as it is, 0 not at all."""
        self._photo.setOpacity(max(0.0, min(1.0, strength)))

    @property
    def zoom(self) -> float:
        """Screen px per photo px."""
        return float(self.transform().m11())

    def fit(self) -> None:
        """Show the whole photo."""
        width, height = self._size
        margin = FIT_MARGIN * max(width, height)
        area = QtCore.QRectF(0, 0, width, height).adjusted(-margin, -margin, margin, margin)
        self.fitInView(area, _Qt.KeepAspectRatio)
        self._fitted = True

    def zoom_by(self, factor: float) -> None:
        """Zoom at the pointer."""
        low, high = ZOOM_RANGE
        factor = max(low, min(high, self.zoom * factor)) / self.zoom
        self.scale(factor, factor)
        self._fitted = False

    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:  # noqa: N802  Qt's names
        """Keep the whole photo in view while nobody zoomed."""
        super().resizeEvent(event)
        if self._fitted:
            self.fit()

    def wheelEvent(self, event: QtGui.QWheelEvent) -> None:  # noqa: N802
        """Zoom; a notch of the wheel is 120 units."""
        self.zoom_by(ZOOM_STEP ** (event.angleDelta().y() / 120))
        event.accept()

    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:  # noqa: N802
        """Take hold of the photo."""
        left_pans = event.button() == _Qt.LeftButton and self._space_held
        if event.button() == _Qt.MiddleButton or left_pans:
            self._pan_from = position_of(event)
            self.show_cursor()
        event.accept()

    def mouseMoveEvent(self, event: QtGui.QMouseEvent) -> None:  # noqa: N802
        """Pan."""
        if self._pan_from is not None:
            self._pan_to(position_of(event))
        # Qt zooms at the last place that it saw the pointer.
        super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QtGui.QMouseEvent) -> None:  # noqa: N802
        """Let go of the photo."""
        if self._pan_from is not None and event.button() != _Qt.RightButton:
            self._pan_from = None
            self.show_cursor()
        event.accept()

    def mouseDoubleClickEvent(self, event: QtGui.QMouseEvent) -> None:  # noqa: N802
        """A second click in short order is a click like any other."""
        self.mousePressEvent(event)

    def _pan_to(self, pos: QtCore.QPoint) -> None:
        moved = pos - self._pan_from
        self._pan_from = pos
        self._fitted = False
        for bar, distance in (
            (self.horizontalScrollBar(), moved.x()),
            (self.verticalScrollBar(), moved.y()),
        ):
            bar.setValue(bar.value() - distance)

    @property
    def is_panning(self) -> bool:
        """True while the photo is held."""
        return self._pan_from is not None

    def show_cursor(self) -> None:
        """Show by the pointer's shape what a press would do."""
        self.viewport().setCursor(self.cursor_shape())

    def cursor_shape(self) -> _Qt.CursorShape:
        """The pointer's shape."""
        if self.is_panning:
            return _Qt.ClosedHandCursor
        return _Qt.OpenHandCursor if self._space_held else _Qt.ArrowCursor

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:  # noqa: N802
        """F or Home fits, Space pans while it is held."""
        if event.key() in (_Qt.Key_F, _Qt.Key_Home):
            self.fit()
        elif event.key() == _Qt.Key_Space:
            self._space_held = True
            self.show_cursor()
        else:
            # Not on to the base class: it would scroll by the arrow keys.
            event.ignore()

    def keyReleaseEvent(self, event: QtGui.QKeyEvent) -> None:  # noqa: N802
        """Space let go ends panning."""
        if event.key() == _Qt.Key_Space and not event.isAutoRepeat():
            self._space_held = False
            self.show_cursor()

    def focusOutEvent(self, event: QtGui.QFocusEvent) -> None:  # noqa: N802
        """A key let go elsewhere is not seen here."""
        self._space_held = False
        super().focusOutEvent(event)

    # Drops

    def dragEnterEvent(self, event: QtGui.QDragEnterEvent) -> None:  # noqa: N802  Qt's names
        """Take photos."""
        if photo_in(event.mimeData()) is not None:
            event.acceptProposedAction()

    def dragMoveEvent(self, event: QtGui.QDragMoveEvent) -> None:  # noqa: N802
        """Take them anywhere."""
        event.acceptProposedAction()

    def dropEvent(self, event: QtGui.QDropEvent) -> None:  # noqa: N802
        """Hand the photo on."""
        given = photo_in(event.mimeData())
        if given is not None:
            event.acceptProposedAction()
            self.photo_given.emit(given)

    def paste(self) -> None:
        """Hand on the photo that was copied."""
        given = photo_in(QtGui.QApplication.clipboard().mimeData())
        if given is not None:
            self.photo_given.emit(given)
