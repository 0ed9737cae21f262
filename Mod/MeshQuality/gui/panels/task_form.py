# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common base of forms of task panels: their messages are in sight, and they close with their document."""

import FreeCAD
from PySide import QtCore, QtGui

_ERROR = "border: 1px solid #cc0000; padding: 4px"
_MARGIN = 20  # pixels that FreeCAD's task view has below a form, and some more
_ARROW = 21  # pixels that the arrow of a box with choices takes from its text
_LINES = 4  # of text that a part must have room for to scroll by itself


class Message(QtGui.QLabel):
    """A sentence for the user, with a red frame where it is an error; hidden without one."""

    def __init__(self):
        super().__init__()
        self.setWordWrap(True)
        self.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self.hide()

    def say(self, text, error=False, scroll=True):
        """Shows another sentence, where the user sees it; without scrolling while options are edited."""
        self.setText(text)
        self.setStyleSheet(_ERROR if error else "")
        self.setVisible(bool(text))
        if text and scroll:
            bring_into_sight(self)


def narrow(widget, rules):
    """Gives a widget rules of its own where the whole window has a style sheet, as FreeCAD's dark ones, mostly to take room from it that
    the task view does not have at first; without such a sheet nothing is changed.
    """
    if QtGui.QApplication.instance().styleSheet():
        widget.setStyleSheet(rules)


def keep_choices(box):
    """Keeps room in a box for the longest of its texts beside its arrow: style sheets give boxes a least width, which counts
    instead of that of their texts.
    """
    longest = max(box.fontMetrics().horizontalAdvance(box.itemText(i)) for i in range(box.count()))
    narrow(box, f"QComboBox {{ min-width: {longest + _ARROW}px }}")


def narrow_buttons(box):
    """Takes room from FreeCAD's buttons below a panel; FreeCAD calls this as modifyStandardButtons."""
    narrow(box, "QPushButton { padding: 4px 8px; margin: 4px 2px }")


def bring_into_sight(widget):
    """Has the task view, which is one long page, scroll to a widget once that has its place."""
    QtCore.QTimer.singleShot(0, lambda: is_in_task_view(widget) and _scroll_to(widget))


def is_in_task_view(widget):
    """Whether it is a part of a panel that FreeCAD shows; None is none."""
    # Not asked by parentWidget(): PySide would have the widget's Python object end with that of its parent.
    try:
        return widget is not None and widget.window() is not widget
    except RuntimeError:  # FreeCAD has closed the panel by itself, and deleted what it showed
        return False


def _scroll_to(widget):
    for area in widget.window().findChildren(QtGui.QScrollArea):
        if area.isAncestorOf(widget) and widget.isVisible():
            area.ensureWidgetVisible(widget)


class Table(QtGui.QTableWidget):
    """A table with headers of its own. Qt's own ones may come to Python as what stood in their place in memory before, such as
    FreeCAD's buttons (PySide2 of Debian 13): calls to them fail or crash.
    """

    def __init__(self, rows, columns):
        super().__init__(rows, columns)
        for direction, take in ((QtCore.Qt.Horizontal, self.setHorizontalHeader), (QtCore.Qt.Vertical, self.setVerticalHeader)):
            header = QtGui.QHeaderView(direction, self)
            header.setSectionsClickable(True)
            header.setHighlightSections(True)
            take(header)


class Form(QtGui.QWidget):
    """The page of a panel. The mouse wheel over a field scrolls the page; it turns a value only where the field has the
    focus. Return in a field or a list ends with the field: FreeCAD's task view would take it for OK, which may begin work of
    minutes; Ctrl+Return does that.
    """

    def keyPressEvent(self, event):
        """Called by Qt with what a field has not used."""
        is_return = event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter)
        if is_return and not event.modifiers() & QtCore.Qt.ControlModifier:
            event.accept()
        else:
            super().keyPressEvent(event)

    def showEvent(self, event):
        """Called by Qt, once all fields are there."""
        for kind in (QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QSlider):
            for field in self.findChildren(kind):
                field.setFocusPolicy(QtCore.Qt.StrongFocus)  # not by the wheel
                field.installEventFilter(self)
        for box in self.findChildren(QtGui.QComboBox):  # whose list FreeCAD's dark style sheets leave white in task panels, with light text
            box.ensurePolished()
            narrow(box.view(), f"background-color: {box.palette().color(QtGui.QPalette.Button).name()}")
        super().showEvent(event)

    def eventFilter(self, field, event):
        """Called by Qt with what is sent to a field; ignored, the wheel goes on to what is around it."""
        if event.type() != QtCore.QEvent.Wheel or field.hasFocus():
            return False
        event.ignore()
        return True


