# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of meshes, read back by the programs that they are for: VTK, Gmsh, MeshLab, FreeCAD FEM.

test_curved_files does the same for curved meshes with Gmsh and VTK.
"""

import os
import re
import shutil
import signal
import subprocess
import unittest
from functools import lru_cache

import FreeCAD
import helpers
import numpy as np
import Part
from test_curved_files import FileTest, has

import MeshQuality as mq

try:
    import resource
except ImportError:  # Windows
    resource = None

# From 1.0 on FreeCAD turns VTK's order of the nodes of a tetrahedron into its own; before, it takes it for its own, which
# is turned the other way round.
VTK_ORDER_IS_TURNED = tuple(int(part) for part in FreeCAD.Version()[:2]) >= (1, 0)

# Prints points, triangles, area and volume of flat meshes, and the corners of their boxes.
READ_BY_VTK = """
import json, os, sys
from vtkmodules.vtkFiltersCore import vtkMassProperties
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
readers = {".vtu": vtkXMLUnstructuredGridReader, ".stl": vtkSTLReader, ".ply": vtkPLYReader,
           ".obj": vtkOBJReader}
results = []
for path in sys.argv[1:]:
    reader = readers[os.path.splitext(path)[1]]()
    reader.SetFileName(path)
    reader.Update()
    data, surface, mass = reader.GetOutput(), vtkDataSetSurfaceFilter(), vtkMassProperties()
    surface.SetInputData(data)
    mass.SetInputConnection(surface.GetOutputPort())
    mass.Update()
    cells = data.GetCellData()
    cells = [cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())]
    results.append({"points": data.GetNumberOfPoints(), "triangles": data.GetNumberOfCells(),
                    "area": mass.GetSurfaceArea(), "volume": mass.GetVolume(),
                    "bounds": data.GetBounds(), "cell data": cells})
print(json.dumps(results))
"""

READ_BY_GMSH = """
import json, sys
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
results = []
for path in sys.argv[1:]:
    gmsh.clear()
    gmsh.open(path)
    mesh = gmsh.model.mesh
    nodes, places, _ = mesh.getNodes()
    points, weights = mesh.getIntegrationPoints(2, "Gauss2")
    _, determinants, _ = mesh.getJacobians(2, points)
    kinds, elements, _ = mesh.getElements(2)
    results.append({
        "points": len(nodes), "kinds": [int(kind) for kind in kinds], "triangles": len(elements[0]),
        "area": float((determinants.reshape(-1, len(weights)) * weights).sum()),
        "bounds": [f(places[i::3]) for i in range(3) for f in (min, max)]})
