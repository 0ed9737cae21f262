# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of nodes for constraints on a FEM mesh.

FreeCAD looks for the nodes of a constraint within the tolerance of its faces, and so misses those on edges that are
looser. Before, it looks for a group of nodes whose name begins with that of the constraint: such constraints get one.
"""

import FreeCAD

from ..core import fem, frames

_ANALYSIS = "Fem::FemAnalysis"
_END = "_AllNodes"  # after the name of the constraint
_REFERENCES = "References"


def is_analysis(obj):
    """Whether a document object is an analysis of FreeCAD's FEM workbench."""
    return isinstance(obj, FreeCAD.DocumentObject) and obj.isDerivedFrom(_ANALYSIS)


def complete(obj, mesh):
    """Gives a Fem.FemMesh, that of a FEM mesh object, the groups that the constraints beside it need now, and takes away
    those of others.
    """
    wanted = _wanted(obj, mesh)
    for group in mesh.Groups:
        name = mesh.getGroupName(group)
        if name.endswith(_END) and set(mesh.getGroupElements(group)) != wanted.get(name):
            mesh.removeGroup(group)
        else:
            wanted.pop(name, None)
    for name, nodes in sorted(wanted.items()):
        mesh.addGroupElements(mesh.addGroup(name, "Node"), sorted(nodes))


def _update(obj):
    """The same for the mesh that an object holds."""
    there = {name: set(nodes) for name, nodes in fem.groups_of(obj.FemMesh).items() if name.endswith(_END)}
    if there != _wanted(obj, obj.FemMesh):
        touched = "Touched" in obj.State
        mesh = obj.FemMesh.copy()
        complete(obj, mesh)
        obj.FemMesh = mesh
        if not touched:
            obj.purgeTouched()


def _wanted(obj, mesh):
    """{name of a group: numbers of its nodes}."""
    source = obj.Proxy.sources(obj)[0]
    if source is None:
        return {}
    part, found, groups = frames.leaf_of(source), {}, None
    for constraint in _constraints_of(obj):
        references = [(owner, name) for owner, names in constraint.References for name in names]
        shapes = [part.Shape.getElement(name) for owner, name in references
                  if owner == part and name.startswith(("Face", "Edge", "Vertex"))]
        if len(shapes) == len(references) and any(map(_is_loose, shapes)):
            groups = groups or fem.groups_of(mesh)
            found[constraint.Name + _END] = set().union(*(
                _nodes_on(mesh, groups, name, shape) for (_, name), shape in zip(references, shapes)))
    return found


def _constraints_of(obj):
    """What refers to sub-elements in the analyses that have a mesh."""
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
    from .fem_mesh import FemMeshObject  # which imports this

    return [obj for obj in objects if isinstance(getattr(obj, "Proxy", None), FemMeshObject) and obj.Fingerprint]


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
            _update(mesh)

    def slotUndoDocument(self, document):
        """Called by FreeCAD, which brings back constraints but no earlier groups of a mesh."""
        for mesh in _meshes_of(document.Objects):
            _update(mesh)

    slotRedoDocument = slotAbortTransaction = slotUndoDocument


FreeCAD.addDocumentObserver(_Observer())
