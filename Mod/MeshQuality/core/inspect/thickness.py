# SPDX-License-Identifier: LGPL-2.1-or-later
"""thickness: how thick the walls of a solid are, and how wide its gaps."""

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

# The mesh of a shape is to deviate by at most this share of the thinnest wall: two sides, one percent of it together.
_SHARE = 0.005
_MOST_TRIANGLES = 200_000  # most triangles of such a finer mesh
_DECIDES = 0.4  # share of the difference of smallest thickness and limit: two sides together deviate by less than the whole
_ROUNDING = 2.0 ** -23  # share of the size: the rounding of two points to single precision
_LEAST_FINER = 0.1  # share of the deviation of a mesh: no finer mesh is proposed
_MEASURES = ((0.0, 0.3), (0.3, 0.6), (0.6, 1.0))  # shares of the progress: for each mesh, and for measuring it
_PERCENTILES = (1, 5, 25, 50, 75)
_NAMED = 10  # thin places that a text lists


@dataclass(frozen=True)
class ThinPlace:
    """A connected region of walls that are thinner than a limit.

    thickness  mm, the smallest there
    point      float64 (3,), mm, where that is
    area       mm^2, of the surface that sees the thin wall
    triangles  int32 (n,), of the mesh
    faces      names of the CAD faces that see it: ("Face3", "Face7"); empty without a shape
    """

    thickness: float
    point: np.ndarray
    area: float
    triangles: np.ndarray
    faces: tuple


