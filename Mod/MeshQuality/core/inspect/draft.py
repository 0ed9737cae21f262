# SPDX-License-Identifier: LGPL-2.1-or-later
"""draft: how the surface of a solid leaves a mould that opens along a direction."""

from dataclasses import dataclass

import numpy as np

from ... import options
from ...compat import extension
from ...errors import InvalidInput
from ...listing import Public
from ..meshes.surface_mesh import SurfaceMesh
from ..operands.operands import part_of
from ..operands.solid_surfaces import SolidSource, face_name
from . import tables

_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
_UNDERCUT = 0  # the core's number of a release that is an undercut
_MESHING = 0.6  # share of the progress
_LISTED = 20  # faces in a text
_PER_DIMENSION = 50.0  # least number of edges along the largest dimension


@dataclass(frozen=True)
class FaceDraft:
    """The draft of a CAD face.

    face           its name, such as "Face3"
    area           mm^2
    min_draft      degrees, the smallest draft of its triangles, whichever half of the mould forms them
    low_area       mm^2 with less draft than min_draft of the report
    undercut_area  mm^2 that neither half of the mould can leave
    """

    face: str
    area: float
    min_draft: float
    low_area: float
    undercut_area: float


class DraftMap(metaclass=Public):
    """The draft of each triangle of a surface against a pull direction.

    mesh            SurfaceMesh that was measured
    pull_direction  float64 (3,), of length 1
    angles          float64 (T,), degrees between the surface and the pull: 90 where it faces along it, 0 on walls along it,
                    -90 where it faces against it
    release         int8 (T,): 1: the half of the mould that opens along the pull can leave the triangle, 2: the other one can,
                    3: either; 0: neither, it is an undercut
    areas           float64 (T,), mm^2, of the triangles
    min_draft       degrees, the bound that was given
    faces           [FaceDraft, ...] by CAD face in their order; empty without a shape
    low_area, undercut_area
                    mm^2 with less draft than min_draft, and of undercuts
    exact_normals   share of the triangles whose normal is that of the CAD face; the others have that of the triangle
    bridge          "live" or "stream": how the shape came from FreeCAD; empty without one
    notes           sentences that a user should know
    """

    __slots__ = {"_core": None, "mesh": "SurfaceMesh", "pull_direction": "float64 (3,)", "areas": "float64 (T,), mm^2",
                 "min_draft": "degrees", "faces": "[FaceDraft, ...]", "notes": "sentences"}

    def __init__(self, core, pull, min_draft):
        self._core, self.mesh = core, SurfaceMesh(core.surface)
        self.pull_direction, self.min_draft = pull / np.linalg.norm(pull), min_draft
        self.areas, self.notes = tables.areas_of(self.mesh), [*self.mesh.report.notes]
        self.faces = self._by_face()

    angles = property(lambda self: self._core.angles, doc="float64 (T,), degrees")
    release = property(lambda self: self._core.release, doc="int8 (T,)")
    is_low = property(lambda self: np.abs(self.angles) < self.min_draft, doc="bool (T,): less draft than min_draft")
    is_undercut = property(lambda self: self.release == _UNDERCUT, doc="bool (T,): neither half can leave it")
    low_area = property(lambda self: float(self.areas[self.is_low].sum()), doc="mm^2")
    undercut_area = property(lambda self: float(self.areas[self.is_undercut].sum()), doc="mm^2")
    exact_normals = property(lambda self: self._core.exact_normals / max(1, len(self.areas)), doc="share of the triangles")
    bridge = property(lambda self: self.mesh.report.bridge, doc='"live", "stream" or ""')

    def _by_face(self):
        faces = self.mesh.triangle_face
        low, undercut, steepness = self.is_low, self.is_undercut, np.abs(self.angles)
        found = []
        for face in np.unique(faces[faces >= 0]).tolist():
            there = faces == face
            found.append(FaceDraft(f"Face{face + 1}", float(self.areas[there].sum()), float(steepness[there].min()),
                                   float(self.areas[there & low].sum()), float(self.areas[there & undercut].sum())))
        return found

    def write_csv(self, path):
        """Writes a line a triangle: its number, its CAD face, its draft in degrees, its release, its area in mm^2. Raises
        IoError naming the path.
        """
        surface = self._core.surface
        tables.write(path, ("triangle", "face", "draft", "release", "area"),
                     ((i, face_name(surface, i) or "", f"{angle:.9g}", release, f"{area:.9g}") for i, (angle, release, area)
                      in enumerate(zip(self.angles.tolist(), self.release.tolist(), self.areas.tolist()))))

    def to_dict(self):
        """All but the arrays, for JSON."""
        return {"pull_direction": self.pull_direction.tolist(), "min_draft": self.min_draft, "triangles": len(self.areas),
                "area": float(self.areas.sum()), "low_area": self.low_area, "undercut_area": self.undercut_area,
                "exact_normals": self.exact_normals, "bridge": self.bridge,
                "faces": [{"face": face.face, "area": face.area, "min_draft": face.min_draft, "low_area": face.low_area,
                           "undercut_area": face.undercut_area} for face in self.faces], "notes": [*self.notes]}

    def __str__(self):
        whole = float(self.areas.sum()) or 1.0
        pull = ", ".join(f"{x:.4g}" for x in self.pull_direction)
        lines = [f"draft        {len(self.areas):,} triangles, pull direction ({pull})",
                 f"low          {self.low_area:.4g} mm^2 below {self.min_draft:g} degrees, {100 * self.low_area / whole:.3g} %",
                 f"undercuts    {self.undercut_area:.4g} mm^2, {100 * self.undercut_area / whole:.3g} %"]
        bad = sorted((face for face in self.faces if face.low_area or face.undercut_area),
                     key=lambda face: -max(face.undercut_area, face.low_area))
        lines += [f"  {face.face:<10} {face.min_draft:.3g} degrees at least, low {face.low_area:.4g} mm^2, undercut "
                  f"{face.undercut_area:.4g} mm^2" for face in bad[:_LISTED]]
        if len(bad) > _LISTED:
            lines.append(f"  and {len(bad) - _LISTED} more faces")
        return "\n".join([*lines, *(f"note         {note}" for note in self.notes)]) + "\n"

    def __repr__(self):
        return f"<DraftMap: {len(self.areas):,} triangles, {self.undercut_area:.4g} mm^2 of undercuts>"


