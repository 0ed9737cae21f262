# SPDX-License-Identifier: LGPL-2.1-or-later
"""File > Export: quality meshes of what is selected in one file, with their certificates in the Report view."""

import os
import re
from typing import NamedTuple

import FreeCAD
import numpy as np

from .. import formats, phrases
from ..compat import extension
from ..core.certify import verdict
from ..core.curving import curve
from ..core.formats import three_mf
from ..core.meshes import writing
from ..core.meshes.surface_mesh import SurfaceMesh
from ..core.patches.patches import Division, Patches, patches_of
from ..core.patches.source_faces import own_names
from ..core.sources import convert, frames, hidden_parts
from ..core.triangulation import triangulate
from ..errors import Error, InvalidInput
from ..phrases import Text, counted
from . import export as meshes
from . import file_settings
from .export_bodies import Body, items_of
from .gui_hooks import window


def export(objects, path):
    """See MeshQuality.exchange.export."""
    try:
        _export(objects, path)
    except Error as error:
        raise type(error)(window().translated(error)) from error


def _export(objects, path):
    items = items_of(objects)
    path = meshes.checked(items[0].source, path, tuple(formats.FORMATS))
    suffix = formats.known_suffix(os.path.splitext(path)[1], tuple(formats.FORMATS))
    only = items[0].source if len(items) == 1 else None
    for item in items:
        for sentence in hidden_parts.sentences_of(item.source, with_meshes=True):
            _say(FreeCAD.Console.PrintWarning, item.label, sentence)
    bodies = [body for item in items for body in item.bodies]
    fem = next((body for body in bodies if meshes.holds_fem_mesh(body.source)), None)
    if only is not None and (fem or convert.is_mesh(only) and suffix != ".3mf"):
        meshes.export_mesh(only, path, scale=file_settings.scale())
        _tell_of_mesh(bodies[0])
    elif fem:
        raise InvalidInput(Text(phrases.FEM_MESH_ALONE, name=f"'{fem.label}'"))
    elif formats.FORMATS[suffix].curved and not any(convert.is_mesh(body.source) for body in bodies):
        _write_elements(bodies, path, suffix)
    else:
        _write_triangles(items, bodies, path, suffix)
    FreeCAD.Console.PrintMessage(f"Written: {path}\n")


def _write_elements(bodies, path, suffix):
    """Writes elements on all shapes at once, so that bodies that touch have the same nodes there."""
    shapes = [convert.taken(convert.shape_of(body.source)) for body in bodies]
    shape = shapes[0] if len(shapes) == 1 else _compound(shapes)
    values = file_settings.element_values(suffix, bool(shape.Solids))
    labels = [body.label for body in bodies]
    try:
        with window().file_progress(labels[0]) as progress:
            made = curve(shape, **values, progress=progress)
    except Error:
        _tell_of_faces(labels, shapes)
        raise
    if len(bodies) > 1:
        names, solids = (own_names(_short(labels, suffix), [found.countElement(kind) for found in shapes], kind)
                         for kind in ("Face", "Solid"))
        made._patches = patches_of(Division(face_names=names), made.triangle_face, len(made.triangles))
        made._solid_names = solids
    findings = verdict.of_curved(made, verdict.must_be_closed(shape), values, shape=shape)
    if findings:
        _tell_of_faces(labels, shapes)
    made.write(path, scale=file_settings.scale())
    straight = made.straight.report
    _tell(", ".join(labels), made.report, findings, _asked(phrases.REQUESTED_BEFORE, straight),
          counted(phrases.EXEMPT_TRIANGLES, len(straight.exempt_reasons)), Text(phrases.OF_ORDER, count=str(made.order)))


def _tell_of_faces(labels, shapes):
    """Which of the faces that errors and certificates name are of which of several bodies."""
    first = 1
    for label, shape in zip(labels, shapes):
        last = first + shape.countElement("Face") - 1
        if len(shapes) > 1:
            _say(FreeCAD.Console.PrintMessage, label, Text(phrases.FACES_OF_BODY, face=f"Face{first}", face2=f"Face{last}"))
        first = last + 1


def _compound(shapes):
    import Part

    return Part.makeCompound(shapes)


class _Part(NamedTuple):
    """A body with its SurfaceMesh."""

    body: Body
    mesh: SurfaceMesh


def _write_triangles(items, bodies, path, suffix):
    parts = {id(body): _Part(body, _triangles_of(body)) for body in bodies}
    scale = file_settings.scale()
    if suffix == ".3mf":
        named = [(_plain(item.label), [(_plain(body.label), parts[id(body)].mesh, _materials(parts[id(body)], len(bodies)))
                                       for body in item.bodies]) for item in items]
        for part in parts.values():
            writing.require_in_range(part.mesh.vertices + part.mesh.origin, scale)
        writing.atomically(path, suffix, lambda ready: three_mf.write(ready, named, scale))
    elif len(bodies) == 1:
        parts[id(bodies[0])].mesh.write(path, scale=scale)
    else:
        _merged([*parts.values()], suffix).write(path, scale=scale)


