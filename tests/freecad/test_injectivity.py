# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved triangles that cross: in reports of curve, in certificates, and as verify shows them again."""

import json
import os

import FreeCAD
import helpers
import numpy as np
import Part
from test_certify import mesh_of

import MeshQuality as mq
from MeshQuality.core.certify import verdict
from MeshQuality.core.verify import crossing_verifier


def nearly_touching(turn, gap):
    """Two cylinders side by side, the first turned about its axis by degrees."""
    first, second = Part.makeCylinder(5, 10), Part.makeCylinder(5, 12)
    first.rotate(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), turn)
    second.rotate(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), turn + 180)
    second.translate(FreeCAD.Vector(10 + gap, 0, -1))
    return Part.makeCompound([first, second])


class CurvedIntersections(helpers.DocumentTest):
    def test_bodies_that_cross_only_when_curved(self):
        """Where their edges are chords, the straight meshes of two cylinders are apart though these are in one another."""
        for turn in range(10, 90, 8):
            pair = nearly_touching(turn, -0.02)
            if not mq.curve(pair, order=1, chord_height=0.3).report.curved_intersections:
                break
        report = mq.curve(pair, order=2, chord_height=0.3).report
        self.assertEqual((report.self_intersections, report.overlaps), (0, 0))
        self.assertGreater(report.curved_intersections, 0, report)
        self.assertTrue(any("of curved triangles cross" in note for note in report.notes), report.notes)
        self.assertIn(f"triangles that cross: {report.curved_intersections}, not proven apart", str(report))
        report = mq.curve(nearly_touching(turn, 0.1), order=2, chord_height=0.3).report
        self.assertEqual((report.curved_intersections, report.not_proven_apart), (0, 0))

    def test_volumes_surfaces_and_given_meshes_say_it(self):
        ball = Part.makeSphere(5)
        path = os.path.join(self.folder, "ball.msh")
        mq.curve(ball, order=1, volume=True).write(path)
        for curved in (mq.curve(ball, order=2), mq.curve(ball, order=2, volume=True), mq.curve(ball, mesh=path, order=3),
                       mq.curve(mq.triangulate(ball), shape=ball, order=2)):
            self.assertEqual((curved.report.curved_intersections, curved.report.not_proven_apart), (0, 0))

    def test_objects_show_it(self):
        obj = mq.add_curved_mesh(self.add_shape(Part.makeSphere(5)))
        self.assertEqual((obj.CurvedIntersections, obj.NotProvenApart), (0, 0))

    def add_shape(self, shape):
        obj = self.document.addObject("Part::Feature", "Shape")
        obj.Shape = shape
        return obj

    def test_solids_that_touch_on_planes_do_not_cross(self):
        """Also where the faces that lie on each other have other triangles."""
        boxes = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(5, 5, 5, FreeCAD.Vector(10, 2, 2))])
        report = mq.curve(boxes, order=2).report
        self.assertEqual((report.curved_intersections, report.not_proven_apart), (0, 0))


class Overlaps(helpers.DocumentTest):
    """Bodies of a volume mesh that lie in one another."""

    def ball(self, radius, x=0.0):
        mesh = mq.curve(Part.makeSphere(radius), order=2, volume=True)
        return mesh.nodes + [x, 0, 0], mesh.tetrahedra

    def together(self, *bodies):
        nodes, rows, count = [], [], 0
        for places, tetrahedra in bodies:
            nodes.append(places)
            rows.append(tetrahedra + count)
            count += len(places)
        return mesh_of(np.concatenate(nodes), ("tetrahedron", np.concatenate(rows)))

    def test_a_body_in_another(self):
        certificate = mq.certify(self.together(self.ball(5), self.ball(2)))
        self.assertEqual((certificate.overlapping_bodies, certificate.curved_intersections), (1, 0))
        self.assertTrue(any("1 pair of bodies lies in one another, at (" in note for note in certificate.notes))
        self.assertIn("1 pair of bodies lies in one another.", str(verdict.of_certificate(certificate)[0].text))

    def test_equal_bodies_and_bodies_apart(self):
        ball = self.ball(5)
        self.assertEqual(mq.certify(self.together(ball, ball)).overlapping_bodies, 1)
        self.assertEqual(mq.certify(self.together(ball, self.ball(5, 11.0))).overlapping_bodies, 0)
        self.assertEqual(mq.certify(self.together(ball)).overlapping_bodies, 0)

    def test_a_body_in_a_cavity(self):
        shell = Part.makeSphere(5).cut(Part.makeSphere(3))
        mesh = mq.curve(shell, order=2, volume=True)
        certificate = mq.certify(self.together((mesh.nodes, mesh.tetrahedra), self.ball(2)))
        self.assertEqual((certificate.overlapping_bodies, certificate.curved_intersections), (0, 0))


