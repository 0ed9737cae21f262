#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What OpenFOAM makes of our surfaces, beside those of FreeCAD's STL.

    /usr/bin/python3 benchmarks/solvers/openfoam.py [--surfaces 100] [--no-cases]

Surfaces: the valid parts of $MESHQUALITY_DATA/cad with closed solids, each as an STL with one solid a face; surfaceCheck must call
it closed and know the names of all faces. Cases: a pipe with a branch, a flanged elbow and a finned housing, each meshed
by blockMesh and snappyHexMesh with our surface and its patches, and with that of FreeCAD's `tessellate` at the same
distance, which has none; sharp edges and levels are ours for both. Needs Debian's openfoam.
"""

import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

ENVIRONMENT = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}
CAD_SUFFIXES = {".step", ".stp", ".iges", ".igs", ".brep", ".brp"}
LIMIT = 60  # s of the processor for a part


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--data", default=str(inside_freecad.data_folder()), help="folder with cad/")
    result.add_argument("--surfaces", type=int, default=100, help="parts to check")
    result.add_argument("--no-cases", action="store_true", help="surfaces only")
    return result


def program(name, folder, *arguments):
    """The output of a program of OpenFOAM in a folder, and its seconds."""
    start = time.monotonic()
    done = subprocess.run([name, *arguments], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=1200,
                          check=False)
    return done.stdout + done.stderr, time.monotonic() - start


def checked_surface(path, folder):
    """[solids, triangles, closed, names equal] of one part; [] where it has no closed solid or is not valid."""
    import MeshQuality as mq
    import Part

    shape = Part.read(str(path))
    if not shape.Solids or not shape.isValid():
        return []
    mesh = mq.triangulate(shape, chord_height_relative=0.002)
    if len(set(mesh.triangle_solid.tolist())) != 1 or -1 in mesh.triangle_solid:
        return []  # shells touch, as surfaceCheck counts edges by their places
    target = os.path.join(folder, "part.stl")
    mesh.write(target, ascii=True, scale=0.001)
    said, _ = program("surfaceCheck", folder, target)
    names = set(re.findall(r"^(Face\d+)\s", said, re.MULTILINE))
    wanted = {f"Face{index + 1}" for index in set(mesh.triangle_face.tolist())}
    return [1, len(mesh.triangles), "Surface is closed" in said, names == wanted]


def surfaces(arguments):
    """The results by part, of as many parts as asked for."""
    from child import in_child

    found = {}
    for path in sorted(Path(arguments.data, "cad").iterdir()):
        if len(found) == arguments.surfaces:
            break
        if path.suffix.lower() not in CAD_SUFFIXES:
            continue
        with tempfile.TemporaryDirectory() as folder:
            result = in_child(lambda path=path, folder=folder: checked_surface(path, folder), LIMIT)
        if result:
            found[path.name] = result
            if not all(result[2:]):
                print(path.name, *result, flush=True)
    closed, named = (sum(result[i] for result in found.values()) for i in (2, 3))
    print(f"{len(found)} surfaces: {closed} closed, {named} with the names of all faces")
    return found


def models():
    """{name: (solid, patches)}"""
    import Part
    from FreeCAD import Vector

    pipe = Part.makeCylinder(10, 60).fuse(Part.makeCylinder(6, 40, Vector(0, 0, 30), Vector(1, 0, 0))).removeSplitter()
    bend = Part.makeTorus(40, 10, Vector(), Vector(0, 0, 1), -180, 180, 90)
    elbow = bend.fuse(Part.makeCylinder(18, 5, Vector(40, 0, 0), Vector(0, -1, 0))).removeSplitter()
    fins = Part.makeBox(80, 60, 10)
    for i in range(6):
        fins = fins.fuse(Part.makeBox(4, 60, 25, Vector(4 + 13.6 * i, 0, 10)))
    fins = fins.cut(Part.makeCylinder(8, 60, Vector(40, 0, 5), Vector(0, 1, 0)))
    return {"pipe": (pipe, {"inlet": Vector(0, 0, 0), "outlet_1": Vector(0, 0, 60), "outlet_2": Vector(40, 0, 30)}),
            "elbow": (elbow, {"inlet": Vector(40, -5, 0), "outlet": Vector(0, 40, 0)}),
            "fins": (fins.removeSplitter(), {})}


def cases():
    """The rows of the table of cases."""
    import MeshQuality as mq

    rows = []
    for name, (solid, places) in models().items():
        patches = {patch: [f"Face{i}" for i, face in enumerate(solid.Faces, 1)
                           if (face.CenterOfMass - place).Length < 1e-3] for patch, place in places.items()}
        flow = "internal" if patches else "external"
        mesh = mq.triangulate(solid, chord_height_relative=0.002, patches=patches, patch_rest="walls")
        points, facets = solid.tessellate(mesh.report.chord_height_asked)
        plain = mq.triangulate(solid, chord_height_relative=0.002, patch_rest="walls")
        with tempfile.TemporaryDirectory() as folder:
            mq.write_openfoam_case(mesh, folder, flow=flow)
            rows.append((name, "MeshQuality", len(mesh.triangles), *meshed(folder)))
        with tempfile.TemporaryDirectory() as folder:
            mq.write_openfoam_case(plain, folder, flow=flow)  # the same but for names, then the other surface
            write_plain(os.path.join(folder, "constant", "triSurface", "surface.stl"), points, facets)
            rows.append((name, "FreeCAD", len(facets), *meshed(folder)))
        print(*rows[-2:], sep="\n", flush=True)
    return rows


def meshed(folder):
    """(cells, failed checks, patches, s)"""
    program("blockMesh", folder)
    _, seconds = program("snappyHexMesh", folder, "-overwrite")
    said, _ = program("checkMesh", folder)
    cells = re.search(r"cells:\s+(\d+)", said)
    failed = re.search(r"Failed (\d+) mesh checks", said)
    with open(os.path.join(folder, "constant", "polyMesh", "boundary"), encoding="utf-8") as stream:
        patches = [name for name in re.findall(r"^    (\w+)\s*\{", stream.read(), re.MULTILINE) if not name.endswith(("Min", "Max"))]
    ended = 0 if "Mesh OK." in said else None
    return int(cells[1]) if cells else 0, int(failed[1]) if failed else ended, " ".join(patches), round(seconds, 1)


def write_plain(path, points, facets):
    """An STL as FreeCAD's export has it: one solid without names of faces."""
    with open(path, "w", encoding="utf-8") as stream:
        stream.write("solid walls\n")
        for facet in facets:
            stream.write("facet normal 0 0 0\nouter loop\n")
            for corner in facet:
                stream.write("vertex {!r} {!r} {!r}\n".format(*(0.001 * number for number in points[corner])))
            stream.write("endloop\nendfacet\n")
        stream.write("endsolid walls\n")


def work(arguments):
    sys.stdout.reconfigure(line_buffering=True)
    found = surfaces(arguments) if arguments.surfaces else {}
    rows = [] if arguments.no_cases else cases()
    return {"surfaces": found, "cases": rows}


inside_freecad.start(__file__, parser(), work)
