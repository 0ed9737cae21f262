# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Deviation": a scan in the colours of its deviation from a part, measured anew after each edit."""

import hashlib

import FreeCAD
import numpy as np

from .. import options, phrases
from ..compat import extension
from ..core.certify import verdict
from ..core.inspect import deviation
from ..core.meshes.surface_mesh import SurfaceMesh
from ..core.operands.operands import Operands
from ..core.operands.solid_surfaces import SolidSource
from ..core.sources import convert
from ..errors import InvalidInput
from . import boolean, mesh_object, properties
from .gui_hooks import window

_VALUES = ("Deviations", "App::PropertyFloatList", "The deviation of each triangle, mm: the largest of its corners")
_PLACES = 10


class DeviationObject(mesh_object.SegmentedMesh, boolean.MeshBoolean):
    """Proxy of a Mesh::FeaturePython that holds a scan, aligned with a part, and what was measured. Its certificate says
    whether the scan is within the tolerance.
    """

    COMMAND, CALL = "MeshQuality_Deviation", "add_deviation"
    OPTIONS = options.inspection.DEVIATION
    MEASURED = (
        *properties.TOPOLOGY,
        ("MaxDeviation", "App::PropertyLength", "The largest distance of a point, outside or inside"),
        ("Highest", "App::PropertyDistance", "The largest deviation outside"),
        ("Lowest", "App::PropertyDistance", "The largest deviation inside, below 0"),
        ("Mean", "App::PropertyDistance", "The mean of all deviations"),
        ("Rms", "App::PropertyLength", "The root mean square of all deviations"),
        ("Within", "App::PropertyFloat", "Percentage of the points within the tolerance; 100 without one"),
        ("Points", "App::PropertyInteger", "Number of points that were measured"),
        ("Places", "App::PropertyVectorList", "Where deviations are largest"),
        ("PlaceTexts", "App::PropertyStringList", "How large they are there, and the nearest CAD face"),
        ("Alignment", "App::PropertyPlacement", "The motion by which the points were aligned before"),
        ("Residual", "App::PropertyLength", "Root mean square of the distances of the points that were aligned, without outliers"),
        properties.BRIDGE,
        properties.NOTES,
    )
    PROMISES = ()
    HIDDEN = (mesh_object.FACE_RUNS, _VALUES)
    GROUP, LEAST = "Deviation", 2
    SOURCES = "The scan, a mesh or a point cloud, and the part or mesh that it is measured against"

    def has_faces(self, obj):
        """There are no patches: a scan has no faces of its own."""
        return False

    @classmethod
    def kept_length(cls, sources):
        """None: nothing is made that could deviate."""
        return None

    @classmethod
    def size_of(cls, sources):
        """The size of the part."""
        return convert.size_of(sources[-1])

    @classmethod
    def few(cls, count):
        """The Text for an object without a scan and a part."""
        return phrases.Text(phrases.DEVIATION_OF_TWO)

    @classmethod
    def called_with(cls, names):
        """The scan and the part."""
        return ", ".join(names)

    @classmethod
    def read(cls, sources):
        """The argument of compute, read from the document."""
        if None in sources:
            raise InvalidInput(phrases.Text(phrases.SOURCE_DELETED))
        return _Compared(sources)

    @classmethod
    def compute(cls, compared, values, progress):
        """(DeviationMap, Mesh.Mesh, SurfaceMesh, what is shown on its triangles, findings of its certificate)."""
        found = deviation.measured(compared.scan, compared.target(), values["tolerance"], values["align"], deviation.NO_PAIRS, progress)
        vertices, triangles, chosen = deviation.drawn(found)
        of_corners = chosen[triangles]
        worst = of_corners[np.arange(len(triangles)), np.abs(found.values[of_corners]).argmax(axis=1)]
        mesh = SurfaceMesh(extension().surface_from_arrays(vertices, triangles, found.faces[worst], True))
        return found, mesh.to_mesh(), mesh, found.values[worst], verdict.of_deviation(found)

    def take(self, obj, result):
        """Shows the scan and what was measured."""
        found, shown, mesh, values, findings = result
        finished = self.show(obj, mesh, shown, False, findings)
        places = found.worst_places(_PLACES)
        obj.MaxDeviation, obj.Highest, obj.Lowest, obj.Mean, obj.Rms = found.max_deviation, found.highest, found.lowest, \
            found.mean, found.rms
        obj.Within = 100.0 * found.within() if found.tolerance is not None else 100.0
        obj.Points, obj.Places = len(found.values), [FreeCAD.Vector(*place.point.tolist()) for place in places]
        obj.PlaceTexts = [f"{place.value:+.4g} mm" + (f" ({place.face})" if place.face else "") for place in places]
        obj.Alignment, obj.Residual = found.placement, found.alignment.rms if found.alignment is not None else 0.0
        obj.Bridge, obj.Notes, obj.Deviations = found.bridge, [*found.notes], values.tolist()
        window().show_values(obj, values, colour_limit(obj))
        return finished

    def told(self, obj):
        """How well the scan was aligned."""
        if obj.Align == "none" or not obj.Fingerprint:
            return None
        return phrases.Text(phrases.FITTED, length=f"{obj.Residual.Value:.4g} mm", count=f"{obj.Points:,}")

    def follow_label(self, obj):
        """Labels stay."""

    def onDocumentRestored(self, obj):
        """Colours are saved with the document."""
        boolean.MeshBoolean.onDocumentRestored(self, obj)


