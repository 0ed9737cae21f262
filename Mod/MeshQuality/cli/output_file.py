# SPDX-License-Identifier: LGPL-2.1-or-later
"""The file that a job writes its mesh to."""

import os

import MeshQuality as mq
from MeshQuality import files
from MeshQuality.cli.input_files import patches_in
from MeshQuality.cli.parser import SOLID_SUFFIXES
from MeshQuality.formats import CURVED_SUFFIXES


def written(job, write):
    """Has `write` write the mesh to a path, if asked for; says where, for the sentence to end with.

    A file that is there is replaced once the mesh is written in whole; so is each file in a folder.
    """
    path = job.get("output")
    if not path:
        return ""
    path = os.path.realpath(path)
    if not job["suffix"]:
        write(path)
        return f" in {path}"
    ready = job["ready"]
    if (os.path.exists(path) and not os.path.isfile(path)) or not files.freecad_takes(ready):
        # Not beside a pipe or a device; nor where FreeCAD cannot write.
        ready = os.path.join(job["scratch"], "mesh" + job["suffix"])
    try:
        write(ready)
        files.put_in_place(ready, path)
    except (mq.IoError, OSError) as error:
        # Asked while what was written still takes the room.
        if (isinstance(error, OSError) and files.is_full(error)) or files.disk_is_full(ready):
            raise files.DiskFull(f"'{path}' cannot be written: the disk is full") from error
        raise mq.IoError(str(error).replace(ready, path)) from error
    finally:
        files.remove_if_there(ready)
    return f" in {path}"


def write_solid_mesh(job, mesh):
    """Writes a mesh that may know the CAD it was made of: as a solid into STEP, else by `written`; says where, and what the solid has."""
    if job["suffix"] not in SOLID_SUFFIXES or not job.get("output"):
        return written(job, lambda path: mesh.write(path, format=job["suffix"][1:]))
    solid = mq.to_solid(mesh)
    faces = f"{solid.faces} exact faces" if solid.faces else f"{solid.facets} facets, as {solid.notes[0]}"
    return f"{written(job, solid.write)}, a solid of {faces}"


def write_curved(mesh, path, deviation, **how):
    """Writes a CurvedMesh: its elements, or flat triangles, by format."""
    if f".{how['format']}" not in CURVED_SUFFIXES:
        mesh = mq.SurfaceMesh(mesh.tessellate(deviation).surface())
    mesh.write(path, **how)


def writing_of(job, shape, objects):
    """What `write` of a mesh takes of the job: format, patches and so on."""
    how = {**job.get("writing", {}), "format": (job.get("suffix") or ".")[1:]}
    if "patches" in how:
        how["patches"] = patches_in(shape, objects, job["input"], how["patches"])
    return how


def patches_of(how):
    """Those of them that the work on the shape takes, too, so that faults are found before."""
    return {name: how[name] for name in ("patches", "patch_rest") if name in how}
