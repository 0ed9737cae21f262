# SPDX-License-Identifier: LGPL-2.1-or-later
"""mq.boolean: operations, contacts, operands of all kinds, faults, progress."""

import math
import os
import tempfile
import time
import unittest

import FreeCAD
import helpers
import Mesh
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.compat import extension
from MeshQuality.core.certify import verdict

Vector = FreeCAD.Vector


def box(x, y, z, size=(1.0, 1.0, 1.0)):
    """A Mesh.Mesh of a box whose lowest corner is (x, y, z)."""
    mesh = Mesh.createBox(*size)
    mesh.translate(x + size[0] / 2, y + size[1] / 2, z + size[2] / 2)
    return mesh


def placed(mesh, base, axis=Vector(0, 0, 1), angle=0.0):
    mesh = mesh.copy()
    mesh.Placement = FreeCAD.Placement(Vector(*base), FreeCAD.Rotation(axis, angle))
    return mesh


def without(mesh, facets):
    """A copy of a Mesh.Mesh that lacks some facets."""
    mesh = mesh.copy()
    mesh.removeFacets(facets)
    return mesh


class Threads(unittest.TestCase):
    """The option `threads`."""

    def test_the_result_is_the_same_for_any_number(self):
        first = Mesh.createSphere(1.0, 60)
        second = placed(first, (0.4, 0.3, 0.2), Vector(1, 1, 0), 30)
        results = [mq.boolean(first, second, "difference", threads=threads) for threads in (0, 1, 2, 5)]
        for result in results[1:]:
            self.assertEqual(result.vertices.tobytes(), results[0].vertices.tobytes())
            self.assertEqual(result.triangles.tobytes(), results[0].triangles.tobytes())

    def test_numbers_that_are_none_are_refused(self):
        for threads in (-1, 1025, 1.5, True, "all"):
            with self.assertRaisesRegex(mq.InvalidInput, "threads"):
                mq.boolean(box(0, 0, 0), box(0.5, 0.5, 0.5), "union", threads=threads)
            with self.assertRaisesRegex(mq.InvalidInput, "threads"):
                (mq.Solid(box(0, 0, 0)) | box(0.5, 0.5, 0.5)).evaluate(threads=threads)


class ManyBoxes(unittest.TestCase):
    """Boxes along the axes, whose faces lie in common planes: what there is most of in designs."""

    def test_a_row_of_boxes_that_overlap(self):
        count, step = 300, 0.5
        start = time.process_time()
        result = mq.boolean([box(step * k, 0, 0) for k in range(count)], operation="union")
        self.assertLess(time.process_time() - start, 20)  # it took the cube of their number: minutes
        self.assertAlmostEqual(result.report.volume, step * (count - 1) + 1.0, places=9)
        self.assertEqual(result.report.components, 1)

    def test_a_stack_of_turned_boxes(self):
        # Their tops and bottoms are in common planes, all edges of which cross.
        boxes = [placed(box(-0.5, -0.5, 0), (0.03 * k, 0, 0), angle=21.0 * k) for k in range(30)]
        joined = mq.boolean(boxes, operation="union").report
        common = mq.boolean(boxes, operation="intersection").report
        for report in (joined, common):
            self.assertTrue(report.closed and report.manifold)
            self.assertEqual(report.faults_left, 0)
        inner, outer = 0.25 * math.pi, 0.5 * math.pi
        self.assertLess(common.volume, inner)
        self.assertGreater(joined.volume, outer - 0.2)


