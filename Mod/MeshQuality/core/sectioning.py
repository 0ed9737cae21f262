# SPDX-License-Identifier: LGPL-2.1-or-later
"""section: a mesh cut by a plane, as polygons and in whole elements."""

import os

import numpy as np

from ..errors import InvalidInput
from ..listing import Public
from .curving import holds_elements, taken_from
from .elements import kinds
from .elements.assembly import Content
from .inspect import tables
from .inspect.section import Cut, Plane, corners_of, cut_triangles, cut_volumes, enclosed_area, filled, is_closed, lines_of, triangles_of
from .meshes.element_mesh import ElementMesh, read_mesh
from .meshes.surface_mesh import SurfaceMesh, surface_of
from .operands.operands import is_arrays
from .sources import convert, frames


class MeshSection(metaclass=Public):
    """A mesh cut by a plane.

    point, normal  of the plane; the normal points to the half that is cut off
    element   int (P,), the elements that the plane cuts, by their numbers in the table of measures
    polygons  tuple of float64 (n, 3), the cut of each: a ring of points of a volume element, two points of a triangle
    areas     float64 (P,), mm^2, of the rings; empty for surfaces
    area      mm^2: the sum of these; of a surface what its cut encloses, not a number where that is open
    outlines  tuple of float64 (n, 3): of a surface its cut as lines, with what is inside on their left seen from the half that is cut
              off; the first point of a closed line is also its last one
    behind    int (B,), the elements whose middle is not in the half that is cut off

    Elements are cut by their corners: sides of elements of order 2 and more are taken as straight.
    """

    __slots__ = {"_cut": None, "_mesh": None, "_plane": None, "_triangles": None, "area": "mm^2", "behind": "int (B,)",
                 "outlines": "tuple of float64 (n, 3)"}

    def __init__(self, mesh, plane):
        self._mesh, self._plane, self._triangles, self.outlines = mesh, plane, None, ()
        blocks = corners_of(mesh)
        centres = np.concatenate([mesh.nodes[corners].mean(axis=1) for _, corners in blocks])
        self.behind = np.flatnonzero(plane.heights(centres) <= 0.0)
        if mesh.dimension == 3:
            self._cut = cut_volumes(mesh.nodes, blocks, plane)
            self.area = float(self._cut.areas.sum())
            return
        triangles, owner = triangles_of(blocks)
        cut = cut_triangles(mesh.nodes, triangles, plane)
        self.outlines = lines_of(cut.points)
        closed = all(map(is_closed, self.outlines))
        self.area = enclosed_area(cut.points, plane) if closed else float("nan")
        self._cut = Cut(owner[cut.element], cut.points, cut.counts)

    point = property(lambda self: self._plane.point, doc="float64 (3,), mm")
    normal = property(lambda self: self._plane.normal, doc="float64 (3,) of length 1")
    element = property(lambda self: self._cut.element, doc="int (P,)")
    areas = property(lambda self: self._cut.areas if self._mesh.dimension == 3 else np.zeros(0), doc="float64 (P,), mm^2")
    polygons = property(lambda self: tuple(points[:count] for points, count in zip(self._cut.points, self._cut.counts.tolist())),
                        doc="tuple of float64 (n, 3), mm")

    def triangles(self):
        """(float64 (T, 3, 3), int (T,)): triangles that fill the cut, for drawing, and the element of each; -1 for surfaces."""
        if self._mesh.dimension == 3:
            corners, ring = self._cut.fans()
            return corners, self.element[ring]
        corners = filled(self._cut.points, self._plane)
        return corners, np.full(len(corners), -1)

    def half(self):
        """The ElementMesh of the whole elements `behind` the plane, with their groups. Raises InvalidInput where there is none."""
        if not len(self.behind):
            raise InvalidInput("no element is behind the plane: move it along its normal, or turn it")
        return ElementMesh(_content_of(self._mesh, self.behind))

    def write_csv(self, path):
        """Writes a line for each element that is cut: its number, the middle of its polygon in mm and the area in mm^2, of triangles
        the length in mm. Raises IoError naming the path.
        """
        solid = self._mesh.dimension == 3
        sizes = self.areas if solid else np.linalg.norm(self._cut.points[:, 1] - self._cut.points[:, 0], axis=1)
        middles = [points.mean(axis=0).tolist() for points in self.polygons]
        tables.write(path, ("element", "x", "y", "z", "area" if solid else "length"),
                     ((number, *(f"{x:.9g}" for x in middle), f"{size:.9g}")
                      for number, middle, size in zip(self.element.tolist(), middles, sizes.tolist())))

    def to_dict(self):
        """All but the arrays, for JSON."""
        return {"point": self.point.tolist(), "normal": self.normal.tolist(), "elements": len(self.element), "area": self.area,
                "outlines": len(self.outlines), "behind": len(self.behind), "notes": []}

    def __str__(self):
        lines = [f"section      {len(self.element):,} elements are cut, {len(self.behind):,} are behind the plane",
                 f"area         {self.area:.6g} mm^2"]
        if self._mesh.dimension == 2:
            lines.append(f"outlines     {len(self.outlines):,}")
        return "\n".join(lines) + "\n"

    def __repr__(self):
        return f"<MeshSection: {len(self.element):,} elements, {self.area:.6g} mm^2>"