class ThicknessMap(metaclass=Public):
    """The thickness of solids, seen from each triangle of their surface.

    mesh         SurfaceMesh that was measured: that of the shape, or the given one, repaired where it was dirty
    measure      "spheres" or "rays": what values and all that follows from them are
    gap          whether the gaps outside were measured, in place of the walls
    values       float64 (T,), mm, by triangle: at that of its sample points where it is smallest; infinite where nothing is
                 opposite, not a number in another body
    by_rays, by_spheres
                 float64 (T,), mm: both measures
    is_wall      bool (T,): whether two sides of a wall face each other there; elsewhere is a corner, or nothing opposite
    points       float64 (T, 3), mm: where that was measured
    opposite     int32 (T,), the triangle on the other side; -1: none
    areas        float64 (T,), mm^2, of the triangles
    minimum      mm, the smallest of values of walls; infinite where there are none
    bounds       (float, float), mm, between which the smallest thickness of the shape is there: both sides of a wall may deviate
                 by chord_height
    decided      whether min_thickness is not between these bounds: else it cannot be told whether it is met, and a note says so
    deciding_deviation
                 mm, the tolerance with which it may be told then, unless the wall is just as thick
    minimum_triangle, minimum_point, minimum_faces
                 where that is: the triangle, float64 (3,) in mm, and the names of the CAD faces on both sides, such as
                 ("Face3", "Face7"); -1, None and () where there are no walls
    min_thickness
                 mm, the limit that was given, or None
    corner_angle degrees
    chord_height mm, largest distance of the mesh from the shape; None without one. Two sides of a wall deviate by twice
                 that at most
    bridge       "live" or "stream": how the shape came from FreeCAD; empty without one
    seconds      {stage: wall-clock seconds}; cpu_seconds of all threads
    notes        sentences that a user should know

    print(result) writes a report.
    """

    __slots__ = {
        "_core": None, "_measure": None, "_surface": None, "areas": "float64 (T,), mm^2, of the triangles",
        "chord_height": "mm, largest distance of the mesh from the shape, or None", "corner_angle": "degrees",
        "cpu_seconds": "of all threads", "gap": "whether gaps were measured", "mesh": "SurfaceMesh",
        "min_thickness": "mm, or None", "notes": "sentences", "seconds": "{stage: wall-clock seconds}",
    }

    def __init__(self, core, values, chord_height, seconds, cpu_seconds):
        self._core, self._surface = core, core.surface
        self.mesh = SurfaceMesh(self._surface)
        self._measure, self.gap = values["measure"], values["gap"]
        self.min_thickness, self.corner_angle = values["min_thickness"], values["corner_angle"]
        self.chord_height, self.seconds, self.cpu_seconds = chord_height, seconds, cpu_seconds
        self.areas = tables.areas_of(self.mesh)
        self.notes = [*self.mesh.report.notes]
        if not self.decided:
            low, high = self.bounds
            self.notes.append(f"the smallest {'gap' if self.gap else 'thickness'} is {low:.4g} to {high:.4g} mm, as the mesh deviates by "
                              f"up to {chord_height:.3g} mm from the shape: whether it is below {self.min_thickness:g} mm is not known; "
                              "give a smaller tolerance")
        hidden = int(np.isnan(self.by_rays).sum())
        if hidden:
            self.notes.append(f"{hidden:,} triangles lie inside of another body of the mesh and were not measured: unite "
                              "the bodies first, by boolean")

    measure = property(lambda self: self._measure, doc='"spheres" or "rays"')
    values = property(lambda self: self._arrays[0], doc="float64 (T,), mm")
    by_rays = property(lambda self: self._core.by_rays[0], doc="float64 (T,), mm")
    by_spheres = property(lambda self: self._core.by_spheres[0], doc="float64 (T,), mm")
    points = property(lambda self: self._arrays[1] + self.mesh.origin, doc="float64 (T, 3), mm")
    opposite = property(lambda self: self._arrays[2], doc="int32 (T,)")
    is_wall = property(lambda self: self._arrays[3], doc="bool (T,)")
    bridge = property(lambda self: self.mesh.report.bridge, doc='"live", "stream" or ""')

    @property
    def _arrays(self):
        return self._core.by_rays if self._measure == "rays" else self._core.by_spheres

    def by(self, measure):
        """This map by the measure "spheres" or "rays"; nothing is computed again."""
        measure = options.inspection.THICKNESS[0].checked(measure)
        other = object.__new__(type(self))
        for name in self.__slots__:
            setattr(other, name, getattr(self, name))
        other._measure = measure
        return other

    @property
    def minimum_triangle(self):
        """The triangle where the thickness is smallest; -1: there are no walls."""
        walls = np.flatnonzero(self.is_wall)
        return int(walls[np.argmin(self.values[walls])]) if len(walls) else -1

    @property
    def minimum(self):
        """The smallest thickness of walls, mm."""
        return float(self.values[self.minimum_triangle]) if self.minimum_triangle >= 0 else float("inf")

    @property
    def bounds(self):
        """Bounds of the smallest thickness, mm, by the deviation of the mesh."""
        error = 2.0 * max(self.chord_height or 0.0, 0.0)
        return max(0.0, self.minimum - error), self.minimum + error

    @property
    def decided(self):
        """Whether the smallest thickness is below min_thickness, or is not, however its mesh deviates from the shape."""
        low, high = self.bounds
        return self.min_thickness is None or not low < self.least_allowed <= high

    @property
    def least_allowed(self):
        """min_thickness less the rounding of coordinates to single precision, mm: a wall that thick meets it. None without
        min_thickness.
        """
        if self.min_thickness is None:
            return None
        return self.min_thickness - _ROUNDING * float(np.ptp(self.mesh.vertices, axis=0).max())

    @property
    def deciding_deviation(self):
        """Deviation of a mesh, mm, that decides this, unless the wall is just as thick as min_thickness. None without
        min_thickness.
        """
        if self.min_thickness is None:
            return None
        return max(_DECIDES * abs(self.minimum - self.min_thickness), _LEAST_FINER * self.chord_height)

    @property
    def minimum_point(self):
        """The point of the smallest thickness, mm; None without walls."""
        return self.points[self.minimum_triangle] if self.minimum_triangle >= 0 else None

    @property
    def minimum_faces(self):
        """The names of the CAD faces on both sides of the thinnest wall."""
        return self.faces_at(self.minimum_triangle)

    def faces_at(self, triangle):
        """The names of the CAD faces on both sides of the wall at a triangle, ("Face3", "Face7"); one where both are the
        same, none without a shape.
        """
        if triangle < 0:
            return ()
        names = [face_name(self._surface, triangle), face_name(self._surface, int(self.opposite[triangle]))]
        return tuple(dict.fromkeys(name for name in names if name))

    def percentile(self, percent):
        """The thickness in mm below which this share of the walls' area is; a number, or an array for several.

        Raises InvalidInput for numbers out of 0 to 100.
        """
        wanted = np.asarray(percent, dtype=float)
        if not np.all((wanted >= 0.0) & (wanted <= 100.0)):
            raise InvalidInput(f"percent = {percent!r} is not allowed: it must be from 0 to 100")
        walls = np.flatnonzero(self.is_wall)
        if not len(walls):
            found = np.full(wanted.shape, np.inf)
        else:
            order = walls[np.argsort(self.values[walls], kind="stable")]
            shares = np.cumsum(self.areas[order])
            at = np.searchsorted(shares, wanted / 100.0 * shares[-1])
            found = self.values[order[np.minimum(at, len(order) - 1)]]
        return float(found) if np.ndim(percent) == 0 else found

    def histogram(self, bins=20):
        """(area of the walls' surface in mm^2 in each bin, edges of the bins in mm), as numpy.histogram has them."""
        walls = self.is_wall
        if not walls.any():
            return np.zeros(0), np.zeros(0)
        return np.histogram(self.values[walls], bins=bins, weights=self.areas[walls])

    def thin_places(self, limit=None):
        """[ThinPlace, ...]: the connected regions of walls thinner than the limit in mm, thinnest first; without one than
        min_thickness.

        Raises InvalidInput where there is no limit.
        """
        if limit is None and self.min_thickness is None:
            raise InvalidInput("limit = None is not allowed: give a length in mm, or min_thickness to thickness")
        limit = self.least_allowed if limit is None else options.inspection.THICKNESS[2].checked(limit)
        thin = np.flatnonzero(self.is_wall & (self.values < limit))
        found = []
        for triangles in tables.connected(self.mesh.triangles, thin):
            least = triangles[np.argmin(self.values[triangles])]
            names = dict.fromkeys(face_name(self._surface, int(triangle)) for triangle in triangles)
            found.append(ThinPlace(float(self.values[least]), self.points[least], float(self.areas[triangles].sum()),
                                   triangles.astype(np.int32), tuple(name for name in names if name)))
        return sorted(found, key=lambda place: place.thickness)

    def write_csv(self, path):
        """Writes a line a triangle: its number, its CAD face, both measures in mm, x, y and z of the place in mm, the face
        on the other side, whether it is a wall, and its area in mm^2. Raises IoError naming the path.
        """
        surface = self._surface
        tables.write(path, ("triangle", "face", "by_spheres", "by_rays", "x", "y", "z", "opposite_face", "is_wall", "area"),
                     ((i, face_name(surface, i) or "", f"{self.by_spheres[i]:.9g}", f"{self.by_rays[i]:.9g}",
                       *(f"{x:.9g}" for x in point), face_name(surface, across) or "", int(wall), f"{area:.9g}")
                      for i, (point, across, wall, area) in enumerate(zip(self.points.tolist(), self.opposite.tolist(),
                                                                          self.is_wall.tolist(), self.areas.tolist()))))

    def to_dict(self):
        """All but the arrays, for JSON; what is infinite is None."""
        places = self.thin_places() if self.min_thickness is not None else []
        finite = [None if not np.isfinite(value) else float(value) for value in self.percentile(list(_PERCENTILES))]
        has_walls = self.minimum_triangle >= 0
        return {
            "measure": self.measure, "gap": self.gap, "triangles": len(self.values),
            "minimum": self.minimum if has_walls else None, "bounds": list(self.bounds) if has_walls else None,
            "minimum_point": self.minimum_point.tolist() if has_walls else None,
            "minimum_faces": list(self.minimum_faces), "minimum_triangle": self.minimum_triangle,
            "percentiles": dict(zip(map(str, _PERCENTILES), finite)), "min_thickness": self.min_thickness,
            "thin_places": [{"thickness": place.thickness, "point": place.point.tolist(), "area": place.area,
                             "faces": list(place.faces)} for place in places],
            "wall_area": float(self.areas[self.is_wall].sum()), "corner_angle": self.corner_angle,
            "chord_height": self.chord_height, "bridge": self.bridge, "notes": [*self.notes], "seconds": dict(self.seconds),
            "cpu_seconds": self.cpu_seconds,
        }

    def __str__(self):
        what = "gap" if self.gap else "thickness"
        lines = [f"{what:<13}{len(self.values):,} triangles, by {self.measure}"]
        if self.minimum_triangle < 0:
            lines.append(f"minimum      none: no two sides of a {'gap' if self.gap else 'wall'} face each other")
        else:
            lines.append(f"minimum      {self.minimum:.4g} mm {_at(self.minimum_point, self.minimum_faces)}")
            other = self.by("rays" if self.measure == "spheres" else "spheres")
            if other.minimum_triangle >= 0:
                lines.append(f"  by {other.measure:<10}{other.minimum:.4g} mm {_at(other.minimum_point, other.minimum_faces)}")
            shares = ", ".join(f"{percent} % below {value:.4g}" for percent, value in
                               zip(_PERCENTILES, self.percentile(list(_PERCENTILES))))
            lines.append(f"of the area  {shares} mm")
        if self.chord_height is not None:
            lines.append(f"accuracy     the mesh deviates by at most {self.chord_height:.3g} mm from the shape")
        if self.min_thickness is not None:
            places = self.thin_places()
            count = f"{len(places)} places" if len(places) != 1 else "1 place"
            lines.append(f"below {self.min_thickness:<7.4g}{count if places else 'none'}")
            lines += [f"  {place.thickness:.4g} mm {_at(place.point, place.faces)}, {place.area:.4g} mm^2"
                      for place in places[:_NAMED]]
        return "\n".join([*lines, *(f"note         {note}" for note in self.notes)]) + "\n"

    def __repr__(self):
        least = f"{self.minimum:.4g} mm at least" if self.minimum_triangle >= 0 else "no walls"
        return f"<ThicknessMap: {len(self.values):,} triangles, {least}>"