class BooleanTest(unittest.TestCase):
    def solid(self, result, volume=None, relative=1e-6):
        """Checks the guarantees, and the volume.

        Of FreeCAD's own tests that of self-intersections is left out: it takes neighbours on a
        finely divided surface for crossing, which the exact test of the core does not.
        """
        report = result.report
        self.assertTrue(report.closed and report.oriented and report.manifold, str(report))
        self.assertEqual(report.faults_left, 0, str(report))
        faults = extension().verify(result._surface)
        self.assertFalse(any(faults.values()), faults)
        self.assertTrue(np.array_equal(result.vertices, result.vertices.astype(np.float32)))
        mesh = result.to_mesh()
        self.assertTrue(mesh.isSolid())
        for fault in ("hasNonManifolds", "hasInvalidNeighbourhood", "hasCorruptedFacets",
                      "hasNonUniformOrientedFacets"):
            self.assertFalse(getattr(mesh, fault)(), fault)
        if volume is not None:
            self.assertAlmostEqual(report.volume / volume, 1.0, delta=relative)
            self.assertAlmostEqual(mesh.Volume / volume, 1.0, delta=max(relative, 1e-5))
        return result


class Operations(BooleanTest):
    VOLUMES = {"union": 1.875, "intersection": 0.125, "difference": 0.875,
               "symmetric_difference": 1.75}

    def test_boxes_that_overlap_in_a_corner(self):
        a, b = box(0, 0, 0), box(0.5, 0.5, 0.5)
        for operation, volume in self.VOLUMES.items():
            with self.subTest(operation):
                self.solid(mq.boolean(a, b, operation), volume, 1e-4)

    def test_spheres_satisfy_inclusion_and_exclusion(self):
        a = Mesh.createSphere(1.0, 40)
        b = placed(a, (0.7, 0.2, 0.1))
        single = mq.quality(a).volume
        results = {name: self.solid(mq.boolean(a, b, name)) for name in self.VOLUMES}
        volumes = {name: result.report.volume for name, result in results.items()}
        self.assertAlmostEqual(volumes["union"] + volumes["intersection"], 2 * single, places=5)
        self.assertAlmostEqual(volumes["difference"] + volumes["intersection"], single, places=5)
        self.assertAlmostEqual(volumes["symmetric_difference"],
                               volumes["union"] - volumes["intersection"], places=3)

    def test_linked_tori_stay_apart(self):
        a = Mesh.createTorus(5.0, 1.0, 30)
        b = placed(a, (5, 0, 0), Vector(1, 0, 0), 90)
        result = self.solid(mq.boolean(a, b, "union"), 2 * mq.quality(a).volume)
        self.assertEqual(result.report.components, 2)
        self.assertEqual(result.report.retained, a.CountFacets + b.CountFacets)
        self.assertEqual(result.report.error_bound, 0.0)

    def test_a_cavity(self):
        result = self.solid(mq.boolean(box(0, 0, 0, (4, 4, 4)), box(1, 1, 1), "difference"), 63.0)
        self.assertEqual(result.report.components, 2)

    def test_any_number_of_operands_in_one_pass(self):
        ball = Mesh.createSphere(1.0, 24)
        row = [placed(ball, (1.5 * k, 0.1 * k, 0.05 * k)) for k in range(6)]
        pairwise = row[0]
        for other in row[1:]:
            pairwise = mq.boolean(pairwise, other, "union")
        together = self.solid(mq.boolean(row, operation="union"), pairwise.report.volume, 1e-4)
        self.assertEqual(set(together.triangle_source[:, 0].tolist()) - {-1}, set(range(6)))
        plate = box(0, 0, 0, (10, 10, 1))
        pins = [box(1 + 2 * k, 1 + 2 * k, -1, (1, 1, 3)) for k in range(4)]
        self.solid(mq.boolean([plate, *pins], operation="difference"), 96.0)

    def test_nothing_left_is_an_empty_mesh_and_said(self):
        a = Mesh.createSphere(1.0, 20)
        for result in (mq.boolean(a, a, "difference"),
                       mq.boolean(a, placed(a, (9, 0, 0)), "intersection")):
            self.assertEqual(len(result.triangles), 0)
            self.assertEqual(result.report.faults_left, 0)
            self.assertTrue(any("empty" in note for note in result.report.notes))
            self.assertEqual(result.to_mesh().CountFacets, 0)

    def test_a_mesh_with_itself_is_that_mesh(self):
        a = Mesh.createSphere(1.0, 20)
        for operation in ("union", "intersection"):
            result = self.solid(mq.boolean(a, a, operation), mq.quality(a).volume)
            self.assertEqual(result.report.retained, a.CountFacets)


