# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line inside FreeCAD: does the job of the file named by MESHQUALITY_JOB."""

import json
import os
import sys
import traceback

import MeshQuality as mq
from MeshQuality import files, limits
from MeshQuality.cli import input_files
from MeshQuality.cli.exit_status import DONE, FAILED, USAGE
from MeshQuality.cli.input_files import (mesh_of, read_analysis, read_mesh, read_operand, read_points, read_shape,
                                        read_shape_and_objects, size_field_in, sizes_in)
from MeshQuality.cli.output_file import patches_of, write_curved, write_solid_mesh, writing_of, written
from MeshQuality.cli.parser import CAD_SUFFIXES, MESH_SUFFIXES, TABLES
from MeshQuality.cli.progress_line import end_progress_line, progress_line
from MeshQuality.cli.report_fields import WRAP_FIELDS, plain, report_fields
from MeshQuality.core.certify import verdict
from MeshQuality.core.reporting import report as report_pages
from MeshQuality.core.reporting.page import page_of
from MeshQuality.core.volumes.volume_report import partly
from MeshQuality.phrases import Text, upper_first

_GRACE = 30  # seconds beyond the limit, after which it ends without its owner

# What is said without findings; some commands have no options that request anything.
_ALL_MET = "all requested limits are met"
_NO_FINDING = {**dict.fromkeys(("quality", "certify"), "no limits were requested, and no faults were found"),
               **dict.fromkeys(("measures", "section", "to-solid"), "no limits were requested"),
               "voids": "there are none",
               "verify": "all of it holds"}


def _count(number, noun):
    return f"{number} {noun}{'' if number == 1 else 's'}"


def _table_written(job, found):
    """Writes the table of what was found, if asked for; says where, for the sentence to end with."""
    if not job.get("csv"):
        return ""
    found.write_csv(job["csv"])
    return f", written to {job['csv']}"


def triangulate(job):
    """Returns the report, what the command did, and the findings."""
    shape, objects = read_shape_and_objects(job["input"], job.get("object"))
    values = {**job["options"],
              "local_sizes": sizes_in(shape, objects, job["input"], job["options"].get("local_sizes")),
              "size_field": size_field_in(objects, job["options"].get("size_field"))}
    how = writing_of(job, shape, objects)
    mesh = mq.triangulate(shape, **values, **patches_of(how), progress=progress_line())
    report, where = mesh.report, written(job, lambda path: mesh.write(path, **how))
    job["shown"] = mesh, shape
    return report, _count(report.triangles, "triangle") + where, \
        verdict.of_triangulation(mesh, verdict.must_be_closed(shape), values, shape)


def curve(job):
    """Likewise."""
    shape, objects = read_shape_and_objects(job["input"], job.get("object"))
    how = writing_of(job, shape, objects)
    values = {**job["options"], "size_field": size_field_in(objects, job["options"].get("size_field"))}
    mesh = mq.curve(shape, **values, **patches_of(how), mesh=job.get("mesh"), mesh_scale=job.get("mesh_scale", 1.0),
                    progress=progress_line())
    report, job["shown"] = mesh.report, (mesh, None)
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
    job["shown"] = mesh, None
    report, where = mesh.report, write_solid_mesh(job, mesh)
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


def cam(job):
    """Likewise, and between which distances from the solid the mesh is."""
    mesh = mq.cam(read_operand(job["input"], job.get("object")), **job["options"], progress=progress_line())
    job["shown"] = mesh, None
    report, where = mesh.report, written(job, lambda path: mesh.write(path, format=job["suffix"][1:]))
    return report, f"{_count(report.triangles, 'triangle')}{where}, proven to be {mesh.nearest:.4g} to {mesh.farthest:.4g} mm {mesh.side} of the " \
                   "part", verdict.topology(report, True, mesh), {"side": mesh.side, "nearest": mesh.nearest, "farthest": mesh.farthest}


def wrap(job):
    """Likewise, and what the report of a Boolean lacks. Places that are to stay dry are findings where they do not."""
    sources = [read_operand(path, job.get("object")) for path in job["inputs"]]
    mesh = mq.wrap(sources, **job["options"], dry=job.get("dry"), progress=progress_line())
    report, told, findings = _offset_written(job, mesh)
    return report, f"{told}, {mesh.gap_triangles} of them close gaps", \
        [*findings, *(verdict.Finding(str(leak)) for leak in mesh.leaks)], \
        {**plain({name: getattr(mesh, name) for name in WRAP_FIELDS}), "leaks": [leak.to_dict() for leak in mesh.leaks]}


