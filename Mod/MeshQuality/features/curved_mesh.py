# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Curved Mesh": curved elements that follow a shape of the document.

Its Mesh is what the elements look like, cut into flat triangles; the elements themselves are kept
in hidden properties, so that an opened document can write them without curving anew.
"""

from dataclasses import dataclass
from functools import partial

from .. import options
from ..compat import property_of
from ..core.certify import verdict
from ..core.curving import ARRAYS, CurvedMesh, curve, lists_of, loader_of, store_in
from ..core.sources import convert
from . import mesh_object, properties, transactions
from .gui_hooks import window

# Of every mesh of curved elements: name, type, what it says, where the report has it.
MEASURED = (
    ("Elements", "App::PropertyInteger", "Number of tetrahedra, or of triangles without a volume",
     "elements"),
    ("Vertices", "App::PropertyInteger", "Number of corners of elements", "vertices"),
    ("InvalidBefore", "App::PropertyInteger", "Number of invalid elements before repair",
     "invalid_before"),
    ("InvalidElements", "App::PropertyStringList", "Which elements are invalid",
     "invalid_elements"),
    ("MinScaledJacobian", "App::PropertyFloat",
     "Smallest Jacobian of all elements, each against that of its straight element: 1 is best, "
     "0 or less is invalid", "min_scaled_jacobian"),
    ("MinDistortion", "App::PropertyFloat",
     "Smallest ratio of the least to the largest Jacobian of one element: 1 is best, 0 or less is "
     "invalid", "min_distortion"),
    ("MeanDistortion", "App::PropertyFloat", "Mean of that ratio over the elements",
     "mean_distortion"),
    ("MaxShapeDistortion", "App::PropertyFloat",
     "Largest deviation of an element from equal sides and angles: 1 is ideal, 5 is poor, infinite: "
     "folded", "max_shape_distortion"),
    ("MaxDeviation", "App::PropertyLength", "Max. deviation of the elements from the shape",
     "max_deviation"),
    ("RmsDeviation", "App::PropertyLength", "Root mean square of that deviation", "rms_deviation"),
    ("CurvedIntersections", "App::PropertyInteger", "Number of pairs of curved triangles that cross", "curved_intersections"),
    ("NotProvenApart", "App::PropertyInteger",
     "Number of pairs of curved triangles that are neither proven to cross nor to be apart, as where bodies touch",
     "not_proven_apart"),
    ("EnclosedVolume", "App::PropertyVolume", "Volume that the elements enclose", "volume"),
    ("VolumeError", "App::PropertyFloat",
     "Relative error of that volume against the volume of the shape; -1: the shape has none",
     "volume_error"),
    ("Straightened", "App::PropertyStringList",
     "Elements that were straightened, as they stayed invalid", "straightened"),
    ("MovedVertices", "App::PropertyInteger", "Number of corners that repairs moved", "moved_vertices"),
    ("Repairs", "App::PropertyStringList", "Kinds of repairs, and the number of each", "repairs"),
    properties.BRIDGE,
    properties.NOTES,
)
# Properties of promises, beside mesh_object.PROMISES.
PROMISES = (
    ("Invalid", "App::PropertyInteger",
     "Number of elements that are not proven valid; 0 is required", "invalid"),
    properties.DEVIATION,
)


class CurvedMeshObject(mesh_object.SourceMesh):
    """Proxy of a Mesh::FeaturePython that holds curved elements on its source's shape."""

    COMMAND, CALL = "MeshQuality_Curve", "add_curved_mesh"
    OPTIONS = options.CURVE + options.CURVED_DISPLAY
    PRESETS = options.CURVE_PRESETS
    BOUND_BEFORE = options.RELATIVE
    PROMISES, MEASURED = PROMISES, MEASURED
    HIDDEN = (
        *mesh_object.SourceMesh.HIDDEN,
        ("ElementsOrder", "App::PropertyInteger", "Order of the stored elements"),
        ("ElementsFingerprint", "App::PropertyString", "Digest of the source and the options of the elements"),
        ("ShownDeviation", "App::PropertyLength", "Max. deviation of the triangles shown from the elements"),
        *((name, "App::PropertyFloatList", f"The array {array} of the elements, row by row")
          for name, array in ARRAYS.items()),
    )

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """As in the base class; where the deviation alone has changed, the elements are cut anew only."""
        work = super().work_on(sources, values, obj)
        own = convert.own_shape_of(sources[0])
        work.compute = partial(work.compute, digest=partial(_elements_fingerprint, own, {**work.values, "size_field": work.size_digests}),
                               draw=window().drawing())
        if obj is not None and obj.ElementsFingerprint and obj.Certificate != verdict.UNKNOWN:
            work.compute = partial(work.compute, held=(obj.ElementsFingerprint, loader_of(obj)))
        return work

    @classmethod
    def compute(cls, shape, values, progress, digest, draw, held=None):
        """The Result; `digest` gives the fingerprint of the elements, `held` are the fingerprint of
        elements that there are already and what makes them, `draw` is what makes the drawing, if anything.
        """
        fingerprint = digest()
        kept = held is not None and held[0] == fingerprint
        curved = held[1]() if kept \
            else curve(shape, **_elements_values(values), progress=progress)
        tessellation = curved.tessellate(values["deviation"], progress)
        proof = None if kept else Proof(curved, shape, values)
        surface = tessellation.surface()
        return Result(curved, fingerprint, tessellation.deviation,
                      convert.mesh_of_surface(surface),
                      mesh_object.runs_of_faces(surface.triangle_face), proof,
                      {} if kept else lists_of(curved),
                      draw(tessellation, curved.shown_quality) if draw else None)

    def frame_of_result(self, obj, work, result):
        """Elements that were kept are where they were computed."""
        return work.frame if result.proof is not None else property_of(obj, "SourceFrame")

    def take(self, obj, result):
        """Shows the elements and their report; those that were kept have been shown before."""
        if result.proof is not None:
            store_in(obj, result.curved, result.lists)
            result.proof.show(obj)
            obj.ElementsFingerprint = result.fingerprint
        obj.ShownDeviation, obj.FaceRuns = result.deviation, result.face_runs
        self.drawing = result.drawing
        properties.show_mesh(obj, result.mesh)
        self.drawing = None
        return None if result.proof is None else (result.curved.report, result.proof.findings)


