# SPDX-License-Identifier: LGPL-2.1-or-later
"""mq.triangulate: properties of the mesh, options, progress and cancel."""

import gc
import math
import os
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import FreeCAD
import helpers
import numpy as np
import Part
import parts

import MeshQuality as mq
from MeshQuality.core.certify import verdict


def several_bodies():
    """Four solids that do not touch, none of which takes most of the triangles."""
    bodies = [Part.makeSphere(5), Part.makeCylinder(4, 10), Part.makeTorus(6, 2), Part.makeCone(4, 2, 8)]
    return Part.makeCompound([body.translate(FreeCAD.Vector(20 * i, 0, 0)) or body for i, body in enumerate(bodies)])


class Details(unittest.TestCase):
    """Edges and faces below what is asked for."""

    @staticmethod
    def cut_plate():
        """A plate with one corner cut off at 0.0005 mm: its side there is as wide as that."""
        corners = ((0, 0), (10, 0), (10, 9.9995), (9.9995, 10), (0, 10), (0, 0))
        face = Part.Face(Part.makePolygon([FreeCAD.Vector(x, y, 0) for x, y in corners]))
        return face.extrude(FreeCAD.Vector(0, 0, 3))

    def test_a_thin_face_is_an_edge(self):
        shape = self.cut_plate()
        mesh = mq.triangulate(shape, chord_height=0.05)
        self.assertTrue(mesh.report.closed and mesh.report.oriented)
        self.assertLess(len(mesh.triangles), 1000)
        self.assertAlmostEqual(mesh.report.volume, shape.Volume, places=2)
        self.assertAlmostEqual(mesh.report.detail, 0.001, places=6)
        text = "mm, which does not show at what is asked for: its edges count as one"
        self.assertTrue(any(text in str(note) for note in mesh.report.notes), mesh.report.notes)

    def test_short_edges_side_by_side_are_one_vertex(self):
        points = [(0, 0), (10, 0), (10, 7.9994), (9.9998, 7.9998), (9.9994, 8), (0, 8), (0, 0)]
        plate = Part.Face(Part.makePolygon([FreeCAD.Vector(x, y, 0) for x, y in points]))
        for shape in (plate, plate.extrude(FreeCAD.Vector(0, 0, 3))):
            mesh = mq.triangulate(shape, chord_height=0.02)
            self.assertEqual(mesh.report.closed, shape is not plate)
            self.assertTrue(mesh.report.manifold)
            self.assertLess(len(mesh.triangles), 100)
            self.assertEqual(len(mesh.report.exempt), 0)

    @staticmethod
    def horn(length):
        """A plate between two arcs that touch the line y = 0: one at the tip, one this far from it."""
        def on_arc(radius, start, turn):
            return FreeCAD.Vector(start + radius * math.sin(turn), radius - radius * math.cos(turn), 0)

        tip, node, end = on_arc(2, 0, 0), on_arc(10, length, 0), on_arc(2, 0, 1.2)
        turn = math.asin((end.x - length) / 10)
        upper = Part.Arc(tip, on_arc(2, 0, 0.5), end).toShape()
        lower = Part.Arc(node, on_arc(10, length, turn / 2), on_arc(10, length, turn)).toShape()
        line = Part.makeLine(tip, node)
        side = Part.makeLine(on_arc(10, length, turn), end)
        plate = Part.Face(Part.Wire(Part.__sortEdges__([upper, line, lower, side])))
        below = FreeCAD.Vector(0, 0, -1)
        shell = Part.Shell([plate, upper.extrude(-below), line.extrude(below), lower.extrude(below)])
        shell.sewShape()
        return shell

    def test_a_tip_beside_a_narrow_corner_is_taken_off(self):
        report = mq.triangulate(self.horn(0.02), min_angle=25, chord_height=0.02).report
        self.assertEqual([reason.cause for _, reason in report.exempt_reasons], ["narrow_corner"])
        self.assertGreaterEqual(report.min_angle_unexempted, 25)
        self.assertTrue(any("Face1: has a spike" in str(note) for note in report.notes), report.notes)

    def test_a_finer_distance_keeps_it(self):
        mesh = mq.triangulate(self.cut_plate(), chord_height=0.001)
        self.assertEqual(len(set(mesh.triangle_face.tolist())), 7)
        self.assertGreater(len(mesh.triangles), 10000)

    def test_curving_follows(self):
        shape = self.cut_plate()
        for curved in (mq.curve(shape, order=2, chord_height=0.05, volume=True),
                       mq.curve(mq.triangulate(shape, chord_height=0.05), order=3, shape=shape)):
            self.assertEqual(curved.report.invalid, 0)

    def test_loose_faces_are_joined_up_to_a_pole(self):
        """At the tip any parameter along the collapsed side is nearest: that of the edge's own curve is the right one."""
        half = Part.makeCone(3, 0, 5, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 180)
        faces = [face.copy() for face in half.Faces if abs(face.CenterOfMass.y) > 1e-6]
        other = [face.copy() for face in faces]
        for face in other:
            face.rotate(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 180)
        mesh = mq.triangulate(Part.Compound(faces + other), chord_height=0.02)
        self.assertTrue(mesh.report.closed and mesh.report.oriented, mesh.report)
        self.assertEqual(mesh.report.self_intersections, 0)
        self.assertLess(abs(mesh.report.volume / (15.0 * np.pi) - 1.0), 0.01)

    def loose(self, *solids):
        return [face.copy() for solid in solids for face in solid.Faces]

    def test_loose_faces_show_their_outside(self):
        faces = self.loose(Part.makeBox(10, 8, 6), Part.makeCylinder(2, 5, FreeCAD.Vector(20, 0, 0)))
        mesh = mq.triangulate(Part.Compound([face.reversed() for face in faces]), chord_height=0.02)
        self.assertTrue(mesh.report.closed and mesh.report.oriented, mesh.report)
        self.assertLess(abs(mesh.report.volume / (480.0 + 20.0 * np.pi) - 1.0), 0.01)

    def test_a_void_of_loose_faces_stays_a_void(self):
        inner = Part.makeBox(4, 4, 3, FreeCAD.Vector(3, 2, 1))
        core = Part.makeBox(1, 1, 1, FreeCAD.Vector(4, 3, 2))
        faces = self.loose(inner, Part.makeBox(10, 8, 6), core)
        mesh = mq.triangulate(Part.Compound(faces), chord_height=0.02)
        self.assertTrue(mesh.report.closed and mesh.report.oriented, mesh.report)
        self.assertAlmostEqual(mesh.report.volume, 480.0 - 48.0 + 1.0, places=3)

    def test_loose_faces_are_joined_along_parts_of_edges(self):
        """One face has a whole edge or circle where its neighbours have several that end elsewhere."""
        lower = Part.makeBox(10, 8, 6)
        left = Part.makeBox(4, 8, 2, FreeCAD.Vector(0, 0, 6))
        right = Part.makeBox(6, 8, 2, FreeCAD.Vector(4, 0, 6))
        tower = Part.makeCylinder(2, 3, FreeCAD.Vector(5, 4, 8))
        tower.rotate(FreeCAD.Vector(5, 4, 8), FreeCAD.Vector(0, 0, 1), 50)  # the seam meets no vertex of the plate
        plate = Part.Face([Part.Wire(Part.makePolygon([FreeCAD.Vector(x, y, 8) for x, y in (
            (0, 0), (10, 0), (10, 8), (0, 8), (0, 0))])), Part.Wire([Part.makeCircle(
                2, FreeCAD.Vector(5, 4, 8), FreeCAD.Vector(0, 0, 1), a, a + 120) for a in (0, 120, 240)])])
        plate.validate()
        faces = [face for face in self.loose(lower) if abs(face.CenterOfMass.z - 6) > 1e-6]
        for side in self.loose(left, right):
            where = side.CenterOfMass
            if abs(where.z - 6) > 1e-6 and abs(where.z - 8) > 1e-6 and abs(where.x - 4) > 1e-6:
                faces.append(side)
        faces += [plate] + [face for face in self.loose(tower) if abs(face.CenterOfMass.z - 8) > 1e-6]
        mesh = mq.triangulate(Part.Compound(faces), chord_height=0.02)
        self.assertTrue(mesh.report.closed and mesh.report.oriented and mesh.report.manifold, mesh.report)
        self.assertEqual(mesh.report.self_intersections, 0)
        self.assertLess(abs(mesh.report.volume / (640.0 + 12.0 * np.pi) - 1.0), 0.001)
        self.assertGreaterEqual(mesh.report.min_angle_unexempted, 25.0)
        self.assertEqual(mq.curve(mesh, order=2, shape=Part.Compound(faces)).report.invalid, 0)
        apart = mq.triangulate(Part.Compound(faces), chord_height=0.02, sew=False)
        self.assertFalse(apart.report.closed or apart.report.sewn)
        self.assertEqual(mq.curve(apart, order=2, shape=Part.Compound(faces)).report.invalid, 0)

    def test_an_iges_file_is_watertight(self):
        """Its reader leaves mirrored places whose factor is positive, and faces without a shell."""
        plate = Part.makeBox(10, 8, 6).cut(Part.makeCylinder(2, 20, FreeCAD.Vector(5, 4, -5)))
        shape = plate.makeFillet(0.7, plate.Edges[:4])
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "plate.igs")
            shape.exportIges(path)
            read = Part.Shape()
            read.read(path)
        self.assertFalse(read.Shells)
        mesh = mq.triangulate(read, chord_height=0.02)
        self.assertTrue(mesh.report.closed and mesh.report.oriented, mesh.report)
        self.assertEqual(mesh.report.self_intersections, 0)
        self.assertLessEqual(mesh.report.max_chord_height, 0.02)
        self.assertLess(abs(mesh.report.volume / shape.Volume - 1.0), 0.01)

    def test_loose_faces_are_joined(self):
        box = Part.makeBox(10, 8, 6)
        shape = box.cut(Part.makeSphere(4, FreeCAD.Vector(9, 7, 5)))
        faces = [face.copy() for face in shape.Faces]
        mesh = mq.triangulate(Part.Compound([face.reversed() if i % 3 == 0 else face
                                             for i, face in enumerate(faces)]), chord_height=0.02)
        self.assertTrue(mesh.report.closed and mesh.report.oriented, mesh.report)
        self.assertEqual(mesh.report.self_intersections, 0)
        self.assertLess(abs(abs(mesh.report.volume) / shape.Volume - 1.0), 0.01)
        self.assertTrue(any("edges of loose faces were joined in" in str(note) for note in mesh.report.notes))


