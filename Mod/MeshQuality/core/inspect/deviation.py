# SPDX-License-Identifier: LGPL-2.1-or-later
"""deviation: how far a mesh, a scan or a point cloud is from CAD or from another mesh."""

from dataclasses import dataclass

import FreeCAD
import numpy as np

from ... import options, phrases
from ...compat import extension
from ...errors import InvalidInput
from ...listing import Public
from ..meshes.surface_mesh import SurfaceMesh, surface_of
from ..operands.operands import is_arrays, part_of
from ..operands.solid_surfaces import SolidSource, is_given_mesh
from ..sources import convert, frames
from . import tables

_MESHING = 0.2  # share of the progress
_RELATIVE = 3e-4  # distance of the reference's mesh from its shape, as a fraction of the size: projections start on it
_ENOUGH_VERTICES = 1000  # a mesh with fewer is aligned by points between its vertices, too
_SPREAD_POINTS = 20_000  # number of these
_BINS = 50
_APART = 0.05  # fraction of the size of the points, by which worst places are apart
_PERCENTILES = (1, 5, 50, 95, 99)
_LISTED = 10  # places and faces in a text
_MOST_MARKS = 50_000  # points of a cloud that are drawn, each as a small triangle
_MARK = 0.004  # its size, as a fraction of that of the cloud
_PAIRS = {"pairs": 3, "3-2-1": 6}  # least number of pairs


@dataclass(frozen=True)
class DeviationPlace:
    """A place where the deviation is large.

    value   mm, signed
    point   float64 (3,), mm, where the point is once it is aligned
    index   the point's number
    face    the nearest CAD face, such as "Face3"; None without CAD
    """

    value: float
    point: np.ndarray
    index: int
    face: object


@dataclass(frozen=True)
class FaceDeviation:
    """The deviations of the points whose nearest point is on one CAD face.

    face       its name, such as "Face3"
    points     number of points
    low, high  mm, the lowest and the highest deviation, signed
    mean, rms  mm, mean and root mean square
    within     share of the points within the tolerance; None without one
    """

    face: str
    points: int
    low: float
    high: float
    mean: float
    rms: float
    within: object


@dataclass(frozen=True)
class AlignmentReport:
    """How points were aligned with the reference.

    rms             mm, root mean square of the distances of the points that were fitted, outliers left out
    used, points    number of points of the last step without outliers, and with them
    iterations      steps
    position_error  mm, standard error of the translation, by the scatter of the points
    angle_error     degrees, likewise of the rotation
    undetermined    number of motions that change no distance, such as a turn of a cylinder about its axis: these are left as they
                    were
    """

    rms: float
    used: int
    points: int
    iterations: int
    position_error: float
    angle_error: float
    undetermined: int


