# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which sides of the triangles of a mesh lie on edges of the shape."""

import numpy as np


def edges_of_shape(mesh, ends, wanted, shape):
    """int (T, 3): which of the wanted edges of the shape each side of the triangles lies on, -1: none.

    A side lies on an edge where both of its ends do, and triangles of different faces, or only one triangle, meet
    in it. The seam of a closed face has the same face on both sides: there the ends alone tell.
    """
    entity = np.asarray(mesh.vertex_entity)[ends]
    dimension, index = entity[..., 0], entity[..., 1]
    keys = np.sort(ends.reshape(-1, 2).astype(np.int64), axis=1)
    _, side, uses = np.unique(keys[:, 0] << 32 | keys[:, 1], return_inverse=True, return_counts=True)
    face = np.repeat(np.asarray(mesh.triangle_face), 3)
    low, high = np.full(len(uses), np.iinfo(np.int64).max), np.full(len(uses), -1)
    np.minimum.at(low, side, face)
    np.maximum.at(high, side, face)
    border = ((uses == 1) | (low != high))[side].reshape(len(ends), 3)
    found = np.full((len(ends), 3), -1)
    vertices, edges_of_shape = shape.Vertexes, shape.Edges
    for edge in wanted:
        inside = (dimension == 1) & (index == edge)
        at_ends = (dimension == 0) & np.isin(index, _ends_of(edges_of_shape[edge], vertices))
        on_edge = (inside | at_ends).all(axis=2)
        if inside.any():
            on_edge &= inside.any(axis=2)
        chosen = on_edge & border
        found[chosen if chosen.any() else on_edge] = edge
    return found


def _ends_of(edge, vertices):
    """The indices of the vertices at the ends of a Part.Edge."""
    return [i for i, vertex in enumerate(vertices) if any(vertex.isSame(end) for end in edge.Vertexes)]
