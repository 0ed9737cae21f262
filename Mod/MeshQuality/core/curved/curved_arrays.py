# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrays of which the core makes a curved mesh."""

# The arrays that make up a curved mesh, and what document objects call them.
ARRAYS = {
    "Nodes": "nodes", "NodeEntity": "node_entity", "EdgeNodes": "edges",
    "EdgeEntity": "edge_entity", "TriangleNodes": "triangles", "TriangleFace": "triangle_face",
    "TriangleFaceBehind": "triangle_face_behind",
    "TriangleQuality": "triangle_quality", "TetrahedronNodes": "tetrahedra",
    "TetrahedronSolid": "tetrahedron_solid", "TetrahedronQuality": "tetrahedron_quality",
}
