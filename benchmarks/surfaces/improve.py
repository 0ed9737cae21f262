#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Improving meshes: triangles, smallest angle, triangles below 25 degrees, and time.

    /usr/bin/python3 benchmarks/surfaces/improve.py [--only 'nut*']

FreeCAD's standard meshes of CAD parts (deflection a thousandth of the size, angular deflection 0.5)
and meshes from files, both of $MESHQUALITY_DATA (default: ../shared/data beside the repository).
Seconds are the processor's of mq.improve. Distances are the largest of corners and centres of one
surface from the other one, new from given and back, as parts of the size.
"""

import fnmatch
import gzip
import shutil
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

PARTS = ("linkrods.step", "netgen_screw.step", "gmsh_t20_data.step", "frame.step", "SCDR.stp")
MESHES = ("ballA.off", "casting.off", "Octocat.obj.gz", "nut-big.obj", "screw-big.obj",
          "3DBenchy.obj")
ANGLE = 25.0
HEAD = f"{'':<20} {'triangles':>9} {'angle':>6} {'below':>6}    {'after':>7} {'angle':>6} " \
       f"{'below':>6} {'CPU s':>7} {'distance':>8} {'back':>8}"


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--data", default=str(inside_freecad.data_folder()),
                        help="folder with cad/ and mesh/")
    result.add_argument("--only", default="*", metavar="PATTERN", help="names of files")
    return result


def standard_mesh(path):
    import MeshPart
    import Part

    shape = Part.read(str(path))
    box = shape.BoundBox
    size = max(box.XLength, box.YLength, box.ZLength)
    return MeshPart.meshFromShape(Shape=shape, LinearDeflection=1e-3 * size, AngularDeflection=0.5)


def read_mesh(path):
    import Mesh

    if path.suffix != ".gz":
        return Mesh.Mesh(str(path))
    with tempfile.TemporaryDirectory() as folder:
        plain = Path(folder, path.stem)
        with gzip.open(path) as packed, open(plain, "wb") as stream:
            shutil.copyfileobj(packed, stream)
        return Mesh.Mesh(str(plain))


def figures(surface):
    from MeshQuality.compat import extension

    angles = extension().triangle_shapes(surface)[0]
    return {"triangles": len(angles), "angle": float(angles.min()),
            "below": int((angles < ANGLE).sum())}


def measure(name, mesh):
    import MeshQuality as mq
    import numpy as np
    from MeshQuality.compat import extension
    from MeshQuality.core.sources import convert

    vertices, triangles = convert.arrays_of_mesh(mesh)
    given = mq.SurfaceMesh(convert.surface_of_arrays(extension(), vertices, triangles, measured=False))
    start = time.process_time()
    better = mq.improve(given, min_angle=ANGLE)
    seconds = time.process_time() - start
    size = float(np.ptp(vertices, axis=0).max())
    apart = [extension().surface_distance(a._surface, b._surface)[1] / size
             for a, b in ((better, given), (given, better))]
    return {"name": name, "before": figures(given._surface), "after": figures(better._surface),
            "seconds": seconds, "distances": apart}


def line(row):
    before, after = row["before"], row["after"]
    return f"{row['name']:<20} {before['triangles']:9} {before['angle']:6.2f} " \
           f"{before['below']:6} -> {after['triangles']:7} {after['angle']:6.2f} " \
           f"{after['below']:6} {row['seconds']:7.2f} {row['distances'][0]:8.1e} " \
           f"{row['distances'][1]:8.1e}"


def work(arguments):
    folder, rows = Path(arguments.data), []
    print(HEAD)
    for names, kind, read in ((PARTS, "cad", standard_mesh), (MESHES, "mesh", read_mesh)):
        for name in fnmatch.filter(names, arguments.only):
            path = folder / kind / name
            if not path.exists():
                print(f"{name:<20} skipped: it is not in {path.parent}")
                continue
            rows.append(measure(name, read(path)))
            print(line(rows[-1]), flush=True)
    return {"angle": ANGLE, "meshes": rows}


inside_freecad.start(__file__, parser(), work)
