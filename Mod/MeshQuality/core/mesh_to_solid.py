# SPDX-License-Identifier: LGPL-2.1-or-later
"""to_solid: the CAD solid of a closed mesh, with the exact surfaces that the mesh was made of."""

from dataclasses import dataclass, field

import FreeCAD
import numpy as np
import Part

from .. import options, phrases, solid_phrases
from ..errors import GeometryError, InvalidInput, IoError
from ..listing import Public
from ..phrases import Text
from .brep.construction import tolerance_of
from .inspect.deviation import deviation
from .meshes.surface_mesh import SurfaceMesh, surface_of
from .operands.operands import part_of

_MOST_FACETS = 20_000  # triangles: OpenCASCADE sews more in minutes only
_ROUNDING = 1e-6  # of the size: single precision of the mesh
_COARSE = 5e-3  # of the size: deflection of the tessellation that spreads points over faces
_WITHIN = np.array([(i + 1, j + 1, 5 - i - j) for i in range(5) for j in range(5 - i)]) / 7.0  # weights of the corners of its triangles
_FEW, _MANY = 60, 300  # points a face by which it is chosen, and checked
_CORNERS = 2.0  # times the distance of the mesh from the CAD's faces: where three planes meet at right angles, sqrt(3) times it
_AGREE = 0.5  # cosine of the angle between the normals of a face and of the mesh, at least


@dataclass(frozen=True)
class MeshSolid(metaclass=Public):
    """A CAD solid made of a mesh, and how it was checked.

    shape         Part.Solid, or a Part.Compound of them: valid and closed
    faces         number of its faces on exact surfaces of the CAD
    facets        number of its faces that are planar facets of the mesh, coplanar ones merged; either this or faces is 0
    volume        mm^3
    mesh_volume   mm^3, of the mesh
    deviation     mm, the largest distance of the mesh from the solid, at its vertices and the middles of its triangles
    deviation_back
                  mm, the largest distance of the solid from the mesh, at its vertices and at points spread over its faces
    tolerance     mm: deviation and deviation_back are at most this. Twice the distance of the mesh from the CAD by its report, as sharp
                  edges are farther apart than faces are. The volumes differ by at most half of this times the area
    notes         why it is facets, where it is
    """

    shape: object
    faces: int
    facets: int
    volume: float
    mesh_volume: float
    deviation: float
    deviation_back: float
    tolerance: float
    notes: tuple = field(default=())

    def write(self, path):
        """Writes a STEP file and reads it back. Raises IoError where that is not possible, or where the solid that is read is not
        valid or has another volume by more than a millionth.
        """
        path = str(path)
        try:
            self.shape.exportStep(path)
            back = Part.Shape()
            back.read(path)
        except Exception as error:  # what OpenCASCADE raises has no common class
            raise IoError(f"{path}: {error}") from error
        if not back.Solids or not back.isValid() or abs(back.Volume - self.volume) > 1e-6 * self.volume:
            raise IoError(f"{path}: the solid that is read back is not the one that was written")

    def to_dict(self):
        """All but the shape, for JSON."""
        return {name: getattr(self, name) for name in ("faces", "facets", "volume", "mesh_volume", "deviation", "deviation_back", "tolerance")} \
            | {"notes": list(map(str, self.notes))}

    def __str__(self):
        what = f"{self.faces:,} exact faces" if self.faces else f"{self.facets:,} planar facets"
        return "\n".join((f"solid        {what}, {self.volume:.6g} mm^3; mesh {self.mesh_volume:.6g} mm^3",
                          f"deviation    {self.deviation:.3g} mm of the mesh from the solid, {self.deviation_back:.3g} mm back, {self.tolerance:.3g} mm "
                          "are allowed", *(f"note         {note}" for note in self.notes))) + "\n"

    def __repr__(self):
        what = f"{self.faces} exact faces" if self.faces else f"{self.facets} facets"
        return f"<MeshSolid: {what}, {self.volume:.6g} mm^3, {self.deviation:.3g} mm from the mesh>"


