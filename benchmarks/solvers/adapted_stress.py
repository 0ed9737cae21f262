#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest stress by uniform and by adapted meshes, over the unknowns: a plate with a hole, and a shaft with a fillet.

    /usr/bin/python3 benchmarks/solvers/adapted_stress.py [--only plate] [--most 60000]

CalculiX solves. Elements are quadratic. The exact stress is taken from a mesh with short edges where the largest stress is.
"""

import json
import sys
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

TARGET = 0.01
EDGES = {"plate": (12, 6, 4, 3), "shaft": (12, 8, 5.5, 4)}  # mm, of uniform meshes
GROWTH = 0.3  # of sizes with the distance from where the stress is largest, of the mesh for the exact stress


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--only", default="")
    result.add_argument("--most", type=int, default=60_000, help="unknowns of adapted meshes; 0: uniform meshes alone")
    result.add_argument("--target", type=float, default=0.002, help="of the error in the norm of energy")
    result.add_argument("--fine", type=float, nargs="+", default=[0.4], help="mm where the stress is largest, of meshes for the exact stress: the last counts")
    result.add_argument("--edges", type=float, nargs="+", help="mm, of uniform meshes, in place of those in EDGES")
    return result


def plate():
    import FreeCAD
    import Part

    return Part.makeBox(100, 50, 4).cut(Part.makeCylinder(2.5, 4, FreeCAD.Vector(50, 25, 0)))


def away(name, points):
    """The distances from the edge of the hole, or from the fillet, mm."""
    import numpy as np

    if name == "plate":
        return np.abs(np.hypot(points[:, 0] - 50, points[:, 1] - 25) - 2.5)
    return np.hypot(np.hypot(points[:, 1], points[:, 2]) - 5, points[:, 0] - 14)


def analysis_of(name, document):
    """The analysis with a coarse mesh."""
    import cantilever

    import MeshQuality as mq

    part = document.addObject("Part::Feature", "Part")
    part.Shape = plate() if name == "plate" else cantilever.bracket()
    document.recompute()
    analysis = cantilever.add_analysis(part, "force")
    if name == "plate":
        force = next(obj for obj in analysis.Group if obj.isDerivedFrom("Fem::ConstraintForce"))
        force.Direction, force.Reversed = (part, [cantilever.face_at(part.Shape, "x", 1)]), False
    mq.add_fem_mesh(part, analysis=analysis, max_edge=EDGES[name][0], order=2)
    return analysis


def work(arguments):
    import FreeCAD
    import numpy as np

    import MeshQuality as mq
    from MeshQuality.features.adapted_mesh import AnalysisOnMeshes

    rows = []
    for name in EDGES:
        if arguments.only not in name:
            continue
        document = FreeCAD.newDocument()
        solver = AnalysisOnMeshes(analysis_of(name, document), 2, None, lambda function: function())

        def measured(mesh, kind, solver=solver, name=name):
            found = solver.results(mesh)
            xx, yy, zz, xy, yz, zx = (found[key] for key in ("SXX", "SYY", "SZZ", "SXY", "SYZ", "SZX"))
            stress = np.sqrt(0.5 * ((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) + 3 * (xy**2 + yz**2 + zx**2))
            rows.append({"part": name, "kind": kind, "unknowns": 3 * len(mesh.nodes), "stress": float(stress.max()),
                         "at": mesh.nodes[int(stress.argmax())].round(2).tolist()})
            print(json.dumps(rows[-1]), flush=True)
            return np.column_stack([found[key] for key in ("D1", "D2", "D3")])

        for edge in arguments.edges or EDGES[name]:
            measured(mq.curve(solver.shape, order=2, volume=True, max_edge=edge), "uniform")
        if arguments.most:
            mq.adapt(lambda mesh: measured(mesh, "adapted"), solver.shape, target_error=arguments.target, max_unknowns=arguments.most, steps=6,
                     strains=True, max_edge=EDGES[name][0])
        for fine in arguments.fine:
            measured(mq.curve(solver.shape, order=2, volume=True, max_edge=EDGES[name][1],
                              size_field=lambda points, name=name, fine=fine: fine + GROWTH * away(name, points)), "exact")
        FreeCAD.closeDocument(document.Name)
    exact = {row["part"]: row["stress"] for row in rows if row["kind"] == "exact"}
    for row in rows:
        row["error"] = abs(row["stress"] / exact[row["part"]] - 1.0)
    needed = {f"{part} {kind}": unknowns_for(TARGET, [row for row in rows if (row["part"], row["kind"]) == (part, kind)])
              for part in exact for kind in ("uniform", "adapted")}
    print(json.dumps(needed), flush=True)
    return {"rows": rows, "unknowns at the target": needed}


def unknowns_for(target, rows):
    """The fewest unknowns from which on all meshes have a lower error; None: the last one has not."""
    found = None
    for row in sorted(rows, key=lambda row: -row["unknowns"]):
        if row["error"] > target:
            break
        found = row["unknowns"]
    return found


inside_freecad.start(__file__, parser(), work)