class SimpleParts(unittest.TestCase):
    def check(self, shape, **options):
        mesh = mq.triangulate(shape, **options)
        report = mesh.report
        self.assertTrue(report.closed and report.oriented and report.manifold, str(report))
        self.assertGreaterEqual(report.min_angle_unexempted, options.get("min_angle", 25.0))
        self.assertEqual(report.triangles, len(mesh.triangles))
        self.assertEqual(report.vertices, len(mesh.vertices))
        self.assertTrue(np.array_equal(mesh.vertices, mesh.vertices.astype(np.float32)))
        self.assertGreater(report.volume, 0.0)
        return mesh

    def test_every_elementary_surface(self):
        for name, shape in helpers.simple_parts().items():
            with self.subTest(name):
                mesh = self.check(shape, chord_height_relative=0.01)
                size = max(shape.BoundBox.XLength, shape.BoundBox.YLength, shape.BoundBox.ZLength)
                self.assertLessEqual(mesh.report.max_chord_height, 0.01 * size)
                self.assertLessEqual(abs(mesh.report.volume - shape.Volume),
                                     mesh.report.max_chord_height * shape.Area + 1e-6)
                self.assertEqual(sorted(set(mesh.triangle_face.tolist())),
                                 list(range(len(shape.Faces))))
                self.assertLessEqual(max(helpers.distances_to_faces(shape, mesh)), 0.01 * size)

    def test_a_box_needs_no_more_than_its_corners_ask_for(self):
        shape = Part.makeBox(10, 10, 10)
        mesh = self.check(shape)
        self.assertAlmostEqual(mesh.report.volume, 1000.0, places=6)
        self.assertEqual(mesh.report.euler, 2)

    def test_every_vertex_lies_on_its_entity(self):
        shape = helpers.simple_parts()["cut"]
        mesh = self.check(shape)
        lists = (shape.Vertexes, shape.Edges, shape.Faces)
        for point, (dimension, index) in list(zip(mesh.vertices, mesh.vertex_entity))[::5]:
            vertex = Part.Vertex(FreeCAD.Vector(*(point + mesh.origin)))
            self.assertLess(vertex.distToShape(lists[dimension][index])[0], 1e-4)

    def test_finer_chord_height_gives_a_closer_mesh(self):
        shape = Part.makeTorus(10, 3)
        coarse = self.check(shape, chord_height=0.2)
        fine = self.check(shape, chord_height=0.05)
        self.assertLess(fine.report.max_chord_height, 0.05)
        self.assertGreater(len(fine.triangles), len(coarse.triangles))
        self.assertLess(abs(fine.report.volume - shape.Volume),
                        abs(coarse.report.volume - shape.Volume))

    def test_max_edge_bounds_the_edges(self):
        mesh = self.check(Part.makeBox(10, 10, 10), max_edge=2.0)
        corners = mesh.vertices[mesh.triangles]
        edges = corners - np.roll(corners, 1, axis=1)
        self.assertLessEqual(np.linalg.norm(edges, axis=2).max(), 2.0)

    def test_same_input_same_bytes(self):
        shape = helpers.simple_parts()["fused"]
        first, second = (mq.triangulate(shape, chord_height=0.1) for _ in range(2))
        self.assertEqual(first.vertices.tobytes(), second.vertices.tobytes())
        self.assertEqual(first.triangles.tobytes(), second.triangles.tobytes())

    def test_the_bytes_are_the_same_for_any_number_of_threads(self):
        shapes = {**helpers.simple_parts(), "bracket": parts.bracket(), "flap": parts.flap(), "helix": parts.helix(),
                  "bodies": several_bodies()}
        for name, shape in shapes.items():
            with self.subTest(name):
                one, *others = (mq.triangulate(shape, chord_height_relative=0.0005, threads=n) for n in (1, 2, 3, 8))
                for several in others:
                    for array in ("vertices", "triangles", "triangle_face", "vertex_entity"):
                        self.assertEqual(getattr(several, array).tobytes(), getattr(one, array).tobytes(), array)
                    for figure in ("max_chord_height", "exempt", "notes", "queries", "predicates", "exact_predicates"):
                        self.assertEqual(getattr(several.report, figure), getattr(one.report, figure), figure)

    def test_bodies_that_do_not_touch_get_what_one_alone_gets(self):
        shape = several_bodies()
        mesh = self.check(shape, chord_height=0.02)
        alone = [mq.triangulate(body, chord_height=0.02) for body in shape.Solids]
        self.assertEqual(mesh.report.euler, sum(one.report.euler for one in alone))
        self.assertEqual(mesh.report.exempt, [])
        faces = np.cumsum([0] + [len(body.Faces) for body in shape.Solids])
        for first, end, one in zip(faces[:-1], faces[1:], alone):
            own = (mesh.triangle_face >= first) & (mesh.triangle_face < end)
            self.assertAlmostEqual(own.sum() / len(one.triangles), 1.0, delta=0.1)

    def test_a_limit_concerns_all_bodies_together(self):
        mesh = mq.triangulate(several_bodies(), chord_height=0.001, max_triangles=2000)
        self.assertLessEqual(len(mesh.triangles), 2000)
        self.assertFalse(mesh.report.complete)

    def test_numbers_of_threads_that_are_none_are_refused(self):
        for threads in (-1, 1025, 1.5, True, "all"):
            with self.assertRaisesRegex(mq.InvalidInput, "threads"):
                mq.triangulate(Part.makeBox(1, 1, 1), threads=threads)

    def test_several_threads_at_once_get_what_one_gets(self):
        shapes = list(helpers.simple_parts().values())[:4]
        alone = [mq.triangulate(shape, chord_height=0.1).triangles.tobytes() for shape in shapes]
        with ThreadPoolExecutor(4) as pool:
            together = list(pool.map(
                lambda shape: mq.triangulate(shape, chord_height=0.1).triangles.tobytes(), shapes))
        self.assertEqual(alone, together)

    def test_far_from_the_origin_nothing_is_lost(self):
        shape = Part.makeCylinder(5, 10, FreeCAD.Vector(1e6, 0, 0))
        mesh = self.check(shape, chord_height=0.05)
        self.assertTrue(mesh.origin.any())
        self.assertLess(np.abs(mesh.vertices).max(), 1000.0)
        self.assertLess(abs(mesh.report.volume / shape.Volume - 1.0), 0.05)
        self.assertAlmostEqual(mesh.to_mesh().BoundBox.Center.x, 1e6, delta=1.0)

    def test_faces_below_single_precision_are_a_point(self):
        box = Part.makeBox(10, 10, 10)
        cutter = Part.makeBox(8, 8, 8, FreeCAD.Vector(-4, -4, 0))
        cutter.Placement = FreeCAD.Placement(
            FreeCAD.Vector(10, 10, 10) - FreeCAD.Vector(1, 1, 1) * 3e-6,
            FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), FreeCAD.Vector(1, 1, 1)))
        shape = box.cut(cutter)
        self.assertEqual(len(shape.Faces), 7)
        tiny = min(range(7), key=lambda i: shape.Faces[i].Area)
        self.assertLess(shape.Faces[tiny].Length, 5e-5)
        mesh = self.check(shape)
        self.assertEqual(mesh.report.euler, 2)
        self.assertNotIn(tiny, mesh.triangle_face)
        left_out = f"Face{tiny + 1} is a point in single precision: left out"
        self.assertIn(left_out, mesh.report.notes)
        for method in ("star", "sprinkle"):
            with self.subTest(method=method):
                sampled = mq.triangulate(shape, method=method)
                self.assertIn(left_out, sampled.report.notes)

    def test_two_faces_do_not_share_an_edge_that_is_no_segment(self):
        """A segment was split between triangles with the same third corner on either face."""
        def rounded(size, place, radius):
            box = Part.makeBox(*size, FreeCAD.Vector(*place))
            return box.makeFillet(radius, box.Edges)

        first = rounded((6.649232081042951, 11.659334527478972, 9.602467782112463),
                        (3.1219687772852973, -1.6347451926683352, -2.449704694585839), 0.7707597426587804)
        second = rounded((7.219900622734113, 8.698709089978255, 10.017261593541498),
                         (0.4278010063274795, -0.7530503810956031, -2.3951446560146934), 0.45393916853761396)
        ring = Part.makeTorus(6.097066389693372, 6.537007492019581 / 4,
                              FreeCAD.Vector(3.1651895841969404, 0.5824190002692138, 3.217932993368538))
        shape = first.fuse(second).cut(ring)
        for insertion in ("off-centre", "circumcentre"):
            self.check(shape, min_angle=16.526594861165, chord_height_relative=0.003368443955734472,
                       insertion=insertion)
        for min_edge in (0.03, 1.0):  # which gives way to it
            self.check(shape, min_edge=min_edge)

    def test_edges_of_no_face_are_named(self):
        axis = Part.makeLine(FreeCAD.Vector(-50, 0, 0), FreeCAD.Vector(50, 0, 0))
        result = mq.triangulate(Part.makeCompound([Part.makeBox(10, 10, 10), axis, Part.Vertex(0, 0, 99)]))
        self.assertEqual([note for note in result.report.notes if "of no face" in note],
                         ["Edge13: of no face, so that no mesh has it", "Vertex11: of no face, so that no mesh has it"])
        self.assertEqual(mq.triangulate(Part.makeBox(10, 10, 10)).report.notes, [])

    def test_open_faces_give_an_open_mesh(self):
        mesh = mq.triangulate(Part.makePlane(10, 10))
        self.assertFalse(mesh.report.closed)
        self.assertTrue(mesh.report.oriented and mesh.report.manifold)
        self.assertAlmostEqual(mesh.report.area, 100.0, places=6)


