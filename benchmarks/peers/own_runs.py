# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of MeshQuality, or of OpenCASCADE through FreeCAD, for peers.py: done by a copy of its process."""

import numpy as np

from boolean_peers import read_off, write_off
from peer_runs import DIGITS, Watch, write_curved, write_filling


def shape_of(path):
    import Part

    shape = Part.Shape()
    shape.importBrep(str(path))
    return shape


def surface(job):
    import MeshQuality as mq

    shape, triangulate = shape_of(job["input"]), mq.triangulate  # which loads its module
    watch = Watch()
    mesh = triangulate(shape, min_angle=25.0, chord_height=job["setting"])
    said = watch.read()
    mesh.write(job["out"])  # vertices alone are about an origin
    return said


def brep_mesh(job):
    """Its angular limit is opened, so that only the distance counts, which makes the fewest triangles."""
    import MeshPart

    shape = shape_of(job["input"])
    watch = Watch()
    mesh = MeshPart.meshFromShape(Shape=shape, LinearDeflection=job["setting"], AngularDeflection=1.5, Relative=False)
    said = watch.read()
    points, triangles = mesh.Topology
    write_off(job["out"], np.array([tuple(point) for point in points]), np.array(triangles), DIGITS)
    return said


def boolean(job):
    import MeshQuality as mq

    (a, b), join = map(read_off, job["input"]), mq.boolean
    watch = Watch()
    mesh = join(a, b, job["operation"])
    said = watch.read()
    mesh.write(job["out"])  # vertices alone are about an origin
    return said


def simplify(job):
    import MeshQuality as mq

    mesh, reduce = read_off(job["input"]), mq.simplify
    watch = Watch()
    made = reduce(mesh, tolerance=job["setting"])
    said = watch.read()
    made.write(job["out"])
    return said


def fill(job):
    from MeshQuality.compat import extension

    points, triangles = read_off(job["input"])
    watch = Watch()
    added, tetrahedra = extension().fill_surface(points, triangles, 1.0, None)
    said = watch.read()
    write_filling(job["out"], np.concatenate([points, added.reshape(-1, 3)]), tetrahedra.reshape(-1, 4))
    return said


def offset(job):
    import MeshQuality as mq

    mesh, grow = read_off(job["input"]), mq.offset
    watch = Watch()
    made = grow(mesh, job["distance"], tolerance=job["setting"])
    said = watch.read()
    made.write(job["out"])
    return said


def occ_offset(job):
    """Of the shape, with rounded joins; its triangles are no part of the time."""
    shape = shape_of(job["shape"])
    watch = Watch()
    made = shape.makeOffsetShape(job["distance"], 1e-3 * abs(job["distance"]), join=0)
    said = watch.read()
    if not made.isValid() or not made.Solids or made.Volume <= 0.0:
        raise ValueError("no valid solid")
    points, triangles = made.tessellate(0.3 * job["target"])
    write_off(job["out"], np.array([tuple(point) for point in points]), np.array(triangles), DIGITS)
    return said


def wrap(job):
    import MeshQuality as mq

    mesh, around = read_off(job["input"]), mq.wrap
    watch = Watch()
    made = around(mesh, job["gap"], job["setting"])
    said = watch.read()
    made.write(job["out"])
    return said


def curve(job):
    """At its defaults, with tetrahedra."""
    import MeshQuality as mq

    shape, bend = shape_of(job["shape"]), mq.curve
    watch = Watch()
    made = bend(shape, order=2, volume=True)
    said = watch.read()
    write_curved(job["out"], np.asarray(made.nodes), np.asarray(made.tetrahedra), np.asarray(made.triangles))
    return said


def improve(job):
    import MeshQuality as mq

    mesh, better = read_off(job["input"]), mq.improve
    watch = Watch()
    made = better(mesh, min_angle=25.0, tolerance=job["setting"])
    said = watch.read()
    made.write(job["out"])
    return said


RUNS = {"surface": {"MeshQuality": surface, "BRepMesh": brep_mesh}, "public": {"MeshQuality": surface, "BRepMesh": brep_mesh},
        "boolean": {"MeshQuality": boolean},
        "simplify": {"MeshQuality": simplify}, "fill": {"MeshQuality": fill},
        "offset": {"MeshQuality": offset, "OpenCASCADE": occ_offset}, "wrap": {"MeshQuality": wrap}, "curving": {"MeshQuality": curve},
        "improve": {"MeshQuality": improve}}


def run(job):
    """What a run says; an error of it is its result."""
    from MeshQuality.compat import extension

    extension()  # loading it is no part of the run
    try:
        return RUNS[job["task"]][job["mesher"]](job)
    except Exception as error:  # whatever it raises is the row's result
        return {"failed": f"error: {error}"}