def _offset_written(job, mesh):
    job["shown"] = mesh, None
    report, where = mesh.report, write_solid_mesh(job, mesh)
    return report, f"{_count(report.triangles, 'triangle')}{where}", verdict.of_boolean(mesh)


def improve(job):
    """Likewise; the mesh is to be as closed as that before it."""
    given = mesh_of(read_mesh(job["input"]))
    mesh = mq.improve(given, **job["options"], progress=progress_line())
    job["shown"] = mesh, None
    report, where = mesh.report, written(job, lambda path: mesh.write(path, format=job["suffix"][1:]))
    return report, _count(report.triangles, "triangle") + where, \
        verdict.of_improvement(mesh, given.report.closed)


def simplify(job):
    """Likewise, and what is proven."""
    given = mesh_of(read_mesh(job["input"]))
    mesh = mq.simplify(given, **job["options"], progress=progress_line())
    job["shown"] = mesh, None
    report, where = mesh.report, written(job, lambda path: mesh.write(path, format=job["suffix"][1:]))
    return report, f"{report.triangles} of {_count(given.report.triangles, 'triangle')}{where}, proven to deviate by {mesh.deviation:.4g} mm at " \
                   "most", verdict.of_improvement(mesh, given.report.closed), {"deviation": mesh.deviation}


def quality(job):
    """Likewise; a mesh is to be watertight unless the shape is not."""
    mesh = mesh_of(read_mesh(job["input"]))
    shape = read_shape(job["shape"], job.get("object")) if job.get("shape") else None
    report = mq.quality(mesh, shape, progress_line())
    job["shown"] = mesh, shape
    return report, f"measured {_count(report.triangles, 'triangle')} of {job['input']}", \
        verdict.of_measured(mesh, report, shape is None or verdict.must_be_closed(shape))


def _elements_of(job):
    """The mesh, or the name of the file of elements, that is measured."""
    return read_mesh(job["input"]) if job["input"].lower().endswith(MESH_SUFFIXES) else job["input"]


def measures(job):
    """Likewise; there are no findings, as nothing was requested."""
    found = mq.measures(_elements_of(job))
    return found, f"measured {_count(len(found), 'element')} of {job['input']}{_table_written(job, found)}", []


def section(job):
    """Likewise."""
    found = mq.section(_elements_of(job), job["point"], job["normal"])
    where = written(job, lambda path: found.half().write(path, format=job["suffix"][1:]))
    return found, f"cut {_count(len(found.element), 'element')} of {job['input']}: {found.area:.6g} mm^2{_table_written(job, found)}{where}", []


def solid(job):
    """Likewise."""
    found = mq.to_solid(mesh_of(read_mesh(job["input"])), progress=progress_line())
    return found, f"made a solid of {_count(found.facets, 'facet')}{written(job, found.write)}", []


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
    job["shown"] = found, None
    return found, f"measured {_count(len(found.values), 'triangle')}{_table_written(job, found)}", verdict.of_thickness(found)


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
    job["shown"] = found, None
    return found, f"measured {_count(len(found.areas), 'triangle')}{_table_written(job, found)}", verdict.of_draft(found)


def voids(job):
    """Likewise."""
    found = mq.voids(read_operand(job["input"], job.get("object")), **job["options"], progress=progress_line())
    return found, f"searched {_count(len(found.mesh.triangles), 'triangle')}", verdict.of_voids(found)


def adapt(job):
    """Likewise; a target that is not reached is a finding."""
    found = mq.adapt(read_analysis(job["input"], job.get("object")), **job["options"], progress=progress_line())
    where = written(job, lambda path: found.mesh.write(path, format=job["suffix"][1:]))
    return found, f"{_count(len(found.mesh.tetrahedra), 'element')}{where}, error {found.error:.2%}, ended by {found.stopped}", \
        [*verdict.of_curved(found.mesh, True), *([] if found.stopped == "target" else [verdict.Finding(
            f"The estimated error is {found.error:.2%}, above what is asked for: ended by {found.stopped}.")])]


