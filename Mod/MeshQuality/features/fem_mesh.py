# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "FEM mesh": tetrahedra or shell elements for FreeCAD's FEM workbench that follow a shape of the
document.

Since FreeCAD 1.0 that workbench finds nodes and faces by where they lie on a shape in the document, whatever containers the
mesh is in. Before, it did by the shape's own placement, without the containers around it: so the mesh stays there, too, and
only in the App::Part of the part it is seen at the part, where it is put unless an analysis elsewhere gets it.
"""

from dataclasses import dataclass

import FreeCAD

from .. import options, phrases
from ..compat import fem_in_document, fem_source_property
from ..core.curving import curve
from ..core.fem import fem, fem_size
from ..core.sources import frames
from ..core.sources import hidden_parts
from ..errors import InvalidInput
from . import curved_mesh, fem_groups, mesh_object, transactions
from .fem_groups import is_analysis
from .gui_hooks import window

PART = (fem_source_property(), "App::PropertyLinkGlobal", "The source, as FreeCAD's FEM workbench looks it up")


class FemMeshObject(mesh_object.PatchedMesh, mesh_object.ShapeMesh):
    """Proxy of a Fem::FemMeshObjectPython that holds elements of order 1 or 2 on its source's shape."""

    TYPE, MESH = "Fem::FemMeshObjectPython", "FemMesh"
    LEAVES_CONTAINERS, PLACED_IN_DOCUMENT = not fem_in_document(), fem_in_document()
    COMMAND, CALL = "MeshQuality_FemMesh", "add_fem_mesh"
    OPTIONS, PRESETS = options.fem.FEM, options.fem.FEM_PRESETS
    BOUND_BEFORE = options.RELATIVE
    PROMISES, MEASURED = curved_mesh.PROMISES, curved_mesh.MEASURED
    HIDDEN = (PART,)
    _shown = None  # fingerprint of the mesh that was made last, as long as the document is open

    def size(self, obj):
        """Number of tetrahedra, of a mesh of shells that of triangles."""
        return obj.FemMesh.VolumeCount or obj.FemMesh.FaceCount

    def onChanged(self, obj, name):
        """Called by FreeCAD; what its FEM workbench looks up is the Source."""
        super().onChanged(obj, name)
        if name == "Source" and PART[0] in obj.PropertiesList and not obj.Document.Restoring:
            _name_source(obj)

    def add_properties(self, obj):
        """As in the base class; an object of another version of FreeCAD gets the name that this one looks up."""
        super().add_properties(obj)
        _name_source(obj)

    def require_patch_names(self, names):
        """As fem_groups.require_patch_names."""
        fem_groups.require_patch_names(names)

    def told(self, obj):
        """A Text if the mesh is not seen where its part is, with the remedy."""
        source = self.sources(obj)[0]
        if self.PLACED_IN_DOCUMENT:
            around = ", ".join(f"'{found.Label}'" for found in frames.containers_of(obj))
            return None if frames.is_identity(frames.frame_of(obj)) else phrases.Text(phrases.FEM_IN_CONTAINER, name=around)
        if source is None or frames.same(frames.frame_of(obj), frames.frame_of(source)):
            return None
        part, mesh = (frames.containers_of(found) for found in (frames.object_of(source), obj))
        if part and home_of(source) == part[0]:
            return phrases.Text(phrases.FEM_BESIDE, name=f"'{part[0].Label}'")
        return phrases.Text(phrases.FEM_BESIDE_ANY, name=", ".join(f"'{found.Label}'" for found in [*part, *mesh]))

    def show_patches(self, obj):
        """Patches are groups."""
        fem_groups.update(obj)

    def _bring_up_to_date(self, obj):
        """As in the base class; patches may have been changed in the property editor."""
        super()._bring_up_to_date(obj)
        self._shown = obj.Fingerprint
        fem_groups.update(obj)

    def held(self, obj):
        """As in the base class; nothing after undo or redo, which bring back the fingerprint, and not always the FemMesh."""
        known = super().held(obj)
        return known if self._shown in (None, known) else ""

    @classmethod
    def compute(cls, shape, values, progress):
        """The Result."""
        curve_values, note = cls.curve_values(shape, values)
        curved = hidden_parts.noted(curve(shape, **curve_values, progress=progress), [note] if note else [])
        return cls.result_of(curved, shape, curve_values)

    @staticmethod
    def curve_values(shape, values):
        """(the options of curve that stand for those of a FEM mesh, a note on them or "")."""
        length, note = fem_size.longest_edge(shape, values)
        values = {**values, "volume": values["volume"] and bool(shape.Solids), "max_edge": length}
        del values["elements_through"]
        return values, note

    @staticmethod
    def result_of(curved, shape, curve_values):
        """The Result of a CurvedMesh that was made with these options."""
        return Result(fem.elements_of(curved, groups=True), curved_mesh.Proof(curved, shape, curve_values))

    def take(self, obj, result):
        """Shows the elements and their report."""
        mesh = result.mesh()
        self.follow(obj)  # groups are made of patches
        fem_groups.complete(obj, mesh)
        obj.FemMesh = mesh
        result.proof.show(obj)
        return result.proof.report, result.proof.findings


