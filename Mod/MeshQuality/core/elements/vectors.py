# SPDX-License-Identifier: LGPL-2.1-or-later
"""Products of rows of vectors."""

import numpy as np


def lengths(vectors):
    return np.sqrt(np.einsum("...i,...i->...", vectors, vectors))


def dot(a, b):
    return np.einsum("...i,...i->...", a, b)


def cross(a, b):
    """As np.cross, in half the time."""
    found = np.empty(np.broadcast_shapes(a.shape, b.shape))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        found[..., i] = a[..., j] * b[..., k] - a[..., k] * b[..., j]
    return found
