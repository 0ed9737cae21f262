#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Booleans of the meshes of the data folder that are not closed, and of many operands in one pass.

    /usr/bin/python3 benchmarks/boolean/open_operands.py [--resolutions 129 257 513] [--only lion gearbox] [--many 4 16]

A box is taken from each mesh whose row of index.csv says that it is open or not manifold, and from closed ones that are
damaged here. "exact" says whether the exact
method takes it after its repairs; then the method "uniform" is timed at each resolution: stages, samples, the share of the
surface that is a guess, and whether the result is closed and how many faults it has. With --many, unions of as many spheres
in one pass beside two at a time: seconds, and the largest distance of vertices that were made from the spheres, in units of the
distance between rays. The status is 1 where a result is not closed, oriented and manifold.
"""

import csv
import gzip
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
import made_meshes
import numpy as np

# Closed meshes that are damaged here: all triangles missing that look upward, one in five missing, all made smaller by a fifth
# so that none touch.
DAMAGED = ("mesh/ifam_chair.stl.gz", "mesh/ifam_knot1.stl.gz")
HEAD = (f"{'mesh':<34} {'triangles':>9} {'exact':<8} {'rays':>5} {'method':<8} {'seconds':>7} {'winding':>7} {'samples':>9} "
        f"{'guess %':>7} {'kept':>8} {'made':>8} {'faults':>6} {'sound':>5}")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--resolutions", type=int, nargs="+", default=[129, 257, 513])
    result.add_argument("--only", nargs="+", help="only meshes whose names contain one of these words")
    result.add_argument("--many", type=int, nargs="*", default=[4, 16], help="numbers of operands of the unions")
    return result


def read_meshes(names):
    """(name, Mesh.Mesh) of files of the data folder."""
    import Mesh

    for name in names:
        path = inside_freecad.data_folder() / name
        with tempfile.TemporaryDirectory() as scratch:
            if path.suffix == ".gz":
                unpacked = Path(scratch) / path.stem
                unpacked.write_bytes(gzip.decompress(path.read_bytes()))
                path = unpacked
            mesh = Mesh.Mesh(str(path))
        if mesh.CountFacets:
            yield Path(name).name.split(".")[0], mesh


def dirty_meshes(only):
    """(name, Mesh.Mesh) of the meshes that are not closed or not manifold."""
    with open(inside_freecad.data_folder() / "index.csv", encoding="utf-8") as rows:
        names = [row["file"] for row in csv.DictReader(rows)
                 if row["kind"] == "mesh" and ("open" in row["flags"] or "non-manifold" in row["flags"])]
    return read_meshes([name for name in names if not only or any(word in name for word in only)])


def damaged_meshes(only):
    """(name, (V, F)) of closed meshes that were damaged beyond repair."""
    for name, mesh in read_meshes(DAMAGED):
        points = np.array([(p.x, p.y, p.z) for p in mesh.Topology[0]], np.float32)
        triangles = np.array(mesh.Topology[1], np.int32)
        corners = points[triangles]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        upward = normal[:, 2] / np.maximum(np.linalg.norm(normal, axis=1), 1e-30)
        pieces = {"upper side missing": triangles[upward < 0.3],
                  "one in five missing": triangles[np.random.default_rng(1).uniform(size=len(triangles)) > 0.2]}
        small = corners + 0.2 * (corners.mean(axis=1)[:, None] - corners)
        for damage, (v, f) in {**{key: (points, kept) for key, kept in pieces.items()},
                               "loose triangles": (small.reshape(-1, 3).astype(np.float32),
                                                   np.arange(3 * len(triangles), dtype=np.int32).reshape(-1, 3))}.items():
            if not only or any(word in f"{name}, {damage}" for word in only):
                yield f"{name}, {damage}", (v, f)


def tool_for(mesh):
    """A box over the corner of a mesh's box with the greatest coordinates."""
    import Mesh

    points = mesh[0] if isinstance(mesh, tuple) else np.array([(p.x, p.y, p.z) for p in mesh.Topology[0]])
    sides, high = np.ptp(points, axis=0), points.max(axis=0)
    tool = Mesh.createBox(*map(float, sides * (1.03, 1.07, 0.97) + 0.1 * sides.max()))
    tool.translate(*map(float, high))
    return tool


