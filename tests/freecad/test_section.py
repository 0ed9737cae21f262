# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that a plane cuts: areas against closed forms and OpenCASCADE's sections, outlines, halves in whole elements."""

import csv
import json
import math
import os
import unittest

import FreeCAD
import helpers
import Mesh
import numpy as np
import Part
import test_cli

import MeshQuality as mq
from MeshQuality.core.elements import kinds, shapes
from MeshQuality.core.inspect import section as cuts
from MeshQuality.core.meshes.element_mesh import ElementMesh

TUBE = Part.makeCylinder(10, 30).cut(Part.makeCylinder(4, 30))


def area_of(corners):
    return 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()


def area_by_opencascade(shape, point, normal):
    normal = FreeCAD.Vector(*normal).normalize()
    wires = shape.slice(normal, normal.dot(FreeCAD.Vector(*point)))
    return Part.makeFace(wires, "Part::FaceMakerBullseye").Area


class Volumes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.box = mq.curve(Part.makeBox(10, 20, 30), order=1, volume=True, max_edge=4.0)

    def test_areas_in_any_direction(self):
        random = np.random.default_rng(5)
        for point, normal in zip(random.uniform((2, 2, 2), (8, 18, 28), (12, 3)), random.normal(size=(12, 3))):
            found = mq.section(self.box, point, normal)
            exact = area_by_opencascade(Part.makeBox(10, 20, 30), point, normal)
            self.assertAlmostEqual(found.area, exact, delta=1e-6 * exact)
            corners, element = found.triangles()
            self.assertAlmostEqual(area_of(corners), found.area, places=9)
            self.assertEqual(set(element.tolist()), set(found.element[found.areas > 0].tolist()))
            self.assertLess(np.abs((corners - found.point) @ found.normal).max(), 1e-12 * 30)

    def test_polygons_are_the_elements_where_the_plane_cuts_them(self):
        found = mq.section(self.box, (5, 10, 15), (1, 2, 3))
        self.assertEqual(len(found.polygons), len(found.areas))
        nodes, tetrahedra = self.box.nodes, self.box.tetrahedra
        for element, ring, area in list(zip(found.element, found.polygons, found.areas))[::10]:
            corners = nodes[tetrahedra[element]]
            solid = Part.Solid(Part.Shell([Part.Face(Part.makePolygon([FreeCAD.Vector(*corners[i]) for i in (*face, face[0])]))
                                           for face in kinds.FACES["tetrahedron"]]))
            self.assertAlmostEqual(area_by_opencascade(solid, found.point, found.normal), area, delta=1e-6)
            self.assertIn(len(ring), (3, 4))

    def test_a_plane_in_faces_of_elements_counts_them_once(self):
        """The half that is cut off owns what lies in the plane."""
        nodes = np.array([(x, y, z) for z in (0, 1, 2) for y in (0, 1) for x in (0, 1)], dtype=float)
        hexahedron = np.array([0, 1, 3, 2, 4, 5, 7, 6])
        blocks = [("hexahedron", np.stack([hexahedron, hexahedron + 4]))]
        for z, element in ((1.0, 0), (2.0, 1)):
            found = cuts.cut_volumes(nodes, blocks, cuts.Plane.of((0, 0, z), "z"))
            self.assertEqual((found.element.tolist(), found.areas.tolist()), ([element], [1.0]))
        self.assertEqual(len(cuts.cut_volumes(nodes, blocks, cuts.Plane.of((0, 0, 0), "z")).element), 0)

    def test_each_kind_of_element(self):
        for kind in ("tetrahedron", "pyramid", "prism", "hexahedron"):
            corners = np.array(shapes._REGULAR[kind], dtype=float)
            faces = [Part.Face(Part.makePolygon([FreeCAD.Vector(*corners[i]) for i in (*face, face[0])])) for face in kinds.FACES[kind]]
            solid = Part.Solid(Part.Shell(faces))
            for normal in ((1, 0.3, 0.2), (0.1, 1, -0.4), (1, 1, 1)):
                with self.subTest(f"{kind} {normal}"):
                    plane = cuts.Plane.of(corners.mean(axis=0), normal)
                    found = cuts.cut_volumes(corners, [(kind, np.arange(len(corners))[None])], plane)
                    self.assertAlmostEqual(float(found.areas[0]), area_by_opencascade(solid, plane.point, normal), places=9)

    def test_the_half_in_whole_elements(self):
        layered = mq.volume_mesh(Part.makeCylinder(5, 20), 3, 0.2, patches={"inlet": ["Face3"]}, patch_rest="walls")
        found = mq.section(layered, (0, 0, 10), "z")
        half, table = found.half(), mq.measures(layered)
        self.assertEqual(len(mq.measures(half)), len(found.behind))
        self.assertLess(len(found.behind), len(table))
        centres = np.concatenate([half.nodes[block.nodes].mean(axis=1) for block in half.blocks])
        self.assertLessEqual(centres[:, 2].max(), 10.0)
        np.testing.assert_allclose(mq.measures(half)["aspect_ratio"], table["aspect_ratio"][found.behind])
        self.assertEqual(half.groups, ("fluid",))
        with self.assertRaisesRegex(mq.InvalidInput, "no element is behind the plane"):
            mq.section(layered, (0, 0, -1), "z").half()