class Views(unittest.TestCase):
    def test_types_shapes_and_lifetime(self):
        mesh = mq.triangulate(Part.makeBox(1, 2, 3))
        expected = {"vertices": (np.float64, 2, 3), "triangles": (np.int32, 2, 3),
                    "triangle_face": (np.int32, 1, None), "vertex_entity": (np.int32, 2, 2),
                    "origin": (np.float64, 1, None)}
        for name, (dtype, dimensions, width) in expected.items():
            array = getattr(mesh, name)
            self.assertEqual(array.dtype, dtype)
            self.assertEqual(array.ndim, dimensions)
            if width:
                self.assertEqual(array.shape[1], width)
            with self.assertRaises(ValueError):
                array[0] = 1
        again = mesh.vertices
        self.assertTrue(np.shares_memory(again, mesh.vertices), "a view, not a copy")
        before = again.copy()
        del mesh
        gc.collect()
        junk = [np.ones(10000) for _ in range(100)]
        self.assertTrue(np.array_equal(again, before), f"{len(junk)}")

    def test_report_reads_well(self):
        report = mq.triangulate(Part.makeBox(1, 2, 3)).report
        self.assertIsInstance(report, mq.MeshReport)
        text = str(report)
        for word in ("triangles", "closed", "angles", "chord height"):
            self.assertIn(word, text)
        self.assertEqual(sum(report.angle_histogram), report.triangles)
        self.assertEqual(report.exempt_causes, [])
        self.assertTrue(all(isinstance(s, float) for s in report.seconds.values()))


