# SPDX-License-Identifier: LGPL-2.1-or-later
"""SurfaceMesh: what the algorithms return."""

from ..compat import extension
from ..errors import InvalidInput
from ..listing import Public
from . import convert


class SurfaceMesh(metaclass=Public):
    """A triangle mesh with its link to the CAD faces and its report.

    vertices       float64 (V, 3), mm, relative to origin; each a single-precision number
    origin         float64 (3,), mm; zero unless the part lies far from the origin
    triangles      int32 (T, 3), outward orientation
    triangle_face  int32 (T,), triangle i lies on shape.Faces[triangle_face[i]]
    triangle_solid     int32 (T,), triangle i bounds shape.Solids[triangle_solid[i]]; -1: no solid
    triangle_opposite  int32 (T,), the triangle of another solid in the same place, the other way round;
                       -1: none; empty where no solid shares a face with another (imprint=True)
    vertex_entity  int32 (V, 2), (dimension 0|1|2, index into Vertexes|Edges|Faces)
    report         MeshReport

    The arrays are read-only views of the core's memory, without a copy; each keeps it alive.
    """

    __slots__ = ("_surface",)

    def __init__(self, surface):
        self._surface = surface

    vertices = property(lambda self: self._surface.vertices, doc="float64 (V, 3), mm")
    origin = property(lambda self: self._surface.origin, doc="float64 (3,), mm")
    triangles = property(lambda self: self._surface.triangles, doc="int32 (T, 3)")
    triangle_face = property(lambda self: self._surface.triangle_face, doc="int32 (T,)")
    triangle_solid = property(lambda self: self._surface.triangle_solid, doc="int32 (T,)")
    triangle_opposite = property(lambda self: self._surface.triangle_opposite, doc="int32 (T,)")
    vertex_entity = property(lambda self: self._surface.vertex_entity, doc="int32 (V, 2)")
    report = property(lambda self: self._surface.report, doc="MeshReport")

    def to_mesh(self):
        """A Mesh.Mesh with the same triangles in the same order and one segment a CAD face.

        Its Placement holds the origin.
        """
        return convert.mesh_of_surface(self._surface)

    def write(self, path):
        """Writes .stl, .ply, .obj, .off, .msh (Gmsh 4.1) or .vtu by extension, in mm.

        Raises IoError naming the path.
        """
        self._surface.write(convert.file_name(path))

    def __repr__(self):
        return repr(self.report).replace(type(self.report).__name__, type(self).__name__, 1)


def surface_of(mesh, measured=True):
    """The core's Surface of anything that is a mesh; raises InvalidInput."""
    module = extension()
    if isinstance(mesh, SurfaceMesh):
        return mesh._surface
    if convert.is_mesh(mesh):
        return convert.surface_of_arrays(module, *convert.arrays_of_mesh(mesh), measured=measured)
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return convert.surface_of_arrays(module, *mesh, measured=measured)
    raise InvalidInput("a Mesh.Mesh, a SurfaceMesh or arrays (V, F) are needed, not "
                       f"{type(mesh).__name__}")
