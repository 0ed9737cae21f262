# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench. Each opens its task panel for what is selected."""

from functools import partial

import FreeCAD
import FreeCADGui
import Part

from ..compat import why_no_extension
from ..core.curving import holds_elements
from ..core.inspect.deviation import has_points
from ..core.sources import convert, frames
from ..errors import Error
from ..features import (adapted_mesh, boolean, cam_mesh, cfd, cured_mesh, curved_mesh, deviation, export, fem_mesh, flow_mesh, hollow, improved_mesh, inspection,
                        mesh_object, offset, quality_mesh, repaired_mesh, simplified_mesh, wrap)
from . import help_pages, quality_data, saving
from .panel_operation import Operation, name_of
from .panels import quality_panel
from .panels.adapt_panel import AdaptPanel
from .panels.binary_panel import BinaryPanel
from .panels.case_panel import CasePanel
from .panels.export_panel import ExportPanel
from .panels.flow_panel import FlowPanel
from .panels.mesh_panel import MeshPanel
from .panels.patches_panel import PatchesPanel
from .panels.repair_panel import RepairPanel
from .panels.solid_panel import SolidPanel
from .quantities import text_of
from .selection import picked_faces, select
from .translation import translated
from .triangle_estimate import FemTrial, FlowTrial, Trial
from .update import update_in_background

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class _Command:
    """A subclass has NAME, TEXT (also of the undo step), TIP, NEEDS, what is to be selected, KEYS, KIND, the class of the objects
    that it adds, if any, and ASKS, whether it opens a panel.
    """

    KIND = None
    NEEDS = ""
    ASKS = True

    def GetResources(self):
        return {"Pixmap": self.NAME, "MenuText": self.TEXT + ("..." if self.ASKS else ""),
                "ToolTip": "\n".join(filter(None, (self.TIP, self.NEEDS))), "Accel": self.KEYS}

    def IsActive(self):
        return not why_no_extension() and not FreeCADGui.Control.activeDialog() \
            and bool(self.selected())

    def Activated(self):
        FreeCADGui.Control.showDialog(self.panel(self.operations(self.selected())))

    def panel(self, operations, **values):
        """The panel for operations, with further arguments as MeshPanel has them."""
        return MeshPanel(operations, **values)

    def selected(self):
        """The selected objects that the command applies to; none when it cannot be used."""
        return [source for source in _selected() if _has_shape(source)]

    def operations(self, selected):
        """The operations of the panel: here, a mesh of each object."""
        return [Operation(self.TEXT, self.KIND, [source], self.trial([source]))
                for source in selected]

    def editing(self, obj):
        """The operation of the panel that edits an existing object."""
        return Operation.of_object(self.TEXT, obj, self.trial(obj.Proxy.sources(obj)))

    def trial(self, sources):
        """Estimates the number of triangles or elements; None: that would take as long as the work itself."""
        return None


class _OfOne(_Command):
    """Opens PANEL, a class, for the one object that is selected."""

    PANEL = None

    def Activated(self):
        FreeCADGui.Control.showDialog(self.PANEL(self.selected()[0]))


class Triangulate(_Command):
    KIND = quality_mesh.QualityMesh
    NAME = KIND.COMMAND
    TEXT = "Quality mesh"
    TIP = "Mesh the selected shapes with a guaranteed smallest angle"
    NEEDS = "Select one or more shapes first."
    KEYS = "Q, M"

    def trial(self, sources):
        return partial(Trial, self.KIND, sources)


class Quick(Triangulate):
    NAME = "MeshQuality_Quick"
    TEXT = "Quick mesh"
    TIP = "Mesh the selected shape at once, with the values used last, and show its quality in colour"
    NEEDS = "Select one shape first."
    KEYS = "Q, Q"
    ASKS = False

    def Activated(self):
        panel = MeshPanel(Triangulate().operations(self.selected()),
                          afterwards=quality_panel.open_panel)
        FreeCADGui.Control.showDialog(panel)
        panel.accept()

    def selected(self):
        return _if_one(_has_shape)


class Curve(_Command):
    KIND = curved_mesh.CurvedMeshObject
    NAME = KIND.COMMAND
    TEXT = "Curved mesh"
    TIP = "Mesh the selected shapes with curved elements, each proven valid"
    NEEDS = "Select one or more shapes first."
    KEYS = "Q, C"


