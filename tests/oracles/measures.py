# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the oracles measure with, by OpenCASCADE through FreeCAD's Part, NumPy, SciPy and VTK: no code of MeshQuality.

Points are float64 (n, 3) in mm; a mesh is (points, triangles) with triangles int (t, 3), seen from outside.
"""

import math

import FreeCAD
import numpy as np
import Part
import vtk
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

_AT_A_TIME = 2_000_000  # pairs in one array


def vector(point):
    return FreeCAD.Vector(*map(float, point))


def size(shape):
    box = shape.BoundBox
    return max(box.XLength, box.YLength, box.ZLength)


def rounding(points):
    """What single-precision coordinates leave open: of numbers as large as these, mm."""
    if not len(points):
        return 0.0
    return 4e-7 * max(float(np.abs(points).max(initial=0.0)), float(np.ptp(points, axis=0).max(initial=0.0)))


# Shapes


def skin(shape):
    """The faces alone: distances to them are not 0 inside of the solid."""
    return Part.makeCompound(shape.Faces)


def distances(points, shape):
    """Of each point from the shape, by OpenCASCADE."""
    shape, factor = magnified(shape)
    return np.array([shape.distToShape(Part.Vertex(*map(float, factor * point)))[0] for point in np.asarray(points)]) / factor


def magnified(shape):
    """(shape, factor): OpenCASCADE's tolerance of 1e-7 mm is too coarse for the distances of micro parts."""
    factor = 10.0 / size(shape) if size(shape) < 0.1 else 1.0
    if factor > 1.0:
        shape = shape.copy()
        shape.scale(factor)
    return shape, factor


