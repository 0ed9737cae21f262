#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Uniform Booleans of shapes whose CAD faces the rays meet, beside those of the same meshes alone.

    /usr/bin/python3 benchmarks/boolean/native_rays.py [--resolutions 65 129 257 513] [--pairs sphere torus] [--most 4000]

Rows "mesh" have operands meshed with half the tolerance of the resolution, as far as the result may be off; rows "fine"
those meshed with a sixteenth, of which rows "faces" take which faces a ray meets. Errors are distances from the faces of
what OpenCASCADE's own Boolean of the shapes gives, in units of the distance between rays: those of vertices that were
reconstructed, and of the centroids of all triangles made or changed. The status is 1 where rows "faces" are no better than
rows "mesh". direct_rays_bench shoots rays at faces without a mesh.
"""

import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
import numpy as np

MESHES = (1 / 2, 1 / 16)  # deviation of the operands' meshes, as fractions of the tolerance
HEAD = (f"{'pair':<22} {'rays':>5} {'from':<6} {'samples':>9} {'on faces':>9} {'vertices':>8} {'mean':>9} {'largest':>9} "
        f"{'t. mean':>9} {'t. most':>9} {'faults':>6} {'CPU s':>7} {'Msamples/s':>10}")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--resolutions", type=int, nargs="+", default=[65, 129, 257, 513])
    result.add_argument("--pairs", nargs="+", help="only those whose names contain one of these words")
    result.add_argument("--most", type=int, default=4000, help="points measured of each kind, picked at random")
    return result


def made_pairs():
    """(name, A, B, operation)."""
    import Part
    from FreeCAD import Vector

    yield ("sphere - box", Part.makeSphere(10.0), Part.makeBox(12.3, 14.1, 9.7, Vector(1.3, -6.2, 2.1)), "difference")
    pipe = Part.makeCylinder(5.0, 40.0, Vector(-20.2, 0.3, 0.1), Vector(1, 0, 0))
    yield ("pipes, union", pipe, Part.makeCylinder(4.1, 38.0, Vector(0.4, -19.1, 0.7), Vector(0.1, 1, 0.05)), "union")
    yield ("torus - box", Part.makeTorus(12.0, 4.0), Part.makeBox(20.0, 9.0, 20.0, Vector(2.1, -4.3, -9.7)), "difference")
    cone = Part.makeCone(9.0, 0.0, 22.0, Vector(0.2, 0.1, -8.0))
    yield ("cone n sphere", cone, Part.makeSphere(8.0, Vector(1.1, 0.4, 0.3)), "intersection")


# Parts of the data folder: where beside the middle of their box the tool lies, and its sides, in fractions of the box.
PARTS = (("bottle.brep", (0.2, 0.1, 0.1)), ("0049_control_arm.step", (0.1, 0.2, 0.1)), ("CrankArm.brep", (0.25, 0.1, 0.2)))


def part_pairs():
    import Part
    from FreeCAD import Vector

    folder = inside_freecad.data_folder() / "cad"
    for name, beside in PARTS:
        if not (folder / name).exists():
            print(f"missing: {folder / name}")
            continue
        shape = Part.Shape()
        shape.read(str(folder / name))
        box = shape.BoundBox
        sides = [0.62 * box.XLength, 0.57 * box.YLength, 0.53 * box.ZLength]
        corner = Vector(*(middle + (share - 0.3) * side for middle, share, side in
                          zip(box.Center, beside, (box.XLength, box.YLength, box.ZLength))))
        yield f"{Path(name).stem} - box", shape, Part.makeBox(*sides, corner), "difference"
        if name == PARTS[0][0]:
            moved = shape.copy()
            moved.translate(Vector(0.31 * box.XLength, 0.17 * box.YLength, 0.11 * box.ZLength))
            yield f"{Path(name).stem} U copy", shape, moved, "union"


def exact(a, b, operation):
    return {"difference": a.cut, "union": a.fuse, "intersection": a.common}[operation](b)


def some(points, most):
    if len(points) <= most:
        return points
    return points[np.random.default_rng(7).choice(len(points), most, replace=False)]


def errors(result, reference, spacing, most):
    """(vertices, mean and largest distance of reconstructed vertices, the same of triangles) in units of the spacing."""
    from MeshQuality.compat import extension

    made = result.triangle_source[:, 0] < 0
    own = np.unique(result.triangles[~made])
    vertices = np.setdiff1d(np.unique(result.triangles[made]), own)
    corners = result.vertices[result.triangles[made]]
    found = [len(vertices)]
    for points in (result.vertices[vertices], corners.mean(axis=1)):
        points = some(points, most) + result.origin
        distances = extension().distances_to_faces(reference, points, None) if len(points) else np.zeros(1)
        found += [float(distances.mean() / spacing), float(distances.max() / spacing)]
    return found


def row(name, rays, source, operands, operation, reference, most):
    import MeshQuality as mq

    start = time.process_time()
    result = mq.boolean(*operands, operation, method="uniform", resolution=rays)
    cpu = time.process_time() - start
    report = result.report
    seconds = dict(report.seconds)
    sampling = seconds.get("sampling", 0.0) + seconds.get("sampling CAD faces", 0.0)
    count, *found = errors(result, reference, report.tolerance_asked / 3**0.5, most)
    print(f"{name:<22} {rays:>5} {source:<6} {report.samples:>9} {report.face_samples:>9} {count:>8} "
          + " ".join(f"{value:>9.2e}" for value in found)
          + f" {report.faults_left:>6} {cpu:>7.2f} {report.samples / sampling / 1e6:>10.2f}", flush=True)
    return {"pair": name, "rays": rays, "from": source, "samples": report.samples, "on_faces": report.face_samples,
            "vertices": count, "mean": found[0], "largest": found[1], "triangle_mean": found[2],
            "triangle_largest": found[3], "faults": report.faults_left, "closed": report.closed, "cpu_seconds": cpu,
            "seconds": seconds, "notes": list(report.notes), "fitted": report.fitted_vertices,
            "unfitted": report.unfitted_vertices}


def rows_of(name, a, b, operation, rays, most):
    import MeshQuality as mq

    reference = exact(a, b, operation)
    boxes = (a.BoundBox, b.BoundBox)
    side = max(max(getattr(box, f"{axis}Max") for box in boxes) - min(getattr(box, f"{axis}Min") for box in boxes)
               for axis in "XYZ")
    tolerance = 3**0.5 * side / rays
    coarse, fine = ([mq.triangulate(shape, chord_height=share * tolerance) for shape in (a, b)] for share in MESHES)
    return [row(name, rays, source, operands, operation, reference, most)
            for source, operands in (("mesh", coarse), ("fine", fine), ("faces", (a, b)))]


def work(arguments):
    print(HEAD)
    rows = []
    for name, a, b, operation in [*made_pairs(), *part_pairs()]:
        if arguments.pairs and not any(word in name for word in arguments.pairs):
            continue
        for rays in arguments.resolutions:
            rows += rows_of(name, a, b, operation, rays, arguments.most)
    worse = {source: [f"{faces['pair']} {faces['rays']} {error}" for mesh, faces in pairs_from(rows, source)
                      for error in ("mean", "largest") if faces[error] >= mesh[error]] for source in ("mesh", "fine")}
    for source, found in worse.items():
        print(f"no better than {source}: {', '.join(found) or 'none'}")
    return {"rows": rows, "status": 1 if worse["mesh"] else 0}


def pairs_from(rows, source):
    """(row from meshes, row from faces) of the same pair and resolution."""
    faces = {(row["pair"], row["rays"]): row for row in rows if row["from"] == "faces"}
    return [(row, faces[row["pair"], row["rays"]]) for row in rows if row["from"] == source]


inside_freecad.start(__file__, parser(), work)