@dataclass(frozen=True)
class Result:
    """The result of a curved mesh object.

    curved       CurvedMesh
    fingerprint  of its elements
    deviation    of the flat triangles that are shown of it, mm
    mesh         the Mesh.Mesh of those
    face_runs    for the property FaceRuns
    proof        of elements that are new
    lists        of elements that are new, for the document
    drawing      for the 3D view; None without one
    """

    curved: CurvedMesh
    fingerprint: str
    deviation: float
    mesh: object
    face_runs: list
    proof: object
    lists: dict
    drawing: object


class Proof:
    """The parts of the certificate of a CurvedMesh: its report, the topology of its corners, and the findings."""

    def __init__(self, curved, shape, values):
        self.report = curved.report
        self.topology = verdict.topology_of_corners(curved)
        self.closed = verdict.must_be_closed(shape)
        self.findings = verdict.of_curved(curved, self.closed, values, self.topology, shape)

    def show(self, obj):
        """Fills the groups Quality and Certificate."""
        properties.show_report(obj, (*MEASURED, *PROMISES), self.report)
        mesh_object.show_certificate(obj, self.topology, self.closed, self.findings)


def _elements_values(values):
    """The options on which the elements depend."""
    return {name: value for name, value in values.items() if name != "deviation"}


def _elements_fingerprint(shape, values):
    return mesh_object.fingerprint_of(shape, _elements_values(values))


def add_curved_mesh(source, **values):
    """Adds a document object that keeps a curved mesh of `source` up to date; one undo step.

    source   document object with a shape: feature, body, link or container
    values   the options of curve, except progress, and deviation: the largest distance in mm of
             the triangles that the object shows from its curved elements

    Returns the object; CurvedMesh.of(object) are its elements. Raises what curve raises, and then
    adds nothing.
    """
    return transactions.add_of_source(CurvedMeshObject, source, values, "CurvedMesh", "Curved mesh")
