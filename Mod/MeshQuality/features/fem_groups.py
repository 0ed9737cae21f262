# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of a FEM mesh beside the groups of the shape: elements of patches, and nodes for constraints.

FreeCAD looks for the nodes of a constraint within the tolerance of its faces, and so misses those on edges that are
looser. Before, it looks for a group of nodes whose name begins with that of the constraint: such constraints get one.
"""

import re

import FreeCAD

from .. import phrases
from ..core.fem import fem
from ..core.patches.patches import division_for
from ..core.sources import frames
from ..errors import InvalidInput
from .patches import patches_of_object

_ANALYSIS = "Fem::FemAnalysis"
_END = "_AllNodes"  # after the name of the constraint
_REFERENCES = "References"
_OF_SHAPE, _FACE = re.compile(r"(Solid|Face|Edge)[1-9][0-9]*"), re.compile(r"Face([1-9][0-9]*)")


def is_analysis(obj):
    """Whether a document object is an analysis of FreeCAD's FEM workbench."""
    return isinstance(obj, FreeCAD.DocumentObject) and obj.isDerivedFrom(_ANALYSIS)


def is_of_shape(name):
    """Whether it is the name of the group of a solid, face or edge."""
    return bool(_OF_SHAPE.fullmatch(name))


def require_patch_names(names):
    """Raises InvalidInput where a patch has the name of a group that the mesh has anyway."""
    wrong = next((name for name in names if _OF_SHAPE.fullmatch(name)), None)
    if wrong is not None:
        raise InvalidInput(phrases.Text(phrases.PATCH_LIKE_GROUP, name=repr(wrong)))


def complete(obj, mesh):
    """Gives the Fem.FemMesh of a FEM mesh object the groups that its patches and the constraints beside it need now, and
    removes groups of other patches and constraints.
    """
    wanted = _wanted(obj, mesh)
    for key, group in _own_groups(obj, mesh).items():
        if wanted.get(key) == set(mesh.getGroupElements(group)):
            del wanted[key]
        else:
            mesh.removeGroup(group)
    for (name, kind), numbers in sorted(wanted.items()):
        mesh.addGroupElements(mesh.addGroup(name, kind), sorted(numbers))


def update(obj):
    """Updates the groups of the mesh that an object holds."""
    mesh = obj.FemMesh
    if {key: set(mesh.getGroupElements(group)) for key, group in _own_groups(obj, mesh).items()} != _wanted(obj, mesh):
        touched = "Touched" in obj.State
        mesh = mesh.copy()
        complete(obj, mesh)
        obj.FemMesh = mesh
        if not touched:
            obj.purgeTouched()


def _own_groups(obj, mesh):
    """{(name, kind): group} of the groups that belong neither to the shape nor to a given mesh."""
    named = {(mesh.getGroupName(group), mesh.getGroupElementType(group)): group for group in mesh.Groups}
    return {key: group for key, group in named.items()
            if not is_of_shape(key[0]) and key[0] not in _given_groups(obj)}


def _given_groups(obj):
    return getattr(obj, "GivenGroups", ())


def _wanted(obj, mesh):
    """{(name, kind) of a group: numbers of its elements or nodes}."""
    source = obj.Proxy.sources(obj)[0]
    if source is None:
        return {}
    groups = fem.groups_of(mesh)
    found = {**_of_patches(obj, source, groups), **_of_constraints(obj, frames.leaf_of(source), mesh, groups)}
    return {key: numbers for key, numbers in found.items() if key[0] not in _given_groups(obj)}


def _of_patches(obj, source, groups):
    division = division_for(source, *patches_of_object(obj))
    if division is None:
        return {}
    require_patch_names(filter(None, (*division.names, division.rest)))
    found = {}
    for name, numbers in groups.items():
        face = _FACE.fullmatch(name)
        patch = division.patch_of.get(int(face[1]) - 1) if face else None
        title = division.rest if patch is None else division.names[patch]
        if face and title:
            found.setdefault((title, "Face"), set()).update(numbers)
    return found


def _of_constraints(obj, part, mesh, groups):
    found = {}
    for constraint in _constraints_of(obj):
        references = [(owner, name) for owner, names in constraint.References for name in names]
        shapes = [part.Shape.getElement(name) for owner, name in references
                  if owner == part and name.startswith(("Face", "Edge", "Vertex"))]
        if len(shapes) == len(references) and any(map(_is_loose, shapes)):
            found[constraint.Name + _END, "Node"] = set().union(*(
                _nodes_on(mesh, groups, name, shape) for (_, name), shape in zip(references, shapes)))
    return found


def _constraints_of(obj):
    """The objects that refer to sub-elements in the analyses that have a mesh."""
    return [member for analysis in obj.InList if is_analysis(analysis) for member in analysis.Group
            if _REFERENCES in member.PropertiesList and member.References]


def _is_loose(shape):
    """Whether something on the border of a face or an edge is looser than that itself."""
    border = [*shape.Edges, *shape.Vertexes] if shape.ShapeType == "Face" else shape.Vertexes
    return any(part.Tolerance > shape.Tolerance for part in border)


def _nodes_on(mesh, groups, name, shape):
    if shape.ShapeType == "Vertex":
        return set(mesh.getNodesByVertex(shape))
    return {node for element in groups.get(name, ()) for node in mesh.getElementNodes(element)}


def _meshes_of(objects):
    return [obj for obj in objects if getattr(getattr(obj, "Proxy", None), "MESH", "") == "FemMesh" and obj.Fingerprint]


class _Observer:
    """Has groups follow the constraints."""

    def slotChangedObject(self, obj, name):
        """Called by FreeCAD."""
        if obj.Document.Restoring or obj.Document.Transacting:
            return
        if name == _REFERENCES:
            analyses = filter(is_analysis, obj.InList)
        elif name == "Group" and is_analysis(obj):
            analyses = [obj]
        else:
            return
        for mesh in _meshes_of(member for analysis in analyses for member in analysis.Group):
            update(mesh)

    def slotUndoDocument(self, document):
        """Called by FreeCAD, which brings back constraints but no earlier groups of a mesh."""
        for mesh in _meshes_of(document.Objects):
            update(mesh)

    slotRedoDocument = slotAbortTransaction = slotUndoDocument


FreeCAD.addDocumentObserver(_Observer())
