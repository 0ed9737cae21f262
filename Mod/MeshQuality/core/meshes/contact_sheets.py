# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contacts of solids as one sheet of triangles: the surface of an assembly as one conforming complex, in which more than two
triangles meet at the edges of a contact.
"""

import numpy as np

from ...compat import extension
from ..patches.patches import with_interfaces

SHEET = "sheet"  # the value of the option interfaces


def with_sheets(mesh, patches):
    """A SurfaceMesh that has the triangles between two solids once, and its Patches, in which they are
    "Solid1_and_Solid2".

    The triangles of the first solid are kept: normals point into the second one. Points in the same place are one
    vertex.
    """
    between = with_interfaces(patches, mesh, "and")
    opposite, solid = mesh.triangle_opposite, mesh.triangle_solid
    chosen = np.flatnonzero((opposite < 0) | (solid < solid[opposite]))
    vertices, triangles = _joined(mesh.vertices + mesh.origin, mesh.triangles[chosen])
    surface = extension().surface_from_arrays(vertices, triangles, mesh.triangle_face[chosen], False)
    used, numbers = np.unique(between.of_triangle[chosen], return_inverse=True)
    return type(mesh)(surface), between._replace(
        names=tuple(between.names[i] for i in used), colours=tuple(between.colours[i] for i in used),
        of_triangle=numbers.reshape(-1).astype(np.int32))


def _joined(points, triangles):
    """The points of the triangles with one for each place, in their order, and the triangles by these."""
    points = points + 0.0  # no -0, which would be another place
    _, first, place = np.unique(points.view([("", points.dtype)] * 3).reshape(-1), return_index=True, return_inverse=True)
    used, numbers = np.unique(first[place.reshape(-1)][triangles], return_inverse=True)
    return points[used], numbers.reshape(-1, 3).astype(np.int32)
