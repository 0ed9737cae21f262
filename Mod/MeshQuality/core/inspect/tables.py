# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of triangles: areas, and files with a line for each."""

import csv
import io
import os

import numpy as np

from ..meshes.writing import atomically
from ..sources import convert


def areas_of(mesh):
    """float64 (T,), mm^2, of the triangles of a SurfaceMesh."""
    corners = mesh.vertices[mesh.triangles]
    return 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)


def write(path, head, rows):
    """Writes rows below their head as CSV. Raises IoError naming the path."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(head)
    table.writerows(rows)

    def write_into(ready):
        with open(ready, "w", encoding="ascii") as stream:
            stream.write(text.getvalue())

    atomically(os.fsdecode(convert.file_name(path)), ".csv", write_into)


def connected(triangles, chosen):
    """The chosen triangles by regions connected by vertices: index arrays."""
    if not len(chosen):
        return []
    _, corners = np.unique(triangles[chosen], return_inverse=True)
    corners = corners.reshape(-1, 3)
    label = np.arange(len(chosen))
    at_vertex = np.full(corners.max() + 1, len(chosen))
    while True:
        np.minimum.at(at_vertex, corners, label[:, None])
        lower = at_vertex[corners].min(axis=1)
        lower = lower[lower]
        if np.array_equal(lower, label):
            break
        label = lower
    order = np.argsort(label, kind="stable")
    return np.split(chosen[order], np.flatnonzero(np.diff(label[order])) + 1)