class Surfaces(unittest.TestCase):
    def test_what_closed_surfaces_enclose(self):
        mesh = mq.triangulate(TUBE, chord_height=0.002)
        found = mq.section(mesh, (0, 0, 12.3), "z")
        self.assertAlmostEqual(found.area, math.pi * 84, delta=0.1)
        self.assertAlmostEqual(area_of(found.triangles()[0]), found.area, places=9)
        self.assertEqual(sorted(round(np.linalg.norm(line[:, :2], axis=1).mean()) for line in found.outlines), [4, 10])
        for line in found.outlines:
            np.testing.assert_array_equal(line[0], line[-1])
        self.assertTrue((found.triangles()[1] == -1).all())
        self.assertEqual(len(found.areas), 0)
        # What is inside is on the left: the outer line goes around counter-clockwise.
        outer = max(found.outlines, key=lambda line: np.linalg.norm(line, axis=1).mean())
        self.assertGreater(np.cross(outer[:-1], outer[1:])[:, 2].sum(), 0.0)

    def test_oblique_cuts_of_a_mesh_of_freecad(self):
        box = Mesh.createBox(10, 20, 30)
        for normal in ((1, 2, 3), (-1, 0.5, 0.2)):
            found = mq.section(box, (1, 1, 1), normal)
            exact = area_by_opencascade(Part.makeBox(10, 20, 30, FreeCAD.Vector(-5, -10, -15)), (1, 1, 1), normal)
            self.assertAlmostEqual(found.area, exact, delta=1e-5 * exact)

    def test_open_surfaces_have_no_area(self):
        mesh = mq.triangulate(Part.Shell(TUBE.Faces[:1]))
        found = mq.section(mesh, (0, 0, 0), "x")
        self.assertTrue(math.isnan(found.area))
        self.assertEqual(len(found.triangles()[0]), 0)
        self.assertEqual(len(found.outlines), 2)
        self.assertAlmostEqual(sum(np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in found.outlines), 60.0, delta=0.05)

    def test_what_cannot_be_cut(self):
        mesh = Mesh.createSphere(5.0, 20)
        for point, normal, words in (((0, 0), "z", "point"), ((0, 0, math.nan), "z", "point"), ((0, 0, 0), "w", "normal"),
                                     ((0, 0, 0), (0, 0, 0), "normal")):
            with self.assertRaisesRegex(mq.InvalidInput, f"{words} = .* is not allowed"):
                mq.section(mesh, point, normal)
        with self.assertRaises(mq.InvalidInput):
            mq.section(Part.makeBox(1, 1, 1), (0, 0, 0), "z")


class Files(helpers.DocumentTest):
    def test_objects_and_tables(self):
        obj = mq.add_curved_mesh(self.box(), volume=True, order=2, max_edge=5.0)
        found = mq.section(obj, (5, 5, 5), "x")
        size = obj.Source.Shape.BoundBox
        self.assertAlmostEqual(found.area, size.YLength * size.ZLength, delta=1e-5 * found.area)
        path = os.path.join(self.folder, "cut.csv")
        found.write_csv(path)
        with open(path, encoding="ascii") as stream:
            rows = list(csv.DictReader(stream))
        np.testing.assert_allclose([float(row["area"]) for row in rows], found.areas, rtol=1e-8)
        self.assertTrue(all(abs(float(row["x"]) - 5.0) < 1e-9 for row in rows))

    def test_command_line(self):
        given, half, table = (os.path.join(self.folder, name) for name in ("tube.stl", "half.vtu", "cut.csv"))
        mq.triangulate(TUBE).write(given)
        status, out, err = test_cli.run("section", given, "--point", "0,0,10", "--normal=-z", "-o", half, "--csv", table, "--json")
        self.assertEqual(status, 0, err)
        found = mq.section(Mesh.Mesh(given), (0, 0, 10), "-z")
        report = json.loads("".join(out))
        self.assertEqual((report["elements"], report["area"], report["outlines"]), (len(found.element), found.area, 2))
        self.assertEqual(len(mq.measures(ElementMesh.read(half))), len(found.behind))
        with open(table, encoding="ascii") as stream:
            self.assertEqual(len(list(csv.DictReader(stream))), len(found.element))
        status, _, err = test_cli.run("section", given, "--normal", "up")
        self.assertEqual(status, 2)
        self.assertIn("normal = 'up' is not allowed", "".join(err))
