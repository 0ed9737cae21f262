# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a mesh is as far from its CAD faces as a certificate says: an independent check of what the core measures.

The points of each triangle that were measured are projected onto the shape by OpenCASCADE itself, without any of the
classification that the measures rest on: the shape is not farther from them than the face that they were measured from. Some triangles are compared with the very face that they are said to be
on. The grids of points of the CAD faces and edges that the certificate names are evaluated by FreeCAD, and their distances from
the mesh measured by nearest_on_mesh.
"""

import FreeCAD
import numpy as np

from ...compat import extension
from ..elements import lagrange
from . import nearest_on_mesh

_STEPS = 7  # steps of the lattice of points of a triangle; its corners are not measured
_OWN = [(i + 0.5) / 9 for i in range(9)]  # places along each parameter at which faces and edges must have been measured
_MOST_POINTS = 1_000_000
_EXACT, _NOTHING = 1e-6, 1e-7  # allowed difference of distances at the same points: of the distance, and of the size of the mesh
_COMPARED = 500  # triangles that are compared with their own face
_NEARLY_FOLDED = 0.5  # cosine to the normal of the CAD face below which a triangle may be said to fold over it
_ELSEWHERE = 1e-3  # share of the size: a surface that is nowhere farther from the shape counts as on it
_NAMED = 3
_MIDDLE = (2 / 7, 2 / 7, 0.0)  # a measured point
_AROUND = [(i / 4 + 1 / 12, j / 4 + 1 / 12, 0.0) for i in range(4) for j in range(4 - i)]  # points of triangles that turn far


def faults_of(shape, nodes, rows, said, proven, progress=None):
    """Sentences on distances in a certificate that do not hold."""
    if len(said.get("face", ())) != len(rows) or len(said.get("deviation", ())) != len(rows):
        return [f"the certificate says max_deviation = {proven['max_deviation']!r}, but does not list the CAD face and the "
                f"distance of each of the {len(rows):,} triangles of the surface"]
    claimed, faces = np.array(said["deviation"], dtype=float), np.array(said["face"], dtype=int)
    if faces.max(initial=-1) >= len(shape.Faces):
        return [f"the certificate names Face{faces.max() + 1}, but the shape has {len(shape.Faces):,} faces"]
    found, size = [], float(np.ptp(nodes[rows], axis=(0, 1)).max())
    if not claimed.max(initial=0.0) - 1e-8 <= _number(proven["max_deviation"]) <= claimed.max(initial=0.0):
        found.append(f"the certificate says max_deviation = {proven['max_deviation']!r}, but the largest that it lists is "
                     f"{claimed.max(initial=0.0)!r}")
    allowed = (1.0 + _EXACT) * claimed + _NOTHING * size
    distance = _distances(shape, nodes, rows, progress)
    _name(found, distance > allowed, "is {:.3g} mm from the shape, more than the certificate says", distance)
    compared = np.unique(np.linspace(0, len(rows) - 1, min(_COMPARED, len(rows))).astype(int))
    own, cosine = _own_faces(shape, nodes, rows[compared], faces[compared], _MIDDLE)
    folded = np.zeros(len(rows), dtype=bool)
    if "folded_on_cad" not in said:
        return [*found, "the certificate does not list the triangles that fold over their CAD face"]
    listed = np.array(said["folded_on_cad"], dtype=int)
    if listed.max(initial=-1) >= len(rows) or len(np.unique(listed)) != _number(proven["folded_on_cad"]):
        return [*found, f"the certificate says folded_on_cad = {proven['folded_on_cad']!r}, but lists {len(listed):,} such triangles"]
    folded[listed] = True
    wrong = np.zeros(len(rows), dtype=bool)
    wrong[compared] = own > allowed[compared]
    distance[compared] = own
    _name(found, wrong, "is {:.3g} mm from the CAD face that the certificate says it is on", distance)
    least = np.ones(len(rows))
    least[compared] = cosine
    turning = np.unique(np.concatenate([np.array(said.get("turning", []), dtype=int), listed]))
    for place in _AROUND if len(turning) else ():
        least[turning] = np.minimum(least[turning], _own_faces(shape, nodes, rows[turning], faces[turning], place)[1])
    _name(found, ~folded & (least < 0.0), "is turned against its CAD face, which the certificate says it follows", distance)
    _name(found, folded & (least > _NEARLY_FOLDED), "is said to fold over its CAD face, but no such place was found", distance)
    return found


def _number(value):
    return value if isinstance(value, (int, float)) and not isinstance(value, bool) else -1.0


def _name(found, wrong, text, values):
    for i in np.flatnonzero(wrong)[:_NAMED]:
        found.append(f"triangle {i} of the surface {text.format(values[i])}")
    if wrong.sum() > _NAMED:
        found.append(f"and {int(wrong.sum()) - _NAMED:,} more triangles likewise")


def _lattice(steps):
    return np.array([(i / steps, j / steps, 0.0) for i in range(steps + 1) for j in range(steps + 1 - i)])


def _points(nodes, rows, at):
    """float64 (F, n, 3): points of each triangle."""
    return np.einsum("pn,fnx->fpx", lagrange.at_places("triangle", rows.shape[1], at), nodes[rows])


def _distances(shape, nodes, rows, progress):
    """Distances of points of each triangle, mm; in large meshes only some of the points that were measured."""
    at = _lattice(_STEPS)
    at = at[(at.max(axis=1) < 1.0) & (at.sum(axis=1) > 0.0)]
    count = int(np.clip(_MOST_POINTS // max(len(rows), 1), 1, len(at)))
    points = _points(nodes, rows, at[np.linspace(0, len(at) - 1, count).astype(int)])
    found = extension().distances_to_faces(shape, points.reshape(-1, 3), progress)
    return found.reshape(len(rows), -1).max(axis=1)


def _own_faces(shape, nodes, rows, faces, place):
    """(the distance of a place of each triangle from its face, the cosine of the angle between their normals there)."""
    import Part

    step = 1e-4
    at = np.array(place) + np.array([[0, 0, 0], [-step, 0, 0], [step, 0, 0], [0, -step, 0], [0, step, 0]])
    around = np.einsum("pn,fnx->fpx", lagrange.at_places("triangle", rows.shape[1], at), nodes[rows])
    normal = np.cross(around[:, 2] - around[:, 1], around[:, 4] - around[:, 3])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    own, cosine = [], []
    for point, direction, face in zip(around[:, 0].tolist(), normal, faces.tolist()):
        face = shape.Faces[face]
        vector = FreeCAD.Vector(*point)
        own.append(face.distToShape(Part.Vertex(vector))[0])
        cosine.append(float(direction @ np.array(face.normalAt(*face.Surface.parameter(vector)))))
    return np.array(own), np.array(cosine)


def largest(shape, nodes, rows, progress=None):
    """(mm, mm): the largest distance of points of the triangles from the shape, and the distance up to which points
    count as on it.
    """
    return float(_distances(shape, nodes, rows, progress).max(initial=0.0)), _ELSEWHERE * float(np.ptp(nodes[rows], axis=(0, 1)).max())


def cad_faults(shape, nodes, rows, said, proven):
    """Sentences on distances from the CAD to the mesh in a certificate that do not hold.

    The grids that the certificate names are evaluated by FreeCAD: they must be all over the faces and edges, as close as it says,
    and none of their points farther from the mesh than it says.
    """
    grids = (said.get("face_grids", []), said.get("edge_grids", []))
    if not grids[0]:
        return [f"the certificate says cad_deviation = {proven['cad_deviation']!r}, but not at which points: certify the mesh again"]
    faces, edges, found = shape.Faces, shape.Edges, []
    if max(grid[0] for grid in grids[0]) >= len(faces) or max((grid[0] for grid in grids[1]), default=0) >= len(edges):
        return [f"the certificate names faces or edges that the shape does not have: it has {len(faces):,} and {len(edges):,}"]
    found += _gaps_of_faces(faces, grids[0]) + _gaps_of_edges(faces, edges, grids[1])
    points, names, spacing = [], [], 0.0
    for number, *grid in grids[0]:
        own, far = _points_of_face(faces[number], *grid)
        points.append(own)
        names += [f"Face{number + 1}"] * len(own)
        spacing = max(spacing, far)
    for number, low, high, steps in grids[1]:
        own = np.array([tuple(edges[number].valueAt(t)) for t in np.linspace(low, high, steps + 1)])
        points.append(own)
        names += [f"Edge{number + 1}"] * len(own)
        spacing = max(spacing, float(np.linalg.norm(np.diff(own, axis=0), axis=1).max()))
    points, size = np.concatenate(points), float(np.ptp(nodes[rows], axis=(0, 1)).max())
    if not _number(proven["cad_spacing"]) >= (1.0 - _EXACT) * spacing:
        found.append(f"the certificate says cad_spacing = {proven['cad_spacing']!r}, but the points that it names are {spacing:.6g} mm "
                     "apart")
    allowed = (1.0 + _EXACT) * max(_number(proven["cad_deviation"]), 0.0) + _NOTHING * size
    distance = nearest_on_mesh.beyond(points, nodes, rows, allowed)
    wrong = np.flatnonzero(distance > allowed)
    for i in wrong[np.unique([names[i] for i in wrong], return_index=True)[1]][:_NAMED]:
        x, y, z = points[i]
        far = f"{distance[i]:.3g} mm" if np.isfinite(distance[i]) else f"more than {allowed:.3g} mm"
        found.append(f"{names[i]} is {far} from the mesh at ({x:.4g}, {y:.4g}, {z:.4g}) mm: the certificate says "
                     f"cad_deviation = {proven['cad_deviation']!r}")
    return found


def _points_of_face(face, u0, u1, v0, v1, columns, rows):
    """(points of the grid that are inside of the face, how far neighbours across its cells are apart at most)."""
    us, vs = np.linspace(u0, u1, columns + 1), np.linspace(v0, v1, rows + 1)
    there = np.array([[face.isPartOfDomain(u, v) for v in vs] for u in us])
    points = np.array([[tuple(face.valueAt(u, v)) for v in vs] for u in us])
    across = np.linalg.norm(points[1:, 1:] - points[:-1, :-1], axis=2)[there[:-1, :-1]]
    return points[there], float(across.max(initial=0.0))


def _gaps_of_faces(faces, grids):
    """A list with a sentence on a face that has points in none of its grids; else empty."""
    for number, face in enumerate(faces):
        own = [grid[1:5] for grid in grids if grid[0] == number]
        u0, u1, v0, v1 = face.ParameterRange
        for s in _OWN:
            for t in _OWN:
                u, v = u0 + s * (u1 - u0), v0 + t * (v1 - v0)
                if not any(a <= u <= b and c <= v <= d for a, b, c, d in own) and face.isPartOfDomain(u, v):
                    x, y, z = face.valueAt(u, v)
                    return [f"Face{number + 1} was not measured at ({x:.4g}, {y:.4g}, {z:.4g}) mm"]
    return []


def _gaps_of_edges(faces, edges, grids):
    """A list with a sentence on an edge of a face that has places in none of its grids; else empty."""
    for number, edge in enumerate(edges):
        own = [grid[1:3] for grid in grids if grid[0] == number]
        low, high = edge.ParameterRange
        if edge.Degenerated or (not own and not any(edge.isSame(other) for face in faces for other in face.Edges)):
            continue
        for s in _OWN:
            t = low + s * (high - low)
            if not any(a <= t <= b for a, b in own):
                x, y, z = edge.valueAt(t)
                return [f"Edge{number + 1} was not measured at ({x:.4g}, {y:.4g}, {z:.4g}) mm"]
    return []
