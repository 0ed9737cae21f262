# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "CFD surface": a mesh of the document as a shape, one face a patch, for CfdOF."""

import FreeCAD

from .. import phrases
from ..compat import extension
from ..core.meshes.openfoam_case import point_inside, require_closed
from ..core.patches import patch_faces
from ..core.patches.patches import colour_of, patches_of
from ..core.sources import convert, frames
from ..errors import Error, InvalidInput
from ..phrases import Text
from .export import flat_maker_of
from .gui_hooks import window
from .mesh_shape import MeshShape
from .properties import add_property


class CfdSurface(MeshShape):
    """Proxy of a Part::FeaturePython whose faces are the patches of its Source; they have the triangles of that in place
    of a surface. CfdOF takes it as the Part of its mesh and its faces as those of boundaries, and writes its triangles.
    """

    NAME, TITLE, WORD = "CfdSurface", "CFD surface", "CFD surface"

    _has_surfaces = False  # whether its faces were given surfaces, so that FreeCAD can copy them
    _is_making = False  # whether a shape with triangles alone is about to take their place

    def __init__(self, obj):
        super().__init__(obj)
        add_property(obj, "App::PropertyStringList", "Patches", "Patches", "The name of the patch that each face is")
        add_property(obj, "App::PropertyVectorDistance", "PointInside", "Patches",
                     "A point inside of the closed surface, for snappyHexMesh")
        for name in ("Patches", "PointInside"):
            obj.setEditorMode(name, 1)

    def make_shape(self, obj, source):
        """Gives the object a face a patch, the names of these, and a point inside."""
        mesh = flat_maker_of(source)()
        require_closed(mesh)
        patches = mesh._patches or patches_of(None, mesh.triangle_face, len(mesh.triangles))
        points = mesh.vertices + mesh.origin
        used = sorted(set(patches.of_triangle.tolist()))
        self._is_making = True
        try:
            obj.Shape = patch_faces.shape_of(points, mesh.triangles, patches.of_triangle)
        finally:
            self._is_making = self._has_surfaces = False
        obj.Patches = [f"Face{i + 1}: {patches.names[patch]}" for i, patch in enumerate(used)]
        obj.PointInside = FreeCAD.Vector(*point_inside(points[mesh.triangles]))
        window().show_faces(obj, [colour_of(patches, patch) for patch in used])

    def onDocumentRestored(self, obj):
        """The faces get their triangles back, which FreeCAD does not save."""
        self.make_anew(obj)

    def make_anew(self, obj):
        """Gives the faces the triangles of the mesh as it is; says where that cannot be."""
        try:
            self._bring_up_to_date(obj)
        except Error as error:
            FreeCAD.Console.PrintWarning(f"{obj.Label}: {window().translated(error)}\n")
            import Part

            obj.Shape = Part.Shape()  # faces without their triangles would get other triangles than the mesh
            obj.touch()
            return
        obj.purgeTouched()


def add_cfd_surface(obj):
    """Adds a shape whose faces are the patches of a mesh of the document, for CfdOF; one undo step.

    obj  document object with a closed mesh, which has patches by set_patches; or a link to one

    CfdOF takes it as the Part of its mesh (snappyHexMesh or cfMesh) and its faces as those of boundaries and refinements;
    it writes the triangles as they are, so that its options for triangulation do nothing. The property Patches says which
    face is which patch, PointInside is a point for snappyHexMesh. The shape follows the mesh.

    Returns the object. Raises InvalidInput for other objects, for a mesh that is open, and in a window with a binary that cannot take
    FreeCAD's shapes in place, and then adds nothing.
    """
    if not frames.is_object(obj) or not convert.is_mesh(obj):
        raise InvalidInput(f"{convert.label_of(obj)} holds no mesh: give an object with a mesh, or a link to one")
    if FreeCAD.GuiUp and not _can_be_undone():
        raise InvalidInput(Text(phrases.CASE_NO_UNDO, name=convert.label_of(obj)))
    return CfdSurface.add(obj)


def _can_be_undone():
    """Whether faces with triangles alone can be given surfaces in place, without which a copy of them ends FreeCAD's view."""
    import Part

    return extension().add_placeholder_surfaces(Part.Vertex())


def _is_cfd_surface(obj):
    return isinstance(getattr(obj, "Proxy", None), CfdSurface)


class _Observer:
    """Gives shapes their triangles back, which FreeCAD does not keep for undoing."""

    def slotBeforeChangeObject(self, obj, name):
        """Called by FreeCAD, which then copies the shape without its triangles, and would end when it shows that."""
        if name == "Shape" and _is_cfd_surface(obj) and not obj.Shape.isNull():
            obj.Proxy._has_surfaces = extension().add_placeholder_surfaces(obj.Shape)

    def slotChangedObject(self, obj, name):
        """Called by FreeCAD, also where the same shape was placed elsewhere only."""
        if name == "Shape" and _is_cfd_surface(obj) and obj.Proxy._has_surfaces and not obj.Proxy._is_making \
                and not obj.Shape.isNull() and not obj.Document.Transacting and not obj.Document.Restoring:
            obj.Proxy.make_anew(obj)

    def slotUndoDocument(self, document):
        """Called by FreeCAD."""
        for obj in document.Objects:
            if _is_cfd_surface(obj) and obj.Source is not None:
                obj.Proxy.make_anew(obj)

    slotRedoDocument = slotAbortTransaction = slotUndoDocument


FreeCAD.addDocumentObserver(_Observer())
