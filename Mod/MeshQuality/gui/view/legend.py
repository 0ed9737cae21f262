# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend of the quality view: what it looks like, and which corner of the view it leaves free."""

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from ...core import colour_scale

translate = FreeCAD.Qt.translate

COLOURS, LABELS = 64, 5
_FEWER, _LOW = 3, 100  # labels of a bar that is lower than this, pixels
TOP_LEFT, TOP_RIGHT, BOTTOM_LEFT, BOTTOM_RIGHT = range(4)  # FreeCAD's numbers of the corners
_BAR, _HEIGHT, _MARGIN, _GAP = 18, 180, 8, 6  # pixels
_LEAST, _OF_VIEW = 50, 0.4  # pixels of a bar; of the height of a low view, so that the model is seen
# Light enough for dark text on whatever is behind it.
_PLATE, _INK = QtGui.QColor(250, 250, 250, 215), QtGui.QColor(20, 20, 20)
_CUBE, _AROUND_CUBE = 132, 1.3  # pixels of FreeCAD's cube at first; with its arrows and its menu


def picture(scale, view_height):
    """The legend of a quality_data.Scale: uint8 (height, width, 4), the first row at the bottom.

    view_height  height of the 3D view in pixels; the legend is lower in a low view
    """
    title = translate("MeshQuality", scale.measure.title)
    tall = min(_HEIGHT, max(_LEAST, round(_OF_VIEW * view_height)))  # height of the bar
    labels = [scale.text(number) for number in np.linspace(scale.low, scale.high, LABELS if tall >= _LOW else _FEWER)]
    font = QtGui.QApplication.font()
    metrics = QtGui.QFontMetrics(font)
    line = metrics.height()
    inner = max(_BAR + _GAP + max(map(metrics.horizontalAdvance, labels)), metrics.horizontalAdvance(title))
    below = 1.5 * line if scale.unbounded else 0.0  # room for infinite values
    width, height = inner + 2 * _MARGIN, tall + 2 * line + _GAP + 2 * _MARGIN + below
    ratio = FreeCADGui.getMainWindow().devicePixelRatioF()
    image = QtGui.QImage(round(width * ratio), round(height * ratio), QtGui.QImage.Format_RGBA8888)
    image.setDevicePixelRatio(ratio)
    image.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(image)
    painter.setFont(font)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(_PLATE)
    painter.drawRoundedRect(QtCore.QRectF(0, 0, width, height), 5, 5)
    painter.setPen(_INK)
    painter.drawText(QtCore.QRectF(_MARGIN, _MARGIN, inner, line), QtCore.Qt.AlignLeft, title)
    top = _MARGIN + 1.5 * line + _GAP  # top of the bar: labels are as high as a line, and stand beside the bar's ends
    _paint_bar(painter, scale, top, tall)
    for i, label in enumerate(labels):
        middle = top + tall * (1.0 - i / (len(labels) - 1))
        painter.drawText(QtCore.QRectF(_MARGIN + _BAR + _GAP, middle - 0.5 * line, inner, line),
                         QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter, label)
    if scale.unbounded:
        row = top + tall + line
        red, green, blue, _ = colour_scale.bytes_of(np.array([np.nan]))[0].tolist()
        painter.fillRect(QtCore.QRectF(_MARGIN, row, _BAR, line), QtGui.QColor(red, green, blue))
        painter.drawText(QtCore.QRectF(_MARGIN + _BAR + _GAP, row, inner, line),
                         QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter, scale.text(np.inf))
    painter.end()
    rows = np.frombuffer(image.constBits(), dtype=np.uint8).reshape(image.height(), image.width(), 4)
    return rows[::-1].copy()


def _paint_bar(painter, scale, top, tall):
    numbers = np.linspace(scale.low, scale.high, COLOURS)
    step = tall / COLOURS
    painter.save()
    painter.setRenderHint(QtGui.QPainter.Antialiasing, False)
    for i, (red, green, blue, _) in enumerate(colour_scale.bytes_of(scale.goodness(numbers)).tolist()):
        box = QtCore.QRectF(_MARGIN, top + tall - (i + 1) * step, _BAR, step + 1.0)
        painter.fillRect(box, QtGui.QColor(red, green, blue))
    painter.restore()


def corner_to_leave():
    """(corner, pixels): where FreeCAD shows its navigation cube, and how far it reaches; 0: nowhere."""
    view = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    cube = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/NaviCube")
    if not view.GetBool("ShowNaviCube", True):
        return TOP_RIGHT, 0
    # FreeCAD has kept the corner in either group.
    corner = cube.GetInt("CornerNaviCube", view.GetInt("CornerNaviCube", TOP_RIGHT))
    ratio = FreeCADGui.getMainWindow().devicePixelRatioF()
    return corner, round(_AROUND_CUBE * ratio * cube.GetInt("CubeSize", _CUBE))
