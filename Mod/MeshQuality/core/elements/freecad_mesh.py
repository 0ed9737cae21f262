# SPDX-License-Identifier: LGPL-2.1-or-later
"""FEM meshes of FreeCAD, and the meshes of this package, as Parts."""

import FreeCAD
import numpy as np

from ...errors import InvalidInput
from ..sources import frames
from . import kinds
from .parts import Parts, Section

_KINDS = {"Volumes": {4: "tetrahedron", 10: "tetrahedron", 5: "pyramid", 13: "pyramid", 6: "prism", 15: "prism",
                      8: "hexahedron", 20: "hexahedron", 27: "hexahedron"},
          "Faces": {3: "triangle", 6: "triangle", 4: "quadrilateral", 8: "quadrilateral", 9: "quadrilateral"},
          "Edges": {2: "line", 3: "line"}}


def parts_of(source):
    """The Parts of a Fem.FemMesh, a document object with one, a CurvedMesh or a SurfaceMesh; raises InvalidInput."""
    if hasattr(source, "triangle_face"):
        return _of_ours(source)
    if isinstance(frames.object_of(source), FreeCAD.DocumentObject):
        return _of_object(source)
    if _is_fem_mesh(source):
        return of_fem_mesh(source)
    raise InvalidInput("a Fem.FemMesh, a document object with one, a CurvedMesh or a SurfaceMesh is needed, not "
                       f"{type(source).__name__}")


def _is_fem_mesh(candidate):
    return type(candidate).__name__ == "FemMesh" and hasattr(candidate, "NodeCount")


def _of_object(source):
    linked, matrix = frames.linked_of(source)
    mesh = getattr(linked, "FemMesh", None)
    if not _is_fem_mesh(mesh):
        raise InvalidInput(f"'{frames.object_of(source).Label}' has no FEM mesh: give an object that has one, or its shape to "
                           "mq.curve")
    parts = of_fem_mesh(mesh)
    # The nodes are where the mesh itself stands, which follows the object's placement but not its containers and links.
    moved = frames.frame_of(source).toMatrix() * matrix * mesh.Placement.inverse().toMatrix()
    rows = np.array(moved.A).reshape(4, 4)
    parts.points = parts.points @ rows[:3, :3].T + rows[:3, 3]
    return parts


def of_fem_mesh(mesh):
    """The Parts of a Fem.FemMesh, where that stands by its own placement."""
    numbers = np.fromiter(mesh.Nodes, dtype=np.int64, count=mesh.NodeCount)
    points = np.array([tuple(point) for point in mesh.Nodes.values()], dtype=np.float64).reshape(-1, 3)
    parts = Parts(points, [], numbers)
    for name, known in _KINDS.items():
        elements = {}
        for number in getattr(mesh, name):
            elements.setdefault(len(nodes := mesh.getElementNodes(number)), []).append((number, nodes))
        for count, found in elements.items():
            if count not in known:
                raise InvalidInput(f"element {found[0][0]} has {count} nodes, which no element of {name} has that is known "
                                   "here: mesh the part with elements of order 1 or 2")
            order = kinds.from_mirrored(known[count], count)
            nodes = np.array([nodes for _, nodes in found], dtype=np.int64)[:, order]
            parts.sections.append(Section(known[count], nodes, np.array([number for number, _ in found])))
    for group in mesh.Groups:
        if mesh.getGroupElementType(group) != "Node":
            parts.add_to_group(mesh.getGroupName(group), sorted(mesh.getGroupElements(group)))
    return parts


def _of_ours(mesh):
    """The Parts of a CurvedMesh or a SurfaceMesh, with its patches as groups, else one for each CAD face, and one a solid."""
    curved = hasattr(mesh, "tetrahedra")
    parts = Parts(np.array(mesh.nodes if curved else mesh.vertices + mesh.origin), [])
    last = 0
    kinds_of = [("triangle", mesh.triangles, mesh.triangle_face, "Face")]
    if curved:
        kinds_of = [("tetrahedron", mesh.tetrahedra, mesh.tetrahedron_solid, "Solid"), *kinds_of,
                    ("line", mesh.edges, mesh.edge_entity, "Edge")]
    for kind, nodes, entity, name in kinds_of:
        numbers = np.arange(last + 1, last + len(nodes) + 1)
        last += len(nodes)
        entity = entity if len(entity) else np.full(len(nodes), -1)  # of a mesh that was made of no CAD
        parts.sections.append(Section(kind, np.array(nodes, dtype=np.int64), numbers, np.array(entity, dtype=np.int64)))
        if kind == "triangle" and mesh.patches:
            for i, patch in enumerate(mesh.patches):
                parts.add_to_group(patch, numbers[mesh.triangle_patch == i])
        else:
            for i in np.unique(entity[entity >= 0]).tolist():
                parts.add_to_group(f"{name}{i + 1}", numbers[entity == i])
    return parts
