# SPDX-License-Identifier: LGPL-2.1-or-later
"""FEM meshes as other programs make them, for tests. Runs inside FreeCAD."""

import numpy as np

import MeshQuality as mq
from MeshQuality.core.elements import kinds
from MeshQuality.core.fem import fem


def inside(shape, size):
    """Numbers of those tetrahedra of `straight_mesh` whose first edge has only tetrahedra without a face on the surface
    around it.
    """
    found = mq.curve(shape, order=1, volume=True, max_edge=size)
    surface = {frozenset(map(int, corners)) for corners in found.triangles}
    cells = [frozenset(map(int, corners)) for corners in found.tetrahedra]
    inner = [not any(cell - {corner} in surface for corner in cell) for cell in cells]
    edges = [frozenset(map(int, corners[:2])) for corners in found.tetrahedra]
    return [i for i, edge in enumerate(edges) if all(inner[k] for k, cell in enumerate(cells) if edge <= cell)]


def straight_mesh(shape, size, folded=()):
    """A Fem.FemMesh of second order whose middle nodes lie on chords, as other programs make it; of the tetrahedra `folded`
    the first middle node lies beyond the opposite face.
    """
    found = mq.curve(shape, order=1, volume=True, max_edge=size)
    numbers, nodes = {}, [tuple(point) for point in found.nodes]
    mesh = fem.module().FemMesh()

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in numbers:
            numbers[key] = len(nodes) + 1
            nodes.append(tuple((found.nodes[a] + found.nodes[b]) / 2))
        return numbers[key]

    order = np.argsort(kinds.from_mirrored("tetrahedron", 10))
    rows = [[*(corners + 1), *(middle(corners[a], corners[b]) for a, b in kinds.EDGES["tetrahedron"])]
            for corners in found.tetrahedra]
    faces = [[*(corners + 1), *(middle(corners[a], corners[b]) for a, b in kinds.EDGES["triangle"])]
             for corners in found.triangles]
    for i in folded:
        a, b, c, d = found.nodes[found.tetrahedra[i]]
        nodes[rows[i][4] - 1] = tuple((a + b) / 2 + 1.5 * ((c + d) / 2 - (a + b) / 2))
    for number, point in enumerate(nodes):
        mesh.addNode(*point, number + 1)
    for number, row in enumerate(rows):
        mesh.addVolume([int(row[k]) for k in order], number + 1)
    for number, row in enumerate(faces):
        mesh.addFace(list(map(int, row)), len(rows) + number + 1)
    return mesh
