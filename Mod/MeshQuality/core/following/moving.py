# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a mesh on another shape with the same faces, edges and vertices."""

import numpy as np

from ..places.entities import scale_and_shift
from ..places.places import place_on

_POLE = 1e-9  # a derivative below this fraction of the size: the surface is a point there
_RESIDUAL = 1e-11  # of the equations of inner points, relative


def moved(places, after):
    """(points (V, 3), (u, v) of the pairs) on the entities of another shape: points on vertices and edges go to these, and inner
    points by that by which (u, v) of the borders change, harmonically continued inwards.
    """
    uv, change, fixed = _change_at_borders(places, after)
    first, second, weights = _weights(places)
    for k in (0, 1):
        change[:, k] = _harmonic(first, second, weights, change[:, k], fixed[:, k])
    uv += change
    points = np.zeros_like(places.points)
    for v, (dimension, index) in enumerate(places.entity.tolist()):
        if dimension < 2:
            points[v] = place_on(after, dimension, index, places.share[v])
    for pair in np.flatnonzero(places.inner).tolist():
        face, vertex = places.pairs[pair].tolist()
        points[vertex] = after.surfaces[face].value(*uv[pair].tolist())
    return points, uv


def _change_at_borders(places, after):
    """(u, v) in the new ranges, the change of that at borders, and where it is known."""
    before = places.entities
    uv, change = np.zeros_like(places.uv), np.zeros_like(places.uv)
    fixed = np.repeat(~places.inner[:, None], 2, axis=1)
    for face in np.unique(places.pairs[:, 0]).tolist():
        of_face = np.flatnonzero(places.pairs[:, 0] == face)
        factors = scale_and_shift(before, after, face)
        uv[of_face] = places.uv[of_face] * factors[:, 0] + factors[:, 1]
        border = of_face[~places.inner[of_face]]
        if not len(border):
            continue
        found = np.array([places.on_border(after, face, v) for v in places.pairs[border, 1].tolist()]) - uv[border]
        for k, period in enumerate(after.periods(face)):
            if period:
                found[:, k] -= period * np.round((found[:, k] - found[0, k]) / period)
        change[border] = found
        _free_poles(places, face, border, fixed)
    return uv, change, fixed


def _free_poles(places, face, border, fixed):
    """Where a surface is a point along u or v, that parameter is none of the point's."""
    surface = places.entities.surfaces[face]
    for pair in border[places.entity[places.pairs[border, 1], 0] == 0].tolist():
        u, v = places.uv[pair].tolist()
        for k in (0, 1):
            if surface.getDN(u, v, 1 - k, k).Length < _POLE * places.entities.size:
                fixed[pair, k] = False


def _weights(places):
    """(first pair, second pair, weight) of the sides of all triangles: half the cotangent of the angle opposite."""
    at = places.points[places.triangles]
    found = []
    for k in range(3):
        a, b, c = at[:, k], at[:, k - 2], at[:, k - 1]
        one, other = b - a, c - a
        area = np.linalg.norm(np.cross(one, other), axis=1)
        weights = 0.5 * np.einsum("ij,ij->i", one, other) / np.maximum(area, 1e-300)
        found.append((places.corners[:, k - 2], places.corners[:, k - 1], np.where(area > 0.0, weights, 0.0)))
    return (np.concatenate(parts) for parts in zip(*found))


def _harmonic(first, second, weights, values, fixed):
    """Values that minimise the sum of weights times squared differences, where those that are not fixed are free: by conjugate
    gradients.
    """
    count, free = len(values), ~fixed
    degree = np.bincount(first, weights, count) + np.bincount(second, weights, count)
    diagonal = np.where(degree > 0.0, degree, 1.0)

    def applied(x):
        return np.where(free, degree * x - np.bincount(first, weights * x[second], count)
                        - np.bincount(second, weights * x[first], count), 0.0)

    x = np.where(fixed, values, 0.0)
    rest = -applied(x)
    wanted = _RESIDUAL * float(np.linalg.norm(rest))
    direction = shifted = rest / diagonal
    product = float(rest @ shifted)
    for _ in range(count):
        if np.linalg.norm(rest) <= wanted:
            break
        image = applied(direction)
        step = product / float(direction @ image)
        x = x + step * direction
        rest = rest - step * image
        shifted = rest / diagonal
        product, before = float(rest @ shifted), product
        direction = shifted + (product / before) * direction
    return x
