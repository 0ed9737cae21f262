#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 18 to 21 of Dey, O'Bara, Shephard: a pipe assembly and a part, straight and curved, and Gmsh beside them.

    /usr/bin/python3 benchmarks/papers dey-examples [--order 2] [--out-dir docs/pictures]

The paper's models are not public. The pipes are a tee with flanges and an elbow, the part is the crank of tests/parts. Both
have periodic faces, as the paper's. Ours start from a coarse surface mesh (chord height 0.03 of the size). Gmsh, where the Python
given by --python has it, gets about as many tetrahedra, curves its own straight mesh, and repairs it (elastic analogy, then its
high-order optimisation). Both are judged by the core's proof: invalid tetrahedra right after curving and in the end, and the
least lower bound of min J / max J. Seconds are those of the processor; Gmsh's are without its straight mesh.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import inside_freecad
import numpy as np
import small_pictures

CHORD_HEIGHT = 0.03  # of the largest dimension
SHOWN = 1e-3  # deviation of the pictures' triangles, of the largest dimension
SECONDS = 100.0  # of the processor, for Gmsh


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--order", type=int, default=2, choices=(2, 3, 4))
    result.add_argument("--python", default="/usr/bin/python3", help="that has the module gmsh")
    result.add_argument("--out-dir", default=str(inside_freecad.ROOT / "docs" / "pictures"), help="folder for the picture")
    return result


def pipes():
    """A tee, an elbow on its branch, and flanges with bolt holes."""
    import math

    import Part
    from FreeCAD import Vector

    x, z = Vector(1, 0, 0), Vector(0, 0, 1)
    outer = Part.makeCylinder(1.0, 6.0, Vector(-3, 0, 0), x).fuse(Part.makeCylinder(0.8, 3.0, Vector(), z))
    inner = Part.makeCylinder(0.8, 7.0, Vector(-3.5, 0, 0), x).fuse(Part.makeCylinder(0.6, 3.0, Vector(), z))
    ends = []
    for radius in (0.8, 0.6):
        disc = Part.Face(Part.Wire(Part.makeCircle(radius, Vector(0, 0, 3), z)))
        ends.append(disc.revolve(Vector(2, 0, 3), Vector(0, 1, 0), 90))
    outer, inner = outer.fuse(ends[0]), inner.fuse(ends[1])
    for at in (-3.0, 2.6):
        outer = outer.fuse(Part.makeCylinder(1.7, 0.4, Vector(at, 0, 0), x))
        for k in range(6):
            turn = math.pi * k / 3.0
            inner = inner.fuse(Part.makeCylinder(0.15, 1.0, Vector(at - 0.3, 1.35 * math.cos(turn), 1.35 * math.sin(turn)), x))
    return outer.cut(inner).Solids[0]


def models():
    import parts

    return {"pipes": pipes(), "crank": parts.crank()}


def certified(mesh):
    """(tetrahedra, invalid, least lower bound of min J / max J) of a file."""
    import MeshQuality as mq
    from MeshQuality.compat import extension

    lows, verdicts = [], []
    read = mq.read_mesh(str(mesh))
    for block in read.blocks:
        if block.kind == "tetrahedron":
            low, _, verdict = extension().check_elements(block.kind, block.order, read.nodes, block.nodes)
            lows.append(low)
            verdicts.append(verdict)
    low, verdict = np.concatenate(lows), np.concatenate(verdicts)
    return len(low), int((verdict != 0).sum()), float(low.min())


def ours(shape, order, folder):
    import MeshQuality as mq

    mesh = mq.curve(shape, order=order, volume=True, chord_height_relative=CHORD_HEIGHT)
    mesh.write(folder / "ours.msh")
    count, invalid, least = certified(folder / "ours.msh")
    report = mesh.report
    return mesh, {"elements": count, "before": report.invalid_before, "after": invalid, "least": least, "seconds": report.cpu_seconds,
                  "repairs": {name: number for name, number in report.repairs.items() if number}}


def gmsh(shape, arguments, folder, count):
    shape.exportBrep(str(folder / "model.brep"))
    done = subprocess.run([arguments.python, str(inside_freecad.ROOT / "benchmarks" / "curve" / "curve_gmsh.py"), str(folder / "model.brep"),
                           str(folder), str(arguments.order), str(SECONDS), str(count)],
                          capture_output=True, text=True, env=inside_freecad.system_environment())
    if done.returncode != 0 or not done.stdout.strip():
        return {"failed": (done.stderr.strip().splitlines() or ["it crashed"])[-1]}
    said = json.loads(done.stdout.strip().splitlines()[-1])
    if said["plain"] is None or said["repaired"] is None:
        return {"failed": f"it did not end within {SECONDS:.0f} s"}
    before, after = (certified(folder / f"{name}.msh") for name in ("plain", "repaired"))
    return {"elements": after[0], "before": before[1], "after": after[1], "least": after[2], "seconds": said["repaired"]["seconds"],
            "version": said["version"]}