class FemMesh(_Command):
    KIND = fem_mesh.FemMeshObject
    NAME = KIND.COMMAND
    TEXT = "FEM mesh"
    TIP = "Mesh the selected shapes for FreeCAD's FEM workbench, in the active analysis"
    NEEDS = "Select one or more shapes first."
    KEYS = "Q, F"

    def trial(self, sources):
        return partial(FemTrial, self.KIND, sources)

    def selected(self):
        # An analysis may be selected beside the shapes, to say where the mesh belongs.
        return [source for source in super().selected() if not fem_mesh.is_analysis(frames.leaf_of(source))]


class FlowMesh(_Command):
    KIND = flow_mesh.FlowMeshObject
    NAME = KIND.COMMAND
    TEXT = "Flow mesh"
    TIP = "Fill the selected solid, or the space around it, for flow solvers, with layers of prisms on walls"
    NEEDS = "Select one or more solids first, or faces of one that are walls."
    KEYS = "Q, X"

    def trial(self, sources):
        return partial(FlowTrial, self.KIND, sources)

    def panel(self, operations, **values):
        return FlowPanel(operations, **values)

    def operations(self, selected):
        return _with_faces(self, selected, "walls")


class Cure(_Command):
    KIND = cured_mesh.CuredMeshObject
    NAME = KIND.COMMAND
    TEXT = "Certify and cure"
    TIP = "Prove which elements of the selected FEM mesh are valid, and make those valid that are not, on its part"
    NEEDS = "Select one FEM mesh first, and its part where it does not name it."
    KEYS = "Q, V"

    def selected(self):
        """The part and the FEM mesh: the selected part, else the part that the mesh names."""
        found = [source for source in _selected() if not fem_mesh.is_analysis(frames.leaf_of(source))]
        meshes = [source for source in found if cured_mesh.has_fem_mesh(source)]
        parts = [source for source in found if source not in meshes and _has_shape(source)]
        if len(meshes) != 1 or len(found) > 2:
            return []
        part = parts[0] if parts else cured_mesh.part_of(meshes[0])
        return [] if part is None else [part, meshes[0]]

    def operations(self, selected):
        return [Operation(self.TEXT, self.KIND, selected)]


class Adapt(_OfOne):
    PANEL = AdaptPanel
    NAME = "MeshQuality_Adapt"
    TEXT = "Adapt mesh"
    TIP = "Refine the FEM mesh of the selected analysis where the error of its solution is, step by step, solved by CalculiX"
    NEEDS = "Select an analysis with a FEM mesh of MeshQuality, or that mesh, first."
    KEYS = "Q, Y"

    def selected(self):
        """The analysis: selected itself, or that of the selected mesh."""
        found = [frames.linked_of(source)[0] for source in _selected()]
        analyses = {obj if fem_mesh.is_analysis(obj) else fem_mesh.analysis_around(obj) for obj in found}
        return [obj for obj in analyses if obj is not None and adapted_mesh.mesh_of_analysis(obj) is not None] if len(analyses) == 1 else []


class Boolean(_Command):
    KIND = boolean.MeshBoolean
    NAME = KIND.COMMAND
    TEXT = "Mesh Boolean"
    TIP = "Unite, intersect or subtract the selected meshes and shapes, in the order of selection"
    NEEDS = "Select two or more meshes or shapes first."
    KEYS = "Q, B"

    def selected(self):
        found = [source for source in _selected() if _has_shape(source) or convert.is_mesh(source)]
        one_document = len({frames.object_of(source).Document for source in found}) == 1
        return found if len(found) >= self.KIND.LEAST and one_document else []

    def operations(self, selected):
        return [Operation(self.TEXT, self.KIND, selected)]


class Offset(_Command):
    KIND = offset.OffsetObject
    NAME = KIND.COMMAND
    TEXT = "Offset"
    TIP = "Grow or shrink the selected solids by a distance; of shapes and of closed meshes"
    NEEDS = "Select one or more solids or closed meshes first."
    KEYS = "Q, G"

    def selected(self):
        return [source for source in _selected() if _has_shape(source) or convert.is_mesh(source)]


class CamMesh(Offset):
    KIND = cam_mesh.CamMeshObject
    NAME = KIND.COMMAND
    TEXT = "CAM mesh"
    TIP = "Mesh the selected solids for machining, never inside of them, so that no tool cuts into the part, or never outside"
    NEEDS = "Select one or more solids or closed meshes first."
    KEYS = "Q, J"


class Hollow(Offset):
    KIND = hollow.HollowObject
    NAME = KIND.COMMAND
    TEXT = "Hollow"
    TIP = "Leave a wall of the selected solids, for printing and casting; selected faces become openings"
    NEEDS = "Select one or more solids or closed meshes first, or faces of one solid."
    KEYS = "Q, H"

    def operations(self, selected):
        return _with_faces(self, selected, "openings")


