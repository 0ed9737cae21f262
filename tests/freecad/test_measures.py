# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures of elements against VTK's vtkMeshQuality and OpenFOAM's checkMesh, where these are installed, and in closed form."""

import csv
import json
import os
import re
import shutil
import subprocess
import time
import unittest

import helpers
import numpy as np
import Part
import test_cli

import MeshQuality as mq
from MeshQuality.core.elements import kinds, measures, shapes
from MeshQuality.core.elements.neighbours import finite_volume_measures

try:
    import vtk
except ImportError:
    vtk = None

CELLS = {"triangle": (5, "Triangle"), "quadrilateral": (9, "Quad"), "tetrahedron": (10, "Tet"), "pyramid": (14, "Pyramid"),
         "prism": (13, "Wedge"), "hexahedron": (12, "Hex")}
WORDS = {"edge_ratio": "EdgeRatio", "aspect_ratio": "AspectRatio", "scaled_jacobian": "ScaledJacobian",
         "equiangle_skew": "EquiangleSkew", "min_angle": "MinAngle", "max_angle": "MaxAngle", "skew": "Skew", "taper": "Taper",
         "warpage": "Warpage"}
OTHER_WORDS = {("hexahedron", "aspect_ratio"): "MaxEdgeRatio", ("prism", "aspect_ratio"): "MaxAspectFrobenius"}
# Other numberings of a hexahedron: VTK's edge ratio looks for the longest edge among the first six only.
NUMBERINGS = {"hexahedron": ((0, 1, 2, 3, 4, 5, 6, 7), (4, 5, 6, 7, 0, 1, 2, 3), (0, 4, 5, 1, 3, 7, 6, 2), (2, 6, 7, 3, 1, 5, 4, 0))}
MOST = 1e-9
ENVIRONMENT = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}


def elements_of(kind, amplitude, count=200):
    """Regular elements with displaced corners, of sizes from 0.1 to 10, some of them folded where the amplitude is large."""
    random = np.random.default_rng(len(kind))
    regular = np.array(shapes._REGULAR[kind])
    found = (regular + amplitude * random.normal(size=(count, *regular.shape))) * random.uniform(0.1, 10, (count, 1, 1))
    if kind == "quadrilateral":
        # Flat every second one: VTK before 9.2 takes another area for an aspect ratio of those that are not.
        found[::2, :, 2] = 0.0
    return found


def function_of_vtk(kind, name):
    word = CELLS[kind][1] + OTHER_WORDS.get((kind, name), WORDS[name])
    return getattr(vtk.vtkMeshQuality, word, None) or getattr(vtk.vtkMeshQuality, word + "s", None)


def by_vtk(function, kind, corners):
    found = []
    for points in corners:
        cell = vtk.vtkGenericCell()
        cell.SetCellType(CELLS[kind][0])
        for i, point in enumerate(points):
            cell.GetPoints().SetPoint(i, point)
        found.append(function(cell.GetRepresentativeCell() if hasattr(cell, "GetRepresentativeCell") else cell))
    return np.array(found)


class AgainstVtk(unittest.TestCase):
    def setUp(self):
        if vtk is None:
            self.skipTest("VTK's Python module is missing: Debian's package python3-vtk9 has it")

    def test_each_measure_of_each_kind(self):
        compared = set()
        for kind in CELLS:
            for measure in measures.MEASURES:
                function = function_of_vtk(kind, measure.name) if kind in measure.of else None
                if function is None:
                    continue
                for amplitude in (0.05, 0.3):
                    with self.subTest(f"{kind} {measure.name} {amplitude}"):
                        self.compare(kind, measure, function, elements_of(kind, amplitude))
                compared.add((kind, measure.name))
        # What VTK 9.1 has; later ones have the equiangle skew, prisms and pyramids, too.
        self.assertGreaterEqual(len(compared), 19)

    def compare(self, kind, measure, function, corners):
        if (kind, measure.name) == ("quadrilateral", "aspect_ratio"):
            corners = corners[::2]
            corners = corners[measures.MEASURES[2].values(kind, corners) > 0.0]
        values = measure.values(kind, corners)
        if (kind, measure.name) == ("hexahedron", "edge_ratio"):
            expected = np.max([by_vtk(function, kind, corners[:, list(order)]) for order in NUMBERINGS[kind]], axis=0)
        else:
            expected = by_vtk(function, kind, corners)
        if measure.name == "warpage":  # VTK's is 1 of flat ones, the manual's 0
            expected = 1.0 - expected
        known = expected < 1e300  # VTK's word for infinite
        self.assertGreater(known.sum(), 50)
        self.assertTrue(np.isinf(values[~known]).all())
        np.testing.assert_allclose(values[known], expected[known], rtol=MOST, atol=MOST)


