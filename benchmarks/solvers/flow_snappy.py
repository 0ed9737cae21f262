# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers of volume_mesh beside those of OpenFOAM's snappyHexMesh on the same surfaces: coverage, time, faults of checkMesh.

    freecadcmd -P <root>/Mod benchmarks/solvers/flow_snappy.py </dev/null
Needs blockMesh, snappyHexMesh and checkMesh (Debian: openfoam). Five regions, 5 layers of 0.05 mm and on, growth 1.2, on all walls but
openings; PARTS="step": only those that are named so. The surface is ours for both, with patches and sharp edges by write_openfoam_case; cells of the background are as long as
our edges may be. snappyHexMesh gets absolute sizes and a feature angle of 130 degrees, so that layers go around edges. Two lines each.
"""

import os
import re
import subprocess
import tempfile
import time

import Part
from FreeCAD import Vector

import MeshQuality as mq

ENVIRONMENT = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}
LAYERS, FIRST, GROWTH, EDGE = 5, 0.05, 1.2, 1.5
CHANGES = {"addLayers false": "addLayers true", "relativeSizes true": "relativeSizes false", "featureAngle 60": "featureAngle 130",
           "layers {}": f"layers {{ walls {{ nSurfaceLayers {LAYERS}; }} }}", "expansionRatio 1.2": f"expansionRatio {GROWTH}",
           "finalLayerThickness 0.3": f"firstLayerThickness {FIRST / 1000}", "minThickness 0.1": f"minThickness {0.2 * FIRST / 1000}"}


def regions():
    """{name: (solid, a place of each opening)}"""
    bend = Part.Face(Part.Wire(Part.makeCircle(3, Vector(12, 0, 0), Vector(0, 1, 0)))).revolve(Vector(), Vector(0, 0, 1), 90)
    branch = Part.makeCylinder(2, 14, Vector(), Vector(0.8, 0, 0.6))
    ribs = Part.makeBox(30, 8, 6)
    for i in range(3):
        ribs = ribs.cut(Part.makeBox(1, 8, 2, Vector(6 + 8 * i, 0, 0)))
    bank = Part.makeBox(20, 10, 4)
    for i in range(3):
        bank = bank.cut(Part.makeCylinder(1, 4, Vector(4 + 5 * i, 4 + i, 0)))
    step = Part.makeBox(20, 8, 4).fuse(Part.makeBox(20, 8, 8, Vector(20, 0, -4))).removeSplitter()
    return {"pipe bend": (bend, [Vector(12, 0, 0), Vector(0, 12, 0)]),
            "junction": (Part.makeCylinder(3, 24, Vector(0, 0, -12)).fuse(branch).removeSplitter(),
                         [Vector(0, 0, -12), Vector(0, 0, 12), Vector(11.2, 0, 8.4)]),
            "duct with ribs": (ribs, [Vector(0, 4, 3), Vector(30, 4, 3)]), "bank of cylinders": (bank, [Vector(0, 5, 2), Vector(20, 5, 2)]),
            "step": (step, [Vector(0, 4, 2), Vector(40, 4, 0)])}


def program(name, folder, *arguments):
    done = subprocess.run([name, *arguments], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=3000, check=False)
    return done.stdout + done.stderr


def faults(folder):
    said = program("checkMesh", folder)
    found = [line.strip() for line in said.splitlines() if "***" in line]
    worst = re.search(r"non-orthogonality Max: ([\d.]+)", said)
    cells = re.search(r"cells:\s+(\d+)", said)
    return int(cells[1]), float(worst[1]), ("Mesh OK" if "Mesh OK." in said else found)


def told(name, how, seconds, coverage, checked):
    cells, worst, found = checked
    print(f"{name}, {how}: {cells:,} cells, {seconds:.1f} s, {coverage}, non-orthogonality {worst:.0f}°, {found}", flush=True)


def main():
    for name, (solid, places) in regions().items():
        if os.environ.get("PARTS", "") not in name:
            continue
        solid = solid.Solids[0]
        openings = [f"Face{i}" for i, face in enumerate(solid.Faces, 1) if any((face.CenterOfMass - place).Length < 0.01 for place in places)]
        named = {"patches": {"openings": openings}, "patch_rest": "walls"}
        with tempfile.TemporaryDirectory() as folder:
            start = time.time()
            mesh = mq.volume_mesh(solid, LAYERS, FIRST, GROWTH, walls=["walls"], max_edge=EDGE, **named)
            seconds = time.time() - start
            mesh.write(folder, format="openfoam")
            told(name, "volume_mesh", seconds, f"layers on {mesh.report.covered:.1%} of the area, as high as asked on "
                 f"{mesh.report.full_height:.1%}", faults(folder))
        with tempfile.TemporaryDirectory() as folder:
            mq.write_openfoam_case(mq.triangulate(solid, max_edge=EDGE, **named), folder, cell=EDGE, types={"openings": "patch"})
            path = os.path.join(folder, "system", "snappyHexMeshDict")
            with open(path, encoding="utf-8") as stream:
                text = stream.read()
            for old, new in CHANGES.items():
                assert old in text, old
                text = text.replace(old, new)
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(text)
            start = time.time()
            program("blockMesh", folder)
            said = program("snappyHexMesh", folder, "-overwrite")
            seconds = time.time() - start
            rows = re.findall(r"Extruding (\d+) out of (\d+) faces .*?Added (\d+) out of (\d+) cells", said, re.DOTALL)
            if not rows:
                print(name, "snappyHexMesh:", said[-500:], flush=True)
                continue
            faces, of_faces, cells, of_cells = map(int, rows[-1])
            told(name, "snappyHexMesh", seconds, f"layers on {faces / of_faces:.1%} of the faces, {cells / of_cells:.1%} of all cells of layers",
                 faults(folder))


main()
