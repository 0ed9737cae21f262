#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest von Mises stress on FEM meshes with default options, by CalculiX.

    /usr/bin/python3 benchmarks/fem_stress.py [--parts cantilever bracket shaft]

prints a row for each part and each number of elements through its walls, against a mesh with edges of 1.5 mm, that of the
cantilever against beam theory.
"""

import tempfile
import time

import inside_freecad

REFERENCE_EDGE = 1.5  # mm
HEAD = "| part | elements through | longest edge | tetrahedra | expected | solver s | largest stress | error |"


def largest_stress(name, folder, **values):
    """{"tetrahedra", "expected", "edge", "stress", "solver"} of a FEM mesh of the part with these options; edge in mm, stress
    in MPa.
    """
    import cantilever
    import FreeCAD

    import MeshQuality as mq
    from MeshQuality import fem_options, options
    from MeshQuality.core import fem_size

    make, clamped, end = {"cantilever": (cantilever.bored, ("x", -1), ("x", 1)),
                          "bracket": (cantilever.angle_bracket, ("z", -1), ("z", 1)),
                          "shaft": (cantilever.bracket, ("x", -1), ("x", 1))}[name]
    document = FreeCAD.newDocument()
    try:
        part = document.addObject("Part::Feature", "Part")
        part.Shape = make()
        document.recompute()
        analysis = cantilever.add_analysis(part, "force", clamped)
        force = next(obj for obj in analysis.Group if obj.isDerivedFrom("Fem::ConstraintForce"))
        force.Force, force.References = cantilever.BORED_FORCE, [(part, cantilever.face_at(part.Shape, *end))]
        along = "x" if name == "bracket" else "z"
        force.Direction = (part, [cantilever.face_at(part.Shape, along, 1)])
        mesh = mq.add_fem_mesh(part, analysis=analysis, **values).FemMesh
        asked = options.check(fem_options.FEM, values)
        before = time.perf_counter()
        stress = max(cantilever.solve(analysis, folder).vonMises)
        return {"tetrahedra": mesh.VolumeCount, "expected": fem_size.expected_elements(part.Shape, asked),
                "edge": fem_size.longest_edge(part.Shape, asked)[0], "stress": stress,
                "solver": time.perf_counter() - before}
    finally:
        FreeCAD.closeActiveTransaction()  # opened by what reads the results
        FreeCAD.closeDocument(document.Name)


def parser():
    result = inside_freecad.command_line(__doc__)
    names = ["cantilever", "bracket", "shaft"]
    result.add_argument("--parts", nargs="+", choices=names, default=names)
    return result


def work(arguments):
    import cantilever

    print(HEAD)
    for name in arguments.parts:
        with tempfile.TemporaryDirectory() as folder:
            right = cantilever.BORED_STRESS if name == "cantilever" \
                else largest_stress(name, folder, max_edge=REFERENCE_EDGE)["stress"]
            for through in (1, 2, 3):
                row = largest_stress(name, folder, elements_through=through)
                print(f"| {name} | {through} | {row['edge']:.2f} mm | {row['tetrahedra']:,} | {row['expected']:,} | "
                      f"{row['solver']:.0f} | {row['stress']:.1f} MPa | {100 * (row['stress'] / right - 1):+.1f} % |", flush=True)


if __name__ == "__main__":
    inside_freecad.start(__file__, parser(), work)
