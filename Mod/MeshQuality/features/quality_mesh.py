# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Quality Mesh": a mesh that follows a shape of the document."""

from functools import partial

from .. import options
from ..core.certify import verdict
from ..core.triangulation import MeshCache, triangulate
from . import mesh_cache_limit, mesh_object, properties, transactions


class QualityMesh(mesh_object.SourceMesh):
    """Proxy of a Mesh::FeaturePython that holds a mesh of its source.

    A shape that the object has met lately gets the mesh that it had, so that undo and redo give the
    triangles that were there; faces that an edit leaves alone start with theirs.
    """

    COMMAND, CALL = "MeshQuality_Triangulate", "add_quality_mesh"
    OPTIONS = options.TRIANGULATE
    PRESETS = options.TRIANGULATE_PRESETS
    MEASURED = (
        *properties.TOPOLOGY,
        *properties.ANGLES,
        ("ReusedFaces", "App::PropertyInteger", "Faces of the shape whose triangles were reused after the last edit",
         "reused_faces"),
        properties.BRIDGE,
        properties.NOTES,
    )
    PROMISES = (
        *mesh_object.ANGLE_PROMISES,
        ("AskedChordHeight", "App::PropertyLength", "Requested max. deviation from the shape; 0: none", "chord_height_asked"),
        ("MaxChordHeight", "App::PropertyLength", "Measured max. deviation from the shape", "max_chord_height"),
        properties.DEVIATION,
    )
    HIDDEN = (*mesh_object.SourceMesh.HIDDEN, properties.EXEMPT_REASONS)
    cache = None  # MeshCache of its last meshes; not saved, nor copied with the object

    def add_properties(self, obj):
        """As for all, and Reuse."""
        super().add_properties(obj)
        if properties.add_property(
                obj, "App::PropertyBool", "Reuse", "Update",
                "After an edit, faces that did not change keep their triangles, which is faster; undo gives "
                "the mesh that was there. Off: each mesh is computed from scratch, and depends on the shape "
                "and the options alone"):
            obj.Reuse = True

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """As for all, with the cache of the object."""
        work = super().work_on(sources, values, obj)
        if obj is not None and not obj.Reuse:
            work.add_to_fingerprint("from nothing")
            return work
        cache = obj.Proxy.cache if obj is not None else None
        work.compute = partial(work.compute, cache=MeshCache() if cache is None else cache)
        return work

    @classmethod
    def compute(cls, shape, values, progress, cache=None):
        """The SurfaceMesh of the shape, the Mesh.Mesh made of it, whether it was to be closed, the findings of its
        certificate, and the cache.
        """
        mesh = triangulate(shape, **values, progress=progress, cache=cache)
        closed = verdict.must_be_closed(shape)
        return mesh, mesh.to_mesh(), closed, verdict.of_triangulation(mesh, closed, values, shape), cache

    def take(self, obj, result):
        """Shows the mesh and its report."""
        *shown, self.cache = result
        mesh_cache_limit.use(self)
        return self.show(obj, *shown)


def add_quality_mesh(source, **values):
    """Adds a document object that keeps a quality mesh of `source` up to date; one undo step.

    source   document object with a shape: feature, body, link or container
    values   the options of triangulate, except progress

    Returns the object. Raises what triangulate raises, and then adds nothing.
    """
    return transactions.add_of_source(QualityMesh, source, values, "QualityMesh", "Quality mesh")
