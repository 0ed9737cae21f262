# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate of a mesh: what was promised, whether the finished mesh keeps it, and where not.

It is about the mesh as it was measured after rounding to single precision, not about the algorithm.
"""

import re
from dataclasses import dataclass

import numpy as np

from ..compat import core

KEPT, MISSED = "kept", "missed: "
UNKNOWN = "unknown: the mesh was made by an older version; update it"


@dataclass(frozen=True)
class Fault:
    """A promise that is not kept: a sentence, and the CAD faces ("Face7", ...) where that is."""

    text: str
    faces: tuple = ()


def sentence(faults):
    """What the property Certificate says."""
    return MISSED + "; ".join(fault.text for fault in faults) if faults else KEPT


def faces(faults):
    """The CAD faces of all faults, each once."""
    return list(dict.fromkeys(face for fault in faults for face in fault.faces))


def shall_be_closed(shape):
    """Whether all faces of the shape belong to solids."""
    return bool(shape.Solids) and sum(len(solid.Faces) for solid in shape.Solids) >= len(shape.Faces)


def topology_faults(report, closed):
    """Of a mesh that must be manifold, and closed if asked for."""
    found = []
    if closed and not report.closed:
        found.append(Fault(f"not closed: {report.border_edges} edges have one triangle only"))
    if not report.manifold:
        found.append(Fault(
            f"not manifold: {report.nonmanifold_edges} edges of three or more triangles, "
            f"{report.pinched_vertices} pinched vertices, {report.degenerate_triangles} triangles "
            "without area"))
    return found


def angle_faults(mesh):
    """Of a SurfaceMesh: triangles below the smallest angle that was asked for."""
    report = mesh.report
    asked = report.min_angle_asked
    if not report.triangles or report.min_angle >= asked:
        return []
    angles = core().triangle_shapes(mesh._surface)[0]
    worst = int(np.argmin(angles))
    below = np.flatnonzero(angles < asked)
    # A mesh that comes from no shape has no faces.
    names = [f"Face{face + 1}" for face in mesh.triangle_face[below]] if len(mesh.triangle_face) \
        else []
    where = dict(report.exempt).get(worst, f"on Face{mesh.triangle_face[worst] + 1}" if names
                                    else "for no known reason")
    more = f" ({len(below) - 1} more triangles are below)" if len(below) > 1 else ""
    return [Fault(f"smallest angle {report.min_angle:.3g} of {asked:g} degrees at triangle {worst}: "
                  f"{where}{more}", tuple(dict.fromkeys(names)))]


def distance_faults(measured, asked, what):
    """Of a distance in mm that was to be kept within; asked 0: none."""
    if not asked or measured <= asked:
        return []
    return [Fault(f"{what} {measured:.3g} of {asked:.3g} mm")]


def element_faults(report):
    """Of a CurveReport: elements that are not proven to be free of folds."""
    if not report.invalid:
        return []
    named = report.invalid_elements
    more = f" and {len(named) - 3} more" if len(named) > 3 else ""
    found = re.findall(r"on (Face\d+)", "; ".join(named))
    return [Fault(f"{report.invalid} of {report.elements} elements are not proven free of folds: "
                  f"{', '.join(named[:3])}{more}", tuple(dict.fromkeys(found)))]