class Exemptions(unittest.TestCase):
    def test_a_narrow_wedge_keeps_its_angle_and_says_so(self):
        corners = [FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(20, 0, 0), FreeCAD.Vector(20, 3, 0)]
        wedge = Part.Face(Part.makePolygon([*corners, corners[0]])).extrude(
            FreeCAD.Vector(0, 0, 10))
        report = mq.triangulate(wedge).report
        self.assertTrue(report.closed and report.oriented and report.manifold)
        self.assertGreaterEqual(report.min_angle_unexempted, 25.0)
        self.assertAlmostEqual(report.min_angle, math.degrees(math.atan2(3, 20)), places=3)
        cause, count = report.exempt_causes[0]
        self.assertEqual(cause, "the shape itself has a corner of #° between Edge# and Edge# at Vertex# on Face#")
        self.assertEqual(sum(n for _, n in report.exempt_causes), len(report.exempt))
        self.assertIn(f"{count} triangles below the limit, same cause", str(report))


    def test_faces_that_touch_along_an_edge_do_not_cross(self):
        """Splitting the triangles of both faces led to the same crossings at half the size, down to single precision."""
        ball = Part.makeSphere(5, FreeCAD.Vector(), FreeCAD.Vector(-1, 0, 0), -90, 90, 360)
        for chord_height in (0.4, 0.28):
            report = mq.triangulate(Part.makeCylinder(5, 5).cut(ball), chord_height=chord_height).report
            self.assertEqual((report.self_intersections, len(report.exempt)), (0, 0), str(report))

    def test_a_wall_of_a_micrometre_is_refined_to_its_thickness(self):
        """Triangles between its edges are crowded until the edges have been divided: 292 of 76,502 missed the bound."""
        box = Part.makeBox(8, 10, 5)
        pocket = Part.makeBox(9, 6, 4, FreeCAD.Vector(0.251, 5, 2))
        report = mq.triangulate(box.makeFillet(0.25, box.Edges).cut(pocket), min_angle=29.7, chord_height=0.05).report
        self.assertEqual((len(report.exempt), report.self_intersections), (0, 0), str(report))
        self.assertTrue(report.closed and report.manifold)
        self.assertLess(report.triangles, 120000)

    def test_pieces_that_only_touch_do_not_narrow_each_others_corners(self):
        lens = Part.Face(Part.Wire([Part.Arc(*(FreeCAD.Vector(*p) for p in points)).toShape()
                                    for points in (((0, 0, 0), (10, 3, 0), (20, 0, 0)),
                                                   ((20, 0, 0), (10, 2.4, 0), (0, 0, 0)))]))
        part = lens.extrude(FreeCAD.Vector(0, 0, 2))
        beside = Part.makeBox(1, 1, 1, FreeCAD.Vector(-1, -1, -1))  # has a node where the part has one
        alone = mq.triangulate(part, chord_height=0.02)
        both = mq.triangulate(Part.makeCompound([part, beside]), chord_height=0.02)
        self.assertEqual(int((both.triangle_face < len(part.Faces)).sum()), len(alone.triangles))


