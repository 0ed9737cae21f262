# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples of Wang 2010, tables I to III, with models that stand for the paper's, which are not public.

Scans of $MESHQUALITY_DATA have the paper's numbers of triangles: longest edges are halved until there are as many, or VTK
decimates them. Files that are open or not manifold are repaired first, by the exact union of one operand. What the paper made
(helix, slices, cylinder, rings, bars) is made here after its figures. All coordinates are single-precision numbers.
"""

import sys
from dataclasses import dataclass, field
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import boolean_models
import mesh_files
import numpy as np
from inside_freecad import data_folder


@dataclass(frozen=True)
class Example:
    """A row of table I; *that* in a name is the result of the row above. `faces` has the paper's triangles of both operands,
    None where it does not give them. `paper` has for 257, 513 and 1025 rays the seconds on the clock of the whole and of
    sampling; the other systems have seconds or None where they failed, `errors` the mean and the largest of table II in per cent
    of the diagonal, `full` the mean and the seconds of table III.
    """

    name: str
    operation: str
    faces: tuple
    paper: dict
    others: dict
    errors: dict = field(default_factory=dict)
    full: tuple = ()


def _times(*pairs):
    return dict(zip((257, 513, 1025), pairs))


def _others(acis, cgal, rhinoceros):
    return {"ACIS": acis, "CGAL 2008": cgal, "Rhinoceros": rhinoceros}


EXAMPLES = (
    Example("vase-lion U dragon", "union", (400_000, 277_000),
            _times((4.35, 0.967), (5.26, 1.75), (8.33, 4.04)), _others(None, None, 71)),
    Example("chair - flower", "difference", (464, 158_000),
            _times((0.624, 0.250), (1.51, 0.577), (4.68, 1.59)), _others(1.72, 7.82, 2),
            _times((1.03e-3, 1.43), (7.66e-4, 0.783), (2.89e-4, 0.377)), (9.30e-4, 2.90)),
    Example("pig U filigree", "union", (1_208, 260_000),
            _times((2.23, 0.733), (3.00, 1.31), (5.63, 2.95)), _others(None, None, None)),
    Example("helix - slices", "difference", (74_000, 920),
            _times((1.36, 0.593), (2.56, 0.811), (5.16, 1.48)), _others(19.9, 77.5, 47),
            _times((3.14e-3, 0.842), (1.08e-3, 0.406), (4.12e-4, 0.187)), (2.21e-3, 4.29)),
    Example("that n cylinder", "intersection", (None, 180),
            _times((1.34, 0.515), (2.45, 0.826), (5.82, 2.03)), _others(39.9, 56.9, 58),
            _times((5.67e-3, 0.795), (1.88e-3, 0.414), (9.95e-4, 0.180)), (3.19e-3, 4.15)),
    Example("ring U bars", "union", (10_400, 4_172),
            _times((0.405, 0.203), (0.811, 0.390), (2.23, 1.01)), _others(0.56, None, None)),
    Example("that - bars", "difference", (None, 4_172),
            _times((0.499, 0.234), (1.17, 0.405), (3.12, 1.19)), _others(None, None, None)),
    Example("ring U ring", "union", (12_300, 14_300),
            _times((0.608, 0.234), (1.37, 0.531), (4.09, 1.48)), _others(None, 35.0, None),
            _times((8.22e-4, 0.0496), (5.07e-4, 0.966), (2.31e-4, 0.0365)), (1.67e-4, 3.59)),
    Example("dragon - bunny", "difference", (277_000, 69_600),
            _times((2.47, 0.593), (3.37, 1.11), (6.26, 2.71)), _others(None, None, 25)),
    Example("armadillo U nefertiti", "union", (871_000, 400_000),
            _times((9.00, 1.68), (10.1, 2.59), (15.2, 6.61)), _others(None, None, None)),
    Example("buddha U vase-lion", "union", (871_000, 400_000),
            _times((9.00, 1.68), (10.1, 2.59), (15.2, 6.61)), _others(None, None, None)),
)
BY_NAME = {example.name: example for example in EXAMPLES}


def named(words):
    """The examples whose names contain one of the words; all of them where there are no words."""
    return [example for example in EXAMPLES if not words or any(word in example.name for word in words)]


def operands(name):
    """((V, F), (V, F)) of an example; to be called in FreeCAD."""
    return tuple((vertices.astype(np.float32).astype(float), triangles) for vertices, triangles in _MADE[name]())


def exact(a, b, operation):
    """(V, F) of the exact Boolean of two operands, or of one where the other is None."""
    import MeshQuality as mq

    result = mq.boolean([mesh for mesh in (a, b) if mesh is not None], operation=operation, method="exact")
    return np.array(result.vertices, float) + result.origin, np.array(result.triangles)


def _path(folder, name):
    path = data_folder() / folder / name
    if not path.exists():
        raise FileNotFoundError(f"{path} is not there: name the folder of the models in MESHQUALITY_DATA (docs/papers/wang.md says where "
                                "they come from)")
    return path


def _scan(name):
    return boolean_models.read(_path("boolean", f"{name}.ply.gz"))


def _file(name, count):
    """A file of the data folder, repaired, with this number of triangles (one more where it must be even)."""
    vertices, triangles = mesh_files.read(_path("mesh", name))
    vertices, triangles = exact((vertices.astype(np.float32).astype(float), triangles), None, "union")
    if len(triangles) > count:
        return exact(_decimated(vertices, triangles, count), None, "union")  # which may have folded it onto itself
    return halve_longest(vertices, triangles, count)


def halve_longest(vertices, triangles, count):
    """Halves edges that are the longest of both of their triangles, longest first, until there are this many triangles."""
    while len(triangles) < count:
        corners = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)  # edge k: k to k + 1
        _, first, edge = np.unique(corners.min(axis=1) * len(vertices) + corners.max(axis=1), return_index=True,
                                   return_inverse=True)
        ends = corners[first]
        order = np.argsort(np.argsort(np.linalg.norm(vertices[ends[:, 0]] - vertices[ends[:, 1]], axis=1), kind="stable"))
        edge = edge.reshape(-1, 3)
        longest = order[edge].argmax(axis=1)
        chosen = edge[np.arange(len(edge)), longest]
        both = np.flatnonzero(np.bincount(chosen, minlength=len(first)) == 2)
        both = both[np.argsort(-order[both])][:(count - len(triangles) + 1) // 2]
        middle = np.full(len(first), -1)
        middle[both] = len(vertices) + np.arange(len(both))
        vertices = np.vstack([vertices, vertices[ends[both]].mean(axis=1).astype(np.float32)])
        cut = np.flatnonzero(middle[chosen] >= 0)
        a, b, c = (triangles[cut, (longest[cut] + k) % 3] for k in range(3))
        m = middle[chosen[cut]]
        triangles = triangles.copy()
        triangles[cut] = np.stack([a, m, c], axis=1)
        triangles = np.vstack([triangles, np.stack([m, b, c], axis=1)])
    return vertices, triangles.astype(np.int32)


def _decimated(vertices, triangles, count):
    import vtk
    from offset_parts import poly_data
    from vtk.util.numpy_support import vtk_to_numpy

    decimation = vtk.vtkQuadricDecimation()
    decimation.SetInputData(poly_data(vertices, triangles))
    decimation.SetTargetReduction(1.0 - count / len(triangles))
    decimation.Update()
    found = decimation.GetOutput()
    return (vtk_to_numpy(found.GetPoints().GetData()).astype(float),
            vtk_to_numpy(found.GetPolys().GetData()).reshape(-1, 4)[:, 1:].astype(np.int32))


def _placed(mesh, diagonal=100.0, shift=(0.0, 0.0, 0.0)):
    """The mesh with this diagonal of its box, the middle of which is at `shift`, mm."""
    vertices, triangles = mesh
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    return (vertices - (low + high) / 2) * (diagonal / np.linalg.norm(high - low)) + shift, triangles


def _grid(columns, rows, closed):
    """Triangles of a tube of rows x columns vertices; the rows are joined to a ring where it is closed."""
    i, j = (index.ravel() for index in np.mgrid[:rows if closed else rows - 1, :columns])
    a, b = i * columns + j, i * columns + (j + 1) % columns
    c, d = (i + 1) % rows * columns + j, (i + 1) % rows * columns + (j + 1) % columns
    return np.vstack([np.stack([a, b, d], axis=1), np.stack([a, d, c], axis=1)]).astype(np.int32)


def _lids(columns, rows):
    fan = np.array([(0, k + 1, k) for k in range(1, columns - 1)], np.int32)
    return np.vstack([fan, (rows - 1) * columns + fan[:, ::-1]])


def _torus(major, minor, columns, rows, start=0.0, shift=(0.0, 0.0, 0.0)):
    """`start` is the angle of a row's first vertex about the tube."""
    around = (2 * np.pi * np.arange(rows) / rows)[:, None]
    across = (start + 2 * np.pi * np.arange(columns) / columns)[None, :]
    radius = major + minor * np.cos(across)
    points = np.stack([radius * np.cos(around), radius * np.sin(around), minor * np.sin(across) + 0 * around], axis=2)
    return _outward(points.reshape(-1, 3) + shift, _grid(columns, rows, closed=True))


