# SPDX-License-Identifier: LGPL-2.1-or-later
"""improve: better triangles for a mesh that has no CAD behind it."""

from .. import options
from ..compat import extension
from .meshes.surface_mesh import SurfaceMesh, surface_of


def improve(mesh, min_angle=25.0, tolerance=None, feature_angle=35.0, progress=None):
    """The same surface with better triangles, for a mesh that has no CAD behind it.

    mesh           Mesh.Mesh, Mesh feature, SurfaceMesh, or arrays (V, F); it need not be closed
    min_angle      degrees, 0 < a <= 34: what the smallest angle of every triangle is to reach
    tolerance      mm: the surface changes only where corners, edge middles and centres of the new
                   triangles stay within it of the surface given, and the vertices given within it
                   of the new surface; a thousandth of the largest dimension unless given
    feature_angle  degrees: edges where the surface turns by more than this stay, borders too
    progress       as for triangulate

    Returns a SurfaceMesh; report.exempt names the triangles that stay below min_angle, and why.
    Raises InvalidInput for a mesh with a triangle that names a vertex twice; Cancelled.
    """
    values = options.check(options.IMPROVE, {
        "min_angle": min_angle, "tolerance": tolerance, "feature_angle": feature_angle})
    options.require_callable(progress)
    module = extension()
    core_options = module.ImproveOptions()
    options.hand_over(values, core_options)
    return SurfaceMesh(module.improve(surface_of(mesh, measured=False), core_options, progress))
