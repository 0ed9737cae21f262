# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved meshes of other orders, and files that hold them: MFEM, Nektar++ and CGNS by what their formats say, node by node;
Gmsh and VTK read all orders.
"""

import itertools
import math
import os
import re
import shutil
import subprocess
import unittest
from xml.etree import ElementTree

import FreeCAD
import numpy as np
import Part
import test_curved_files
from test_curved_files import READ_BY_GMSH, READ_BY_VTK, has

import MeshQuality as mq
from MeshQuality import formats
from MeshQuality.compat import extension
from MeshQuality.core.curving import ARRAYS, CurvedMesh
from MeshQuality.core.elements import kinds, lagrange, polynomials
from MeshQuality.core.formats import cgns


def bent_tetrahedron():
    """A tetrahedron of order 2 with corners 6 mm from the first, the middle of whose first edge is bent by 1 mm."""
    points = kinds.places("tetrahedron", 10) * 6.0
    points[4] = (3.0, -1.0, 0.0)
    faces = [part[1] for part in kinds.faces_of("tetrahedron", 10)]
    arrays = {
        "nodes": points, "node_entity": np.full((10, 2), (3, 0)), "tetrahedra": np.arange(10)[None],
        "tetrahedron_solid": np.zeros(1), "triangles": np.array(faces), "triangle_face": np.arange(4),
        "triangle_face_behind": np.zeros(0), "edges": np.array([[0, 1, 4]]), "edge_entity": np.array([2]),
        "triangle_quality": np.full(4, 0.5), "tetrahedron_quality": np.full(1, 0.5)}
    return CurvedMesh(extension().curved_from_arrays(2, arrays), measured=False)


def measure(mesh):
    """Volume of the tetrahedra, or area of the triangles, by Gauss points of Duffy's square or cube."""
    volume = len(mesh.tetrahedra) > 0
    kind, dimension = ("tetrahedron", 3) if volume else ("triangle", 2)
    line, weights = np.polynomial.legendre.leggauss(9)
    line, weights = (line + 1) / 2, weights / 2
    total, step = 0.0, 1e-6
    for index in itertools.product(range(9), repeat=dimension):
        u, v, w = (*line[list(index)], 0.0)[:3]
        at = np.array([u, v * (1 - u), w * (1 - u) * (1 - v)])[:dimension]
        weight = np.prod(weights[list(index)]) * (1 - u) * (((1 - u) * (1 - v)) if volume else 1)
        ends = np.concatenate([at + step * np.eye(dimension), at - step * np.eye(dimension)])
        values = lagrange.values(kind, mesh.order, lagrange.shares(kind, ends))
        found = np.einsum("ij,njk->nik", values, mesh.nodes[mesh.elements])
        along = (found[:, :dimension] - found[:, dimension:]) / (2 * step)
        total += weight * (np.linalg.det(along) if volume else np.linalg.norm(np.cross(along[:, 0], along[:, 1]), axis=1)).sum()
    return total


