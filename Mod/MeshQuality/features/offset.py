# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Offset": a mesh that follows a solid of the document at a distance."""

import json
from functools import partial

from .. import options, phrases
from ..core.certify import verdict
from ..core.offsetting import run_offset, tolerance_of_offset
from ..core.operands.operands import Operands
from ..core.sources import convert
from ..errors import Error, InvalidInput
from . import mesh_object, properties, transactions
from .recompute_work import Work


class SolidMesh(mesh_object.SegmentedMesh, mesh_object.OfOneSource):
    """Proxy of a Mesh::FeaturePython that holds a mesh made of a solid: of a shape, or of the space in a closed mesh.
    Triangles from a shape are assigned to its CAD faces, and to the patches of these.

    A subclass has
    given_of(source, values, obj)  class method: what the work is about, a Given
    compute(given, values, progress) -> (OffsetMesh, the Mesh.Mesh made of it, the findings of its certificate, given)
    """

    MEASURED = (
        *properties.TOPOLOGY,
        properties.VOLUME,
        ("Repaired", "App::PropertyStringList", "Repairs of the source's mesh", "repaired"),
        properties.BRIDGE,
        properties.NOTES,
    )
    PROMISES = (
        ("AskedTolerance", "App::PropertyLength", "Requested max. deviation from the exact result, in both directions",
         "tolerance_asked"),
        ("ErrorBound", "App::PropertyLength", "Proven max. deviation from the exact result, in both directions", "error_bound"),
        properties.FAULTS_LEFT,
        properties.DEVIATION,
    )
    TAKES_MESHES = True

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """The Work of making the mesh of the source with these options."""
        mesh_object.require_source(sources, obj)
        values = options.check(cls.OPTIONS, values)
        missing = next((option for option in cls.OPTIONS if option.is_required and not values[option.name]), None)
        if missing is not None:
            raise InvalidInput(phrases.Text(phrases.NOT_GIVEN, option=missing.name))
        given = cls.given_of(sources[0], values, obj)
        return Work(sources, values, partial(given.digest, values), partial(cls.compute, given, values))

    @classmethod
    def given_of(cls, source, values, obj):
        """The Given."""
        return Given(source)

    def has_faces(self, obj):
        """False if the source is a mesh, or has meshes."""
        source, = self.sources(obj)
        return convert.has_faces(source) and not convert.meshes_in(source)

    def holds_mesh(self, obj):
        """The mesh may be empty."""
        return obj.Mesh.CountFacets == obj.Triangles

    def take(self, obj, result):
        """Shows the mesh and its report."""
        mesh, shown, findings, _ = result
        return self.show(obj, mesh, shown, True, findings)


class Given:
    """The present shape or mesh of a source, for work on another thread.

    operands  Operands, of which the source is the only one
    """

    def __init__(self, source):
        self.operands = Operands([source])

    def digest(self, values):
        """A hash of the source and options; the same after saving and loading, and after a container around it was
        moved.
        """
        return self.operands.digest() + json.dumps(values, sort_keys=True)


class OffsetObject(SolidMesh):
    """Proxy of a Mesh::FeaturePython that holds its source grown or shrunk by a distance."""

    COMMAND, CALL = "MeshQuality_Offset", "add_offset"
    SOURCE, NEEDS = "The object whose solid is offset", "a shape or a mesh"
    OPTIONS = options.offset.OFFSET_OBJECT

    @classmethod
    def kept_length(cls, sources):
        """A function from options to the tolerance."""
        try:
            return tolerance_of_offset(Operands(sources))
        except Error:
            return None

    @classmethod
    def compute(cls, given, values, progress):
        """(OffsetMesh, Mesh.Mesh, findings of its certificate, given)."""
        mesh = run_offset(given.operands, values, progress)
        return mesh, mesh.to_mesh(), verdict.of_boolean(mesh), given

    def told(self, obj):
        """A Text if the offset is empty."""
        return None if obj.Triangles or not obj.Fingerprint else phrases.Text(phrases.NOTHING_LEFT)


def add_offset(source, distance, tolerance=None):
    """Adds a document object that keeps a solid of the document, grown or shrunk, up to date; one undo step.

    source     document object with a shape or a closed mesh: feature, body, mesh, link or container
    distance   mm; outward, or inward where it is below 0
    tolerance  as for offset

    Returns the object. Raises what offset raises, and then adds nothing.
    """
    return transactions.add_of_source(OffsetObject, source, {"distance": distance, "tolerance": tolerance}, "Offset", "Offset")