class DeviationMap(metaclass=Public):
    """The signed distances of points from a reference.

    values         float64 (N,), mm, by point or vertex: positive outside, negative inside
    points         float64 (N, 3), mm, where they were measured: as given, or aligned
    nearest        float64 (N, 3), mm, the nearest points of the reference
    normals        float64 (N, 3), unit vectors along which the distance grows
    faces          int32 (N,), the nearest CAD face: faces[i] is that of shape.Faces[i]; -1 without CAD
    max_deviation  mm, the largest distance, outside or inside
    tolerance      mm, the limit that was given, or None
    placement      FreeCAD.Placement that puts the points where they were measured; the identity without alignment
    alignment      AlignmentReport, or None
    by_face        [FaceDeviation, ...] in the order of faces; empty without CAD
    triangles      int32 (T, 3) of a mesh; empty for points
    exact          share of the points that are measured from the CAD surfaces themselves, or from a given mesh; the others
                   have the distance from the mesh of the shape
    bridge         "live" or "stream": how the shape came from FreeCAD; empty without one
    notes          sentences that a user should know

    print(result) writes a report.
    """

    __slots__ = {
        "_deviation": None, "values": "float64 (N,), mm", "points": "float64 (N, 3), mm", "nearest": "float64 (N, 3), mm",
        "faces": "int32 (N,)", "tolerance": "mm, or None", "alignment": "AlignmentReport, or None",
        "triangles": "int32 (T, 3)", "bridge": '"live", "stream" or ""', "notes": "sentences", "by_face": "[FaceDeviation, ...]"}

    def __init__(self, core, points, triangles, tolerance, bridge, is_aligned):
        self._deviation = core
        self.values, self.nearest, self.faces = core.values, core.nearest, core.faces
        motion = core.motion
        self.points = points @ motion[:3, :3].T + motion[:3, 3] if is_aligned else points
        self.triangles, self.tolerance, self.bridge = triangles, tolerance, bridge
        self.alignment = None
        if is_aligned:
            self.alignment = AlignmentReport(core.rms, core.used, core.fitted, core.iterations, core.shift_error,
                                             float(np.degrees(core.turn_error)), core.undetermined)
        self.notes = self._noted()
        self.by_face = self._of_faces()

    normals = property(lambda self: self._deviation.normals, doc="float64 (N, 3)")
    placement = property(lambda self: FreeCAD.Placement(FreeCAD.Matrix(*self._deviation.motion.ravel().tolist())),
                         doc="FreeCAD.Placement")
    max_deviation = property(lambda self: float(np.abs(self.values).max()), doc="mm")
    highest = property(lambda self: float(self.values.max()), doc="mm, the largest deviation outside")
    lowest = property(lambda self: float(self.values.min()), doc="mm, the largest deviation inside, negative")
    mean = property(lambda self: float(self.values.mean()), doc="mm")
    rms = property(lambda self: float(np.sqrt(np.square(self.values).mean())), doc="mm, root mean square")
    exact = property(lambda self: 1.0 - self._deviation.by_mesh / len(self.values), doc="share of the points")

    def _noted(self):
        notes = []
        if self._deviation.by_mesh:
            notes.append(f"{self._deviation.by_mesh} points have the distance from the mesh of the shape, as the search on its "
                         "surfaces found none as near")
        if self.alignment is not None and self.alignment.undetermined:
            count = self.alignment.undetermined
            notes.append(f"{count} {'motion changes' if count == 1 else 'motions change'} no distance, as a turn of a cylinder about "
                         "its axis does: there the points are as they were")
        return notes

    def _of_faces(self):
        order = np.argsort(self.faces, kind="stable")
        faces, starts = np.unique(self.faces[order], return_index=True)
        found = []
        for face, chosen in zip(faces.tolist(), np.split(order, starts[1:])):
            if face >= 0:
                values = self.values[chosen]
                found.append(FaceDeviation(
                    f"Face{face + 1}", len(values), float(values.min()), float(values.max()), float(values.mean()),
                    float(np.sqrt(np.square(values).mean())),
                    None if self.tolerance is None else float((np.abs(values) <= self.tolerance).mean())))
        return found

    def within(self, low=None, high=None):
        """The share of the points whose deviation is between two bounds, mm; without them: within the tolerance.

        Raises InvalidInput where there is neither.
        """
        if low is None and high is None:
            if self.tolerance is None:
                raise InvalidInput("there is no tolerance: give low and high, or tolerance to deviation")
            low, high = -self.tolerance, self.tolerance
        above = self.values >= (-np.inf if low is None else low)
        return float((above & (self.values <= (np.inf if high is None else high))).mean())

    def percentile(self, percents):
        """mm: the deviations below which these percentages of the points are."""
        return np.percentile(self.values, percents)

    def histogram(self, bins=_BINS):
        """(counts int64 (bins,), edges float64 (bins + 1,) in mm) of the deviations."""
        return np.histogram(self.values, bins)

    def worst_places(self, count=_LISTED):
        """[DeviationPlace, ...], the largest deviations first; each farther than a twentieth of the size from those before it.
        With a tolerance only what is beyond it.
        """
        size = np.abs(self.values)
        left = np.argsort(-size, kind="stable")
        if self.tolerance is not None:
            left = left[size[left] > self.tolerance]
        apart = _APART * float(np.ptp(self.points, axis=0).max())
        found = []
        while len(left) and len(found) < count:
            index = int(left[0])
            face = int(self.faces[index])
            found.append(DeviationPlace(float(self.values[index]), self.points[index], index, f"Face{face + 1}" if face >= 0 else None))
            left = left[np.linalg.norm(self.points[left] - self.points[index], axis=1) > apart]
        return found

    def write_csv(self, path):
        """Writes a line a point: its number, x, y, z where it was measured, its deviation in mm, and the nearest CAD face.
        Raises IoError naming the path.
        """
        tables.write(path, ("point", "x", "y", "z", "deviation", "face"),
                     ((i, f"{x:.9g}", f"{y:.9g}", f"{z:.9g}", f"{value:.9g}", f"Face{face + 1}" if face >= 0 else "")
                      for i, ((x, y, z), value, face) in enumerate(zip(self.points.tolist(), self.values.tolist(), self.faces.tolist()))))

    def to_dict(self):
        """All but the arrays, for JSON."""
        counts, edges = self.histogram()
        return {"points": len(self.values), "max_deviation": self.max_deviation, "highest": self.highest, "lowest": self.lowest,
                "mean": self.mean, "rms": self.rms, "tolerance": self.tolerance,
                "within": None if self.tolerance is None else self.within(), "exact": self.exact,
                "percentiles": dict(zip(map(str, _PERCENTILES), self.percentile(list(_PERCENTILES)).tolist())),
                "histogram": {"counts": counts.tolist(), "edges": edges.tolist()},
                "faces": [dict(vars(face)) for face in self.by_face],
                "worst_places": [{"value": place.value, "point": place.point.tolist(), "index": place.index, "face": place.face}
                                 for place in self.worst_places()],
                "placement": self._deviation.motion.tolist(),
                "alignment": None if self.alignment is None else dict(vars(self.alignment)),
                "bridge": self.bridge, "notes": [*self.notes]}

    def __str__(self):
        lines = [f"deviation    {len(self.values):,} points, {self.lowest:.4g} to {self.highest:.4g} mm",
                 f"             mean {self.mean:.4g} mm, root mean square {self.rms:.4g} mm"]
        shares = ", ".join(f"{percent} % below {value:.4g}" for percent, value in
                           zip(_PERCENTILES, self.percentile(list(_PERCENTILES))))
        lines.append(f"of points    {shares} mm")
        if self.tolerance is not None:
            lines.append(f"tolerance    {self.tolerance:.4g} mm: {100.0 * self.within():.4g} % of the points are within it")
        if self.alignment is not None:
            fit = self.alignment
            lines.append(f"alignment    root mean square {fit.rms:.4g} mm of {fit.used:,} of {fit.points:,} points, known to "
                         f"{fit.position_error:.2g} mm and {fit.angle_error:.2g} degrees")
        lines += [f"  {place.value:+.4g} mm at ({', '.join(f'{x:.4g}' for x in place.point)})" + (f" of {place.face}" if place.face else "")
                  for place in self.worst_places()]
        by_size = sorted(self.by_face, key=lambda face: -max(-face.low, face.high))
        lines += [f"  {face.face:<10} {face.low:+.4g} to {face.high:+.4g} mm, mean {face.mean:+.4g} mm, {face.points:,} points"
                  for face in by_size[:_LISTED]]
        if len(by_size) > _LISTED:
            lines.append(f"  and {len(by_size) - _LISTED} more faces")
        return "\n".join([*lines, *(f"note         {note}" for note in self.notes)]) + "\n"

    def __repr__(self):
        return f"<DeviationMap: {len(self.values):,} points, {self.max_deviation:.4g} mm at most>"


