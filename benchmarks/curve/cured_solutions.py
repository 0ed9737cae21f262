#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What Gmsh's meshes are good for once they are cured: solutions that are known, against theirs.

    /usr/bin/python3 benchmarks/curve/cured_solutions.py [--picture docs/pictures/cured_convergence.svg]

Poisson's equation in a torus (poisson.py) on one mesh at orders 1 to 4, and an eighth of a hollow sphere under inner pressure,
which CalculiX (ccx) solves and Lame's formulas know. Gmsh is Python's module gmsh. Prints a table of each.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

PYTHON = "/usr/bin/python3"
ORDERS = (1, 2, 3, 4)
INNER, OUTER, PRESSURE, YOUNG, RATIO = 10.0, 20.0, 100.0, 210000.0, 0.3  # mm, MPa
GMSH = """
import sys
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setNumber("Mesh.MeshSizeMax", float(sys.argv[3]))
gmsh.option.setNumber("Mesh.SecondOrderLinear", 1 if sys.argv[5] == "straight" else 0)
gmsh.open(sys.argv[1])
for dimension, name in ((2, "Face"), (3, "Solid")):
    for _, tag in gmsh.model.getEntities(dimension):
        gmsh.model.setPhysicalName(dimension, gmsh.model.addPhysicalGroup(dimension, [tag]), f"{name}{tag}")
gmsh.model.mesh.generate(3)
gmsh.model.mesh.setOrder(int(sys.argv[4]))
gmsh.write(sys.argv[2])
"""


def gmsh_mesh(shape, path, size, order=1, middle="placed"):
    """Gmsh's mesh of a shape, in a file."""
    brep = os.path.splitext(path)[0] + ".brep"
    shape.exportBrep(brep)
    subprocess.run([PYTHON, "-c", GMSH, brep, path, str(size), str(order), middle], check=True,
                   capture_output=True, timeout=600)
    return path


def poisson_rows(folder):
    """As poisson.study has them, of a mesh of Gmsh that is cured."""
    import numpy as np
    import Part
    import poisson

    import MeshQuality as mq

    shape, rows = Part.makeTorus(poisson.RADIUS, poisson.TUBE), []
    path = gmsh_mesh(shape, os.path.join(folder, "torus.msh"), 0.36)
    for order in ORDERS:
        box = mq.curve(Part.makeBox(1, 1, 1), order=order, volume=True)
        element = poisson.Element(order, poisson.places_of_nodes(box.nodes, box.elements, order))
        mesh = mq.curve(shape, mesh=path, order=order)
        if mesh.report.invalid:
            raise ValueError(str(mesh.report))
        row = [order, len(mesh.elements)]
        for nodes in (mesh.nodes, poisson.straightened(mesh.nodes, mesh.elements, element)):
            problem = poisson.Problem(nodes, mesh.elements, np.unique(mesh.triangles), element, order)
            u, unknowns = problem.solve()
            row += [unknowns] * (len(row) == 2) + list(problem.errors(u))
        rows.append(tuple(row))
    return rows


def shell():
    """An eighth of a hollow sphere, and {name of a set: its face}."""
    import FreeCAD
    import Part

    cut = [Part.makeSphere(radius, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 0, 90, 90) for radius in (OUTER, INNER)]
    shape = cut[0].cut(cut[1])
    faces = {}
    for i, face in enumerate(shape.Faces, 1):
        centre = face.CenterOfMass
        if isinstance(face.Surface, Part.Sphere):
            faces["inner" if face.Surface.Radius < 15 else "outer"] = f"Face{i}"
        else:
            faces[min("xyz", key=lambda axis, at=centre: abs(getattr(at, axis)))] = f"Face{i}"
    return shape, faces


def exact(radius):
    """Displacement outwards and hoop stress at a radius."""
    share = PRESSURE * INNER**3 / (OUTER**3 - INNER**3)
    return (share / YOUNG * ((1 - 2 * RATIO) * radius + (1 + RATIO) * OUTER**3 / (2 * radius**2)),
            share * (1 + OUTER**3 / (2 * radius**3)))


