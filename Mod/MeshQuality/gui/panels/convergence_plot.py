# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plot of the error over the unknowns, both axes logarithmic."""

import math

import FreeCAD
from PySide import QtCore, QtGui

translate = FreeCAD.Qt.translate

_HEIGHT = 180
_LEFT, _RIGHT, _TOP, _BOTTOM = 52, 12, 20, 34  # pixels around the axes
_POINT = 3.5


class ConvergencePlot(QtGui.QWidget):
    """Points joined by lines, powers of ten at the axes, and a dashed line at the target."""

    def __init__(self):
        super().__init__()
        self.setMinimumHeight(_HEIGHT)
        self._points, self._target = [], 0.0

    def show_steps(self, points, target):
        """Takes [(unknowns, relative error), ...] and the error that is asked for."""
        self._points = [(x, y) for x, y in points if x > 0 and y > 0]
        self._target = target
        self.update()

    def ranges(self):
        """(low, high) of log10 of the unknowns, and of the errors and the target."""
        logs = [math.log10(x) for x, _ in self._points]
        errors = [math.log10(y) for y in (*(y for _, y in self._points), self._target)]
        return tuple((low - 0.05 * max(high - low, 0.2), high + 0.05 * max(high - low, 0.2))
                     for low, high in ((min(logs), max(logs)), (min(errors), max(errors))))

    def place(self, unknowns, error):
        """Where a point is drawn."""
        (x0, x1), (y0, y1) = self.ranges()
        width, height = self.width() - _LEFT - _RIGHT, self.height() - _TOP - _BOTTOM
        return QtCore.QPointF(_LEFT + width * (math.log10(unknowns) - x0) / (x1 - x0),
                              _TOP + height * (y1 - math.log10(error)) / (y1 - y0))

    def paintEvent(self, _):
        if not self._points:
            return
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        colour = self.palette().color(QtGui.QPalette.WindowText)
        self._draw_axes(painter, colour)
        places = [self.place(*point) for point in self._points]
        painter.setPen(QtGui.QPen(QtGui.QColor(30, 110, 200), 2))
        painter.drawPolyline(QtGui.QPolygonF(places))
        painter.setBrush(QtGui.QColor(30, 110, 200))
        for place in places:
            painter.drawEllipse(place, _POINT, _POINT)
        painter.end()

    def _draw_axes(self, painter, colour):
        right, low = self.width() - _RIGHT, self.height() - _BOTTOM
        grid = QtGui.QColor(colour)
        grid.setAlpha(60)
        (x0, x1), (y0, y1) = self.ranges()
        for value in ticks(x0, x1):
            x = self.place(value, self._target).x()
            painter.setPen(grid)
            painter.drawLine(QtCore.QPointF(x, _TOP), QtCore.QPointF(x, low))
            painter.setPen(colour)
            painter.drawText(QtCore.QRectF(x - 40, low + 2, 80, 14), QtCore.Qt.AlignCenter, f"{value:,.0f}")
        for value in ticks(y0, y1):
            y = self.place(self._points[0][0], value).y()
            painter.setPen(grid)
            painter.drawLine(QtCore.QPointF(_LEFT, y), QtCore.QPointF(right, y))
            painter.setPen(colour)
            painter.drawText(QtCore.QRectF(0, y - 8, _LEFT - 5, 16), QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter, f"{100 * value:.3g} %")
        painter.drawRect(QtCore.QRectF(_LEFT, _TOP, right - _LEFT, low - _TOP))
        painter.drawText(QtCore.QRectF(_LEFT, low + 16, right - _LEFT, 16), QtCore.Qt.AlignCenter, translate("MeshQuality", "Unknowns"))
        painter.drawText(QtCore.QRectF(4, 0, right, 16), QtCore.Qt.AlignLeft, translate("MeshQuality", "Error"))
        painter.setPen(QtGui.QPen(QtGui.QColor(200, 60, 40), 1, QtCore.Qt.DashLine))
        y = self.place(self._points[0][0], self._target).y()
        painter.drawLine(QtCore.QPointF(_LEFT, y), QtCore.QPointF(right, y))


def ticks(low, high):
    """Round numbers whose log10 is between two others: 1, 2 and 5 times powers of ten, or these alone where there are many."""
    steps = (1, 2, 5) if high - low < 2 else (1,)
    found = [step * 10.0**power for power in range(math.floor(low), math.ceil(high) + 1) for step in steps]
    return [value for value in found if low <= math.log10(value) <= high]