class Solids(BooleanTest):
    def test_operators_are_the_operations(self):
        a, b = box(0, 0, 0), box(0.5, 0.5, 0.5)
        first, second = mq.Solid(a), mq.Solid(b)
        for solid, operation in ((first | second, "union"), (first & b, "intersection"), (first - second, "difference"),
                                 (first ^ b, "symmetric_difference")):
            with self.subTest(operation):
                found = self.solid(solid.evaluate(), Operations.VOLUMES[operation], 1e-4)
                expected = mq.boolean(a, b, operation)
                self.assertEqual(found.triangles.shape, expected.triangles.shape)
        self.assertEqual(repr(first | second), "<Solid: 2 sources, 1 operation>")

    def test_sequences_are_rounded_once(self):
        ball, cube = Mesh.createSphere(10.0, 40), box(0, 0, 0, (12, 12, 12))
        a, b = mq.Solid(ball), mq.Solid(cube)
        both = self.solid(((a - b) | (a & b)).evaluate(), mq.quality(ball).volume, 1e-5)
        self.assertLess(both.report.error_bound, 1e-5)
        # Nothing was rounded inside of the surface, which the cube's is: all corners lie on the ball's facets.
        depth = 10.0 - np.linalg.norm(both.vertices, axis=1)
        self.assertLess(depth.max(), 10.0 * (1.0 - math.cos(math.pi / 40)) * 2.0)

    def test_a_carved_block_has_the_volume_of_one_cut_after_the_other(self):
        ball = Mesh.createSphere(1.0, 16)
        block = box(0, 0, 0, (12, 8, 3))
        solid, cut = mq.Solid(block), block
        for k in range(12):
            tool = placed(ball, (0.9 * k + 0.5, 0.6 * k + 0.3, 2.9 + 0.013 * k))
            solid, cut = solid - tool, mq.boolean(cut, tool, "difference")
        carved = self.solid(solid.evaluate(), cut.report.volume, 1e-4)
        self.assertEqual(set(carved.triangle_source[:, 0].tolist()) - {-1}, set(range(13)))

    def test_long_sequences_and_what_is_none(self):
        row = mq.Solid(box(0, 0, 0))
        for k in range(1, 1200):  # deeper than Python's limit of recursion
            row = row | box(1.5 * k, 0, 0)
        self.assertAlmostEqual(row.evaluate().report.volume, 1200.0, places=2)
        doubled = mq.Solid(box(0, 0, 0))
        for _ in range(40):
            doubled = doubled | doubled
        with self.assertRaisesRegex(mq.InvalidInput, "more than 2,000,000 operands and operations"):
            doubled.evaluate()
        with self.assertRaisesRegex(mq.InvalidInput, "a Solid already"):
            mq.Solid(row)
        with self.assertRaisesRegex(mq.InvalidInput, "operand B"):
            (mq.Solid(box(0, 0, 0)) - 7).evaluate()
        with self.assertRaises(mq.InvalidInput):
            row.evaluate(tolerance=-1.0)


