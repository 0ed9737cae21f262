# SPDX-License-Identifier: LGPL-2.1-or-later
"""A histogram whose bars can be picked."""

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from ...core import colour_scale
from ..quantities import count_text

translate = FreeCAD.Qt.translate

_HEIGHT = 90
_AXIS = 16  # pixels for the numbers below


class HistogramView(QtGui.QWidget):
    """Bars in the colours of the scale; heights are logarithmic, as few bad ones matter most."""

    picked = QtCore.Signal(int, int)  # the first and the last bar; -1: none any more

    def __init__(self):
        super().__init__()
        self.setMinimumHeight(_HEIGHT)
        self.setMouseTracking(True)
        self._histogram = self._scale = self._colours = None
        self.chosen = self.last = -1
        self._pressed = -1  # the place of the bar from which the mouse is drawn

    def show_histogram(self, histogram, scale):
        """Takes a quality_data.Histogram and the Scale of its values."""
        self._histogram, self._scale = histogram, scale
        self.chosen = self.last = self._pressed = -1
        edges = histogram.edges()
        goodness = scale.goodness(0.5 * (edges[1:] + edges[:-1]))
        self._colours = [QtGui.QColor(*map(int, rgb)) for rgb in colour_scale.bytes_of(goodness)]
        self.update()

    @property
    def counts(self):
        """How many elements each bar stands for."""
        return self._histogram.counts

    def pick(self, bar, last=None):
        """Chooses a bar, those from one to another, or none by -1."""
        self.chosen, self.last = bar, bar if last is None else last
        self.update()
        self.picked.emit(self.chosen, self.last)

    def words(self, bar, last=None):
        """The range of values of a bar, or of several bars in a row."""
        last = bar if last is None else last
        edges, count = self._histogram.edges(), int(self._histogram.counts[bar:last + 1].sum())
        low, high = self._scale.text(edges[bar]), self._scale.text(edges[last + 1])
        end = len(self._histogram.counts) - 1
        if (bar == 0) != (last == end):
            words = translate("MeshQuality", "{0} below {1}") if bar == 0 \
                else translate("MeshQuality", "{0} above {1}")
            return words.format(count_text(count), high if bar == 0 else low)
        words = translate("MeshQuality", "{0} from {1} to {2}")
        return words.format(count_text(count), low, high)

    def _place_at(self, x):
        return int(np.clip(x * len(self._colours) / max(self.width(), 1), 0, len(self._colours) - 1))

    def bar_at(self, x):
        """The bar at a place in pixels; -1 when it is empty."""
        if self._histogram is None:
            return -1
        bar = self._place_at(x)
        return bar if self._histogram.counts[bar] else -1

    def mousePressEvent(self, event):
        bar = self.bar_at(event.pos().x())
        self._pressed = self._place_at(event.pos().x()) if self._histogram is not None else -1
        self.pick(-1 if bar == self.chosen == self.last else bar)

    def mouseMoveEvent(self, event):
        """Drawn over several bars with a button down, it chooses all of them."""
        if event.buttons() & QtCore.Qt.LeftButton and self._pressed >= 0:
            first, last = sorted((self._pressed, self._place_at(event.pos().x())))
            if first != last and (first, last) != (self.chosen, self.last):
                self.pick(first, last)
            return
        bar = self.bar_at(event.pos().x())
        self.setToolTip(self.words(bar) if bar >= 0 else "")

    def paintEvent(self, _):
        if self._histogram is None:
            return
        painter = QtGui.QPainter(self)
        counts = self._histogram.counts
        width, height = self.width() / len(counts), self.height() - _AXIS
        tall = np.log1p(counts) / max(np.log1p(counts.max()), 1e-12)
        for bar, part in enumerate(tall):
            if counts[bar]:
                high = max(2.0, part * (height - 2))
                box = QtCore.QRectF(bar * width, height - high, max(width - 1, 1.0), high)
                painter.fillRect(box, self._colours[bar])
                if self.chosen <= bar <= self.last:
                    painter.setPen(QtGui.QPen(QtGui.QColor(255, 32, 255), 2))
                    painter.drawRect(box)
        painter.setPen(self.palette().color(QtGui.QPalette.WindowText))
        row = QtCore.QRectF(0, height, self.width(), _AXIS)
        ends = QtCore.Qt.AlignLeft, QtCore.Qt.AlignRight
        for number, side in zip((self._histogram.low, self._histogram.high), ends):
            painter.drawText(row, side | QtCore.Qt.AlignBottom, self._scale.text(number))
        painter.end()