def _prism(start, end, radius, sides):
    """A bar from a point to another."""
    start, end = np.array(start, float), np.array(end, float)
    axis = (end - start) / np.linalg.norm(end - start)
    u = np.cross(axis, (0.3, 0.5, 0.8))
    u /= np.linalg.norm(u)
    angle = 2 * np.pi * np.arange(sides) / sides
    circle = radius * (np.outer(np.cos(angle), u) + np.outer(np.sin(angle), np.cross(axis, u)))
    return _outward(np.vstack([start + circle, end + circle]),
                    np.vstack([_grid(sides, 2, closed=False), _lids(sides, 2)]))


def _outward(points, triangles):
    a, b, c = (points[triangles[:, k]] - points.mean(axis=0) for k in range(3))
    outward = np.einsum("ij,ij->", a, np.cross(b, c)) > 0
    return points, triangles if outward else np.ascontiguousarray(triangles[:, ::-1])


def _joined(meshes):
    first = np.cumsum([0] + [len(points) for points, _ in meshes[:-1]])
    return (np.vstack([points for points, _ in meshes]),
            np.vstack([triangles + n for n, (_, triangles) in zip(first, meshes)]).astype(np.int32))


def _helix(rows=739, columns=50, turns=3.4, pitch=6.0, major=8.0, minor=1.7):
    around = np.linspace(0.0, 2 * np.pi * turns, rows)[:, None]
    across = (2 * np.pi * np.arange(columns) / columns)[None, :]
    radius = major + minor * np.cos(across)
    points = np.stack([radius * np.cos(around), radius * np.sin(around),
                       pitch * around / (2 * np.pi) + minor * np.sin(across)], axis=2)
    return _outward(points.reshape(-1, 3), np.vstack([_grid(columns, rows, closed=False), _lids(columns, rows)]))