class Result(BooleanTest):
    def test_retained_triangles_are_the_operands_bit_for_bit(self):
        operands = [Mesh.createSphere(1.0, 30), Mesh.createSphere(1.0, 30)]
        operands[1].translate(1, 0.25, 0)
        corners = []
        for operand in operands:
            points, facets = helpers.points_and_facets(operand)
            corners.append(points[facets])
        result = self.solid(mq.boolean(*operands, "difference"))
        self.assertEqual(result.triangle_source.dtype, np.int32)
        self.assertEqual(result.triangle_source.shape, (len(result.triangles), 2))
        own = result.triangle_source[:, 0] >= 0
        self.assertEqual(own.sum(), result.report.retained)
        self.assertEqual((~own).sum(), result.report.reconstructed)
        self.assertTrue((result.triangle_source[~own] == -1).all())
        for triangle in np.flatnonzero(own):
            operand, source = result.triangle_source[triangle]
            mine = {tuple(p) for p in result.vertices[result.triangles[triangle]]}
            theirs = {tuple(p) for p in corners[operand][source]}
            self.assertEqual(mine, theirs)

    def test_it_is_a_surface_mesh_and_an_operand(self):
        result = mq.boolean(box(0, 0, 0), box(0.5, 0.5, 0.5), "difference")
        self.assertIsInstance(result, mq.SurfaceMesh)
        self.assertIsInstance(result, mq.BooleanMesh)
        self.assertIsInstance(result.report, mq.MeshReport)
        points, facets = helpers.points_and_facets(result.to_mesh())
        self.assertTrue(np.array_equal(points, result.vertices))
        self.assertTrue(np.array_equal(facets, result.triangles))
        self.assertEqual(mq.quality(result).volume, result.report.volume)
        again = mq.boolean(result, box(0.5, 0.5, 0.5), "union")
        self.solid(again, 1.875, 1e-4)

    def test_report(self):
        report = mq.boolean(Mesh.createSphere(1.0, 30), box(0, 0, 0), "union").report
        self.assertGreater(report.retained, 0)
        self.assertGreater(report.reconstructed, 0)
        self.assertLess(report.error_bound, math.sqrt(3) * 2.0 / 512)
        self.assertEqual(report.repaired, [])
        self.assertTrue(all(isinstance(s, float) for s in report.seconds.values()))
        self.assertGreater(report.cpu_seconds, 0.0)
        text = str(report)
        for words in ("retained", "mm; requested at most", "closed       yes", "volume"):
            self.assertIn(words, text)

    def test_every_format(self):
        result = mq.boolean(box(0, 0, 0), box(0.5, 0.5, 0.5), "union")
        with tempfile.TemporaryDirectory() as folder:
            for suffix in ("stl", "ply", "obj", "off", "msh", "vtu"):
                path = os.path.join(folder, "result." + suffix)
                result.write(path)
                if suffix not in ("msh", "vtu"):
                    self.assertEqual(Mesh.Mesh(path).CountFacets, len(result.triangles))

    def test_same_input_same_bytes(self):
        a, b = Mesh.createSphere(1.0, 50), placed(Mesh.createSphere(1.0, 50), (0.5, 0.1, 0))
        first, second = (mq.boolean(a, b, "union") for _ in range(2))
        self.assertEqual(first.vertices.tobytes(), second.vertices.tobytes())
        self.assertEqual(first.triangles.tobytes(), second.triangles.tobytes())
        self.assertEqual(first.triangle_source.tobytes(), second.triangle_source.tobytes())


class Contacts(BooleanTest):
    """Boxes that touch, as they stand and turned so that no coordinate is a round number."""

    def each(self, *boxes):
        yield boxes
        yield tuple(placed(b, (0, 0, 0), Vector(1, 2, 3), 31.7) for b in boxes)

    def test_a_shared_face(self):
        for a, b in self.each(box(0, 0, 0), box(1, 0, 0)):
            result = self.solid(mq.boolean(a, b, "union"), 2.0, 1e-3)
            self.assertEqual(result.report.components, 1)

    def test_a_part_of_a_face(self):
        for a, b in self.each(box(0, 0, 0), box(1, 0.25, 0.25, (1, 0.5, 0.5))):
            self.solid(mq.boolean(a, b, "union"), 1.25, 1e-3)

    def test_a_flush_hole(self):
        straight, turned = self.each(box(0, 0, 0), box(0.25, 0.25, 0, (0.5, 0.5, 1)))
        result = self.solid(mq.boolean(*straight, "difference"), 0.75, 1e-3)
        self.assertEqual(result.report.euler, 0)
        # Rounded coordinates of the turned boxes are flush no more: a skin may stay over the hole.
        self.solid(mq.boolean(*turned, "difference"), 0.75, 1e-3)

    def test_a_shared_edge(self):
        for a, b in self.each(box(0, 0, 0), box(1, 1, 0)):
            self.solid(mq.boolean(a, b, "union"), 2.0, 1e-3)

    def test_a_shared_vertex(self):
        for a, b in self.each(box(0, 0, 0), box(1, 1, 1)):
            self.solid(mq.boolean(a, b, "union"), 2.0, 1e-3)

    def test_nearly_coincident_spheres(self):
        a = Mesh.createSphere(1.0, 40)
        b = placed(a, (0, 0, 0), Vector(0, 0, 1), 0.35)
        result = self.solid(mq.boolean(a, b, "union", tolerance=0.01))
        self.assertLessEqual(result.report.error_bound, 0.01)
        self.assertAlmostEqual(result.report.volume, mq.quality(a).volume, delta=0.05)


