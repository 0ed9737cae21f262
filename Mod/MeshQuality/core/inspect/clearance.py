# SPDX-License-Identifier: LGPL-2.1-or-later
"""clearance: how near the bodies of an assembly are to each other."""

from dataclasses import dataclass

import numpy as np

from ... import options
from ...compat import extension
from ...errors import InvalidInput
from ...listing import Public
from ..meshes.surface_mesh import SurfaceMesh
from ..operands.operands import is_arrays, part_of
from ..operands.solid_surfaces import SolidSource, face_name
from ..sources import convert, frames

_MESHING = 0.5  # of the progress
_ROUNDING = 1e-7  # fraction of the size of the bodies, below which two lengths are the same
_MOST_FACE_PAIRS = 16  # that are measured by OpenCASCADE for one pair of bodies
_LISTED = 20  # pairs in a text
# Surfaces between which OpenCASCADE finds the smallest distance for certain, and at once.
_ELEMENTARY = ("Plane", "Cylinder", "Cone", "Sphere", "Toroid")
APART, TOUCHING, OVERLAPPING, INSIDE, EQUAL = "apart", "touching", "overlapping", "inside", "equal"
COMMON = (OVERLAPPING, INSIDE, EQUAL)  # relations of bodies with a volume in common
_WHOLE = 0.01  # fraction of a body's volume that its mesh's deviation may at most take from what another contains of it


@dataclass(frozen=True)
class BodyPair:
    """How near two bodies are to each other.

    bodies        their names
    relation      "apart"; "touching": they meet, but not deeper than the meshes are exact; "overlapping"; "inside": one lies
                  in the other, also where it meets its surface; "equal": they are one body twice
    distance      mm, of their surfaces; 0 where they touch or overlap, which includes distances of a tenth of a millionth of
                  their size
    lower, upper  mm, bounds of the distance of the shapes: it is between them
    method        "OpenCASCADE": exact, by the surfaces of the shapes; "mesh": that of the meshes, exact for these
    points        float64 (3,), mm, one on each body
    faces         the names of the CAD faces there, one of each body, or None
    depth         mm, how deep points of the one mesh lie in the other body, where they meet; where only faces meet, the mean
                  thickness of what both have in common
    common_volume mm3, of what both have in common, where their surfaces meet; 0 otherwise; None where it is not known
    inner         the name of the body inside of the other; None otherwise
    """

    bodies: tuple
    relation: str
    distance: float
    lower: float
    upper: float
    method: str
    points: tuple
    faces: tuple
    depth: float
    common_volume: object
    inner: object


class ClearanceReport(metaclass=Public):
    """The distances of the bodies of an assembly.

    bodies         their names
    pairs          [BodyPair, ...], nearest first
    min_clearance  mm, the limit that was given, or None
    within         mm; pairs farther apart were left out; None: none was
    bridge         "live" or "stream": how the shapes came from FreeCAD; empty without any
    notes          sentences that a user should know
    """

    __slots__ = {"bodies": "names", "pairs": "[BodyPair, ...]", "min_clearance": "mm, or None", "within": "mm, or None",
                 "bridge": '"live", "stream" or ""', "notes": "sentences"}

    def __init__(self, bodies, pairs, values, bridge, notes):
        self.bodies, self.bridge, self.notes = tuple(bodies), bridge, notes
        rank = {OVERLAPPING: 0, EQUAL: 0, TOUCHING: 1}
        self.pairs = sorted(pairs, key=lambda pair: (rank.get(pair.relation, 2), pair.distance))
        self.min_clearance, self.within = values["min_clearance"], values["within"]

    @property
    def minimum(self):
        """The smallest distance, mm; infinite without pairs."""
        return min((pair.distance for pair in self.pairs), default=float("inf"))

    @property
    def too_near(self):
        """The pairs that are nearer than min_clearance, or have a volume in common."""
        return [pair for pair in self.pairs
                if pair.relation in COMMON or pair.distance < (self.min_clearance or 0.0)]

    def to_dict(self):
        """All of it, for JSON."""
        return {"bodies": list(self.bodies), "minimum": self.minimum if self.pairs else None,
                "min_clearance": self.min_clearance, "within": self.within, "bridge": self.bridge,
                "pairs": [{"bodies": list(pair.bodies), "relation": pair.relation, "distance": pair.distance,
                           "lower": pair.lower, "upper": pair.upper, "method": pair.method,
                           "points": [point.tolist() for point in pair.points], "faces": list(pair.faces),
                           "depth": pair.depth, "common_volume": pair.common_volume, "inner": pair.inner} for pair in self.pairs],
                "notes": [*self.notes]}

    def __str__(self):
        count = len(self.pairs)
        lines = [f"clearance    {len(self.bodies)} bodies, {count} pair{'' if count == 1 else 's'}"]
        lines += [_line(pair) for pair in self.pairs[:_LISTED]]
        if count > _LISTED:
            lines.append(f"  and {count - _LISTED} more")
        return "\n".join([*lines, *(f"note         {note}" for note in self.notes)]) + "\n"

    def __repr__(self):
        least = f", {self.minimum:.4g} mm at least" if self.pairs else ""
        return f"<ClearanceReport: {len(self.bodies)} bodies, {len(self.pairs)} pairs{least}>"