class Scrolled(QtGui.QScrollArea):
    """The lowest part of a form. It is as high as the fields in it, and scrolls by itself where the task view has less room than
    that: FreeCAD's buttons and what tells of the work, which are above it, stay in sight.
    """

    def __init__(self, fields):
        super().__init__()
        self._task_view = None
        self._later = QtCore.QTimer(self)  # not while the layout around is at work, which would not see another height
        self._later.setSingleShot(True)
        self._later.setInterval(0)
        self._later.timeout.connect(self._fit)
        self.setFrameShape(QtGui.QFrame.NoFrame)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setWidget(fields)
        for part in (self.viewport(), fields):
            part.setAutoFillBackground(False)

    def minimumSizeHint(self):
        """Called by Qt: there is no bar to reach what would be too wide."""
        bar = 0 if self._needed() <= self.maximumHeight() else self.verticalScrollBar().sizeHint().width()
        return QtCore.QSize(self.widget().minimumSizeHint().width() + bar, self.minimumHeight())

    def sizeHint(self):
        """Called by Qt."""
        return QtCore.QSize(self.widget().sizeHint().width(), self._needed())

    def showEvent(self, event):
        """Called by Qt, in the task view."""
        super().showEvent(event)
        self._task_view = next((area for area in self.window().findChildren(QtGui.QScrollArea) if area.isAncestorOf(self)), None)
        if self._task_view is not None:
            self._task_view.viewport().installEventFilter(self)
        self._later.start()

    def moveEvent(self, event):
        """Called by Qt where what is above gets more or less."""
        super().moveEvent(event)
        self._later.start()

    def resizeEvent(self, event):
        """Called by Qt: lines break elsewhere in another width."""
        super().resizeEvent(event)
        self._later.start()

    def eventFilter(self, watched, event):
        """Called by Qt where the fields need another height, or the task view gets one."""
        done = super().eventFilter(watched, event)
        if event.type() in (QtCore.QEvent.LayoutRequest, QtCore.QEvent.Resize):
            self._later.start()
        return done

    def _needed(self):
        fields, width = self.widget(), self.viewport().width()
        layout = fields.layout()
        return layout.heightForWidth(width) if layout.hasHeightForWidth() and self.isVisible() else fields.sizeHint().height()

    def _fit(self):
        if self._task_view is not None:
            needed, room = self._needed(), self._room()
            # Too little to scroll in: then the task view scrolls all, and there is one bar.
            height = min(needed, room) if room >= _LINES * self.fontMetrics().height() else needed
            if height != self.maximumHeight():
                self.setFixedHeight(height)

    def _room(self):
        """Pixels between what is above and the lower end of the task view."""
        view = self._task_view
        return view.viewport().height() - self.mapTo(view.viewport(), QtCore.QPoint()).y() - view.verticalScrollBar().value() - _MARGIN


class ClosesWithDocument:
    """Closes a panel that FreeCAD shows once its document is closed; `end` with the panel.

    document  name
    close     close(), called where the document goes and the panel is still shown
    """

    def __init__(self, document, form, close):
        self._document, self._form, self._close = document, form, close
        self._active = True
        FreeCAD.addDocumentObserver(self)

    def end(self):
        """Stops watching."""
        if self._active:
            self._active = False
            FreeCAD.removeDocumentObserver(self)

    def slotDeletedDocument(self, document):
        """Called by FreeCAD."""
        if document.Name == self._document:
            self.end()
            if is_in_task_view(self._form):
                self._close()
