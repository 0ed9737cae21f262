# SPDX-License-Identifier: LGPL-2.1-or-later
"""volume_mesh of higher orders: curved layers that follow the CAD, valid by other programs, too."""

import json
import os

import helpers
import numpy as np
import Part
from FreeCAD import Vector
from test_cli import run
from test_curved_files import PYTHON, has
from test_exchange import run as exchange_run
from test_volume_mesh import pipe_bend, wedge

import MeshQuality as mq
from MeshQuality.core.elements import kinds

LAYERS = {"layers": 5, "first_height": 0.03, "growth_rate": 1.3}

# Gmsh's own determinants at points inside of elements and at their nodes: the number of elements, and of those with one that is not
# positive. At the apex of pyramids they vanish.
DETERMINANTS_BY_GMSH = """
import json, sys
import gmsh, numpy as np
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.open(sys.argv[1])
found = {}
for kind in gmsh.model.mesh.getElementTypes(3):
    name, dimension, order, count, nodes, corners = gmsh.model.mesh.getElementProperties(kind)
    nodes = np.array(nodes).reshape(-1, 3)
    nodes = nodes[nodes[:, 2] < 0.999] if "Pyramid" in name else nodes
    inside = np.array(gmsh.model.mesh.getIntegrationPoints(kind, "Gauss6")[0]).reshape(-1, 3)
    places = np.concatenate([nodes, inside])
    determinants = np.array(gmsh.model.mesh.getJacobians(kind, places.ravel())[1]).reshape(-1, len(places))
    found[name] = [len(determinants), int((determinants.min(axis=1) <= 0.0).sum())]
print(json.dumps(found))
"""


# What MFEM's numbers of elements are, and their edges and quadrilaterals as fem/geom.cpp of MFEM goes through them.
MFEM = {
    4: ("tetrahedron", ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)), ()),
    6: ("prism", ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)), ((0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5))),
    7: ("pyramid", ((0, 1), (1, 2), (3, 2), (0, 3), (0, 4), (1, 4), (2, 4), (3, 4)), ((3, 2, 1, 0),)),
}


def numbered_by_mfem(path):
    """[(kind, attribute, points by place of the element: {corner, pair or four corners: point}), ...] of a file of volumes of order 2,
    and its elements of the boundary, [(attribute, corners), ...].
    """
    with open(path, encoding="utf-8") as file:
        lines = [line.strip() for line in file if line.strip() and not line.startswith("#")]
    rows = {}
    for title in ("elements", "boundary"):
        at = lines.index(title)
        rows[title] = [list(map(int, line.split())) for line in lines[at + 2:at + 2 + int(lines[at + 1])]]
    vertices = int(lines[lines.index("vertices") + 1])
    points = np.array([line.split() for line in lines[lines.index("nodes") + 5:]], dtype=float)
    edges, quadrilaterals, found = {}, {}, []
    for _, number, *corners in rows["elements"]:
        for edge in MFEM[number][1]:
            edges.setdefault(frozenset(corners[i] for i in edge), len(edges))
        for four in MFEM[number][2]:
            quadrilaterals.setdefault(frozenset(corners[i] for i in four), len(quadrilaterals))
    for attribute, number, *corners in rows["elements"]:
        kind, pairs, fours = MFEM[number]
        places = {(i,): points[corner] for i, corner in enumerate(corners)}
        places.update({edge: points[vertices + edges[frozenset(corners[i] for i in edge)]] for edge in pairs})
        places.update({four: points[vertices + len(edges) + quadrilaterals[frozenset(corners[i] for i in four)]] for four in fours})
        found.append((kind, attribute, places))
    assert len(points) == vertices + len(edges) + len(quadrilaterals), "nodes are missing, or too many"
    return found, [(attribute, corners) for attribute, _, *corners in rows["boundary"]]


def distances(face, points):
    return [face.distToShape(Part.Vertex(Vector(*point)))[0] for point in points.tolist()]