class Wrap(Boolean):
    KIND = wrap.WrapObject
    NAME = KIND.COMMAND
    TEXT = "Wrap"
    TIP = "Close the outer surface of the selected objects, which may overlap, be open or have gaps, for flow simulations"
    NEEDS = "Select two or more objects first."
    KEYS = "Q, W"


def _with_faces(command, selected, option):
    """The operations of a command, of one object with the selected faces as a value of an option."""
    faces = picked_faces(selected[0]) if len(selected) == 1 else []
    return [Operation(command.TEXT, command.KIND, [source], command.trial([source]), chosen={option: faces} if faces else None)
            for source in selected]


class _OfOneMesh(_OfOne):
    """The same for the mesh that is selected."""

    def selected(self):
        return _if_one(convert.is_mesh)


class _OfOneFlatMesh(_OfOne):
    """The same for a mesh of flat triangles."""

    def selected(self):
        return _if_one(_is_flat_mesh)


class Analyse(_OfOneMesh):
    NAME = "MeshQuality_Analyse"
    TEXT = "Analyse quality"
    TIP = "Colour the selected mesh by its quality and find its worst elements"
    NEEDS = "Select one mesh or FEM mesh first."
    KEYS = "Q, A"

    def selected(self):
        return _if_one(lambda source: convert.is_mesh(source) or cured_mesh.has_fem_mesh(frames.linked_of(source)[0]))

    def Activated(self):
        quality_panel.open_panel(self.selected()[0])


class Thickness(_OfOneFlatMesh):
    NAME = "MeshQuality_Thickness"
    TEXT = "Wall thickness"
    TIP = "Colour the selected closed mesh by the thickness of its walls and find the thinnest"
    NEEDS = "Select one closed mesh first."
    KEYS = "Q, T"

    def Activated(self):
        quality_panel.open_panel(self.selected()[0], quality_data.THICKNESS)


class Inspect(Offset):
    KIND = inspection.Inspection
    NAME = KIND.COMMAND
    TEXT = "Inspection"
    TIP = "Measure walls, clearances, draft or closed voids of the selected solids again after each edit, against a limit"
    NEEDS = "Select one or more solids or closed meshes first."
    KEYS = "Q, K"


class Deviation(Boolean):
    KIND = deviation.DeviationObject
    NAME = KIND.COMMAND
    TEXT = "Deviation"
    TIP = "Colour the selected scan, a mesh or points, by its signed distance from the selected part, aligned before if asked"
    NEEDS = "Select a mesh or points, and a part, first."
    KEYS = "Q, D"

    def panel(self, operations, **values):
        return MeshPanel(operations, afterwards=quality_panel.open_panel, **values)

    def selected(self):
        """The scan and the part, in whatever order they were selected; of two meshes the first one is the scan."""
        found = [source for source in _selected() if _has_shape(source) or has_points(source)]
        scans = [source for source in found if has_points(source)]
        one_document = len({frames.object_of(source).Document for source in found}) == 1
        if len(found) != 2 or not scans or not one_document:
            return []
        return [scans[0], found[1] if scans[0] == found[0] else found[0]]


class Improve(_Command):
    KIND = improved_mesh.ImprovedMesh
    NAME = KIND.COMMAND
    TEXT = "Improve mesh"
    TIP = "Improve the triangles of the selected meshes on their surface; sharp edges stay"
    NEEDS = "Select one or more meshes first."
    KEYS = "Q, I"

    def selected(self):
        return [source for source in _selected() if convert.is_mesh(source)]


class Simplify(Improve):
    KIND = simplified_mesh.SimplifiedMeshObject
    NAME = KIND.COMMAND
    TEXT = "Simplify"
    TIP = "Fewer triangles for the selected meshes, within a distance that is proven; sharp edges stay"
    NEEDS = "Select one or more meshes first."
    KEYS = "Q, L"


class Repair(_Command):
    KIND = repaired_mesh.RepairedMesh
    NAME = KIND.COMMAND
    TEXT = "Repair mesh"
    TIP = "List the faults of the selected mesh, show where they are, and make a closed mesh without them"
    NEEDS = "Select one mesh first."
    KEYS = "Q, R"

    def selected(self):
        return _if_one(_is_flat_mesh)

    def panel(self, operations, **values):
        return RepairPanel(operations, **values)


class Export(_OfOneMesh):
    PANEL = ExportPanel
    NAME = "MeshQuality_Export"
    TEXT = "Export mesh"
    TIP = "Write the selected mesh into a file for a solver or a printer, with the names of its patches"
    NEEDS = "Select one mesh or FEM mesh first."
    KEYS = "Q, E"

    def selected(self):
        return _if_one(lambda source: convert.is_mesh(source) or export.holds_fem_mesh(source))