def section(mesh, point, normal):
    """Cuts a mesh by a plane -> MeshSection: the polygons, their area, and the elements behind it as a mesh.

    mesh    what mq.measures takes: a surface or volume mesh, an object of the document with one, or the name of a file
    point   (x, y, z) in mm on the plane
    normal  (x, y, z) of any length, or "x", "-x", "y" and so on: it points to the half that is cut off

    Raises InvalidInput for other things, and a mesh of lines only; IoError naming a file.
    """
    plane = Plane.of(point, normal)
    if frames.is_object(mesh) and holds_elements(mesh):
        mesh = taken_from(mesh)()
    if convert.is_mesh(mesh) or is_arrays(mesh):
        mesh = SurfaceMesh(surface_of(mesh, measured=False))
    mesh = read_mesh(mesh) if isinstance(mesh, (str, os.PathLike)) else ElementMesh.of(mesh)
    if mesh.dimension < 2:
        raise InvalidInput("the mesh has lines only: sections are of surfaces and volumes")
    return MeshSection(mesh, plane)


def _content_of(mesh, chosen):
    """The Content of those elements of the highest dimension of an ElementMesh that are chosen, with their groups."""
    blocks, members, first, number = [], {}, 0, np.full(len(mesh.nodes), -1, dtype=np.int32)
    for i, block in enumerate(mesh.blocks):
        if kinds.DIMENSION[block.kind] != mesh.dimension:
            continue
        rows = chosen[(chosen >= first) & (chosen < first + len(block.nodes))] - first
        first += len(block.nodes)
        if not len(rows):
            continue
        for name, parts in mesh.group_members.items():
            for own in (np.flatnonzero(np.isin(rows, found)).astype(np.int32) for at, found in parts if at == i):
                if len(own):
                    members.setdefault(name, []).append((len(blocks), own))
        blocks.append(block._replace(nodes=block.nodes[rows], group=block.group[rows], geometry=block.geometry[rows]))
    used = np.unique(np.concatenate([block.nodes.ravel() for block in blocks]))
    number[used] = np.arange(len(used))
    names = {name: i for i, name in enumerate(members)}
    blocks = [block._replace(nodes=number[block.nodes], group=np.array(
        [names.get(mesh.groups[group], -1) if group >= 0 else -1 for group in block.group.tolist()], dtype=np.int32)) for block in blocks]
    return Content(mesh.nodes[used], tuple(blocks), {name: tuple(parts) for name, parts in members.items()}, ())
