#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our own tetrahedral mesher beside Netgen's: CPU seconds, tetrahedra and dihedral angles; prints a table in Markdown.

    /usr/bin/python3 benchmarks/filling.py [--parts FOLDER] [--most 60] [--program build/benchmarks/fill_surfaces]

The closed solids of the parts in a folder, smallest files first, each alone, meshed with the options of curving. Both
meshers get the same surfaces, in this run. Netgen's time includes its process.
"""

import json
import os
import statistics
import subprocess
import tempfile
from pathlib import Path

import inside_freecad

SECONDS = 120.0  # on the clock, for both meshers of one surface


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


def both(program, path):
    """{mesher: row} of one surface; None where the time is up."""
    try:
        done = subprocess.run([program, str(path)], capture_output=True, text=True, timeout=SECONDS, check=True)
    except subprocess.TimeoutExpired:
        return None
    return {row["mesher"]: row for row in map(json.loads, done.stdout.splitlines())}


def table(rows):
    """What the rows in which both meshers have filled come to."""
    done = [row for row in rows if all("tetrahedra" in row[name] for name in ("own", "netgen"))]
    print(f"\n{len(rows)} surfaces; filled by ours {sum('tetrahedra' in row['own'] for row in rows)}, by Netgen "
          f"{sum('tetrahedra' in row['netgen'] for row in rows)}, by both {len(done)}\n")
    print("| | ours | Netgen |\n|---|---|---|")
    for title, key, sums in (("CPU s, all", "seconds", True), ("tetrahedra, all", "tetrahedra", True),
                             ("without positive volume", "flat", True), ("smallest dihedral angle, median, degrees", "smallest", False),
                             ("angle that a twentieth are below, median", "twentieth", False)):
        values = [(sum if sums else statistics.median)([row[name][key] for row in done]) for name in ("own", "netgen")]
        print(f"| {title} | {values[0]:,.4g} | {values[1]:,.4g} |")
    ratios = sorted(row["netgen"]["seconds"] / row["own"]["seconds"] for row in done)
    worse = [row["own"]["surface"] for row in done if row["own"]["smallest"] < row["netgen"]["smallest"] - 0.1]
    print(f"\nNetgen's time by ours: {ratios[0]:.1f} to {ratios[-1]:.1f}, median {statistics.median(ratios):.1f}. "
          f"Smallest angle worse by more than 0.1 degrees: {', '.join(Path(name).stem for name in worse) or 'none'}")


def work(arguments):
    """The rows of all surfaces."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for path in surfaces(arguments.parts, arguments.most, folder):
            row = both(arguments.program, path)
            if row is None:
                print(f"{path.stem}: not done in {SECONDS:g} s", flush=True)
                continue
            rows.append(row)
            failed = "; ".join(f"{name}: {row[name]['failed'][:80]}" for name in row if "failed" in row[name])
            print(path.stem, " ".join(f"{name} {row[name]['seconds']:.2f} s" for name in row), failed, flush=True)
    table(rows)
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
