# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line inside FreeCAD: does the job of the file named by MESHQUALITY_JOB."""

import json
import math
import os
import sys
import time
import traceback

import FreeCAD

import MeshQuality as mq
from MeshQuality import files, limits
from MeshQuality.cli.exit_status import DONE, FAILED, USAGE
from MeshQuality.cli.parser import MESH_SUFFIXES
from MeshQuality.compat import extension
from MeshQuality.core.sources import convert
from MeshQuality.core.sources import hidden_parts
from MeshQuality.core.certify import verdict
from MeshQuality.formats import CURVED_SUFFIXES
from MeshQuality.phrases import Text, upper_first

_STAGE = 39  # characters, in a line of 80
_GRACE = 30  # seconds beyond the limit, after which it ends without its owner

_left_out = []  # sentences about what is hidden in the containers that the present job has read
# The verdict without findings; some commands have no options that request anything.
_ALL_MET = "all requested limits are met"
_NO_FINDING = {**dict.fromkeys(("quality", "certify"), "no limits were requested, and no faults were found"),
               "voids": "there are none",
               "verify": "all of it holds"}

# Fields of reports for Python only.
_NOT_WRITTEN = {"exempt_reasons", "spanning", "max_chord_triangle", "max_chord_point", "detail", "sewn", "imprinted", "reused_faces",
                "holes_filled"}
WRAP_FIELDS = ("distance_to_input", "distance_from_input", "gap_triangles", "gap_area")  # fields of the mesh itself


def report_fields(report):
    """A report as plain values for JSON; numbers that JSON has no word for become null."""
    if hasattr(report, "to_dict"):
        return _plain(report.to_dict())
    names = [name for cls in reversed(type(report).__mro__) for name, value in vars(cls).items() if isinstance(value, property)]
    fields = {name: getattr(report, name) for name in names if name not in _NOT_WRITTEN}
    if fields.get("box"):
        fields["box"] = [corner.tolist() for corner in report.box]
    if "straight" in fields:
        fields["straight"] = report_fields(report.straight)
    return _plain(fields)


def _plain(fields):
    return {name: None if isinstance(value, float) and not math.isfinite(value) else value
            for name, value in fields.items()}


def read_shape(path, name=None):
    """The shape of a CAD file; of an FCStd file that of one object, or of all final ones."""
    return read_shape_and_objects(path, name)[0]


def read_shape_and_objects(path, name=None):
    """(the shape as read_shape returns it, the objects of an FCStd file that make it up; [] for others)."""
    if not path.lower().endswith(".fcstd"):
        return _read_file(path, name), []
    objects = _read_objects(path, name)
    return _shape_of_objects(objects), objects


def _shape_of_objects(objects):
    import Part

    shapes = [convert.shape_of(obj) for obj in objects]
    return shapes[0] if len(shapes) == 1 else Part.makeCompound(shapes)


def read_operand(path, name=None):
    """What a Boolean takes of a file: a mesh, a shape, or the object of an FCStd file, with the meshes in it."""
    if path.lower().endswith(MESH_SUFFIXES):
        return read_mesh(path)
    if not path.lower().endswith(".fcstd"):
        return _read_file(path, name)
    objects = _read_objects(path, name, with_meshes=True)
    holding = [obj for obj in objects if convert.meshes_in(obj)]
    if len(objects) > 1 and holding:
        raise mq.InvalidInput(f"'{path}' has {len(objects)} objects with shapes, and {convert.label_of(holding[0])} holds "
                              "meshes, too: choose one object by --object")
    return objects[0] if len(objects) == 1 else _shape_of_objects(objects)


def _one_line(error):
    """What an error of FreeCAD says: some have ends of lines in them."""
    return " ".join(str(error).split())


def _read_file(path, name):
    import Part

    if name:
        raise mq.InvalidInput(f"--object is for FCStd files, not for '{path}'")
    try:
        shape = Part.read(path)
    except Exception as error:  # noqa: BLE001 - FreeCAD raises many types, some of them its own
        raise mq.InvalidInput(f"cannot read '{path}': {_one_line(error)}") from error
    if shape.isNull():
        raise mq.InvalidInput(f"cannot read '{path}': it holds no shape")
    return shape


