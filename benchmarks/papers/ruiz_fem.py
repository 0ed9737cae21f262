#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Future work (b) of Ruiz et al.: how good meshes of Star, Sprinkle, refine and Gmsh are for finite elements.

    /usr/bin/python3 benchmarks/papers ruiz-fem [--python PYTHON] [--solids crank]

Linear triangles for -Laplace(u) + u / L^2 = f on the surface of each solid, L being its largest dimension; the Laplacian is the
surface's own (Laplace-Beltrami). All meshes of a solid have about as many triangles as Star's raw one. Condition: of the matrix,
and after scaling by its diagonal. Iterations: of conjugate gradients until the residual is 1e-8 of the load, without and with that
scaling, for f = x y / L^2. Weights < 0: edges whose two opposite angles are more than 180 degrees together, where linear
elements lose the maximum principle. Gmsh (frontal Delaunay, sizes from curvature) is run by the Python given, and left out without it.
"""

import inspect
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import inside_freecad
import numpy as np

SOLIDS = ("bearing", "helix", "crank", "support")
CHORD_HEIGHT = 0.001  # of the largest dimension, of Star's raw mesh
ALIKE, TRIES = 0.03, 14
FRONTAL = 6  # Gmsh's number of that algorithm
RESIDUAL = 1e-8


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--python", default="/usr/bin/python3", help="that has the module gmsh")
    result.add_argument("--solids", nargs="+", default=SOLIDS, choices=SOLIDS)
    return result


def raw(shape, method, height):
    import MeshQuality as mq

    return mq.triangulate(shape, method=method, refine_samples=False, chord_height_relative=height)


def refined(shape, method, height):
    import MeshQuality as mq

    return mq.triangulate(shape, method=method, chord_height_relative=height)


def alike(make, setting, wanted, power):
    """The mesh (V, F) by `make(setting)` whose number of triangles comes closest to the wanted one.

    power: that of the setting with which the number grows, for the next guess.
    """
    best = None
    for _ in range(TRIES):
        mesh = make(setting)
        ratio = len(mesh[1]) / wanted
        if best is None or abs(np.log(ratio)) < abs(np.log(len(best[1]) / wanted)):
            best = mesh
        if abs(ratio - 1.0) < ALIKE:
            break
        setting *= ratio ** (-0.8 / power)
    return best


def arrays(mesh):
    return mesh.vertices + mesh.origin, mesh.triangles


def by_gmsh(shape, python, folder):
    import mesh_files

    model, off = folder / "model.brep", folder / "mesh.off"
    shape.exportBrep(str(model))

    def make(elements):
        done = subprocess.run([python, str(inside_freecad.ROOT / "benchmarks" / "triangulate" / "quality_gmsh.py"), str(model), str(off), str(FRONTAL),
                               str(elements)],
                              capture_output=True, text=True, env=inside_freecad.system_environment(), check=True)
        said = json.loads(done.stdout.strip().splitlines()[-1])
        if said["empty_faces"]:
            print(f"Gmsh left {said['empty_faces']} faces without triangles")
        return mesh_files.read(off)

    return make


def cotangents(corners):
    """(T, 3): of the angle at each corner."""
    result = np.empty(corners.shape[:2])
    for k in range(3):
        a, b = corners[:, (k + 1) % 3] - corners[:, k], corners[:, (k + 2) % 3] - corners[:, k]
        result[:, k] = np.einsum("ij,ij->i", a, b) / np.linalg.norm(np.cross(a, b), axis=1)
    return result


def matrices(vertices, triangles):
    """Stiffness and mass of linear triangles."""
    from scipy.sparse import csr_matrix

    corners = vertices[triangles]
    cot = cotangents(corners)
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    stiffness, mass = np.zeros((len(triangles), 3, 3)), np.zeros((len(triangles), 3, 3))
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        stiffness[:, i, j] = stiffness[:, j, i] = -cot[:, k] / 2
        stiffness[:, k, k] = (cot[:, i] + cot[:, j]) / 2
        mass[:, i, j] = mass[:, j, i] = areas / 12
        mass[:, k, k] = areas / 6
    rows = np.broadcast_to(triangles[:, :, None], stiffness.shape)
    columns = np.broadcast_to(triangles[:, None, :], stiffness.shape)
    place = (rows.ravel(), columns.ravel())
    return (csr_matrix((values.ravel(), place), shape=(len(vertices), len(vertices))) for values in (stiffness, mass))


def condition(matrix):
    from scipy.sparse.linalg import eigsh

    largest = eigsh(matrix, k=1, which="LM", return_eigenvectors=False, tol=1e-4)[0]
    least = eigsh(matrix.tocsc(), k=1, sigma=0.0, which="LM", return_eigenvectors=False, tol=1e-4)[0]
    return float(largest / least)


def iterations(matrix, load):
    from scipy.sparse.linalg import cg

    count = 0

    def count_one(_):
        nonlocal count
        count += 1

    residual = "rtol" if "rtol" in inspect.signature(cg).parameters else "tol"  # since SciPy 1.12, and before
    _, failed = cg(matrix, load, atol=0.0, maxiter=100_000, callback=count_one, **{residual: RESIDUAL})
    return None if failed else count


def measured(mesh, size):
    import render
    from scipy.sparse import diags

    used, numbers = np.unique(mesh[1], return_inverse=True)
    vertices, triangles = mesh[0][used], numbers.reshape(-1, 3)
    angles = render.smallest_angles(vertices, triangles)
    stiffness, mass = matrices(vertices, triangles)
    matrix = stiffness + mass / size**2
    scale = diags(1.0 / np.sqrt(matrix.diagonal()))
    scaled = scale @ matrix @ scale
    load = mass @ (vertices[:, 0] * vertices[:, 1] / size**2)
    above = stiffness.tocoo()
    edges = above.row < above.col
    return {"triangles": len(triangles), "vertices": len(vertices), "min_angle": float(angles.min()), "mean_min_angle": float(angles.mean()),
            "condition": condition(matrix), "condition_scaled": condition(scaled),
            "iterations": iterations(matrix, load), "iterations_scaled": iterations(scaled, scale @ load),
            "negative": float((above.data[edges] > 1e-9).mean())}


def text(name, row):
    return f"{name:<14} {row['triangles']:9,} {row['min_angle']:8.2f} {row['mean_min_angle']:5.1f} {row['condition']:11,.0f} " \
           f"{row['condition_scaled']:9,.0f} {row['iterations']:10} {row['iterations_scaled']:7} {100 * row['negative']:10.2f}"


def meshes(shape, arguments, folder):
    """(name, mesh) of each way, about as many triangles in each."""
    first = arrays(raw(shape, "star", CHORD_HEIGHT))
    wanted = len(first[1])
    yield "star, raw", first
    yield "sprinkle, raw", alike(lambda h: arrays(raw(shape, "sprinkle", h)), CHORD_HEIGHT, wanted, -1.0)
    for method in ("star", "sprinkle", "refine"):
        yield method, alike(lambda h, m=method: arrays(refined(shape, m, h)), CHORD_HEIGHT, wanted, -1.0)
    if arguments.gmsh:
        yield "Gmsh", alike(by_gmsh(shape, arguments.python, folder), 30.0, wanted, 2.0)


def work(arguments):
    sys.path.append(str(inside_freecad.ROOT / "tools"))
    import parts

    arguments.gmsh = inside_freecad.has_module(arguments.python, "gmsh")
    if not arguments.gmsh:
        print(f"Gmsh is skipped: {arguments.python} has no module gmsh (package python3-gmsh)")
    found = {}
    for name in arguments.solids:
        shape = parts.ALL[name]()
        box = shape.BoundBox
        size = max(box.XLength, box.YLength, box.ZLength)
        print(f"\n{name:<14} {'':9} {'angle':>8} {'':5} {'condition':>11} {'':9} {'iterations':>10} {'':7} {'weights':>10}\n"
              f"{'':<14} {'triangles':>9} {'smallest':>8} {'mean':>5} {'as it is':>11} {'scaled':>9} {'as it is':>10} "
              f"{'scaled':>7} {'< 0 %':>10}")
        rows = found[name] = {}
        with tempfile.TemporaryDirectory() as folder:
            for way, mesh in meshes(shape, arguments, Path(folder)):
                rows[way] = measured(mesh, size)
                print(text(way, rows[way]), flush=True)
    return {"solids": found}


inside_freecad.start(__file__, parser(), work)