def _slices():
    return _joined([_prism((0.1, 0.2, z), (0.1, 0.2, z + 0.6), 13.0, 24) for z in -1.33 + 2.31 * np.arange(10)])


def _bars(shift):
    """Seven bars across the ring, which go on by the shift along their axes."""
    places = 2.7 * (np.arange(7) - 3)
    return _joined([_prism((y, -15.0 + shift, 0.2), (y, 15.0 + shift, 0.3), 0.9, 150) for y in places])


def _ring():
    return _torus(11.0, 2.6, 40, 130)


_MADE = {
    "vase-lion U dragon": lambda: (_placed(_file("lion_vase_poly.off.gz", 400_000)),
                                   _placed(_scan("dragon277k"), 90.0, (21.0, 6.0, 3.0))),
    "chair - flower": lambda: (_placed(_file("ifam_chair.stl.gz", 464)),
                               _placed(_file("ifam_heptoroid100k.stl.gz", 158_000), 55.0, (3.0, 2.0, 1.0))),
    "pig U filigree": lambda: (_placed(_file("ifam_pig.stl.gz", 1_208)),
                               _placed(_file("ifam_filigree100k.stl.gz", 260_000), 90.0, (9.0, 5.0, 4.0))),
    "helix - slices": lambda: (_helix(), _slices()),
    "that n cylinder": lambda: (exact(*operands("helix - slices"), "difference"),
                                _prism((0.4, 0.3, -4.0), (0.3, 0.2, 26.0), 7.9, 46)),
    "ring U bars": lambda: (_ring(), _bars(0.0)),
    "that - bars": lambda: (exact(*operands("ring U bars"), "union"), _bars(18.0)),
    "ring U ring": lambda: (_torus(10.0, 2.0, 41, 150, np.pi / 2),
                            _torus(10.0, 1.6, 48, 150, -np.pi / 2, (0.0, 0.0, 3.6))),
    "dragon - bunny": lambda: (_scan("dragon277k"), _scan("bunny70k")),
    "armadillo U nefertiti": lambda: (_scan("armadillo871k"), _scan("nefertiti400k")),
    "buddha U vase-lion": lambda: (_placed(_file("buddha_100k.obj.gz", 871_000)),
                                   _placed(_file("lion_vase_poly.off.gz", 400_000), 85.0, (14.0, 10.0, 6.0))),
}