class MissingFaces(unittest.TestCase):
    """A shape one of whose faces cannot be meshed: a bow tie, whose border crosses itself."""

    def setUp(self):
        corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (9, 9, 0), (9, 0, 0), (0, 9, 0))]
        bow_tie = Part.Face(Part.makePolygon([*corners, corners[0]]))
        self.shape = Part.makeCompound([Part.makePlane(5, 4, FreeCAD.Vector(20, 0, 0)), bow_tie])

    def test_they_are_an_error_that_names_them(self):
        with self.assertRaisesRegex(mq.TopologyError, "no triangulation of Face2: "):
            mq.triangulate(self.shape)

    def test_when_allowed_the_rest_is_meshed_and_they_are_noted(self):
        mesh = mq.triangulate(self.shape, allow_missing_faces=True)
        self.assertAlmostEqual(mesh.report.area, 20.0, places=6)
        self.assertEqual(set(mesh.triangle_face.tolist()), {0})
        self.assertTrue(any("Face2 is missing" in note for note in mesh.report.notes))
        self.assertEqual([face for face, _ in mesh.report.missing_faces], [1])
        self.assertIn("not all limits met", repr(mesh))
        finding, = verdict.of_triangulation(mesh, False)
        self.assertEqual((finding.text, finding.faces),
                         ("1 face could not be meshed and was left out: Face2.", ("Face2",)))

    def test_a_shape_of_nothing_else_stays_an_error(self):
        with self.assertRaises(mq.TopologyError):
            mq.triangulate(self.shape.Faces[1], allow_missing_faces=True)


