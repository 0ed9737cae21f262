# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces of a shape that are found again after an edit, by kind, area and place."""

import numpy as np

_SAME = 1e-6  # share of the size, and of an area, by which the same face may differ


def described(shape):
    """[kind, area, centre] of each face; centres as if the shape had no placement."""
    back = shape.Placement.inverse()
    return [[type(face.Surface).__name__, face.Area, *back.multVec(face.CenterOfMass)] for face in shape.Faces]


def followed(before, now):
    """{number of a face before an edit: its number after it}, of those that are found again; None: all keep their numbers.

    An edit of dimensions alone leaves the kinds of all faces, and FreeCAD then their numbers; unless one of them lies at
    another number, as in a shape that lists its faces in another order.
    """
    found = _same_faces(before, now) if now else {}
    same_kinds = [face[0] for face in before] == [face[0] for face in now]
    if same_kinds and all(index == place for index, place in found.items()):
        return None
    return found


def _same_faces(before, now):
    """{index before: index now} of faces that match exactly one face, which matches no other."""
    kinds, numbers = np.array([face[0] for face in now]), np.array([face[1:] for face in now], dtype=float)
    near = _SAME * max(float(np.ptp(numbers[:, 1:], axis=0).max(initial=0.0)), 1.0)
    found = {}
    for index, (kind, *wanted) in enumerate(before):
        off = np.abs(numbers - wanted)
        alike = np.flatnonzero((kinds == kind) & (off[:, 0] <= _SAME * wanted[0]) & (off[:, 1:] <= near).all(axis=1))
        if len(alike) == 1:
            found[index] = int(alike[0])
    taken = list(found.values())
    return {index: place for index, place in found.items() if taken.count(place) == 1}