class InClosedForm(unittest.TestCase):
    def test_regular_elements_are_ideal(self):
        for kind in CELLS:
            for measure in measures.MEASURES:
                if kind in measure.of and measure.name not in ("min_angle", "max_angle"):
                    value = measure.values(kind, np.array(shapes._REGULAR[kind])[None])[0]
                    # Verdict's constant for prisms has six digits.
                    self.assertAlmostEqual(value, measure.ideal, places=5 if kind == "prism" else 12, msg=f"{kind} {measure.name}")

    def test_a_measure_that_a_kind_does_not_have(self):
        by_name = {measure.name: measure for measure in measures.MEASURES}
        self.assertTrue(np.isnan(by_name["taper"].values("tetrahedron", np.zeros((3, 4, 3)))).all())

    def test_a_sheared_row_of_boxes(self):
        """Two unit cubes sheared by 1: the line between the centres is at 45 degrees to the face between them where shifted."""
        box = np.array(shapes._REGULAR["hexahedron"], dtype=float)
        shift = np.array([0.0, 1.0, 0.0])
        first, second = box.copy(), box + [1, 0, 0]
        second[[1, 2, 5, 6]] += shift
        first[[0, 3, 4, 7]] -= shift
        nodes, index = np.unique(np.concatenate([first, second]).round(12), axis=0, return_inverse=True)
        angle, skewness = finite_volume_measures(nodes, [("hexahedron", index.reshape(2, 8))])
        np.testing.assert_allclose(angle, 45.0, rtol=1e-12)
        self.assertTrue((skewness > 0.0).all())
        even = finite_volume_measures(np.concatenate([box, box + [1, 0, 0]]), [("hexahedron", np.arange(16).reshape(2, 8))])
        np.testing.assert_allclose(even, 0.0, atol=1e-12)


class Tables(helpers.DocumentTest):
    def test_triangles_of_everything_that_is_a_mesh(self):
        mesh = mq.triangulate(Part.makeCylinder(5, 20), chord_height=0.05)
        table = mq.measures(mesh)
        self.assertAlmostEqual(table["min_angle"].min(), mesh.report.min_angle, places=9)
        self.assertEqual(table.kinds, {"triangle": len(mesh.triangles)})
        np.testing.assert_array_equal(table.face, mesh.triangle_face)
        for other in (mesh.to_mesh(), (mesh.vertices, mesh.triangles)):
            np.testing.assert_allclose(mq.measures(other)["scaled_jacobian"], table["scaled_jacobian"], rtol=1e-9)
        at, value = table.worst("min_angle")
        self.assertEqual(table["min_angle"][at], value)
        self.assertIn("scaled_jacobian", str(table))
        with self.assertRaisesRegex(mq.InvalidInput, "there is no measure 'taper'.*edge_ratio"):
            _ = table["taper"]

    def test_a_table_in_a_file(self):
        mesh = mq.triangulate(Part.makeBox(2, 3, 4))
        path = os.path.join(self.folder, "measures.csv")
        table = mq.measures(mesh)
        table.write_csv(path)
        with open(path, encoding="ascii") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual(len(rows), len(mesh.triangles))
        self.assertEqual([float(row["aspect_ratio"]) for row in rows], table["aspect_ratio"].tolist())
        self.assertEqual(rows[0]["face"], f"Face{mesh.triangle_face[0] + 1}")

    def test_volumes_of_a_file(self):
        path = os.path.join(self.folder, "part.msh")
        mesh = mq.curve(Part.makeBox(2, 3, 4), order=1, volume=True)
        mesh.write(path)
        table = mq.measures(path)
        self.assertEqual(table.kinds, {"tetrahedron": len(mesh.tetrahedra)})
        self.assertIn("non_orthogonality", table.names)
        np.testing.assert_allclose(np.sort(mq.measures(mesh)["aspect_ratio"]), np.sort(table["aspect_ratio"]), rtol=1e-12)

    def test_the_command_line(self):
        path, table = os.path.join(self.folder, "part.stl"), os.path.join(self.folder, "measures.csv")
        mesh = mq.triangulate(Part.makeBox(2, 3, 4))
        mesh.write(path)
        status, out, err = test_cli.run("measures", path, "--csv", table, "--json")
        self.assertEqual(status, 0, err)
        found = json.loads(out)
        self.assertEqual(found["elements"], {"triangle": len(mesh.triangles)})
        self.assertAlmostEqual(found["measures"]["min_angle"]["worst"], mesh.report.min_angle, places=5)
        with open(table, encoding="ascii") as stream:
            self.assertEqual(len(stream.readlines()), len(mesh.triangles) + 1)
        volume = os.path.join(self.folder, "part.msh")
        mq.curve(Part.makeBox(2, 3, 4), order=1, volume=True).write(volume)
        status, out, err = test_cli.run("measures", volume)
        self.assertEqual(status, 0, err)
        self.assertIn("non_orthogonality", out)

    def test_meshes_that_have_nothing_to_measure(self):
        with self.assertRaisesRegex(mq.InvalidInput, "no triangles"):
            mq.measures((np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int32)))

    def test_a_million_triangles(self):
        side = 708
        x, y = np.meshgrid(np.arange(side + 1.0), np.arange(side + 1.0))
        nodes = np.stack([x.ravel(), y.ravel(), np.sin(x.ravel() / 9)], axis=1)
        at = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).ravel()
        rows = np.concatenate([np.stack([at, at + 1, at + side + 2], axis=1), np.stack([at, at + side + 2, at + side + 1], axis=1)])
        begun = time.process_time()
        table = mq.measures((nodes, rows.astype(np.int32)))
        for name in table.names:
            self.assertEqual(len(table[name]), len(rows))
        # About 2 s; the machine may do much else.
        self.assertLess(time.process_time() - begun, 10.0)


