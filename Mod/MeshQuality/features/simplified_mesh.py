# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Simplified Mesh": a mesh of the document with fewer triangles, within a proven distance."""

import numpy as np

from .. import options, phrases
from ..compat import extension
from ..core.certify import verdict
from ..core.meshes.surface_mesh import SurfaceMesh
from ..core.simplification import simplify
from ..core.sources import convert, frames
from ..errors import InvalidInput
from . import improved_mesh, mesh_object, properties, transactions


class SimplifiedMeshObject(mesh_object.SegmentedMesh, improved_mesh.ImprovedMesh):
    """Proxy of a Mesh::FeaturePython that holds its source's mesh with fewer triangles. These keep the CAD faces of the source."""

    COMMAND, CALL = "MeshQuality_Simplify", "add_simplified_mesh"
    SOURCE = "The object whose mesh is simplified"
    OPTIONS = options.simplify.SIMPLIFY
    MEASURED = (
        *properties.TOPOLOGY,
        ("GivenTriangles", "App::PropertyInteger", "Number of triangles of the given mesh"),
        ("MaxDeviation", "App::PropertyLength", "No point of either surface is farther from the other one, proven"),
        properties.DEVIATION,
        properties.NOTES,
    )
    PROMISES = ()
    HIDDEN = (mesh_object.FACE_RUNS,)

    def has_faces(self, obj):
        """There are no patches: the source has them."""
        return False

    @classmethod
    def more_of(cls, source):
        """The CAD faces of the triangles, as FaceRuns has them."""
        return {"runs": list(getattr(frames.linked_of(source)[0], "FaceRuns", []))}

    @classmethod
    def compute(cls, source, values, progress, runs):
        """The SimplifiedMesh, the Mesh.Mesh made of it, whether it was to be closed, the findings of its certificate, and the
        number of triangles that were given.
        """
        vertices, triangles = source.arrays
        faces = mesh_object.faces_of_runs(runs, len(triangles)).astype(np.int32)
        surface = extension().surface_from_arrays(vertices, triangles, faces, True) if len(faces) else \
            convert.surface_of_arrays(extension(), vertices, triangles)
        given = SurfaceMesh(surface)
        mesh = simplify(given, **values, progress=progress)
        closed = given.report.closed
        return mesh, mesh.to_mesh(), closed, verdict.of_improvement(mesh, closed, progress), len(triangles)

    def take(self, obj, result):
        """Shows the mesh and its report."""
        mesh, *shown, count = result
        obj.GivenTriangles, obj.MaxDeviation = count, mesh.deviation
        return self.show(obj, mesh, *shown)

    def told(self, obj):
        """How many triangles are left, and what is proven."""
        return phrases.Text(phrases.SIMPLIFIED, count=f"{obj.Triangles:,}", count2=f"{obj.GivenTriangles:,}",
                            length=f"{obj.MaxDeviation.Value:.4g} mm")


def add_simplified_mesh(source, **values):
    """Adds a document object that keeps the mesh of `source` with fewer triangles; one undo step.

    source   document object with a mesh
    values   the options of simplify, except progress

    The properties MaxDeviation, mm, and GivenTriangles say what is proven and what was given. Returns the object. Raises what
    simplify raises, and then adds nothing.
    """
    if not convert.is_mesh(source):
        raise InvalidInput(f"a document object with a mesh is needed, not {getattr(source, 'Label', type(source).__name__)}")
    return transactions.add_of_source(SimplifiedMeshObject, source, values, "SimplifiedMesh", "Simplify", "simplified")
