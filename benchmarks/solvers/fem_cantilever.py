#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""FEM meshes for CalculiX in FreeCAD: ours beside those of FreeCAD's Gmsh and Netgen objects.

    /usr/bin/python3 benchmarks/solvers/fem_cantilever.py [--sizes 10 5]

prints a table for a beam of known deflection and one for a shaft with a fillet, against fine meshes. Gmsh is the program
of that name, or else Python's module gmsh, run as if it were that. What cannot run here is skipped, and says so.
"""

import resource
import sys
import tempfile
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

# Degree 3, by Keast: weights and barycentric points of a quadrature, exact for the Jacobian of ten nodes.
QUADRATURE = ((-0.8, (0.25, 0.25, 0.25, 0.25)), *((0.45, tuple(0.5 if i == j else 1 / 6 for j in range(4)))
                                                  for i in range(4)))
HEAD = "| mesh | longest edge | tetrahedra | nodes | CPU s | solver | folded | least J | volume | deflection |"
LATTICE = 6  # points along an edge at which the Jacobian is sampled
MIDDLES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))  # SMESH's order of middle nodes


def gradients(points):
    """(P, 10, 3): derivatives of the shape functions of a quadratic tetrahedron at barycentric points."""
    import numpy as np

    corners = np.vstack((-np.ones(3), np.eye(3)))  # of the barycentric coordinates
    made = [(4.0 * points[:, [i]] - 1.0) * corners[i] for i in range(4)]
    made += [4.0 * (points[:, [i]] * corners[j] + points[:, [j]] * corners[i]) for i, j in MIDDLES]
    return np.stack(made, axis=1)


def jacobians(mesh, points):
    """(E, P): Jacobians of the quadratic tetrahedra of a Fem.FemMesh over those of the straight ones; (E,): the latter."""
    import numpy as np

    numbers = {number: i for i, number in enumerate(mesh.Nodes)}
    nodes = np.array([tuple(point) for point in mesh.Nodes.values()])
    elements = nodes[[[numbers[n] for n in mesh.getElementNodes(volume)] for volume in mesh.Volumes]]
    found = np.linalg.det(np.einsum("pnk,enx->epxk", gradients(points), elements))
    straight = np.linalg.det(elements[:, 1:4] - elements[:, :1])
    return found / straight[:, None], np.abs(straight)


def lattice():
    """Barycentric points evenly spread in a tetrahedron, its corners among them."""
    import numpy as np

    count = range(LATTICE)
    return np.array([(i, j, k, LATTICE - 1 - i - j - k) for i in count for j in count for k in count
                     if i + j + k < LATTICE]) / (LATTICE - 1)


def geometry_of(mesh, shape):
    """(folded elements, least Jacobian over that of the straight element, relative error of the volume)."""
    import numpy as np

    sampled, _ = jacobians(mesh, lattice())
    weights, points = zip(*QUADRATURE)
    exact, straight = jacobians(mesh, np.array(points))
    volume = (exact @ np.array(weights) * straight).sum() / 6.0
    return int((sampled.min(axis=1) <= 0.0).sum()), float(sampled.min()), float(volume / shape.Volume - 1.0)


def cpu_seconds():
    """Of this process and of those that it has run."""
    return sum(used.ru_utime + used.ru_stime for used in map(resource.getrusage, (resource.RUSAGE_SELF,
                                                                                  resource.RUSAGE_CHILDREN)))


def study(shape, load, mesher, size):
    """One row of the table: {column: value}."""
    import cantilever
    import fem_meshers
    import FreeCAD

    document, row = FreeCAD.newDocument(), {"mesher": mesher, "size": size}
    try:
        part = document.addObject("Part::Feature", "Part")
        part.Shape = shape
        document.recompute()
        analysis = cantilever.add_analysis(part, load)
        before = cpu_seconds()
        mesh = fem_meshers.MESHERS[mesher](part, analysis, size).FemMesh
        row.update(cpu=cpu_seconds() - before, tetrahedra=mesh.VolumeCount, nodes=mesh.NodeCount)
        row["folded"], row["jacobian"], row["volume"] = geometry_of(mesh, part.Shape)
        end = part.Shape.getElement(cantilever.face_at(part.Shape, "x", 1))
        before = cpu_seconds()
        with tempfile.TemporaryDirectory() as folder:
            row["deflection"] = cantilever.deflection(cantilever.solve(analysis, folder), mesh, end)
        row["solver"] = cpu_seconds() - before
        return row
    except RuntimeError as error:
        return {**row, "skipped": str(error).strip().splitlines()[-1]}
    finally:
        FreeCAD.closeDocument(document.Name)


def line(row, expected):
    """One row as text; `expected`: the deflection, mm."""
    if "skipped" in row:
        return f"| {row['mesher']} | {row['size']:g} mm | skipped: {row['skipped']} |"
    return (f"| {row['mesher']} | {row['size']:g} mm | {row['tetrahedra']:,} | {row['nodes']:,} | {row['cpu']:.1f} | "
            f"{row['solver']:.0f} | {row['folded']} | {row['jacobian']:.2f} | {100 * row['volume']:+.4f} % | "
            f"{100 * (row['deflection'] / expected - 1):+.3f} % |")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--parts", nargs="+", choices=("beam", "shaft"), default=["beam", "shaft"])
    result.add_argument("--sizes", type=float, nargs="+", default=[10.0, 5.0], help="longest edges, mm")
    result.add_argument("--finest", type=float, default=2.5, help="that of the meshes that the shaft is judged by, mm")
    return result


def reference(shape, load, size):
    """The deflection on fine meshes, ours and Gmsh's: their mean, as nothing else knows it."""
    found = [study(shape, load, mesher, size) for mesher in ("MeshQuality", "Gmsh")]
    found = {row["mesher"]: row["deflection"] for row in found if "deflection" in row}
    print(f"on meshes of {size:g} mm: {found}")
    return sum(found.values()) / len(found)


def work(arguments):
    import cantilever
    import fem_meshers

    cases = {"beam": (cantilever.beam(), "force"), "shaft": (cantilever.bracket(), "weight")}
    results = {}
    with tempfile.TemporaryDirectory() as folder:
        fem_meshers.use_gmsh_module(folder)
        for part in arguments.parts:
            shape, load = cases[part]
            expected = cantilever.deflections()[load] if part == "beam" else reference(shape, load, arguments.finest)
            rows = [study(shape, load, mesher, size) for size in arguments.sizes for mesher in fem_meshers.MESHERS]
            print(f"{part}, {load}, deflection {expected:.6g} mm\n{HEAD}")
            print("\n".join(line(row, expected) for row in rows), flush=True)
            results[part] = {"expected": expected, "rows": rows}
    return results


inside_freecad.start(__file__, parser(), work)