def thickness(source, measure="spheres", gap=False, min_thickness=None, tolerance=None, spacing=None, corner_angle=45.0,
              progress=None):
    """Measures how thick the walls of solids are, by rays and by inscribed spheres at once: a ThicknessMap.

    source         Part.Shape or document object with solids; or a closed mesh: Mesh.Mesh, SurfaceMesh, arrays (V, F).
                   Meshes with small faults are repaired as operands of boolean are
    measure        what the result's values are: "spheres", the diameter of the largest ball in the solid that touches the
                   surface there, or "rays", the length along the inward normal to where the solid ends. Rays measure too
                   much where the sides of a wall are inclined; spheres measure across
    gap            measure the gaps and slots outside of each solid instead
    min_thickness  mm; walls thinner than this are reported
    tolerance      mm; largest distance of the mesh from a shape. None: a thousandth of the largest dimension, and where
                   that is more than 0.005 of the thinnest wall, or does not tell whether that is below min_thickness, the shape
                   is meshed anew, finer, up to twice
    spacing        mm; largest distance between points that are measured; None: a fiftieth of the largest dimension
    corner_angle   degrees, at most 89. A ball that touches the surface near an edge is as small as it is near: that says
                   nothing about walls. Two sides are a wall where they are inclined to each other by this angle at most.
                   Edges that are sharper count as thin
    progress       callable(fraction 0..1, stage); returning False cancels

    The solids of a shape are measured each by itself. Points are in the inside of triangles, with the normal of the smooth
    surface. Returns the same for any number of threads.
    Raises InvalidInput naming the shape or mesh, the defect and the remedy; TopologyError, GeometryError; Cancelled.
    """
    values = options.check(options.inspection.THICKNESS, {
        "measure": measure, "gap": gap, "min_thickness": min_thickness, "tolerance": tolerance, "spacing": spacing,
        "corner_angle": corner_angle})
    options.require_callable(progress)
    taken = SolidSource(source)
    if taken.shape is None:
        core = _measured(taken, None, values, progress)
        return ThicknessMap(core, values, None, dict(core.seconds), core.cpu_seconds)
    chosen, seconds, cpu_seconds = values["tolerance"] or taken.first_chord_height(), {}, 0.0
    for begin, end in ((0.0, 1.0),) if values["tolerance"] else _MEASURES:
        core = _measured(taken, chosen, values, part_of(progress, begin, end))
        more, cpu_more = _times(core)
        seconds = {stage: seconds.get(stage, 0.0) + more.get(stage, 0.0) for stage in {**seconds, **more}}
        cpu_seconds += cpu_more
        chosen = None if values["tolerance"] else _finer(core, values)
        if chosen is None:
            break
    if progress is not None:
        progress(1.0, "done")
    found = ThicknessMap(core, values, core.surface.report.max_chord_height, seconds, cpu_seconds)
    if not values["tolerance"] and found.chord_height > 2.0 * _SHARE * found.minimum:
        found.notes.append(f"the mesh deviates by more than {2.0 * _SHARE:g} of the thinnest wall, as it would have more than "
                           f"{_MOST_TRIANGLES:,} triangles: give tolerance for a finer one")
    return found


