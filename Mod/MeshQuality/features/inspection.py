# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Inspection": the walls, clearances, draft or voids of a solid, measured anew after each edit."""

import math

import FreeCAD
import numpy as np

from .. import options, phrases
from ..compat import extension
from ..core.certify import verdict
from ..core.inspect.clearance import APART, COMMON, TOUCHING, clearance
from ..core.inspect.draft import draft
from ..core.inspect.thickness import thickness
from ..core.inspect.voids import voids
from ..core.meshes.surface_mesh import SurfaceMesh
from . import mesh_object, offset, properties, transactions
from .gui_hooks import window

# The checks that give it; name, type, what it says.
RESULTS = (
    (("thickness", "clearance"), "Minimum", "App::PropertyLength",
     "Smallest thickness, gap or clearance; 0 also where no two sides face each other"),
    (options.inspection.CHECKS, "Faces", "App::PropertyStringList",
     "CAD faces where the minimum is, with too little draft or undercuts, or of voids"),
    (("thickness", "clearance", "voids"), "Places", "App::PropertyVectorList",
     "Where walls below the limit are thinnest, without a limit the thinnest one; one point on each of the two solids of "
     "each line of Pairs; the centres of voids"),
    (("clearance",), "Pairs", "App::PropertyStringList",
     "Pairs of solids that are too near or overlap, without a limit all, and how near: those that overlap, then the nearest "
     "ones, then those that touch"),
    (("thickness", "clearance", "voids"), "Count", "App::PropertyInteger",
     "Number of places below the limit (a wall has two sides), of pairs of solids that are too near or overlap, of voids"),
    (("draft",), "LowDraftArea", "App::PropertyArea", "Area with less draft than the limit"),
    (("draft",), "UndercutArea", "App::PropertyArea", "Area that neither half of the mould can leave"),
    (("voids",), "VoidVolume", "App::PropertyVolume", "Volume of all voids"),
)
_MOST_PAIRS = 500  # that are listed
_NO_MESH = (np.zeros((0, 3)), np.zeros((0, 3), np.int32), np.zeros(0, np.int32), True)


class Inspection(offset.SolidMesh):
    """Proxy of a Mesh::FeaturePython that holds the mesh on which its source was measured, and what was found there. Its
    certificate says whether the limits are met.
    """

    COMMAND, CALL = "MeshQuality_Inspect", "add_inspection"
    SOURCE, NEEDS = "The object that is measured", "a shape or a mesh"
    OPTIONS = options.inspection.INSPECTION_OBJECT
    MEASURED = (*properties.TOPOLOGY, *(row[1:] for row in RESULTS),
                properties.BRIDGE, properties.NOTES)
    PROMISES = ()

    @classmethod
    def compute(cls, given, values, progress):
        """What was found, the Mesh.Mesh on which, the findings of its certificate, and {property: value}."""
        measure, options, findings, results = _CHECKS[values["check"]]
        found = measure(given.operands.plain(0), **{option.name: values[option.name] for option in options}, progress=progress)
        mesh = getattr(found, "mesh", None) or SurfaceMesh(extension().surface_from_arrays(*_NO_MESH))
        return found, mesh, mesh.to_mesh(), findings(found), results(found)

    def take(self, obj, result):
        """Shows the mesh and what was found."""
        found, mesh, shown, findings, results = result
        finished = self.show(obj, mesh, shown, False, findings)
        for checks, name, kind, _ in RESULTS:
            given = obj.Check in checks
            setattr(obj, name, results[name] if given else _NOTHING.get(kind, 0.0))
            obj.setEditorMode(name, 1 if given else 2)
        obj.Notes = list(found.notes)
        window().show_values(obj, np.where(found.is_wall, found.values, np.inf) if obj.Check == "thickness" else None)
        return finished

    def told(self, obj):
        """The minimum, where the certificate does not say it."""
        if "Minimum" not in _given_by(obj.Check) or not obj.Fingerprint or not verdict.is_met(obj.Certificate):
            return None
        if not obj.Places:
            return phrases.Text(phrases.NO_WALLS)
        is_wall = obj.Check == "thickness" and not obj.Gap
        return phrases.Text(phrases.SMALLEST_WALL if is_wall else phrases.SMALLEST_GAP, length=f"{obj.Minimum.Value:.4g} mm")