def _read_objects(path, name, with_meshes=False):
    """The object of this name or label in an FCStd file, or all final ones; `_left_out` tells of what is hidden in them,
    meshes too where these count.
    """
    found = _objects_in(path, name)
    for obj in found:
        _left_out.extend(hidden_parts.sentences_of(obj, with_meshes))
    return found


def _objects_in(path, name):
    try:
        document = FreeCAD.openDocument(path)
    except Exception as error:  # noqa: BLE001
        raise mq.InvalidInput(f"cannot read '{path}': {_one_line(error)}") from error
    if name:
        found = [o for o in document.Objects if name in (o.Name, o.Label)][:1]
        if not found:
            raise mq.InvalidInput(f"'{path}' has no object named '{name}'")
        return found
    found = final_objects(document)
    if not found:
        raise mq.InvalidInput(f"'{path}' has no object with faces")
    return found


def final_objects(document):
    """Those objects with faces that no other object with faces is made of or holds.

    Meshes, drawings and analyses that refer to an object do not count.
    """
    import Part

    shaped = []
    for obj in document.Objects:
        shape = Part.getShape(obj)
        if not shape.isNull() and shape.Faces and not obj.isDerivedFrom("App::OriginFeature"):
            shaped.append(obj)
    return [obj for obj in shaped if not any(user in shaped for user in obj.InListRecursive)]


def sizes_in(shape, objects, path, sizes):
    """Local sizes by the sub-elements of the shape that objects of a file make up.

    A name may begin with that of one of the objects, as if the file was a container, and goes on with the path
    from there as in Python: "Box.Face6", "Part.Box.Face6". With one object it may begin below that, too.
    """
    found = {}
    for name, size in (sizes or {}).items():
        plain = _name_in_file(shape, objects, path, name, "local_sizes names") if "." in name else name
        found[plain] = min(size, found.get(plain, size))
    return found or None


def patches_in(shape, objects, path, patches):
    """Patches by the sub-elements of that shape: {name: faces}, or {name: {"faces": faces, ...}}. Values of another form
    are left as they are, to be refused later.
    """
    def plain(name, face):
        return _name_in_file(shape, objects, path, face, f"patch {name!r} names") \
            if isinstance(face, str) and "." in face else face

    found = {}
    for name, said in (patches or {}).items():
        faces = said.get("faces") if isinstance(said, dict) else said
        if isinstance(faces, list):
            faces = [plain(name, face) for face in faces]
            said = {**said, "faces": faces} if isinstance(said, dict) else faces
        found[name] = said
    return found if patches is not None else None


def _name_in_file(shape, objects, path, name, said):
    if not objects:
        element = name.rpartition(".")[2]
        raise mq.InvalidInput(f"{said} {name}, but '{path}' has no objects with names, as FCStd files have: "
                              f"name the sub-element of the whole shape, such as {element}")
    first, rest = name.split(".", 1)
    owners = [obj for obj in objects if obj.Name == first] or [obj for obj in objects if obj.Label == first]
    if owners:
        plain = next(iter(convert.resolve_sizes(owners[0], {rest: 1.0})))
        return convert.name_in(shape, _element(owners[0], plain, f"{said} {name}"))
    if len(objects) == 1:
        return next(iter(convert.resolve_sizes(objects[0], {name: 1.0})))
    raise mq.InvalidInput(f"{said} {name}, but '{path}' has no '{first}' among the objects that are meshed: "
                          f"begin with one of {', '.join(obj.Name for obj in objects)}")


def _element(obj, plain, said):
    shape = convert.shape_of(obj)
    try:
        return shape.getElement(plain)
    except Exception as error:  # noqa: BLE001 - FreeCAD raises many types, some of them its own
        raise mq.InvalidInput(f"{said}, but {convert.label_of(obj)} has no {plain}") from error