class CurvedVolumeMeshes(helpers.DocumentTest):
    def assert_sound(self, mesh, order):
        """All elements are proven valid, conform, share the nodes between corners, and are none of them bent less."""
        certificate = mq.certify(mesh)
        self.assertEqual((certificate.invalid, certificate.conforming, certificate.oriented), (0, True, True))
        self.assertEqual({block.order for block in mesh.blocks}, {order})
        self.assertEqual(mesh.report.straightened, ())
        self.assertGreater(mesh.report.min_distortion, 0.0)
        of_edge, of_face = {}, {}
        for block in mesh.blocks:
            between = block.nodes[:, kinds.CORNERS[block.kind]:]
            for i, edge in enumerate(kinds.EDGES[block.kind] if order == 2 else ()):
                for key, node in zip(np.sort(block.nodes[:, list(edge)], axis=1).tolist(), between[:, i].tolist()):
                    self.assertEqual(of_edge.setdefault(tuple(key), node), node)
            for face in kinds.FACES[block.kind] if kinds.DIMENSION[block.kind] == 3 else ():
                for key in np.sort(block.nodes[:, list(face)], axis=1).tolist():
                    of_face[tuple(key)] = of_face.get(tuple(key), 0) + 1
        self.assertLessEqual(max(of_face.values()), 2)
        self.assertEqual(len(set(of_edge.values())), len(of_edge))

    def assert_valid_by_gmsh(self, mesh):
        if not has("gmsh"):
            self.skipTest("needs python3-gmsh")
        path = os.path.join(self.folder, "curved.msh")
        mesh.write(path)
        found = json.loads(exchange_run(PYTHON, "-c", DETERMINANTS_BY_GMSH, path))
        self.assertEqual(sorted(count for count, _ in found.values()), sorted(len(rows) for _, rows in mesh.solid_blocks))
        self.assertEqual(sum(folded for _, folded in found.values()), 0, found)

    def test_layers_of_a_pipe_bend_follow_its_wall(self):
        shape, errors = pipe_bend(), []
        for edge in (1.5, 0.8):  # of which surface edges are about halved, too: the chord height bounds them as well
            mesh = mq.volume_mesh(shape, **LAYERS, walls=["Face1"], max_edge=edge, order=2)
            self.assert_sound(mesh, 2)
            self.assert_valid_by_gmsh(mesh)
            self.assertEqual(mesh.report.covered, 1.0)
            on_wall = mesh.boundary_triangles[mesh.triangle_face == 0]
            self.assertLess(max(distances(shape.Faces[0], mesh.nodes[np.unique(on_wall)])), 1e-5)
            straight = mq.volume_mesh(shape, **LAYERS, walls=["Face1"], max_edge=edge)
            np.testing.assert_allclose(mesh.nodes[:len(straight.nodes)], straight.nodes, atol=1e-5)
            errors.append((abs(mesh.report.volume / shape.Volume - 1.0), abs(straight.report.volume / shape.Volume - 1.0)))
        self.assertLess(errors[0][0], 2e-3 * errors[0][1])  # of order 2 and of order 1
        self.assertLess(errors[1][0], 0.3 * errors[0][0])

    def test_where_layers_run_out(self):
        """Pyramids and tetrahedra at the apex of a cone, whose wall bends more than the first layer is high."""
        mesh = mq.volume_mesh(Part.makeCone(0, 3, 12), layers=4, first_height=0.02, growth_rate=1.3, max_edge=1.5, order=2)
        self.assertGreater(len(mesh.pyramids), 0)
        self.assertLess(mesh.report.covered, 1.0)
        self.assert_sound(mesh, 2)
        self.assert_valid_by_gmsh(mesh)

    def test_around_a_pin_with_thin_layers(self):
        pin = Part.makeCylinder(3, 12)
        mesh = mq.volume_mesh(pin, layers=3, first_height=0.002, far_field="box:2", max_edge=2.0, patch_rest="pin", order=3)
        self.assert_sound(mesh, 3)
        block, rows = next(part for part in mesh.group_members["pin"] if mesh.blocks[part[0]].kind == "triangle")
        self.assertLess(max(distances(pin, mesh.nodes[np.unique(mesh.blocks[block].nodes[rows])])), 1e-5)

    def test_seams_of_coplanar_faces_stay(self):
        """A floor of two faces in one plane, beside walls: each keeps its area, so that the mesh follows the edge between them."""
        floor = Part.makeBox(10, 10, 5).fuse(Part.makeBox(10, 10, 5, Vector(10, 0, 0))).Solids[0]
        for order in (1, 2):
            mesh = mq.volume_mesh(floor, layers=3, first_height=0.05, walls=["Face1", "Face2"], max_edge=2.0, order=order)
            triangles, quadrilaterals = mesh.sides
            for face, shape in enumerate(floor.Faces):
                halves = quadrilaterals[mesh.quadrilateral_face == face]
                rows = np.concatenate([triangles[mesh.triangle_face == face], halves[:, [0, 1, 2]], halves[:, [0, 2, 3]]])
                a, b, c = mesh.nodes[rows].transpose(1, 0, 2)
                self.assertAlmostEqual(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2, shape.Area, delta=1e-4)

    def test_files_and_their_certificates(self):
        part = os.path.join(self.folder, "bend.step")
        pipe_bend().exportStep(part)
        shape = Part.read(part)
        for order, walls in ((2, None), (1, ["Face1"]), (2, ["Face1"])):
            mesh = mq.volume_mesh(shape, layers=2, first_height=0.05, walls=walls, max_edge=3.0, order=order)
            path = os.path.join(self.folder, f"bend{order}.{'vtu' if walls is None else 'msh'}")
            mesh.write(path)
            certificate = mq.certify(path, shape)
            self.assertEqual((certificate.invalid, certificate.not_on_shape), (0, None))
            self.assertEqual(certificate.folded_on_cad, 0)
            self.assertLess(certificate.max_deviation, 0.3 if order == 1 else 0.02)
            self.assertEqual(len(certificate.triangle_face), len(mesh.boundary_triangles) + 2 * len(mesh.boundary_quadrilaterals))
            certificate.save(f"{path}.json", cad=part)
            found = mq.verify(f"{path}.json")
            self.assertTrue(found.holds, found.faults)
        status, _, said = run("verify", f"{path}.json", "--strict")
        self.assertEqual(status, 0, said)
        with self.assertRaisesRegex(mq.InvalidInput, "straight sides, not of order 2"):
            mesh.write(os.path.join(self.folder, "case"))

    def test_mfem_finds_each_node_in_its_place(self):
        mesh = mq.volume_mesh(wedge(20), layers=3, first_height=0.05, max_edge=2.5, walls=["Face1", "Face2"], order=2)
        self.assertIn(".mesh", mesh.suffixes)
        path = os.path.join(self.folder, "wedge.mesh")
        mesh.write(path, scale=0.001)
        found, boundary = numbered_by_mfem(path)
        volumes = [block for block in mesh.blocks if kinds.DIMENSION[block.kind] == 3]
        self.assertEqual({kind for kind, *_ in found}, {"tetrahedron", "prism", "pyramid"})
        expected = [(block.kind, nodes) for block in volumes for nodes in block.nodes]
        self.assertEqual(len(found), len(expected))
        for (kind, attribute, places), (known, nodes) in zip(found, expected):
            self.assertEqual((kind, attribute), (known, 1))
            corners = kinds.places(kind, kinds.CORNERS[kind])
            at = kinds.matching(kind, len(nodes), np.array([corners[list(place)].mean(axis=0) for place in places]))
            np.testing.assert_allclose(np.array([*places.values()]), 0.001 * mesh.nodes[nodes[at]], rtol=1e-12, atol=1e-15)
        faces = [block for block in mesh.blocks if kinds.DIMENSION[block.kind] == 2]
        self.assertEqual(len(boundary), sum(len(block.nodes) for block in faces))
        self.assertEqual(len({attribute for attribute, _ in boundary}), 5)

    def test_the_command_line(self):
        part, path = (os.path.join(self.folder, name) for name in ("bend.brep", "bend.msh"))
        pipe_bend().exportBrep(part)
        status, out, said = run("volume", part, "-o", path, "--layers", "2", "--first-height", "0.05", "--max-edge", "2.5", "--wall", "Face1",
                                "--order", "2", "--json", "--strict")
        self.assertEqual(status, 0, said)
        report = json.loads(out)
        self.assertEqual((report["order"], report["straightened"]), (2, []))
        self.assertEqual({block.order for block in mq.read_mesh(path).blocks}, {2})
        status, _, said = run("volume", part, "-o", path, "--layers", "2", "--first-height", "0.05", "--order", "9")
        self.assertEqual(status, 2)
        self.assertIn("order", "".join(said))


