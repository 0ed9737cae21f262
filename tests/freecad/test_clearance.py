# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clearance: known distances of bodies, how they stand to each other, the command line."""

import json
import os
import subprocess
import tempfile
import time
import unittest

import FreeCAD
import helpers
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.core.certify import verdict

COMMAND = os.path.join(helpers.ROOT, "bin", "meshquality")
V = FreeCAD.Vector


def pair_of(*bodies, **values):
    found = mq.clearance(list(bodies), **values)
    return found.pairs[0]


class KnownDistances(unittest.TestCase):
    def test_of_elementary_faces_are_exact(self):
        box = Part.makeBox(10, 10, 10)
        for other, distance, faces in (
                (Part.makeBox(5, 5, 5, V(12, 2, 2)), 2.0, ("Face2", "Face1")),
                (Part.makeCylinder(3, 20, V(16, 5, -5)), 3.0, ("Face2", "Face1")),
                (Part.makeSphere(4, V(5, 5, 14.37)), 0.37, ("Face6", "Face1"))):
            pair = pair_of(box, other)
            self.assertEqual((pair.relation, pair.method, pair.faces), ("apart", "OpenCASCADE", faces))
            self.assertAlmostEqual(pair.distance, distance, delta=1e-6)
            self.assertEqual((pair.lower, pair.upper), (pair.distance, pair.distance))
            self.assertAlmostEqual(np.linalg.norm(pair.points[0] - pair.points[1]), distance, delta=1e-6)

    def test_of_a_shaft_in_its_bore(self):
        bore = Part.makeBox(40, 40, 20, V(-20, -20, 0)).cut(Part.makeCylinder(10, 20))
        pair = pair_of(bore, Part.makeCylinder(9.9, 30, V(0.03, 0, -5)))
        self.assertEqual(pair.relation, "apart")
        self.assertLessEqual(pair.lower, 0.07 + 1e-9)
        self.assertGreaterEqual(pair.upper, 0.07 - 1e-9)
        exact = pair_of(bore, Part.makeCylinder(9.9, 30, V(0.03, 0, -5)), tolerance=0.002)
        self.assertAlmostEqual(exact.distance, 0.07, delta=0.005)

    def test_of_curved_faces_are_within_bounds(self):
        ellipsoid = Part.makeSphere(5)
        stretch = FreeCAD.Matrix()
        stretch.scale(1, 1, 2)
        ellipsoid = ellipsoid.transformGeometry(stretch)
        pair = pair_of(ellipsoid, Part.makeBox(10, 10, 10, V(-5, -5, 10.5)))
        self.assertEqual(pair.method, "mesh")
        self.assertLessEqual(pair.lower, 0.5)
        self.assertGreaterEqual(pair.upper, 0.5)
        self.assertLess(pair.upper - pair.lower, 0.1)

    def test_of_meshes(self):
        first, second = mq.triangulate(Part.makeBox(4, 4, 4)), mq.triangulate(Part.makeBox(4, 4, 4, V(5, 6, 1)))
        pair = pair_of(first, (second.vertices, second.triangles))
        self.assertEqual(pair.method, "mesh")
        self.assertAlmostEqual(pair.distance, 5**0.5, delta=1e-6)
        arrays = [(mesh.vertices, mesh.triangles) for mesh in (first, second)]
        self.assertEqual(pair_of(*arrays).distance, pair.distance)