class HangingCorners(helpers.DocumentTest):
    """Corners that lie anywhere on an edge or a face of another element."""

    def test_on_an_edge(self):
        for share in (0.5, 0.25, 0.9):
            nodes = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [share, 0, 0], [0.5, -1, 0]]
            self.assertFalse(mq.certify(mesh_of(nodes, ("triangle", [[0, 1, 2], [0, 4, 3], [3, 4, 1]]))).conforming)
            self.assertTrue(mq.certify(mesh_of(nodes, ("triangle", [[0, 1, 2], [0, 4, 1]]))).conforming)

    def test_amid_a_face(self):
        nodes = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0.2, 0.3, 0], [0.3, 0.3, -1]]
        rows = [[0, 1, 2, 3], [0, 4, 1, 5], [1, 4, 2, 5], [2, 4, 0, 5]]
        self.assertFalse(mq.certify(mesh_of(nodes, ("tetrahedron", rows))).conforming)

    def test_on_a_curved_edge(self):
        def arc(t):
            return np.array([1 - t * t, 2 * t * (1 - 0.2 * t), 0])

        nodes = [arc(0), arc(1), [0, 0, 0], arc(0.5), arc(1) / 2, arc(0) / 2, arc(0.3), arc(0.15), arc(0.65), np.array([3, 2, 0])]

        def middle(i, j):
            nodes.append((np.array(nodes[i]) + np.array(nodes[j])) / 2)
            return len(nodes) - 1

        rows = [[0, 1, 2, 3, 4, 5], [6, 0, 9, 7, middle(0, 9), middle(9, 6)], [1, 6, 9, 8, middle(6, 9), middle(9, 1)]]
        self.assertFalse(mq.certify(mesh_of(nodes, ("triangle", rows))).conforming)

    def test_bodies_that_touch_are_no_fault(self):
        nodes = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0, 0], [0.6, 0, 0], [0.4, -1, 0]]
        self.assertTrue(mq.certify(mesh_of(nodes, ("triangle", [[0, 1, 2], [3, 5, 4]]))).conforming)


class BothDistances(helpers.DocumentTest):
    """certify with a shape measures the mesh from the CAD, and the CAD from the mesh."""

    def test_a_whole_surface(self):
        ball = Part.makeSphere(5)
        for order in (1, 2, 3):
            certificate = mq.certify(mq.curve(ball, order=order, chord_height_relative=0.02), ball)
            self.assertLess(certificate.cad_deviation, 1.5 * certificate.max_deviation + 1e-9)
            self.assertGreater(certificate.cad_deviation, 0.3 * certificate.max_deviation)
            self.assertEqual(len(certificate.face_deviation), 1)
            self.assertLess(certificate.cad_spacing, 2.0)

    def test_a_face_that_is_missing(self):
        box = Part.makeBox(10, 10, 10)
        curved = mq.curve(box, order=2, max_edge=3)
        kept = curved.triangles[curved.triangle_face != 2]
        certificate = mq.certify(mesh_of(curved.nodes, ("triangle", kept)), box)
        self.assertAlmostEqual(certificate.cad_deviation, 5.0, delta=0.5)
        self.assertEqual(certificate.face_deviation.argmax(), 2)
        self.assertLess(np.delete(certificate.face_deviation, 2).max(), 1e-9)
        self.assertTrue(any("the mesh leaves out a part of Face3" in note for note in certificate.notes), certificate.notes)


