# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies in bodies: what overlaps, lies in another body, is there twice or crosses in the mesh is named and not met."""

import json
import os
import subprocess
import tempfile
import unittest

import FreeCAD
import helpers
import Part

import MeshQuality as mq
from MeshQuality.core.certify import verdict

COMMAND = os.path.join(helpers.ROOT, "bin", "meshquality")
V = FreeCAD.Vector


def together(*bodies):
    return Part.makeCompound(list(bodies))


def box(size=10, at=(0, 0, 0)):
    return Part.makeBox(size, size, size, V(*at))


def block():
    """A block with a bore of radius 10."""
    return Part.makeBox(40, 40, 20, V(-20, -20, 0)).cut(Part.makeCylinder(10, 20))


def shaft(radius):
    return Part.makeCylinder(radius, 30, V(0, 0, -5))


def ball_in_ball():
    """A ball of radius 10 in a hollow one, with a gap of 0.05."""
    return together(Part.makeSphere(12.05).cut(Part.makeSphere(10.05)), Part.makeSphere(10))


NESTED = together(box(20, (-10, -10, -10)), Part.makeSphere(6))


class Overlaps(unittest.TestCase):
    def test_bodies_that_are_not_apart_are_named(self):
        for shape, found in (
                (NESTED, ("Solid2", "Solid1", "inside")),
                (together(box(), box().copy()), ("Solid1", "Solid2", "equal")),
                (together(Part.makeCylinder(5, 10), Part.makeCylinder(5, 10)), ("Solid1", "Solid2", "equal")),
                (together(box(), box(10, (5, 4, 3))), ("Solid1", "Solid2", "overlapping")),
                (together(box(), box(10, (5, 0, 0))), ("Solid1", "Solid2", "overlapping")),
                (together(box(20), box(5, (3, 3, 0))), ("Solid1", "Solid2", "overlapping")),
                (together(Part.makeCylinder(10, 30), Part.makeCylinder(10, 20, V(0, 0, 5))), ("Solid1", "Solid2", "overlapping")),
                (together(block(), shaft(10.005)), ("Solid1", "Solid2", "overlapping"))):
            for imprint in (False, True):
                mesh = mq.triangulate(shape, chord_height=0.02, imprint=imprint)
                self.assertEqual(mesh.report.overlapping_bodies, [found])
                finding, = verdict.of_triangulation(mesh, True, {"overlap": "refuse"}, shape)
                self.assertIn(found[0], finding.text)
                self.assertEqual(verdict.of_triangulation(mesh, True, {"overlap": "allow"}, shape), [])

    def test_bodies_that_touch_or_are_apart_are_not(self):
        hollow = Part.makeSphere(10).cut(Part.makeSphere(8))
        for shape in (together(box(), box(10, (10, 4, 3))), together(box(), box(10, (10, 10, 10))),
                      together(hollow, Part.makeSphere(5)), together(hollow, Part.makeSphere(8)),
                      together(block(), shaft(10)), together(Part.makeBox(10, 10, 2).cut(Part.makeCylinder(3, 2, V(5, 5, 0))),
                                                             Part.makeCylinder(3, 2, V(5, 5, 0)))):
            mesh = mq.triangulate(shape, chord_height=0.05)
            self.assertEqual((mesh.report.overlapping_bodies, mesh.report.overlaps), ([], 0), mesh.report.notes)
            self.assertEqual(verdict.of_triangulation(mesh, True, {}, shape), [])

    def test_volume_meshes(self):
        curved = mq.curve(NESTED, volume=True, imprint=True)
        finding, = verdict.of_curved(curved, True)
        self.assertEqual(finding.text, "1 pair of bodies overlaps. Solid2 lies inside Solid1.")

    def test_files_of_flows_are_refused(self):
        mesh = mq.triangulate(together(box(), box(10, (5, 4, 3))))
        allowed = mq.triangulate(together(box(), box(10, (5, 4, 3))), overlap="allow")
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(mq.InvalidInput, "Solid1 and Solid2 overlap"):
                mq.write_openfoam_case(mesh, folder, flow="external")
            self.assertTrue(mq.write_openfoam_case(allowed, folder, flow="external"))

    def test_objects(self):
        document = FreeCAD.newDocument()
        try:
            source = document.addObject("Part::Feature", "Both")
            source.Shape = NESTED
            for add in (mq.add_quality_mesh, mq.add_curved_mesh, mq.add_fem_mesh):
                refused, allowed = add(source), add(source, overlap="allow")
                self.assertIn("Solid2 lies inside Solid1", refused.Certificate)
                self.assertEqual(allowed.Certificate, "met", add)
        finally:
            FreeCAD.closeDocument(document.Name)

    def test_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "both.brep")
            NESTED.exportBrep(path)
            for words, status in (([], 3), (["--overlap", "allow"], 0)):
                done = subprocess.run([COMMAND, "triangulate", path, "--strict", "--json", *words], capture_output=True,
                                      text=True, timeout=120, stdin=subprocess.DEVNULL)
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertEqual(json.loads(done.stdout)["overlapping_bodies"], [["Solid2", "Solid1", "inside"]])