def measure_mesh(mq, name, mesh, resolutions):
    """Prints and returns the rows of a mesh."""
    tool, rows = tool_for(mesh), []
    count = len(mesh[1]) if isinstance(mesh, tuple) else mesh.CountFacets
    try:
        mq.boolean(mesh, tool, "difference", method="exact")
        exact = "yes"
    except mq.Error as error:
        exact = type(error).__name__[:8]
    for resolution in resolutions:
        began = time.perf_counter()
        try:
            report = mq.boolean(mesh, tool, "difference", method="uniform", resolution=resolution).report
        except mq.Error as error:
            print(f"{name:<34} {count:>9} {exact:<8} {resolution:>5} {type(error).__name__}: {error}", flush=True)
            continue
        row = {"mesh": name, "triangles": count, "exact": exact, "rays": resolution, "method": report.method,
               "seconds": time.perf_counter() - began, "winding": dict(report.seconds).get("winding numbers", 0.0),
               "samples": report.samples, "guess": 100.0 * report.guessed_share, "kept": report.retained,
               "made": report.reconstructed, "faults": report.faults_left,
               "sound": not report.triangles or report.closed and report.oriented and report.manifold}
        rows.append(row)
        print(f"{name:<34} {count:>9} {exact:<8} {resolution:>5} {row['method']:<8} {row['seconds']:>7.2f} "
              f"{row['winding']:>7.2f} {row['samples']:>9} {row['guess']:>7.2f} {row['kept']:>8} {row['made']:>8} "
              f"{row['faults']:>6} {'yes' if row['sound'] else 'no':>5}", flush=True)
    return rows


def spheres(count):
    """[(V, F)], centres: spheres of radius 1 at random places that overlap."""
    random = np.random.default_rng(count)
    centres = random.uniform(-1.0, 1.0, (count, 3)) * count ** (1 / 3)
    return [made_meshes.sphere(5, centre=centre) for centre in centres], centres


def off(result, centres, spacing):
    """The largest distance of the vertices of made triangles from the nearest sphere."""
    made = np.unique(result.triangles[result.triangle_source[:, 0] < 0])
    points = np.asarray(result.vertices)[made] + result.origin
    distance = np.abs(np.linalg.norm(points[:, None] - centres[None], axis=2) - 1.0).min(axis=1)
    return distance.max() / spacing


def measure_many(mq, count, resolution):
    operands, centres = spheres(count)
    began = time.perf_counter()
    at_once = mq.boolean(operands, operation="union", method="uniform", resolution=resolution)
    middle = time.perf_counter()
    folded = operands[0]
    for operand in operands[1:]:
        folded = mq.boolean(folded, operand, "union", method="uniform", resolution=resolution)
    end = time.perf_counter()
    size = np.ptp(np.concatenate([points for points, _ in operands]), axis=0).max()
    row = {"operands": count, "rays": resolution, "one_pass": middle - began, "by_twos": end - middle,
           "largest": off(at_once, centres, size / (resolution - 4.2)), "faults": at_once.report.faults_left,
           "volume": at_once.report.volume, "volume_by_twos": folded.report.volume}
    print(f"{count:>9} {resolution:>5} {row['one_pass']:>8.2f} {row['by_twos']:>8.2f} {row['largest']:>9.3f} "
          f"{row['faults']:>6}  {row['volume']:.5f} {row['volume_by_twos']:.5f}", flush=True)
    return row


def work(arguments):
    import MeshQuality as mq

    print(HEAD)
    rows = [row for name, mesh in [*dirty_meshes(arguments.only), *damaged_meshes(arguments.only)]
            for row in measure_mesh(mq, name, mesh, arguments.resolutions)]
    print(f"\n{'operands':>9} {'rays':>5} {'one pass':>8} {'by twos':>8} {'largest/r':>9} {'faults':>6}  volumes")
    many = [measure_many(mq, count, resolution) for count in arguments.many for resolution in arguments.resolutions]
    return {"rows": rows, "many": many, "status": 0 if all(row["sound"] for row in rows) else 1}


inside_freecad.start(__file__, parser(), work)
