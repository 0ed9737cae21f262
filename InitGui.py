# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD executes this file inside a function: its methods see none of the names defined here.
import os

import FreeCADGui
import MeshQuality
from MeshQuality.gui import preferences, translation


class MeshQualityWorkbench(FreeCADGui.Workbench):
    def Initialize(self):
        # FreeCAD would load this with the first mesh, which would stop the window then.
        import MeshGui  # noqa: F401
        from MeshQuality.gui import commands

        for title, names in commands.register():
            self.appendMenu(["Mesh Quality", title] if title else ["Mesh Quality"], names)
        for title, names in commands.toolbars():
            self.appendToolbar(title, names)

    def ContextMenu(self, recipient):
        from MeshQuality.gui import commands

        fitting = commands.fitting()
        if fitting:
            self.appendContextMenu("", fitting)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


_resources = os.path.normpath(os.path.join(
    os.path.dirname(MeshQuality.__file__), os.pardir, os.pardir, "Resources"))
MeshQualityWorkbench.MenuText = translation.of_workbench("Mesh Quality")
MeshQualityWorkbench.ToolTip = translation.of_workbench("Meshes of CAD shapes with guaranteed quality")
MeshQualityWorkbench.Icon = os.path.join(_resources, "icons", "MeshQuality.svg")
FreeCADGui.addIconPath(os.path.join(_resources, "icons"))
FreeCADGui.addLanguagePath(os.path.join(_resources, "translations"))
FreeCADGui.updateLocale()
for _page in ("preferences.ui", "preferences_files.ui"):
    FreeCADGui.addPreferencePage(os.path.join(_resources, "ui", _page), "Mesh Quality")
preferences.limit_threads()
FreeCADGui.addWorkbench(MeshQualityWorkbench())
