# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of other programs as the core takes them to be curved."""

import numpy as np

from ..elements import kinds


_SIMPLICES = ("line", "triangle", "tetrahedron")


def is_mixed(mesh):
    """Whether an ElementMesh has prisms, pyramids, hexahedra or quadrilaterals."""
    return any(block.kind not in _SIMPLICES for block in mesh.blocks)


def corners_of(mesh, solids):
    """(nodes, triangles, tetrahedra, regions) of an ElementMesh that is not mixed: float64 (N, 3), int32 (T, 3), (E, 4) and
    (E,).

    solids  number of solids of the shape: in a shape with one solid, groups are materials or loads, not bodies
    """
    tetrahedra = [block for block in mesh.blocks if block.kind == "tetrahedron"]
    triangles = [block.nodes[:, :3] for block in mesh.blocks if block.kind == "triangle"]
    return (mesh.nodes, _joined(triangles, 3), _joined([block.nodes[:, :4] for block in tetrahedra], 4),
            _joined([_regions_of(block, solids) for block in tetrahedra], None))


def blocks_of(mesh, solids):
    """(nodes, elements, listed) of an ElementMesh: lists of (kind, int32 corners, int32 bodies), the solids, or else the surface,
    and beside solids what lies on surfaces.
    """
    parts = {2: [], 3: []}
    for block in mesh.blocks:
        corners = np.ascontiguousarray(block.nodes[:, :kinds.CORNERS[block.kind]], dtype=np.int32)
        regions = np.ascontiguousarray(_regions_of(block, solids), dtype=np.int32)
        parts.setdefault(kinds.DIMENSION[block.kind], []).append((block.kind, corners, regions))
    return (mesh.nodes, parts[3], parts[2]) if parts[3] else (mesh.nodes, parts[2], [])


def _regions_of(block, solids):
    """A number a body: the CAD solid of each element, where the file says these of all."""
    if solids < 2 or not (block.geometry >= 0).all():
        return np.zeros(len(block.nodes), dtype=np.int32)  # groups may be of materials: the core asks the shape
    return block.geometry


def _joined(parts, width):
    empty = np.empty(0 if width is None else (0, width), dtype=np.int32)
    return np.ascontiguousarray(np.concatenate([empty, *parts]), dtype=np.int32)


def carried_groups(mesh, curved):
    """{name: {kind: int (n,)}}: which of its elements a CurvedMesh has of each group of the ElementMesh that it was made of.

    Rows of curved.tetrahedra, curved.triangles and curved.edges, by kind: tetrahedron, triangle, line.
    """
    of_node = np.full(len(curved.nodes), -1, dtype=np.int32)
    of_node[:len(curved.given_node)] = curved.given_node
    ours = {kind: _keys(of_node[nodes[:, :kinds.CORNERS[kind]]])
            for kind, nodes in (("tetrahedron", curved.tetrahedra), ("triangle", curved.triangles), ("line", curved.edges))}
    found = {}
    for name, parts in mesh.group_members.items():
        for block, rows in parts:
            kind, nodes = mesh.blocks[block].kind, mesh.blocks[block].nodes
            rows = np.flatnonzero(np.isin(ours[kind], _keys(nodes[rows][:, :kinds.CORNERS[kind]])))
            of_kind = found.setdefault(name, {})
            of_kind[kind] = np.union1d(of_kind.get(kind, np.zeros(0, dtype=int)), rows)
    return found


def lost_of_group(mesh, name, carried):
    """How many elements of a group of the ElementMesh are not in carried_groups(...)[name]."""
    return sum(len(rows) for _, rows in mesh.group_members[name]) - sum(map(len, carried.values()))


def _keys(corners):
    """One key for each row, equal for elements with the same corners; a row with a new vertex, -1, matches no given
    element.
    """
    rows = np.ascontiguousarray(np.sort(corners, axis=1), dtype=np.int32)
    return rows.view(np.dtype((np.void, rows.itemsize * rows.shape[1]))).ravel()
