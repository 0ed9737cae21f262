# SPDX-License-Identifier: LGPL-2.1-or-later
"""curve(shape, mesh=) of prisms, pyramids, hexahedra and quadrilaterals: layers follow their walls, and all is proven."""

import json
import os
import subprocess

import helpers
import layered_meshes
import numpy as np
import Part
from FreeCAD import Vector
from test_cli import run
from test_curved_files import PYTHON, has

import MeshQuality as mq
from MeshQuality.core.elements import kinds, polynomials
from MeshQuality.core.elements.assembly import Content
from MeshQuality.core.fem import fem
from MeshQuality.core.meshes.element_mesh import ElementMesh

NAIVE = {"shell of prisms": 50, "prisms around a sphere": 50, "pipe of hexahedra": 16, "pipe bend of hexahedra": 16,
         "blade of hexahedra": 8, "pipe with pyramids": 16}  # at least as many are invalid where the surface alone is curved

# VTK reads a file, and says which of its places inside of cells are which; in a process of its own.
READ_BY_VTK = """
import json, sys
import vtk
reader = vtk.vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1])
reader.Update()
grid = reader.GetOutput()
found = []
for i in range(grid.GetNumberOfCells()):
    cell = grid.GetCell(i)
    place, weights = [0.0] * 3, [0.0] * cell.GetNumberOfPoints()
    cell.EvaluateLocation(vtk.reference(0), [0.3, 0.2, 0.6], place, weights)
    found.append(place)
print(json.dumps(found))
"""


class LayersTest(helpers.DocumentTest):
    def assert_cured(self, name, shape, given, order, deviation):
        """All is valid and on the CAD, no corner moved, and the elements are those that were given."""
        mesh = mq.curve(shape, mesh=given, order=order)
        said = f"{name} of order {order}: {mesh.report}"
        self.assertEqual(mesh.report.invalid, 0, said)
        self.assertLess(mesh.report.max_deviation, deviation, said)
        self.assertEqual(len(mesh.moved_nodes), 0, said)
        np.testing.assert_array_equal(mesh.nodes[:len(mesh.given_node)], given.nodes[mesh.given_node], said)
        for block, before in zip(mesh.blocks, given.blocks):
            if kinds.DIMENSION[block.kind] == given.dimension:
                self.assertEqual(block.kind, before.kind, said)
                corners = before.nodes[:, :kinds.CORNERS[block.kind]]
                np.testing.assert_array_equal(mesh.given_node[block.nodes[:, :corners.shape[1]]], corners, said)
        certificate = mq.certify(mesh)
        self.assertEqual((certificate.invalid, certificate.conforming, certificate.oriented), (0, True, True), said)
        return mesh


