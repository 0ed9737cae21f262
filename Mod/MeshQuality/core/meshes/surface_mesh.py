# SPDX-License-Identifier: LGPL-2.1-or-later
"""SurfaceMesh: what the algorithms return."""

import numpy as np

from ...compat import extension
from ...errors import InvalidInput
from ...listing import Public
from ..patches.patches import kept
from ..sources import convert
from . import writing


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
    patches        the names of its patches; empty where none were given
    triangle_patch int32 (T,), triangle i is in patches[triangle_patch[i]]; empty likewise

    The arrays are read-only views of the core's memory, without a copy; each keeps it alive.
    """

    __slots__ = ("_construction", "_overlap", "_patches", "_surface")

    def __init__(self, surface, patches=None, overlap="refuse", construction=None):
        self._surface = surface
        self._construction = construction  # of core.brep, by which to_solid knows the CAD faces
        self._patches = patches
        self._overlap = overlap

    vertices = property(lambda self: self._surface.vertices, doc="float64 (V, 3), mm")
    origin = property(lambda self: self._surface.origin, doc="float64 (3,), mm")
    triangles = property(lambda self: self._surface.triangles, doc="int32 (T, 3)")
    triangle_face = property(lambda self: self._surface.triangle_face, doc="int32 (T,)")
    triangle_solid = property(lambda self: self._surface.triangle_solid, doc="int32 (T,)")
    triangle_opposite = property(lambda self: self._surface.triangle_opposite, doc="int32 (T,)")
    vertex_entity = property(lambda self: self._surface.vertex_entity, doc="int32 (V, 2)")
    report = property(lambda self: self._surface.report, doc="MeshReport")
    patches = property(lambda self: names_of_patches(self), doc="names of the patches")
    triangle_patch = property(lambda self: numbers_of_patches(self), doc="int32 (T,)")

    def to_mesh(self):
        """A Mesh.Mesh with the same triangles in the same order and one segment a CAD face.

        Its Placement holds the origin.
        """
        return convert.mesh_of_surface(self._surface)

    def of_solid(self, number):
        """The SurfaceMesh of the triangles that bound shape.Solids[number], closed as that is.

        Raises InvalidInput where no triangle does.
        """
        there = [i for i in np.unique(self.triangle_solid).tolist() if i >= 0]
        if number not in there:
            raise InvalidInput(f"no triangle bounds solid {number!r}: give one of {there}" if there else
                               "the mesh does not know solids: take one of triangulate of a shape with solids")
        chosen = np.flatnonzero(self.triangle_solid == number)
        corners, vertices = self.triangles[chosen], self.vertices + self.origin
        used, numbers = np.unique(corners, return_inverse=True)
        part = SurfaceMesh(extension().surface_from_arrays(
            vertices[used], numbers.reshape(-1, 3).astype(np.int32), self.triangle_face[chosen], True))
        if self._patches is not None:
            part._patches = kept(self._patches.division, part)
        return part

    def write(self, path, patches=None, patch_rest=None, scale=1.0, ascii=False, format=None,  # noqa: A002
              interfaces=False):
        """Writes into a file; one that is there is replaced once the new one is complete.

        path        the extension says the format: .stl .ply .obj .off .msh (Gmsh 4.1) .msh2 (Gmsh 2.2) .vtu
                    .su2 .cgns .mesh (MFEM) .xml (Nektar++) .inp .unv .nas .bdf .exo .tri .eMesh .fms .3mf .amf
        patches     {"inlet": ["Face1", "Face4"], ...}, or {"inlet": {"faces": [...], "colour": "#ff0000"}}; None:
                    those that the mesh was made with
        patch_rest  name of the patch of all other faces; None: each is one by its own name
        scale       factor of the coordinates, which are mm: 0.001 for metres
        ascii       STL as text, with one solid a patch
        format      such as "msh2", whatever the extension
        interfaces  of a mesh of imprint=True: triangles between two solids are patches of their own,
                    "Solid1_to_Solid2" on the side of the first and "Solid2_to_Solid1" on the other; "sheet":
                    they are there once, "Solid1_and_Solid2", with normals into the second solid, and points
                    in the same place are one, so that the surfaces of all solids are one conforming mesh

        Raises InvalidInput naming patch, face and remedy; IoError naming the path.
        """
        writing.write(self, path, patches, patch_rest, scale, ascii, format, interfaces)

    def _write_core(self, path, name, patches, scale, ascii):  # noqa: A002
        self._surface.write(path, name, **writing.arguments_of(patches), scale=scale, ascii=ascii)

    def __repr__(self):
        return repr(self.report).replace(type(self.report).__name__, type(self).__name__, 1)


def names_of_patches(mesh):
    """A tuple of names; empty where a mesh was made without patches."""
    return () if mesh._patches is None else mesh._patches.names


def numbers_of_patches(mesh):
    """int32 (T,), read-only; empty likewise."""
    found = np.zeros(0, dtype=np.int32) if mesh._patches is None else mesh._patches.of_triangle.view()
    found.flags.writeable = False
    return found


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
