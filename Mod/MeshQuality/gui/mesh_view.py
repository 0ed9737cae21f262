# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the document objects behave in the tree and the 3D view: icon, and editing by double click."""

import os

import FreeCADGui

from ..compat import PlainState

ICONS = os.path.normpath(os.path.join(os.path.dirname(__file__), os.pardir, os.pardir, os.pardir,
                                      "Resources", "icons"))


class MeshView(PlainState):
    """Proxy of the view of a mesh object."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        """Called when the view is made, and when it is read from a file."""
        self.view = view

    def getIcon(self):
        """That of the command which adds such objects."""
        # A document that is being read has no proxy yet.
        command = getattr(self.view.Object.Proxy, "COMMAND", "MeshQuality")
        return os.path.join(ICONS, f"{command}.svg")

    def doubleClicked(self, view):
        """Opens the panel with the object's options."""
        return FreeCADGui.getDocument(view.Object.Document.Name).setEdit(view.Object.Name)

    def setEdit(self, view, mode=0):
        """Opens the panel; only the usual mode of editing is ours."""
        if mode != 0 or FreeCADGui.Control.activeDialog():
            return None
        from . import commands

        FreeCADGui.Control.showDialog(commands.panel_of(view.Object))
        return True

    def unsetEdit(self, view, mode=0):
        """Editing has ended: by the panel, or because the object is no more."""
        FreeCADGui.Control.closeDialog()
        return True