class Unsound(unittest.TestCase):
    """What is not a closed manifold never passes for sound: faults_left counts it."""

    def checkers(self, turn, base):
        """Every other cube of a chessboard of 3 x 3 x 3, which touch in edges and corners."""
        box = mq.triangulate(Part.makeBox(1, 1, 1))
        places = [(i, j, k) for i in range(3) for j in range(3) for k in range(3) if (i + j + k) % 2 == 0]
        points = np.vstack([box.vertices + place for place in places])
        triangles = np.vstack([box.triangles + len(box.vertices) * i for i in range(len(places))])
        points, index = np.unique(points, axis=0, return_inverse=True)
        matrix = np.array(FreeCAD.Placement(Vector(*base), turn).toMatrix().A).reshape(4, 4)
        moved = points @ matrix[:3, :3].T + matrix[:3, 3]
        return moved.astype(np.float32).astype(float), index.ravel()[triangles]

    def test_faults_are_counted(self):
        for seed in (21, 23, 55, 1, 2, 3):
            dice = np.random.default_rng(seed)
            turn, base = FreeCAD.Rotation(*dice.uniform(0, 360, 3)), dice.uniform(0, 1, 3)
            for operation in ("union", "difference"):
                report = mq.boolean(self.checkers(FreeCAD.Rotation(), (0, 0, 0)), self.checkers(turn, base), operation,
                                    tolerance=1e-4).report
                sound = report.closed and report.manifold and report.oriented
                self.assertEqual(report.faults_left == 0, sound, (seed, operation, report.faults_left))


class DirtyOperands(BooleanTest):
    def test_a_hole_is_closed_and_reported(self):
        sphere = Mesh.createSphere(1.0, 40)
        result = self.solid(mq.boolean(without(sphere, [100, 101, 900]), box(0, 0, 0), "union"))
        whole = mq.boolean(sphere, box(0, 0, 0), "union")
        self.assertAlmostEqual(result.report.volume, whole.report.volume, delta=1e-3)
        self.assertEqual(len(result.report.repaired), 1)
        self.assertRegex(result.report.repaired[0], "operand A: .*holes? closed")
        self.assertIn("repaired", str(result.report))

    def test_flipped_and_duplicate_triangles(self):
        points, facets = helpers.points_and_facets(Mesh.createSphere(1.0, 20))
        facets[7] = facets[7][::-1]
        facets = np.vstack([facets, facets[30:31]])
        result = self.solid(mq.boolean(box(0, 0, 0), (points, facets), "union"))
        self.assertRegex(result.report.repaired[0], "operand B: ")

    def test_an_operand_that_intersects_itself(self):
        both = box(0, 0, 0)
        both.addMesh(box(0.5, 0.5, 0.5))
        self.solid(mq.boolean(both, box(9, 9, 9), "union"), 2.875, 1e-4)

    def test_an_open_sheet_is_refused(self):
        sheet = Mesh.createPlane(5, 5)
        with self.assertRaisesRegex(mq.InvalidInput, "operand B.*open.*close it"):
            mq.boolean(box(0, 0, 0), sheet, "union")
        with self.assertRaisesRegex(mq.InvalidInput, "operand A bounds no volume.*close it"):
            mq.boolean(sheet, box(0, 0, 0), "union", method="uniform")

    def test_what_is_no_operand(self):
        good = box(0, 0, 0)
        for bad in (None, 5, "mesh", (1, 2, 3), Mesh.Mesh(), Part.Shape(),
                    Part.makeLine((0, 0, 0), (1, 0, 0)), ([(0, 0, 0)], [(0, 1, 2)])):
            with self.subTest(bad), self.assertRaises(mq.InvalidInput):
                mq.boolean(good, bad, "union")
        with self.assertRaisesRegex(mq.InvalidInput, "operand B.*vertex 0.*finite"):
            points, facets = helpers.points_and_facets(good)
            points[0, 0] = math.nan
            mq.boolean(good, (points, facets), "union")


