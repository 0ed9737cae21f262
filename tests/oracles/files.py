# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every writer with a reader of somebody else's (FreeCAD, VTK, meshio, Gmsh, netCDF, h5py, and a few lines for plain texts), and
read_mesh on files that meshio wrote: the same triangles and elements, with the same corners.
"""

import contextlib
import io
import os
import re
import tempfile
import warnings
import zipfile
from xml.etree import ElementTree

import gmsh
import h5py
import measures
import Mesh
import meshio
import MeshQuality as mq
import netCDF4
import numpy as np
import solids
import vtk
from judge import Judge, dice_of
from vtk.util.numpy_support import vtk_to_numpy

KINDS = [*solids.SOLIDS]


def check(shape, seed):
    dice, _ = dice_of("files", seed)
    judge, size = Judge(), measures.size(shape)
    chord_height = 0.02 * size
    flat = mq.triangulate(shape, chord_height=chord_height)
    with tempfile.TemporaryDirectory() as folder:
        for name in dice.sample(sorted(SURFACES), 7):
            _surface(judge, flat, name, dice, os.path.join(folder, f"flat{name.split()[0]}"))
        order = dice.choice([1, 2])
        solid = mq.curve(shape, order=order, volume=True, chord_height=chord_height)
        for name in dice.sample(sorted(ELEMENTS), 3):
            path = os.path.join(folder, f"solid{name}")
            solid.write(path)
            _same(judge, f"{name} of order {order}", ELEMENTS[name](path), (solid.nodes, solid.tetrahedra[:, :4]))
        for name in dice.sample(sorted(WRITTEN_BY_MESHIO), 3):
            _read(judge, solid, name, folder)
    return judge.verdict()


def _surface(judge, flat, name, dice, path):
    scale = dice.choice([1.0, 1.0, 0.001])
    flat.write(path, scale=scale, ascii="text" in name)
    _same(judge, f"{name}, scale {scale}", SURFACES[name](path), ((flat.vertices + flat.origin) * scale, flat.triangles))


def _same(judge, name, found, right):
    """The same simplices with the same corners; for triangles also seen from the same side."""
    if len(found[1]) != len(right[1]):
        judge.claim(False, f"{name}: {len(found[1])} elements read, {len(right[1])} written")
        return
    allowed = 2e-5 * np.ptp(right[0], axis=0).max() + 4 * measures.rounding(right[0])
    mine, other = (np.asarray(points)[np.asarray(cells)] for points, cells in (found, right))
    rank = [np.lexsort(np.rint(one.mean(axis=1).T / (4 * allowed))) for one in (mine, other)]
    turned = [_from_the_first(one[order], allowed) for one, order in zip((mine, other), rank)]
    off = np.abs(turned[0] - turned[1]).max(axis=(1, 2))
    if (off > allowed).any():  # middles on the border of two cells of the rounding: by the nearest
        from scipy.spatial import cKDTree  # noqa: PLC0415

        _, nearest = cKDTree(other.reshape(len(other), -1)).query(_turns(mine).reshape(-1, other[0].size))
        off = np.abs(other.reshape(len(other), -1)[nearest] - _turns(mine).reshape(-1, other[0].size)).max(axis=1)
        off = off.reshape(len(mine), -1).min(axis=1)
    judge.claim((off <= allowed).all(), f"{name}: {(off > allowed).sum()} of {len(off)} elements have other corners, by "
                f"{off.max():.4g}")


def _from_the_first(cells, allowed):
    """Each simplex turned so that its least corner comes first, without being mirrored."""
    turns = _turns(cells)
    keys = np.rint(turns[:, :, 0] / (4 * allowed))
    best = np.array([min(range(len(key)), key=lambda k: tuple(key[k])) for key in keys])
    return turns[np.arange(len(cells)), best]


def _turns(cells):
    """[simplex, turn, corner, coordinate]: the even permutations of its corners."""
    ways = [(0, 1, 2), (1, 2, 0), (2, 0, 1)] if cells.shape[1] == 3 else [
        (0, 1, 2, 3), (0, 2, 3, 1), (0, 3, 1, 2), (1, 0, 3, 2), (1, 2, 0, 3), (1, 3, 2, 0),
        (2, 0, 1, 3), (2, 1, 3, 0), (2, 3, 0, 1), (3, 0, 2, 1), (3, 1, 0, 2), (3, 2, 1, 0)]
    return np.stack([cells[:, way] for way in ways], axis=1)


# Readers: a path -> (points, corners of the triangles)


def by_freecad(path):
    points, facets = Mesh.Mesh(path).Topology
    return np.array([tuple(point) for point in points]), np.array(facets)


def by_vtk(reader):
    def read(path):
        made = reader()
        made.SetFileName(path)
        made.Update()
        data = made.GetOutput()
        cells = vtk_to_numpy(data.GetPolys().GetData()).reshape(-1, 4)[:, 1:]
        return vtk_to_numpy(data.GetPoints().GetData()).astype(float), cells

    return read


def _quiet(call, *arguments, **options):
    """meshio warns, prints, and ends the program where it cannot read a file."""
    with warnings.catch_warnings(), contextlib.redirect_stdout(io.StringIO()):
        warnings.simplefilter("ignore")
        try:
            return call(*arguments, **options)
        except SystemExit as error:
            raise ValueError(f"meshio ends with {error}") from error


def by_meshio(form, corners=3):
    names = {3: ("triangle", "triangle6", "triangle10"), 4: ("tetra", "tetra10", "tetra20")}[corners]

    def read(path):
        mesh = _quiet(meshio.read, path, file_format=form)
        cells = [block.data[:, :corners] for block in mesh.cells if block.type in names]
        return mesh.points, np.concatenate(cells) if cells else np.zeros((0, corners), int)

    return read


def by_gmsh(dimension):
    def read(path):
        gmsh.initialize()
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            gmsh.open(path)
            tags, points, _ = gmsh.model.mesh.getNodes()
            where = np.zeros(int(tags.max()) + 1, dtype=int)
            where[tags.astype(int)] = np.arange(len(tags))
            kinds, _, nodes = gmsh.model.mesh.getElements(dimension)
            cells = [where[np.asarray(found, dtype=int)].reshape(-1, gmsh.model.mesh.getElementProperties(kind)[3])
                     for kind, found in zip(kinds, nodes)]
            return points.reshape(-1, 3), np.concatenate([found[:, :dimension + 1] for found in cells])
        finally:
            gmsh.finalize()

    return read


def by_netcdf(corners):
    def read(path):
        with netCDF4.Dataset(path) as data:
            points = np.column_stack([data["coord" + axis][:] for axis in "xyz"] if "coordx" in data.variables
                                     else list(data["coord"][:]))
            cells = [value[:, :corners] - 1 for name, value in data.variables.items()
                     if name.startswith("connect") and value.elem_type.upper().startswith(("TRI", "TET")[corners - 3])]
            return np.array(points), np.concatenate([np.array(one) for one in cells])

    return read


def by_tri(path):
    """Cart3D: numbers of points and triangles, then these."""
    with open(path, encoding="ascii") as stream:
        words = stream.read().split()
    count, triangles = int(words[0]), int(words[1])
    points = np.array(words[2:2 + 3 * count], dtype=float).reshape(-1, 3)
    return points, np.array(words[2 + 3 * count:2 + 3 * (count + triangles)], dtype=int).reshape(-1, 3) - 1


def by_mfem(corners):
    """The corners in the text of MFEM's format 1.0 of order 1."""
    kind = {3: 2, 4: 4}[corners]

    def read(path):
        with open(path, encoding="ascii") as stream:
            text = re.sub(r"#.*", "", stream.read())
        lines = text.split("elements", 1)[1].split("boundary")[0].split("\n")
        rows = [list(map(int, line.split())) for line in lines if len(line.split()) > 2]
        cells = np.array([row[2:] for row in rows if row[1] == kind])
        words = text.split("vertices", 1)[1].split()
        return np.array(words[2:2 + 3 * int(words[0])], dtype=float).reshape(-1, 3), cells

    return read


