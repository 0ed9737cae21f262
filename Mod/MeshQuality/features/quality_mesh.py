# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Quality Mesh": a mesh that follows a shape of the document."""

from .. import options
from ..api import triangulate
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


class QualityMesh(mesh_object.SourceMesh):
    """Proxy of a Mesh::FeaturePython that holds a mesh of its source."""

    COMMAND, CALL = "MeshQuality_Triangulate", "add_quality_mesh"
    OPTIONS = options.TRIANGULATE
    PRESETS = options.TRIANGULATE_PRESETS
    MEASURED = MEASURED

    @classmethod
    def compute(cls, shape, values, progress):
        """The SurfaceMesh of the shape, and the Mesh.Mesh made of it."""
        mesh = triangulate(shape, **values, progress=progress)
        return mesh, mesh.to_mesh()

    def take(self, obj, result):
        """Shows the mesh and its report."""
        mesh, obj.Mesh = result
        show_report(obj, mesh.report)
        obj.FaceRuns = mesh_object.runs_of_faces(mesh.triangle_face)


def show_report(obj, report):
    """Fills the group Quality."""
    mesh_object.show_topology(obj, report)
    obj.MeasuredMinAngle, obj.MeasuredMaxAngle = report.min_angle, report.max_angle
    obj.MaxChordHeight = max(report.max_chord_height, 0.0)
    obj.Exempt = [f"triangle {triangle}: {why}" for triangle, why in report.exempt]
    obj.Notes = list(report.notes)


def add(source, values):
    """Adds a quality mesh of `source` to its document; see mesh_object.add."""
    return mesh_object.add_of_source(QualityMesh, source, values, "QualityMesh", "Quality mesh")