class Operands(BooleanTest):
    def test_all_kinds_of_meshes_give_the_same_bytes(self):
        a, b = Mesh.createSphere(1.0, 30), box(0, 0, 0)
        expected = mq.boolean(a, b, "difference")
        points, facets = helpers.points_and_facets(a)
        surface = mq.boolean([a], operation="union")
        self.assertEqual(surface.report.retained, a.CountFacets)
        for operand in ((points, facets), [points.tolist(), facets.tolist()],
                        (surface.vertices, surface.triangles), surface):
            result = mq.boolean(operand, b, "difference")
            self.assertAlmostEqual(result.report.volume, expected.report.volume, places=9)
            self.assertEqual(len(result.triangles), len(expected.triangles))

    def test_placements(self):
        a = box(0, 0, 0, (1, 2, 3))
        turned = placed(a, (10, 0, 0), Vector(0, 0, 1), 90)  # covers 8..10 x 0..1 x 0..3
        self.solid(mq.boolean(turned, box(8.5, 0.5, 1), "intersection"), 0.5, 1e-5)

    def test_far_from_the_origin_nothing_is_lost(self):
        a = placed(box(0, 0, 0), (1e6, 0, 0))
        b = placed(box(0, 0, 0), (1e6 + 0.5, 0.5, 0.5))
        result = self.solid(mq.boolean(a, b, "union"), 1.875, 1e-4)
        self.assertTrue(result.origin.any())
        self.assertAlmostEqual(result.to_mesh().BoundBox.XMax, 1e6 + 1.5, delta=0.2)

    def test_arrays_of_more_digits_keep_them_and_the_report_says_so(self):
        points, facets = helpers.points_and_facets(box(0, 0, 0))
        third = (points / 3.0, facets)
        result = mq.boolean(third, box(9, 9, 9), "union")
        self.assertTrue({tuple(p) for p in third[0]} <= {tuple(p) for p in result.vertices})
        self.assertTrue(any("digits" in note for note in result.report.notes))

    def test_shapes_are_meshed_within_half_the_tolerance(self):
        cube, ball = Part.makeBox(2, 2, 2), Part.makeSphere(1.2)
        result = self.solid(mq.boolean(cube, ball, "difference", tolerance=0.004))
        self.assertAlmostEqual(result.report.volume, cube.cut(ball).Volume, delta=0.004)
        notes = [note for note in result.report.notes if "is a shape" in note]
        self.assertEqual(len(notes), 2)
        self.assertIn("meshing shapes", result.report.seconds)
        coarse = mq.boolean(cube, ball, "difference", tolerance=0.1)
        self.assertLess(coarse.report.triangles, result.report.triangles)

    def test_what_is_made_on_shapes_lies_on_their_surfaces(self):
        cube, ball = Part.makeBox(2, 2, 2), Part.makeSphere(1.2)
        result = self.solid(mq.boolean(cube, ball, "difference", tolerance=0.02))
        self.assertGreater(result.report.fitted_vertices, 20)
        self.assertIn("vertices put there", str(result.report))
        on_cube = np.abs(result.vertices).min(axis=1) < 1e-5
        from_ball = np.abs(np.linalg.norm(result.vertices, axis=1) - 1.2)
        curve = on_cube & (from_ball < 0.02)
        self.assertGreaterEqual(curve.sum(), result.report.fitted_vertices)
        if result.report.unfitted_vertices == 0:
            self.assertLess(from_ball[curve].max(), 1e-5)
        self.assertLessEqual(result.report.error_bound, 0.02)

    def test_a_shape_with_a_mesh(self):
        result = mq.boolean(Part.makeCylinder(1, 4), box(-2, -2, 1, (4, 4, 1)), "union",
                            tolerance=0.002)
        self.solid(result, 16 + 3 * math.pi, 1e-3)

    def test_open_shapes_are_refused(self):
        with self.assertRaisesRegex(mq.InvalidInput, "operand B.*open"):
            mq.boolean(Part.makeBox(1, 1, 1), Part.makePlane(3, 3), "union")