def points_on(shape, numbers, count):
    """Random points on the faces and edges of the shape: (points, the face of each or -1)."""
    found, faces = [], []
    areas = np.array([face.Area for face in shape.Faces])
    chosen = np.concatenate([np.arange(len(areas)), numbers.choice(len(areas), count, p=areas / areas.sum())])
    for k in numbers.permutation(chosen)[:count]:
        face = shape.Faces[k]
        u0, u1, v0, v1 = face.ParameterRange
        for _ in range(20):
            u, v = numbers.uniform(u0, u1), numbers.uniform(v0, v1)
            if face.isPartOfDomain(u, v):
                found.append(tuple(face.valueAt(u, v)))
                faces.append(k)
                break
    for edge in numbers.choice(np.array(range(len(shape.Edges))), min(len(shape.Edges), count // 4), replace=False):
        edge = shape.Edges[edge]
        if not edge.Degenerated:
            found.append(tuple(edge.valueAt(numbers.uniform(*edge.ParameterRange))))
            faces.append(-1)
    return np.array(found), np.array(faces)


def points_around(shape, numbers, count, reach):
    """Random points in the box of the shape, and within a reach of its faces."""
    box, half = shape.BoundBox, count // 2
    low, high = np.array([box.XMin, box.YMin, box.ZMin]), np.array([box.XMax, box.YMax, box.ZMax])
    near, _ = points_on(shape, numbers, half)
    aside = numbers.normal(size=near.shape)
    aside *= (numbers.uniform(0, reach, len(near)) / np.linalg.norm(aside, axis=1))[:, None]
    return np.concatenate([numbers.uniform(low - 0.1 * (high - low), high + 0.1 * (high - low), (half, 3)), near + aside])


def inside(points, shape):
    """Whether each point is in one of the solids, by OpenCASCADE."""
    shape, factor = magnified(shape)
    return np.array([any(solid.isInside(vector(factor * p), 1e-9, False) for solid in shape.Solids)
                     for p in np.asarray(points)], dtype=bool)


def tessellated(shape, tolerance):
    """A mesh of the shape by OpenCASCADE's BRepMesh; points of faces are not joined."""
    points, triangles = shape.copy().tessellate(tolerance)
    return np.array([tuple(p) for p in points]), np.array(triangles, dtype=int).reshape(-1, 3)


def volume_of(shape):
    """(mm^3, mm^3 that this may be wrong) of the solids: OpenCASCADE's own where all faces are elementary between lines and
    conics. Elsewhere BRepGProp is off by up to a third, and a fine mesh of BRepMesh is taken instead.
    """
    found, error = 0.0, 0.0
    for solid in shape.Solids:
        exact, fine = abs(solid.Volume), 1e-3 * size(solid)
        if _is_elementary(solid):
            found, error = found + exact, error + 1e-5 * exact
        else:
            found, error = found + abs(volume(*tessellated(solid, fine))), error + fine * solid.Area
    return found, error


def _is_elementary(solid):
    """Whether BRepGProp can be trusted."""
    surfaces = {type(face.Surface).__name__ for face in solid.Faces}
    curves = {type(edge.Curve).__name__ for edge in solid.Edges if not edge.Degenerated}
    return surfaces <= {"Plane", "Cylinder", "Cone", "Sphere", "Toroid"} and curves <= {"Line", "Circle", "Ellipse"}


# Meshes


def corners(points, triangles):
    return points[triangles]


def volume(points, triangles):
    a, b, c = np.moveaxis(points[triangles] - points.mean(axis=0), 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6.0


def normals(points, triangles):
    """Twice the area times the unit normal, by triangle."""
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    return np.cross(b - a, c - a)


def areas(points, triangles):
    return np.linalg.norm(normals(points, triangles), axis=1) / 2.0


def angles(points, triangles):
    """The smallest angle of each triangle in degrees; by atan2, exact for small ones."""
    edges = np.roll(points[triangles], -1, axis=1) - points[triangles]
    turned = -np.roll(edges, 1, axis=1)
    sines = np.linalg.norm(np.cross(edges, turned), axis=2)
    return np.degrees(np.arctan2(sines, np.einsum("ijk,ijk->ij", edges, turned))).min(axis=1)


def not_closed(triangles):
    """What keeps the triangles from being a closed, oriented manifold by edges, or ""."""
    runs = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    if (runs[:, 0] == runs[:, 1]).any():
        return "a triangle has a vertex twice"
    if len(np.unique(runs, axis=0)) != len(runs):
        return "two triangles run an edge the same way"
    there, back = {*map(tuple, runs.tolist())}, {*map(tuple, runs[:, ::-1].tolist())}
    return f"{len(there - back)} edges have one triangle" if there != back else ""


def components(triangles, count):
    """(number, that of each triangle) of the pieces that hang together by vertices."""
    rows, columns = triangles[:, [0, 1]].T.reshape(-1), triangles[:, [1, 2]].T.reshape(-1)
    _, of_vertex = connected_components(coo_matrix((np.ones(len(rows)), (rows, columns)), (count, count)), directed=False)
    _, of_triangle = np.unique(of_vertex[triangles[:, 0]], return_inverse=True)
    return int(of_triangle.max(initial=-1)) + 1, of_triangle


def winding(points, mesh_points, triangles):
    """Winding numbers of the mesh around points, by the solid angles of van Oosterom and Strackee 1983."""
    result, step = np.zeros(len(points)), max(1, _AT_A_TIME // max(len(triangles), 1))
    for start in range(0, len(points), step):
        rays = mesh_points[triangles][None] - points[start:start + step, None, None]
        lengths = np.linalg.norm(rays, axis=3)
        a, b, c = np.moveaxis(rays, 2, 0)
        la, lb, lc = np.moveaxis(lengths, 2, 0)
        dots = [np.einsum("ijk,ijk->ij", *pair) for pair in ((a, b), (b, c), (c, a))]
        below = la * lb * lc + dots[0] * lc + dots[1] * la + dots[2] * lb
        solid = np.arctan2(np.einsum("ijk,ijk->ij", a, np.cross(b, c)), below)
        result[start:start + step] = solid.sum(axis=1) / (2.0 * math.pi)
    return result


class Nearest:
    """Distances of points from a mesh, by VTK in double precision."""

    def __init__(self, points, triangles):
        self._origin = points.mean(axis=0)
        held = vtk.vtkPoints()
        held.SetDataTypeToDouble()
        held.SetData(numpy_to_vtk(np.ascontiguousarray(points - self._origin), deep=True))
        cells = vtk.vtkCellArray()
        rows = np.column_stack([np.full(len(triangles), 3), triangles]).astype(np.int64)
        cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(rows.reshape(-1), deep=True))
        self._data = vtk.vtkPolyData()
        self._data.SetPoints(held)
        self._data.SetPolys(cells)
        self._locator = vtk.vtkStaticCellLocator()
        self._locator.SetDataSet(self._data)
        self._locator.BuildLocator()

    def distances(self, points):
        found, cell, sub, squared = [0.0] * 3, vtk.reference(0), vtk.reference(0), vtk.reference(0.0)
        result = []
        for point in points - self._origin:
            self._locator.FindClosestPoint(point, found, cell, sub, squared)
            result.append(math.dist(point, found))
        return np.array(result)


def samples(points, triangles, numbers, count):
    """Random points in triangles, large ones more often: (points, the triangle of each)."""
    area = areas(points, triangles)
    chosen = numbers.choice(len(triangles), count, p=area / area.sum())
    weights = numbers.dirichlet([1, 1, 1], count)
    return np.einsum("ij,ijk->ik", weights, points[triangles[chosen]]), chosen


def crossings(points, triangles, group=None):
    """Pairs (edge of one, other triangle) where an edge goes through the inside of a triangle, clear of its border and of
    the edge's ends by a millionth of their size; of different groups only where groups are given. Where triangles only
    touch there is none.
    """
    points = points - points.mean(axis=0)
    edges, owner = _edges_of(triangles)
    found = set()
    for e, t in _near_pairs(points, edges, triangles):
        apart = (edges[e][:, :, None] != triangles[t][:, None, :]).all(axis=(1, 2))
        if group is not None:
            apart &= group[owner[e]] != group[t]
        e, t = e[apart], t[apart]
        hit = _goes_through(points[edges[e]], points[triangles[t]])
        found.update(zip(owner[e[hit]].tolist(), t[hit].tolist()))
    return sorted({(min(pair), max(pair)) for pair in found})


def _edges_of(triangles):
    """Each edge once, and a triangle that has it."""
    runs = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    edges, first = np.unique(runs, axis=0, return_index=True)
    return edges, first % len(triangles)


def _near_pairs(points, edges, triangles):
    """Blocks of (edges, triangles) whose boxes overlap, by a tree over the middles of boxes by sizes of triangles."""
    low, high = points[edges].min(axis=1), points[edges].max(axis=1)
    middle, reach = (low + high) / 2.0, np.linalg.norm(high - low, axis=1) / 2.0
    tops, bottoms = points[triangles].max(axis=1), points[triangles].min(axis=1)
    centers, radii = (tops + bottoms) / 2.0, np.linalg.norm(tops - bottoms, axis=1) / 2.0
    tree, longest = cKDTree(middle), reach.max(initial=0.0)
    for start in range(0, len(triangles), 500):
        block = slice(start, start + 500)
        lists = tree.query_ball_point(centers[block], radii[block] + longest)
        t = np.repeat(np.arange(start, start + len(lists)), [len(one) for one in lists])
        e = np.fromiter((k for one in lists for k in one), dtype=int, count=len(t))
        overlap = ((low[e] <= tops[t]) & (high[e] >= bottoms[t])).all(axis=1)
        yield e[overlap], t[overlap]


def _goes_through(segments, triangles):
    """Which segments go through the inside of their triangles (Moeller and Trumbore 1997), with a margin."""
    margin = 1e-6
    start, way = segments[:, 0], segments[:, 1] - segments[:, 0]
    a, b, c = np.moveaxis(triangles, 1, 0)
    across = np.cross(way, c - a)
    scale = np.einsum("ij,ij->i", b - a, across)
    flat = np.linalg.norm(way, axis=1) * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    steep = np.abs(scale) > 1e-9 * flat
    with np.errstate(divide="ignore", invalid="ignore"):
        u = np.einsum("ij,ij->i", start - a, across) / scale
        other = np.cross(start - a, b - a)
        v = np.einsum("ij,ij->i", way, other) / scale
        t = np.einsum("ij,ij->i", c - a, other) / scale
        inner = (u > margin) & (v > margin) & (u + v < 1 - margin) & (t > margin) & (t < 1 - margin)
    return steep & inner