def drawing(vertices, triangles, lines, camera):
    """Polygons and their colours from the back to the front: shaded triangles that face the eye, and edges of elements."""
    points = np.asarray(vertices) @ camera.T
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    light = normals[:, 2] / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)
    size = np.ptp(points[:, 0])
    items = [(corner[:, 2].mean(), corner[:, :2], (0.45 + 0.5 * share) * np.array([0.72, 0.84, 0.95]))
             for corner, share in zip(corners, light) if share > 0.0]
    in_front = edges_of(np.asarray(triangles)[light > 0.0])
    items += [(points[[a, b], 2].mean() + 0.01 * size, points[[a, b, a], :2], np.zeros(3)) for a, b in lines
              if (min(a, b), max(a, b)) in in_front]
    items.sort(key=lambda item: item[0])
    return [item[1] for item in items], [item[2] for item in items]


def edges_of(triangles):
    return {tuple(sorted((t[k], t[(k + 1) % 3]))) for t in triangles.tolist() for k in range(3)}


def runs(edge_lines):
    """Pairs of vertices of runs that -1 ends."""
    return [(a, b) for a, b in zip(edge_lines[:-1], edge_lines[1:]) if a >= 0 and b >= 0]


def draw(meshes, path):
    """{name: CurvedMesh}: straight on the left, curved on the right."""
    import render
    from matplotlib.collections import PolyCollection

    figure, axes = small_pictures.panels(len(meshes), 2, 4.6, 3.6)
    camera = render.camera(-60.0, 30.0)
    for row, (name, mesh) in enumerate(meshes.items()):
        straight = mesh.straight
        size = np.ptp(straight.vertices, axis=0).max()
        shown = mesh.tessellate(SHOWN * size)
        surface = shown.surface()
        for axis, title, drawn in (
                (axes[2 * row], f"{name}: {len(straight.triangles):,} straight triangles",
                 drawing(straight.vertices, straight.triangles, edges_of(straight.triangles), camera)),
                (axes[2 * row + 1], f"curved, order {mesh.order}: {len(mesh.triangles):,}",
                 drawing(surface.vertices, surface.triangles, runs(np.asarray(shown.edge_lines).tolist()), camera))):
            polygons, colours = drawn
            axis.add_collection(PolyCollection(polygons, facecolors=colours, edgecolors=colours, linewidths=0.4))
            axis.set_aspect("equal")
            axis.autoscale()
            axis.set_title(title, fontsize=9)
    small_pictures.save(figure, path)


def text(name, by, row):
    if "failed" in row:
        return f"{name:<8} {by:<8} {row['failed']}"
    return f"{name:<8} {by:<8} {row['elements']:10,} {row['before']:14} {row['after']:7} {row['least']:13.3f} {row['seconds']:6.2f}  " \
           f"{', '.join(f'{number} {what}' for what, number in row.get('repairs', {}).items())}"


def work(arguments):
    sys.path.append(str(inside_freecad.ROOT / "tools"))
    has_gmsh = inside_freecad.has_module(arguments.python, "gmsh")
    if not has_gmsh:
        print(f"Gmsh is skipped: {arguments.python} has no module gmsh (package python3-gmsh)")
    meshes, found = {}, {}
    print(f"{'model':<8} {'by':<8} {'tetrahedra':>10} {'invalid before':>14} {'after':>7} {'min J / max J':>13} {'CPU s':>6}  repairs")
    for name, shape in models().items():
        with tempfile.TemporaryDirectory() as scratch:
            meshes[name], row = ours(shape, arguments.order, Path(scratch))
            found[name] = {"ours": row}
            print(text(name, "ours", row), flush=True)
            if has_gmsh:
                found[name]["gmsh"] = gmsh(shape, arguments, Path(scratch), row["elements"])
                print(text(name, "Gmsh", found[name]["gmsh"]), flush=True)
    draw(meshes, Path(arguments.out_dir) / "dey_examples.png")
    return {"order": arguments.order, "models": found}


inside_freecad.start(__file__, parser(), work)
