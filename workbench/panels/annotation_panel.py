"""The list of what is said of a sketch: how true it is, sizes to edit, suggestions to take."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from .. import host
from ..canvas.lengths import parse_length
from ..canvas.qt import QtCore, QtGui
from ..canvas.selection import Selection
from . import annotation_texts as texts
from . import traced_texts
from .method_button import MethodButton
from .working import is_waiting

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from ...solver.solution import Report
    from .controller import SketchController

_Qt = QtCore.Qt

WHAT, SIZE, OFF = range(3)
#: The annotation's id is kept with its row.
_ID = int(_Qt.UserRole)
#: Residuals follow a drag this often; a list of hundreds at every frame would slow it.
FOLLOW_MS = 120


class AnnotationPanel(QtGui.QWidget):
    """Rows of annotations, for one tab at a time."""

    def __init__(self) -> None:
        super().__init__()
        self.controller: SketchController | None = None
        self._listed: tuple[object, ...] = ()
        self._judged: tuple[object, ...] = ()
        self._marked: tuple[object, ...] = ()
        self._followed: tuple[object, frozenset[str]] = (None, frozenset())
        self._follows = host.translate("InContext", "Follows from the others")
        self._list = _List()
        self._list.itemSelectionChanged.connect(self._select_in_sketch)
        self._list.itemChanged.connect(self._take_size)
        self._list.delete_pressed.connect(self.delete_selected)
        self._status = QtGui.QLabel()
        self._status.setTextFormat(_Qt.RichText)
        self._status.setWordWrap(True)
        self._status.linkActivated.connect(self._go)
        self._counts = QtGui.QLabel()
        self._counts.setWordWrap(True)
        self._traced = QtGui.QLabel()
        self._traced.setWordWrap(True)
        self._suggested = QtGui.QPushButton()
        self._suggested.clicked.connect(self._take_all)
        self._method = MethodButton()
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(4, 4, 4, 4)
        for widget in (self._status, self._list, self._traced, self._suggested, self._counts):
            layout.addWidget(widget)
        layout.addWidget(self._method, 0, _Qt.AlignLeft)
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.refresh)
        self.refresh()

    def show_sketch(self, controller: SketchController | None) -> None:
        """Show the annotations of a tab, or none."""
        if controller is not self.controller:
            self.controller = controller
            self._listed = ()
        self.refresh()

    def refresh_soon(self) -> None:
        """Follow the sketch, though not at every frame of a drag."""
        if not self._soon.isActive():
            self._soon.start(FOLLOW_MS)

    def refresh(self) -> None:
        """Show what is said now, and how true it is."""
        if is_waiting():
            # An edit from a row is being worked on, which the row must outlive.
            self._soon.start(FOLLOW_MS)
            return
        self._soon.stop()
        self.setEnabled(self.controller is not None)
        graph, report = self._graph(), self._report()
        self._list.blockSignals(True)
        key = () if graph is None else (graph.annotations, graph.edges)
        if key != self._listed:
            self._listed = key
            self._fill(graph)
        self._judge(report)
        self._list.blockSignals(False)
        self.show_selection()
        self._say_the_rest()

    def _graph(self) -> SketchGraph | None:
        return None if self.controller is None else self.controller.tab.view.graph

    def _report(self) -> Report | None:
        lift = None if self.controller is None else self.controller.lift
        return None if lift is None else lift[1].report

    def _fill(self, graph: SketchGraph | None) -> None:
        self._judged = self._marked = ()
        self._list.clear()
        for id_, annotation in ({} if graph is None else graph.annotations).items():
            row = QtGui.QTreeWidgetItem([texts.words_of(annotation), texts.size_text(annotation)])
            row.setData(WHAT, _ID, id_)
            row.setIcon(WHAT, QtGui.QIcon(texts.kind_icon(annotation.kind)))
            row.setToolTip(WHAT, f"{id_}: {', '.join(texts.named_by(annotation))}")
            if texts.size_text(annotation):
                row.setFlags(row.flags() | _Qt.ItemIsEditable)
            self._list.addTopLevelItem(row)

    def _judge(self, report: Report | None) -> None:
        """Write each annotation's residual; what disagrees in red."""
        bad = () if report is None else report.conflicts
        idle = self._idle()
        said = (self._listed, None if report is None else report.residuals, bad, idle)
        if said == self._judged:
            return
        self._judged = said
        for row in self._list.rows():
            id_ = row.data(WHAT, _ID)
            residual = None if report is None else report.residuals.get(id_)
            row.setText(OFF, texts.residual_text(residual))
            row.setTextAlignment(OFF, _Qt.AlignRight | _Qt.AlignVCenter)
            colour = self._colour(is_bad=id_ in bad)
            row.setToolTip(OFF, self._follows if id_ in idle else "")
            for column in (WHAT, SIZE, OFF):
                row.setForeground(column, colour)

    def _idle(self) -> frozenset[str]:
        """The annotations that follow from the others: in a complete sketch that is most of them,
        so that it is told by a tooltip and not by a colour."""
        from ...solver.diagnosis.redundancy import redundant_annotations

        view = None if self.controller is None else self.controller.tab.view
        lift = None if self.controller is None else self.controller.lift
        if view is None or lift is None or view.is_in_hand:
            return frozenset()
        if self._followed[0] is not lift[0]:
            self._followed = (lift[0], frozenset(redundant_annotations(*lift)))
        return self._followed[1]

    def _colour(self, *, is_bad: bool) -> QtGui.QBrush:
        palette = self.palette()
        if is_bad:
            dark = palette.color(QtGui.QPalette.Base).lightness() < 128
            return QtGui.QBrush(QtGui.QColor("#ff7b72" if dark else "#c01c28"))
        return QtGui.QBrush(palette.color(QtGui.QPalette.Text))

    def _say_the_rest(self) -> None:
        """How the solve went, suggestions, and the counts of parameters."""
        controller = self.controller
        self._status.setText("" if controller is None else controller.tab.outcome_with_links)
        suggestions = () if controller is None else controller.tab.view.suggestions
        one, all_of = "Take the suggestion (Y)", "Take all {} suggestions (Y)"
        words = host.translate("InContext", one if len(suggestions) == 1 else all_of)
        self._suggested.setText(words.format(len(suggestions)))
        self._suggested.setVisible(bool(suggestions))
        self._say_of_traced()
        counts = "" if controller is None else controller.parameter_words()
        self._counts.setText(counts)
        self._counts.setVisible(bool(counts))
        self._method.show_models(() if controller is None else controller.models)

    def _say_of_traced(self) -> None:
        """How well the lines that are traced on real things agree; each of them in the tooltip."""
        lift = None if self.controller is None else self.controller.lift
        words, each = ("", "") if lift is None else traced_texts.words_of(*lift)
        if self.controller is not None:
            words = f"{words} {self.controller.lens_watch.words}".strip()
        self._traced.setText(words)
        self._traced.setToolTip(each)
        self._traced.setVisible(bool(words))

    def _take_all(self) -> None:
        if self.controller is not None:
            self.controller.tab.view.take_suggestions()

    def _go(self, id_: str) -> None:
        if self.controller is not None:
            self.controller.tab.view.go_to(id_)

    # Both ways with the sketch

    def show_selection(self) -> None:
        """Mark the rows of what is selected in the sketch, or of what is said of it."""
        if self.controller is None:
            return
        chosen = self.controller.tab.view.selection
        graph = self._graph()
        marked = (chosen, () if graph is None else graph.annotations)
        if marked == self._marked:
            return
        self._marked = marked
        ids = chosen.annotations or said_of(graph, chosen)
        self._list.blockSignals(True)
        for row in self._list.rows():
            row.setSelected(row.data(WHAT, _ID) in ids)
        self._list.blockSignals(False)
        if self._list.selectedItems():
            self._list.scrollToItem(self._list.selectedItems()[0])

    def selected_ids(self) -> frozenset[str]:
        """The annotations whose rows are selected."""
        return frozenset(row.data(WHAT, _ID) for row in self._list.selectedItems())

    def _select_in_sketch(self) -> None:
        if self.controller is not None:
            self.controller.tab.view.select(Selection(annotations=self.selected_ids()))

    def delete_selected(self) -> None:
        """Take away the annotations whose rows are selected."""
        from ...solver.editing.elements import delete

        ids, graph = self.selected_ids(), self._graph()
        if self.controller is not None and graph is not None and ids:
            self.controller.tab.view.edit(delete(graph, annotations=ids), "Delete annotation")

    def _take_size(self, row: QtGui.QTreeWidgetItem, column: int) -> None:
        """Drive a length or a diameter by what was typed; what cannot be read is taken back."""
        graph, id_ = self._graph(), row.data(WHAT, _ID)
        if column != SIZE or graph is None or self.controller is None:
            return
        annotation = graph.annotations[id_]
        name = "length_mm" if hasattr(annotation, "length_mm") else "diameter_mm"
        try:
            changed = replace(annotation, **{name: parse_length(row.text(SIZE))})
        except ValueError as error:
            QtGui.QToolTip.showText(
                QtGui.QCursor.pos(), host.translate("InContext", str(error)), self._list
            )
            changed = annotation
        self._listed = ()
        larger = replace(graph, annotations={**graph.annotations, id_: changed})
        words = {"length_mm": "Set length", "diameter_mm": "Set diameter"}[name]
        self.controller.tab.view.edit(larger, words)
        # Not while the editor of the row is still open.
        self._soon.start(0)


