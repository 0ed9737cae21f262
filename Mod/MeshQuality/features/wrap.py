# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Wrap": a closed mesh around objects of the document."""

from .. import options, phrases
from ..core.certify import verdict
from ..core.patches.source_faces import FacesOfSeveral
from ..core.wrapping import Wrapped, run
from ..errors import InvalidInput
from . import boolean, mesh_object, properties


class WrapObject(mesh_object.SegmentedMesh, boolean.MeshBoolean):
    """Proxy of a Mesh::FeaturePython that holds the outer surface of its sources. Its triangles are on the CAD faces on which
    they lie, and in their patches.
    """

    COMMAND, CALL = "MeshQuality_Wrap", "add_wrap"
    OPTIONS = options.wrap.WRAP_OBJECT
    MEASURED = (
        *properties.TOPOLOGY,
        properties.VOLUME,
        ("GapTriangles", "App::PropertyInteger", "Number of triangles that close gaps", "gap_triangles"),
        ("GapArea", "App::PropertyArea", "Area of the triangles that close gaps", "gap_area"),
        ("DistanceToInput", "App::PropertyLength", "Largest distance of the wrap from what it lies on, but for gaps",
         "distance_to_input"),
        ("DistanceFromInput", "App::PropertyLength", "Largest distance from the wrap of what sticks out of it",
         "distance_from_input"),
        properties.BRIDGE,
        properties.NOTES,
    )
    PROMISES = (
        ("AskedTolerance", "App::PropertyLength", "Requested max. deviation of the wrap from what it lies on", "tolerance_asked"),
        ("ErrorBound", "App::PropertyLength", "Max. deviation: the larger one of both distances, with that of the meshes of shapes",
         "error_bound"),
        properties.FAULTS_LEFT,
        properties.DEVIATION,
    )
    GROUP, LEAST = "Wrap", 1
    SOURCES = "The objects that are wrapped, with a mesh or a shape"

    @classmethod
    def kept_length(cls, sources):
        """The options say it."""
        return None

    @classmethod
    def few(cls, count):
        """What is said of no source, a Text."""
        return phrases.Text(phrases.NO_SOURCES)

    @classmethod
    def read(cls, sources):
        """What compute takes, read from the document."""
        return Wrapped(sources)

    @classmethod
    def compute(cls, wrapped, values, progress):
        """The WrapMesh, the Mesh.Mesh made of it, and the findings of its certificate."""
        if values["gap"] is None:
            raise InvalidInput(phrases.Text(phrases.NOT_GIVEN, option="gap"))
        mesh = run(wrapped, {**values, "threads": 0}, progress)
        return mesh, mesh.to_mesh(), verdict.of_boolean(mesh)

    def faces(self, obj):
        """Those of all sources."""
        return FacesOfSeveral(self.sources(obj))

    def holds_mesh(self, obj):
        """Older versions did not keep the faces of the triangles."""
        return super().holds_mesh(obj) and bool(obj.FaceRuns or not obj.Triangles)

    def follow_label(self, obj):
        """It has one operation."""


def add_wrap(objects, gap, tolerance=None):
    """Adds a document object that keeps the outer surface of document objects up to date; one undo step.

    objects    a document object with a mesh or a shape, or a list of them, of one document
    gap        mm; openings narrower than this are closed
    tolerance  as for wrap

    Returns the object. Raises what wrap raises, and then adds nothing.
    """
    sources = list(objects) if isinstance(objects, list) else [objects]
    if not sources:
        raise InvalidInput("the list of objects is empty")
    values = options.check(options.wrap.WRAP_OBJECT, {"gap": gap, "tolerance": tolerance})
    if values["gap"] is None:
        raise InvalidInput(phrases.Text(phrases.NOT_GIVEN, option="gap"))
    return boolean.add_of_sources(WrapObject, sources, values, "wrap", "Wrap")
