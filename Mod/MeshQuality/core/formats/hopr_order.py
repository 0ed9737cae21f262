# SPDX-License-Identifier: LGPL-2.1-or-later
"""How HOPR orders nodes and sides of elements: nodes by their steps along three axes, sides as CGNS does."""

import functools

import numpy as np

from ..elements import kinds

# Corners of sides in CGNS' order, which begin at the corner that a neighbour's are counted from.
SIDES = {
    "tetrahedron": ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)),
    "pyramid": ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
    "prism": ((0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5), (0, 2, 1), (3, 4, 5)),
    "hexahedron": ((0, 3, 2, 1), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (4, 5, 6, 7)),
}
# The faces of kinds.FACES that these are.
SIDE_FACES = {kind: tuple([set(face) for face in kinds.FACES[kind]].index(set(side)) for side in sides)
              for kind, sides in SIDES.items()}


@functools.lru_cache(maxsize=None)
def of_gmsh(kind, order):
    """int (nodes,): which node in Gmsh's order each of HOPR's is."""
    steps = [(i, j, k) for k in range(order + 1) for j in range(order + 1) for i in range(order + 1)
             if _is_inside(kind, order, (i, j, k))]
    at = np.array(steps, dtype=float) / order
    if kind == "pyramid":  # whose apex is above the middle of its base
        at[:, :2] += at[:, 2:] / 2
    return kinds.matching(kind, kinds.count_of(kind, order), at)


def _is_inside(kind, order, step):
    i, j, k = step
    return {"tetrahedron": i + j + k <= order, "pyramid": max(i, j) + k <= order, "prism": i + j <= order, "hexahedron": True}[kind]