class _List(QtGui.QTreeWidget):
    """The rows; Delete takes away what is selected."""

    delete_pressed = QtCore.Signal()

    def __init__(self) -> None:
        super().__init__()
        names = ("What is true", "Size", "Off")
        self.setHeaderLabels([host.translate("InContext", name) for name in names])
        self.setRootIsDecorated(False)
        self.setUniformRowHeights(True)
        self.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        self.setEditTriggers(
            QtGui.QAbstractItemView.DoubleClicked | QtGui.QAbstractItemView.EditKeyPressed
        )
        self.setItemDelegate(_SizeOnly(self))
        header = self.header()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(WHAT, QtGui.QHeaderView.Stretch)
        header.setSectionResizeMode(SIZE, QtGui.QHeaderView.ResizeToContents)
        header.setSectionResizeMode(OFF, QtGui.QHeaderView.ResizeToContents)

    def rows(self) -> list[QtGui.QTreeWidgetItem]:
        """All rows."""
        return [self.topLevelItem(k) for k in range(self.topLevelItemCount())]

    def event(self, event: QtCore.QEvent) -> bool:
        """Claim Delete: FreeCAD would delete the selected object."""
        is_ours = event.type() == QtCore.QEvent.ShortcutOverride
        if is_ours and event.key() in (_Qt.Key_Delete, _Qt.Key_Backspace):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:  # noqa: N802  Qt's name
        """Delete; else move about."""
        if event.key() in (_Qt.Key_Delete, _Qt.Key_Backspace):
            self.delete_pressed.emit()
        else:
            super().keyPressEvent(event)


class _SizeOnly(QtGui.QStyledItemDelegate):
    """Opens an editor over sizes alone."""

    def createEditor(self, parent, option, index):  # noqa: N802  Qt's name
        """See Qt."""
        return super().createEditor(parent, option, index) if index.column() == SIZE else None


def said_of(graph: SketchGraph | None, chosen: Selection) -> frozenset[str]:
    """The annotations that name something of what is selected."""
    from ...solver.annotations import targets_of

    if graph is None or not chosen:
        return frozenset()
    ids = chosen.vertices | chosen.edges | chosen.circles
    named = {
        id_: {target for targets in targets_of(a).values() for target in targets}
        for id_, a in graph.annotations.items()
    }
    return frozenset(id_ for id_, targets in named.items() if targets & ids)
