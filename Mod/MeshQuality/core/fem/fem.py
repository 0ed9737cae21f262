# SPDX-License-Identifier: LGPL-2.1-or-later
"""FEM meshes of FreeCAD, made of curved elements of order 1 or 2."""

from collections import deque
from dataclasses import dataclass
from itertools import islice

import numpy as np

from ...errors import Error, InvalidInput
from ..elements import kinds
from ..sources import convert

# FreeCAD's tetrahedra are turned the other way round than Gmsh's, and their middle nodes come in another order;
# triangles and edges are alike.
_TETRAHEDRON = (1, 0, 2, 3, 4, 6, 5, 9, 7, 8)
MAX_ORDER = 2
_NAMES = {"tetrahedron": "Volume", "triangle": "Face", "line": "Edge"}
_STEP = 2000  # nodes or elements: some milliseconds


@dataclass(frozen=True)
class Elements:
    """What a Fem.FemMesh is made of, as Python lists, which any thread may make.

    points  the coordinates of all nodes: x, y, z
    blocks  [(kind, first number, nodes of each element), ...], the numbers of a block go up by one; kind is
            "Volume", "Face" or "Edge"
    groups  [(name, kind, numbers of elements), ...]
    """

    points: list
    blocks: list
    groups: list


def module():
    """FreeCAD's module Fem. Raises Error where FreeCAD is built without it."""
    try:
        import Fem
    except ImportError as error:
        raise Error(f"this FreeCAD has no FEM workbench ({error}): install a FreeCAD that is built with it") from error
    return Fem


def elements_of(curved, groups):
    """The Elements of a CurvedMesh: the tetrahedra of a volume mesh, the triangles otherwise.

    groups  whether the triangles on the CAD faces and the edges on the CAD edges are elements, too, and all
            elements of a CAD entity a group by FreeCAD's name for that: Solid1, Face1, Edge1
    Raises InvalidInput for higher orders, which FreeCAD's FEM meshes cannot hold.
    """
    if curved.order > MAX_ORDER:
        raise InvalidInput(f"a FEM mesh of FreeCAD has order 1 or 2, not {curved.order}: curve with order=2")
    found = _kinds(curved)
    behind = curved.triangle_face_behind  # an element between two solids is in the group of either's face
    blocks, named, first = [], [], 1
    for kind, nodes, entity, name in found if groups else found[:1]:
        blocks.append((kind, first, convert.lists(nodes + 1)))
        if groups:
            named += _groups(kind, name, [entity, *([behind] if kind == "Face" and len(behind) else [])], first)
        first += len(nodes)
    return Elements([convert.lists(column) for column in np.ascontiguousarray(curved.nodes.T)], blocks, named)


_TYPES = {1: "Edge", 2: "Face", 3: "Volume"}  # by dimension


def elements_of_mesh(mesh):
    """The Elements of an ElementMesh of orders 1 and 2, with its groups; nodes in the middle of faces and volumes, which
    FreeCAD's FEM meshes do not have, are left out. Raises InvalidInput for higher orders.
    """
    highest = max(block.order for block in mesh.blocks)
    if highest > MAX_ORDER:
        raise InvalidInput(f"a FEM mesh of FreeCAD has order 1 or 2, and the file has elements of order {highest}: read it by "
                           "mq.read_mesh")
    blocks, first, starts = [], 1, []
    for block in mesh.blocks:
        count = kinds.serendipity_count(block.kind, block.nodes.shape[1])
        nodes = block.nodes[:, :count][:, np.argsort(kinds.from_mirrored(block.kind, count))]
        blocks.append((_TYPES[kinds.DIMENSION[block.kind]], first, nodes))
        starts.append(first)
        first += len(nodes)
    used, numbers = np.unique(np.concatenate([nodes.ravel() for _, _, nodes in blocks]), return_inverse=True)
    numbers, at = numbers.ravel() + 1, 0
    for i, (kind, start, nodes) in enumerate(blocks):
        blocks[i] = kind, start, convert.lists(numbers[at:at + nodes.size].reshape(nodes.shape))
        at += nodes.size
    groups = {}
    for name, parts in mesh.group_members.items():
        for block, rows in parts:
            groups.setdefault((name, blocks[block][0]), []).extend(convert.lists(rows + starts[block]))
    return Elements([convert.lists(column) for column in np.ascontiguousarray(mesh.nodes[used].T)], blocks,
                    [(name, kind, members) for (name, kind), members in groups.items() if members])


def _kinds(curved):
    """[(kind, nodes by element, CAD entity by element, name of that), ...], of the highest dimension first."""
    found = [("Face", curved.triangles, curved.triangle_face, "Face"),
             ("Edge", curved.edges, curved.edge_entity, "Edge")]
    if len(curved.tetrahedra):
        count = curved.tetrahedra.shape[1]
        turned = curved.tetrahedra[:, [k for k in _TETRAHEDRON if k < count]]
        found.insert(0, ("Volume", turned, curved.tetrahedron_solid, "Solid"))
    return found


def _groups(kind, name, entities, first):
    """The groups of one kind of element; what lies on no CAD entity is in none.

    entities  arrays of the CAD entity by element: an element is in the group of each
    """
    found = {}
    for entity in entities:
        for numbers in convert.face_segments(entity):
            index = int(entity[numbers[0]])
            if index >= 0:
                found.setdefault(index, []).extend(convert.lists(numbers + first))
    for index, numbers in sorted(found.items()):
        yield f"{name}{index + 1}", kind, numbers


def groups_from_rows(groups, elements):
    """The groups of given.carried_groups in the form of the groups of Elements."""
    first = {kind: number for kind, number, _ in elements.blocks}
    return [(name, _NAMES[kind], convert.lists(rows + first[_NAMES[kind]]))
            for name, parts in groups.items() for kind, rows in parts.items() if len(rows)]


def mesh_of(elements):
    """A Fem.FemMesh of Elements. SMESH keeps lists of all its meshes, so that only the main thread may make one
    while the window shows others.
    """
    mesh = module().FemMesh()
    deque(fill(mesh, elements), maxlen=0)
    return mesh


def fill(mesh, elements):
    """Fills an empty Fem.FemMesh with Elements, as mesh_of; yields after each of many short steps."""
    # map, as FreeCAD takes one element a call: a loop in Python takes a third longer.
    count = len(elements.points[0])
    yield from _in_steps(map(mesh.addNode, *elements.points, range(1, count + 1)), count)
    for kind, first, nodes in elements.blocks:
        yield from _in_steps(map(getattr(mesh, f"add{kind}"), nodes, range(first, first + len(nodes))), len(nodes))
    for name, kind, numbers in elements.groups:
        mesh.addGroupElements(mesh.addGroup(name, kind), numbers)
        yield


def _in_steps(calls, count):
    for _ in range(0, count, _STEP):
        deque(islice(calls, _STEP), maxlen=0)
        yield


def groups_of(mesh):
    """{name: numbers of elements or nodes} of a Fem.FemMesh."""
    return {mesh.getGroupName(group): mesh.getGroupElements(group) for group in mesh.Groups}
