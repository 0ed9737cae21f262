#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles that are left within a distance: simplify beside MeshLab's quadrics and Manifold's, on meshes of ten parts.

    /usr/bin/python3 benchmarks/surfaces/simplify_meshes.py --rivals PYTHON [--only PART]

PYTHON has pymeshlab and manifold3d, as the scratch environment of benchmarks/peers. Given are meshes of FreeCAD's tessellation, which nobody
of the three has made, three times as close to the part as the tolerance, a thousandth of the diagonal. simplify is asked for the tolerance and
proves it. The others get the fewest triangles of a grid whose distance both ways, by MeshLab's filter of Hausdorff at 20,000 points a side, is
within it. Of each result MeshLab counts the triangles that cross others; closedness is counted here. Seconds are of the processor, one run.
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

sys.path += [str(folder) for folder in Path(__file__).resolve().parents[1].iterdir() if folder.is_dir()]
import inside_freecad  # noqa: E402
from boolean_peers import read_off, write_off  # noqa: E402
from setting_search import coarsest  # noqa: E402

FILES = ("mal_vis.brep", "component8.step", "M6-1x12-countersunk-screw.step", "aagnet_partA.step", "featuretype.step")
TOLERANCE, GIVEN, SAMPLES, DIGITS = 1e-3, 1e-3 / 3, 20000, 17  # the first two of the diagonal
RIVALS = ("MeshLab", "Manifold")
GRID = [2.0**(-k / 4) for k in range(2, 40)]  # fraction of triangles that MeshLab leaves; the other way round of the tolerance


def parts():
    """(name, shape) of parts from files and made ones."""
    import Part
    from FreeCAD import Vector

    box = Part.makeBox(30, 20, 10)
    yield "rounded box", box.makeFillet(3, box.Edges)
    yield "tee", Part.makeCylinder(10, 60).fuse(Part.makeCylinder(7, 40, Vector(0, 0, 30), Vector(1, 0, 0))).removeSplitter()
    yield "torus", Part.makeTorus(20, 6)
    yield "plate", Part.makeBox(60, 40, 5).cut(Part.makeCompound([Part.makeCylinder(4, 20, Vector(x, 20, -5)) for x in (12, 30, 48)]))
    yield "ball and cone", Part.makeSphere(10).fuse(Part.makeCone(8, 3, 30)).removeSplitter()
    for path in (inside_freecad.data_folder() / "cad" / name for name in FILES):
        if path.exists():
            yield path.stem, Part.makeCompound(Part.read(str(path)).Solids[:1])


def rivals(given, own, tolerance):
    """{name: row} of the others and of a result that is there; runs where pymeshlab and manifold3d are."""
    import pymeshlab

    def as_set(mesh):
        made = pymeshlab.MeshSet(verbose=False)
        made.add_mesh(pymeshlab.Mesh(mesh[0], mesh[1]))
        return made

    def distance(mesh):
        both = as_set(given)
        both.add_mesh(pymeshlab.Mesh(mesh[0], mesh[1]))
        ways = [both.get_hausdorff_distance(sampledmesh=i, targetmesh=1 - i, samplenum=SAMPLES, sampleedge=True)["max"] for i in (0, 1)]
        return max(ways) / tolerance

    def row(mesh, seconds):
        judged = as_set(mesh)
        judged.compute_selection_by_self_intersections_per_face()
        sides = np.concatenate([mesh[1][:, [0, 1]], mesh[1][:, [1, 2]], mesh[1][:, [2, 0]]])
        keys = [{tuple(side) for side in way.tolist()} for way in (sides, sides[:, ::-1])]
        return {"triangles": len(mesh[1]), "distance": distance(mesh), "seconds": seconds, "crossing": judged.current_mesh().selected_face_number(),
                "closed": len(keys[0]) == len(sides) and keys[0] == keys[1]}

    makers, found = {"MeshLab": meshlab, "Manifold": manifold}, {}
    if own is not None:
        found["MeshQuality"] = row(own, None)
    for name, make in makers.items():
        made = {}

        def tried(setting, make=make, made=made):
            begun = time.process_time()
            made[setting] = (make(given, setting, tolerance, as_set), time.process_time() - begun)
            return distance(made[setting][0])

        setting = coarsest(GRID[::-1] if name == "MeshLab" else [2 * step for step in GRID], tried, 1.0)
        found[name] = row(*made[setting]) if setting is not None else None
    return found


def meshlab(given, share, _, as_set):
    made = as_set(given)
    made.meshing_decimation_quadric_edge_collapse(
        targetperc=share, qualitythr=0.3, preserveboundary=True, preservenormal=True, preservetopology=True, optimalplacement=True, planarquadric=True)
    return made.current_mesh().vertex_matrix(), made.current_mesh().face_matrix()


def manifold(given, share, tolerance, _):
    import manifold3d

    points, triangles = given
    made = manifold3d.Manifold(manifold3d.Mesh64(points, triangles.astype(np.uint64))).simplify(share * tolerance).to_mesh64()
    return np.asarray(made.vert_properties)[:, :3], np.asarray(made.tri_verts).astype(np.int32)


def work(arguments):
    import MeshQuality as mq

    rows = []
    print("| part | given | by | triangles left | distance / tolerance | closed | crossing | CPU s |\n|---|---:|---|---:|---:|---|---:|---:|")
    for name, shape in parts():
        if arguments.only and name not in arguments.only:
            continue
        size = shape.BoundBox.DiagonalLength
        points, triangles = shape.tessellate(GIVEN * size)
        given = np.array([tuple(point) for point in points]), np.array(triangles, dtype=np.int32)
        begun = time.process_time()
        try:
            own, said = mq.simplify(given, tolerance=TOLERANCE * size), ""
        except mq.Error as error:
            own, said = None, str(error)
        seconds = time.process_time() - begun
        with tempfile.TemporaryDirectory() as folder:
            files = [f"{folder}/given.off", f"{folder}/own.off"]
            write_off(files[0], *given, DIGITS)
            if own is not None:
                write_off(files[1], own.vertices + own.origin, own.triangles, DIGITS)
            done = subprocess.run([arguments.rivals, __file__, "rivals", *files, repr(TOLERANCE * size)], capture_output=True, text=True, check=True,
                                  env=inside_freecad.system_environment())
        found = json.loads(done.stdout.splitlines()[-1])
        if own is not None:
            found["MeshQuality"]["seconds"] = seconds
        for by in ("MeshQuality", *RIVALS):
            row = found.get(by)
            text = f"{row['triangles']:,} | {row['distance']:.2f} | {'yes' if row['closed'] else 'no'} | {row['crossing']} | {row['seconds']:.2f}" if row \
                else f"{said or 'none keeps it'} | - | - | - | -"
            print(f"| {name} | {len(triangles):,} | {by} | {text} |", flush=True)
            rows.append({"part": name, "given": len(triangles), "by": by, **(row or {})})
    return {"rows": rows}


if sys.argv[1:2] == ["rivals"]:
    out = Path(sys.argv[3])
    print(json.dumps(rivals(read_off(sys.argv[2]), read_off(out) if out.exists() else None, float(sys.argv[4]))))
elif __name__ == "__main__" or inside_freecad.VARIABLE in __import__("os").environ:
    command = inside_freecad.command_line(__doc__)
    command.add_argument("--rivals", required=True, help="a Python that has pymeshlab and manifold3d")
    command.add_argument("--only", action="append", metavar="PART", help="these parts only")
    inside_freecad.start(__file__, command, work)