def _first_height(job, given):
    """mm, by --y-plus."""
    if given is not None:
        raise mq.InvalidInput("--first-height and --y-plus both say how high the first layer is: give one of them")
    if job["speed"] is None or job["length"] is None:
        raise mq.InvalidInput("--y-plus needs the flow: give --speed in m/s and --length in mm")
    try:
        fluid = float(job["fluid"])
    except ValueError:
        fluid = job["fluid"]
    return mq.first_height(job["speed"], job["length"], fluid, job["y_plus"])


def volume(job):
    """Likewise; walls without layers are findings."""
    shape, objects = read_shape_and_objects(job["input"], job.get("object"))
    values = {**job["options"], "local_sizes": sizes_in(shape, objects, job["input"], job["options"].get("local_sizes"))}
    how = writing_of(job, shape, objects)
    if job["y_plus"] is not None:
        values["first_height"] = _first_height(job, values["first_height"])
    far_field = job["far_field"]
    if far_field and far_field.lower().endswith(CAD_SUFFIXES):
        far_field = read_shape(far_field)
    mesh = mq.volume_mesh(shape, **values, walls=job.get("walls"), far_field=far_field, symmetry=job["symmetry"], **patches_of(how),
                          progress=progress_line())
    report = mesh.report
    where = written(job, lambda path: mesh.write(path, how.get("scale"), how["format"] or None, job["binary"]))
    return report, f"{_count(sum(report.elements.values()), 'element')}{where}, layers on {report.covered:.1%} of the walls", \
        [verdict.Finding(f"{wall.face} has layers on {partly(wall.covered)} of its area only.", faces=(wall.face,))
         for wall in report.walls if wall.covered < 1.0]


def deviation(job):
    """Likewise."""
    found = mq.deviation(read_points(job["input"]), read_operand(job["reference"], job.get("object")), **job["options"],
                         scale=job["mesh_scale"], progress=progress_line())
    job["shown"] = found, None
    return found, f"measured {_count(len(found.values), 'point')}{_table_written(job, found)}", verdict.of_deviation(found)


def verify(job):
    """Likewise; each fault is a finding."""
    found = mq.verify(job["input"], job.get("mesh"), progress_line())
    return found, f"verified {_count(found.elements, 'element')} of the certificate {job['input']}", \
        [verdict.Finding(upper_first(Text("{text}", text=f"{fault}."))) for fault in found.faults]


def _write_page(job, findings):
    """Writes the page of --report; says where, for the sentence to end with."""
    source, shape = job["shown"]
    content = report_pages.content_for(source, os.path.basename(job["inputs"][0]), shape, progress_line(), findings)
    content.asked = report_pages.asked_rows(TABLES[job["command"]], job["options"])
    report_pages.write_page(job["page"], page_of(content))
    return f"; report in {job['page']}"


def _failure(status, error, **more):
    """The result of a job that ended with this error. Its kind is what the error has in common with those of other parts."""
    said = error.args[0] if error.args else None
    while isinstance(said, Text) and isinstance(said.places.get("phrase"), Text):
        said = said.places["phrase"]  # without the name before it
    kind = {"kind": said.phrase} if isinstance(said, Text) else {}
    return {"status": status, "text": str(error), **kind, **more}


def run(job):
    """The job's result as plain data; never raises."""
    input_files.left_out.clear()
    try:
        report, text, findings, *more = {"triangulate": triangulate, "curve": curve, "boolean": boolean, "improve": improve, "simplify": simplify,
                                         "quality": quality, "measures": measures, "section": section, "to-solid": solid, "certify": certify, "verify": verify, "thickness": thickness,
                                         "clearance": clearance, "draft": draft, "voids": voids, "deviation": deviation,
                                         "offset": offset, "hollow": hollow, "wrap": wrap, "cam": cam, "adapt": adapt, "volume": volume}[job["command"]](job)
        text += _write_page(job, findings) if job.get("page") else ""
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
    return {"status": DONE, "text": ". ".join(part.rstrip(".") for part in (f"{text}; {said}", *input_files.left_out)), "met": met,
            "sound": not getattr(report, "faults_left", 0) and getattr(report, "holds", True),
            "report": {**fields, "notes": [*fields["notes"], *input_files.left_out], **verdict.plain(findings)},
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
