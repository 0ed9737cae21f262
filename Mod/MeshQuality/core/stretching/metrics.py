# SPDX-License-Identifier: LGPL-2.1-or-later
"""Metrics at the vertices of a mesh: symmetric matrices by which an edge e of the wanted length has e M e = 1."""

import numpy as np

from .cad_pairs import matrices, sixes

_CHORD = 6.0  # h^2 = 6 distance / curvature: an equilateral triangle of that side on a sphere has this distance at its centre


def by_curvature(curvatures, normals, distance, longest, stretching):
    """(n, 6): lengths that have the distance (mm) in the directions of the two principal curvatures, at most `longest` and
    at most `stretching` times the shorter one; none is below the distance itself.
    """
    values, vectors = np.linalg.eigh(matrices(curvatures))
    # The eigenvector nearest to the normal has no curvature of the surface.
    off = np.argmax(np.abs(np.einsum("nij,ni->nj", vectors, normals)), axis=1)
    values = np.abs(values)
    values[np.arange(len(off)), off] = 0.0
    return _bounded(np.minimum(values / (_CHORD * distance), distance**-2.0), vectors, longest, stretching)


def bounded(rows, longest, stretching):
    """(n, 6) of metrics that are given: eigenvalues below 0 count as 0; lengths bounded as above."""
    values, vectors = np.linalg.eigh(matrices(rows))
    return _bounded(np.maximum(values, 0.0), vectors, longest, stretching)


def _bounded(values, vectors, longest, stretching):
    values = np.maximum(values, longest**-2.0)
    values = np.maximum(values, values.max(axis=1)[:, None] / stretching**2)
    return sixes(np.einsum("nij,nj,nkj->nik", vectors, values, vectors))


def with_curves(rows, tangents, curvatures, distance, stretching):
    """(n, 6) that along tangents (n, 3) have at most the length for the curvature of a curve, and bounded stretching."""
    along = np.minimum(curvatures / (8.0 * distance), distance**-2.0)
    full = matrices(rows)
    have = np.einsum("ni,nij,nj->n", tangents, full, tangents)
    outer = tangents[:, :, None] * tangents[:, None, :]
    across = (np.trace(full, axis1=1, axis2=2) - have) / 2.0
    full = full + np.maximum(along - have, 0.0)[:, None, None] * outer
    return sixes(full + np.maximum(along / stretching**2 - across, 0.0)[:, None, None] * (np.eye(3) - outer))


def within(rows, across, widths):
    """(n, 6) that in directions (n, 3) want edges no longer than widths (mm), or than the shortest ones in any direction."""
    full = matrices(rows)
    have = np.einsum("ni,nij,nj->n", across, full, across)
    wanted = np.minimum(widths**-2.0, np.linalg.eigvalsh(full).max(axis=1))
    return sixes(full + np.maximum(wanted - have, 0.0)[:, None, None] * across[:, :, None] * across[:, None, :])


def shortest(rows):
    """float64 (n,), mm: the least length that metrics (n, 6) want in any direction."""
    return np.linalg.eigvalsh(matrices(rows)).max(axis=1) ** -0.5


def main_lengths(rows, normals):
    """Two arrays (n, 3), mm: the directions within the surface in which metrics want the longest and the shortest edges, as long as they
    want them.
    """
    values, vectors = np.linalg.eigh(matrices(rows))
    off = np.argmax(np.abs(np.einsum("nij,ni->nj", vectors, normals)), axis=1)
    each = np.arange(len(rows))
    values[each, off] = np.inf
    order = np.argsort(values, axis=1)
    return tuple(vectors[each, :, order[:, k]] / np.sqrt(values[each, order[:, k]])[:, None] for k in (0, 1))


def longest_direction(rows, normals):
    """(n, 3), mm: the first of main_lengths."""
    return main_lengths(rows, normals)[0]
