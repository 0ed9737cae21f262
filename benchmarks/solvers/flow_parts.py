# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers of volume_mesh in 25 parts from elsewhere: coverage, time, and what OpenFOAM's checkMesh says. A row of a table each.

    MESHQUALITY_DATA=<data> freecadcmd -P <root>/Mod benchmarks/solvers/flow_parts.py </dev/null
Needs checkMesh (Debian: openfoam). Valid single solids drawn at random from $MESHQUALITY_DATA/cad, filled as they are, all faces walls, and the
main wing and the flap of tests/parts, which the air flows around. Three layers, the first 0.0007 of the size high, growth 1.3, edges up to a 25th of
the size. PARTS="axle.step flap": only those. LIMIT=100: seconds of the clock for each.
"""

import os
import sys
import time
from pathlib import Path

import Part

import MeshQuality as mq
from MeshQuality.core.volumes.volume_report import percent

ROOT = Path(__file__).resolve().parents[2]
sys.path += [*map(str, (ROOT / "benchmarks").iterdir()), str(ROOT / "tests")]
from check_mesh import checked
from parts import wing

FILES = ("0049_control_arm.step", "rhs_wing.brep", "featuretype.step", "nafems-le10.step", "netgen_screw.step", "codo2.stp", "fuselage.brep",
         "axle.step", "Barrel_Body.stp", "milled_002.stp", "nist_ftc_10_asme1_rb.stp",
         "chess-rook-complex.stp", "Pump_TopCover.brep", "nist_ctc_01_asme1_rd.stp", "BSplHelix.brep", "mfcad_0-0-0-1-3-23.step",
         "rear_camera_mount.stp", "mal_vis.brep", "nist_ftc_06_asme1_rd.stp", "vessel.step", "pipejnt.step", "misc1.step", "torus.brep")
AROUND = {"main wing": wing.wing_main, "flap": wing.flap}
LIMIT = float(os.environ.get("LIMIT", 100))


def solid_of(name):
    shape = Part.Shape()
    shape.read(os.path.join(os.environ["MESHQUALITY_DATA"], "cad", name))
    return shape.Solids[0]


def row_of(name):
    """The cells of a part's row."""
    shape = AROUND[name]() if name in AROUND else solid_of(name)
    size = max(shape.BoundBox.XLength, shape.BoundBox.YLength, shape.BoundBox.ZLength)
    far = {"far_field": "box:2"} if name in AROUND else {}
    start, stages = time.time(), [""]

    def progress(_, stage):
        stages.append(stage)
        return time.time() - start < LIMIT

    try:
        mesh = mq.volume_mesh(shape, 3, 0.0007 * size, 1.3, max_edge=size / 25.0, progress=progress, **far)
    except mq.Cancelled:
        return [name, len(shape.Faces), f"none in {LIMIT:g} s: {stages[-1]}"]
    except mq.Error as error:
        return [name, len(shape.Faces), "", round(time.time() - start), str(error)]
    seconds, report = time.time() - start, mesh.report
    faults = checked(mesh)
    return [name, len(shape.Faces), f"{sum(report.elements.values()):,}", round(seconds), percent(report.covered) + " %",
            percent(report.full_height) + " %", f"{report.max_non_orthogonality:.0f}°", "; ".join(faults) or "Mesh OK", *report.notes]


def main():
    chosen = os.environ.get("PARTS", "").split() or [*FILES, *AROUND]
    for name in chosen:
        print("|", " | ".join(str(cell) for cell in row_of(name.replace("main_wing", "main wing"))), "|", flush=True)


main()
