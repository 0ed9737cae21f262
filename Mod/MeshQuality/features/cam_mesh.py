# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "CAM mesh": a mesh that follows a solid of the document on one side of it, for machining."""

from .. import options, phrases
from ..core.certify import verdict
from ..core.machining import run_cam
from . import offset, properties, transactions


class CamMeshObject(offset.SolidMesh):
    """Proxy of a Mesh::FeaturePython that holds a mesh which is never inside its source, or never outside."""

    COMMAND, CALL = "MeshQuality_CamMesh", "add_cam_mesh"
    SOURCE, NEEDS = "The object whose solid is machined", "a shape or a mesh"
    OPTIONS = options.cam.CAM
    MEASURED = (
        *properties.TOPOLOGY,
        ("Nearest", "App::PropertyLength", "Every point of the mesh is at least this far from the surface of the part, on its side; proven"),
        ("MaxDeviation", "App::PropertyLength", "No point of the mesh is farther from the surface of the part; proven"),
        properties.DEVIATION,
        properties.NOTES,
    )
    PROMISES = ()

    def has_faces(self, obj):
        """There are no patches: the mesh is offset from one whose faces are not kept."""
        return False

    @classmethod
    def compute(cls, given, values, progress):
        """(CamMesh, Mesh.Mesh, findings of its certificate, given)."""
        mesh = run_cam(given.operands, values, progress)
        return mesh, mesh.to_mesh(), verdict.topology(mesh.report, True, mesh), given

    def take(self, obj, result):
        """Shows the mesh and its report."""
        obj.Nearest, obj.MaxDeviation = result[0].nearest, result[0].farthest
        return super().take(obj, result)

    def told(self, obj):
        """What is proven of the side."""
        if not obj.Fingerprint:
            return None
        phrase = phrases.NEVER_INSIDE if obj.Side == options.cam.SIDES[0] else phrases.NEVER_OUTSIDE
        return phrases.Text(phrase, length=f"{obj.Nearest.Value:.4g} mm", length2=f"{obj.MaxDeviation.Value:.4g} mm")


def add_cam_mesh(source, tolerance, side="outside"):
    """Adds a document object that keeps a mesh for machining of a solid of the document up to date; one undo step.

    source     document object with a shape or a closed mesh: feature, body, mesh, link or container
    tolerance, side  as for cam

    The properties Nearest and MaxDeviation, mm, say between which distances from the part all points of the mesh are, on its side. Returns
    the object. Raises what cam raises, and then adds nothing.
    """
    return transactions.add_of_source(CamMeshObject, source, {"tolerance": tolerance, "side": side}, "CamMesh", "CAM mesh", "CAM mesh")
