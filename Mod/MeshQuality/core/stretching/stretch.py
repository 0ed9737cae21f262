# SPDX-License-Identifier: LGPL-2.1-or-later
"""stretched: the triangles of a quality mesh, made to follow a metric."""

import numpy as np

from ...compat import extension
from ...errors import Cancelled, InvalidInput
from ..meshes.surface_mesh import SurfaceMesh
from ..places.entities import Entities
from ..places.places import Places, unfit
from .cad_pairs import CadPairs
from .collapses import Collapses
from .faults import Faults
from .limits import LONGEST, Limits
from .moves import Moves
from .swaps import Swaps
from .triangles import SCORE, Triangles, edge_keys, score
from .widths import at_borders

LARGEST_ANGLE = 150.0  # degrees
QUALITY = 0.3  # in the metric
_STEPS = 1.0, 1.0, 1.2, LONGEST  # edges shorter than these in the metric are collapsed, one step after the other
_REPAIRS = 4  # rounds for what is left beyond the largest angle or below the quality
_LONGEST_LOW = 2.0  # in the metric, the longest edge that may come from such a round
_FIRST = 170.0, 155.0, LARGEST_ANGLE  # degrees in the first step, until no angle above the largest one is left
_ROUNDS = 7  # in which what is around triangles at fault stays as it was
_SHARE = 0.98  # of the largest distance that triangles keep by their corners
_NAMED = 5  # faces in a note
_COSINE = np.cos(np.radians(LARGEST_ANGLE))
_PLANE = "Part::GeomPlane"


class StretchedMesh(SurfaceMesh):
    """A SurfaceMesh whose triangles follow a metric.

    largest_angle   degrees, of all triangles
    metric_quality  float64 (T,): 4 sqrt(3) area / (sum of squared sides) in the metric; 1: equilateral; nan where the quality mesh stayed
    given_triangles how many the quality mesh had that it was made of
    """

    __slots__ = {"given_triangles": "of the quality mesh before", "largest_angle": "degrees", "metric_quality": "float64 (T,), 1 at most"}


def stretched(mesh, shape, metric, progress=None):
    """The StretchedMesh of a SurfaceMesh of a shape, and sentences about promises that it does not keep.

    metric  one of forms
    Raises InvalidInput naming the option that does not go with a metric; Cancelled.
    """
    reasons = unfit(mesh)
    if reasons:
        raise InvalidInput(f"metric needs triangles that lie on single whole faces: {'; '.join(reasons)}")
    surface, triangles, names = _without_faults(mesh, shape, metric, progress)
    if surface is None:
        found = _finished(mesh._surface, mesh, None)
        return found, ["the triangles are those of the quality mesh: stretched ones would be too far from the shape, or cross"]
    found = _finished(surface, mesh, triangles)
    low = int((found.metric_quality < QUALITY).sum())
    said = [f"{low} triangles have a quality below {QUALITY} in the metric, the least is {found.metric_quality.min():.3f}"] if low else []
    if names:
        listed = ", ".join(names[:_NAMED]) + (f" and {len(names) - _NAMED} more faces" if len(names) > _NAMED else "")
        said.append(f"on {listed} some triangles keep equal sides, as stretched ones would be too far from the shape, or cross")
    if found.largest_angle > LARGEST_ANGLE + 0.01:
        said.append(f"the largest angle is {found.largest_angle:.2f} degrees")
    return found, said


def _without_faults(mesh, shape, metric, progress):
    """(core's Surface, Triangles, names of faces that keep triangles); None thrice: all would have to keep them.

    Every round begins with the triangles of equal sides, and those around the faults of earlier rounds stay. So what fails in one place
    changes nothing elsewhere.
    """
    asked, first = mesh.report.chord_height_asked, 0
    held = np.zeros(len(mesh.vertices), dtype=bool)
    faults = Faults(mesh, Places(mesh, Entities(shape)), asked)
    for wide in range(_ROUNDS):
        triangles = _changed(mesh, shape, metric, _SHARE * (asked or np.inf), _FIRST[first], held, _poll(progress))
        while first + 1 < len(_FIRST) and triangles.measures.cosine.min() < _COSINE:
            first += 1
            triangles = _changed(mesh, shape, metric, _SHARE * (asked or np.inf), _FIRST[first], held, _poll(progress))
        points, corners = _numbered(mesh, triangles)
        crossing, at_fault = faults.crossing(points, corners, triangles.face)
        surface = _surface(mesh, shape, triangles, points, corners, len(crossing), progress)
        rows = np.concatenate([at_fault.ravel(), faults.too_far(surface, shape, progress)])
        if not len(rows):
            break
        held |= faults.held(points + mesh.origin, corners, triangles.face, rows, wide)
    if len(rows) or _worse(surface.report, mesh.report):
        return None, None, None
    return surface, triangles, [f"Face{face + 1}" for face in sorted(faults.said)]