class VerifiedAgain(helpers.DocumentTest):
    """What verify shows of crossings and distances, by other means."""

    def saved(self, shape=None, **options):
        shape = shape or Part.makeSphere(5)
        cad, mesh, path = (os.path.join(self.folder, name) for name in ("part.brep", "mesh.msh", "mesh.json"))
        shape.exportBrep(cad)
        mq.curve(shape, order=2, chord_height_relative=0.03, **options).write(mesh)
        certificate = mq.certify(mesh, shape)
        certificate.save(path, cad=cad)
        return path, certificate

    def forged(self, path, change):
        with open(path, encoding="ascii") as stream:
            content = json.load(stream)
        change(content)
        other = os.path.join(self.folder, "forged.json")
        with open(other, "w", encoding="ascii") as stream:
            json.dump(content, stream)
        return mq.verify(other).faults

    def test_what_was_taken_out_is_missed(self):
        path, _ = self.saved(volume=True)
        with open(path, encoding="ascii") as stream:
            content = json.load(stream)
        parts = [("proven", name) for name in content["proven"] if name != "notes"]
        parts += [("surface", name) for name in content["surface"]]
        parts += [(name,) for name in content if name != "program"]
        self.assertGreater(len(parts), 20)
        for *outer, name in parts:
            with self.subTest(name):
                def change(made, outer=outer, name=name):
                    for part in outer:
                        made = made[part]
                    del made[name]
                try:
                    faults = self.forged(path, change)
                except mq.InvalidInput as error:
                    faults = [str(error)]
                self.assertTrue(faults)
        faults = self.forged(path, lambda made: made.update(cad=None))
        self.assertTrue(any("from which CAD file its distances are" in fault for fault in faults), faults)

    def test_distances(self):
        path, _ = self.saved(volume=True)
        found = mq.verify(path)
        self.assertTrue(found.holds, found.faults)
        smaller = self.forged(path, lambda content: (
            content["proven"].update(max_deviation=1e-9), content["surface"].update(
                deviation=[1e-9] * len(content["surface"]["deviation"]))))
        self.assertTrue(any("mm from the shape, more than the certificate says" in fault for fault in smaller), smaller)
        unlisted = self.forged(path, lambda content: content["proven"].update(max_deviation=1e-9))
        self.assertTrue(any("but the largest that it lists is" in fault for fault in unlisted), unlisted)
        without = self.forged(path, lambda content: content["surface"].pop("face") and content["surface"].pop("deviation"))
        self.assertTrue(any("does not list the CAD face" in fault for fault in without), without)
        nowhere = self.forged(path, lambda content: content.update(cad=None))
        self.assertTrue(any("cannot be shown again without the CAD file" in fault for fault in nowhere), nowhere)

    def test_holes(self):
        box = Part.makeBox(10, 10, 10)
        cad, path = (os.path.join(self.folder, name) for name in ("box.brep", "box.json"))
        box.exportBrep(cad)
        whole = mq.curve(box, order=2, max_edge=3)
        mesh = os.path.join(self.folder, "box.vtu")
        whole.write(mesh)
        mq.certify(mesh, box).save(path, cad=cad)
        found = mq.verify(path)
        self.assertTrue(found.holds, found.faults)

    def test_crossings(self):
        balls = Part.makeCompound([Part.makeSphere(5), Part.makeSphere(5, FreeCAD.Vector(9.7, 0, 0))])
        path, certificate = self.saved(balls)
        self.assertGreater(certificate.curved_intersections, 0)
        found = mq.verify(path)
        self.assertTrue(found.holds, found.faults)

        def hide(content):
            content["surface"]["crossing"] = []
            content["proven"]["curved_intersections"] = 0

        hidden = self.forged(path, hide)
        self.assertTrue(any("are certified apart, but cross" in fault for fault in hidden), hidden)
        counted = self.forged(path, lambda content: content["proven"].update(curved_intersections=0))
        self.assertTrue(any("says curved_intersections = 0, but lists" in fault for fault in counted), counted)

        def touch(content):
            content["surface"]["touching"] = content["surface"]["crossing"]
            hide(content)

        touching = self.forged(path, touch)
        self.assertTrue(any("are certified to touch only" in fault for fault in touching), touching)

        def invent(content):
            content["surface"]["crossing"].append([0, 1])
            content["proven"]["curved_intersections"] += 1

        invented = self.forged(path, invent)
        self.assertTrue(any("are certified to cross, but are apart" in fault for fault in invented), invented)

    def test_touching_solids(self):
        boxes = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(5, 5, 5, FreeCAD.Vector(10, 2, 2))])
        path, certificate = self.saved(boxes)
        self.assertEqual((certificate.curved_intersections, certificate.not_proven_apart), (0, 0))
        found = mq.verify(path)
        self.assertTrue(found.holds, found.faults)

    def test_bodies_in_one_another(self):
        path, _ = self.saved(volume=True)
        forged = self.forged(path, lambda content: content["proven"].update(overlapping_bodies=3))
        self.assertTrue(any("says overlapping_bodies = 3, but lists 0 such pairs that hold" in fault for fault in forged), forged)

    def test_the_core_and_the_verifier_agree_on_flat_and_slender_triangles(self):
        rows = np.array([[0, 1, 2], [1, 3, 2], [0, 2, 4]])
        for height in (1.0, 1e-3, 1e-6):
            nodes = np.array([[0, 0, 0], [1, 0, 0], [0.5, height, 0], [1.5, height, 0], [-0.5, height, 0]])
            pairs, _ = crossing_verifier.examine(nodes, [("triangle", 1, rows)])
            self.assertEqual(len(pairs), 0, height)
            self.assertEqual(mq.certify(mesh_of(nodes, ("triangle", rows))).not_proven_apart, 0)
