#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many triangles stretched meshes need for a distance, beside those of equal sides and those of mmgs in the same metric.

    /usr/bin/python3 benchmarks/triangulate/stretching.py [--mmg PYTHON] [--relative FRACTION] [--only PART] [--real 40]

PYTHON is one that has mmgpy. mmgs gets the quality mesh, our metric at its vertices, and the distance. Distances are measured by
mq.quality of each mesh against the shape, angles from the points. With --real that many parts drawn at random from
$MESHQUALITY_DATA/cad, among files up to 150 kB with at most 12,000 triangles, with the default distance.
"""

import math
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
from triangle_angles import largest_angles

LARGEST_FILE, MOST_TRIANGLES = 150_000, 12_000  # bytes and triangles of real parts
SCREWS = "netgen_screw.step", "M6-1x12-countersunk-screw.step"  # the second one has a thread

MMG = """
import sys, numpy, mmgpy
given = numpy.load(sys.argv[1])
mesh = mmgpy.MmgMeshS(given["points"], given["triangles"])
mesh.set_field("tensor", numpy.ascontiguousarray(given["metric"]))
mesh.remesh(hausd=float(given["distance"]), hgrad=-1.0, verbose=-1)
numpy.savez(sys.argv[2], points=mesh.get_vertices(), triangles=mesh.get_triangles())
"""


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--mmg", default="")
    result.add_argument("--relative", type=float, default=1e-4, help="largest distance as a fraction of the size")
    result.add_argument("--only", default="")
    result.add_argument("--real", type=int, default=0)
    return result


def aerofoil(chord, x, y, z, points=30):
    """A closed wire with a section of 12 % thickness."""
    import FreeCAD
    import Part

    def half(s):
        return 0.6 * (0.2969 * math.sqrt(s) - 0.126 * s - 0.3516 * s * s + 0.2843 * s**3 - 0.1036 * s**4)

    shares = [(0.5 * (1 + math.cos(math.pi * i / points)), 1) for i in range(points + 1)]
    shares += [(0.5 * (1 - math.cos(math.pi * i / points)), -1) for i in range(1, points)]
    places = [FreeCAD.Vector(x + chord * s, y, z + side * chord * half(s)) for s, side in shares]
    curve = Part.BSplineCurve()
    curve.interpolate([*places, places[0]])
    return Part.Wire([curve.toShape()])


def parts():
    """{name: shape}."""
    import Part

    block = Part.makeBox(40, 30, 20)
    return {
        "cylinder": Part.makeCylinder(10, 40),
        "wing": Part.makeLoft([aerofoil(100, 0, 0, 0), aerofoil(50, 30, 150, 8)], True),
        "block, all edges rounded": block.makeFillet(5, block.Edges),
        "cone": Part.makeCone(10, 3, 30),
        "pipe": Part.makeCylinder(10, 60).cut(Part.makeCylinder(8, 60)),
        **{f"screw, {name}": Part.read(str(inside_freecad.data_folder() / "cad" / name)) for name in SCREWS},
    }


def by_mmg(python, mesh, shape, relative):
    """(points, triangles) of mmgs; None where it fails."""
    import numpy as np

    from MeshQuality.core.places.entities import Entities
    from MeshQuality.core.places.places import Places
    from MeshQuality.core.stretching.cad_pairs import CadPairs
    from MeshQuality.core.stretching.forms import Curvature

    places = Places(mesh, Entities(shape))
    pairs = CadPairs(places, places.corners)
    box = shape.BoundBox
    longest = max(box.XLength, box.YLength, box.ZLength)
    rows = Curvature(relative * longest, longest, 5.0).at(places.points[pairs.vertex], pairs.normals, pairs.curvatures)
    metric = np.zeros((len(places.points), 6))
    order = np.argsort(rows[:, :3].sum(axis=1))  # of several faces that which wants the shortest edges
    metric[pairs.vertex[order]] = rows[order]
    with tempfile.TemporaryDirectory() as folder:
        np.savez(f"{folder}/given.npz", points=places.points, triangles=mesh.triangles, metric=metric[:, [0, 3, 5, 1, 4, 2]],
                 distance=relative * longest)
        done = subprocess.run([python, "-c", MMG, f"{folder}/given.npz", f"{folder}/made.npz"], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, env=inside_freecad.system_environment())
        if done.returncode:
            return None
        made = np.load(f"{folder}/made.npz")
        return made["points"], made["triangles"]


def row(name, points, triangles, shape, seconds, more=""):
    import MeshQuality as mq

    report = mq.quality((points, triangles), shape)
    angles = largest_angles(points, triangles)
    print(f"{name} | {len(triangles):,} | {angles.max():.1f} | {(angles > 150).sum()} | {report.max_chord_height:.4f} | "
          f"{report.self_intersections} | {report.closed} | {more} | {seconds:.1f}", flush=True)
    return [name, len(triangles), float(angles.max()), report.max_chord_height, more, seconds]


def files(only):
    """Of real parts, in random order."""
    found = sorted(path for path in (inside_freecad.data_folder() / "cad").rglob("*")
                   if path.suffix.lower() in inside_freecad.CAD_SUFFIXES and path.stat().st_size <= LARGEST_FILE and only in path.name)
    random.Random(1).shuffle(found)
    return found


def real(asked):
    """One row a part: triangles of equal sides, stretched ones, what is said of them."""
    import Part

    import MeshQuality as mq

    rows = []
    print("part | equal sides | stretched | times fewer | largest angle | below 0.3, least quality | CPU s | notes")
    for path in files(asked.only):
        if len(rows) == asked.real:
            break
        shape = Part.read(str(path))
        try:
            equal = mq.triangulate(shape)
            if len(equal.triangles) > MOST_TRIANGLES:
                continue
            start = time.process_time()
            found = mq.triangulate(shape, metric="curvature")
        except mq.Error as error:
            print(f"{path.name}: {error}", flush=True)
            continue
        seconds, known = time.process_time() - start, found.metric_quality[found.metric_quality == found.metric_quality]
        low, least = int((known < 0.3).sum()), float(known.min(initial=1.0))
        notes = [str(note) for note in found.report.notes if note not in equal.report.notes]
        rows.append([path.name, len(equal.triangles), len(found.triangles), found.largest_angle, low, least, seconds, notes])
        print(f"{path.name} | {len(equal.triangles):,} | {len(found.triangles):,} | {len(equal.triangles) / len(found.triangles):.2f} | "
              f"{found.largest_angle:.1f} | {low}, {least:.2f} | {seconds:.1f} | {' '.join(notes)[:300]}", flush=True)
    ratios = sorted(row[1] / row[2] for row in rows)
    print(f"{len(rows)} parts; times fewer: median {ratios[len(ratios) // 2]:.2f}, best {ratios[-1]:.2f}; "
          f"{sum(ratio == 1.0 for ratio in ratios)} unchanged; {sum(row[4] == 0 for row in rows)} without a quality below 0.3")
    return {"rows": rows}


def work(asked):
    import MeshQuality as mq

    if asked.real:
        return real(asked)
    rows = []
    print("mesh | triangles | largest angle | above 150 | distance | crossings | closed | below 0.3, least quality | CPU s")
    for name, shape in parts().items():
        if asked.only not in name:
            continue
        times, meshes = [time.process_time()], []
        for metric in ("none", "curvature"):
            meshes.append(mq.triangulate(shape, chord_height_relative=asked.relative, metric=metric))
            times.append(time.process_time())
        equal, found = meshes
        quality = f"{(found.metric_quality < 0.3).sum()}, {found.metric_quality.min():.2f}"
        rows.append(row(f"{name}: equal sides", equal.vertices + equal.origin, equal.triangles, shape, times[1] - times[0]))
        rows.append(row(f"{name}: stretched", found.vertices + found.origin, found.triangles, shape, times[2] - times[1], quality))
        if asked.mmg:
            start = time.perf_counter()
            made = by_mmg(asked.mmg, equal, shape, asked.relative)
            if made is None:
                print(f"{name}: mmgs | failed", flush=True)
            else:
                rows.append(row(f"{name}: mmgs", *made, shape, time.perf_counter() - start))
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