class Gaps(unittest.TestCase):
    """Bodies with a gap less than the deviation of their meshes."""

    def test_triangles_are_split_until_clear(self):
        for shape in (together(block(), shaft(9.99)), together(block(), Part.makeCylinder(9.99, 30, V(0.003, 0, -5)))):
            mesh = mq.triangulate(shape, chord_height=0.02)
            self.assertEqual((mesh.report.overlapping_bodies, mesh.report.overlaps), ([], 0))
            both = mq.boolean([mesh.of_solid(0), mesh.of_solid(1)], operation="intersection", tolerance=1e-4)
            self.assertEqual(len(both.triangles), 0)

    def test_what_cannot_be_cleared_is_not_met(self):
        mesh = mq.triangulate(together(block(), shaft(9.9995)), chord_height=0.02)
        self.assertEqual(mesh.report.overlapping_bodies, [("Solid1", "Solid2", "near")])
        self.assertGreater(mesh.report.overlaps, 1000)
        finding, = verdict.of_triangulation(mesh, True)
        self.assertEqual(finding.text, "1 pair of bodies crosses in the mesh only. "
                                       "Solid1 and Solid2 cross: a smaller max. deviation separates them.")

    def test_curved_elements_that_cross_are_not_met(self):
        curved = mq.curve(ball_in_ball(), order=1, chord_height=0.5, min_angle=20)
        crossing = curved.report.curved_intersections
        self.assertEqual(bool(verdict.of_curved(curved, True)), crossing > 0)
        for order in (1, 2):
            crossing = mq.curve(together(block(), shaft(9.9995)), order=order, chord_height=0.5)
            self.assertGreater(crossing.report.curved_intersections, 0)
            self.assertEqual(crossing.report.curved_overlaps, crossing.report.curved_intersections)
            texts = [finding.text for finding in verdict.of_curved(crossing, True)]
            self.assertTrue(any("pairs of triangles cross" in text for text in texts), texts)
            self.assertEqual(verdict.of_curved(crossing, True, {"overlap": "allow"}), [])

    def test_a_solid_that_touches_itself_along_an_edge(self):
        """Two edges lie on each other there, each between two faces: triangles have vertices in common there."""
        outline = Part.makePolygon([V(*at) for at in ((0, 0), (5, 5), (10, 0), (10, 10), (5, 5), (0, 10), (0, 0))])
        solid = Part.Face(outline).extrude(V(0, 0, 4))
        self.assertEqual((solid.isValid(), len(solid.Edges)), (True, 18))
        mesh = mq.triangulate(solid, chord_height=0.1)
        self.assertEqual(mesh.report.self_intersections, 0)
        self.assertTrue(mesh.report.closed and mesh.report.manifold, mesh.report)
        self.assertAlmostEqual(mesh.report.volume, 200.0, places=6)
        notes = [str(note) for note in mesh.report.notes]
        self.assertTrue(any("where the solid touches itself" in note for note in notes), notes)


if __name__ == "__main__":
    unittest.main()
