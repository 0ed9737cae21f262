#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Assemblies and dirty meshes wrapped: soundness, distances by other means, time; CGAL's alpha wrapping beside it.

    /usr/bin/python3 benchmarks/surfaces/wrap_assemblies.py [--gap 0.02] [--tolerance 0.005] [--only NAME ...] [--folder DIR]
                                                   [--limit 120] [--no-cgal]

Gap and tolerance are fractions of the largest side. Each file is wrapped in a FreeCAD of its own, with a limit of seconds of
the processor. "to" is the largest distance of the wrap from the input, but for triangles that close gaps; "from" that of
points of the input outside of the wrap from it, both measured by VTK on samples, as fractions of the tolerance. "said" is
what the report says. CGAL wraps the same triangles with alpha = gap and offset = tolerance / 2, built from alpha_wrap.cpp
where its headers are installed; its distances are measured in the same way, for all of its triangles.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
from child import Limits
from inside_freecad import ROOT, data_folder

VARIABLE = "MESHQUALITY_WRAP"
CAD = (".step", ".stp", ".brep", ".igs", ".iges")
MESHES = (".stl", ".obj", ".ply", ".off")
# Files with several solids, and meshes with holes, crossing pieces or edges of more than two triangles.
ASSEMBLIES = ("777-200LR.stp", "Motor-c.brep", "SCDR.stp", "as1-oc-214.stp", "asm-simplified-connectors.stp",
              "cube-sphere-cube-compound.brep", "dm1-id-214.stp", "multi_volume_cylinders.stp", "nonmanifold_boxes.brep",
              "F-16_OpenVSP3.5.0.stp", "dlr_f6.brep", "fuselage_structure.brep")
DIRTY = ("3DBenchy.obj", "busted.stl", "chair_model.obj", "Cray_left.obj", "non_manif_hole.ply", "plane_holes.obj",
         "thingi_112932.stl", "thingi_40509.stl", "thingi_58011.stl.gz", "two_spheres.stl", "self_intersectA.obj",
         "lion_vase_poly.off.gz")
MOST_POINTS = 4000


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--gap", type=float, default=0.02)
    parser.add_argument("--tolerance", type=float, default=0.005)
    parser.add_argument("--folder", type=Path, help="all files of this folder in place of those of the corpus")
    parser.add_argument("--only", nargs="+", help="names of files")
    parser.add_argument("--limit", type=float, default=120.0)
    parser.add_argument("--no-cgal", action="store_true")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "wrap_assemblies.jsonl")
    arguments = parser.parse_args()
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    rows = []
    with tempfile.TemporaryDirectory() as folder, arguments.out.open("w", encoding="utf-8") as file:
        peer = None if arguments.no_cgal else built_peer(Path(folder))
        for path in paths(arguments):
            row = run(path, arguments, peer, Path(folder))
            file.write(json.dumps(row) + "\n")
            file.flush()
            rows.append(row)
            print(in_line(row), flush=True)
    report(rows)


def paths(arguments):
    if arguments.folder:
        found = [path for path in sorted(arguments.folder.iterdir()) if kind_of(path) in (*CAD, *MESHES)]
    else:
        found = [data_folder() / "cad" / name for name in ASSEMBLIES] + [data_folder() / "mesh" / name for name in DIRTY]
    return [path for path in found if not arguments.only or path.name in arguments.only]


def kind_of(path):
    return Path(path.name.removesuffix(".gz")).suffix.lower()


def built_peer(folder):
    """The program, or None where CGAL is not installed."""
    program = folder / "alpha_wrap"
    done = subprocess.run(["c++", "-std=c++17", "-O3", "-DNDEBUG", str(Path(__file__).with_name("alpha_wrap.cpp")), "-o",
                           str(program), "-lgmp", "-lmpfr"], capture_output=True, text=True, check=False)
    if done.returncode:
        print(f"CGAL is left out: {done.stderr.splitlines()[0] if done.stderr else 'no compiler'}", file=sys.stderr)
        return None
    return program


def run(path, arguments, peer, folder):
    row = {"part": path.name}
    job = {"path": str(path), "gap": arguments.gap, "tolerance": arguments.tolerance, "folder": str(folder),
           "program": str(peer) if peer else ""}
    for kind in ("ours", "cgal") if peer else ("ours",):
        began = time.perf_counter()
        command = ["freecadcmd", "-P", str(ROOT / "Mod"), str(Path(__file__).resolve())]
        status, text = Limits(arguments.limit, 12.0).run(command, {**os.environ, VARIABLE: json.dumps({**job, "kind": kind})})
        lines = [line for line in text.splitlines() if line.startswith("{")]
        row[kind] = json.loads(lines[-1]) if lines else {"outcome": "time" if status is None else "crash",
                                                         "seconds": time.perf_counter() - began}
        if kind == "ours" and row[kind]["outcome"] == "error":
            break
    return row


def in_line(row):
    def told(result):
        return " ".join(f"{key}={value:.3g}" if isinstance(value, float) else f"{key}={value}"
                        for key, value in result.items())
    return f"{row['part']:<32} {told(row['ours'])}  | cgal: {told(row.get('cgal', {}))}"


def report(rows):
    for kind in ("ours", "cgal"):
        some = [row[kind] for row in rows if kind in row]
        done = [one for one in some if one["outcome"] == "sound" and "to" in one]
        if some:
            near = sum(max(one["to"], one["from"]) <= 1.0 for one in done)
            seconds = sorted(one["seconds"] for one in done) or [0.0]
            print(f"{kind}: {len(some)} files, sound {len(done)}, within the tolerance {near}, "
                  f"median {seconds[len(seconds) // 2]:.2f} s")


