# SPDX-License-Identifier: LGPL-2.1-or-later
"""quality: what any mesh is like."""

from .. import options
from ..compat import extension
from .meshes.surface_mesh import surface_of
from .sources import convert


def quality(mesh, shape=None, progress=None):
    """The MeshReport of a mesh: a Mesh.Mesh, a Mesh feature, a SurfaceMesh, or arrays (V, F).

    Open, non-manifold and wrongly oriented edges, degenerate and duplicate triangles, and self-intersections (triangles
    that cross, touch or fold onto each other) are counted; an error is raised for none of them.
    With `shape` (Part.Shape or document object) the report also has max_chord_height, the largest
    distance from the shape's faces of the triangles' corners, edge middles and centroids, and of points
    inside large triangles, measured apart from what the mesher measures; progress as for triangulate.
    Raises InvalidInput for anything else and for indices out of range.
    """
    surface = surface_of(mesh)
    options.require_callable(progress)
    if shape is None:
        return extension().report_with_crossings(surface, progress)
    return extension().measure_against(surface, convert.shape_of(shape), progress)