_NOTHING = {"App::PropertyStringList": [], "App::PropertyVectorList": [], "App::PropertyInteger": 0}


def _given_by(check):
    return {name for checks, name, *_ in RESULTS if check in checks}


def _length(value):
    return value if math.isfinite(value) else 0.0


def _vectors(points):
    return [FreeCAD.Vector(*map(float, point)) for point in points]


def _of_thickness(found):
    thin = found.thin_places() if found.min_thickness is not None else []
    places = [place.point for place in thin] or [found.minimum_point] * (found.minimum_triangle >= 0)
    return {"Minimum": _length(found.minimum), "Faces": list(found.minimum_faces), "Places": _vectors(places),
            "Count": len(thin)}


def _of_clearance(found):
    nearest = found.pairs[0] if found.pairs else None
    told = found.pairs if found.min_clearance is None else found.too_near
    # Parts that touch by design come last: they would hide those that are too near.
    told = sorted(told, key=lambda pair: (pair.relation not in COMMON, pair.relation == TOUCHING, pair.distance))[:_MOST_PAIRS]
    return {"Minimum": _length(found.minimum), "Count": len(found.too_near), "Pairs": list(map(_pair_text, told)),
            "Faces": [face for face in nearest.faces if face] if nearest else [],
            "Places": _vectors(point for pair in told or found.pairs[:1] for point in pair.points)}


def _pair_text(pair):
    how = f"{pair.distance:.4g} mm" if pair.relation == APART else pair.relation
    faces = ", ".join(filter(None, pair.faces))
    return f"{how}: {pair.bodies[0]}, {pair.bodies[1]}" + (f" ({faces})" if faces else "")


def _of_draft(found):
    return {"LowDraftArea": found.low_area, "UndercutArea": found.undercut_area,
            "Faces": [face.face for face in found.faces if face.low_area > 0.0 or face.undercut_area > 0.0]}


def _of_voids(found):
    return {"VoidVolume": found.void_volume, "Count": len(found.voids), "Places": _vectors(void.center for void in found.voids),
            "Faces": [face for void in found.voids for face in void.faces]}


_PULL = next(option for option in options.inspection.INSPECTION_OBJECT if option.name == "pull_direction")
# The function, its options, the findings of what it returns, and the properties of that.
_CHECKS = {
    "thickness": (thickness, options.inspection.THICKNESS, verdict.of_thickness, _of_thickness),
    "clearance": (clearance, (options.inspection.CLEARANCE[0], options.inspection.CLEARANCE[-1]), verdict.of_clearance,
                  _of_clearance),
    "draft": (draft, (_PULL, *options.inspection.DRAFT), verdict.of_draft, _of_draft),
    "voids": (voids, options.inspection.VOIDS, verdict.of_voids, _of_voids),
}


def add_inspection(source, check="thickness", **values):
    """Adds a document object that measures a solid of the document again after each edit; one undo step.

    source  document object with a shape or a closed mesh: feature, body, mesh, link or container
    check   "thickness", "clearance" (of the solids of a shape to each other), "draft" or "voids"
    values  options of the function of that name: measure, gap, min_thickness, spacing, corner_angle; min_clearance;
            pull_direction ("x", "-x" ... "-z") and min_draft; tolerance. Those of other checks have no effect

    The properties Minimum, Places, Faces, Count, LowDraftArea, UndercutArea and VoidVolume say what was found, Certificate
    whether the limit is met, CertificateFaces where not. Its mesh is the one that was measured, for the quality view.
    Returns the object. Raises what the function raises, and then adds nothing.
    """
    return transactions.add_of_source(Inspection, source, {"check": check, **values}, "Inspection", "Inspection")