def _measured(taken, chord_height, values, progress):
    """The core's ThicknessSurface."""
    module = extension()
    surface = taken.mesh(chord_height, values["spacing"] or (taken.size / 50.0 if taken.shape is not None else None),
                         part_of(progress, 0.0, 0.6))
    core_options = module.ThicknessOptions()
    core_options.spacing = values["spacing"] or 0.0
    core_options.corner_angle, core_options.outside = values["corner_angle"], values["gap"]
    try:
        return module.measure_thickness(surface, core_options, part_of(progress, 0.6, 1.0))
    except InvalidInput as error:
        raise taken.named(error) from error


def _times(core):
    """({stage: seconds}, processor seconds), of the mesh, too."""
    report = core.surface.report
    return {**report.seconds, **core.seconds}, report.cpu_seconds + core.cpu_seconds


def _finer(core, values):
    """The distance of a finer mesh from the shape, mm, where the thinnest wall needs one; else None."""
    first = ThicknessMap(core, values, core.surface.report.max_chord_height, {}, 0.0)
    thinnest = min(first.by(measure).minimum for measure in options.inspection.THICKNESS_MEASURES)
    deviation = core.surface.report.max_chord_height
    if not np.isfinite(thinnest):
        return None
    wanted = _SHARE * thinnest
    if not first.decided:
        wanted = min(wanted, first.deciding_deviation)
    if deviation <= wanted:
        return None
    # The number of triangles of a curved surface is inversely proportional to their distance from
    # it.
    least = deviation * len(first.values) / _MOST_TRIANGLES
    wanted = max(wanted, least)
    return wanted if wanted < 0.7 * deviation else None


def _at(point, faces):
    where = f"at ({', '.join(f'{x:.4g}' for x in point)})"
    return f"{where} of {' and '.join(faces[:3])}{' and more' if len(faces) > 3 else ''}" if faces else where