def write_gmsh2(path, nodes, blocks):
    """Volumes as Gmsh 2.2 has them, which gmshToFoam reads."""
    numbers = {"tetrahedron": 4, "hexahedron": 5, "prism": 6, "pyramid": 7}
    rows = [f"{numbers[kind]} 2 1 1 " + " ".join(str(i + 1) for i in element) for kind, corners in blocks for element in corners]
    with open(path, "w", encoding="ascii") as stream:
        stream.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n" % len(nodes))
        stream.writelines(f"{i} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(nodes.tolist(), 1))
        stream.write("$EndNodes\n$Elements\n%d\n" % len(rows))
        stream.writelines(f"{i} {row}\n" for i, row in enumerate(rows, 1))
        stream.write("$EndElements\n")


def mixed_blocks():
    """A bent grid of hexahedra, of which a layer is of prisms, and some hexahedra are divided into pyramids: (nodes, blocks)."""
    n, random = 5, np.random.default_rng(5)
    grid = np.stack(np.meshgrid(*3 * [np.arange(n + 1.0)], indexing="ij"), axis=-1)
    inner = grid[1:-1, 1:-1, 1:-1]
    inner += random.uniform(-0.2, 0.2, inner.shape)
    nodes, corners = list(grid.reshape(-1, 3)), np.array(kinds._CORNERS["hexahedron"])
    found = {"hexahedron": [], "prism": [], "pyramid": []}
    for i, j, k in np.ndindex(n, n, n):
        at = [((i + a) * (n + 1) + j + b) * (n + 1) + k + c for a, b, c in corners]
        if i == 4:
            found["prism"] += [[at[m] for m in (0, 1, 2, 4, 5, 6)], [at[m] for m in (0, 2, 3, 4, 6, 7)]]
        elif (i + j + k) % 4 == 0:
            nodes.append(np.mean([nodes[m] for m in at], axis=0) + 0.05)
            found["pyramid"] += [[*(at[m] for m in face[::-1]), len(nodes) - 1] for face in kinds.FACES["hexahedron"]]
        else:
            found["hexahedron"].append(at)
    # Prisms along z: of two layers the diagonals agree.
    return np.array(nodes), [(kind, np.array(rows)) for kind, rows in found.items()]


class AgainstOpenFoam(helpers.DocumentTest):
    def checked(self, nodes, blocks):
        """(largest non-orthogonality, largest skewness) that checkMesh finds."""
        for program in ("gmshToFoam", "checkMesh"):
            if not shutil.which(program):
                self.skipTest(f"{program} is missing: Debian's package openfoam has it")
        case = os.path.join(self.folder, "case")
        os.makedirs(os.path.join(case, "system"))
        for name, text in (("controlDict", "application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; "
                            "writeControl timeStep; writeInterval 1; writePrecision 16;"), ("fvSchemes", " ".join(f"{name}Schemes {{}}" for name in
                                          ("ddt", "grad", "div", "laplacian", "interpolation", "snGrad"))), ("fvSolution", "")):
            with open(os.path.join(case, "system", name), "w", encoding="ascii") as stream:
                stream.write(f"FoamFile {{ version 2.0; format ascii; class dictionary; object {name}; }}\n{text}\n")
        write_gmsh2(os.path.join(case, "mesh.msh"), nodes, blocks)
        for command in (["gmshToFoam", "mesh.msh"], ["checkMesh", "-allGeometry"]):
            done = subprocess.run(command, cwd=case, env=ENVIRONMENT, capture_output=True, text=True, timeout=300, check=False)
            self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr[-2000:])
        return [float(re.search(rf"{words}\s*=?:?\s*([-+.\de]+)", done.stdout)[1]) for words in
                ("non-orthogonality Max:", "[Mm]ax skewness")]

    def test_tetrahedra(self):
        mesh = mq.curve(Part.makeCylinder(5, 20), order=1, volume=True)
        self.agree(np.array(mesh.nodes), [("tetrahedron", np.array(mesh.tetrahedra))])

    def test_hexahedra_prisms_and_pyramids(self):
        self.agree(*mixed_blocks())

    def agree(self, nodes, blocks):
        angle, skewness = self.checked(nodes, blocks)
        ours = finite_volume_measures(nodes, blocks)
        # checkMesh writes six digits.
        np.testing.assert_allclose([ours[0].max(), ours[1].max()], [angle, skewness], rtol=2e-6)
