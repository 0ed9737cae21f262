# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the document objects behave in the tree and the 3D view: icon with a badge where the mesh
misses a requested limit, is out of date or could not be computed, editing by double click, the context menu.
"""

import FreeCAD
import FreeCADGui
from PySide import QtCore

from ..compat import PlainState
from ..features import mesh_object
from . import visibility, patch_colours
from .panel_operation import is_there
from .view import badge

translate = FreeCAD.Qt.translate

# The number of triangles that are drawn, by the property that holds the mesh; an edge belongs to two.
_TRIANGLES = {"Mesh": lambda obj: obj.Mesh.CountFacets, "FemMesh": lambda obj: obj.FemMesh.FaceCount}
_EDGES_OF_TRIANGLE = 1.5


class MeshView(PlainState):
    """Proxy of the view of a mesh object."""

    _has_colours = False  # whether the mesh is drawn in the colours of its patches
    _colours_wait = False  # whether the colours of patches are about to be drawn
    _drawn = 0  # number of triangles of its last mesh that was not empty

    def __init__(self, view):
        self.view = view  # FreeCAD 1.0 attaches no proxy that comes after the view
        view.Proxy = self

    def attach(self, view):
        """Called when the view is made, and when it is read from a file."""
        self.view = view

    def getIcon(self):
        """The icon of the command that adds such objects, as the path of a file or as a picture."""
        obj = self.view.Object
        # A document that is being read has no proxy yet.
        icon = getattr(obj.Proxy, "COMMAND", "MeshQuality")
        found = badge.badge_of(obj)
        return badge.with_badge(icon, found) if found else badge.path_of(icon)

    def updateData(self, obj, name):
        """A property of the object has changed."""
        if name in ("Certificate", "Status"):
            obj.ViewObject.signalChangeIcon()
        if name == "Mesh" and obj.Mesh.CountFacets > 0:
            before, self._drawn = self._drawn, obj.Mesh.CountFacets
            visibility.follow_count(obj.ViewObject, before, self._drawn)
        if name in _TRIANGLES and _TRIANGLES[name](obj):
            from .view import edge_detail  # imports Coin

            edge_detail.thin_out(obj.ViewObject.RootNode, _EDGES_OF_TRIANGLE * _TRIANGLES[name](obj))
        if name in ("Mesh", "Patches", "PatchRest"):
            self._colour_later(obj)

    def onChanged(self, view, name):
        """A property of the view has changed."""
        if name == "ShapeColor":
            self._colour_later(view.Object)

    def _colour_later(self, obj):
        """Shows patches in colour once FreeCAD has drawn the change, which takes their colours away."""
        if not self._colours_wait and isinstance(getattr(obj, "Proxy", None), mesh_object.SegmentedMesh):
            self._colours_wait, document = True, obj.Document.Name
            QtCore.QTimer.singleShot(0, lambda: self._colour(document, obj))

    def _colour(self, document, obj):
        self._colours_wait = False
        if not is_there(document, obj):
            return
        before, self._has_colours = self._has_colours, patch_colours.show_on_mesh(obj)
        if before and not self._has_colours:
            obj.ViewObject.Coloring = False  # back to the one colour of the view

    def doubleClicked(self, view):
        """Opens the panel with the object's options."""
        return FreeCADGui.getDocument(view.Object.Document.Name).setEdit(view.Object.Name)

    def setEdit(self, view, mode=0):
        """Opens the panel, unless another one is open; only the usual mode of editing is ours."""
        if mode != 0:
            return None
        if FreeCADGui.Control.activeDialog():
            return False
        from . import commands

        FreeCADGui.Control.showDialog(commands.panel_of(view.Object))
        return True

    def unsetEdit(self, view, mode=0):
        """Editing has ended: by the panel, or because the object is no more."""
        FreeCADGui.Control.closeDialog()
        return True

    def setupContextMenu(self, view, menu):
        """Called by FreeCAD for the menu of the object in the tree."""
        from . import background_recompute
        from .update import update_in_background

        if background_recompute.is_computing(view.Object):
            menu.addAction(translate("MeshQuality", "Stop computing"),
                           lambda: background_recompute.stop(view.Object))
        menu.addAction(translate("MeshQuality", "Edit options"), lambda: self.doubleClicked(view))
        # The workbench's own menu has this already.
        if FreeCADGui.activeWorkbench().name() != "MeshQualityWorkbench":
            menu.addAction(translate("MeshQuality", "Update mesh"),
                           lambda: update_in_background(view.Object))


class _Observer:
    """Has the sources of a mesh seen again when that is deleted, by a command or by a script."""

    def slotDeletedObject(self, obj):
        """Called by FreeCAD while the object still is in its document."""
        document = obj.Document
        # Undo and redo do that by themselves; nothing was hidden for a mesh that was never computed.
        if document.Transacting or document.Restoring or not getattr(obj, "Fingerprint", ""):
            return
        for source in visibility.sources_of(obj):
            source.ViewObject.Visibility = True


FreeCAD.addDocumentObserver(_Observer())
