# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench. Each records calls of the public API, so that macros replay."""

import FreeCAD
import FreeCADGui


class Triangulate:
    """Adds a quality mesh of each selected object."""

    NAME = "MeshQuality_Triangulate"

    def GetResources(self):
        return {
            "Pixmap": self.NAME,
            "MenuText": "Quality mesh",
            "ToolTip": "Mesh the selected shapes with a guaranteed smallest angle",
        }

    def IsActive(self):
        return any(_has_shape(obj) for obj in FreeCADGui.Selection.getSelection())

    def Activated(self):
        document = FreeCAD.ActiveDocument
        sources = [o for o in FreeCADGui.Selection.getSelection() if _has_shape(o)]
        document.openTransaction("Quality mesh")
        try:
            FreeCADGui.doCommand("import MeshQuality as mq")
            for source in sources:
                FreeCADGui.doCommand(
                    f"mq.add_quality_mesh(App.getDocument({source.Document.Name!r})"
                    f".getObject({source.Name!r}))")
        except Exception as error:  # noqa: BLE001 - a command's last resort is the report view
            document.abortTransaction()
            FreeCAD.Console.PrintError(f"{error}\n")
            return
        document.commitTransaction()


def _has_shape(obj):
    return hasattr(obj, "Shape") or obj.hasExtension("App::GroupExtension") \
        or obj.TypeId == "App::Link"


def register():
    """Registers all commands with FreeCAD; returns their names in menu order."""
    commands = [Triangulate]
    for command in commands:
        FreeCADGui.addCommand(command.NAME, command())
    return [command.NAME for command in commands]