def read_mesh(path):
    """The Mesh.Mesh of a mesh file."""
    import Mesh

    try:
        mesh = Mesh.Mesh(path)
    except Exception as error:  # noqa: BLE001
        raise mq.InvalidInput(f"cannot read '{path}': {_one_line(error)}") from error
    if mesh.CountFacets == 0:
        raise mq.InvalidInput(f"cannot read '{path}': it holds no triangles")
    return mesh


def _is_shown():
    """Whether stderr, which the caller hands on, ends at a terminal."""
    return os.environ.get("MESHQUALITY_TERMINAL") == "1"


def progress_line():
    """A progress callback: a line for people at a terminal, and the end when the caller is gone."""
    visible, parent = _is_shown(), os.getppid()
    last = [0.0]

    def show(fraction, stage):
        if os.getppid() != parent:
            return False
        now = time.monotonic()
        if visible and now - last[0] > 0.2:
            last[0] = now
            done = int(30 * fraction)
            print(f"\r[{'#' * done:<30}] {100 * fraction:3.0f} %  {stage:<{_STAGE}.{_STAGE}}", end="",
                  file=sys.stderr, flush=True)
        return True

    return show


def end_progress_line():
    """Takes the progress line away."""
    if _is_shown():
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)


def written(job, write):
    """Has `write` write the mesh to the path of the job, if it has one; returns the end of a
    sentence that says where.

    A file that is there is replaced once the mesh is written in whole.
    """
    path = job.get("output")
    if not path:
        return ""
    path = os.path.realpath(path)
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


def write_curved(mesh, path, deviation, **how):
    """Writes a CurvedMesh: its elements, or flat triangles, by format."""
    if f".{how['format']}" not in CURVED_SUFFIXES:
        mesh = mq.SurfaceMesh(mesh.tessellate(deviation).surface())
    mesh.write(path, **how)


def writing_of(job, shape, objects):
    """The arguments of a mesh's `write` in the job: format, patches and so on."""
    how = {**job.get("writing", {}), "format": (job.get("suffix") or ".")[1:]}
    if "patches" in how:
        how["patches"] = patches_in(shape, objects, job["input"], how["patches"])
    return how


def patches_of(how):
    """The arguments of writing that the work on the shape takes, too, so that faults are found before."""
    return {name: how[name] for name in ("patches", "patch_rest") if name in how}


def _count(number, noun):
    return f"{number} {noun}{'' if number == 1 else 's'}"


def triangulate(job):
    """Returns the report, what the command did, and the findings."""
    shape, objects = read_shape_and_objects(job["input"], job.get("object"))
    values = {**job["options"],
              "local_sizes": sizes_in(shape, objects, job["input"], job["options"].get("local_sizes"))}
    how = writing_of(job, shape, objects)
    mesh = mq.triangulate(shape, **values, **patches_of(how), progress=progress_line())
    report, where = mesh.report, written(job, lambda path: mesh.write(path, **how))
    return report, _count(report.triangles, "triangle") + where, \
        verdict.of_triangulation(mesh, verdict.must_be_closed(shape), values, shape)


def curve(job):
    """Likewise."""
    shape, objects = read_shape_and_objects(job["input"], job.get("object"))
    how = writing_of(job, shape, objects)
    mesh = mq.curve(shape, **job["options"], **patches_of(how), mesh=job.get("mesh"), mesh_scale=job.get("mesh_scale", 1.0),
                    progress=progress_line())
    report = mesh.report
    if isinstance(mesh, mq.CurvedElementMesh):
        where = written(job, lambda path: mesh.write(path, scale=how.get("scale", 1.0)))
        return report, f"{_count(report.elements, 'element')} of order {mesh.order}{where}", verdict.of_curved_elements(mesh)
    where = written(job, lambda path: write_curved(mesh, path, job.get("deviation"), **how))
    return report, f"{_count(report.elements, 'element')} of order {mesh.order}{where}", \
        verdict.of_curved(mesh, verdict.must_be_closed(shape), job["options"], shape=shape)


