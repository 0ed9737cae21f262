# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Improved Mesh": a mesh of the document with better triangles."""

import hashlib
import json
from functools import partial

from .. import options, phrases
from ..compat import extension
from ..core.certify import verdict
from ..core.improvement import improve
from ..core.meshes.surface_mesh import SurfaceMesh
from ..core.sources import convert
from ..errors import InvalidInput
from . import mesh_object, properties, transactions
from .recompute_work import Work


class ImprovedMesh(mesh_object.OfOneSource):
    """Proxy of a Mesh::FeaturePython that holds a better version of its source's mesh."""

    COMMAND, CALL = "MeshQuality_Improve", "add_improved_mesh"
    SOURCE, NEEDS = "The object whose mesh is improved", "a mesh"
    OPTIONS = options.IMPROVE
    MEASURED = (*properties.TOPOLOGY, *properties.ANGLES, ("Notes", "App::PropertyStringList", "Changes that were made", "notes"))
    PROMISES = mesh_object.ANGLE_PROMISES
    HIDDEN = (properties.EXEMPT_REASONS,)

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """A better version of the source's mesh."""
        mesh_object.require_source(sources, obj)
        if not convert.is_mesh(sources[0]):
            raise InvalidInput(phrases.Text(phrases.NO_MESH))
        values = options.check(cls.OPTIONS, values)
        mesh, more = convert.MeshCopy(sources[0]), cls.more_of(sources[0])
        return Work(sources, values, partial(_digest, mesh, {**values, **more}),
                    partial(cls.compute, mesh, values, **more))

    @classmethod
    def more_of(cls, source):
        """What else of a source `compute` takes, by name."""
        return {}

    @classmethod
    def compute(cls, source, values, progress):
        """The SurfaceMesh, the Mesh.Mesh made of it, whether it was to be closed, and the findings
        of its certificate.
        """
        given = SurfaceMesh(convert.surface_of_arrays(extension(), *source.arrays))
        mesh = improve(given, **values, progress=progress)
        closed = given.report.closed
        return mesh, mesh.to_mesh(), closed, verdict.of_improvement(mesh, closed, progress)

    def take(self, obj, result):
        """Shows the mesh and its report."""
        return self.show(obj, *result)


def _digest(mesh, values):
    vertices, triangles = mesh.own_arrays
    digest = hashlib.sha256(vertices.tobytes())
    digest.update(triangles.tobytes())
    digest.update(json.dumps(values, sort_keys=True).encode())
    return digest.hexdigest()


def add_improved_mesh(source, **values):
    """Adds a document object that keeps a mesh with better triangles than `source`; one undo step.

    source   document object with a mesh
    values   the options of improve, except progress

    Returns the object. Raises what improve raises, and then adds nothing.
    """
    if not convert.is_mesh(source):
        raise InvalidInput("a document object with a mesh is needed, not "
                           f"{getattr(source, 'Label', type(source).__name__)}")
    return transactions.add_of_source(ImprovedMesh, source, values, "ImprovedMesh", "Improve mesh",
                                     "improved")
