#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long meshes of other programs take to be read and written: a block of tetrahedra in each format.

    /usr/bin/python3 benchmarks/solvers/read_formats.py [--cells 56] [--formats .msh .inp]

prints a line a format: the size of the file, and CPU s to write and to read it. Six tetrahedra fill a cell: 56 cells along
an edge are 1,053,696.
"""

import os
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad


def block(cells):
    """An ElementMesh of a cube of tetrahedra with its triangles below as a group."""
    import itertools

    import numpy as np
    from MeshQuality.core.meshes.element_mesh import ElementMesh
    from MeshQuality.core.elements.assembly import assembled
    from MeshQuality.core.elements.parts import Parts, Section

    at = np.arange((cells + 1) ** 3).reshape((cells + 1,) * 3)
    points = np.stack(np.unravel_index(at.ravel(), at.shape), axis=1) / cells * 97.3
    rows = []
    for axes in itertools.permutations(range(3)):
        step, corners = np.zeros(3, dtype=int), []
        for axis in (None, *axes):
            if axis is not None:
                step[axis] = 1
            corners.append(at[tuple(slice(i, i + cells) for i in step)].ravel())
        odd = sum(a > b for a, b in itertools.combinations(axes, 2)) % 2
        rows.append(np.stack([corners[k] for k in ((0, 1, 3, 2) if odd else (0, 1, 2, 3))], axis=1))
    low = at[:, :, 0]
    quads = np.stack([low[:-1, :-1], low[1:, :-1], low[1:, 1:], low[:-1, 1:]], axis=-1).reshape(-1, 4)
    triangles = np.concatenate([quads[:, [0, 2, 1]], quads[:, [0, 3, 2]]])
    tetrahedra = np.concatenate(rows)
    parts = Parts(points, [Section("tetrahedron", tetrahedra), Section("triangle", triangles)])
    parts.add_to_group("body", np.arange(1, len(tetrahedra) + 1))
    parts.add_to_group("below", np.arange(len(tetrahedra) + 1, len(tetrahedra) + len(triangles) + 1))
    return ElementMesh(assembled(parts))


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--cells", type=int, default=56, help="along an edge of the block")
    result.add_argument("--formats", nargs="+", help="extensions (default: all that hold it)")
    return result


def work(arguments):
    import MeshQuality as mq

    mesh, rows = block(arguments.cells), []
    print(f"{mesh}\nformat       MB  write s  read s")
    with tempfile.TemporaryDirectory() as folder:
        for ending in arguments.formats or mesh.suffixes:
            path, times = os.path.join(folder, f"mesh{ending}"), [time.process_time()]
            mesh.write(path)
            times.append(time.process_time())
            found = mq.read_mesh(path)
            times.append(time.process_time())
            if len(found.blocks[0].nodes) != len(mesh.blocks[0].nodes):
                raise ValueError(f"{ending}: {found}")
            rows.append((ending, os.path.getsize(path) / 1e6, times[1] - times[0], times[2] - times[1]))
            print("{:8} {:6.0f}  {:7.1f} {:7.1f}".format(*rows[-1]), flush=True)
            os.remove(path)
    return {"columns": ("format", "MB", "write", "read"), "rows": rows}


inside_freecad.start(__file__, parser(), work)