def _finished(surface, mesh, triangles):
    found = StretchedMesh(surface, None, mesh._overlap, mesh._construction)
    found.given_triangles = len(mesh.triangles)
    corners = found.vertices[found.triangles]
    sides = np.roll(corners, -1, axis=1) - corners
    lengths = np.linalg.norm(sides, axis=2)
    cosines = -np.einsum("tij,tij->ti", sides, np.roll(sides, 1, axis=1)) / np.maximum(lengths * np.roll(lengths, 1, axis=1), 1e-300)
    found.largest_angle = float(np.degrees(np.arccos(np.clip(cosines.min(initial=1.0), -1.0, 1.0))))
    found.metric_quality = np.full(len(mesh.triangles), np.nan) if triangles is None else triangles.measures.quality
    return found


def _poll(progress):
    def poll():
        if progress is not None and progress(0.5, "stretching triangles") is False:
            raise Cancelled()
    return poll


def _changed(mesh, shape, metric, distance, first, held, poll):
    """The Triangles of a mesh, changed; first: degrees, the largest angle in the first step; held: bool by vertex."""
    places = Places(mesh, Entities(shape))
    corners = places.corners.astype(np.int64)
    pairs = CadPairs(places, corners)
    segments, tangents, bent = _segments(places)
    rows = metric.at(places.points[pairs.vertex], pairs.normals, pairs.curvatures)
    rows = _with_edges(rows, metric, pairs, segments, tangents, bent)
    _fill_poles(rows, pairs, corners)
    triangles = Triangles(places.points, places.entity, pairs, rows, corners, segments, tangents, held)
    _within_faces(triangles, metric, places.entities.edges_of_face)
    verify = None
    if np.isfinite(distance) and any(surface.TypeId != _PLANE for surface in places.entities.surfaces):
        verify = _Verifier(shape, mesh.report.chord_height_asked).too_far
    limits = Limits(np.cos(np.radians(first)), distance, QUALITY, verify)
    collapses, swaps, moves = Collapses(triangles, limits), Swaps(triangles, limits), Moves(triangles, limits, metric.at)
    for shorter in _STEPS:
        collapses.run(shorter, poll)
        limits.cosine = _COSINE
        swaps.run(poll)
        moves.run(1, poll)
    for _ in range(_REPAIRS):
        if score(triangles.measures).min() >= SCORE:
            break
        collapses.run(_LONGEST_LOW, poll, low=True)
        swaps.run(poll)
        moves.run(1, poll, low=True)
    return triangles


class _Verifier:
    """Measures new triangles against the shape itself."""

    def __init__(self, shape, distance):
        self._shape, self._distance = shape, distance

    def too_far(self, triangles, corners, group, groups, moved=None):
        """Whether a centre or the middle of a side of each group of new triangles is too far; moved: as in Triangles.measured."""
        vertices = triangles.pairs.vertex[corners]
        points = triangles.points[vertices]
        if moved is not None:
            points[np.arange(len(corners)), moved[0]] = moved[1]
        keys = edge_keys(vertices, np.roll(vertices, -1, axis=1), len(triangles.points)).ravel()
        _, first, side = np.unique(keys, return_index=True, return_inverse=True)
        middles = ((points + np.roll(points, -1, axis=1)) / 2.0).reshape(-1, 3)[first]
        found = extension().distances_to_faces(self._shape, np.concatenate([points.mean(axis=1), middles]), None)
        count = len(corners)
        largest = np.maximum(found[:count], found[count:][side.reshape(-1)].reshape(-1, 3).max(axis=1))
        return np.bincount(group, largest > self._distance, groups) > 0


def _worse(new, old):
    return old.closed and not new.closed or new.degenerate_triangles > old.degenerate_triangles


def _numbered(mesh, triangles):
    """(float64 (V, 3) beside the origin of the mesh, int32 (T, 3)): the points in use, and the triangles of them."""
    used, numbers = np.unique(triangles.vertices, return_inverse=True)
    return np.float32(triangles.points[used] - mesh.origin).astype(np.float64), numbers.reshape(-1, 3).astype(np.int32)