class Options(unittest.TestCase):
    def refused(self, *words, **options):
        with self.assertRaises(mq.Error) as caught:
            mq.triangulate(Part.makeBox(1, 1, 1), **options)
        for word in words:
            self.assertIn(word, str(caught.exception))
        return caught.exception

    def test_numbers_out_of_range_are_named(self):
        for name in ("min_angle", "chord_height", "chord_height_relative", "max_edge", "min_edge"):
            for value in (math.nan, math.inf, -1.0, 0.0, 0, "25", [1], True, 1j):
                if name == "chord_height" and value == math.inf:
                    continue  # which says that there is no bound
                error = self.refused(name, repr(value)[:2], "must be", **{name: value})
                self.assertIsInstance(error, mq.InvalidInput)
        self.refused("min_angle", "35", "34 degrees", min_angle=35)
        self.refused("chord_height_relative", "at most 1", chord_height_relative=1.5)

    def test_none_is_no_bound_but_not_an_angle(self):
        self.refused("min_angle", "None", min_angle=None)
        mq.triangulate(Part.makeBox(1, 1, 1), chord_height=None, max_edge=None, max_triangles=None)

    def test_whole_numbers(self):
        for value in (0, -5, 2.5, "3"):
            self.refused("max_triangles", max_triangles=value)

    def test_options_that_exclude_each_other(self):
        self.refused("chord_height", "chord_height_relative",
                     chord_height=1.0, chord_height_relative=0.1)
        self.refused("min_edge", "max_edge", min_edge=2.0, max_edge=1.0)

    def test_methods(self):
        self.refused("method", "'foo'", "refine", method="foo")
        self.refused("connectivity", "'foo'", "parametric", connectivity="foo")
        self.refused("refine_samples", "True or False", refine_samples=1)
        self.refused("seed", "-1", "at least 0", seed=-1)
        with self.assertRaises(TypeError):
            mq.triangulate(Part.makeBox(1, 1, 1), min_angel=3)

    def test_insertion(self):
        self.refused("insertion", "'foo'", "off-centre, circumcentre", insertion="foo")
        self.refused("insertion", "None", insertion=None)
        self.refused("evaluation", "'own'", "fast, native", evaluation="own")
        shape = Part.makeTorus(10, 3)
        default, chosen, paper = (
            mq.triangulate(shape, **options) for options in
            ({}, {"insertion": "off-centre"}, {"insertion": "circumcentre"}))
        self.assertEqual(default.vertices.tobytes(), chosen.vertices.tobytes())
        self.assertNotEqual(default.vertices.tobytes(), paper.vertices.tobytes())
        self.assertGreaterEqual(paper.report.min_angle_unexempted, 25.0)
        one_by_one = mq.triangulate(shape, insertion="circumcentre", order="worst first")
        self.assertNotEqual(one_by_one.vertices.tobytes(), paper.vertices.tobytes())
        self.assertGreaterEqual(one_by_one.report.min_angle_unexempted, 25.0)
        self.refused("worst first", "insertion = circumcentre", order="worst first")
        self.refused("order", "'best'", "rounds, worst first", order="best")

    def test_numpy_numbers_and_quantities(self):
        for angle in (np.float32(20), np.int64(20), FreeCAD.Units.Quantity("20 deg")):
            mesh = mq.triangulate(Part.makeBox(1, 1, 1), min_angle=angle)
            self.assertEqual(mesh.report.min_angle_asked, 20.0)
        self.refused("min_angle", "20", min_angle=FreeCAD.Units.Quantity("20 mm"))


