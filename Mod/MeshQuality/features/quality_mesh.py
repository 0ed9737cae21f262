# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Quality Mesh": a mesh that follows a shape of the document."""

from .. import options, phrases
from ..api import triangulate
from . import certificate, mesh_object

# Name, type, what it says: measured on the mesh that the object holds.
MEASURED = (
    *mesh_object.TOPOLOGY,
    *mesh_object.ANGLES,
    ("Notes", "App::PropertyStringList", "What else happened on the way"),
)

# Name, type, what it says: beside mesh_object.PROMISES.
PROMISES = (
    *mesh_object.ANGLE_PROMISES,
    ("AskedChordHeight", "App::PropertyLength",
     "Distance to the shape that the mesh was to keep within; 0: none"),
    ("MaxChordHeight", "App::PropertyLength", "Largest measured distance to the shape"),
)


class QualityMesh(mesh_object.SourceMesh):
    """Proxy of a Mesh::FeaturePython that holds a mesh of its source."""

    COMMAND, CALL = "MeshQuality_Triangulate", "add_quality_mesh"
    OPTIONS = options.TRIANGULATE
    PRESETS = options.TRIANGULATE_PRESETS
    MEASURED, PROMISES = MEASURED, PROMISES

    @classmethod
    def compute(cls, shape, values, progress):
        """The SurfaceMesh of the shape, the Mesh.Mesh made of it, what FaceRuns gets, whether it was to
        be closed, and the faults of its certificate.
        """
        mesh = triangulate(shape, **values, progress=progress)
        closed = certificate.shall_be_closed(shape)
        runs = mesh_object.runs_of_faces(mesh.triangle_face)
        return mesh, mesh.to_mesh(), runs, closed, _faults(mesh, closed)

    def take(self, obj, result):
        """Shows the mesh and its report."""
        mesh, shown, obj.FaceRuns, closed, faults = result
        mesh_object.show_mesh(obj, shown)
        show_report(obj, mesh.report)
        mesh_object.show_certificate(obj, mesh.report, closed, faults)


def _faults(mesh, closed):
    found = certificate.angle_faults(mesh) + certificate.chord_faults(mesh)
    if not mesh.report.complete:
        found.append(certificate.Fault(phrases.LIMIT))
    return found + certificate.topology_faults(mesh.report, closed, mesh)


def show_report(obj, report):
    """Fills the group Quality, and what the certificate says of the angle and the distance."""
    mesh_object.show_topology(obj, report)
    mesh_object.show_angles(obj, report)
    obj.MaxChordHeight = max(report.max_chord_height, 0.0)
    obj.AskedChordHeight = report.chord_height_asked


def add(source, values):
    """Adds a quality mesh of `source` to its document; see mesh_object.add."""
    return mesh_object.add_of_source(QualityMesh, source, values, "QualityMesh", "Quality mesh")