def to_solid(mesh, facets=True, progress=None):
    """The CAD solid of a closed mesh, with the exact surfaces that the mesh was made of: a MeshSolid.

    mesh      what triangulate, offset, hollow or boolean returned, made of shapes or of such meshes: its surfaces are those of the
              shapes, or offset from them. Or another closed mesh: Mesh.Mesh, Mesh feature, SurfaceMesh, arrays (V, F), which gets facets
    facets    True: where exact surfaces do not close, the solid has planar facets, and a note says why; False: it is refused
    progress  as for triangulate

    The faces of the CAD, and of offsets also cylinders, tori and spheres about edges and vertices, are divided along their
    intersections by OpenCASCADE; those pieces that lie on the mesh are sewn. The solid is checked: it is valid and closed, its volume is
    that of the mesh and its distance from the mesh, both ways, is at most that of the mesh from the CAD, by its report.

    Raises InvalidInput for a mesh that is open or not manifold, or has more than 20,000 triangles where facets are needed; GeometryError
    where no valid solid comes of it; Cancelled.
    """
    options.require_callable(progress)
    surface = surface_of(mesh)
    report = surface.report
    if not (report.closed and report.manifold and report.oriented) or not len(surface.triangles):
        raise InvalidInput(Text(solid_phrases.REPAIR_FIRST))
    given = _Given(surface)
    try:
        return _exact(mesh, given, progress)
    except _NoSolidError as error:
        if not facets:
            raise GeometryError(Text(solid_phrases.NO_EXACT, phrase=phrases.text_of(error))) from error
        return _facets(given, phrases.text_of(error))


class _NoSolidError(Exception):
    """Why there is no valid solid on the CAD's surfaces."""


class _Given:
    """The mesh: points float64 (V, 3), triangles, volume, area and size."""

    def __init__(self, surface):
        self.points, self.triangles = surface.vertices + surface.origin, np.array(surface.triangles)
        self.volume, self.area = surface.report.volume, surface.report.area
        self.size = float(np.ptp(self.points, axis=0).max())

    def samples(self):
        """float64 (n, 3): its vertices, and the middles of its triangles."""
        return np.concatenate([self.points, self.points[self.triangles].mean(axis=1)])


def _exact(mesh, given, progress):
    """The MeshSolid on the CAD's surfaces; raises _NoSolidError."""
    construction = mesh._construction if isinstance(mesh, SurfaceMesh) else None
    faces = None if construction is None else construction.faces()
    if not faces:
        raise _NoSolidError(Text(solid_phrases.NO_CAD))
    tolerance = tolerance_of(mesh) + _ROUNDING * given.size
    try:
        pieces = faces[0].generalFuse(faces[1:])[0].Faces if len(faces) > 1 else faces
        chosen = _on_mesh(pieces, given, tolerance, part_of(progress, 0.2, 0.6))
        shape = _merged(_solid_of(chosen))
    except Part.OCCError as error:
        raise _NoSolidError(Text(solid_phrases.NOT_INTERSECTED, text=str(error))) from error
    return _checked(shape, given, tolerance, len(shape.Faces), 0, ())


def _on_mesh(pieces, given, tolerance, progress):
    """Those of the faces that lie on the mesh: most of their area is within the tolerance of it, along its normals."""
    samples = [_samples_of(piece, given.size, _FEW) for piece in pieces]
    owner = np.repeat(np.arange(len(pieces)), [len(points) for points, _ in samples])
    points, crosses = (np.concatenate(arrays) for arrays in zip(*samples))
    areas = np.linalg.norm(crosses, axis=1)
    found = deviation(points, (given.points, given.triangles), progress=progress)
    along = np.abs(np.einsum("ij,ij->i", found.normals, crosses)) >= _AGREE * areas
    near = along & (np.abs(found.values) <= tolerance)
    share = np.bincount(owner, areas * near, len(pieces)) / np.maximum(np.bincount(owner, areas, len(pieces)), 1e-300)
    return [piece for piece, part in zip(pieces, share) if part > 0.5]


