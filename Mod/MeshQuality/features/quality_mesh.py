# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Quality Mesh": a mesh that follows a shape of the document."""

from functools import partial

from .. import options, verdict
from ..api import Memory, triangulate
from . import memories, mesh_object

# Name, type, what it says: measured on the mesh that the object holds.
MEASURED = (
    *mesh_object.TOPOLOGY,
    *mesh_object.ANGLES,
    ("ReusedFaces", "App::PropertyInteger",
     "Faces of the shape whose triangles were reused after the last edit"),
    ("Notes", "App::PropertyStringList", "Other remarks about the computation"),
)

# Name, type, what it says: beside mesh_object.PROMISES.
PROMISES = (
    *mesh_object.ANGLE_PROMISES,
    ("AskedChordHeight", "App::PropertyLength",
     "Requested max. deviation from the shape; 0: none"),
    ("MaxChordHeight", "App::PropertyLength", "Measured max. deviation from the shape"),
)


class QualityMesh(mesh_object.SourceMesh):
    """Proxy of a Mesh::FeaturePython that holds a mesh of its source.

    A shape that the object has met lately gets the mesh that it had, so that undo and redo give the
    triangles that were there; faces that an edit leaves alone start with theirs.
    """

    COMMAND, CALL = "MeshQuality_Triangulate", "add_quality_mesh"
    OPTIONS = options.TRIANGULATE
    PRESETS = options.TRIANGULATE_PRESETS
    MEASURED, PROMISES = MEASURED, PROMISES
    memory = None  # of its last meshes; not saved, nor copied with the object

    def add_properties(self, obj):
        """As for all, and Reuse."""
        super().add_properties(obj)
        if mesh_object.add_property(
                obj, "App::PropertyBool", "Reuse", "Update",
                "After an edit, faces that did not change keep their triangles, which is faster; undo gives "
                "the mesh that was there. Off: each mesh is computed from scratch, and depends on the shape "
                "and the options alone"):
            obj.Reuse = True

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """As for all, with what the object remembers."""
        work = super().work_on(sources, values, obj)
        if obj is not None and not obj.Reuse:
            work.tell_apart("from nothing")
            return work
        memory = obj.Proxy.memory if obj is not None else None
        work.compute = partial(work.compute, memory=Memory() if memory is None else memory)
        return work

    @classmethod
    def compute(cls, shape, values, progress, memory=None):
        """The SurfaceMesh of the shape, the Mesh.Mesh made of it, what FaceRuns gets, whether it was to
        be closed, the findings of its certificate, and the memory.
        """
        mesh = triangulate(shape, **values, progress=progress, memory=memory)
        closed = verdict.must_be_closed(shape)
        runs = mesh_object.runs_of_faces(mesh.triangle_face)
        return mesh, mesh.to_mesh(), runs, closed, verdict.of_triangulation(mesh, closed, values), memory

    def take(self, obj, result):
        """Shows the mesh and its report."""
        mesh, shown, obj.FaceRuns, closed, findings, self.memory = result
        memories.use(self)
        mesh_object.show_mesh(obj, shown)
        show_report(obj, mesh.report)
        mesh_object.show_certificate(obj, mesh.report, closed, findings)
        return mesh.report, findings


def show_report(obj, report):
    """Fills the group Quality, and what the certificate says of the angle and the distance."""
    mesh_object.show_topology(obj, report)
    mesh_object.show_angles(obj, report)
    obj.MaxChordHeight = max(report.max_chord_height, 0.0)
    obj.AskedChordHeight = report.chord_height_asked
    obj.ReusedFaces = report.reused_faces


def add(source, values):
    """Adds a quality mesh of `source` to its document; see mesh_object.add."""
    return mesh_object.add_of_source(QualityMesh, source, values, "QualityMesh", "Quality mesh")
