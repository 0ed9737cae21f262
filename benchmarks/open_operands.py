#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Booleans of the meshes of the data folder that are not closed, and of many operands in one pass.

    /usr/bin/python3 benchmarks/open_operands.py [--resolutions 129 257 513] [--only lion gearbox] [--many 4 16]

A box is taken from each mesh whose row of index.csv says that it is open or not manifold. "exact" says whether the exact
method takes it after its repairs; then the method "uniform" is timed at each resolution: stages, samples, the share of the
surface that is a guess, and whether the result is closed and how many faults it has. With --many, unions of as many spheres
in one pass beside two at a time: seconds, and the largest distance of vertices that were made from the spheres, in units of the
distance between rays. The status is 1 where a result is not closed, oriented and manifold.
"""

import csv
import gzip
import tempfile
import time
from pathlib import Path

import inside_freecad
import made_meshes
import numpy as np

HEAD = (f"{'mesh':<26} {'triangles':>9} {'exact':<8} {'rays':>5} {'method':<8} {'seconds':>7} {'winding':>7} {'samples':>9} "
        f"{'guess %':>7} {'kept':>8} {'made':>8} {'faults':>6} {'sound':>5}")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--resolutions", type=int, nargs="+", default=[129, 257, 513])
    result.add_argument("--only", nargs="+", help="only meshes whose names contain one of these words")
    result.add_argument("--many", type=int, nargs="*", default=[4, 16], help="numbers of operands of the unions")
    return result


def dirty_meshes(only):
    """(name, Mesh.Mesh) of the meshes that are not closed or not manifold."""
    import Mesh

    folder = inside_freecad.data_folder()
    with open(folder / "index.csv", encoding="utf-8") as rows:
        names = [row["file"] for row in csv.DictReader(rows)
                 if row["kind"] == "mesh" and ("open" in row["flags"] or "non-manifold" in row["flags"])]
    for name in names:
        path = folder / name
        if only and not any(word in name for word in only):
            continue
        with tempfile.TemporaryDirectory() as scratch:
            if path.suffix == ".gz":
                unpacked = Path(scratch) / path.stem
                unpacked.write_bytes(gzip.decompress(path.read_bytes()))
                path = unpacked
            mesh = Mesh.Mesh(str(path))
        if mesh.CountFacets:
            yield Path(name).name, mesh


def tool_for(mesh):
    """A box over the corner of a mesh's box with the greatest coordinates."""
    import Mesh

    box = mesh.BoundBox
    side = max(box.XLength, box.YLength, box.ZLength)
    tool = Mesh.createBox(1.03 * box.XLength + 0.1 * side, 1.07 * box.YLength + 0.1 * side, 0.97 * box.ZLength + 0.1 * side)
    tool.translate(box.XMax, box.YMax, box.ZMax)
    return tool


def measure_mesh(mq, name, mesh, resolutions):
    """Prints and returns the rows of a mesh."""
    tool, rows = tool_for(mesh), []
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
            print(f"{name:<26} {mesh.CountFacets:>9} {exact:<8} {resolution:>5} {type(error).__name__}: {error}", flush=True)
            continue
        row = {"mesh": name, "triangles": mesh.CountFacets, "exact": exact, "rays": resolution, "method": report.method,
               "seconds": time.perf_counter() - began, "winding": dict(report.seconds).get("winding numbers", 0.0),
               "samples": report.samples, "guess": 100.0 * report.guessed_share, "kept": report.retained,
               "made": report.reconstructed, "faults": report.faults_left,
               "sound": not report.triangles or report.closed and report.oriented and report.manifold}
        rows.append(row)
        print(f"{name:<26} {mesh.CountFacets:>9} {exact:<8} {resolution:>5} {row['method']:<8} {row['seconds']:>7.2f} "
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
    rows = [row for name, mesh in dirty_meshes(arguments.only)
            for row in measure_mesh(mq, name, mesh, arguments.resolutions)]
    print(f"\n{'operands':>9} {'rays':>5} {'one pass':>8} {'by twos':>8} {'largest/r':>9} {'faults':>6}  volumes")
    many = [measure_many(mq, count, resolution) for count in arguments.many for resolution in arguments.resolutions]
    return {"rows": rows, "many": many, "status": 0 if all(row["sound"] for row in rows) else 1}


inside_freecad.start(__file__, parser(), work)
