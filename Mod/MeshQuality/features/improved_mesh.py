# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Improved Mesh": a mesh of the document with better triangles."""

import hashlib
import json
from functools import partial

import FreeCAD

from .. import convert, options
from ..api import improve
from ..compat import core
from ..errors import InvalidInput
from . import certificate, mesh_object
from .work import Work

# Name, type, what it says: measured on the mesh that the object holds.
MEASURED = (
    *mesh_object.TOPOLOGY,
    ("MeasuredMaxAngle", "App::PropertyAngle", "Largest angle of all triangles"),
    ("Exempt", "App::PropertyStringList", "Triangles below the angle asked for, and why"),
    ("Notes", "App::PropertyStringList", "What was done"),
)

# Name, type, what it says: beside mesh_object.PROMISES.
PROMISES = (
    ("AskedMinAngle", "App::PropertyAngle", "Smallest angle that was asked for"),
    ("MeasuredMinAngle", "App::PropertyAngle", "Smallest angle of all triangles"),
)


class ImprovedMesh(mesh_object.MeshObject):
    """Proxy of a Mesh::FeaturePython that holds a better version of its source's mesh."""

    COMMAND, CALL = "MeshQuality_Improve", "add_improved_mesh"
    OPTIONS = options.IMPROVE
    PROMISES = PROMISES

    def sources(self, obj):
        """The Source, if any."""
        return [obj.Source] if obj.Source is not None else []

    def holds_mesh(self, obj):
        """A mesh with triangles."""
        return obj.Mesh.CountFacets > 0

    def add_properties(self, obj):
        """Adds those properties that the object has not got yet."""
        mesh_object.add_property(obj, "App::PropertyLinkGlobal", "Source", "Mesh",
                                 "The object whose mesh is improved")
        mesh_object.add_options(obj, self.OPTIONS)
        mesh_object.add_measured(obj, MEASURED)
        self.add_common_properties(obj)

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """A better version of the source's mesh."""
        if len(sources) != 1 or not convert.is_mesh(sources[0]):
            raise InvalidInput("Source is not a mesh: choose one object with a mesh")
        values = options.check(cls.OPTIONS, values)
        vertices, triangles = convert.arrays_of_mesh(sources[0])
        return Work(cls, sources, values, partial(_digest, vertices, triangles, values),
                    partial(cls.compute, vertices, triangles, values))

    @classmethod
    def compute(cls, vertices, triangles, values, progress):
        """The SurfaceMesh, the Mesh.Mesh made of it, whether it was to be closed, and the faults of
        its certificate.
        """
        given = convert.surface_of_arrays(core(), vertices, triangles)
        mesh = improve((vertices, triangles), **values, progress=progress)
        closed = given.report.closed
        faults = certificate.angle_faults(mesh) + certificate.topology_faults(mesh.report, closed)
        return mesh, mesh.to_mesh(), closed, faults

    def take(self, obj, result):
        """Shows the mesh and its report."""
        mesh, obj.Mesh, closed, faults = result
        report = mesh.report
        mesh_object.show_topology(obj, report)
        mesh_object.show_certificate(obj, report, closed, faults)
        obj.MeasuredMinAngle, obj.MeasuredMaxAngle = report.min_angle, report.max_angle
        obj.AskedMinAngle = report.min_angle_asked
        obj.Exempt = [f"triangle {triangle}: {why}" for triangle, why in report.exempt]
        obj.Notes = list(report.notes)


def _digest(vertices, triangles, values):
    digest = hashlib.sha256(vertices.tobytes())
    digest.update(triangles.tobytes())
    digest.update(json.dumps(values, sort_keys=True).encode())
    return digest.hexdigest()


def add(source, values):
    """Adds an improved mesh of `source` to its document; see mesh_object.add."""
    if not isinstance(source, FreeCAD.DocumentObject) or not convert.is_mesh(source):
        raise InvalidInput("a document object with a mesh is needed, not "
                           f"{getattr(source, 'Label', type(source).__name__)}")
    checked = options.check(ImprovedMesh.OPTIONS, values)

    def make(obj):
        proxy = ImprovedMesh(obj)
        obj.Label = f"{source.Label} improved"
        obj.Source = source
        mesh_object.set_options(obj, ImprovedMesh.OPTIONS, checked)
        return proxy

    return mesh_object.add(source.Document, "ImprovedMesh", "Improve mesh", make)