def by_unv(path):
    """I-DEAS universal: datasets 2411 (nodes) and 2412 (elements)."""
    with open(path, encoding="ascii") as stream:
        blocks = re.split(r"^ {4}-1\n", stream.read(), flags=re.M)
    nodes, cells = {}, []
    for block in blocks:
        lines = block.splitlines()
        if lines and lines[0].strip() == "2411":
            for head, row in zip(lines[1::2], lines[2::2]):
                nodes[int(head.split()[0])] = [float(word.replace("D", "E")) for word in row.split()]
        if lines and lines[0].strip() == "2412":
            words = [line.split() for line in lines[1:]]
            cells += [row[:3] for head, row in zip(words, words[1:]) if len(head) == 6 and head[1] in ("41", "91")
                      and len(row) == 3]
    where = {tag: k for k, tag in enumerate(nodes)}
    return np.array([*nodes.values()]), np.array([[where[int(tag)] for tag in row] for row in cells])


def by_3mf(path):
    with zipfile.ZipFile(path) as archive:
        name = next(name for name in archive.namelist() if name.endswith(".model"))
        root = ElementTree.fromstring(archive.read(name))
    space = {"m": root.tag[1:].split("}")[0]}
    points = [[float(one.get(axis)) for axis in "xyz"] for one in root.findall(".//m:vertex", space)]
    cells = [[int(one.get(f"v{k}")) for k in (1, 2, 3)] for one in root.findall(".//m:triangle", space)]
    return np.array(points), np.array(cells)