class _Compared:
    """The scan and the part of a Deviation, as they are now, for work on another thread."""

    def __init__(self, sources):
        if not deviation.has_points(sources[0]):
            raise InvalidInput(phrases.Text(phrases.POINTS_NEEDED, name=convert.label_of(sources[0])))
        self.scan = deviation.Scan(*deviation.points_of(sources[0]))
        self._label, self._reference = convert.label_of(sources[1]), Operands([sources[1]])

    def target(self):
        """The SolidSource of the part; once taken, any thread may mesh it."""
        found = SolidSource(self._reference.plain(0))
        found.label = self._label
        return found

    def digest(self):
        """A hash of both."""
        digest = hashlib.sha256(self._reference.digest().encode())
        digest.update(np.ascontiguousarray(self.scan.points))
        digest.update(np.ascontiguousarray(self.scan.triangles))
        return digest.hexdigest()


def colour_limit(obj):
    """mm: deviations beyond it are red or blue: the tolerance, else the largest deviation."""
    return obj.Tolerance.Value or obj.MaxDeviation.Value or 1.0


def is_of_points(obj):
    """Whether a document object is a Deviation with the deviations of its triangles."""
    return isinstance(getattr(obj, "Proxy", None), DeviationObject) and len(obj.Deviations) == obj.Mesh.CountFacets > 0


def add_deviation(scan, reference, tolerance=None, align="none"):
    """Adds a document object that shows a scan in the colours of its deviation from a part, and measures it again after each
    edit; one undo step.

    scan       document object with a mesh or points
    reference  document object with a shape or a mesh, of the same document
    tolerance  mm; points farther than this are reported, and red outside or blue inside
    align      "none", "near" or "any", as for deviation

    The properties MaxDeviation, Highest, Lowest, Mean, Rms, Within, Places and PlaceTexts say what was found, Alignment and
    Residual how the scan was aligned, Certificate whether all points are within the tolerance. Its mesh is the scan where it was
    measured; points are drawn as small triangles. Returns the object. Raises what deviation raises, and then adds nothing.
    """
    values = options.check(options.inspection.DEVIATION, {"tolerance": tolerance, "align": align})
    return boolean.add_of_sources(DeviationObject, [scan, reference], values, "deviation", "Deviation")