class DocumentOperands(helpers.DocumentTest):
    def volume(self, *sources):
        return mq.boolean(list(sources), operation="intersection", tolerance=0.01).report.volume

    def feature(self, mesh, base=(0, 0, 0)):
        obj = self.document.addObject("Mesh::Feature", "Mesh")
        obj.Mesh = mesh
        obj.Placement.Base = Vector(*base)
        return obj

    def test_meshes_shapes_and_links_where_the_document_has_them(self):
        part = self.box(Length=2, Width=2, Height=2)
        part.Placement.Base = Vector(0, 0, 100)
        self.document.recompute()
        mesh = self.feature(box(0, 0, 0), (1.5, 1.5, 101))
        self.assertAlmostEqual(self.volume(part, mesh), 0.25, places=4)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = mesh
        link.Placement.Base = Vector(1.5, 0, 101)
        self.document.recompute()
        self.assertAlmostEqual(self.volume(part, link), 0.5, places=4)
        other = self.document.addObject("App::Link", "Other")
        other.LinkedObject = part
        other.Placement.Base = Vector(0, 0, 101)
        self.document.recompute()
        self.assertAlmostEqual(self.volume(part, other), 4.0, places=4)

    def test_errors_name_the_object(self):
        sheet = self.feature(Mesh.createPlane(5, 5))
        sheet.Label = "my sheet"
        with self.assertRaisesRegex(mq.InvalidInput, "^'my sheet' is an open surface"):
            mq.boolean(self.box(), sheet, "union")
        new = self.document.addObject("Part::Cylinder", "Cylinder")
        with self.assertRaisesRegex(mq.InvalidInput, "^'Cylinder' is null: [^()]*$"):
            mq.boolean(new, sheet, "union")

    def test_errors_name_the_arrays(self):
        cube = mq.triangulate(Part.makeBox(1, 1, 1))
        vertices, triangles = np.array(cube.vertices), np.array(cube.triangles)
        for wrong, said in (((vertices * np.nan, triangles), "vertex 0 has a coordinate that is not"),
                            ((vertices, triangles + 90), "triangle 0 names vertex 90"),
                            ((vertices.astype(complex), triangles), "vertices must be numbers")):
            for method in ("default", "uniform"):
                with self.assertRaisesRegex(mq.InvalidInput, f"^operand A: {said}"):
                    mq.boolean(wrong, cube, "union", method=method)
                with self.assertRaisesRegex(mq.InvalidInput, f"^operand B: {said}"):
                    mq.boolean(cube, wrong, "union", method=method)


