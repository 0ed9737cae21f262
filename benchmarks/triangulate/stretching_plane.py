#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of a plane face in given metrics, beside those of BAMG in Gmsh: triangles, quality in the metric, angles, seconds.

    /usr/bin/python3 benchmarks/triangulate/stretching_plane.py [--gmsh PYTHON]

PYTHON is one that has the module gmsh. BAMG gets the metric at the nodes of a fine mesh. Quality and lengths are computed from the
points of both meshes and the metric itself.
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
from triangle_angles import largest_angles

SIZE = 100.0, 50.0, 10.0  # mm: the plate and the radius of the hole in its middle

GMSH = """
import sys, time, json, numpy, gmsh
given = numpy.load(sys.argv[1])
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
width, height, radius = given["size"]
occ = gmsh.model.occ
plate, hole = occ.addRectangle(0, 0, 0, width, height), occ.addDisk(width / 2, height / 2, 0, radius, radius)
occ.cut([(2, plate)], [(2, hole)])
occ.synchronize()
points, triangles, metric = given["points"], given["triangles"], given["metric"]
full = metric[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]]
rows = [numpy.concatenate([points[t].T.ravel(), full[t].ravel()]) for t in triangles]
view = gmsh.view.add("metric")
gmsh.view.addListData(view, "TT", len(rows), numpy.concatenate(rows))
field = gmsh.model.mesh.field.add("PostView")
gmsh.model.mesh.field.setNumber(field, "ViewIndex", 0)
gmsh.model.mesh.field.setAsBackgroundMesh(field)
for name, value in (("Algorithm", 7), ("MeshSizeFromPoints", 0), ("MeshSizeFromCurvature", 0), ("MeshSizeExtendFromBoundary", 0)):
    gmsh.option.setNumber("Mesh." + name, value)
start = time.process_time()
gmsh.model.mesh.generate(2)
seconds = time.process_time() - start
tags, places, _ = gmsh.model.mesh.getNodes()
_, corners = gmsh.model.mesh.getElementsByType(2)
number = {tag: i for i, tag in enumerate(tags.tolist())}
numpy.savez(sys.argv[2], points=places.reshape(-1, 3), triangles=numpy.array([number[t] for t in corners.tolist()]).reshape(-1, 3), seconds=seconds)
"""


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--gmsh", default="/usr/bin/python3")
    return result


def metrics():
    """{name: function of points (n, 3) that returns (n, 6)}."""
    import numpy as np

    def of(along, across, lengths):
        both = [direction[:, :, None] * direction[:, None, :] / length[:, None, None]**2 for direction, length in zip((along, across), lengths)]
        full = both[0] + both[1]
        full[:, 2, 2] = 1e-4
        return full[:, [0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]

    def line(points):  # a layer along y = 12
        size = 0.4 + 0.25 * np.abs(points[:, 1] - 12.0)
        ones, zeros = np.ones(len(points)), np.zeros(len(points))
        return of(np.stack([ones, zeros, zeros], axis=1), np.stack([zeros, ones, zeros], axis=1), (np.minimum(5.0 * size, 8.0), np.minimum(size, 8.0)))

    def ring(points):  # a front around the hole
        out = points - np.array([SIZE[0] / 2, SIZE[1] / 2, 0.0])
        distance = np.maximum(np.linalg.norm(out[:, :2], axis=1), 1e-9)
        across = np.stack([out[:, 0] / distance, out[:, 1] / distance, 0 * distance], axis=1)
        along = np.stack([-across[:, 1], across[:, 0], 0 * distance], axis=1)
        size = 0.3 + 0.3 * np.abs(distance - 16.0)
        return of(along, across, (np.minimum(4.0 * size, 6.0), np.minimum(size, 6.0)))

    return {"layer along a line": line, "front around the hole": ring}


def row(name, mesh, points, triangles, metric, seconds):
    import numpy as np

    corners = points[triangles]
    sides = np.roll(corners, -1, axis=1) - corners
    rows = metric(corners.reshape(-1, 3)).reshape(-1, 3, 6)

    def form(m, a, b):
        full = m[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]].reshape(-1, 3, 3)
        return np.einsum("ni,nij,nj->n", a, full, b)

    lengths = np.stack([np.sqrt(form((rows[:, k] + rows[:, (k + 1) % 3]) / 2, sides[:, k], sides[:, k])) for k in range(3)], axis=1)
    mean = rows.sum(axis=1)
    one, other, last = (form(mean, sides[:, k], sides[:, k]) for k in range(3))
    mixed = form(mean, sides[:, 0], sides[:, 1])
    quality = 2 * np.sqrt(3) * np.sqrt(np.maximum(one * other - mixed**2, 0)) / (one + other + last)
    angles = largest_angles(points, triangles)
    print(f"{name} | {mesh} | {len(triangles):,} | {quality.mean():.2f} | {quality.min():.2f} | {(quality < 0.3).sum()} | {lengths.mean():.2f} | "
          f"{lengths.max():.2f} | {angles.max():.1f} | {(angles > 150).sum()} | {seconds:.1f}", flush=True)
    return [name, mesh, len(triangles), float(quality.mean()), float(quality.min()), int((quality < 0.3).sum()), float(lengths.mean()),
            float(lengths.max()), float(angles.max()), seconds]


def by_bamg(python, metric, folder):
    """(points, triangles, seconds)."""
    import numpy as np
    import Part

    import MeshQuality as mq

    fine = mq.triangulate(Part.makePlane(SIZE[0], SIZE[1]), max_edge=0.35)
    points = fine.vertices + fine.origin
    np.savez(f"{folder}/given.npz", points=points, triangles=fine.triangles, metric=metric(points), size=SIZE)
    subprocess.run([python, "-c", GMSH, f"{folder}/given.npz", f"{folder}/made.npz"], check=True, env=inside_freecad.system_environment())
    made = np.load(f"{folder}/made.npz")
    return made["points"], made["triangles"], float(made["seconds"])


def work(asked):
    import FreeCAD
    import Part

    import MeshQuality as mq

    hole = Part.Face(Part.Wire(Part.makeCircle(SIZE[2], FreeCAD.Vector(SIZE[0] / 2, SIZE[1] / 2, 0))))
    plate = Part.makePlane(SIZE[0], SIZE[1]).cut(hole)
    rows = []
    print("metric | mesh | triangles | mean quality | least | below 0.3 | mean length | longest | largest angle | above 150 | CPU s")
    for name, metric in metrics().items():
        start = time.process_time()
        found = mq.triangulate(plate, metric=metric)
        rows.append(row(name, "ours", found.vertices + found.origin, found.triangles, metric, time.process_time() - start))
        with tempfile.TemporaryDirectory() as folder:
            points, triangles, seconds = by_bamg(asked.gmsh, metric, folder)
        rows.append(row(name, "BAMG", points, triangles, metric, seconds))
    print(json.dumps({"rows": len(rows)}))
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
