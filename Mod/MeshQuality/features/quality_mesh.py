# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Quality Mesh": a mesh that follows a shape of the document."""

import hashlib
import json

import FreeCAD
import numpy as np

from .. import convert, options
from ..api import triangulate
from ..errors import InvalidInput
from . import mesh_object

# Name, type, what it says: measured on the mesh that the object holds.
MEASURED = (
    *mesh_object.TOPOLOGY,
    ("MeasuredMinAngle", "App::PropertyAngle", "Smallest angle of all triangles"),
    ("MeasuredMaxAngle", "App::PropertyAngle", "Largest angle of all triangles"),
    ("MaxChordHeight", "App::PropertyLength", "Largest measured distance to the shape"),
    ("Exempt", "App::PropertyStringList", "Triangles below the angle asked for, and why"),
    ("Notes", "App::PropertyStringList", "What else happened on the way"),
)
# Name, type, what it says. Kept for the object's own use and hidden from the property editor.
HIDDEN = (
    ("Fingerprint", "App::PropertyString", "Of the shape and the options of this mesh"),
    ("FaceRuns", "App::PropertyIntegerList",
     "Pairs (index of a CAD face, number of successive triangles on it)"),
)


class QualityMesh(mesh_object.MeshObject):
    """Proxy of a Mesh::FeaturePython that holds a mesh of its source."""

    def add_properties(self, obj):
        """Adds those properties that the object has not got yet."""
        # Global: a mesh may follow a shape inside a container that it does not belong to itself.
        mesh_object.add_property(obj, "App::PropertyLinkGlobal", "Source", "Mesh",
                                 "The object whose shape is meshed")
        mesh_object.add_options(obj, options.TRIANGULATE)
        mesh_object.add_measured(obj, MEASURED)
        mesh_object.add_hidden(obj, "Mesh", HIDDEN)

    def onDocumentRestored(self, obj):
        """The mesh gets its segments back, which FreeCAD does not save."""
        super().onDocumentRestored(obj)
        segments = convert.face_segments(faces_of_runs(obj.FaceRuns))
        if segments and obj.Mesh.countSegments() == 0:
            mesh = obj.Mesh.copy()
            convert.add_segments(mesh, segments)
            obj.Mesh = mesh
            obj.purgeTouched()

    def update(self, obj):
        """Meshes the source anew, unless neither it nor an option has changed."""
        if obj.Source is None:
            raise InvalidInput("Source is empty: choose an object with a shape")
        values = mesh_object.options_of(obj, options.TRIANGULATE)
        options.check(options.TRIANGULATE, values)
        shape = convert.shape_of(obj.Source)
        fingerprint = fingerprint_of(shape, values)
        if fingerprint == obj.Fingerprint and obj.Mesh.CountFacets > 0:
            return
        mesh = triangulate(shape, **values)
        obj.Mesh = mesh.to_mesh()
        show_report(obj, mesh.report)
        obj.FaceRuns = runs_of_faces(mesh.triangle_face)
        obj.Fingerprint = fingerprint


def fingerprint_of(shape, values):
    """Changes whenever the shape or an option does; the same after saving and loading."""
    digest = hashlib.sha256(shape.exportBrepToString().encode())
    digest.update(json.dumps(values, sort_keys=True).encode())
    return digest.hexdigest()


def runs_of_faces(triangle_face):
    """triangle_face as a flat list face, count, ...: short, as triangles come sorted."""
    starts = np.flatnonzero(np.diff(triangle_face, prepend=-2))
    counts = np.diff(starts, append=len(triangle_face))
    return np.column_stack((triangle_face[starts], counts)).ravel().tolist()


def faces_of_runs(runs):
    """The inverse of runs_of_faces."""
    pairs = np.array(runs, dtype=np.int64).reshape(-1, 2)
    return np.repeat(pairs[:, 0], pairs[:, 1])


def show_report(obj, report):
    """Fills the group Quality."""
    mesh_object.show_topology(obj, report)
    obj.MeasuredMinAngle, obj.MeasuredMaxAngle = report.min_angle, report.max_angle
    obj.MaxChordHeight = max(report.max_chord_height, 0.0)
    obj.Exempt = [f"triangle {triangle}: {why}" for triangle, why in report.exempt]
    obj.Notes = list(report.notes)


def add(source, values):
    """Adds a quality mesh of `source` to its document; see mesh_object.add."""
    if not isinstance(source, FreeCAD.DocumentObject):
        raise InvalidInput("a document object with a shape is needed, not "
                           f"{type(source).__name__}")
    checked = options.check(options.TRIANGULATE, values)

    def make(obj):
        proxy = QualityMesh(obj)
        obj.Label = f"{source.Label} quality mesh"
        obj.Source = source
        mesh_object.set_options(obj, options.TRIANGULATE, checked)
        return proxy

    return mesh_object.add(source.Document, "QualityMesh", "Quality mesh", make)