def _name_source(obj):
    if getattr(obj, PART[0]) != obj.Source:
        setattr(obj, PART[0], obj.Source)


@dataclass
class Result:
    """The result of a FEM mesh object: the fem.Elements of its mesh, and the curved_mesh.Proof of its certificate."""

    elements: fem.Elements
    proof: curved_mesh.Proof
    _made: object = None

    def steps(self):
        """Makes the Fem.FemMesh on the main thread, which may do other things after each short step."""
        mesh = fem.module().FemMesh()
        yield from fem.fill(mesh, self.elements)
        self._made = mesh

    def mesh(self):
        """The Fem.FemMesh that the steps made; made now if they are not done."""
        return fem.mesh_of(self.elements) if self._made is None else self._made


def analysis_around(source):
    """The analysis that lists the object of a source; None where there is none."""
    return next((user for user in frames.object_of(source).InList if is_analysis(user)), None)


def add_fem_mesh(source, analysis=None, **values):
    """Adds a document object that keeps a FEM mesh of `source` up to date; one undo step.

    source    document object with a shape: feature, body, link or container
    analysis  Fem::FemAnalysis that gets the mesh; None: in the window the active one, else the one that lists
              what is selected, or `source`; else no one
    values    the options of curve, except progress; order is 1 or 2, imprint and volume are True unless given; a
              shape without solids makes triangles. elements_through: without max_edge, how many elements a wall
              has through its thickness, 2 unless given

    Its property FemMesh is a Fem.FemMesh as CurvedMesh.to_fem_mesh(groups=True) makes it. Returns the object.
    Raises what curve raises, and then adds nothing; Error where FreeCAD is built without its FEM workbench.
    """
    fem.module()
    if isinstance(frames.object_of(source), FreeCAD.DocumentObject):
        analysis = _checked(analysis, source) if analysis is not None \
            else window().analysis_for(source) or analysis_around(source)
    return transactions.add_of_source(FemMeshObject, source, values, "FemMesh", "FEM mesh", "FEM mesh",
                                      then=lambda obj: put_into(analysis, obj, source))


def home_of(source):
    """The App::Part in which alone the mesh of a source is seen where that is; None where there is none."""
    if fem_in_document():
        return None
    container = next(iter(frames.containers_of(frames.object_of(source))), None)
    return container if container is not None and container.isDerivedFrom("App::Part") else None


def _checked(analysis, source):
    document = frames.object_of(source).Document
    if not is_analysis(analysis) or analysis.Document != document:
        raise InvalidInput(f"analysis must be a Fem::FemAnalysis of document '{document.Label}', not "
                           f"{getattr(analysis, 'Label', analysis)!r}")
    return analysis


def put_into(analysis, obj, source):
    """Adds a mesh to an analysis, and says where that has others; without one to the App::Part around its source."""
    if analysis is None:
        home = home_of(source)
        if home is not None:
            home.addObject(obj)
        return
    others = [f"'{other.Label}'" for other in analysis.Group if other.isDerivedFrom("Fem::FemMeshObject")]
    analysis.addObject(obj)
    if others:
        said = phrases.Text(phrases.MORE_MESHES, name=f"'{analysis.Label}'", name2=", ".join(others))
        FreeCAD.Console.PrintWarning(f"{obj.Label}: {window().translated(said)}\n")
