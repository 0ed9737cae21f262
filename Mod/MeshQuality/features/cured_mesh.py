# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Cured mesh": a FEM mesh that another program made, with valid elements that follow the part.

It follows the part and the given mesh, whose groups it keeps where their elements stayed, and takes its place in the
analysis: FreeCAD's solvers take the one Fem::FemMeshObject that an analysis lists, and refuse two.
"""

import hashlib
from dataclasses import replace
from functools import partial

import FreeCAD

from .. import options, phrases
from ..compat import fem_source_property
from ..core.certify.certification import certify
from ..core.curved import simplex_arrays
from ..core.curving import curve
from ..core.fem import fem, fem_places
from ..core.sources import convert, frames
from ..errors import InvalidInput
from . import curved_mesh, fem_mesh, mesh_object, transactions
from .fem_groups import is_analysis, is_of_shape
from .gui_hooks import window
from .recompute_work import Work

GIVEN = ("Given", "App::PropertyLinkGlobal", "The object with the FEM mesh that is cured")
_GROUPS = ("GivenGroups", "App::PropertyStringList", "Groups of the given mesh that this one has, too")
_FOUND = (
    ("GivenElements", "App::PropertyInteger", "Number of elements of the given mesh"),
    ("GivenInvalid", "App::PropertyInteger", "Number of its elements that are not proven valid"),
    ("GivenInvalidElements", "App::PropertyStringList", "Which these are"),
    ("GivenReplaced", "App::PropertyInteger", "Number of its elements that others replace"),
    ("GivenMoved", "App::PropertyInteger", "Number of its vertices that are not where they were"),
)
_CERTIFYING = 0.1  # part of the progress
_RESULT_MESH = "Fem::MeshResult"  # solvers do not take it


class CuredMeshObject(fem_mesh.FemMeshObject):
    """Proxy of a Fem::FemMeshObjectPython that holds the cured elements of another FEM mesh."""

    COMMAND, CALL = "MeshQuality_Cure", "add_cured_mesh"
    OPTIONS, PRESETS = options.fem.CURE, ()
    LINKS = ("Source", "SourcePath", "Given")
    MEASURED = (*fem_mesh.FemMeshObject.MEASURED, *_FOUND)
    HIDDEN = (*fem_mesh.FemMeshObject.HIDDEN, _GROUPS)

    def sources(self, obj):
        """The part with its path, and the object with the given mesh."""
        return [*super().sources(obj), obj.Given]

    def add_properties(self, obj):
        """As in the base class, with a property for the given mesh."""
        mesh_object.add_property(obj, GIVEN[1], GIVEN[0], "Mesh", GIVEN[2])
        super().add_properties(obj)

    @classmethod
    def called_with(cls, names):
        """The arguments of CALL: the mesh comes first."""
        part, mesh = names
        return f"{mesh}, {part}"

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """The Work of curing the mesh of the second source on the shape of the first."""
        mesh_object.require_source(sources[:1], obj)
        if sources[1] is None:
            raise InvalidInput(phrases.Text(phrases.GIVEN_DELETED))
        values = options.check(cls.OPTIONS, values)
        if cls.LEAVES_CONTAINERS:
            shape, mesh = convert.own_shape_of(sources[0]), fem_places.mesh_in_frame(sources[1], sources[0])
        else:
            shape, mesh = convert.shape_of(sources[0]), fem_places.mesh_at(sources[1], sources[0])
        convert.taken(shape)
        return Work(sources, values, partial(_digest, shape, mesh, values), partial(cls.compute, shape, values, mesh=mesh))

    @classmethod
    def compute(cls, shape, values, progress, mesh):
        """The fem_mesh.Result."""
        if simplex_arrays.is_mixed(mesh):
            raise InvalidInput("the mesh has elements that are neither triangles nor tetrahedra: such meshes are cured by "
                               "curve(part, mesh=...) in Python or on the command line, and not kept in documents")
        before = certify(mesh, progress=progress and (lambda done, stage: progress(_CERTIFYING * done, stage)))
        curved = curve(shape, **values, mesh=mesh, progress=progress and (
            lambda done, stage: progress(_CERTIFYING + (1.0 - _CERTIFYING) * done, stage)))
        elements = fem.elements_of(curved, groups=True)
        carried = {name: parts for name, parts in simplex_arrays.carried_groups(mesh, curved).items() if not is_of_shape(name)}
        elements = replace(elements, groups=[*elements.groups, *fem.groups_from_rows(carried, elements)])
        return fem_mesh.Result(elements, Cure(curved, shape, values, mesh, before, carried))

    def take(self, obj, result):
        """As in the base class; which groups are the given ones has to be known before patches become groups."""
        obj.GivenGroups = sorted(result.proof.groups)
        return super().take(obj, result)

    def told(self, obj):
        """What was found and changed."""
        if not obj.Fingerprint:
            return None
        counted = phrases.counted
        return phrases.Text("{list}", list=[
            counted(phrases.GIVEN_INVALID, obj.GivenInvalid, count2=f"{obj.GivenElements:,}"),
            counted(phrases.CURED_INVALID, obj.Invalid, count2=f"{obj.Elements:,}"),
            counted(phrases.GIVEN_REPLACED, obj.GivenReplaced), counted(phrases.GIVEN_MOVED, obj.GivenMoved)])


class Cure(curved_mesh.Proof):
    """The Proof of cured elements, and what was changed of the given ones.

    mesh    the ElementMesh that was given, and `before` its MeshCertificate
    groups  those of simplex_arrays.carried_groups that it keeps
    """

    def __init__(self, curved, shape, values, mesh, before, groups):
        super().__init__(curved, shape, values)
        self.groups, self._before = groups, before
        self._count = sum(before.elements.values())
        stayed = int((curved.given_element >= 0).sum())
        self._replaced, self._moved = self._count - stayed, len(curved.moved_nodes)
        self._lost = {name: lost for name in groups if (lost := simplex_arrays.lost_of_group(mesh, name, groups[name]))}

    def show(self, obj):
        """Fills the groups Quality and Certificate."""
        super().show(obj)
        before = self._before
        obj.GivenElements, obj.GivenInvalid = self._count, before.invalid
        obj.GivenInvalidElements = before.invalid_elements
        obj.GivenReplaced, obj.GivenMoved = self._replaced, self._moved
        lost = [phrases.counted(phrases.GROUP_LOST, count, name=f"'{name}'") for name, count in self._lost.items()]
        obj.Notes = [*obj.Notes, *before.notes, *lost]
        for sentence in lost:
            FreeCAD.Console.PrintWarning(f"{obj.Label}: {window().translated(sentence)}\n")


def _digest(shape, mesh, values):
    digest = hashlib.sha256(mesh_object.fingerprint_of(shape, values).encode())
    for array in (mesh.nodes, *(block.nodes for block in mesh.blocks)):
        digest.update(array.tobytes())
    for name, parts in sorted(mesh.group_members.items()):
        digest.update(name.encode())
        for block, rows in parts:
            digest.update(bytes([block]) + rows.tobytes())
    return digest.hexdigest()


def has_fem_mesh(obj):
    """Whether a document object holds a FEM mesh with elements."""
    mesh = isinstance(obj, FreeCAD.DocumentObject) and obj.isDerivedFrom("Fem::FemMeshObject") and obj.FemMesh
    return bool(mesh) and mesh.VolumeCount + mesh.FaceCount > 0


def part_of(fem_object):
    """The source that a FEM mesh object names: a document object, or a pair as in frames; None: it names none."""
    if isinstance(getattr(fem_object, "Proxy", None), fem_mesh.FemMeshObject):
        return fem_object.Proxy.sources(fem_object)[0]
    names = (fem_source_property(), "Part", "Shape")
    found = (getattr(fem_object, name, None) for name in names)
    return next((part for part in found if isinstance(part, FreeCAD.DocumentObject)), None)


def add_cured_mesh(fem_object, part=None, order=2, **values):
    """Adds a document object with the valid elements of a FEM mesh that another program made; one undo step.

    fem_object  Fem::FemMeshObject: a mesh of triangles or tetrahedra, by FreeCAD's Gmsh or Netgen, or from a file
    part        document object that the mesh is of; None: what the mesh itself says
    order       1 or 2
    values      straighten_invalid and imprint, as for curve; imprint is True unless given

    The object's FemMesh is curve(part, mesh=the given one), with a group for each solid, face and edge, and the groups
    of elements of the given mesh as far as their elements stayed. It follows both, and takes the place of all meshes in
    the analysis that has the given one: FreeCAD's solvers take one mesh. These stay in the document. Where no analysis has
    the given mesh, the object goes where add_fem_mesh puts its own.

    Returns the object. Raises what curve raises, also where the mesh is not one of the part, and then changes nothing;
    InvalidInput naming the mesh.
    """
    if not has_fem_mesh(fem_object):
        raise InvalidInput(f"{convert.label_of(fem_object)} has no FEM mesh with triangles or tetrahedra: give a "
                           "Fem::FemMeshObject that was meshed")
    part = part_of(fem_object) if part is None else part
    if part is None:
        raise InvalidInput(phrases.Text(phrases.NO_PART, name=f"'{fem_object.Label}'"))
    if isinstance(frames.object_of(part), FreeCAD.DocumentObject) and frames.object_of(part).Document != fem_object.Document:
        raise InvalidInput(f"'{fem_object.Label}' and its part are objects of different documents: link them into one")
    analyses = _analyses_of(fem_object)

    def begin(obj):
        setattr(obj, GIVEN[0], fem_object)
        if not analyses:
            fem_mesh.put_into(window().analysis_for(part) or fem_mesh.analysis_around(part), obj, part)

    with transactions.undo_step(fem_object.Document, "Certify and cure"):
        obj = transactions.add_of_source(CuredMeshObject, part, {"order": order, **values}, "CuredMesh", "Certify and cure",
                                         "cured mesh", then=begin)
        for analysis in analyses:
            _replace_meshes(analysis, obj)
        obj.purgeTouched()
    return obj


def _analyses_of(fem_object):
    """Those that have the mesh, or else one that was cured from it."""
    cured = [user for user in fem_object.InList if getattr(user, GIVEN[0], None) == fem_object]
    found = ([user for user in mesh.InList if is_analysis(user)] for mesh in (fem_object, *cured))
    return next(filter(None, found), [])


def _replace_meshes(analysis, obj):
    others = [member for member in analysis.Group if member.isDerivedFrom("Fem::FemMeshObject")
              and getattr(getattr(member, "Proxy", None), "Type", "") != _RESULT_MESH]
    for other in others:
        analysis.removeObject(other)
    analysis.addObject(obj)
    labels = ", ".join(f"'{other.Label}'" for other in others)
    said = phrases.Text(phrases.TAKES_PLACE, name=f"'{analysis.Label}'", name2=labels)
    FreeCAD.Console.PrintMessage(f"{obj.Label}: {window().translated(said)}\n")
