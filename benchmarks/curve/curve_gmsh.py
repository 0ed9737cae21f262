# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves one solid with Gmsh, for curve_peers.py: a Python that has the module gmsh runs it.

    curve_gmsh.py MODEL.brep FOLDER ORDER SECONDS TETRAHEDRA

One straight mesh is made, the coarsest that Gmsh makes or, if TETRAHEDRA is not 0, one of about so
many; from it one process writes FOLDER/plain.msh, curved only, and one
FOLDER/repaired.msh, after the elastic analogy and the high-order optimisation. What each took is
printed as JSON, in seconds of the processor; a process gets SECONDS.
"""

import json
import os
import resource
import sys
from pathlib import Path

import gmsh
sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
from child import in_child

# Of the diagonal. Gmsh 4.8 makes no coarser mesh when it is asked to.
SIZE = 0.1
TRIES, NEAR = 6, 0.1
STEPS = {"plain": [], "repaired": ["HighOrderElastic", "HighOrder"]}


def cpu():
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def load(path):
    """The size of the coarsest mesh."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.model.occ.importShapes(path)
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.MinimumCirclePoints", 4)
    gmsh.option.setNumber("Mesh.SaveAll", 1)
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    box = gmsh.model.getBoundingBox(-1, -1)
    return SIZE * sum((box[i + 3] - box[i]) ** 2 for i in range(3)) ** 0.5


def straight_mesh(size):
    """Seconds, and tetrahedra."""
    gmsh.model.mesh.clear()
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    start = cpu()
    gmsh.model.mesh.generate(3)
    return cpu() - start, sum(len(tags) for tags in gmsh.model.mesh.getElements(3)[1])


def mesh_of(size, wanted):
    """Seconds of the straight mesh that is kept."""
    seconds, count = straight_mesh(size)
    for _ in range(TRIES):
        if not wanted or abs(count - wanted) <= NEAR * wanted:
            break
        size *= (count / wanted) ** (1 / 3)
        seconds, count = straight_mesh(size)
    return seconds


def curve(order, steps, path):
    start = cpu()
    gmsh.model.mesh.setOrder(order)
    said = ""
    for step in steps:
        try:
            gmsh.model.mesh.optimize(step)
        except Exception as error:  # the mesh is still there, and is judged
            said = str(error)
    seconds = cpu() - start
    gmsh.write(path)
    return {"seconds": seconds, "said": said}


def main():
    path, folder, order, limit = sys.argv[1], sys.argv[2], int(sys.argv[3]), float(sys.argv[4])
    straight = mesh_of(load(path), int(sys.argv[5]))
    result = {"version": gmsh.GMSH_API_VERSION, "straight": straight}
    for name, steps in STEPS.items():
        target = os.path.join(folder, f"{name}.msh")
        result[name] = in_child(lambda s=steps, t=target: curve(order, s, t), limit)
    print(json.dumps(result), flush=True)
    os._exit(0)


if __name__ == "__main__":
    main()