def _surface(mesh, shape, triangles, points, corners, crossings, progress):
    """The core's Surface of the triangles."""
    face, solid_of = triangles.face, np.full(int(mesh.triangle_face.max()) + 1, -1, dtype=np.int32)
    solid_of[mesh.triangle_face] = mesh.triangle_solid
    entity = np.ascontiguousarray(triangles.entity[np.unique(triangles.vertices)], dtype=np.int32)
    return extension().with_triangles(mesh._surface, points, corners, face.astype(np.int32), solid_of[face], entity, shape,
                                      mesh.report.chord_height_asked, crossings, progress)


def _with_edges(rows, metric, pairs, segments, tangents, bent):
    """Metrics that know the curvature of the edges of the shape, too."""
    order = np.argsort(pairs.vertex, kind="stable")
    vertex = pairs.vertex[order]
    for end in (0, 1):
        low, high = (np.searchsorted(vertex, segments[:, end], side) for side in ("left", "right"))
        for step in range(int((high - low).max(initial=0))):
            there = low + step < high
            at = order[(low + step)[there]]
            rows[at] = metric.along_edges(rows[at], tangents[there, end], bent[there, end])
    return rows


def _within_faces(triangles, metric, edges_of_face):
    """Changes the metrics of triangles to such that know how wide the faces are at their borders."""
    rows, across, widths = at_borders(triangles, edges_of_face)
    while len(rows):  # a vertex has several segments: one of them at a time
        now, first = np.unique(rows, return_index=True)
        triangles.metric[now] = metric.across_faces(triangles.metric[now], across[first], widths[first])
        rows, across, widths = (np.delete(values, first, axis=0) for values in (rows, across, widths))
    triangles.measures = triangles.measured(triangles.corners)


def _fill_poles(rows, pairs, corners):
    """Where a face has no normal its metric is the mean of those of the other corners around."""
    for pair in np.flatnonzero(pairs.irregular).tolist():
        around = np.unique(corners[(corners == pair).any(axis=1)])
        around = around[~pairs.irregular[around]]
        if len(around):
            rows[pair] = rows[around].mean(axis=0)


def _segments(places):
    """Segments (S, 3): two vertices and their edge; unit tangents (S, 2, 3) and curvatures (S, 2), for each mm, at the two ends."""
    entities, entity = places.entities, places.entity
    inner_of = [[] for _ in entities.edges]
    for v in np.flatnonzero(entity[:, 0] == 1).tolist():
        inner_of[entity[v, 1]].append(v)
    corner = _corners_of_shape(places)
    segments, tangents, bent = [], [], []
    for number, (edge, inner) in enumerate(zip(entities.edges, inner_of)):
        if edge.Degenerated:
            continue
        ends = entities.ends_of_edge[number]
        inner.sort(key=lambda v: places.share[v])
        chain = [corner[ends[0]], *inner, corner[ends[-1]]]
        low, high = edge.ParameterRange
        at = [low + share * (high - low) for share in (0.0, *places.share[inner].tolist(), 1.0)]
        along, curved = zip(*(_direction(edge, t) for t in at))
        for k in range(len(chain) - 1):
            segments.append((chain[k], chain[k + 1], number))
            tangents.append(along[k:k + 2])
            bent.append(curved[k:k + 2])
    return np.array(segments, dtype=np.int64).reshape(-1, 3), np.array(tangents).reshape(-1, 2, 3), np.array(bent).reshape(-1, 2)


def _direction(edge, parameter):
    """(unit tangent, curvature) of an edge; that of its chord where the curve has none."""
    try:
        found = *edge.tangentAt(parameter), edge.curvatureAt(parameter)
    except Exception:  # noqa: BLE001  FreeCAD raises errors of several kinds where the derivative is zero
        found = (np.nan,)
    if not np.isfinite(found).all():
        low, high = edge.ParameterRange
        chord = edge.valueAt(high) - edge.valueAt(low)
        found = *(chord / max(chord.Length, 1e-300)), 0.0
    return found[:3], found[3]


def _corners_of_shape(places):
    """The vertex of the mesh at each vertex of the shape; several of these may have one, where they lie in one place."""
    there = np.flatnonzero(places.entity[:, 0] == 0)
    found = dict(zip(places.entity[there, 1].tolist(), there.tolist()))
    for number, vertex in enumerate(places.entities.vertices):
        if number not in found and len(there):
            found[number] = int(there[np.argmin(np.linalg.norm(places.points[there] - np.array(vertex.Point), axis=1))])
    return found