def deviation(points, reference, tolerance=None, align=False, pairs=None, scale=1.0, progress=None):
    """Measures how far points are from a shape or a mesh, with a sign: a DeviationMap.

    points     a scan: Mesh.Mesh, SurfaceMesh, arrays (V, F), a Points.Points, a document object of these, or an array (N, 3)
    reference  Part.Shape or document object with a shape: distances are from its faces, exact; or a mesh
    tolerance  mm; points farther than this, outside or inside, are reported
    align      False: points are measured where they are; True or "any": they are fitted to the reference from any pose;
               "near": from where they are; "pairs": from the pose that pairs say; "3-2-1": to six pairs, of which the first
               points come to lie on the reference, three on one face, two on another, one on a third
    pairs      [((x, y, z) of the scan, (x, y, z) of the reference), ...], mm, for these
    scale      factor of the coordinates of the points: 25.4 where they are inches, 1000 for metres
    progress   callable(fraction 0..1, stage); returning False cancels

    The sign is positive outside. Where the nearest point is on an edge, the normals of its faces decide. Fits are by least
    squares along the normals; points farther off than three standard deviations are left out of it, but measured.
    Raises InvalidInput naming what was given and the remedy, also where an alignment does not converge or ends farther off
    than a fiftieth of the size; TopologyError, GeometryError; Cancelled.
    """
    how = {False: "none", True: "any", None: "none"}.get(align, align) if isinstance(align, (bool, type(None))) else align
    values = options.check(options.inspection.DEVIATION, {
        "tolerance": tolerance, "align": "near" if how in _PAIRS else how})
    options.require_callable(progress)
    ends = _ends_of(pairs, how)
    label, given, triangles = points_of(points)
    given = given * _scale_of(scale)
    return measured(Scan(label, given, triangles), SolidSource(reference), values["tolerance"], how, ends, progress)


