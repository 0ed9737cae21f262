# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances between two surfaces as Metro takes them (Cignoni, Rocchini, Scopigno 1998): from points of one to triangles of the
other, both ways, by VTK."""

import numpy as np


def even_points(corners, most, rng, corners_only=None):
    """Points that lie evenly on the area of triangles (T, 3, 3); of those that are marked only corners."""
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    chosen = rng.choice(len(corners), most, p=area / area.sum())
    shares = rng.dirichlet((1.0, 1.0, 1.0), most)
    if corners_only is not None:
        marked = corners_only[chosen]
        shares[marked] = np.eye(3)[rng.integers(3, size=marked.sum())]
    return np.einsum("ij,ijk->ik", shares, corners[chosen])


def distances(result, exact, most):
    """{"to": (mean, largest), "back": (mean, largest)} of two surfaces (V, F), in per cent of the diagonal of the box of the
    exact one. `most` points lie evenly on each surface; their mean counts, and the largest of theirs and of all vertices
    that the two do not share.
    """
    size = diagonal(exact)
    return {"to": _one_way(result, exact, most, size), "back": _one_way(exact, result, most, size)}


def diagonal(mesh):
    """That of the box of a surface (V, F)."""
    return float(np.linalg.norm(mesh[0].max(axis=0) - mesh[0].min(axis=0)))


def _one_way(start, target, most, size):
    from offset_parts import locator

    nearest, _, _ = locator(*target)
    points, triangles = start
    even = nearest(even_points(points[triangles], most, np.random.default_rng(7)))
    known = set(map(bytes, np.ascontiguousarray(target[0])))
    others = nearest([point for point in np.ascontiguousarray(points) if bytes(point) not in known])
    return tuple(float(100.0 * value / size) for value in (even.mean(), np.concatenate([even, others]).max()))
