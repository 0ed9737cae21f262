# SPDX-License-Identifier: LGPL-2.1-or-later
"""write_report: a page on a mesh, or on what was measured, with pictures, what was requested, and what was found."""

import os

import numpy as np

from .. import options, phrases
from .. import report_phrases as words
from ..compat import extension
from ..core.certify import verdict
from ..core.curving import holds_elements, taken_from
from ..core.meshes.element_mesh import ElementMesh
from ..core.meshes.surface_mesh import SurfaceMesh
from ..core.reporting.content import View, content_of
from ..core.reporting.page import page_of
from ..core.reporting.report import SUFFIXES, asked_rows, content_for, write_page
from ..core.sources import convert, frames
from ..errors import InvalidInput
from . import cured_mesh, deviation, inspection, mesh_object
from .gui_hooks import WINDOWLESS, window
from .properties import exempt_reasons, options_of

_RECOMPUTED = ("thickness", "draft")  # checks whose values by triangle no document holds


def write_report(source, path, shape=None, progress=None):
    """Writes a page, as HTML that needs no other file or as PDF: pictures, what was requested and what was found, a histogram, a
    table by CAD face, places with pictures, versions and a digest.

    source    what triangulate, boolean, offset, hollow, wrap, improve, simplify, repair, curve, thickness, draft or deviation return;
              a Mesh.Mesh, arrays (V, F), an ElementMesh; or a document object with a mesh or a FEM mesh
    path      with the extension .html, or .pdf, which a browser prints: Chromium, Chrome, Edge or Brave, the one that the variable
              MESHQUALITY_BROWSER names or the first that is on the path; a file that is there is replaced
    shape     Part.Shape or document object: deviations of triangles from it are shown, too; of a quality mesh of the document its
              source unless given
    progress  as for triangulate

    Lengths are in mm. The page is in the language of the window, of scripts in English. Raises InvalidInput for other
    things; IoError naming the path, and where no browser prints.
    """
    options.require_callable(progress)
    name = os.fsdecode(convert.file_name(path))
    if not name.lower().endswith(SUFFIXES):
        raise InvalidInput(f"'{name}' has no known extension: a report is .html or .pdf")
    content = taken(source, shape)(progress) if frames.is_object(source) else \
        content_for(source, getattr(source, "Label", None) or type(source).__name__, shape, progress)
    write_page(name, page_of(content, window().translated))


def taken(source, shape=None):
    """A function of progress that makes the Content of a document object as it is now; any thread may call it."""
    obj = frames.linked_of(source)[0]
    label, proxy = frames.leaf_of(source).Label, getattr(obj, "Proxy", None)
    if isinstance(proxy, mesh_object.SourceMesh) and shape is None and None not in proxy.sources(obj):
        shape = proxy.sources(obj)[0]
    shape = None if shape is None else convert.taken(convert.shape_of(shape))
    if isinstance(proxy, inspection.Inspection) and obj.Check in _RECOMPUTED:
        work = proxy.work_on(proxy.sources(obj), options_of(obj, proxy.OPTIONS), obj)
        make = lambda progress: content_of(work.result(progress)[0], label)  # noqa: E731
    elif holds_elements(source):
        loaded = taken_from(source)
        make = lambda progress: content_of(loaded(), label)  # noqa: E731
    elif cured_mesh.has_fem_mesh(obj):
        mesh = ElementMesh.of(source)
        make = lambda progress: content_of(mesh, label)  # noqa: E731
    elif convert.is_mesh(source):
        make = _triangles_of(source, obj, label, shape)
    else:
        raise InvalidInput(f"'{label}' has no mesh: a report is of a mesh, an inspection or a FEM mesh")
    said = _certificate_of(obj, proxy) if isinstance(proxy, mesh_object.MeshObject) else {}

    def content(progress=None):
        found = make(progress)
        for name, value in said.items():
            setattr(found, name, value)
        return found

    return content


def _triangles_of(source, obj, label, shape):
    vertices, triangles = convert.arrays_of_mesh(source)
    faces = mesh_object.faces_of_runs(list(getattr(obj, "FaceRuns", [])), len(triangles)).astype(np.int32)
    reasons, own = exempt_reasons(obj), None
    limit = obj.AskedChordHeight.Value if "AskedChordHeight" in obj.PropertiesList else 0.0
    if deviation.is_of_points(obj):
        ends = deviation.colour_limit(obj)
        own = [View(words.SIGNED, "mm", np.array(obj.Deviations), ends, -ends)]

    def make(progress):
        surface = extension().surface_from_arrays(vertices, triangles, faces, True) if len(faces) else \
            convert.surface_of_arrays(extension(), vertices, triangles)
        found = content_of(SurfaceMesh(surface), label, shape, progress)
        if own is not None:
            found.views = own
        elif limit and len(found.views) > 1:
            found.views[1] = View(words.DEVIATION, "mm", found.views[1].values, limit, 0.0, limit)
        found.add_exempt(reasons)
        return found

    return make


def _title_of(option):
    """What the option is called, in the window in the user's language."""
    return option.title or option.name if window() is WINDOWLESS else phrases.Text("{option}", option=option.name)


def _certificate_of(obj, proxy):
    """What the object says of its result, as fields of a Content."""
    found = {"asked": asked_rows(proxy.OPTIONS, options_of(obj, proxy.OPTIONS), _title_of), "findings": []}
    certificate = phrases.stored(obj.Certificate, obj.CertificateData)
    if verdict.is_met(certificate):
        found["verdict"] = words.MET
    elif verdict.is_missed(certificate) or verdict.is_open(certificate):
        found["verdict"] = words.NOT_MET if verdict.is_missed(certificate) else words.NOT_DECIDED
        said = verdict.said(certificate)
        found["findings"].append(phrases.upper_first(said) if isinstance(said, phrases.Text) else said)
    told = proxy.told(obj)
    if told is not None:
        found["findings"].append(phrases.upper_first(phrases.sentence(told)))
    return found