print(json.dumps(results))
"""

MEASURES = """<!DOCTYPE FilterScript>
<FilterScript><filter name="Compute Geometric Measures"/></FilterScript>
"""


@lru_cache(1)
def part():
    """A part with a bore, not around the origin, and its mesh."""
    shape = Part.makeBox(10, 20, 30).cut(Part.makeCylinder(3, 40, FreeCAD.Vector(5, 10, -5)))
    shape.translate(FreeCAD.Vector(7, -3, 2))
    return shape, mq.triangulate(shape, chord_height=0.05)


def bounds_of(mesh):
    low, high = mesh.report.box
    return [value for pair in zip(low, high) for value in pair]


class FlatMeshes(FileTest):
    def setUp(self):
        super().setUp()
        _, self.mesh = part()

    def assert_same(self, read, format_name, points=None, digits=6):
        """What a program found in a file is what the mesh has."""
        report = self.mesh.report
        with self.subTest(format_name):
            self.assertEqual(read["triangles"], report.triangles)
            self.assertEqual(read["points"], points or report.vertices)
            self.assertAlmostEqual(read["area"] / report.area, 1.0, places=digits)
            if "volume" in read:
                self.assertAlmostEqual(read["volume"] / report.volume, 1.0, places=digits)
            np.testing.assert_allclose(read["bounds"], bounds_of(self.mesh), atol=1e-5)

    @unittest.skipUnless(has("vtkmodules"), "VTK's Python module is not installed")
    def test_vtk(self):
        formats = ("vtu", "stl", "ply", "obj")
        paths = [self.write(self.mesh, f"part.{name}") for name in formats]
        found = dict(zip(formats, self.read(READ_BY_VTK, paths)))
        for name in formats:
            self.assert_same(found[name], name)
        self.assertIn("cad_face", found["vtu"]["cell data"])

    @unittest.skipUnless(has("gmsh"), "Gmsh's Python module is not installed")
    def test_gmsh(self):
        formats = ("msh", "stl")
        paths = [self.write(self.mesh, f"part.{name}") for name in formats]
        for name, read in zip(formats, self.read(READ_BY_GMSH, paths)):
            self.assertEqual(read["kinds"], [2])
            self.assert_same(read, name)

    @unittest.skipUnless(shutil.which("meshlabserver") and shutil.which("xvfb-run"),
                         "meshlabserver (MeshLab) or xvfb-run is not installed")
    def test_meshlab(self):
        # Not .obj: MeshLab 2020.09 of Debian 12 ends at an assertion on any file of that kind, also
        # on those that it wrote itself.
        script = os.path.join(self.folder, "measures.mlx")
        with open(script, "w", encoding="ascii") as stream:
            stream.write(MEASURES)
        for name in ("ply", "stl", "off"):
            path = self.write(self.mesh, f"part.{name}")
            done = subprocess.run(["xvfb-run", "-a", "meshlabserver", "-i", path, "-s", script],
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                  errors="replace", timeout=120, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            said = done.stdout + done.stderr
            points, triangles = re.search(r"loaded has (\d+) vn (\d+) fn", said).groups()
            low, high = (re.search(rf"Box {end}\s+(\S+)\s+(\S+)\s+(\S+)", said).groups()
                         for end in ("min", "max"))
            self.assert_same({
                "points": int(points), "triangles": int(triangles),
                "area": float(re.search(r"Surface Area is (\S+)", said)[1]),
                "volume": float(re.search(r"Mesh Volume\s+is (\S+)", said)[1]),
                "bounds": [float(value) for pair in zip(low, high) for value in pair],
            }, name, digits=5)

    def test_freecad_fem(self):
        import Fem

        found = Fem.read(self.write(self.mesh, "part.vtu"))
        self.assertEqual((found.NodeCount, found.TriangleCount),
                         (self.mesh.report.vertices, self.mesh.report.triangles))
        corners = np.array([[tuple(found.Nodes[node]) for node in found.getElementNodes(face)]
                            for face in found.Faces])
        expected = self.mesh.vertices[self.mesh.triangles] + self.mesh.origin
        np.testing.assert_allclose(corners, expected, atol=1e-5)


# Corners, then the middles of these edges: of FreeCAD's elements of order 2.
EDGES = {6: ((0, 1), (1, 2), (2, 0)), 10: ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))}


def volumes_of(nodes):
    """The volume of tetrahedra (E, 10, 3) with EDGES[10], negative for those turned inside out.

    By a rule of five points that is exact for the cubic determinant (Zienkiewicz).
    """
    total = np.zeros(len(nodes))
    for place, weight in [((0.25,) * 4, -0.8)] + [
            (tuple(0.5 if i == k else 1 / 6 for i in range(4)), 0.45) for k in range(4)]:
        slopes = np.vstack([np.eye(3), [-1, -1, -1]])[[3, 0, 1, 2]]  # of the four coordinates
        rows = [(4 * place[i] - 1) * slopes[i] for i in range(4)]
        rows += [4 * (place[i] * slopes[j] + place[j] * slopes[i]) for i, j in EDGES[10]]
        total += weight * np.linalg.det(np.einsum("nk,enx->exk", np.array(rows), nodes))
    return total / 6


@unittest.skipUnless(resource, "there are no limits of files")
class WithoutRoom(FileTest):
    """What libraries of formats make of a disk that is full: they crashed, or raised errors of their own."""

    def test_the_error_names_the_path_and_nothing_stays(self):
        mesh = mq.curve(Part.makeSphere(5), order=2, volume=True, chord_height_relative=0.05)
        old, limits = signal.signal(signal.SIGXFSZ, signal.SIG_IGN), resource.getrlimit(resource.RLIMIT_FSIZE)
        try:
            for suffix in (".h5", ".exo", ".cgns", ".msh", ".vtu"):
                path = os.path.join(self.folder, "mesh" + suffix)
                for room in (0, 3000, 20000):
                    with self.subTest(suffix, room=room):
                        resource.setrlimit(resource.RLIMIT_FSIZE, (room, limits[1]))
                        with self.assertRaisesRegex(mq.IoError, re.escape(path)):
                            mesh.write(path)
                        self.assertEqual(os.listdir(self.folder), [])
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)
            signal.signal(signal.SIGXFSZ, old)


class CurvedMeshesInFem(FileTest):
    def fem_nodes(self, mesh, elements):
        """float64 (E, nodes, 3): where the nodes of the elements of a Fem.FemMesh lie."""
        places = mesh.Nodes
        return np.array([[tuple(places[node]) for node in mesh.getElementNodes(element)]
                         for element in elements])

    def assert_middles(self, nodes):
        """Each middle node lies nearer to the middle of its edge than to that of another edge."""
        pairs = np.array(EDGES[nodes.shape[1]])
        middles = nodes[:, pairs].mean(axis=2)
        inner = nodes[:, -len(pairs):]
        apart = np.linalg.norm(inner[:, :, None] - middles[:, None], axis=3)
        self.assertTrue((apart.argmin(axis=2) == np.arange(len(pairs))).all())

    def test_tetrahedra(self):
        import Fem

        curved = mq.curve(Part.makeCylinder(5, 10), order=2, volume=True)
        given = curved.to_fem_mesh()
        expected = self.fem_nodes(given, given.Volumes)
        self.assert_middles(expected)
        # FreeCAD's tetrahedra are turned the other way round than this formula has them.
        self.assertAlmostEqual(-volumes_of(expected).sum() / curved.report.volume, 1.0, places=9)
        self.assertLess(volumes_of(expected).max(), 0.0)
        for name in ("inp", "unv", "vtu"):
            with self.subTest(name):
                path = os.path.join(self.folder, "part." + name)
                (curved if name == "vtu" else given).write(path)
                read = Fem.read(path)
                self.assertEqual((read.NodeCount, read.TetraCount),
                                 (len(curved.nodes), len(curved.elements)))
                found = self.fem_nodes(read, read.Volumes)
                self.assert_middles(found)
                if name == "vtu":
                    volumes = volumes_of(found) * (-1.0 if VTK_ORDER_IS_TURNED else 1.0)
                    self.assertGreater(volumes.min(), 0.0)
                    self.assertAlmostEqual(volumes.sum() / curved.report.volume, 1.0, places=6)
                else:
                    np.testing.assert_allclose(found, expected, atol=1e-6)

    def test_triangles_and_straight_elements(self):
        import Fem

        torus, cylinder = Part.makeTorus(10, 3), Part.makeCylinder(5, 10)
        for curved in (mq.curve(torus, order=2), mq.curve(torus, order=1),
                       mq.curve(cylinder, order=1, volume=True)):
            given = curved.to_fem_mesh()
            expected = self.fem_nodes(given, given.Volumes or given.Faces)
            if not given.Volumes:
                np.testing.assert_array_equal(expected, curved.nodes[curved.triangles])
            for name in ("inp", "unv", "vtu"):
                with self.subTest(f"{curved} {name}"):
                    path = os.path.join(self.folder, "part." + name)
                    (curved if name == "vtu" else given).write(path)
                    read = Fem.read(path)
                    self.assertEqual((read.NodeCount, read.TriangleCount, read.TetraCount),
                                     (len(curved.nodes), given.TriangleCount, given.TetraCount))
                    found = self.fem_nodes(read, read.Volumes or read.Faces)
                    if name == "vtu" and read.Volumes:
                        corners = [0, 2, 1, 3] if VTK_ORDER_IS_TURNED else [0, 1, 2, 3]
                        expected = curved.nodes[curved.elements[:, corners]]
                    np.testing.assert_allclose(found, expected, atol=1e-5)

    def test_a_wrong_order_of_nodes_is_noticed(self):
        curved = mq.curve(Part.makeCylinder(5, 10), order=2, volume=True)
        given = curved.to_fem_mesh()
        nodes = self.fem_nodes(given, given.Volumes)[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]]
        with self.assertRaises(AssertionError):
            self.assert_middles(nodes)
        self.assertGreater(abs(-volumes_of(nodes).sum() / curved.report.volume - 1.0), 1e-3)

