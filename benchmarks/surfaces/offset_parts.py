#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Real parts offset outward and inward: soundness, distance by other means, time; OpenCASCADE's offset beside it.

    /usr/bin/python3 benchmarks/surfaces/offset_parts.py [--distances 0.005 -0.005 0.02 -0.02] [--tolerance 0.001] [--only NAME ...]
                                                [--folder DIR] [--largest TRIANGLES] [--limit 60] [--no-occ] [--hollow]

All parts of the folder that our mesh closes, at 0.03 % of the size and with at most as many triangles, are measured; the
others are printed first. Distances and the tolerance are fractions of each part's largest side. Each part is offset in a
FreeCAD of its own, with a limit of seconds. Distances are measured by VTK from OpenCASCADE's own triangulation of the part,
five times as fine as the tolerance: of vertices and centroids of the result, and, the other way round, of points at the
distance before the part that have nothing nearer. What seems to be too far is measured from the faces. "occ" is
makeOffsetShape with rounded joins, or makeThickness with --hollow, and says whether what it gives is a valid solid.
"""

import argparse
import json
import os
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
from child import Limits
from inside_freecad import ROOT, data_folder

VARIABLE = "MESHQUALITY_OFFSET"
SUFFIXES = (".step", ".stp", ".brep", ".igs", ".iges")
MOST_POINTS = 1500  # measured each way
MOST_EXACT = 50  # of those that seem to be too far, measured once more from the faces
CHORD = 3e-4  # deviation of the mesh that tells whether a part is closed, as a fraction of its size
FINE = 0.2  # deviation of the reference triangulation, as a fraction of the tolerance


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--distances", type=float, nargs="+", default=[0.005, -0.005, 0.02, -0.02])
    parser.add_argument("--tolerance", type=float, default=0.001)
    parser.add_argument("--folder", type=Path, default=data_folder() / "cad")
    parser.add_argument("--only", nargs="+", help="names of files")
    parser.add_argument("--largest", type=int, default=100_000, help="triangles of the mesh of a part, at most")
    parser.add_argument("--limit", type=float, default=60.0, help="seconds of the processor for each part and distance")
    parser.add_argument("--no-occ", action="store_true")
    parser.add_argument("--hollow", action="store_true", help="hollow by these thicknesses in place of offsets")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "offset_parts.jsonl")
    arguments = parser.parse_args()
    paths = [path for path in sorted(arguments.folder.iterdir()) if path.suffix.lower() in SUFFIXES
             and (not arguments.only or path.name in arguments.only)]
    paths = [path for path in paths if is_fit(path, arguments)]
    print(f"{len(paths)} parts", flush=True)
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    rows = []
    with arguments.out.open("w", encoding="utf-8") as file:
        for path in paths:
            for distance in arguments.distances:
                row = {"part": path.name, "distance": distance}
                for kind in ("ours",) if arguments.no_occ else ("ours", "occ"):
                    row[kind] = run(kind, path, distance, arguments)
                file.write(json.dumps(row) + "\n")
                file.flush()
                rows.append(row)
                print(in_line(row), flush=True)
    report(rows, arguments)


def is_fit(path, arguments):
    """Whether our mesh closes the part, with few enough triangles."""
    mesh = run("mesh", path, 0.0, arguments)
    fit = mesh["outcome"] == "closed" and mesh["triangles"] <= arguments.largest
    if not fit:
        print(f"left out: {path.name:<40} {told(mesh)}", flush=True)
    return fit


def run(kind, path, distance, arguments):
    job = {"kind": kind, "path": str(path), "distance": distance, "tolerance": arguments.tolerance,
           "hollow": arguments.hollow}
    command = ["freecadcmd", "-P", str(ROOT / "Mod"), str(Path(__file__).resolve())]
    began = time.perf_counter()
    status, text = Limits(arguments.limit, 8.0).run(command, {**os.environ, VARIABLE: json.dumps(job)})
    lines = [line for line in text.splitlines() if line.startswith("{")]
    if lines:
        return json.loads(lines[-1])
    return {"outcome": "time" if status is None else "crash", "seconds": time.perf_counter() - began}


def told(result):
    return " ".join(f"{key}={value:.3g}" if isinstance(value, float) else f"{key}={value}" for key, value in result.items())


def in_line(row):
    return f"{row['part']:<40} {row['distance']:+.3f}  {told(row['ours'])}  | occ: {told(row.get('occ', {}))}"


def report(rows, arguments):
    for distance in arguments.distances:
        here = [row for row in rows if row["distance"] == distance and row["ours"]["outcome"] != "unfit"]
        ours = [row["ours"] for row in here]
        within = sum(one["outcome"].startswith("sound") and one["bound"] <= 1.0 and one.get("there", 0.0) <= 1.0
                     and one.get("back", 0.0) <= 1.0
                     for one in ours)
        seconds = sorted(one["seconds"] for one in ours)
        text = f"{distance:+.3f}: {len(here)} parts, sound {sum(one['outcome'].startswith('sound') for one in ours)}, within tolerance {within}"
        text += f", median {seconds[len(seconds) // 2]:.2f} s" if seconds else ""
        occ = [row["occ"] for row in here if "occ" in row]
        if occ:
            times = sorted(one["seconds"] for one in occ)
            text += f"; OpenCASCADE: valid solids {sum(one['outcome'] == 'valid' for one in occ)}, median {times[len(times) // 2]:.2f} s"
        print(text)


def inside():
    """One part in FreeCAD; prints its row."""
    job = json.loads(os.environ[VARIABLE])
    import Part

    try:
        shape = Part.read(job["path"])
        box = shape.BoundBox
        size = max(box.XLength, box.YLength, box.ZLength)
        row = {"mesh": meshed, "ours": ours, "occ": occ}[job["kind"]](shape, size, job)
    except Exception as error:  # noqa: BLE001 - whatever fails is a row of the table
        row = {"outcome": "unfit" if "open" in str(error) else "error", "seconds": 0.0, "message": str(error)[:160]}
    print("\n" + json.dumps(row), flush=True)


def meshed(shape, size, job):
    import MeshQuality as mq

    began = time.process_time()
    mesh = mq.triangulate(shape, chord_height=CHORD * size)
    return {"outcome": "closed" if mesh.report.closed else "open", "triangles": len(mesh.triangles),
            "seconds": time.process_time() - began}


def ours(shape, size, job):
    import MeshQuality as mq
    from MeshQuality.compat import extension

    tolerance, distance = job["tolerance"] * size, job["distance"] * size
    began = time.process_time()
    if job["hollow"]:
        result = mq.hollow(shape, abs(distance), tolerance=tolerance)
    else:
        result = mq.offset(shape, distance, tolerance=tolerance)
    seconds = time.process_time() - began
    sound = not any(extension().verify(result._surface).values())
    row = {"outcome": "sound" if sound else "unsound", "seconds": seconds, "triangles": len(result.triangles),
           "bound": result.report.error_bound / tolerance}
    # Of several bodies, and of a surface with holes, the offset is that of another surface than the shape's faces.
    print("\n" + json.dumps(row), flush=True)  # in case that measuring takes too long
    if len(shape.Solids) == 1 and not result.report.repaired and len(result.triangles) and not job["hollow"]:
        row["there"], row["back"] = (d / tolerance for d in measured(shape, result, distance, tolerance))
    return row


def measured(shape, result, distance, tolerance):
    """Largest deviation of the result from the distance, and of points at the distance from the result; mm."""
    import numpy as np
    import Part
    from FreeCAD import Vector

    points, facets = shape.tessellate(FINE * tolerance)
    part, part_points, part_facets = locator(np.array([tuple(p) for p in points]), np.array(facets))
    vertices = np.asarray(result.vertices) + result.origin
    offset, _, _ = locator(vertices, np.asarray(result.triangles))
    samples = picked(np.concatenate((vertices, vertices[result.triangles].mean(axis=1))), MOST_POINTS)
    off = np.abs(part(samples) - abs(distance))
    for i in np.argsort(-off)[:MOST_EXACT]:
        # OpenCASCADE's triangulation deviates by more than was asked for on some faces: its faces themselves tell.
        if off[i] > tolerance:
            off[i] = abs(Part.Compound(shape.Faces).distToShape(Part.Vertex(*samples[i].tolist()))[0] - abs(distance))
    there = off.max()
    at = points_at_distance(part, part_points[part_facets], distance, tolerance, MOST_POINTS)
    far = offset(at)
    for i in np.flatnonzero(far > tolerance):
        # OpenCASCADE turns a few triangles over: what is not on the side of the offset does not count.
        if shape.isInside(Vector(*at[i]), 1e-9, True) != (distance < 0.0):
            far[i] = 0.0
    return there, far.max(initial=0.0)


def points_at_distance(part, corners, distance, tolerance, most):
    """Points at a distance before triangles (T, 3, 3) that nothing else of the part is nearer to, also a little farther on:
    other ones are in a gap that closes. `part` tells distances from it.
    """
    import numpy as np

    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    good = lengths > 1e-2 * np.median(lengths)  # needles have no normals
    direction = picked(normals[good] / lengths[good, None], most)
    at = picked(corners.mean(axis=1)[good], most) + distance * direction
    on = part(at) >= abs(distance) - 0.2 * tolerance
    on &= part(at + np.sign(distance) * 2.0 * tolerance * direction) >= abs(distance) + 1.5 * tolerance
    return at[on]


def picked(points, most):
    return points[:: max(1, len(points) // most)]


def poly_data(points, facets):
    """Triangles for VTK."""
    import numpy as np
    import vtk
    from vtk.util import numpy_support

    data, cells, array = vtk.vtkPolyData(), vtk.vtkCellArray(), vtk.vtkPoints()
    array.SetData(numpy_support.numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    ids = np.hstack((np.full((len(facets), 1), 3), facets)).astype(np.int64)
    cells.SetCells(len(facets), numpy_support.numpy_to_vtkIdTypeArray(ids.ravel(), deep=True))
    data.SetPoints(array)
    data.SetPolys(cells)
    return data


def locator(points, facets):
    """(distances of points from triangles, as a function; the points and the triangles)."""
    import numpy as np
    import vtk

    tree = vtk.vtkStaticCellLocator()
    tree.SetDataSet(poly_data(points, facets))
    tree.BuildLocator()

    def distances(samples):
        found, cell, sub, square = [0.0] * 3, vtk.reference(0), vtk.reference(0), vtk.reference(0.0)
        result = np.empty(len(samples))
        for i, sample in enumerate(samples):
            tree.FindClosestPoint(sample, found, cell, sub, square)
            result[i] = float(square) ** 0.5
        return result

    return distances, points, facets


def occ(shape, size, job):
    distance = job["distance"] * size
    began = time.process_time()
    if job["hollow"]:
        made = shape.makeThickness([shape.Faces[0]], -abs(distance), 1e-3 * abs(distance))
    else:
        made = shape.makeOffsetShape(distance, 1e-3 * abs(distance), join=0)
    valid = made.isValid() and bool(made.Solids) and made.Volume > 0
    return {"outcome": "valid" if valid else "invalid", "seconds": time.process_time() - began}


if VARIABLE in os.environ:
    inside()
    sys.exit(0)
if __name__ == "__main__":
    main()
