#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that Gmsh made of CAD parts: certified, and curved by `mq.curve(part, mesh=...)`, beside Gmsh's own curving.

    /usr/bin/python3 benchmarks/given_meshes.py [--parts FOLDER] [--orders 2 3]

Gmsh (Debian's python3-gmsh) meshes each part with sizes from curvature, 12 elements a turn, and makes the mesh one of the second
order: as it is placed, and optimised for high orders (method HighOrder, which moves nodes). Each of these three is
certified. The straight one is curved. A row tells, by part: elements, invalid ones of each, nodes that moved, largest distance of the
surface from the CAD, CPU s. --parts: a folder of CAD files; default: cad/ of $MESHQUALITY_DATA.
"""

import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import inside_freecad

READ = {".step", ".stp", ".brep", ".brp", ".iges", ".igs"}
GMSH_SECONDS = 60  # of the clock, for a part


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--parts", default=str(inside_freecad.data_folder() / "cad"), help="folder of CAD files")
    result.add_argument("--orders", type=int, nargs="+", default=[2, 3])
    result.add_argument("--seconds", type=int, default=120, help="of the processor, for a part")
    result.add_argument("--most", type=int, default=1000, help="parts at most")
    return result


def gmsh_meshes(path, folder):
    """Runs in a Python with Gmsh: writes straight.msh, placed.msh and optimised.msh, and their CPU s."""
    import gmsh

    def used():
        return resource.getrusage(resource.RUSAGE_SELF).ru_utime

    gmsh.initialize()
    for option, value in (("General.Terminal", 0), ("General.NumThreads", 1), ("Mesh.MeshSizeFromCurvature", 12),
                          ("Mesh.SaveAll", 1), ("Mesh.MshFileVersion", 4.1), ("Mesh.Binary", 1)):
        gmsh.option.setNumber(option, value)
    if path.lower().endswith((".step", ".stp")):
        gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
    gmsh.model.occ.importShapes(path, highestDimOnly=False)
    gmsh.model.occ.synchronize()
    gmsh.model.mesh.generate(3)
    seconds = [used()]
    gmsh.write(os.path.join(folder, "straight.msh"))
    gmsh.model.mesh.setOrder(2)
    seconds.append(used())
    gmsh.write(os.path.join(folder, "placed.msh"))
    gmsh.model.mesh.optimize("HighOrder")
    seconds.append(used())
    gmsh.write(os.path.join(folder, "optimised.msh"))
    print(*seconds)


def meshed_by_gmsh(path, folder):
    """[s to place, s to optimise], None where Gmsh does not mesh the part."""
    command = ["/usr/bin/python3", __file__, "--gmsh", str(path), folder]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=GMSH_SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return None
    if done.returncode or not os.path.exists(os.path.join(folder, "optimised.msh")):
        return None
    made, placed, optimised = map(float, done.stdout.split()[-3:])
    return [round(placed - made, 2), round(optimised - placed, 2)]


def part_row(path, folder, gmsh_seconds, orders):
    """What came out of one part."""
    import MeshQuality as mq
    import Part

    shape = Part.read(str(path))
    row = {"part": path.name, "gmsh_seconds": gmsh_seconds}
    for name in ("placed", "optimised"):
        certificate = mq.certify(os.path.join(folder, f"{name}.msh"))
        row[name] = {"elements": sum(certificate.elements.values()), "invalid": certificate.invalid}
    straight = mq.read_mesh(os.path.join(folder, "straight.msh"))
    for order in orders:
        try:
            curved = mq.curve(shape, mesh=straight, order=order)
        except mq.Error as error:
            row[f"order {order}"] = {"error": str(error)}
            continue
        report = curved.report
        certificate = mq.certify(curved, shape)
        row[f"order {order}"] = {
            "elements": report.elements, "invalid": report.invalid, "certified_invalid": certificate.invalid,
            "invalid_elements": list(report.invalid_elements)[:5], "moved": len(curved.moved_nodes),
            "new": int((curved.given_element < 0).sum()), "deviation": certificate.max_deviation,
            "cpu_seconds": round(report.cpu_seconds, 2)}
    return row


def work(arguments):
    from child import outcome_in_child

    rows = []
    for path in sorted(Path(arguments.parts).iterdir(), key=lambda path: path.stat().st_size):
        if path.suffix.lower() not in READ or len(rows) == arguments.most:
            continue
        with tempfile.TemporaryDirectory() as folder:
            gmsh_seconds = meshed_by_gmsh(path, folder)
            if gmsh_seconds is None:
                continue
            row, why = outcome_in_child(
                lambda path=path, folder=folder, times=gmsh_seconds: part_row(path, folder, times, arguments.orders),
                arguments.seconds)
        rows.append(row or {"part": path.name, "failed": why})
        print(rows[-1], flush=True)
    summarise(rows, arguments.orders)
    return {"rows": rows}


def summarise(rows, orders):
    good = [row for row in rows if "failed" not in row]
    print(f"{len(rows)} parts meshed by Gmsh, {len(rows) - len(good)} without an outcome")
    for name in ("placed", "optimised"):
        valid = sum(row[name]["invalid"] == 0 for row in good)
        print(f"Gmsh, order 2, {name}: all valid in {valid}, {sum(row[name]['invalid'] for row in good)} invalid elements")
    for order in orders:
        found = [row[f"order {order}"] for row in good]
        done = [one for one in found if "error" not in one]
        print(f"ours, order {order}: all valid in {sum(one['invalid'] == 0 for one in done)}, "
              f"{sum(one['invalid'] for one in done)} invalid elements, {len(found) - len(done)} refused, "
              f"verdicts differ in {sum(one['invalid'] != one['certified_invalid'] for one in done)}")


if sys.argv[1:2] == ["--gmsh"]:
    gmsh_meshes(*sys.argv[2:])
else:
    inside_freecad.start(__file__, parser(), work)
