# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench. Each opens its task panel for what is selected."""

import FreeCADGui

from .. import convert, options
from ..api import triangulate
from ..features import boolean, curved_mesh, quality_mesh
from . import quality_panel
from .mesh_panel import MeshPanel, Operation


class _Command:
    """A subclass has NAME, TEXT (also of the undo step), TIP, and operations(selected objects)."""

    def GetResources(self):
        return {"Pixmap": self.NAME, "MenuText": self.TEXT + "...", "ToolTip": self.TIP}

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and bool(self.selected())

    def Activated(self):
        FreeCADGui.Control.showDialog(MeshPanel(self.operations(self.selected())))

    def selected(self):
        """The selected objects that the command is for; none when it cannot be used."""
        return [obj for obj in FreeCADGui.Selection.getSelection() if _has_shape(obj)]


class _MeshCommand(_Command):
    """Adds a mesh of each selected object with a shape.

    A subclass also has PROXY and CALL, the function of the API that adds one.
    """

    def operations(self, selected):
        return [self._operation(source) for source in selected]

    def trial(self, source):
        """Estimates the number of triangles; None: that would take as long as the work itself."""
        return None

    def _operation(self, source):
        table = self.PROXY.OPTIONS
        return Operation(
            self.TEXT, table, [source], lambda values: self.PROXY.work_on(source, values),
            lambda values: f"mq.{self.CALL}({_name(source)}{_arguments(table, values)})",
            self.trial(source))


class Triangulate(_MeshCommand):
    NAME = "MeshQuality_Triangulate"
    TEXT = "Quality mesh"
    TIP = "Mesh the selected shapes with a guaranteed smallest angle"
    CALL = "add_quality_mesh"
    PROXY = quality_mesh.QualityMesh

    def trial(self, source):
        def prepare(values, most):
            shape = convert.shape_of(source)
            limit = min(most, values["max_triangles"] or most)

            def compute(progress):
                report = triangulate(shape, **{**values, "max_triangles": limit},
                                     progress=progress).report
                return report.triangles, report.complete or limit == values["max_triangles"]

            return compute

        return prepare


class Curve(_MeshCommand):
    NAME = "MeshQuality_Curve"
    TEXT = "Curved mesh"
    TIP = "Mesh the selected shapes with curved elements, each proven to be free of folds"
    CALL = "add_curved_mesh"
    PROXY = curved_mesh.CurvedMeshObject


class Boolean(_Command):
    NAME = "MeshQuality_Boolean"
    TEXT = "Mesh Boolean"
    TIP = "Join, intersect or subtract the selected meshes and shapes, in the order of selection"

    def selected(self):
        found = [obj for obj in FreeCADGui.Selection.getSelection()
                 if _has_shape(obj) or obj.isDerivedFrom("Mesh::Feature")]
        one_document = len({obj.Document for obj in found}) == 1
        return found if len(found) > 1 and one_document else []

    def operations(self, selected):
        names = ", ".join(map(_name, selected))
        return [Operation(
            self.TEXT, options.BOOLEAN, selected,
            lambda values: boolean.MeshBoolean.work_on(selected, values),
            lambda values: f"mq.add_boolean([{names}]{_arguments(options.BOOLEAN, values)})")]


class Analyse(_Command):
    NAME = "MeshQuality_Analyse"
    TEXT = "Analyse quality"
    TIP = "Colour the selected mesh by its quality and find its worst elements"

    def Activated(self):
        quality_panel.open_panel(self.selected()[0])

    def selected(self):
        found = FreeCADGui.Selection.getSelection()
        return found if len(found) == 1 and found[0].isDerivedFrom("Mesh::Feature") else []


def _name(obj):
    """The object, in Python."""
    return f"App.getDocument({obj.Document.Name!r}).getObject({obj.Name!r})"


def _arguments(table, values):
    """Those values that are not the default, as arguments in Python."""
    defaults = {option.name: option.default for option in table}
    return "".join(f", {name}={value!r}" for name, value in values.items()
                   if value != defaults[name])


def _has_shape(obj):
    return hasattr(obj, "Shape") or obj.hasExtension("App::GroupExtension") \
        or obj.TypeId == "App::Link"


def register():
    """Registers all commands with FreeCAD; returns their names in menu order."""
    commands = [Triangulate, Curve, Boolean, Analyse]
    for command in commands:
        FreeCADGui.addCommand(command.NAME, command())
    return [command.NAME for command in commands]