def draft(source, pull_direction="z", min_draft=1.0, tolerance=None, progress=None):
    """Measures the draft of a solid against the direction in which a mould opens, and its undercuts: a DraftMap.

    source          Part.Shape or document object; or a closed mesh: Mesh.Mesh, SurfaceMesh, arrays (V, F), repaired where
                    it has small faults
    pull_direction  (x, y, z), or "x", "-z" and so on: one half of the mould opens along it, the other one against it
    min_draft       degrees, the draft that walls should have
    tolerance       mm; largest distance of the mesh from a shape; None: a thousandth of the largest dimension
    progress        callable(fraction 0..1, stage); returning False cancels

    Of a shape the normals are those of its faces, exact. A triangle is an undercut where a ray from its middle, along the
    pull if it faces that way, else against it, meets the solid again; solids of one shape are in each other's way.
    Raises InvalidInput naming the shape or mesh, the defect and the remedy; TopologyError, GeometryError; Cancelled.
    """
    values = options.check(options.inspection.DRAFT, {"min_draft": min_draft, "tolerance": tolerance})
    options.require_callable(progress)
    pull = direction_of(pull_direction)
    taken = SolidSource(source)
    max_edge = None if taken.shape is None else taken.size / _PER_DIMENSION
    chord_height = None if taken.shape is None else values["tolerance"] or taken.first_chord_height()
    surface = taken.mesh(chord_height, max_edge, part_of(progress, 0.0, _MESHING))
    # Facets of a wall along the pull lie in front of each other by twice the deviation at most.
    offset = max(0.0, 2.0 * surface.report.max_chord_height)
    try:
        core = extension().measure_draft(surface, taken.shape, pull.tolist(), offset, part_of(progress, _MESHING, 1.0))
    except InvalidInput as error:
        raise taken.named(error) from error
    return DraftMap(core, pull, values["min_draft"])


def direction_of(given, name="pull_direction"):
    """float64 (3,) of a direction, which the error calls by the name of an argument; raises InvalidInput."""
    found = given
    if isinstance(given, str):
        axis = given.strip().lower().lstrip("+")
        sign, axis = (-1.0, axis[1:]) if axis.startswith("-") and axis[1:] in _AXES else (1.0, axis)
        found = [sign * x for x in _AXES[axis]] if axis in _AXES else given.split(",")
    try:
        found = np.array([float(x) for x in found])
    except (TypeError, ValueError):
        found = np.zeros(0)
    if found.shape != (3,) or not np.isfinite(found).all() or not found.any():
        raise InvalidInput(f"{name} = {given!r} is not allowed: give three numbers such as (0, 0, 1), or one of x, y, z, "
                           "-x, -y, -z")
    return found