def by_amf(path):
    data = zipfile.ZipFile(path) if zipfile.is_zipfile(path) else None
    root = ElementTree.fromstring(data.read(data.namelist()[0])) if data else ElementTree.parse(path).getroot()
    points = [[float(one.find(axis).text) for axis in "xyz"] for one in root.iter("coordinates")]
    return np.array(points), np.array([[int(one.find(f"v{k}").text) for k in (1, 2, 3)] for one in root.iter("triangle")])


def by_cgns(path):
    """The coordinates and TRI_3 sections of CGNS in HDF5."""
    with h5py.File(path, "r") as file:
        found = {}

        def visit(name, node):
            if isinstance(node, h5py.Dataset) and name.endswith(" data"):
                found[name] = np.array(node)

        file.visititems(visit)
    points = np.column_stack([next(value for name, value in found.items() if f"Coordinate{axis}" in name) for axis in "XYZ"])
    cells = []
    for name, value in found.items():
        kind = found.get(name.replace("/ElementConnectivity/ data", "/ data"))
        if name.endswith("ElementConnectivity/ data") and kind is not None and kind[0] == 5:
            cells.append(value.reshape(-1, 3) - 1)
    return points, np.concatenate(cells)


def by_vtu(corners):
    """The corners come first, whatever the order of the cells."""
    kinds = {3: (vtk.VTK_TRIANGLE, vtk.VTK_QUADRATIC_TRIANGLE, vtk.VTK_LAGRANGE_TRIANGLE),
             4: (vtk.VTK_TETRA, vtk.VTK_QUADRATIC_TETRA, vtk.VTK_LAGRANGE_TETRAHEDRON)}[corners]

    def read(path):
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(path)
        reader.Update()
        grid = reader.GetOutput()
        cells = [[grid.GetCell(k).GetPointId(j) for j in range(corners)] for k in range(grid.GetNumberOfCells())
                 if grid.GetCellType(k) in kinds]
        return vtk_to_numpy(grid.GetPoints().GetData()).astype(float), np.array(cells)

    return read


def by_su2(path):
    """The triangles of all markers: meshio reads no file without volumes."""
    with open(path, encoding="ascii") as stream:
        lines = [line.split() for line in stream]
    start = next(k for k, words in enumerate(lines) if words[0] == "NPOIN=")
    points = [words[:3] for words in lines[start + 1:start + 1 + int(lines[start][1])]]
    cells = [words[1:4] for words in lines[start + 1 + len(points):] if words[0] == "5"]
    return np.array(points, dtype=float), np.array(cells, dtype=int)


SURFACES = {
    ".stl": by_freecad, ".stl text": by_meshio("stl"), ".ply": by_vtk(vtk.vtkPLYReader), ".ply by meshio": by_meshio("ply"),
    ".obj": by_vtk(vtk.vtkOBJReader), ".off": by_freecad, ".off by meshio": by_meshio("off"), ".msh": by_gmsh(2),
    ".msh by meshio": by_meshio("gmsh"), ".msh2": by_meshio("gmsh"), ".vtu": by_vtu(3), ".vtu by meshio": by_meshio("vtu"),
    ".su2": by_su2, ".cgns": by_cgns, ".mesh": by_mfem(3), ".inp": by_meshio("abaqus"), ".unv": by_unv,
    ".nas": by_meshio("nastran"), ".bdf": by_meshio("nastran"), ".exo": by_netcdf(3), ".tri": by_tri, ".3mf": by_3mf,
    ".amf": by_amf}
ELEMENTS = {".msh": by_gmsh(3), ".msh2": by_meshio("gmsh", 4), ".vtu": by_vtu(4), ".inp": by_meshio("abaqus", 4),
            ".nas": by_meshio("nastran", 4), ".exo": by_netcdf(4)}
WRITTEN_BY_MESHIO = {"gmsh22": ".msh", "gmsh": ".msh", "vtu": ".vtu", "vtk": ".vtk", "abaqus": ".inp", "med": ".med", "su2": ".su2"}


def _read(judge, solid, form, folder):
    """read_mesh on the tetrahedra as meshio writes them."""
    path = os.path.join(folder, f"given_{form}{WRITTEN_BY_MESHIO[form]}")
    cells, corners = solid.tetrahedra[:, :4], int(solid.tetrahedra[:, :4].max()) + 1
    _quiet(meshio.Mesh(solid.nodes[:corners], [("tetra", cells)]).write, path, file_format=form)
    mesh = mq.read_mesh(path)
    found = [block.nodes for block in mesh.blocks if block.nodes.shape[1] == 4]
    _same(judge, f"read_mesh of {form}", (mesh.nodes, np.concatenate(found)), (solid.nodes, cells))