class CreasesInsideFaces(unittest.TestCase):
    def setUp(self):
        corners = [FreeCAD.Vector(x, y, 0) for x, y in ((0, 0), (4, 0), (4, 3), (0, 3), (0, 0))]
        spline = Part.BSplineCurve()
        spline.buildFromPolesMultsKnots(corners, [2, 1, 1, 1, 2], [0, 1, 2, 3, 4], False, 1)
        self.block = Part.Face(Part.Wire(spline.toShape())).extrude(FreeCAD.Vector(0, 0, 2))

    def test_they_are_followed_exactly_and_keep_the_faces_numbers(self):
        self.assertEqual(len(self.block.Faces), 3)
        for method in ("refine", "star", "sprinkle"):
            with self.subTest(method):
                mesh = mq.triangulate(self.block, method=method, chord_height=0.01, max_edge=0.5)
                self.assertTrue(mesh.report.closed and mesh.report.oriented and mesh.report.manifold)
                self.assertAlmostEqual(mesh.report.volume, 24.0, places=6)
                self.assertEqual(set(mesh.triangle_face.tolist()), {0, 1, 2})
                self.assertEqual(mesh.report.notes, [])

    def test_local_sizes_reach_all_pieces(self):
        mesh = mq.triangulate(self.block, local_sizes={"Face1": 0.4})
        corners = mesh.vertices[mesh.triangles[mesh.triangle_face == 0]]
        lengths = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
        self.assertLessEqual(lengths.max(), 0.4 + 1e-6)
        with self.assertRaisesRegex(mq.InvalidInput, "Face4, but the shape has 3 faces"):
            mq.triangulate(self.block, local_sizes={"Face4": 0.4})

    def test_curved_meshes_follow_them(self):
        report = mq.curve(self.block, order=3).report
        self.assertEqual(report.invalid, 0)
        self.assertLess(report.max_deviation, 1e-9)