def _samples_of(face, size, most):
    """Points spread over a face, float64 (n, 3), no more than `most`, and the area normals of the triangles of its tessellation that they stand for."""
    corners, triangles = face.tessellate(_COARSE * size)
    corners = np.array([tuple(point) for point in corners]).reshape(-1, 3)[np.array(triangles, dtype=int).reshape(-1, 3)]
    crosses = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    points = np.einsum("ki,tij->tkj", _WITHIN, corners).reshape(-1, 3)
    surface, kept, found = face.Surface, [], []
    for i in np.unique(np.linspace(0, len(points) - 1, min(len(points), most)).astype(int)).tolist():
        u, v = surface.parameter(FreeCAD.Vector(*points[i].tolist()))
        if face.isPartOfDomain(u, v):
            kept.append(i // len(_WITHIN))
            found.append(tuple(surface.value(u, v)))
    return np.array(found).reshape(-1, 3), crosses[kept]


def _solid_of(faces):
    """The Part.Solid, or the Part.Compound of them, that faces bound; raises _NoSolidError."""
    if not faces:
        raise _NoSolidError(Text(solid_phrases.NONE_ON_MESH))
    sewn = Part.makeCompound(faces)
    sewn.sewShape()
    shells = sewn.Shells or [Part.Shell(faces)]  # a sphere or torus alone is not sewn
    if sum(len(shell.Faces) for shell in shells) != len(sewn.Faces) or not all(shell.isClosed() for shell in shells):
        raise _NoSolidError(Text(solid_phrases.NOT_CLOSED))
    return _nested([_outward(Part.Solid(shell)) for shell in shells])


def _outward(solid):
    if solid.Volume < 0.0:
        solid.reverse()
    return solid


def _nested(solids):
    """The solid, or the compound of solids, of closed shells, of which one within another is its cavity, and so on."""
    solids = sorted(solids, key=lambda solid: -solid.Volume)
    around = [[j for j in range(i) if solids[j].isInside(solid.Vertexes[0].Point, 1e-7, False)] for i, solid in enumerate(solids)]
    made = []
    for i, solid in enumerate(solids):
        if len(around[i]) % 2:
            continue
        cavities = [solids[j] for j in range(i + 1, len(solids)) if len(around[j]) == len(around[i]) + 1 and i in around[j]]
        made += (solid.cut(Part.makeCompound(cavities)) if cavities else solid).Solids
    return made[0] if len(made) == 1 else Part.makeCompound(made)


def _merged(shape):
    """The shape with neighbouring faces of one surface joined to one face, where that is valid."""
    merged = shape.removeSplitter()
    return merged if merged.Solids and merged.isValid() else shape


def _facets(given, why):
    """The MeshSolid of planar facets; `why` says why it has no exact faces."""
    if len(given.triangles) > _MOST_FACETS:
        raise InvalidInput(Text(solid_phrases.TOO_MANY, phrase=why, count=f"{len(given.triangles):,}", count2=f"{_MOST_FACETS:,}"))
    shape = Part.Shape()
    shape.makeShapeFromMesh(([FreeCAD.Vector(*point) for point in given.points.tolist()], [tuple(triangle) for triangle in given.triangles.tolist()]), 1e-7)
    try:
        shape = _merged(_solid_of(shape.Faces))
        return _checked(shape, given, _ROUNDING * given.size, 0, len(shape.Faces), (why,))
    except (_NoSolidError, Part.OCCError) as error:
        raise GeometryError(Text(solid_phrases.NO_FACETS, phrase=why, phrase2=phrases.text_of(error))) from error


def _triangles_of(shape):
    """The arrays of a solid of planar facets, which its tessellation is exactly; facets too narrow to be meshed as CAD faces are in it."""
    points, triangles = shape.tessellate(1.0)
    return np.array([tuple(point) for point in points]), np.array(triangles, dtype=np.int32)


def _checked(shape, given, tolerance, faces, facets, notes):
    """The MeshSolid, once it is shown to be one; raises _NoSolidError."""
    if not shape.Solids or not shape.isValid():
        raise _NoSolidError(Text(solid_phrases.NOT_VALID))
    if abs(shape.Volume - given.volume) > tolerance * given.area:
        raise _NoSolidError(Text(solid_phrases.OTHER_VOLUME, volume=f"{shape.Volume:.6g} mm³", volume2=f"{given.volume:.6g} mm³"))
    points = np.concatenate([[tuple(vertex.Point) for vertex in shape.Vertexes], *(_samples_of(face, given.size, _MANY)[0] for face in shape.Faces)])
    there = deviation(given.samples(), shape if faces else _triangles_of(shape)).max_deviation
    back = deviation(points, (given.points, given.triangles)).max_deviation
    tolerance *= _CORNERS
    if max(there, back) > tolerance:
        raise _NoSolidError(Text(solid_phrases.TOO_FAR, length=f"{max(there, back):.3g} mm", length2=f"{tolerance:.3g} mm"))
    return MeshSolid(shape, faces, facets, shape.Volume, given.volume, there, back, tolerance, notes)