def clearance(bodies, min_clearance=None, within=None, tolerance=None, progress=None):
    """The smallest distance between each two bodies, with both places: a ClearanceReport.

    bodies         a list of two or more shapes, document objects or meshes; {name: body, ...}; or one shape or document
                   object with several solids, each of which is a body
    min_clearance  mm; pairs nearer than this are reported as too near
    within         mm; pairs farther apart are left out, which is faster
    tolerance      mm; largest distance of the meshes from the shapes; None: a thousandth of the size of each
    progress       callable(fraction 0..1, stage); returning False cancels

    Shapes are meshed; the distances of the meshes are exact, those of the shapes are between `lower` and `upper`. Where all
    faces that may be nearest are planes, cylinders, cones, spheres or tori, OpenCASCADE measures between these, and the
    distance is that of the shapes: `method` says which.
    Raises InvalidInput naming the body and the remedy; TopologyError, GeometryError; Cancelled.
    """
    values = options.check(options.inspection.CLEARANCE, {
        "min_clearance": min_clearance, "within": within, "tolerance": tolerance})
    options.require_callable(progress)
    named = _bodies_of(bodies)
    made = []
    for i, body in enumerate(named):
        part = part_of(progress, _MESHING * i / len(named), _MESHING * (i + 1) / len(named))
        made += body.surfaces(values["tolerance"], part)
    if len(made) < 2:
        raise InvalidInput("clearance is between two bodies or more: give a list of them, or a shape with several solids")
    core = extension().measure_clearances(
        [body.surface for body in made], [2.0 * body.deviation for body in made],
        float("inf") if values["within"] is None else values["within"], part_of(progress, _MESHING, 1.0))
    pairs = [_pair_of(one, *(made[i] for i in one.bodies)) for one in core]
    notes = [note for body in named for note in body.notes]
    bridge = next((body.bridge for body in named if body.bridge), "")
    return ClearanceReport([body.name for body in made], pairs, values, bridge, notes)


@dataclass
class _Body:
    """A body that was meshed. `shape` has the faces by which its triangles are numbered; None of a mesh."""

    name: str
    surface: object
    shape: object
    deviation: float
    size: float


class _Given:
    """A body as it was given, or a shape of several."""

    def __init__(self, source, name, divided):
        self._source, self._name, self._divided = SolidSource(source), name, divided
        self._source.label = name
        self.bridge, self.notes = "", []

    def surfaces(self, tolerance, progress):
        """[_Body, ...]"""
        source = self._source
        if source.shape is None:
            surface = source.mesh(None, None, progress)
            if not surface.report.closed:
                self.notes.append(f"{self._name} is not closed: whether others lie in it is not known")
            return [_body(self._name, surface, None, 0.0)]
        surface = source.mesh(tolerance or source.first_chord_height(), None, progress)
        self.bridge = surface.report.bridge
        deviation = max(surface.report.max_chord_height, 0.0)
        if not self._divided:
            return [_body(self._name, surface, source.shape, deviation)]
        whole = SurfaceMesh(surface)
        return [_body(f"Solid{i + 1}", whole.of_solid(i)._surface, source.shape, deviation)
                for i in np.unique(whole.triangle_solid).tolist() if i >= 0]


def _body(name, surface, shape, deviation):
    points = surface.vertices
    return _Body(name, surface, shape, deviation, float(np.ptp(points, axis=0).max()) if len(points) else 0.0)


def _bodies_of(bodies):
    """[_Given, ...]"""
    if isinstance(bodies, dict):
        return [_Given(body, str(name), False) for name, body in bodies.items()]
    if isinstance(bodies, list) or isinstance(bodies, tuple) and not is_arrays(bodies) and not frames.is_object(bodies):
        names = [getattr(frames.object_of(body), "Label", None) or f"Body{i + 1}" for i, body in enumerate(bodies)]
        return [_Given(body, name if names.count(name) == 1 else f"{name} ({i + 1})", False)
                for i, (body, name) in enumerate(zip(bodies, names))]
    return [_Given(bodies, convert.label_of(bodies) if not is_arrays(bodies) else "the mesh", True)]


