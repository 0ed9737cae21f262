#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that Gmsh or Netgen made of CAD parts: certified, and curved by `mq.curve(part, mesh=...)`, beside their own curving.

    /usr/bin/python3 benchmarks/curve/given_meshes.py [--mesher gmsh|netgen] [--parts FOLDER] [--orders 2 3] [--plain]

Gmsh (Debian's python3-gmsh) meshes each part with sizes from curvature, 12 elements a turn, and makes the mesh one of the second
order: as it is placed, and optimised for high orders (method HighOrder, which moves nodes). Netgen (nglib, by the program given_netgen
of -DMESHQUALITY_BENCHMARKS=ON) has two elements a radius of curvature, and only places. Each of these is certified. The straight
mesh is curved. A row tells, by part: elements, invalid ones of each, nodes that moved, elements that are new, largest distance of
the surface from the CAD, CPU s. --plain: also the distance of curving without a mesh, where our own straight mesh
is as far from the CAD as the given one. --parts: a folder of CAD files; default: cad/ of $MESHQUALITY_DATA.
"""

import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

READ = {".step", ".stp", ".brep", ".brp", ".iges", ".igs"}
NETGEN_ELEMENTS = 2  # a radius of curvature: as many as FreeCAD's default


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--parts", default=str(inside_freecad.data_folder() / "cad"), help="folder of CAD files")
    result.add_argument("--mesher", choices=("gmsh", "netgen"), default="gmsh")
    result.add_argument("--netgen", default=str(inside_freecad.ROOT / "build" / "benchmarks" / "given_netgen"), help="the program")
    result.add_argument("--plain", action="store_true", help="also curve without a mesh")
    result.add_argument("--orders", type=int, nargs="+", default=[2, 3])
    result.add_argument("--seconds", type=int, default=120, help="of the processor, for a part")
    result.add_argument("--mesher-seconds", type=int, default=60, help="of the clock, for a part")
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


def run_mesher(command, folder, last, seconds):
    """What a program prints that writes the file `last`; None where it fails."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", stdin=subprocess.DEVNULL,
                              timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return None
    return done.stdout if done.returncode == 0 and os.path.exists(os.path.join(folder, last)) else None


def meshed_by_gmsh(path, folder, arguments):
    """{name of the mesh: s that it took}, None where Gmsh does not mesh the part."""
    said = run_mesher(["/usr/bin/python3", __file__, "--gmsh", str(path), folder], folder, "optimised.msh", arguments.mesher_seconds)
    if said is None:
        return None
    made, placed, optimised = map(float, said.split()[-3:])
    return {"placed": round(placed - made, 2), "optimised": round(optimised - placed, 2)}


def meshed_by_netgen(path, folder, arguments):
    """As meshed_by_gmsh. Netgen reads the shape that FreeCAD has read: of some files it takes one body alone."""
    from child import in_child

    brep = os.path.join(folder, "part.brep")

    def export():
        import Part

        Part.read(str(path)).exportBrep(brep)
        return True

    if not in_child(export, arguments.seconds):
        return None
    files = [os.path.join(folder, name) for name in ("straight.msh", "placed.msh")]
    said = run_mesher([arguments.netgen, brep, *files, str(NETGEN_ELEMENTS)], folder, "placed.msh", arguments.mesher_seconds)
    return said and {"placed": json.loads(said.splitlines()[-1])["seconds"]}


MESHERS = {"gmsh": meshed_by_gmsh, "netgen": meshed_by_netgen}


def plain_deviation(shape, straight, order):
    """Of the surface curved without a mesh, from a straight one that is as far from the CAD; None where that is not known."""
    import MeshQuality as mq

    try:
        chord = mq.certify(straight, shape).max_deviation
        return mq.curve(shape, order=order, chord_height=chord).report.max_deviation if chord else None
    except mq.Error:
        return None


def part_row(path, folder, seconds, arguments):
    """What came out of one part."""
    import MeshQuality as mq
    import Part

    shape = Part.read(str(path))
    row = {"part": path.name, "mesher_seconds": seconds}
    for name in seconds:
        certificate = mq.certify(os.path.join(folder, f"{name}.msh"))
        row[name] = {"elements": sum(certificate.elements.values()), "invalid": certificate.invalid}
    straight = mq.read_mesh(os.path.join(folder, "straight.msh"))
    for order in arguments.orders:
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
        if arguments.plain:
            row[f"order {order}"]["plain_deviation"] = plain_deviation(shape, straight, order)
    return row


def work(arguments):
    from child import outcome_in_child

    rows = []
    for path in sorted(Path(arguments.parts).iterdir(), key=lambda path: path.stat().st_size):
        if path.suffix.lower() not in READ or len(rows) == arguments.most:
            continue
        with tempfile.TemporaryDirectory() as folder:
            seconds = MESHERS[arguments.mesher](path, folder, arguments)
            if seconds is None:
                continue
            row, why = outcome_in_child(
                lambda path=path, folder=folder, seconds=seconds: part_row(path, folder, seconds, arguments), arguments.seconds)
        rows.append(row or {"part": path.name, "failed": why})
        print(json.dumps(rows[-1]), flush=True)
    summarise(rows, arguments)
    return {"rows": rows}


def summarise(rows, arguments):
    good = [row for row in rows if "failed" not in row]
    print(f"{len(rows)} parts meshed by {arguments.mesher}, {len(rows) - len(good)} without an outcome")
    for name in ("placed", "optimised") if arguments.mesher == "gmsh" else ("placed",):
        valid = sum(row[name]["invalid"] == 0 for row in good)
        print(f"{arguments.mesher}, order 2, {name}: all valid in {valid}, {sum(row[name]['invalid'] for row in good)} invalid of "
              f"{sum(row[name]['elements'] for row in good)} elements, {sum(row['mesher_seconds'][name] for row in good):.1f} s")
    for order in arguments.orders:
        found = [row[f"order {order}"] for row in good]
        done = [one for one in found if "error" not in one]
        ratios = sorted(one["deviation"] / one["plain_deviation"] for one in done if one.get("plain_deviation"))
        print(f"ours, order {order}: all valid in {sum(one['invalid'] == 0 for one in done)}, "
              f"{sum(one['invalid'] for one in done)} invalid elements, {len(found) - len(done)} refused, "
              f"{sum(one['moved'] for one in done)} nodes moved in {sum(one['moved'] > 0 for one in done)}, "
              f"{sum(one['new'] for one in done)} of {sum(one['elements'] for one in done)} elements new, "
              f"{sum(one['cpu_seconds'] for one in done):.1f} s, "
              f"verdicts differ in {sum(one['invalid'] != one['certified_invalid'] for one in done)}"
              + (f", deviation over that of plain curving: median {ratios[len(ratios) // 2]:.3f}, more than 1 in "
                 f"{sum(ratio > 1.0 for ratio in ratios)} of {len(ratios)}" if ratios else ""))


if sys.argv[1:2] == ["--gmsh"]:
    gmsh_meshes(*sys.argv[2:])
else:
    inside_freecad.start(__file__, parser(), work)