class ProgressAndCancel(unittest.TestCase):
    LONG = {"min_angle": 30.0, "chord_height": 1e-5}

    def test_progress_rises_from_0_to_1(self):
        seen = []
        mq.triangulate(Part.makeTorus(10, 3), chord_height=0.01,
                       progress=lambda fraction, stage: seen.append((fraction, stage)))
        fractions = [fraction for fraction, _ in seen]
        self.assertEqual(fractions[0], 0.0)
        self.assertEqual(fractions[-1], 1.0)
        self.assertTrue(all(isinstance(stage, str) for _, stage in seen))
        self.assertEqual(fractions, sorted(fractions))

    def test_false_cancels_at_once(self):
        refused = []

        def progress(fraction, stage):
            if time.process_time() - start < 0.3:
                return None
            refused.append(time.process_time())
            return False

        start = time.process_time()  # CPU time: what else the machine does is no fault
        with self.assertRaises(mq.Cancelled):
            mq.triangulate(Part.makeTorus(10, 3), progress=progress, **self.LONG)
        self.assertEqual(len(refused), 1)
        self.assertLess(time.process_time() - refused[0], 1.0)

    def test_cancel_before_the_start(self):
        with self.assertRaises(mq.Cancelled):
            mq.triangulate(Part.makeBox(1, 1, 1), progress=lambda fraction, stage: False)

    def test_what_the_callback_raises_comes_out(self):
        def progress(fraction, stage):
            if fraction > 0.0:
                raise KeyError("mine")

        start = time.process_time()
        with self.assertRaisesRegex(KeyError, "mine"):
            mq.triangulate(Part.makeTorus(10, 3), progress=progress, **self.LONG)
        self.assertLess(time.process_time() - start, 20.0)

    def test_the_next_call_works_after_a_cancel(self):
        self.test_cancel_before_the_start()
        self.assertTrue(mq.triangulate(Part.makeBox(1, 1, 1)).report.closed)

    def test_progress_must_be_callable(self):
        with self.assertRaisesRegex(mq.InvalidInput, "progress"):
            mq.triangulate(Part.makeBox(1, 1, 1), progress=3)