@dataclass(frozen=True)
class Scan:
    """The points that are measured: how errors call them, float64 (N, 3) in mm, and int32 (T, 3), empty for points."""

    label: str
    points: np.ndarray
    triangles: np.ndarray


def measured(scan, target, tolerance, how, ends, progress):
    """The DeviationMap of a Scan from a SolidSource; any thread may call it. `ends` are two arrays of pairs."""
    points = scan.points
    if not len(points) or not np.isfinite(points).all():
        raise InvalidInput(phrases.Text(phrases.POINTS_NO_NUMBERS if len(points) else phrases.NO_POINTS, name=scan.label))
    surface = target.mesh(None if target.shape is None else _RELATIVE * target.size, None, part_of(progress, 0.0, _MESHING))
    module = extension()
    kind = {"3-2-1": "three_two_one"}.get(how, how)
    try:
        core = module.measure_deviation(points, surface, target.shape, getattr(module.Align, kind), *ends,
                                        _fitted(points, scan.triangles), part_of(progress, _MESHING, 1.0))
    except InvalidInput as error:
        raise target.named(error) from error
    if how != "none" and not core.converged:
        raise InvalidInput(phrases.Text(phrases.NOT_ALIGNED, name=scan.label, name2=target.label, count=str(core.iterations),
                                        length=f"{core.rms:.4g} mm"))
    bridge = surface.report.bridge if target.shape is not None else ""
    return DeviationMap(core, points, scan.triangles, tolerance, bridge, how != "none")


NO_PAIRS = (np.zeros((0, 3)), np.zeros((0, 3)))


def drawn(found):
    """What is drawn of a DeviationMap: float64 (V, 3), int32 (T, 3), and int (V,), the point of each vertex. Of a cloud these are
    small triangles across the normals, of the worst point and others spread evenly.
    """
    if len(found.triangles):
        return found.points, found.triangles, np.arange(len(found.points))
    count = len(found.points)
    chosen = np.unique(np.append(np.linspace(0, count - 1, min(count, _MOST_MARKS)).astype(int), np.abs(found.values).argmax()))
    points, normals = found.points[chosen], found.normals[chosen]
    axis = np.eye(3)[np.abs(normals).argmin(axis=1)]
    first = np.cross(normals, axis)
    first /= np.linalg.norm(first, axis=1)[:, None]
    second = np.cross(normals, first)
    size = _MARK * max(float(np.ptp(found.points, axis=0).max()), 1e-6)
    corners = np.stack([points + size * (np.cos(angle) * first + np.sin(angle) * second)
                        for angle in 2.0 * np.pi * np.arange(3) / 3.0], axis=1)
    triangles = np.arange(3 * len(chosen), dtype=np.int32).reshape(-1, 3)
    return corners.reshape(-1, 3), triangles, np.repeat(chosen, 3)