def boolean(job):
    """Likewise."""
    sources = [read_operand(path, job.get("object")) for path in job["inputs"]]
    mesh = mq.boolean(sources, **job["options"], progress=progress_line())
    report, where = mesh.report, written(job, lambda path: mesh.write(path, format=job["suffix"][1:]))
    return report, f"{_count(report.triangles, 'triangle')}{where}, {report.retained} of them unchanged from the " \
                   "operands", verdict.of_boolean(mesh)


def offset(job):
    """Likewise."""
    return _offset_written(job, mq.offset(read_operand(job["input"], job.get("object")), **job["options"],
                                          progress=progress_line()))


def hollow(job):
    """Likewise."""
    return _offset_written(job, mq.hollow(read_operand(job["input"], job.get("object")), **job["options"],
                                          openings=job.get("openings"), progress=progress_line()))


def wrap(job):
    """As triangulate(), with values that the report of a Boolean lacks. A leak to a place that is to stay dry is a finding."""
    sources = [read_operand(path, job.get("object")) for path in job["inputs"]]
    mesh = mq.wrap(sources, **job["options"], dry=job.get("dry"), progress=progress_line())
    report, told, findings = _offset_written(job, mesh)
    return report, f"{told}, {mesh.gap_triangles} of them close gaps", \
        [*findings, *(verdict.Finding(str(leak)) for leak in mesh.leaks)], \
        {**_plain({name: getattr(mesh, name) for name in WRAP_FIELDS}), "leaks": [leak.to_dict() for leak in mesh.leaks]}


def _offset_written(job, mesh):
    report, where = mesh.report, written(job, lambda path: mesh.write(path, format=job["suffix"][1:]))
    return report, f"{_count(report.triangles, 'triangle')}{where}", verdict.of_boolean(mesh)


def improve(job):
    """As triangulate(); the mesh must be closed if the given one is."""
    given = mesh_of(read_mesh(job["input"]))
    mesh = mq.improve(given, **job["options"], progress=progress_line())
    report, where = mesh.report, written(job, lambda path: mesh.write(path, format=job["suffix"][1:]))
    return report, _count(report.triangles, "triangle") + where, \
        verdict.of_improvement(mesh, given.report.closed)


def mesh_of(mesh):
    """The SurfaceMesh of a Mesh.Mesh."""
    return mq.SurfaceMesh(convert.surface_of_arrays(extension(), *convert.arrays_of_mesh(mesh)))


def quality(job):
    """As triangulate(); a mesh must be watertight unless its shape is not."""
    mesh = mesh_of(read_mesh(job["input"]))
    shape = read_shape(job["shape"], job.get("object")) if job.get("shape") else None
    report = mq.quality(mesh, shape, progress_line())
    return report, f"measured {_count(report.triangles, 'triangle')} of {job['input']}", \
        verdict.of_measured(mesh, report, shape is None or verdict.must_be_closed(shape))


def certify(job):
    """Likewise."""
    shape = read_shape(job["shape"], job.get("object")) if job.get("shape") else None
    certificate = mq.certify(job["input"], shape, progress_line(), job["mesh_scale"])
    where = ""
    if job.get("save"):
        certificate.save(job["save"], cad=job.get("shape"))
        where = f" in {job['save']}"
    return certificate, f"certified {_count(sum(certificate.elements.values()), 'element')} of {job['input']}{where}", \
        verdict.of_certificate(certificate)


def thickness(job):
    """Likewise."""
    found = mq.thickness(read_operand(job["input"], job.get("object")), **job["options"], progress=progress_line())
    where = ""
    if job.get("csv"):
        found.write_csv(job["csv"])
        where = f", written to {job['csv']}"
    return found, f"measured {_count(len(found.values), 'triangle')}{where}", verdict.of_thickness(found)


