# SPDX-License-Identifier: LGPL-2.1-or-later
"""simplify: the same surface with fewer triangles, within a proven distance."""

import numpy as np

from .. import options
from ..compat import extension
from .meshes.surface_mesh import SurfaceMesh, surface_of

_RELATIVE = 1e-3  # tolerance where none is given, as a fraction of the largest dimension


class SimplifiedMesh(SurfaceMesh):
    """A SurfaceMesh with fewer triangles than the mesh it was made of.

    deviation  mm: no point of either surface is farther than this from the other one, proven
    """

    __slots__ = {"deviation": "mm, proven both ways"}

    def __init__(self, surface, deviation):
        super().__init__(surface)
        self.deviation = deviation


def simplify(mesh, tolerance=None, feature_angle=35.0, progress=None):
    """The same surface with fewer triangles: a SimplifiedMesh.

    mesh           Mesh.Mesh, Mesh feature, SurfaceMesh, or arrays (V, F): manifold and oriented; it need not be closed
    tolerance      mm: all points of each surface are within it of the other one, which is proven; a thousandth of the largest
                   dimension unless given
    feature_angle  degrees: edges where the surface turns by more than this stay edges, within the tolerance
    progress       as for triangulate

    What is closed stays closed, no handle goes, and no triangles meet that did not before. Triangles at an open border stay.
    Where the mesh has CAD faces, their borders stay within the tolerance, and the triangles keep their faces.
    Raises InvalidInput for a mesh that is not manifold and oriented, naming the remedy; Cancelled.
    """
    values = options.check(options.simplify.SIMPLIFY, {"tolerance": tolerance, "feature_angle": feature_angle})
    options.require_callable(progress)
    surface = surface_of(mesh, measured=False)
    if values["tolerance"] is None:
        values["tolerance"] = _RELATIVE * float(np.ptp(surface.vertices, axis=0).max(initial=0.0)) if len(surface.vertices) else 0.0
    return SimplifiedMesh(*extension().simplify(surface, values["tolerance"], values["feature_angle"], progress))