def inside():
    """One file in FreeCAD; prints its row."""
    job = json.loads(os.environ[VARIABLE])
    try:
        source, triangles = read(Path(job["path"]), Path(job["folder"]), job["tolerance"])
        row = (ours if job["kind"] == "ours" else cgal)(source, triangles, job)
    except Exception as error:  # noqa: BLE001 - whatever fails is a row of the table
        row = {"outcome": "error", "seconds": 0.0, "message": str(error)[:200]}
    print("\n" + json.dumps(row), flush=True)


def read(path, folder, tolerance):
    """(what is wrapped, (V, F) of its triangles)."""
    import gzip

    import Mesh
    import numpy as np
    import Part

    if kind_of(path) in CAD:
        shape = Part.read(str(path))
        box = shape.BoundBox
        points, facets = shape.tessellate(0.1 * tolerance * max(box.XLength, box.YLength, box.ZLength))
        return shape, (np.array([tuple(p) for p in points]), np.array(facets))
    if path.name.endswith(".gz"):
        plain = folder / path.name.removesuffix(".gz")
        with gzip.open(path) as packed, plain.open("wb") as file:
            shutil.copyfileobj(packed, file)
        path = plain
    points, facets = Mesh.Mesh(str(path)).Topology
    arrays = np.array([tuple(p) for p in points]), np.array(facets)
    return arrays, arrays


def size_of(triangles):
    import numpy as np

    return float(np.ptp(triangles[0][np.unique(triangles[1])], axis=0).max())


def ours(source, triangles, job):
    import MeshQuality as mq
    import numpy as np
    from MeshQuality.compat import extension

    size = size_of(triangles)
    tolerance = job["tolerance"] * size
    began, clock = time.process_time(), time.perf_counter()
    mesh = mq.wrap(source, job["gap"] * size, tolerance)
    row = {"outcome": "unsound" if any(extension().verify(mesh._surface).values()) else "sound",
           "seconds": time.process_time() - began, "wall": time.perf_counter() - clock, "triangles": len(mesh.triangles),
           "gaps": mesh.gap_triangles, "said": mesh.report.error_bound / tolerance}
    print("\n" + json.dumps(row), flush=True)  # in case that measuring takes too long
    vertices = np.asarray(mesh.vertices) + mesh.origin
    row["to"], row["from"] = (d / tolerance for d in distances(
        triangles, vertices, np.asarray(mesh.triangles), np.asarray(mesh.triangle_source)[:, 0] >= 0))
    return row


def cgal(source, triangles, job):
    import numpy as np

    size, folder = size_of(triangles), Path(job["folder"])
    given, made = folder / "in.off", folder / "out.off"
    write_off(given, *triangles)
    done = subprocess.run([job["program"], str(given), str(made), repr(job["gap"] * size),
                           repr(0.5 * job["tolerance"] * size)], capture_output=True, text=True, check=False)
    if done.returncode:
        return {"outcome": "error", "seconds": 0.0, "message": done.stderr[:200]}
    vertices, facets = read_off(made)
    row = {"outcome": "sound", "seconds": json.loads(done.stdout)["seconds"], "triangles": len(facets)}
    print("\n" + json.dumps(row), flush=True)
    row["to"], row["from"] = (d / (job["tolerance"] * size) for d in distances(
        triangles, vertices, facets, np.ones(len(facets), dtype=bool)))
    return row


def write_off(path, points, facets):
    with path.open("w", encoding="ascii") as file:
        file.write(f"OFF\n{len(points)} {len(facets)} 0\n")
        file.writelines("%.17g %.17g %.17g\n" % tuple(p) for p in points)
        file.writelines("3 %d %d %d\n" % tuple(f) for f in facets)


def read_off(path):
    import numpy as np

    words = path.read_text(encoding="ascii").split()
    count, faces = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * count], dtype=float).reshape(-1, 3)
    return points, np.array(words[4 + 3 * count:4 + 3 * count + 4 * faces], dtype=int).reshape(-1, 4)[:, 1:]


def distances(triangles, vertices, facets, on_input):
    """Of the wrap from the input, and of points of the input outside of the wrap from it; mm."""
    import numpy as np
    import vtk
    from offset_parts import locator, poly_data

    given, _, _ = locator(*triangles)
    samples = vertices[facets[on_input]]
    samples = np.concatenate((samples.reshape(-1, 3), samples.mean(axis=1)))
    to = given(picked(samples)).max(initial=0.0)
    corners = triangles[0][triangles[1]]
    weights = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    rng = np.random.default_rng(1)
    chosen = corners[rng.choice(len(corners), MOST_POINTS, p=weights / weights.sum())]
    shares = rng.dirichlet((1.0, 1.0, 1.0), MOST_POINTS)
    points = np.concatenate((np.einsum("ij,ijk->ik", shares, chosen), picked(corners.reshape(-1, 3))))
    wrapped = poly_data(vertices, facets)
    inside = vtk.vtkSelectEnclosedPoints()
    cloud, places = vtk.vtkPolyData(), vtk.vtkPoints()
    for point in points:
        places.InsertNextPoint(point)
    cloud.SetPoints(places)
    inside.SetInputData(cloud)
    inside.SetSurfaceData(wrapped)
    inside.SetTolerance(1e-9)
    inside.Update()
    outside = np.array([not inside.IsInside(i) for i in range(len(points))])
    away, _, _ = locator(vertices, facets)
    return to, away(points[outside]).max(initial=0.0)


def picked(points):
    return points[:: max(1, len(points) // MOST_POINTS)]


if VARIABLE in os.environ:
    inside()
    sys.exit(0)
if __name__ == "__main__":
    main()
