#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The volume of parts by OpenCASCADE with as many Gauss points as it takes by itself, against that of curved meshes'
reports, `cad_volume`, which is integrated adaptively; and, to judge between them, against that of a fine flat mesh.

    /usr/bin/python3 benchmarks/triangulate/cad_volumes.py [--chord-height-relative 2e-4] [FILE ...]

The fixed one is Shape.Volume in FreeCAD. All are of the solids alone, one by one. Files without a path lie in the data
folder, see inside_freecad.data_folder.
"""

import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

FILES = ("M6-1x12-countersunk-screw.step", "fuselage.brep", "777-200LR_Onshape.step")
HEAD = f"{'file':<32} {'solids':>6} {'cad_volume':>13} {'fixed':>9} {'flat mesh':>9} {'fixed s':>8} {'closed':>7}"


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("files", nargs="*", default=list(FILES), metavar="FILE")
    result.add_argument("--chord-height-relative", type=float, default=2e-4, help="of the flat mesh")
    return result


def volumes(solid, chord):
    """(adaptive, fixed, of a flat mesh, seconds of the fixed one, whether the mesh is closed)."""
    import MeshQuality as mq

    flat = mq.triangulate(solid, min_angle=5.0, chord_height_relative=chord).report
    adaptive = mq.curve(solid, order=1, chord_height_relative=0.01).report.cad_volume
    start = time.perf_counter()
    fixed = abs(solid.copy().Volume)
    return adaptive, fixed, abs(flat.volume), time.perf_counter() - start, flat.closed


def measure(name, chord):
    import Part

    path = inside_freecad.data_folder() / "cad" / name
    shape = Part.read(str(path))
    found = [volumes(solid, chord) for solid in shape.Solids]
    adaptive, fixed, flat, seconds = (sum(row[i] for row in found) for i in range(4))
    return {"file": name, "solids": len(found), "cad_volume": adaptive, "fixed": fixed, "flat_mesh": flat,
            "fixed_seconds": seconds, "closed": all(row[4] for row in found)}


def line(row):
    fixed, flat = (100 * (row[key] / row["cad_volume"] - 1) for key in ("fixed", "flat_mesh"))
    return f"{row['file']:<32} {row['solids']:6} {row['cad_volume']:13.6g} {fixed:+7.2f} % {flat:+7.2f} % " \
           f"{row['fixed_seconds']:8.3f} {str(row['closed']):>7}"


def work(arguments):
    print(HEAD)
    rows = []
    for name in arguments.files:
        rows.append(measure(name, arguments.chord_height_relative))
        print(line(rows[-1]), flush=True)
    return {"chord_height_relative": arguments.chord_height_relative, "files": rows}


inside_freecad.start(__file__, parser(), work)