class Volumes(LayersTest):
    def test_thin_layers_are_valid_where_the_surface_alone_inverts_them(self):
        for name, (shape, given) in layered_meshes.volumes().items():
            self.assertEqual(mq.certify(given).invalid, 0, name)
            size = shape.BoundBox.DiagonalLength
            for order, part in ((2, 3e-3), (3, 4e-4), (4, 6e-5)):
                mesh = self.assert_cured(name, shape, given, order, part * size)
                self.assertGreaterEqual(mesh.report.invalid_before, NAIVE[name], name)
                self.assertLess(mesh.report.volume_error, 2.5 * part, name)

    def test_an_independent_verifier_agrees(self):
        for name, (shape, given) in layered_meshes.volumes().items():
            path, saved = (os.path.join(self.folder, f"mesh.{suffix}") for suffix in ("msh", "json"))
            mq.curve(shape, mesh=given, order=2).write(path)
            certificate = mq.certify(path)
            self.assertEqual(certificate.invalid, 0, name)
            certificate.save(saved)
            self.assertTrue(mq.verify(saved).holds, name)

    def test_layers_far_thinner_than_the_wall_bends(self):
        """A thousandth of the radius, 25 times less than the wall bends: all elements become valid, and none is straightened."""
        shape, given = layered_meshes.around_sphere(thickness=0.005, chord=0.06)
        mesh = mq.curve(shape, mesh=given, order=2, straighten_invalid=True)
        self.assertGreater(mesh.report.invalid_before, 50)
        self.assertEqual((mesh.report.invalid, mq.certify(mesh).invalid), (0, 0))
        self.assertFalse(mesh.report.invalid_elements or mesh.report.straightened)

    def test_groups(self):
        shape, given = layered_meshes.pipe()
        mesh = mq.curve(shape, mesh=given, order=2)
        self.assertEqual(mesh.groups[0], "Solid1")
        self.assertEqual({name for name in mesh.groups if name.startswith("Face")}, {f"Face{i + 1}" for i in range(4)})
        for name, parts in mesh.group_members.items():
            if name.startswith("Face"):
                face = shape.Faces[int(name[4:]) - 1]
                block, rows = parts[0]
                for point in mesh.nodes[mesh.blocks[block].nodes[rows[:5], 4]]:
                    self.assertLess(face.distToShape(Part.Vertex(Vector(*point)))[0], 1e-6, name)

    def test_two_solids_that_share_a_wall_between_layers(self):
        _, given = layered_meshes.pipe()
        block = given.blocks[0]
        radius = np.hypot(*np.moveaxis(given.nodes[block.nodes], 2, 0)[:2]).mean(axis=1)
        wall = float(np.unique(np.round(np.hypot(*given.nodes.T[:2]), 9))[2])
        solids = np.where(radius > wall, 1, 0).astype(np.int32)
        told = ElementMesh(Content(given.nodes.copy(), (block._replace(geometry=solids),), {}, ()))
        inner = Part.makeCylinder(wall, 10).cut(Part.makeCylinder(3, 10))
        outer = Part.makeCylinder(5, 10).cut(Part.makeCylinder(wall, 10))
        mesh = mq.curve(Part.makeCompound([inner, outer]), mesh=told, order=3)
        self.assertEqual((mesh.report.invalid, mq.certify(mesh).invalid), (0, 0))
        self.assertEqual(np.bincount(mesh.blocks[0].geometry).tolist(), np.bincount(solids).tolist())
        surface = next(block for block in mesh.blocks if block.kind == "quadrilateral")
        between = np.isclose(np.hypot(*mesh.nodes[surface.nodes[:, :4]].mean(axis=1).T[:2]), wall * np.cos(np.pi / 8), atol=1e-3)
        self.assertEqual(int(between.sum()), 24)  # once, where both solids meet

    def test_meshes_of_gmsh(self):
        if not has("gmsh"):
            self.skipTest("needs python3-gmsh")
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "gmsh_layers.py")
        done = subprocess.run([PYTHON, script, self.folder], capture_output=True, text=True, timeout=200, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        shapes = {"holed": Part.makeBox(8, 8, 3, Vector(-4, -4, 0)).cut(Part.makeCylinder(2, 3)),
                  "around": Part.makeBox(16, 16, 3, Vector(-8, -8, 0)).cut(Part.makeCylinder(2, 3)),
                  "torus": Part.makeTorus(10, 3)}
        for name, shape in shapes.items():
            given = mq.read_mesh(os.path.join(self.folder, f"{name}.msh"))
            for order in (2, 3, 4):
                mesh = self.assert_cured(name, shape, given, order, 1e-3 * shape.BoundBox.DiagonalLength)
                if name == "around":  # layers a tenth of what the cylinder bends away from them
                    self.assertGreater(mesh.report.invalid_before, 5)


class Surfaces(LayersTest):
    def test_quadrilaterals_on_a_cylinder(self):
        shape, volume = layered_meshes.pipe()
        faces = volume.boundary()[0]
        used, rows = np.unique(faces, return_inverse=True)
        given = layered_meshes.mesh_of(volume.nodes[used], ("quadrilateral", rows.reshape(faces.shape)))
        for order, deviation in ((2, 5e-3), (3, 1.5e-3), (4, 2e-5)):
            mesh = self.assert_cured("cylinders", shape, given, order, deviation)
            self.assertGreater(mesh.report.invalid_before, 0)  # layers on the ends, beside the circles
        self.assertEqual([block.kind for block in mesh.blocks], ["quadrilateral", "line"])

    def test_a_quadrilateral_across_an_edge_of_the_shape_is_refused(self):
        box = Part.makeBox(1, 1, 1)
        corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
        given = layered_meshes.mesh_of(corners, ("quadrilateral", [[0, 3, 2, 1], [0, 1, 2, 6]]))
        with self.assertRaises((mq.GeometryError, mq.TopologyError)):
            mq.curve(box, mesh=given)


class Orders(LayersTest):
    def assert_fits(self, mesh):
        """Faces of two elements are one polynomial, whatever their orders: the same points at the same shares of corners."""
        at = np.array([[0.21, 0.33, 0.0], [0.6, 0.1, 0.0], [0.125, 0.7, 0.0]])
        met, shared = {}, 0
        for block in mesh.blocks:
            if kinds.DIMENSION[block.kind] < 3:
                continue
            for kind, local in kinds.faces_of(block.kind, block.nodes.shape[1]):
                count = kinds.CORNERS[kind]
                for nodes in block.nodes[:, local]:
                    turned = _from_lowest(nodes[:count])
                    key = tuple(nodes[turned])
                    places = polynomials.values(kind, block.order, _turned(kind, at, turned)) @ mesh.nodes[nodes]
                    if key in met:
                        np.testing.assert_allclose(places, met[key], atol=1e-9)
                        shared += 1
                    met[key] = places
        self.assertGreater(shared, 10)

    def test_every_element_has_its_order_and_what_is_shared_the_lowest(self):
        random = np.random.default_rng(5)
        for name, (shape, given) in layered_meshes.volumes().items():
            curved = mq.curve(shape, mesh=given, order=3)
            count = sum(len(block.nodes) for block in given.blocks)
            orders = random.integers(1, 4, count)
            mesh = curved.with_orders(orders)
            made = np.concatenate([np.full(len(block.nodes), block.order) for block in mesh.blocks
                                   if kinds.DIMENSION[block.kind] == 3])
            self.assertEqual(np.bincount(made).tolist(), np.bincount(orders).tolist(), name)
            self.assert_fits(mesh)
            certificate = mq.certify(mesh)
            self.assertTrue(certificate.conforming and certificate.oriented, name)
            folded = sum(int((quality <= 0).sum()) for block, quality in zip(mesh.blocks, mesh.quality)
                         if kinds.DIMENSION[block.kind] == 3)
            self.assertEqual(certificate.invalid, folded, name)
            raised = curved.with_orders(orders, raise_invalid=True)
            self.assertEqual(mq.certify(raised).invalid, 0, name)
            self.assert_fits(raised)
            path = os.path.join(self.folder, "orders.msh")
            raised.write(path)
            again = mq.certify(path)
            self.assertEqual((again.invalid, again.conforming), (0, True), name)

    def test_one_order_for_all_changes_nothing(self):
        shape, given = layered_meshes.pipe(bend=True)
        curved = mq.curve(shape, mesh=given, order=3)
        same = curved.with_orders(np.full(len(given.blocks[0].nodes), 3))
        self.assertEqual(len(same.nodes), len(curved.nodes))
        for block, before in zip(same.blocks, curved.blocks):
            np.testing.assert_allclose(same.nodes[block.nodes], curved.nodes[before.nodes], atol=1e-9)

    def test_tetrahedra_and_triangles(self):
        curved = mq.curve(Part.makeSphere(5), order=2, volume=True, chord_height_relative=0.05)
        orders = 1 + np.arange(len(curved.elements)) % 4
        mesh = curved.with_orders(orders)
        self.assertEqual(mesh.order, 4)
        self.assertEqual(mq.certify(mesh).invalid, 0)
        self.assert_fits(mesh)
        self.assertEqual(set(mesh.groups), {"Solid1", "Face1", *(f"Edge{i + 1}" for i in np.unique(curved.edge_entity))})
        surface = mq.curve(Part.makeTorus(10, 3), order=3)
        self.assertEqual(mq.certify(surface.with_orders(1 + np.arange(len(surface.elements)) % 3)).invalid, 0)

    def test_orders_that_are_not_possible(self):
        curved = mq.curve(Part.makeSphere(5), order=2, volume=True)
        with self.assertRaisesRegex(mq.InvalidInput, "orders has 3 numbers for"):
            curved.with_orders([1, 2, 1])
        with self.assertRaisesRegex(mq.InvalidInput, "from 1 to"):
            curved.with_orders(np.zeros(len(curved.elements), dtype=int))
        several = curved.with_orders(1 + np.arange(len(curved.elements)) % 2)
        with self.assertRaisesRegex(mq.InvalidInput, "several orders"):
            several.with_orders(np.ones(len(curved.elements), dtype=int))


def _from_lowest(corners):
    """The order of the corners of a face that begins at the lowest and goes on towards the lower of its neighbours."""
    count = len(corners)
    first = int(np.argmin(corners))
    forth = [(first + k) % count for k in range(count)]
    back = [(first - k) % count for k in range(count)]
    return forth if corners[forth[1]] < corners[back[1]] else back


def _turned(kind, at, order):
    """Places that have these shares of the corners in this order."""
    shares = polynomials.values(kind, 1, at)
    own = np.empty_like(shares)
    own[:, order] = shares
    return own @ kinds.places(kind, kinds.CORNERS[kind])


class Files(LayersTest):
    def test_gmsh(self):
        shape, given = layered_meshes.volumes()["pipe with pyramids"]
        path = os.path.join(self.folder, "mesh.msh")
        for order in (2, 3, 4):
            mesh = mq.curve(shape, mesh=given, order=order)
            mesh.write(path, scale=2.0)
            again = mq.read_mesh(path, scale=0.5)
            np.testing.assert_allclose(again.nodes, mesh.nodes, atol=1e-9)
            for block, before in zip(again.blocks, mesh.blocks):
                self.assertEqual((block.kind, block.order), (before.kind, before.order))
                np.testing.assert_array_equal(np.sort(block.nodes, axis=None), np.sort(before.nodes, axis=None))
            self.assertEqual(set(again.groups), set(mesh.groups))

    def test_vtk_has_the_same_shapes(self):
        if not has("vtk"):
            self.skipTest("needs python3-vtk9")
        path = os.path.join(self.folder, "mesh.vtu")
        for name in ("shell of prisms", "pipe bend of hexahedra", "prisms around a sphere"):
            shape, given = layered_meshes.volumes()[name]
            for order in (1, 2, 3, 4):
                mesh = mq.curve(shape, mesh=given, order=order)
                mesh.write(path)
                done = subprocess.run([PYTHON, "-c", READ_BY_VTK, path], capture_output=True, text=True, timeout=100, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)
                wanted = [polynomials.values(block.kind, order, [[0.3, 0.2, 0.6]]) @ mesh.nodes[block.nodes]
                          for block in mesh.blocks if kinds.DIMENSION[block.kind] == 3 and block.kind != "tetrahedron"]
                wanted = np.concatenate(wanted)[:, 0]
                first = sum(len(block.nodes) for block in mesh.blocks if block.kind == "tetrahedron")
                places = np.array(json.loads(done.stdout))[first:first + len(wanted)]
                np.testing.assert_allclose(places, wanted, atol=1e-6, err_msg=name)

    def test_what_files_do_not_hold(self):
        shape, given = layered_meshes.volumes()["pipe with pyramids"]
        mesh = mq.curve(shape, mesh=given, order=2)
        with self.assertRaisesRegex(mq.InvalidInput, "hold no pyramids of order 2 with 14 nodes: choose one of .msh"):
            mesh.write(os.path.join(self.folder, "mesh.vtu"))
        with self.assertRaisesRegex(mq.IoError, "ends in one of .msh .vtu"):
            mesh.write(os.path.join(self.folder, "mesh.stl"))


class Documents(LayersTest):
    def test_objects_keep_cured_tetrahedra_only(self):
        made = fem.module().FemMesh()
        for number, point in enumerate([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], 1):
            made.addNode(*map(float, point), number)
        made.addVolume([5, 6, 7, 8, 1, 2, 3, 4])
        part = self.document.addObject("Part::Box", "Part")
        part.Length = part.Width = part.Height = 1
        given = self.document.addObject("Fem::FemMeshObject", "Given")
        given.FemMesh = made
        self.document.recompute()
        with self.assertRaisesRegex(mq.InvalidInput, "neither triangles nor tetrahedra: such meshes are cured by"):
            mq.add_cured_mesh(given, part)
        mesh = mq.curve(part.Shape, mesh=ElementMesh.of(given), order=2)
        self.assertEqual((mesh.report.invalid, len(mesh.nodes)), (0, 27))


class Program(LayersTest):
    def test_curve_a_mesh_of_hexahedra(self):
        shape, given = layered_meshes.pipe()
        straight, cad, out = (os.path.join(self.folder, name) for name in ("straight.msh", "pipe.step", "out.msh"))
        mq.curve(shape, mesh=given, order=1).write(straight)
        shape.exportStep(cad)
        status, said, lines = run("curve", cad, "--mesh", straight, "--order", 3, "-o", out, "--json", "--strict")
        self.assertEqual(status, 0, lines)
        found = json.loads(said)
        self.assertEqual(found["invalid"], 0)
        self.assertGreater(found["invalid_before"], 0)
        self.assertEqual(mq.certify(out).elements, {"hexahedron": len(given.blocks[0].nodes)})