def has_points(source):
    """Whether a document object, or a path to one, is a mesh or a point cloud."""
    return convert.is_mesh(source) or hasattr(getattr(frames.leaf_of(source), "Points", None), "CountPoints")


def points_of(source):
    """(how errors call it, float64 (N, 3) in mm, int32 (T, 3), empty for points) of what deviation takes as points."""
    nothing = np.zeros((0, 3), np.int32)
    if isinstance(source, np.ndarray) or isinstance(source, (list, tuple)) and not is_arrays(source) and not frames.is_object(source):
        points = np.asarray(source, dtype=np.float64)
        if points.ndim != 2 or points.shape[1] != 3:
            raise InvalidInput(f"an array (N, 3) of points is needed, not one of shape {points.shape}")
        return "the array", points, nothing
    if is_given_mesh(source):
        surface = surface_of(source)
        label = "the mesh" if is_arrays(source) or isinstance(source, SurfaceMesh) else convert.label_of(source)
        return label, surface.vertices + surface.origin, np.array(surface.triangles)
    leaf = frames.leaf_of(source) if frames.is_object(source) else source
    cloud = leaf if hasattr(leaf, "CountPoints") else getattr(leaf, "Points", None)
    if hasattr(cloud, "CountPoints"):
        points = np.array([tuple(point) for point in cloud.Points]).reshape(-1, 3)
        if frames.is_object(source):
            points = convert.moved(points, frames.frame_of(source))
        return convert.label_of(source) if frames.is_object(source) else "the point cloud", points, nothing
    raise InvalidInput(f"a mesh, points or an array (N, 3) are needed, not {type(source).__name__}: take a shape as the reference")


def _ends_of(pairs, how):
    """The two arrays (n, 3) of pairs of points, empty where none are needed."""
    if how not in _PAIRS:
        if pairs is not None:
            raise InvalidInput(f'pairs have no effect with align={how!r}: give align="pairs" or "3-2-1"')
        return NO_PAIRS
    try:
        ends = np.array(pairs, dtype=np.float64)
    except (TypeError, ValueError):
        ends = np.zeros(0)
    least = _PAIRS[how]
    if ends.ndim != 3 or ends.shape[1:] != (2, 3) or len(ends) < least or not np.isfinite(ends).all():
        raise InvalidInput(f"align={how!r} needs {least} pairs or more, [((x, y, z), (x, y, z)), ...]: a point of the scan and where it "
                           "belongs on the reference")
    return ends[:, 0], ends[:, 1]


def _scale_of(scale):
    if isinstance(scale, (int, float)) and np.isfinite(scale) and scale > 0.0:
        return float(scale)
    raise InvalidInput(f"scale = {scale!r} is not allowed: give a number above 0, such as 25.4 for inches")


def _fitted(points, triangles):
    """float64 (n, 3): the points by which a coarse mesh is aligned, between its vertices, too; none: all of its vertices."""
    if not len(triangles) or len(points) >= _ENOUGH_VERTICES:
        return np.zeros((0, 3))
    corners = points[triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    ends = np.cumsum(areas)
    at = (np.arange(_SPREAD_POINTS) + 0.5) / _SPREAD_POINTS * ends[-1]
    chosen = np.minimum(np.searchsorted(ends, at), len(ends) - 1)
    # Fractions of multiples of the plastic number are spread evenly over a square.
    first, second = np.arange(_SPREAD_POINTS) * 0.7548776662466927 % 1.0, np.arange(_SPREAD_POINTS) * 0.5698402909980532 % 1.0
    root = np.sqrt(first)
    weights = np.stack([1.0 - root, root * (1.0 - second), root * second], axis=1)
    return np.concatenate([points, np.einsum("ni,nij->nj", weights, corners[chosen])])