def solve(path, sets):
    """(errors of the displacement, of the hoop stress), both as parts of the largest: CalculiX on an .inp file of a mesh."""
    import numpy as np

    with open(path, encoding="utf-8") as file:
        text = file.read()
    fixed = "".join(f"{sets[axis]},{k},{k}\n" for k, axis in enumerate("xyz", 1))
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"{text}*NSET, NSET=all_nodes, GENERATE\n1, {_nodes(text)}\n*ELSET, ELSET=all_elements\n{sets['body']}\n"
                   f"*MATERIAL, NAME=steel\n*ELASTIC\n{YOUNG},{RATIO}\n*SOLID SECTION, ELSET=all_elements, MATERIAL=steel\n*STEP\n*STATIC\n"
                   f"*BOUNDARY\n{fixed}*DSLOAD\n{sets['inner']}_surface,P,{PRESSURE}\n*NODE PRINT, NSET=all_nodes\nU\n"
                   "*EL PRINT, ELSET=all_elements\nS,COORD\n*END STEP\n")
    done = subprocess.run(["ccx", os.path.splitext(path)[0]], capture_output=True, text=True, timeout=600, cwd=os.path.dirname(path))
    tables = _tables(os.path.splitext(path)[0] + ".dat")
    if len(tables) < 3:
        raise RuntimeError(done.stdout[-1000:])
    nodes = np.array([line.split(",")[1:4] for line in text.split("*NODE\n")[1].split("*")[0].splitlines()], dtype=float)
    moved, stress, places = (next(np.array(rows) for name, rows in tables.items() if name.startswith(start))
                             for start in ("displacements", "stresses", "global coordinates"))
    at = nodes[moved[:, 0].astype(int) - 1]
    radius = np.linalg.norm(at, axis=1)
    outwards = (moved[:, 1:] * at).sum(axis=1) / radius
    tensor = stress[:, 2:8]  # xx yy zz xy xz yz
    normal = places[:, 2:5] / np.linalg.norm(places[:, 2:5], axis=1)[:, None]
    x, y, z = normal.T
    radial = (tensor * np.stack([x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z], axis=1)).sum(axis=1)
    hoop = (tensor[:, :3].sum(axis=1) - radial) / 2
    wanted = exact(radius), exact(np.linalg.norm(places[:, 2:5], axis=1))
    return (float(np.abs(outwards - wanted[0][0]).max() / wanted[0][0].max()), float(np.abs(hoop - wanted[1][1]).max() / wanted[1][1].max()))


def _nodes(text):
    return text.split("*NODE\n")[1].split("*")[0].count("\n")


def _tables(path):
    """{title: rows} of a .dat file."""
    found, rows = {}, []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words and re.match(r"[a-z]", words[0]):
                rows = found.setdefault(line.strip(), [])
            elif words:
                rows.append([float(word) for word in words])
    return found


def sphere_rows(folder, sizes=(6.0, 3.0)):
    """(mesh, size, elements, error of the volume, of the displacement and of the hoop stress)"""
    import math

    import MeshQuality as mq

    (shape, faces), rows = shell(), []
    volume = math.pi / 6 * (OUTER**3 - INNER**3)
    for size in sizes:
        linear = gmsh_mesh(shape, os.path.join(folder, "linear.msh"), size)
        for name in ("Gmsh, order 1", "Gmsh, order 2, straight", "Gmsh, order 2, as placed", "cured, order 2"):
            path = os.path.join(folder, "solve.inp")
            if name.startswith("cured"):
                mesh = mq.curve(shape, mesh=linear, order=2, patches={name: [face] for name, face in faces.items()})
                mesh.write(path)
                sets = {**{name: name for name in faces}, "body": "Solid1"}
            else:
                source = linear if "1" in name else gmsh_mesh(shape, os.path.join(folder, "second.msh"), size, 2, name.split()[-1])
                mesh = mq.read_mesh(source)
                mesh.write(path)
                sets = {**faces, "body": "Solid1"}
            of_mesh = mq.certify(mesh)
            count = sum(of_mesh.elements.values())
            rows.append((name, size, count, _volume(mesh) / volume - 1.0, *solve(path, sets)))
    return rows


def _volume(mesh):
    """By quadrature, of the elements of an ElementMesh or a CurvedMesh."""
    import numpy as np
    import poisson
    from MeshQuality.core.meshes.element_mesh import ElementMesh
    from MeshQuality.core.elements import kinds

    mesh = ElementMesh.of(mesh)
    block = mesh.blocks[0]
    element = poisson.Element(block.order, kinds.places(block.kind, block.nodes.shape[1]))
    points, weights = poisson.quadrature(3)
    jacobian = np.einsum("qnr,enx->eqxr", element.gradients(points), mesh.nodes[block.nodes])
    return float((weights * np.linalg.det(jacobian)).sum())


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--picture", type=os.path.abspath, help="file to draw the errors of Poisson's equation into")
    return result


def work(arguments):
    import poisson

    with tempfile.TemporaryDirectory() as folder:
        rows = poisson_rows(folder)
        print("order elements unknowns  cured: L2, H1          straight: L2, H1")
        for row in rows:
            print("{:5d} {:8d} {:8d}  {:9.2e} {:9.2e}   {:9.2e} {:9.2e}".format(*row), flush=True)
        if arguments.picture:
            poisson.draw(rows, arguments.picture, " of Gmsh's, cured")
        solid = sphere_rows(folder)
        print("| mesh | size | tetrahedra | volume | displacement | hoop stress |")
        for row in solid:
            print("| {} | {:g} mm | {:,} | {:+.4%} | {:.3%} | {:.2%} |".format(*row), flush=True)
    return {"poisson": rows, "sphere": solid}


inside_freecad.start(__file__, parser(), work)