class SaveReport(Export):
    NAME = "MeshQuality_SaveReport"
    TEXT = "Save report"
    TIP = "Write a page with pictures of the selected mesh or inspection: what was requested and found, by face, and where it is poor"
    NEEDS = "Select one mesh or FEM mesh first."
    KEYS = "Q, Z"

    def Activated(self):
        saving.save_report(self.selected()[0], lambda text, is_error: (
            FreeCAD.Console.PrintError if is_error else FreeCAD.Console.PrintMessage)(text + "\n"))


class ToSolid(_OfOneFlatMesh):
    PANEL = SolidPanel
    NAME = "MeshQuality_ToSolid"
    TEXT = "To solid"
    TIP = "Make a CAD solid of the selected closed mesh, with the exact surfaces of the shapes that it was made of"
    NEEDS = "Select one closed mesh first."
    KEYS = "Q, N"


class FlowCase(_OfOneMesh):
    PANEL = CasePanel
    NAME = "MeshQuality_FlowCase"
    TEXT = "OpenFOAM case"
    TIP = "Write a folder in which OpenFOAM meshes the space inside of the selected mesh, or around it, or finds the cells of a flow mesh"
    NEEDS = "Select one mesh first."
    KEYS = "Q, O"

    def selected(self):
        return _if_one(lambda source: convert.is_mesh(source) or cfd.holds_cells(source))


class CfdSurface(_OfOneMesh):
    NAME = "MeshQuality_CfdSurface"
    TEXT = "CFD surface"
    TIP = "Make a shape of the selected closed mesh, one face a patch, of which CfdOF takes the triangles"
    NEEDS = "Select one closed mesh first."
    KEYS = "Q, S"
    ASKS = False

    def Activated(self):
        FreeCADGui.doCommand("import MeshQuality as mq")
        try:
            FreeCADGui.doCommand(f"mq.add_cfd_surface({name_of(self.selected()[0])})")
        except Error as error:
            FreeCAD.Console.PrintError(f"{translated(error)}\n")
            return
        obj = FreeCAD.ActiveDocument.ActiveObject
        select([obj])
        told = FreeCAD.Qt.translate("MeshQuality", "{0}: {1}; a point inside, for snappyHexMesh: {2}")
        FreeCAD.Console.PrintMessage(told.format(obj.Label, ", ".join(obj.Patches), ", ".join(map(text_of, obj.PointInside))) + "\n")


class Patches(_OfOneMesh):
    PANEL = PatchesPanel
    NAME = "MeshQuality_Patches"
    TEXT = "Patches"
    TIP = "Name groups of faces of the selected mesh, such as inlet and wall, for files"
    NEEDS = "Select one mesh of a shape first."
    KEYS = "Q, P"

    def selected(self):
        return [frames.linked_of(source)[0] for source in _if_one(_can_have_patches)]


class Update(_Command):
    NAME = "MeshQuality_Update"
    TEXT = "Update mesh"
    TIP = "Compute the selected meshes again where a source or an option has changed"
    NEEDS = "Select one or more meshes of MeshQuality first."
    KEYS = "Q, U"
    ASKS = False

    def Activated(self):
        for obj in self.selected():
            update_in_background(obj)

    def selected(self):
        found = dict.fromkeys(frames.linked_of(source)[0] for source in _selected())
        return [obj for obj in found if isinstance(getattr(obj, "Proxy", None), mesh_object.MeshObject)]


class GetBinary(_Command):
    NAME = "MeshQuality_GetBinary"
    TEXT = "Missing binary"
    TIP = "How to get the binary file without which MeshQuality cannot compute"
    KEYS = ""

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def Activated(self):
        FreeCADGui.Control.showDialog(BinaryPanel())


class FirstSteps(_Command):
    NAME = "MeshQuality_FirstSteps"
    TEXT = "First steps"
    TIP = "A first part in five minutes, and all other pages of the documentation"
    KEYS = ""
    ASKS = False

    def IsActive(self):
        return True

    def Activated(self):
        help_pages.show()


class Examples(FirstSteps):
    NAME = "MeshQuality_Examples"
    TEXT = "Examples"
    ASKS = False
    TIP = "Open two new documents: a pipe tee to mesh, and a scan with a bump and holes to inspect and repair"

    def Activated(self):
        FreeCADGui.doCommand("from MeshQuality.gui import example\nexample.open_documents()")


def _selected():
    """The sources that are selected, each once, see frames."""
    found = []
    for selected in FreeCADGui.Selection.getSelectionEx("", 0):
        found += [source for source, _ in frames.paths_of_selection(selected) if source not in found]
    return found


