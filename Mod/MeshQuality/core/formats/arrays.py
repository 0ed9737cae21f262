# SPDX-License-Identifier: LGPL-2.1-or-later
"""What writers in Python take of a mesh: points, elements and their groups as arrays."""

import numpy as np

# Nodes of a tetrahedron of order 2 as Abaqus, CGNS and Exodus list them: Gmsh exchanges the last two.
_COMMON_ORDER = [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]


def points_of(mesh, scale):
    """float64 (N, 3): the nodes of a SurfaceMesh or a CurvedMesh in the file's coordinates."""
    points = mesh.nodes if hasattr(mesh, "nodes") else mesh.vertices + mesh.origin
    return points * scale


def tetrahedra_in_common_order(mesh):
    """(E, 4 or 10) from 1; without rows where there are none."""
    tetrahedra = getattr(mesh, "tetrahedra", np.zeros((0, 4), dtype=np.int32))
    return tetrahedra[:, [k for k in _COMMON_ORDER if k < tetrahedra.shape[1]]] + 1


def element_blocks(names, group):
    """[(name, indices of its elements), ...] of the groups that have any."""
    order = np.argsort(group, kind="stable")
    ends = np.searchsorted(group[order], np.arange(len(names) + 1))
    return [(name, order[ends[i]:ends[i + 1]]) for i, name in enumerate(names) if ends[i] < ends[i + 1]]
