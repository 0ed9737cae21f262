# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench. Each records calls of the public API, so that macros replay."""

import FreeCAD
import FreeCADGui


class _AddMesh:
    """Adds a mesh of each selected object with a shape, as one undo step.

    A subclass has NAME, TEXT (also of the undo step), TIP, and CALL: the function of the API.
    """

    def GetResources(self):
        return {"Pixmap": self.NAME, "MenuText": self.TEXT, "ToolTip": self.TIP}

    def IsActive(self):
        return any(_has_shape(obj) for obj in FreeCADGui.Selection.getSelection())

    def Activated(self):
        document = FreeCAD.ActiveDocument
        sources = [o for o in FreeCADGui.Selection.getSelection() if _has_shape(o)]
        document.openTransaction(self.TEXT)
        try:
            FreeCADGui.doCommand("import MeshQuality as mq")
            for source in sources:
                FreeCADGui.doCommand(
                    f"mq.{self.CALL}(App.getDocument({source.Document.Name!r})"
                    f".getObject({source.Name!r}))")
        except Exception as error:  # noqa: BLE001 - a command's last resort is the report view
            document.abortTransaction()
            FreeCAD.Console.PrintError(f"{error}\n")
            return
        document.commitTransaction()


class Triangulate(_AddMesh):
    NAME = "MeshQuality_Triangulate"
    TEXT = "Quality mesh"
    TIP = "Mesh the selected shapes with a guaranteed smallest angle"
    CALL = "add_quality_mesh"


class Curve(_AddMesh):
    NAME = "MeshQuality_Curve"
    TEXT = "Curved mesh"
    TIP = "Mesh the selected shapes with curved elements, each proven to be free of folds"
    CALL = "add_curved_mesh"


def _has_shape(obj):
    return hasattr(obj, "Shape") or obj.hasExtension("App::GroupExtension") \
        or obj.TypeId == "App::Link"


def register():
    """Registers all commands with FreeCAD; returns their names in menu order."""
    commands = [Triangulate, Curve]
    for command in commands:
        FreeCADGui.addCommand(command.NAME, command())
    return [command.NAME for command in commands]