class CurvedFlowMeshObjects(helpers.DocumentTest):
    def test_a_document_keeps_it(self):
        part = self.document.addObject("Part::Feature", "Region")
        part.Shape = wedge(20)
        before = mq.add_flow_mesh(part, 2, 0.05, max_edge=2.5)
        obj = mq.add_flow_mesh(part, 2, 0.05, max_edge=2.5, order=2)
        self.assertNotEqual(before.Fingerprint, obj.Fingerprint)
        self.assertGreater(obj.MinDistortion, 0.0)
        self.assertEqual(obj.Elements, before.Elements)
        kinds_of = obj.Kinds
        self.assertTrue(any(kind.startswith("pyramid") for kind in kinds_of))
        name = obj.Name
        self.reopen()
        mesh = mq.ElementMesh.of(self.document.getObject(name))
        self.assertEqual({block.order for block in mesh.blocks}, {2})
        certificate = mq.certify(mesh)
        self.assertEqual((certificate.invalid, certificate.conforming), (0, True))
        self.assertEqual([f"{kind}: {count}" for kind, count in certificate.elements.items()], kinds_of)
        with self.assertRaisesRegex(mq.InvalidInput, "order=1"):
            mq.write_openfoam_case(self.document.getObject(name), os.path.join(self.folder, "case"))
