# SPDX-License-Identifier: LGPL-2.1-or-later
"""voids: closed cavities in a solid, from which nothing comes out."""

from dataclasses import dataclass

import numpy as np

from ... import options
from ...compat import extension
from ...errors import InvalidInput
from ...listing import Public
from ..meshes.surface_mesh import SurfaceMesh
from ..operands.operands import part_of
from ..operands.solid_surfaces import SolidSource
from . import tables

_MESHING = 0.9  # of the progress
_LISTED = 20  # voids in a text


@dataclass(frozen=True)
class Void:
    """A closed cavity.

    volume     mm^3, that of the mesh
    area       mm^2, of its surface
    center     float64 (3,), mm, its centre of mass
    low, high  float64 (3,), mm, the corners of its box
    faces      names of its CAD faces, ("Face3", ...); empty without a shape
    triangles  int32 (n,), of the mesh
    """

    volume: float
    area: float
    center: np.ndarray
    low: np.ndarray
    high: np.ndarray
    faces: tuple
    triangles: np.ndarray


class VoidReport(metaclass=Public):
    """The closed cavities of a solid, and the volumes of its surfaces.

    mesh          SurfaceMesh that was searched
    voids         [Void, ...], largest first
    void_volume   mm^3, of all of them
    solid_volume  mm^3, of the material
    chord_height  mm, largest distance of the mesh from the shape; None without one
    bridge        "live" or "stream": how the shape came from FreeCAD; empty without one
    notes         sentences that a user should know
    """

    __slots__ = {"mesh": "SurfaceMesh", "voids": "[Void, ...], largest first", "solid_volume": "mm^3",
                 "chord_height": "mm, or None", "notes": "sentences"}

    def __init__(self, mesh, voids, solid_volume, chord_height):
        self.mesh, self.voids, self.solid_volume, self.chord_height = mesh, voids, solid_volume, chord_height
        self.notes = [*mesh.report.notes]

    void_volume = property(lambda self: sum(void.volume for void in self.voids), doc="mm^3")
    bridge = property(lambda self: self.mesh.report.bridge, doc='"live", "stream" or ""')

    def to_dict(self):
        """All but the arrays, for JSON."""
        return {"void_volume": self.void_volume, "solid_volume": self.solid_volume, "chord_height": self.chord_height,
                "bridge": self.bridge, "voids": [{"volume": void.volume, "area": void.area, "center": void.center.tolist(),
                           "low": void.low.tolist(), "high": void.high.tolist(), "faces": list(void.faces)}
                          for void in self.voids], "notes": [*self.notes]}

    def __str__(self):
        count = len(self.voids)
        lines = [f"voids        {count or 'none'}{f', {self.void_volume:.6g} mm^3' if count else ''}",
                 f"material     {self.solid_volume:.6g} mm^3"]
        for void in self.voids[:_LISTED]:
            center = ", ".join(f"{x:.4g}" for x in void.center)
            lines.append(f"  {void.volume:.6g} mm^3 at ({center}){f' of {_named(void.faces)}' if void.faces else ''}")
        if count > _LISTED:
            lines.append(f"  and {count - _LISTED} more")
        return "\n".join([*lines, *(f"note         {note}" for note in self.notes)]) + "\n"

    def __repr__(self):
        return f"<VoidReport: {len(self.voids)} voids, {self.void_volume:.4g} mm^3>"


def voids(source, tolerance=None, progress=None):
    """Finds the closed cavities of solids, from which powder, resin or gas does not come out: a VoidReport.

    source     Part.Shape or document object with solids; or a closed mesh: Mesh.Mesh, SurfaceMesh, arrays (V, F), repaired
               where it has small faults
    tolerance  mm; largest distance of the mesh from a shape; None: a thousandth of the largest dimension
    progress   callable(fraction 0..1, stage); returning False cancels

    A cavity is a closed surface that faces inwards; a solid that lies in it is not taken off its volume. Those that open to
    the outside, by a hole however narrow, are none. The solids of a shape are searched each by itself.
    Raises InvalidInput naming the shape or mesh, the defect and the remedy; TopologyError, GeometryError; Cancelled.
    """
    values = options.check(options.inspection.VOIDS, {"tolerance": tolerance})
    options.require_callable(progress)
    taken = SolidSource(source)
    chord_height = None if taken.shape is None else values["tolerance"] or taken.first_chord_height()
    surface = taken.mesh(chord_height, None, part_of(progress, 0.0, _MESHING))
    try:
        surface, _ = extension().solid_surface(surface, part_of(progress, _MESHING, 1.0))
    except InvalidInput as error:
        raise taken.named(error) from error
    mesh = SurfaceMesh(surface)
    found, volume = [], 0.0
    for triangles in tables.connected(mesh.triangles, np.arange(len(mesh.triangles))):
        one = _cavity(mesh, triangles)
        volume += one[0]
        if one[0] < 0.0:
            found.append(one[1])
    found.sort(key=lambda void: -void.volume)
    return VoidReport(mesh, found, volume, None if taken.shape is None else surface.report.max_chord_height)


def _cavity(mesh, triangles):
    """(signed volume in mm^3, the Void) of a closed surface: negative where it faces inwards."""
    corners = mesh.vertices[mesh.triangles[triangles]]
    middle = corners.reshape(-1, 3).mean(axis=0)
    a, b, c = np.moveaxis(corners - middle, 1, 0)
    volumes = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0
    volume = float(volumes.sum())
    # Of the tetrahedra between the triangles and the middle.
    center = middle + (volumes[:, None] * (a + b + c) / 4.0).sum(axis=0) / volume if volume else middle
    faces = mesh.triangle_face[triangles] if len(mesh.triangle_face) else np.zeros(0, int)
    origin = mesh.origin
    return volume, Void(abs(volume), float(tables.areas_of(mesh)[triangles].sum()), center + origin,
                        corners.min(axis=(0, 1)) + origin, corners.max(axis=(0, 1)) + origin,
                        tuple(f"Face{face + 1}" for face in np.unique(faces[faces >= 0]).tolist()),
                        triangles.astype(np.int32))


def _named(faces):
    return " and ".join(faces[:3]) + (f" and {len(faces) - 3} more" if len(faces) > 3 else "")