class Orders(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shape = Part.makeCylinder(5, 10)
        cls.patches = {"ends": ["Face2", "Face3"]}
        cls.meshes = [mq.curve(cls.shape, order=order, volume=volume, patches=cls.patches)
                      for volume in (False, True) for order in range(1, 5 if volume else 6)]

    def same_groups(self, mesh, other):
        for name in ("triangle_face", "edge_entity", "tetrahedron_solid", "triangle_face_behind", "triangle_patch"):
            np.testing.assert_array_equal(getattr(mesh, name), getattr(other, name), name)
        self.assertEqual(mesh.patches, other.patches)
        for name in ("edges", "triangles", "tetrahedra"):
            corners = kinds.CORNERS[{"edges": "line", "triangles": "triangle", "tetrahedra": "tetrahedron"}[name]]
            np.testing.assert_array_equal(getattr(mesh, name)[:, :corners], getattr(other, name)[:, :corners], name)

    def test_a_higher_order_has_the_same_shape(self):
        for mesh in self.meshes:
            most = 4 if len(mesh.tetrahedra) else 5
            for order in range(mesh.order, most + 1):
                raised = mesh.with_order(order)
                self.same_groups(mesh, raised)
                self.assertEqual(raised.order, order)
                # Nodes of the lower order are where its polynomials are at their places.
                back = raised.with_order(mesh.order)
                for name in ("edges", "triangles", "tetrahedra"):
                    off = back.nodes[getattr(back, name)] - mesh.nodes[getattr(mesh, name)]
                    self.assertLess(np.abs(off).max(initial=0.0), 1e-13, (mesh.order, order, name))
                    np.testing.assert_array_equal(back.node_entity[getattr(back, name)],
                                                  mesh.node_entity[getattr(mesh, name)])
                np.testing.assert_array_equal(raised.triangle_quality, mesh.triangle_quality)
                self.assertEqual(len(back.nodes), len(mesh.nodes))

    def test_the_volume_stays_when_the_order_is_raised(self):
        for mesh in (self.meshes[1], self.meshes[2], self.meshes[6]):
            before = measure(mesh)
            if len(mesh.tetrahedra):
                self.assertAlmostEqual(before / mesh.report.volume, 1.0, places=8)
            for order in range(mesh.order + 1, (4 if len(mesh.tetrahedra) else 5) + 1):
                self.assertAlmostEqual(measure(mesh.with_order(order)) / before, 1.0, places=9)

    def test_a_lower_order_goes_through_points_of_the_higher_one_and_is_certified(self):
        for mesh in self.meshes:
            for order in range(1, mesh.order):
                lowered = mesh.with_order(order)
                self.same_groups(mesh, lowered)
                kind = "tetrahedron" if len(mesh.tetrahedra) else "triangle"
                expected = polynomials.between(kind, mesh.order, order) @ mesh.nodes[mesh.elements]
                self.assertLess(np.abs(lowered.nodes[lowered.elements] - expected).max(), 1e-13)
                quality = lowered.tetrahedron_quality if kind == "tetrahedron" else lowered.triangle_quality
                low, _, verdict = extension().check_elements(kind, order, lowered.nodes, lowered.elements)
                np.testing.assert_array_equal(quality, low)
                self.assertEqual(int((verdict != 0).sum()), 0)
                self.assertEqual(mq.certify(lowered).invalid, 0)
                self.assertTrue(mq.certify(lowered).conforming)
        straight = self.meshes[8].with_order(1)
        self.assertEqual(len(straight.nodes), len(np.unique(straight.tetrahedra)))

    def test_a_fold_that_a_lower_order_makes_is_said(self):
        mesh = bent_tetrahedron()
        arrays = {name: np.array(getattr(mesh, name)) for name in ARRAYS.values()}
        arrays["nodes"][1] = (0.5, -0.4, 0.0)  # beside the bent edge, behind the face opposite to the second corner
        arrays["nodes"][4] = (-3.0, 3.0, 3.0)
        folded = CurvedMesh(extension().curved_from_arrays(2, arrays), measured=False)
        self.assertLessEqual(folded.with_order(3).with_order(2).tetrahedron_quality[0], 0.0)
        self.assertIn("1 not proven valid", repr(folded.with_order(3).with_order(2)))

    def test_the_bent_edge_by_hand(self):
        raised = bent_tetrahedron().with_order(3)
        # y = -4 t (1 - t) at thirds.
        np.testing.assert_allclose(raised.nodes[raised.tetrahedra[0, 4:6]], [[2, -8 / 9, 0], [4, -8 / 9, 0]], atol=1e-15)
        np.testing.assert_array_equal(raised.node_entity[raised.tetrahedra[0, 4:6]], [[1, 2], [1, 2]])
        self.assertEqual(raised.edges.tolist(), [raised.tetrahedra[0, [0, 1, 4, 5]].tolist()])

    def test_orders_that_are_not_possible(self):
        for mesh, order in ((self.meshes[0], 6), (self.meshes[0], 0), (self.meshes[0], True), (self.meshes[0], 2.0),
                            (self.meshes[6], 5)):
            with self.assertRaisesRegex(mq.InvalidInput, "have orders 1 to"):
                mesh.with_order(order)


class TextTest(test_curved_files.FileTest):
    """Writes meshes and reads the files as text."""

    def text(self, mesh, name, **how):
        path = os.path.join(self.folder, name)
        mesh.write(path, **how)
        with open(path, encoding="utf-8") as stream:
            return stream.read()


class Files(test_curved_files.FileTest):
    @unittest.skipUnless(has("gmsh"), "Gmsh's Python module is not installed")
    def test_gmsh_reads_orders_that_were_changed(self):
        surface, volume = mq.curve(Part.makeSphere(5), order=3), mq.curve(Part.makeCylinder(5, 10), order=2, volume=True)
        meshes = [surface.with_order(order) for order in range(1, 6)] + [volume.with_order(order) for order in range(1, 5)]
        paths = [self.write(mesh, f"{i}.msh{2 if i % 2 else ''}") for i, mesh in enumerate(meshes)]
        for mesh, read in zip(meshes, self.read(READ_BY_GMSH, paths)):
            self.assertEqual((read["order"], read["elements"], read["nodes"]),
                             (mesh.order, len(mesh.elements), len(mesh.nodes)))
            self.assertGreater(read["least"], 0.0)
            if len(mesh.tetrahedra) and mesh.order > 1:
                self.assertAlmostEqual(read["measure"] / volume.report.volume, 1.0, places=9)

    @unittest.skipUnless(has("vtkmodules"), "VTK's Python module is not installed")
    def test_vtk_reads_every_order(self):
        for volume, orders in ((True, range(1, 5)), (False, range(1, 6))):
            mesh = mq.curve(Part.makeTorus(10, 3), order=4, volume=volume)
            for order in orders:
                changed = mesh.with_order(order)
                read = self.read(READ_BY_VTK, [self.write(changed, f"{order}.vtu")])
                self.assertEqual((read["points"], read["cells"]), (len(changed.nodes), len(changed.elements)))
                self.assertLess(read["off"], 1e-9)


class Mfem(TextTest):
    """MFEM's mesh v1.0 with nodes in H1: as fem/fe/fe_h1.cpp and mesh/mesh.cpp of MFEM 4 number them."""

    def dofs(self, text):
        return np.array([[float(x) for x in line.split()] for line in text.partition("Ordering: 1\n\n")[2].splitlines()])

    def test_a_bent_tetrahedron_of_order_2(self):
        text = self.text(bent_tetrahedron(), "a.mesh")
        self.assertTrue(text.startswith(
            "MFEM mesh v1.0\n\n# attribute 1: Solid1\n# boundary attribute 1: Face1\n# boundary attribute 2: Face2\n"
            "# boundary attribute 3: Face3\n# boundary attribute 4: Face4\n\ndimension\n3\n\nelements\n1\n1 4 0 1 2 3\n\n"
            "boundary\n4\n1 2 0 2 1\n2 2 0 1 3\n3 2 0 3 2\n4 2 3 1 2\n\nvertices\n4\n\nnodes\nFiniteElementSpace\n"
            "FiniteElementCollection: H1_3D_P2\nVDim: 3\nOrdering: 1\n\n"), text)
        # Corners, then edges (0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3).
        self.assertEqual(self.dofs(text).tolist(),
                         [[0, 0, 0], [6, 0, 0], [0, 6, 0], [0, 0, 6], [3, -1, 0], [0, 3, 0], [0, 0, 3], [3, 3, 0], [3, 0, 3],
                          [0, 3, 3]])

    def test_a_bent_tetrahedron_of_order_3(self):
        found = self.dofs(self.text(bent_tetrahedron().with_order(3), "a.mesh", scale=10 / 6))
        low = 5 - math.sqrt(5)  # of 10 mm: (1 - 1 / sqrt(5)) / 2
        high = 10 - low
        bend = -4 * 0.2 * 10 / 6  # t (1 - t) is 1 / 5 there
        third = 10 / 3
        # The bent edge has 4 * (1 / 3) * (1 / 3) of its bend at the centres of its two faces.
        centre = -4 / 9 * 10 / 6
        np.testing.assert_allclose(found[4:], [
            [low, bend, 0], [high, bend, 0], [0, low, 0], [0, high, 0], [0, 0, low], [0, 0, high], [high, low, 0],
            [low, high, 0], [high, 0, low], [low, 0, high], [0, high, low], [0, low, high],
            [third, third, third], [0, third, third], [third, centre, third], [third, third + centre, 0]], atol=1e-14)

    def by_mfem(self, mesh):
        """(edges, faces): {corners: nodes in the file}, and the numbers of those inside of the elements."""
        volume, order = len(mesh.tetrahedra) > 0, mesh.order
        corners = mesh.elements[:, :4 if volume else 3].tolist()
        pairs = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)) if volume else ((0, 1), (1, 2), (2, 0))
        edges, faces, at = {}, {}, int(mesh.elements[:, :4 if volume else 3].max()) + 1
        for element in corners:
            for a, b in pairs:
                key = (min(element[a], element[b]), max(element[a], element[b]))
                if key not in edges:
                    edges[key] = at + np.arange(order - 1)
                    at += order - 1
        for element in corners if volume else ():
            for face in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)):
                key = tuple(element[i] for i in face)
                if not any(turn in faces for turn in itertools.permutations(key)):
                    faces[key] = at + np.arange((order - 1) * (order - 2) // 2)
                    at += (order - 1) * (order - 2) // 2
        return edges, faces, at

    def test_nodes_are_shared_and_where_mfem_has_them(self):
        shape = Part.makeCylinder(5, 10)
        for volume, orders in ((True, (2, 3, 4)), (False, (2, 3, 4, 5))):
            for order in orders:
                mesh = mq.curve(shape, order=order, volume=volume)
                found = self.dofs(self.text(mesh, "a.mesh"))
                edges, faces, first = self.by_mfem(mesh)
                lobatto = {2: [0, 0.5, 1], 3: [0, (1 - 5**-0.5) / 2, (1 + 5**-0.5) / 2, 1],
                           4: [0, (1 - (3 / 7)**0.5) / 2, 0.5, (1 + (3 / 7)**0.5) / 2, 1],
                           5: [0, *((1 + s * ((7 + t * 2 * 7**0.5) / 21)**0.5) / 2 for s, t in ((-1, 1), (-1, -1), (1, -1), (1, 1))),
                               1]}[order]
                for element in mesh.elements[::7]:
                    local = element[:4 if volume else 3].tolist()
                    kind = "tetrahedron" if volume else "triangle"
                    for (a, b), numbers in self.sides_of(edges, local, 2):
                        for step, number in enumerate(numbers, 1):
                            self.at(mesh, kind, element, {a: 1 - lobatto[step], b: lobatto[step]}, found[number])
                    for (a, b, c), numbers in self.sides_of(faces, local, 3):
                        steps = [(i, j) for j in range(1, order) for i in range(1, order - j)]
                        for (i, j), number in zip(steps, numbers):
                            parts = np.array([lobatto[order - i - j], lobatto[i], lobatto[j]])
                            self.at(mesh, kind, element, dict(zip((a, b, c), parts / parts.sum())), found[number])
                inner = math.comb(order - 1, 3 if volume else 2)
                self.assertEqual(len(found), first + inner * len(mesh.elements))

    @staticmethod
    def sides_of(sides, local, width):
        for corners in itertools.permutations(local, width):
            if corners in sides:
                yield corners, sides[corners]

    def at(self, mesh, kind, element, shares, point):
        weights = np.array([[shares.get(int(corner), 0.0) for corner in element[:kinds.CORNERS[kind]]]])
        expected = lagrange.values(kind, mesh.order, weights) @ mesh.nodes[element]
        np.testing.assert_allclose(point, expected[0], atol=1e-12)

    def test_attributes_are_patches_and_solids(self):
        box = Part.makeBox(1, 1, 1)
        pair = Part.makeCompound([box, Part.makeBox(1, 1, 1, FreeCAD.Vector(1, 0, 0))])
        mesh = mq.curve(pair, order=1, volume=True, imprint=True, patches={"inlet": ["Face1"]}, patch_rest="walls")
        text = self.text(mesh, "a.mesh", scale=0.001)
        self.assertIn("# attribute 1: Solid1\n# attribute 2: Solid2\n# boundary attribute 1: inlet\n"
                      "# boundary attribute 2: walls\n", text)
        elements, boundary = (re.search(rf"\n{title}\n\d+\n((?:[\d ]+\n)+)", text)[1].splitlines()
                              for title in ("elements", "boundary"))
        np.testing.assert_array_equal([int(row.split()[0]) for row in elements], mesh.tetrahedron_solid + 1)
        np.testing.assert_array_equal([int(row.split()[0]) for row in boundary], mesh.triangle_patch + 1)
        self.assertIn("\nvertices\n", text)
        self.assertNotIn("FiniteElementSpace", text)

    def test_a_surface_with_ends_has_them_as_boundary(self):
        mesh = mq.curve(Part.makeCylinder(5, 10).Faces[0], order=2)
        text = self.text(mesh, "a.mesh")
        rows = re.search(r"\nboundary\n(\d+)\n((?:[\d ]+\n)+)", text)
        seam = {entity for entity in mesh.edge_entity.tolist()} - {int(row.split()[0]) - 1 for row in rows[2].splitlines()}
        self.assertEqual((len(seam), int(rows[1])), (1, int((~np.isin(mesh.edge_entity, list(seam))).sum())))
        self.assertIn("dimension\n2\n", text)
        self.assertIn("H1_2D_P2\nVDim: 3\n", text)
        flat = mq.triangulate(Part.makeSphere(5))
        self.assertIn("\nboundary\n0\n", self.text(flat, "b.mesh"))


class Nektar(TextTest):
    """Nektar++: as its MeshGraph reads, and its evenly spaced nodes of triangles are ordered."""

    def geometry(self, mesh, **how):
        return ElementTree.fromstring(self.text(mesh, "a.xml", **how))

    @staticmethod
    def numbers(node):
        return [float(x) for x in node.text.split()]

    def rows(self, root, path):
        return [self.numbers(node) for node in root.findall(path)]

    def test_a_bent_tetrahedron_of_order_3(self):
        root = self.geometry(bent_tetrahedron().with_order(3))
        self.assertEqual(root.find("GEOMETRY").attrib, {"DIM": "3", "SPACE": "3"})
        self.assertEqual(self.rows(root, "GEOMETRY/VERTEX/V"), [[0, 0, 0], [6, 0, 0], [0, 6, 0], [0, 0, 6]])
        edges = self.rows(root, "GEOMETRY/EDGE/E")
        faces = self.rows(root, "GEOMETRY/FACE/T")
        self.assertEqual(len(edges), 6)
        number = edges.index([0, 1])
        curve = root.find(f"GEOMETRY/CURVED/E[@EDGEID='{number}']")
        self.assertEqual((curve.get("NUMPOINTS"), curve.get("TYPE")), ("4", "PolyEvenlySpaced"))
        np.testing.assert_allclose(self.numbers(curve), [0, 0, 0, 2, -8 / 9, 0, 4, -8 / 9, 0, 6, 0, 0], atol=1e-15)
        # The first face of the element is that of its first three vertices; its points go around, the centre last.
        first = int(self.rows(root, "GEOMETRY/ELEMENT/A")[0][0])
        self.assertEqual([edges[int(edge)] for edge in faces[first]], [[0, 1], [1, 2], [0, 2]])
        curve = root.find(f"GEOMETRY/CURVED/F[@FACEID='{first}']")
        self.assertEqual((curve.get("NUMPOINTS"), curve.get("TYPE")), ("10", "NodalTriEvenlySpaced"))
        np.testing.assert_allclose(np.reshape(self.numbers(curve), (-1, 3)), [
            [0, 0, 0], [6, 0, 0], [0, 6, 0], [2, -8 / 9, 0], [4, -8 / 9, 0], [4, 2, 0], [2, 4, 0], [0, 4, 0], [0, 2, 0],
            [2, 2 - 4 / 9, 0]], atol=1e-15)

    def test_elements_are_as_nektar_takes_them(self):
        for order in (1, 2, 4):
            mesh = mq.curve(Part.makeCylinder(5, 10), order=order, volume=True, patches={"ends": ["Face2"]}, patch_rest="side")
            root = self.geometry(mesh)
            points = np.array(self.rows(root, "GEOMETRY/VERTEX/V"))
            edges = np.array(self.rows(root, "GEOMETRY/EDGE/E"), dtype=int)
            faces = np.array(self.rows(root, "GEOMETRY/FACE/T"), dtype=int)
            corners = []
            for e0, e1, e2 in edges[faces]:  # as TriGeom finds vertices
                first, = set(e0) - set(e1)
                second, = set(e0) & set(e1)
                third, = set(e1) & set(e2)
                corners.append((first, second, third))
            for row in np.array(self.rows(root, "GEOMETRY/ELEMENT/A"), dtype=int):
                # As TetGeom does: the sides start with the edges of the base, and only then find the top.
                self.assertEqual(faces[row[0], 0], faces[row[1], 0])
                base = [faces[face, 0] for face in row[1:]]
                self.assertTrue(set(base) == set(faces[row[0]]))
                a, = set(edges[base[0]]) - set(edges[base[1]])
                b, = set(edges[base[0]]) & set(edges[base[1]])
                c, = set(edges[base[1]]) - {b}
                d, = set(corners[row[1]]) - {a, b}
                self.assertGreater(np.linalg.det(points[[b, c, d]] - points[a]), 0.0)
                self.assertTrue(max(a, b) < c < d)
                self.assertEqual({frozenset(corners[face]) for face in row},
                                 {frozenset(x) for x in itertools.combinations((a, b, c, d), 3)})
            composites = {node.get("NAME"): node.text.strip() for node in root.findall("GEOMETRY/COMPOSITE/C")}
            self.assertEqual(list(composites), ["Solid1", "ends", "side"])
            self.assertEqual(composites["Solid1"], f"A[0-{len(mesh.tetrahedra) - 1}]")
            self.assertEqual(root.find("GEOMETRY/DOMAIN/D").text.strip(), "C[0]")
            sizes = [sum(int(b or a) - int(a) + 1 for a, b in re.findall(r"(\d+)(?:-(\d+))?", composites[name]))
                     for name in ("ends", "side")]
            self.assertEqual(sizes, np.bincount(mesh.triangle_patch).tolist())
            curves = root.findall("GEOMETRY/CURVED/F")
            self.assertEqual(len(curves), len(faces) if order > 1 else 0)
            for curve in curves:
                at = np.reshape(self.numbers(curve), (-1, 3))
                np.testing.assert_array_equal(at[:3], points[list(corners[int(curve.get("FACEID"))])])
                for side, edge in enumerate(faces[int(curve.get("FACEID"))]):
                    line = np.reshape(self.numbers(root.find(f"GEOMETRY/CURVED/E[@ID='{edge}']")), (-1, 3))
                    part = at[3 + side * (order - 1):3 + (side + 1) * (order - 1)]
                    np.testing.assert_array_equal(part[::-1] if side == 2 else part, line[1:-1])
                if order == 4:
                    break

    def test_the_nodes_within_triangles_go_by_rows(self):
        mesh = mq.curve(Part.makePlane(10, 10), order=5)
        root = self.geometry(mesh)
        at = np.reshape(self.numbers(root.find("GEOMETRY/CURVED/F[@FACEID='0']")), (-1, 3))
        a, b, c = at[:3]
        steps = [(1, 1), (2, 1), (3, 1), (1, 2), (2, 2), (1, 3)]
        np.testing.assert_allclose(at[15:], [a + (b - a) * i / 5 + (c - a) * j / 5 for i, j in steps], atol=1e-12)
        self.assertEqual([node.get("NAME") for node in root.findall("GEOMETRY/COMPOSITE/C")],
                         ["Face1", "Edge1", "Edge2", "Edge3", "Edge4"])
        self.assertEqual(root.find("EXPANSIONS/E").attrib,
                         {"COMPOSITE": "C[0]", "NUMMODES": "4", "TYPE": "MODIFIED", "FIELDS": "u"})


def has_cgns():
    try:
        return cgns.library() is not None
    except mq.IoError:
        return False


@unittest.skipUnless(has_cgns(), "the CGNS library (libcgns-dev) is not installed")
class Cgns(TextTest):
    def test_orders_3_and_4_come_back(self):
        for volume in (False, True):
            for order in (3, 4):
                mesh = mq.curve(Part.makeCylinder(5, 10), order=order, volume=volume)
                path = self.write(mesh, "a.cgns")
                if shutil.which("cgnscheck"):
                    done = subprocess.run(["cgnscheck", path], capture_output=True, text=True, timeout=100, check=False)
                    self.assertEqual(done.returncode, 0)
                    self.assertNotRegex(done.stdout + done.stderr, "(?i)warning|error")
                read = mq.read_mesh(path)
                for kind, nodes in (("triangle", mesh.triangles), ("tetrahedron", mesh.tetrahedra)):
                    blocks = [block.nodes for block in read.blocks if block.kind == kind]
                    if len(nodes):
                        self.sorted_alike(read.nodes[np.concatenate(blocks)], mesh.nodes[nodes])

    def sorted_alike(self, found, expected):
        found, expected = (part[np.lexsort(part[:, :3].reshape(len(part), -1).T)] for part in (found, expected))
        np.testing.assert_array_equal(found, expected)

    def test_nodes_of_quartic_elements_by_the_standard(self):
        """CGNS/SIDS, 3.3.3.1: N23 lies within N1-N12-N6, and so on."""
        place = kinds.places("tetrahedron", 35)[np.argsort(kinds.from_cgns("tetrahedron", 35))]
        within = {23: (1, 12, 6), 24: (2, 6, 9), 25: (3, 9, 12), 26: (1, 6, 15), 27: (2, 18, 6), 28: (4, 15, 18),
                  29: (2, 9, 18), 30: (3, 21, 9), 31: (4, 18, 21), 32: (3, 12, 21), 33: (1, 15, 12), 34: (4, 21, 15),
                  35: (1, 2, 3, 4)}
        for node, around in within.items():
            middle = place[[i - 1 for i in around]].mean(axis=0)
            away = np.linalg.norm(place[22:] - middle, axis=1)
            self.assertEqual(int(away.argmin()) + 23, node)
        ends = {5: (1, 2), 8: (2, 3), 11: (3, 1), 14: (1, 4), 17: (2, 4), 20: (3, 4)}
        for node, (a, b) in ends.items():
            for step in range(3):
                np.testing.assert_allclose(place[node - 1 + step], place[a - 1] + (place[b - 1] - place[a - 1]) * (step + 1) / 4)

    def test_nodes_of_cubic_elements_by_the_standard(self):
        place = kinds.places("tetrahedron", 20)[np.argsort(kinds.from_cgns("tetrahedron", 20))]
        for node, face in {17: (1, 3, 2), 18: (1, 2, 4), 19: (2, 3, 4), 20: (3, 1, 4)}.items():
            np.testing.assert_allclose(place[node - 1], place[[i - 1 for i in face]].mean(axis=0), atol=1e-15)

    def test_order_5_is_refused(self):
        mesh = mq.curve(Part.makePlane(10, 10), order=5)
        with self.assertRaisesRegex(mq.InvalidInput, r"orders? 1 to 4, not elements of order 5"):
            mesh.write(os.path.join(self.folder, "a.cgns"))
        self.assertEqual({form.curved for form in map(formats.FORMATS.get, (".mesh", ".xml"))}, {5})
