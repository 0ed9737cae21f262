# SPDX-License-Identifier: LGPL-2.1-or-later
"""Angles of triangles from their points alone."""


def largest_angles(points, triangles):
    """Degrees, by triangle."""
    import numpy as np

    sides = np.roll(points[triangles], -1, axis=1) - points[triangles]
    lengths = np.linalg.norm(sides, axis=2)
    cosines = -np.einsum("tij,tij->ti", sides, np.roll(sides, 1, axis=1)) / (lengths * np.roll(lengths, 1, axis=1))
    return np.degrees(np.arccos(np.clip(cosines.min(axis=1), -1.0, 1.0)))
