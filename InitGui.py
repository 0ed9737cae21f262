# SPDX-License-Identifier: LGPL-2.1-or-later
import os

import FreeCADGui
import MeshQuality

_ICONS = os.path.join(
    os.path.dirname(MeshQuality.__file__), os.pardir, os.pardir, "Resources", "icons")


class MeshQualityWorkbench(FreeCADGui.Workbench):
    MenuText = "Mesh Quality"
    ToolTip = "Meshes of CAD shapes with guaranteed quality"
    Icon = os.path.join(_ICONS, "MeshQuality.svg")

    def Initialize(self):
        from MeshQuality.gui import commands

        FreeCADGui.addIconPath(self.__class__.icons)
        names = commands.register()
        self.appendToolbar("Mesh Quality", names)
        self.appendMenu("Mesh Quality", names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


MeshQualityWorkbench.icons = _ICONS
FreeCADGui.addWorkbench(MeshQualityWorkbench())
