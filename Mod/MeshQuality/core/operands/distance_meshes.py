# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of shapes that are bound by their distance alone: few triangles, of any angles."""

from dataclasses import dataclass

import numpy as np

from ...compat import attribute_of, extension
from ...errors import Cancelled, InvalidInput, TopologyError
from ..sources import convert
from ..surface_mesh import SurfaceMesh

_COARSEST = 16.0  # of the distance: the first triangulation of a face by OpenCASCADE, ...
_FINER = 4.0  # ... and by how much the next one is finer, whose points are looked for on it, ...
_ROUNDS = 3  # ... at most this often
_NAMED = 5  # faces in a note


@dataclass(frozen=True)
class DistanceMesh:
    """A mesh of a shape, its triangles with the faces on which they lie.

    surface    core.Surface
    deviation  mm: its measured distance from the shape and of points of the shape from it, the largest
    rounded    whether its vertices may be rounded to single precision; otherwise they are such numbers
    note       which faces are OpenCASCADE's triangulation, and which are left out; "": none
    """

    surface: object
    deviation: float
    rounded: bool
    note: str


def mesh_within(shape, distance, progress=None, threads=0):
    """The DistanceMesh of a Part.Shape: ours, and OpenCASCADE's triangulation of faces that we cannot mesh, which may have
    holes. Faces that neither can mesh are left out.

    distance  mm, the largest one wanted
    threads   that work at a time; 0: one for each core

    Raises TopologyError or InvalidInput where no face can be meshed; Cancelled.
    """
    options = extension().TriangulateOptions()
    options.min_angle, options.chord_height, options.allow_missing_faces = 0.0, distance, True
    options.threads = threads
    faces = attribute_of(shape, "Faces")
    try:
        mesh = SurfaceMesh(extension().triangulate(convert.shape_of(shape), options, progress, None))
        require_complete(mesh.report, distance)
    except (InvalidInput, TopologyError) as error:
        refused = error
        pieces, deviation, missing, why = [], 0.0, list(range(len(faces))), str(error)
    else:
        refused, missing = None, sorted(index for index, _ in mesh.report.missing_faces)
        deviation = mesh.report.max_chord_height
        if not missing:
            return DistanceMesh(mesh._surface, deviation, False, "")
        pieces = [(np.asarray(mesh.vertices) + mesh.origin, np.asarray(mesh.triangles), np.asarray(mesh.triangle_face))]
        why = "; ".join(dict.fromkeys(reason for _, reason in mesh.report.missing_faces))
    left_out = []
    for number in missing:
        if progress is not None and progress(1.0, "initial triangulation") is False:
            raise Cancelled("meshing the shape was cancelled")
        points, corners, off = _tessellated(faces[number], distance)
        pieces.append((points, corners, np.full(len(corners), number, dtype=np.int32)))
        deviation = max(deviation, off)
        left_out += [] if len(corners) else [number]
    if refused is not None and len(left_out) == len(faces):
        raise refused
    taken = sorted(set(missing) - set(left_out))
    notes = [f"{_named(taken)}: not meshed; OpenCASCADE's triangulation is taken, which may have holes"] if taken else []
    notes += [f"{_named(left_out)}: meshed neither by us nor by OpenCASCADE, and left out"] if left_out else []
    return DistanceMesh(_joined(pieces), deviation, True, f"{'; '.join(notes)} ({why})")


def require_complete(report, distance):
    """Raises InvalidInput where the mesh of a shape within this distance, in mm, has reached the limit of triangles."""
    if not report.complete:
        raise InvalidInput(f"more than {report.triangles} triangles at a max. deviation of {distance:g} mm: "
                           "give a larger tolerance")


def _named(faces):
    more = f" and {len(faces) - _NAMED} more" if len(faces) > _NAMED else ""
    return ", ".join(f"Face{number + 1}" for number in faces[:_NAMED]) + more


def _joined(pieces):
    """The Surface of [(vertices, triangles, face of each), ...]."""
    starts = np.cumsum([0] + [len(vertices) for vertices, _, _ in pieces])
    return extension().surface_from_arrays(
        np.concatenate([vertices for vertices, _, _ in pieces]),
        np.concatenate([triangles + start for (_, triangles, _), start in zip(pieces, starts)]),
        np.concatenate([faces for _, _, faces in pieces]), False)


def _tessellated(face, distance):
    """(V, F, deviation in mm) of OpenCASCADE's triangulation of a face: the coarsest one that is measured within this
    distance. What it is asked for alone takes far too many triangles in faces with faults.
    """
    face = face.copy()  # the triangulation that the document shows stays
    wanted = _COARSEST * distance
    now = _arrays(face, wanted)
    deviation = None
    for _ in range(_ROUNDS):
        coarse, wanted = now, wanted / _FINER
        now = _arrays(face, wanted)
        if not len(now[1]):
            now = coarse
        elif len(coarse[1]):
            deviation = _deviation(face, coarse, now)
            if deviation <= distance:
                return *coarse, deviation
    if deviation is None:  # there was one only
        deviation = _deviation(face, now, now) if len(now[1]) else 0.0
    return *now, deviation  # otherwise that of the coarser one


def _arrays(face, distance):
    points, corners = face.tessellate(distance)
    return (np.array([tuple(point) for point in points], dtype=float).reshape(-1, 3),
            np.array(corners, dtype=np.int32).reshape(-1, 3))


def _deviation(face, coarse, fine):
    """mm: of points of a mesh from its face, and of points of the face, which are those of a finer mesh, from it."""
    module = extension()
    coarse, fine = (module.surface_from_arrays(*arrays, measured=False) for arrays in (coarse, fine))
    return max(module.measure_against(coarse, face).max_chord_height, module.surface_distance(fine, coarse)[1])