def _pair_of(core, first, second):
    """The BodyPair of what the core has found."""
    deviation = first.deviation + second.deviation
    rounding = _ROUNDING * max(first.size, second.size)
    places = _facing(core, first, second, rounding)
    distance, triangles, points = places[0]
    names = tuple(face_name(body.surface, triangle) for body, triangle in zip((first, second), triangles))
    known = core.common_volume >= 0.0
    thickness = 2.0 * core.common_volume / core.common_area if core.common_area > 0.0 else 0.0
    found = {"bodies": (first.name, second.name), "points": points, "faces": names, "depth": max(core.depth, thickness),
             "common_volume": core.common_volume if known else None, "inner": None}
    if distance == 0.0 and found["depth"] > deviation + rounding:
        relation, found["inner"] = _containing(core.common_volume, first, second, deviation + rounding)
        return BodyPair(relation=relation, distance=0.0, lower=0.0, upper=0.0, method="mesh", **found)
    near = distance
    exact = _exact(places, first, second, deviation + rounding)
    if exact is not None:
        near, found["points"], found["faces"] = exact
        distance = near if near > rounding else 0.0
    relation = INSIDE if core.inside >= 0 else TOUCHING if distance == 0.0 else APART
    if relation == INSIDE:
        found["inner"] = found["bodies"][core.inside]
    bounds = (distance, near) if exact is not None else (max(0.0, distance - deviation), distance + deviation)
    return BodyPair(relation=relation, distance=distance, lower=bounds[0], upper=bounds[1],
                    method="mesh" if exact is None else "OpenCASCADE", **found)


def _containing(volume, first, second, deviation):
    """The relation of bodies that overlap by what they have in common, mm3, and the name of the one inside."""
    reports = {body.name: body.surface.report for body in (first, second)}
    whole = [name for name, own in reports.items()
             if volume >= own.volume - min(deviation * own.area, _WHOLE * own.volume)]
    return {0: OVERLAPPING, 1: INSIDE, 2: EQUAL}[len(whole)], whole[0] if len(whole) == 1 else None


def _facing(core, first, second, rounding):
    """What the core has found by pairs of faces, nearest first; of pairs that are as near those that face each other, such as
    the sides of a gap and not the faces around them.
    """
    least = core.nearest[0]

    def order(place):
        distance, triangles, points = place
        along = points[1] - points[0]
        faces_each_other = sum(abs(float(_normal(body.surface, triangle) @ along))
                               for body, triangle in zip((first, second), triangles))
        return (distance, 0.0) if distance > least + rounding else (least, -faces_each_other)

    return sorted(core.faces, key=order)


def _normal(surface, triangle):
    a, b, c = surface.vertices[surface.triangles[triangle]]
    normal = np.cross(b - a, c - a)
    return normal / (np.linalg.norm(normal) or 1.0)


def _exact(near, first, second, within):
    """(distance, points, names of the faces) by OpenCASCADE between the faces that may be nearest; None where it cannot
    tell for certain.
    """
    if first.shape is None or second.shape is None or len(near) > _MOST_FACE_PAIRS:
        return None
    found = None
    for _, triangles, _ in near:
        names = [face_name(body.surface, triangle) for body, triangle in zip((first, second), triangles)]
        if None in names:
            return None
        faces = [body.shape.getElement(name) for body, name in zip((first, second), names)]
        if not all(type(face.Surface).__name__ in _ELEMENTARY for face in faces):
            return None
        distance, places, _ = faces[0].distToShape(faces[1])
        if places and (found is None or distance < found[0] * (1.0 - _ROUNDING)):
            found = distance, tuple(np.array(place) for place in places[0]), tuple(names)
    # What differs from the meshes by more than they deviate is not trusted.
    return found if found is not None and abs(found[0] - near[0][0]) <= within else None


def _line(pair):
    names = " and ".join(f"{body}{f' {face}' if face else ''}" for body, face in zip(pair.bodies, pair.faces))
    where = " - ".join(f"({', '.join(f'{x:.4g}' for x in point)})" for point in pair.points)
    common = f", {pair.common_volume:.4g} mm3 in common" if pair.common_volume else ""
    if pair.relation == OVERLAPPING:
        return f"  overlap    {names}, {pair.depth:.3g} mm deep{common} at {where}"
    if pair.relation == EQUAL:
        return f"  equal      {' and '.join(pair.bodies)}: one body twice{common}"
    if pair.relation == INSIDE and pair.distance == 0.0:
        return f"  inside     {names}: {pair.inner} lies inside and meets the surface{common} at {where}"
    if pair.relation == TOUCHING:
        return f"  touch      {names} at {where}"
    exact = "exact" if pair.method != "mesh" else f"{pair.lower:.4g} to {pair.upper:.4g}"
    inner = f", {pair.inner} lies inside" if pair.inner else ""
    return f"  {pair.distance:.4g} mm ({exact})  {names}{inner}, {where}"