class Relations(unittest.TestCase):
    def test_touching_overlapping_inside(self):
        box = Part.makeBox(10, 10, 10)
        self.assertEqual(pair_of(box, Part.makeBox(10, 10, 10, V(10, 3, 0))).relation, "touching")
        overlapping = pair_of(box, Part.makeBox(10, 10, 10, V(8, 3, 1)))
        self.assertEqual((overlapping.relation, overlapping.distance), ("overlapping", 0.0))
        self.assertGreater(overlapping.depth, 0.5)
        inside = mq.clearance({"box": box, "ball": Part.makeSphere(3, V(5, 5, 5))}).pairs[0]
        self.assertEqual((inside.relation, inside.inner), ("inside", "ball"))
        self.assertAlmostEqual(inside.distance, 2.0, delta=1e-6)

    def test_a_shaft_that_fits_exactly_touches(self):
        bore = Part.makeBox(40, 40, 20, V(-20, -20, 0)).cut(Part.makeCylinder(10, 20))
        self.assertEqual(pair_of(bore, Part.makeCylinder(10, 30, V(0, 0, -5))).relation, "touching")
        self.assertEqual(pair_of(bore, Part.makeCylinder(10.2, 30, V(0, 0, -5))).relation, "overlapping")

    def test_bodies_that_overlap_by_faces_alone(self):
        """No vertex and no edge of one lies deep in the other."""
        box, bar = Part.makeBox(10, 10, 10), Part.makeBox(30, 10, 10, V(-10, 0, 0))
        cylinder, ball = Part.makeCylinder(5, 10), Part.makeSphere(5)
        for first, second, relation, common in (
                (box, Part.makeBox(10, 10, 10, V(9, 0, 0)), "overlapping", 100), (box, box.copy(), "equal", 1000),
                (box, Part.makeBox(10, 10, 10, V(5, 0, 0)), "overlapping", 500), (cylinder, cylinder.copy(), "equal", 785.4),
                (ball, ball.copy(), "equal", 523.6), (bar, Part.makeBox(10, 30, 10, V(0, -10, 0)), "overlapping", 1000),
                (Part.makeBox(20, 20, 20), box, "inside", 1000), (bar, box, "inside", 1000),
                (box, Part.makeBox(10, 10, 10, V(10, 3, 0)), "touching", 0)):
            for bodies in ((first, second), (mq.triangulate(first), mq.triangulate(second))):
                found = mq.clearance(list(bodies))
                pair = found.pairs[0]
                self.assertEqual((pair.relation, pair.distance, pair.lower), (relation, 0.0, 0.0))
                self.assertAlmostEqual(pair.common_volume, common, delta=0.015 * common + 1e-9)
                self.assertEqual(pair.inner, found.bodies[1] if relation == "inside" else None)
                self.assertEqual(bool(verdict.of_clearance(found)), relation != "touching")
                self.assertIn("touch" if relation == "touching" else "mm3 in common", str(found))

    def test_a_cylinder_in_a_longer_one_lies_inside_as_far_as_the_meshes_tell(self):
        pair = pair_of(Part.makeCylinder(10, 30), Part.makeCylinder(10, 20, V(0, 0, 5)))
        self.assertEqual((pair.relation, pair.inner), ("inside", "Body2"))

    def test_a_tiny_gap_has_an_upper_bound(self):
        for gap in (2e-5, 5e-5, 5e-4):
            pair = pair_of(Part.makeBox(1000, 10, 10), Part.makeBox(10, 10, 10, V(1000 + gap, 0, 0)))
            self.assertLessEqual(pair.lower, gap)
            self.assertGreaterEqual(pair.upper, 0.99 * gap)

    def test_solids_of_one_shape(self):
        whole = Part.makeCompound([Part.makeBox(4, 4, 4, V(i * 6, 0, 0)) for i in range(4)])
        found = mq.clearance(whole)
        self.assertEqual(found.bodies, ("Solid1", "Solid2", "Solid3", "Solid4"))
        self.assertEqual(len(found.pairs), 6)
        self.assertEqual([round(pair.distance, 6) for pair in found.pairs], [2, 2, 2, 8, 8, 14])
        first = found.pairs[0]
        centers = [whole.getElement(name).CenterOfMass.x for name in first.faces]
        self.assertAlmostEqual(abs(centers[0] - centers[1]), 2.0)
        near = mq.clearance(whole, within=5.0)
        self.assertEqual(len(near.pairs), 3)

    def test_objects_where_the_document_has_them(self):
        document = FreeCAD.newDocument()
        try:
            container = document.addObject("App::Part", "Case")
            container.Placement.Base = V(0, 0, 100)
            lower, upper = document.addObject("Part::Box", "Lower"), document.addObject("Part::Box", "Upper")
            container.addObject(lower)
            upper.Placement.Base = V(0, 0, 111.5)
            document.recompute()
            found = mq.clearance([lower, upper], min_clearance=2.0)
            self.assertEqual(found.bodies, ("Lower", "Upper"))
            self.assertAlmostEqual(found.minimum, 1.5, delta=1e-6)
            self.assertEqual(found.too_near, found.pairs)
            self.assertIn("Lower Face6 and Upper Face5", str(found))
        finally:
            FreeCAD.closeDocument(document.Name)

    def test_refused(self):
        box = Part.makeBox(1, 1, 1)
        for bodies, values in ((box, {}), ([box], {}), ([], {}), ([box, "x"], {}), ([box, box], {"within": -1})):
            with self.assertRaises(mq.InvalidInput):
                mq.clearance(bodies, **values)

    def test_cancelling(self):
        meshes = [mq.triangulate(Part.makeSphere(20, V(39 * i, 3, 1)), chord_height=0.01) for i in range(4)]
        asked = []

        def progress(fraction, stage):
            if stage == "measuring the clearance" and not asked:
                asked.append(time.monotonic())
            return not asked

        with self.assertRaises(mq.Cancelled):
            mq.clearance(meshes, progress=progress)
        self.assertLess(time.monotonic() - asked[0], 0.2)


class CommandLine(unittest.TestCase):
    def test_files_and_solids(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, name) for name in ("a.brep", "b.brep", "both.brep")]
            first, second = Part.makeBox(4, 4, 4), Part.makeBox(4, 4, 4, V(4.5, 0, 0))
            for path, shape in zip(paths, (first, second, Part.makeCompound([first, second]))):
                shape.exportBrep(path)
            for inputs, names in ((paths[:2], ["a.brep", "b.brep"]), (paths[2:], ["Solid1", "Solid2"])):
                done = subprocess.run([COMMAND, "clearance", *inputs, "--min-clearance", "1", "--strict", "--json"],
                                      capture_output=True, text=True, timeout=120, stdin=subprocess.DEVNULL)
                self.assertEqual(done.returncode, 3, done.stderr)
                said = json.loads(done.stdout)
                self.assertEqual(said["bodies"], names)
                self.assertAlmostEqual(said["pairs"][0]["distance"], 0.5, places=6)
                self.assertIn("smallest gap 0.5 mm", said["findings"][0]["text"].lower())


if __name__ == "__main__":
    unittest.main()
