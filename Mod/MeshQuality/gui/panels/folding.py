# SPDX-License-Identifier: LGPL-2.1-or-later
"""What panels fold away."""

from PySide import QtCore, QtGui

from .. import preferences
from .task_form import narrow


def fold_button(title, content, name):
    """A button that shows and hides a widget, which begins as the user left it; `name` is under what that is kept."""
    button = QtGui.QToolButton()
    button.setText(title)
    button.setCheckable(True)
    button.setAutoRaise(True)
    button.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
    narrow(button, "padding: 0px; margin: 0px")

    def show(shown):
        button.setArrowType(QtCore.Qt.DownArrow if shown else QtCore.Qt.RightArrow)
        content.setVisible(shown)

    button.toggled.connect(show)
    show(False)
    button.setChecked(preferences.is_open(name))
    button.clicked.connect(lambda is_open: preferences.keep_open(name, is_open))
    return button