def clearance(job):
    """Likewise."""
    bodies = [read_operand(path, job.get("object")) for path in job["inputs"]]
    if len(bodies) > 1:
        names = [os.path.basename(path) for path in job["inputs"]]
        bodies = {name if names.count(name) == 1 else f"{name} ({i + 1})": body
                  for i, (name, body) in enumerate(zip(names, bodies))}
    else:
        bodies = bodies[0]
    found = mq.clearance(bodies, **job["options"], progress=progress_line())
    return found, f"measured {_count(len(found.pairs), 'pair')} of bodies", verdict.of_clearance(found)


def draft(job):
    """Likewise."""
    found = mq.draft(read_operand(job["input"], job.get("object")), job["pull_direction"], **job["options"],
                     progress=progress_line())
    where = ""
    if job.get("csv"):
        found.write_csv(job["csv"])
        where = f", written to {job['csv']}"
    return found, f"measured {_count(len(found.areas), 'triangle')}{where}", verdict.of_draft(found)


def voids(job):
    """Likewise."""
    found = mq.voids(read_operand(job["input"], job.get("object")), **job["options"], progress=progress_line())
    return found, f"searched {_count(len(found.mesh.triangles), 'triangle')}", verdict.of_voids(found)


def verify(job):
    """As triangulate(); each fault is a finding."""
    found = mq.verify(job["input"], job.get("mesh"), progress_line())
    return found, f"verified {_count(found.elements, 'element')} of the certificate {job['input']}", \
        [verdict.Finding(upper_first(Text("{text}", text=f"{fault}."))) for fault in found.faults]


def _failure(status, error, **more):
    """The result of a job that ended with this error. Its kind is the text that the error shares with those of other
    parts.
    """
    said = error.args[0] if error.args else None
    kind = {"kind": said.phrase} if isinstance(said, Text) else {}
    return {"status": status, "text": str(error), **kind, **more}


def run(job):
    """The job's result as plain data; never raises."""
    _left_out.clear()
    try:
        report, text, findings, *more = {"triangulate": triangulate, "curve": curve, "boolean": boolean, "improve": improve,
                                         "quality": quality, "certify": certify, "verify": verify, "thickness": thickness,
                                         "clearance": clearance, "draft": draft, "voids": voids, "offset": offset,
                                         "hollow": hollow, "wrap": wrap}[job["command"]](job)
    except mq.InvalidInput as error:
        return _failure(USAGE, error)
    except files.DiskFull as error:
        return _failure(FAILED, error, limit="disk")
    except MemoryError as error:
        return {"status": FAILED, "text": f"there is not enough memory: {error or 'MemoryError'}", "limit": "memory"}
    except (mq.Error, ImportError, OSError) as error:  # the system's limits and disks; no traceback says more of these
        return _failure(FAILED, error)
    except Exception as error:  # noqa: BLE001 - whatever it is, the caller must hear of it
        traceback.print_exc()
        return {"status": FAILED, "text": f"{type(error).__name__}: {error}"}
    finally:
        end_progress_line()
    met = not findings
    said = verdict.sentence(findings) if findings else _NO_FINDING.get(job["command"], _ALL_MET)
    fields = {**report_fields(report), **(more[0] if more else {})}
    return {"status": DONE, "text": ". ".join(part.rstrip(".") for part in (f"{text}; {said}", *_left_out)), "met": met,
            "sound": not getattr(report, "faults_left", 0) and getattr(report, "holds", True),
            "report": {**fields, "notes": [*fields["notes"], *_left_out], **verdict.plain(findings)},
            "report_text": str(report) + "".join(f"finding      {finding.text}\n" for finding in findings)}


def main():
    with open(os.environ["MESHQUALITY_JOB"], encoding="utf-8") as stream:
        job = json.load(stream)
    limits.end_with_owner()
    if job["memory_limit"]:
        limits.limit_memory(int(job["memory_limit"] * 2**30))
    if job["time_limit"]:
        limits.end_itself_after(int(job["time_limit"]) + _GRACE)
    result = run(job)
    with open(job["result"], "w", encoding="utf-8") as stream:
        json.dump(result, stream)
    sys.exit(result["status"])


if "MESHQUALITY_JOB" in os.environ:
    main()
