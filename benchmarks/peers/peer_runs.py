# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of one rival, for peers.py: the Python of the scratch environment runs it, in a process of its own.

    peer_runs.py '{"task": "surface", "mesher": "Gmsh 5", "setting": 20, "input": "part.brep", "out": "mesh.off"}'

Prints the seconds of the processor and of the clock that the call took, conversions included and files not, as JSON.
"""

import json
import os
import sys
import time
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[1] / "boolean"))
from boolean_peers import read_off, write_off

DIGITS = 17  # bring every double back


class Watch:
    """Seconds of the processor and of the clock since it was made."""

    def __init__(self):
        self.cpu, self.clock = time.process_time(), time.perf_counter()

    def read(self):
        return {"seconds": time.process_time() - self.cpu, "wall": time.perf_counter() - self.clock}


def gmsh_started():
    import gmsh

    gmsh.initialize(["gmsh"])
    # An error would end the process otherwise, however many faces it has meshed.
    for name, value in (("General.Terminal", 0), ("General.NumThreads", 1), ("General.AbortOnError", 0)):
        gmsh.option.setNumber(name, value)
    gmsh.model.add("part")
    return gmsh


def gmsh_elements(gmsh, kind, corners):
    """(points, elements as rows of them) of all elements of a kind."""
    tags, points, _ = gmsh.model.mesh.getNodes()
    index = np.zeros(int(tags.max()) + 1, np.int64)
    index[tags] = np.arange(len(tags))
    _, nodes = gmsh.model.mesh.getElementsByType(kind)
    return points.reshape(-1, 3), index[nodes].reshape(-1, corners)


def gmsh_surface(job, algorithm):
    """Sizes from the curvature, which is Gmsh's own way to keep a distance; `setting` is elements on a full turn."""
    gmsh = gmsh_started()
    gmsh.option.setNumber("Mesh.Algorithm", algorithm)
    gmsh.option.setNumber("Mesh.MeshSizeFromCurvature", job["setting"])
    gmsh.model.occ.importShapes(job["input"])
    gmsh.model.occ.synchronize()
    watch = Watch()
    gmsh.model.mesh.generate(2)
    said = watch.read()
    write_off(job["out"], *gmsh_elements(gmsh, 2, 3), DIGITS)
    return said


def netgen_surface(job):
    """`setting` is its safety of curvature: elements on a radius."""
    from netgen.meshing import MeshingStep
    from netgen.occ import OCCGeometry

    shape = OCCGeometry(job["input"])
    watch = Watch()
    mesh = shape.GenerateMesh(curvaturesafety=job["setting"], segmentsperedge=0.5, grading=0.5,
                              perfstepsend=MeshingStep.MESHSURFACE)
    said = watch.read()
    points = np.array([point.p for point in mesh.Points()])
    write_off(job["out"], points, np.array([[v.nr - 1 for v in face.vertices] for face in mesh.Elements2D()]), DIGITS)
    return said


def manifold_of(mesh):
    import manifold3d

    points, triangles = mesh
    made = manifold3d.Manifold(manifold3d.Mesh64(np.ascontiguousarray(points), triangles.astype(np.uint64)))
    if made.status() != manifold3d.Error.NoError:
        raise ValueError(f"no operand: {made.status().name}")
    return made


def manifold_boolean(job):
    a, b = map(read_off, job["input"])
    watch = Watch()
    a, b = manifold_of(a), manifold_of(b)
    made = {"union": a + b, "intersection": a ^ b, "difference": a - b}[job["operation"]].to_mesh64()
    points, triangles = np.asarray(made.vert_properties)[:, :3], np.asarray(made.tri_verts)
    said = watch.read()
    write_off(job["out"], points, triangles, DIGITS)
    return said


def meshlib_of(mesh):
    from meshlib import mrmeshnumpy

    return mrmeshnumpy.meshFromFacesVerts(mesh[1].astype(np.int32), mesh[0])


def write_meshlib(path, mesh):
    from meshlib import mrmeshnumpy

    mesh.pack()
    write_off(path, mrmeshnumpy.getNumpyVerts(mesh), mrmeshnumpy.getNumpyFaces(mesh.topology), DIGITS)


def meshlib_boolean(job):
    from meshlib import mrmeshpy

    operation = {"union": mrmeshpy.BooleanOperation.Union, "intersection": mrmeshpy.BooleanOperation.Intersection,
                 "difference": mrmeshpy.BooleanOperation.DifferenceAB}[job["operation"]]
    a, b = map(read_off, job["input"])
    watch = Watch()
    made = mrmeshpy.boolean(meshlib_of(a), meshlib_of(b), operation)
    said = watch.read()
    if not made.valid():
        raise ValueError(made.errorString)
    write_meshlib(job["out"], made.mesh)
    return said


def pymeshlab_set(*meshes):
    import pymeshlab

    made = pymeshlab.MeshSet(verbose=False)
    for points, triangles in meshes:
        made.add_mesh(pymeshlab.Mesh(points, triangles))
    return made


def write_pymeshlab(path, made):
    mesh = made.current_mesh()
    write_off(path, mesh.vertex_matrix(), mesh.face_matrix(), DIGITS)


def pymeshlab_boolean(job):
    """Exact, by libigl."""
    operands = [read_off(path) for path in job["input"]]
    watch = Watch()
    made = pymeshlab_set(*operands)
    getattr(made, f"generate_boolean_{job['operation']}")(first_mesh=0, second_mesh=1)
    said = watch.read()
    write_pymeshlab(job["out"], made)
    return said