def _triangles_of(body):
    """The SurfaceMesh of a body, told of in the Report view."""
    if convert.is_mesh(body.source):
        mesh = meshes.flat_maker_of(body.source)()
        _tell_of_mesh(body)
        return mesh
    shape, values = convert.taken(convert.shape_of(body.source)), file_settings.surface_values()
    with window().file_progress(body.label) as progress:
        mesh = triangulate(shape, **values, progress=progress)
    report = mesh.report
    _tell(body.label, report, verdict.of_triangulation(mesh, verdict.must_be_closed(shape), values, shape),
          _asked(phrases.REQUESTED, report), counted(phrases.EXEMPT_TRIANGLES, len(report.exempt_reasons)),
          Text(phrases.WATERTIGHT if report.closed else phrases.NOT_WATERTIGHT))
    return mesh


def _merged(parts, suffix):
    """One SurfaceMesh of several bodies; each is a patch by its name, and for solvers each of their faces."""
    points, corners, faces, last, first = [], [], [], 0, 0
    counts = [_face_count(part) if formats.FORMATS[suffix].curved else None for part in parts]
    for part, count in zip(parts, counts):
        mesh = part.mesh
        points.append(mesh.vertices + mesh.origin)
        corners.append(mesh.triangles.astype(np.int64) + last)
        faces.append(mesh.triangle_face + first if count else np.full(len(mesh.triangles), first, dtype=np.int32))
        last, first = last + len(mesh.vertices), first + (count or 1)
    faces = np.concatenate(faces).astype(np.int32)
    merged = SurfaceMesh(extension().surface_from_arrays(np.concatenate(points), np.concatenate(corners), faces, False))
    names = own_names(_short([part.body.label for part in parts], suffix), counts)
    merged._patches = patches_of(Division(face_names=names), faces, len(faces))
    return merged


def _short(labels, suffix):
    """Labels of which the format holds names that end with the number of a face or a solid."""
    names = formats.FORMATS[suffix].names
    return [label[:names.longest - len("_Solid12345")] for label in labels] if names else labels


def _face_count(part):
    faces = part.mesh.triangle_face
    return int(faces.max()) + 1 if len(faces) and faces.min() >= 0 else None


def _materials(part, bodies):
    """The Patches by which a 3MF file has the colours of a body; where no colours are known, of several bodies each has one."""
    mesh, label, colours = part.mesh, _plain(part.body.label), part.body.colours
    count = len(mesh.triangles)
    if mesh._patches is not None:
        return mesh._patches
    if not colours:
        return Patches((label,), (None,), np.zeros(count, dtype=np.int32), bodies > 1, None)
    faces = mesh.triangle_face
    if len(colours) == 1 or len(faces) != count or faces.max(initial=-1) >= len(colours):
        return Patches((label,), colours[:1], np.zeros(count, dtype=np.int32), True, None)
    distinct = list(dict.fromkeys(colours))
    number = np.array([distinct.index(colour) for colour in colours], dtype=np.int32)
    names = tuple(f"{label} #{'%02x%02x%02x' % colour}" for colour in distinct)
    return Patches(names, tuple(distinct), number[faces], True, None)


def _plain(label):
    """A label without what no XML holds."""
    return re.sub(r"[\x00-\x1f\x7f\ufffe\uffff]+", " ", label)


def _tell_of_mesh(body):
    """What the certificate of a mesh that was there says; of another program's mesh nothing."""
    holder = frames.linked_of(body.source)[0]
    certificate = getattr(holder, "Certificate", "")
    if certificate:
        print_it = FreeCAD.Console.PrintMessage if verdict.is_met(certificate) else FreeCAD.Console.PrintWarning
        _say(print_it, body.label, phrases.stored(certificate, holder.CertificateData))


def _tell(label, report, findings, asked, *found):
    """Two lines on what was made: with a warning where a requested limit is not met."""
    say = window().translated
    FreeCAD.Console.PrintMessage(f"{label}: {say(asked)}; {', '.join(map(say, found))}\n")
    print_it = FreeCAD.Console.PrintWarning if findings else FreeCAD.Console.PrintMessage
    print_it(f"{verdict.line(label, report, findings, say)}\n")


def _asked(phrase, report):
    return Text(phrase, number=f"{report.min_angle_asked:g}", length=f"{report.chord_height_asked:.4g} mm")


def _say(print_it, label, text):
    print_it(f"{label}: {window().translated(text)}\n")