class Options(BooleanTest):
    def refused(self, *words, **options):
        values = {"operation": "union", **options}
        with self.assertRaises(mq.InvalidInput) as caught:
            mq.boolean(box(0, 0, 0), box(0.5, 0.5, 0.5), **values)
        for word in words:
            self.assertIn(word, str(caught.exception))

    def test_out_of_range(self):
        self.refused("operation", "'cut'", "difference", operation="cut")
        self.refused("operation", "None", operation=None)
        self.refused("method", "'paper'", "uniform", method="paper")
        for value in (0, -1.0, math.nan, math.inf, "1", True):
            self.refused("tolerance", "must be", tolerance=value)
        for value in (7, 2.5, "512", 10**6):
            self.refused("resolution", "must be", resolution=value)
        self.refused("tolerance", "single precision", tolerance=1e-9)
        self.refused("progress", progress=3)

    def test_operands_that_are_missing(self):
        a = box(0, 0, 0)
        with self.assertRaisesRegex(mq.InvalidInput, "second operand"):
            mq.boolean(a, operation="union")
        with self.assertRaisesRegex(mq.InvalidInput, "operation='union'"):
            mq.boolean([a, a], "union")
        with self.assertRaisesRegex(mq.InvalidInput, "empty"):
            mq.boolean([], operation="union")

    def test_uniform(self):
        a, b = Mesh.createSphere(1.0, 30), placed(Mesh.createSphere(1.0, 30), (0.8, 0.1, 0.2))
        exact = mq.boolean(a, b, "union").report.volume
        result = mq.boolean(a, b, "union", method="uniform", resolution=65)
        self.assertTrue(result.report.closed and result.report.oriented)
        self.assertAlmostEqual(result.report.volume / exact, 1.0, delta=0.01)
        self.assertGreater(result.report.retained, 0)
        finer = mq.boolean(a, b, "union", method="uniform", tolerance=0.05)
        self.assertLessEqual(finer.report.error_bound, 0.05)
        self.assertEqual(verdict.of_boolean(result), [])
        for report in (result.report, finer.report):
            self.assertLessEqual(report.error_bound, report.tolerance_asked)
        self.assertEqual(finer.report.tolerance_asked, 0.05)
        # The bound of 64 cells, 3.2 of which are free.
        self.assertAlmostEqual(result.report.tolerance_asked, 3**0.5 * 2.8 / (64 - 3.2), places=2)
        for resolution in (64, 65, 100, 128, 129):
            report = mq.boolean(a, b, "union", method="uniform", resolution=resolution).report
            self.assertGreater(report.error_bound, 0.0)
            self.assertLessEqual(report.error_bound, report.tolerance_asked)
        size = 2.8
        for cells in (64, 128):  # what would need exactly so many cells without the free ones
            tolerance = 3**0.5 * size / cells
            report = mq.boolean(a, b, "union", method="uniform", tolerance=tolerance).report
            self.assertGreater(report.error_bound, 0.0)
            self.assertLessEqual(report.error_bound, tolerance)
        with self.assertRaisesRegex(mq.InvalidInput, "uniform' reaches .* mm with the most rays"):
            mq.boolean(a, b, "union", method="uniform", tolerance=1e-4)
        self.assertAlmostEqual(mq.boolean([a, b, a], operation="union", method="uniform").report.volume,
                               mq.boolean(a, b, "union", method="uniform").report.volume, places=3)


class ProgressAndCancel(BooleanTest):
    def operands(self):
        a = Mesh.createSphere(1.0, 300)
        return a, placed(a, (0.01, 0.003, 0.002))

    def test_progress_rises_from_0_to_1(self):
        seen = []
        mq.boolean(Part.makeSphere(1.0), Mesh.createSphere(1.0, 60), "union",
                   progress=lambda fraction, stage: seen.append((fraction, stage)))
        fractions = [fraction for fraction, _ in seen]
        self.assertEqual((fractions[0], fractions[-1]), (0.0, 1.0))
        self.assertEqual(fractions, sorted(fractions))
        self.assertTrue(all(isinstance(stage, str) for _, stage in seen))

    def test_false_cancels_at_once(self):
        a, b = self.operands()
        asked = []

        def progress(fraction, stage):
            if fraction < 0.05:
                return None
            asked.append(time.process_time())  # CPU time: what else the machine does is no fault
            return False

        with self.assertRaises(mq.Cancelled):
            mq.boolean(a, b, "union", progress=progress)
        self.assertEqual(len(asked), 1)
        self.assertLess(time.process_time() - asked[0], 1.0)

    def test_what_the_callback_raises_comes_out(self):
        def progress(fraction, stage):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            mq.boolean(box(0, 0, 0), box(0.5, 0, 0), "union", progress=progress)