def pymeshlab_simplify(job):
    """Quadrics with its options for shape and topology; `setting` is the fraction of the triangles that are left."""
    mesh = read_off(job["input"])
    watch = Watch()
    made = pymeshlab_set(mesh)
    made.meshing_decimation_quadric_edge_collapse(
        targetperc=job["setting"], qualitythr=0.3, preserveboundary=True, preservenormal=True, preservetopology=True,
        optimalplacement=True, planarquadric=True)
    said = watch.read()
    write_pymeshlab(job["out"], made)
    return said


def meshlib_simplify(job):
    """`setting` is its largest error, mm."""
    from meshlib import mrmeshpy

    mesh = read_off(job["input"])
    watch = Watch()
    made = meshlib_of(mesh)
    settings = mrmeshpy.DecimateSettings()
    settings.maxError = job["setting"]
    mrmeshpy.decimateMesh(made, settings)
    said = watch.read()
    write_meshlib(job["out"], made)
    return said


def manifold_simplify(job):
    """`setting` is its tolerance, mm."""
    mesh = read_off(job["input"])
    watch = Watch()
    made = manifold_of(mesh).simplify(job["setting"]).to_mesh64()
    said = watch.read()
    write_off(job["out"], np.asarray(made.vert_properties)[:, :3], np.asarray(made.tri_verts), DIGITS)
    return said


def mmg_simplify(job):
    """Mmg's remesher of surfaces, which may coarsen as far as `setting`, its distance of Hausdorff in mm, allows."""
    import mmgpy

    points, triangles = read_off(job["input"])
    watch = Watch()
    mesh = mmgpy.MmgMeshS(points, triangles)
    mesh.remesh(hausd=job["setting"], hgrad=-1.0, verbose=-1)
    said = watch.read()
    write_off(job["out"], np.asarray(mesh.get_vertices()), np.asarray(mesh.get_triangles()), DIGITS)
    return said


def write_filling(path, points, tetrahedra):
    np.savez(path, points=points, tetrahedra=np.asarray(tetrahedra)[:, :4])


def gmsh_fill(job, algorithm):
    """With the optimisation that it has by default, and Netgen's after it."""
    points, triangles = read_off(job["input"])
    gmsh = gmsh_started()
    gmsh.option.setNumber("Mesh.Algorithm3D", algorithm)
    gmsh.option.setNumber("Mesh.OptimizeNetgen", 1)
    surface = gmsh.model.addDiscreteEntity(2)
    gmsh.model.mesh.addNodes(2, surface, np.arange(1, len(points) + 1), points.ravel())
    gmsh.model.mesh.addElementsByType(surface, 2, np.arange(1, len(triangles) + 1), triangles.ravel() + 1)
    gmsh.model.geo.addVolume([gmsh.model.geo.addSurfaceLoop([surface])])
    gmsh.model.geo.synchronize()
    watch = Watch()
    gmsh.model.mesh.generate(3)
    said = watch.read()
    write_filling(job["out"], *gmsh_elements(gmsh, 4, 4))
    return said


def netgen_fill(job):
    from netgen import meshing

    points, triangles = read_off(job["input"])
    mesh = meshing.Mesh()
    face = mesh.Add(meshing.FaceDescriptor(surfnr=1, domin=1, bc=1))
    watch = Watch()
    rows = [mesh.Add(meshing.MeshPoint(meshing.Pnt(*point))) for point in points.tolist()]
    for corners in triangles.tolist():
        mesh.Add(meshing.Element2D(face, [rows[k] for k in corners]))
    mesh.GenerateVolumeMesh(maxh=1e6)
    said = watch.read()
    write_filling(job["out"], np.array([point.p for point in mesh.Points()]),
                  np.array([[v.nr - 1 for v in element.vertices] for element in mesh.Elements3D()]).reshape(-1, 4))
    return said


def tetgen_fill(job):
    """The border stays; radius to edge 1.2 and dihedral angles of 10 degrees are aimed at, and all its optimisation."""
    import tetgen

    mesh = read_off(job["input"])
    watch = Watch()
    made = tetgen.TetGen(*mesh)
    made.tetrahedralize(plc=True, quality=True, nobisect=True, minratio=1.2, mindihedral=10.0, opt_max_flip_level=10, opt_iterations=10)
    said = watch.read()
    write_filling(job["out"], np.asarray(made.node), np.asarray(made.elem))
    return said


def tetwild_fill(job):
    """It remeshes the border within its own tolerance."""
    import pytetwild

    mesh = read_off(job["input"])
    watch = Watch()
    points, tetrahedra = pytetwild.tetrahedralize(*mesh, num_threads=1, quiet=True)[:2]
    said = watch.read()
    write_filling(job["out"], points, tetrahedra)
    return said


RUNS = {
    "surface": {"Gmsh 5": lambda job: gmsh_surface(job, 5), "Gmsh 6": lambda job: gmsh_surface(job, 6), "Netgen": netgen_surface},
    "boolean": {"Manifold": manifold_boolean, "MeshLib": meshlib_boolean, "PyMeshLab": pymeshlab_boolean},
    "simplify": {"PyMeshLab": pymeshlab_simplify, "MeshLib": meshlib_simplify, "Manifold": manifold_simplify, "Mmg": mmg_simplify},
    "fill": {"Gmsh": lambda job: gmsh_fill(job, 1), "Gmsh HXT": lambda job: gmsh_fill(job, 10), "Netgen": netgen_fill,
             "TetGen": tetgen_fill, "fTetWild": tetwild_fill},
}


def main():
    job = json.loads(sys.argv[1])
    os.chdir(Path(job["out"]).parent)  # fTetWild leaves files where it is
    try:
        said = RUNS[job["task"]][job["mesher"]](job)
    except Exception as error:  # whatever it raises is the row's result
        said = {"failed": f"error: {str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__}"}
    print("\n" + json.dumps(said), flush=True)
    os._exit(0)  # some crash while they tidy up


if __name__ == "__main__":
    main()
