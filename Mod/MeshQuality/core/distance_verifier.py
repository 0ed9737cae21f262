# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a mesh is as far from its CAD faces as a certificate says: an independent check of what the core measures.

The points of each triangle that were measured are projected onto the shape by OpenCASCADE itself, without any of the
classification that the measures rest on: the shape is not farther from them than the face that they were measured from. Some triangles are compared with the very face that they are said to be
on. Points of the CAD faces, by FreeCAD's own tessellation, are looked for among points of the mesh.
"""

import FreeCAD
import numpy as np

from ..compat import extension
from .elements import kinds, lagrange

_STEPS = 7  # of the lattice of points of a triangle; its corners are not measured
_HELD_AGAINST, _MOST_PARTS = 1_000_000, 32  # points of the mesh against which the shape is held: in all; along an edge
_MOST_POINTS = 1_000_000
_EXACT, _NOTHING = 1e-6, 1e-7  # by which distances at the same points may differ, times their own and the size of the mesh
_LOOSE = 1.5  # of the distance at other points, times what is said
_COMPARED = 500  # triangles that are compared with their own face
_NAMED = 3
_MIDDLE = (2 / 7, 2 / 7, 0.0)  # a measured point
_AROUND = [(i / 4 + 1 / 12, j / 4 + 1 / 12, 0.0) for i in range(4) for j in range(4 - i)]  # of triangles that turn far


def faults_of(shape, nodes, order, rows, said, proven, progress=None):
    """Sentences: what of the distances that a certificate says does not hold."""
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
    own, against = _own_faces(shape, nodes, order, rows[compared], faces[compared], _MIDDLE)
    turned = int(against.sum())
    wrong = np.zeros(len(rows), dtype=bool)
    wrong[compared] = own > allowed[compared]
    distance[compared] = own
    _name(found, wrong, "is {:.3g} mm from the CAD face that the certificate says it is on", distance)
    turning = np.array(said.get("turning", []), dtype=int)
    against = np.zeros(len(rows), dtype=bool)
    for place in _AROUND if len(turning) else ():
        against[turning] |= _own_faces(shape, nodes, order, rows[turning], faces[turning], place)[1]
    _name(found, against, "is turned against its CAD face, which the certificate says it follows", distance)
    if turned > _number(proven["folded_on_cad"]):
        found.append(f"the certificate says folded_on_cad = {proven['folded_on_cad']!r}, but {turned:,} triangles are turned "
                     "against their CAD faces")
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
    """By triangle; of large meshes at some of the points that were measured."""
    at = _lattice(_STEPS)
    at = at[(at.max(axis=1) < 1.0) & (at.sum(axis=1) > 0.0)]
    count = int(np.clip(_MOST_POINTS // max(len(rows), 1), 1, len(at)))
    points = _points(nodes, rows, at[np.linspace(0, len(at) - 1, count).astype(int)])
    found = extension().distances_to_faces(shape, points.reshape(-1, 3), progress)
    return found.reshape(len(rows), -1).max(axis=1)


def _own_faces(shape, nodes, order, rows, faces, place):
    """(the distance of a place of each triangle from its face, whether it is turned against the face there)."""
    import Part

    step = 1e-4
    at = np.array(place) + np.array([[0, 0, 0], [-step, 0, 0], [step, 0, 0], [0, -step, 0], [0, step, 0]])
    around = np.einsum("pn,fnx->fpx", lagrange.at_places("triangle", rows.shape[1], at), nodes[rows])
    normal = np.cross(around[:, 2] - around[:, 1], around[:, 4] - around[:, 3])
    own, against = [], []
    for point, direction, face in zip(around[:, 0].tolist(), normal, faces.tolist()):
        face = shape.Faces[face]
        vector = FreeCAD.Vector(*point)
        own.append(face.distToShape(Part.Vertex(vector))[0])
        against.append(float(direction @ np.array(face.normalAt(*face.Surface.parameter(vector)))) < 0)
    return np.array(own), np.array(against, dtype=bool)


def missing(shape, nodes, rows, order, said):
    """(sentences, mm): points of the CAD faces that are farther from the mesh than a certificate says, and how far from it others
    may be.
    """
    parts = int(np.clip(np.sqrt(_HELD_AGAINST / len(rows)), order + 2, _MOST_PARTS))
    points = _points(nodes, rows, _lattice(parts))
    steps = np.linalg.norm(np.diff(nodes[rows[:, [0, 1, 2, 0]]], axis=1), axis=2).max() / parts
    reach = _LOOSE * _number(said) + steps + _NOTHING * float(np.ptp(points, axis=(0, 1)).max())
    used = set(map(tuple, np.unique(np.floor(points.reshape(-1, 3) / reach).astype(int), axis=0).tolist()))
    found = []
    for number, face in enumerate(shape.Faces, 1):
        corners, facets = face.tessellate(reach / 4)
        corners = np.array([tuple(corner) for corner in corners]).reshape(-1, 3)
        samples = np.concatenate([corners, corners[np.array(facets, dtype=int).reshape(-1, 3)].mean(axis=1)])
        cells = np.floor(samples / reach).astype(int)
        for cell, sample in zip(cells.tolist(), samples.tolist()):
            if not any((cell[0] + x, cell[1] + y, cell[2] + z) in used for x in (0, -1, 1) for y in (0, -1, 1) for z in (0, -1, 1)):
                x, y, z = sample
                found.append(f"Face{number} is more than {reach:.3g} mm from the mesh at ({x:.4g}, {y:.4g}, {z:.4g}) mm: the "
                             f"certificate says cad_deviation = {said!r}")
                break
        if len(found) == _NAMED:
            break
    return found, reach
