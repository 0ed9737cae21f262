# SPDX-License-Identifier: LGPL-2.1-or-later
"""ElementMesh: elements of any kind and order that come from elsewhere."""

from ...listing import Public
from ..elements import kinds
from ..elements.boundary import boundary_of
from ..sources import convert, frames
from . import element_writing, reading


class ElementMesh(metaclass=Public):
    """A mesh of lines, triangles, quadrilaterals, tetrahedra, pyramids, prisms and hexahedra.

    nodes          float64 (N, 3), mm
    blocks         tuple of ElementBlock, volumes first
    groups         tuple of names
    group_members  {name: ((index of a block, int32 indices of elements in it), ...)}: all elements of each group,
                   of which some may be in several
    faults         tuple of sentences: what is odd about the mesh, which was taken as it is

    The arrays are read-only. mq.read_mesh(path) and ElementMesh.of(source) make it.
    """

    __slots__ = ("_blocks", "_faults", "_members", "_nodes")

    def __init__(self, content):
        self._nodes, self._blocks, self._members, self._faults = content
        for array in (self._nodes, *(array for block in self._blocks for array in block[2:]),
                      *(rows for parts in self._members.values() for _, rows in parts)):
            array.flags.writeable = False

    @classmethod
    def read(cls, path, scale=1.0):
        """The mesh in a file; see mq.read_mesh."""
        return cls(reading.content_of_file(path, scale))

    @classmethod
    def of(cls, source):
        """The mesh of a Fem.FemMesh, of a document object that has one (with its placement in the document), of a CurvedMesh or
        a SurfaceMesh.

        Raises InvalidInput for other things.
        """
        return source if isinstance(source, cls) else cls(reading.content_of(source))

    nodes = property(lambda self: self._nodes, doc="float64 (N, 3), mm")
    blocks = property(lambda self: self._blocks, doc="tuple of ElementBlock")
    groups = property(lambda self: tuple(self._members), doc="tuple of names")
    group_members = property(lambda self: dict(self._members), doc="{name: ((block, int32 indices), ...)}")
    faults = property(lambda self: self._faults, doc="tuple of sentences")

    @property
    def suffixes(self):
        """The extensions of files that hold all its elements, for write."""
        return element_writing.suffixes_for(self)

    @property
    def dimension(self):
        """The highest dimension of the elements: 1, 2 or 3."""
        return max(kinds.DIMENSION[block.kind] for block in self._blocks)

    def boundary(self):
        """The faces of volume elements that no other one has, or the triangles and quadrilaterals of a mesh without volumes:
        a tuple of int32 (F, nodes per face), one for each kind and order of faces, rows of nodes in Gmsh's
        order, outward.
        """
        return boundary_of(self._blocks)

    def moved(self, placement):
        """The same mesh moved by a FreeCAD.Placement: a new ElementMesh, or itself where that moves nothing."""
        if frames.is_identity(placement):
            return self
        return type(self)((convert.moved(self._nodes, placement), self._blocks, self._members, self._faults))

    def write(self, path, scale=1.0, format=None):  # noqa: A002
        """Writes into a file, with the groups; one that is there is replaced once the new one is complete.

        path    the extension says the format: .msh (Gmsh 4.1), .vtu (VTK), .inp (Abaqus, CalculiX), .unv (I-DEAS), .nas .bdf
                (Nastran), .su2 (SU2), .cgns (CGNS, by its library), .mesh (MFEM: volumes of orders 1 and 2), .h5 (HOPR: volumes of
                one order), .re2 (Nek5000: hexahedra)
        scale   factor of the coordinates, which are mm: 0.001 for metres
        format  the format whatever the extension, such as "msh"

        Raises InvalidInput naming elements or a group that the format cannot hold, and the formats that can; IoError naming
        the path.
        """
        element_writing.write(self, path, scale, format)

    def __repr__(self):
        counts = [f"{len(block.nodes):,} {kinds.PLURALS[block.kind] if len(block.nodes) != 1 else block.kind} of order "
                  f"{block.order}" for block in self._blocks]
        groups = len(self._members)
        named = f", {groups:,} group{'s' if groups != 1 else ''}" if groups else ""
        return f"<{type(self).__name__}: {', '.join(counts)}, {len(self._nodes):,} nodes{named}>"


def read_mesh(path, scale=1.0):
    """The mesh in a file: an ElementMesh with the elements, the groups and the CAD entities that it has.

    path   the extension says the format: .msh .msh2 (Gmsh 2 and 4.1, text and binary) .inp (Abaqus, CalculiX) .unv
           .vtu .vtk .med .cgns .su2 .nas .bdf (Nastran) .exo .e
    scale  factor from the file's coordinates to mm: 1000 for files in metres

    All nodes are in Gmsh's order, whatever the file's order is. .med and .exo that are HDF5 need h5py (Debian:
    python3-h5py), .cgns the CGNS library (libcgns-dev).

    Raises IoError naming the path where there is no such file or it is damaged; InvalidInput naming the element where
    the mesh in it cannot be used.
    """
    return ElementMesh.read(path, scale)
