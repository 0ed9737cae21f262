# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate of a mesh: what was promised, whether the finished mesh keeps it, and where not.

It is about the mesh as it was measured after rounding to single precision, not about the algorithm.
Its sentences are made of the phrases of one table, by which panels translate them.
"""

import re
from dataclasses import dataclass

import numpy as np

from .. import phrases
from ..compat import core

KEPT, MISSED = "kept", "missed: "
UNKNOWN = "unknown: the mesh was made by an older version; update it"


@dataclass(frozen=True)
class Fault:
    """A promise that is not kept.

    text   a sentence
    faces  the CAD faces ("Face7", ...) where that is
    place  the corners of the triangle where it is worst, in the document's frame: three points;
           none where that is not known
    """

    text: str
    faces: tuple = ()
    place: tuple = ()


def sentence(faults):
    """What the property Certificate says."""
    return MISSED + "; ".join(fault.text for fault in faults) if faults else KEPT


def faces(faults):
    """The CAD faces of all faults, each once."""
    return list(dict.fromkeys(face for fault in faults for face in fault.faces))


def place(faults):
    """The place of the first fault that has one, as three points."""
    return next((fault.place for fault in faults if fault.place), ())


def shall_be_closed(shape):
    """Whether all faces of the shape belong to solids."""
    return bool(shape.Solids) and sum(len(solid.Faces) for solid in shape.Solids) >= len(shape.Faces)


def topology_faults(report, closed, mesh=None):
    """Of a mesh that must be manifold, and closed if asked for; a SurfaceMesh also tells where."""
    found = []
    if closed and not report.closed:
        found.append(_fault_at(phrases.NOT_CLOSED.format(count=report.border_edges), mesh,
                               lambda uses: uses == 1))
    if not report.manifold:
        found.append(_fault_at(phrases.NOT_MANIFOLD.format(
            count=report.nonmanifold_edges, count2=report.pinched_vertices,
            count3=report.degenerate_triangles), mesh, lambda uses: uses > 2))
    return found


def _fault_at(text, mesh, bad):
    """A Fault at the triangles with an edge that so many triangles use."""
    if mesh is None:
        return Fault(text)
    triangles = np.asarray(mesh.triangles)
    sides = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, edge, uses = np.unique(sides, axis=0, return_inverse=True, return_counts=True)
    where = np.flatnonzero(bad(uses[edge.ravel()]).reshape(-1, 3).any(axis=1))
    return Fault(text, _names(mesh, where), _corners(mesh, where[0]) if len(where) else ())


def _names(mesh, triangles):
    """The faces of triangles, each once; none of a mesh that comes from no shape."""
    known = len(getattr(mesh, "triangle_face", ())) > 0
    return tuple(f"Face{face + 1}" for face in dict.fromkeys(mesh.triangle_face[triangles].tolist())) \
        if known else ()


def _corners(mesh, triangle):
    """The corners of a triangle in the document's frame."""
    return tuple(map(tuple, (mesh.vertices[mesh.triangles[triangle]] + mesh.origin).tolist()))


def angle_faults(mesh):
    """Of a SurfaceMesh: triangles below the smallest angle that was asked for."""
    report = mesh.report
    asked = report.min_angle_asked
    if not report.triangles or report.min_angle >= asked:
        return []
    angles = core().triangle_shapes(mesh._surface)[0]
    worst = int(np.argmin(angles))
    below = np.flatnonzero(angles < asked)
    names = _names(mesh, below)
    where = dict(report.exempt).get(
        worst, phrases.ONLY_ON_FACE.format(face=_names(mesh, [worst])[0]) if names
        else phrases.NO_REASON)
    text = phrases.ANGLE.format(number=f"{report.min_angle:.3g}", number2=f"{asked:g}", count=worst,
                                phrase=where)
    if len(below) > 1:
        text = phrases.MORE_BELOW.format(phrase=text, count=len(below) - 1)
    return [Fault(text, names, _corners(mesh, worst))]


def chord_faults(mesh):
    """Of a SurfaceMesh: its distance to the shape, and where that is largest."""
    report = mesh.report
    found = distance_faults(report.max_chord_height, report.chord_height_asked,
                            phrases.SHAPE_DISTANCE)
    worst = report.max_chord_triangle
    if not found or worst < 0:
        return found
    text, names = phrases.AT_TRIANGLE.format(phrase=found[0].text, count=worst), _names(mesh, [worst])
    if names:
        text = phrases.ON_FACE.format(phrase=text, face=names[0])
    return [Fault(text, names, _corners(mesh, worst))]


def distance_faults(measured, asked, phrase):
    """Of a distance in mm that was to be kept within; asked 0: none."""
    if not asked or measured <= asked:
        return []
    return [Fault(phrase.format(number=f"{measured:.3g}", number2=f"{asked:.3g}"))]


def element_faults(curved):
    """Of a CurvedMesh: elements that are not proven to be free of folds."""
    report = curved.report
    if not report.invalid:
        return []
    named = report.invalid_elements
    text = ", ".join(named[:3])
    if len(named) > 3:
        text = phrases.AND_MORE.format(list=text, count=len(named) - 3)
    found = re.findall(r"on (Face\d+)", "; ".join(named))
    return [Fault(phrases.FOLDED.format(count=report.invalid, count2=report.elements, list=text),
                  tuple(dict.fromkeys(found)), _first_folded(curved))]


def _first_folded(curved):
    """Corners of the first element that is not proven valid."""
    for quality, elements in ((curved.triangle_quality, curved.triangles),
                              (curved.tetrahedron_quality, curved.tetrahedra)):
        folded = np.flatnonzero(~(quality > 0.0))
        if len(folded):
            return tuple(map(tuple, curved.nodes[elements[folded[0], :3]].tolist()))
    return ()