def _in_place_of(source):
    """The meshes that are seen in place of a source that is hidden, as panels leave it selected."""
    obj = frames.linked_of(source)[0]
    if obj.ViewObject is None or obj.ViewObject.Visibility:
        return []
    return [user for user in dict.fromkeys(obj.InList)
            if isinstance(getattr(user, "Proxy", None), mesh_object.MeshObject) and user.ViewObject.Visibility]


def _if_one(fits):
    """What is selected, if it is one source that fits; or the one mesh that is seen in its place."""
    found = _selected()
    if len(found) == 1 and not fits(found[0]):
        found = _in_place_of(found[0])
    return found if len(found) == 1 and fits(found[0]) else []


def _is_flat_mesh(source):
    return convert.is_mesh(source) and not holds_elements(source)


def _can_have_patches(source):
    obj = frames.linked_of(source)[0]
    proxy = getattr(obj, "Proxy", None)
    return isinstance(proxy, mesh_object.PatchedMesh) and not proxy.lacks_source(obj) and proxy.has_faces(obj)


def _has_shape(source):
    obj = frames.leaf_of(source)
    if obj.isDerivedFrom("App::Origin"):  # a group, but of planes and axes
        return False
    # FEM meshes have a link of the name Shape.
    return isinstance(getattr(obj, "Shape", None), Part.Shape) or obj.hasExtension("App::GroupExtension") \
        or obj.TypeId in ("App::Link", "App::LinkElement", "App::LinkGroup") and not convert.is_mesh(source)


# By task: the title of a submenu, or none, and its commands.
_MENUS = (
    (QT_TRANSLATE_NOOP("Workbench", "Mesh"), (Triangulate, Quick, Curve, Boolean, Wrap)),
    (QT_TRANSLATE_NOOP("Workbench", "Solve"), (FemMesh, Adapt, Cure, FlowMesh, Patches, FlowCase, CfdSurface)),
    (QT_TRANSLATE_NOOP("Workbench", "Print"), (Offset, Hollow, CamMesh)),
    (QT_TRANSLATE_NOOP("Workbench", "Inspect"), (Analyse, Thickness, Inspect, Deviation)),
    (QT_TRANSLATE_NOOP("Workbench", "Repair"), (Repair, Improve, Simplify)),
    (QT_TRANSLATE_NOOP("Workbench", "Hand over"), (Export, ToSolid, SaveReport)),
    ("", (Update,)),
    (QT_TRANSLATE_NOOP("Workbench", "Help"), (FirstSteps, Examples)),
)
# The three toolbars, by name: what is used most, seven buttons at most.
_TOOLBARS = (
    (QT_TRANSLATE_NOOP("Workbench", "Mesh Quality"), (Triangulate, Quick, Curve, FemMesh, Boolean, Wrap, Update)),
    (QT_TRANSLATE_NOOP("Workbench", "Mesh Quality: inspect and repair"), (Analyse, Thickness, Inspect, Deviation, Repair, Improve, Simplify)),
    (QT_TRANSLATE_NOOP("Workbench", "Mesh Quality: print and hand over"), (Offset, Hollow, CamMesh, Patches, Export, ToSolid, SaveReport)),
)
_COMMANDS = tuple(command for _, commands in _MENUS[:-1] for command in commands)  # commands for selected objects


def panel_of(obj):
    """The panel that edits a document object."""
    command = next(command for command in _COMMANDS if command.KIND is type(obj.Proxy))
    return command().panel([command().editing(obj)], editing=True)


def register():
    """Registers all commands with FreeCAD; returns [(title of a submenu, names)], without a title for what is in none. Where
    the binary is missing, none that computes can be used but the one that comes first then and tells how to get it.
    """
    menus = _MENUS
    if why_no_extension():
        FreeCAD.Console.PrintWarning(f"{why_no_extension()}\n")
        menus = (("", (GetBinary,)), *_MENUS)
    for _, commands in menus:
        for command in commands:
            FreeCADGui.addCommand(command.NAME, command())
    return [(title, [command.NAME for command in commands]) for title, commands in menus]


def toolbars():
    """[(name of a toolbar, names of its commands), ...]; where the binary is missing the first one begins with what tells how to
    get it.
    """
    rows = [(title, [command.NAME for command in commands]) for title, commands in _TOOLBARS]
    if why_no_extension():
        rows[0][1].insert(0, GetBinary.NAME)
    return rows


def fitting():
    """Names of the commands that fit what is selected, for the context menu."""
    return [command.NAME for command in _COMMANDS if command().IsActive()]
