#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tetrahedral mesher: CPU seconds, tetrahedra and dihedral angles; prints a table in Markdown.

    /usr/bin/python3 benchmarks/curve/filling.py [--parts FOLDER] [--most 60] [--program build/benchmarks/fill_surfaces]

The closed solids of the parts in a folder, smallest files first, each alone, meshed with the options of curving.
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

SECONDS = 120.0  # on the clock, for one surface


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--parts", default=str(inside_freecad.data_folder() / "cad"))
    result.add_argument("--most", type=int, default=60, help="surfaces")
    result.add_argument("--program", default=str(inside_freecad.ROOT / "build" / "benchmarks" / "fill_surfaces"))
    return result


def surfaces(folder, most, into):
    """Files of the surfaces of closed solids, by name of the part."""
    import Part

    import MeshQuality as mq

    found = []
    for path in sorted((p for p in Path(folder).iterdir() if p.is_file()), key=os.path.getsize):
        if len(found) >= most:
            break
        try:
            shape = Part.read(str(path))
            if len(shape.Solids) != 1:
                continue
            mesh = mq.triangulate(shape.Solids[0], min_angle=20.0)
        except (mq.Error, Exception) as error:  # noqa: BLE001 - FreeCAD raises its own kinds for files that it cannot read
            print(f"{path.name}: left out, {str(error)[:80]}", flush=True)
            continue
        if mesh.report.closed and not mesh.report.self_intersections:
            found.append(Path(into) / f"{path.name}.off")
            mesh.write(found[-1])
    return found


def filled(program, path):
    """The row of one surface; None where the time is up."""
    try:
        done = subprocess.run([program, str(path)], capture_output=True, text=True, timeout=SECONDS, check=True)
    except subprocess.TimeoutExpired:
        return None
    return json.loads(done.stdout)


def table(rows):
    """What the rows of surfaces that were filled come to."""
    done = [row for row in rows if "tetrahedra" in row]
    print(f"\n{len(rows)} surfaces, {len(done)} filled\n\n| | |\n|---|---|")
    for title, key, total in (("CPU s, all", "seconds", sum), ("tetrahedra, all", "tetrahedra", sum),
                              ("without positive volume", "flat", sum),
                              ("smallest dihedral angle, median, degrees", "smallest", statistics.median),
                              ("angle that a twentieth are below, median", "twentieth", statistics.median)):
        print(f"| {title} | {total([row[key] for row in done]):,.4g} |")


def work(arguments):
    """The rows of all surfaces."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for path in surfaces(arguments.parts, arguments.most, folder):
            row = filled(arguments.program, path)
            if row is None:
                print(f"{path.stem}: not done in {SECONDS:g} s", flush=True)
                continue
            rows.append(row)
            print(path.stem, f"{row['seconds']:.2f} s", row.get("failed", ""), flush=True)
    table(rows)
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
