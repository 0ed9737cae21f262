# SPDX-License-Identifier: LGPL-2.1-or-later
"""Certificates: what is met, what is not and where; and when objects are computed anew."""

from unittest import mock

import FreeCAD
import helpers
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality import phrases
from MeshQuality.core.certify import verdict
from MeshQuality.features import mesh_object, properties


def wedge(tip=0.8, length=10.0):
    """A solid with a narrow corner: atan(tip / length) at two of its vertices."""
    corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (length, 0, 0), (length, tip, 0), (0, 0, 0))]
    return Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 3))


class CertificateTest(helpers.DocumentTest):
    def feature(self, shape, name="Part"):
        obj = self.document.addObject("Part::Feature", name)
        obj.Shape = shape
        self.document.recompute()
        return obj


class Certificates(CertificateTest):
    def test_a_good_mesh_keeps_what_was_asked(self):
        cylinder = self.feature(Part.makeCylinder(5, 10))
        obj = mq.add_quality_mesh(cylinder, min_angle=28, chord_height=0.01)
        self.assertEqual(obj.Certificate, "met")
        self.assertEqual((obj.AskedMinAngle.Value, obj.AskedChordHeight.Value), (28.0, 0.01))
        self.assertGreaterEqual(obj.MeasuredMinAngle.Value, 28.0 - 1e-9)
        self.assertLessEqual(obj.MaxChordHeight.Value, 0.01)
        self.assertTrue(obj.AskedClosed and obj.Closed and obj.Manifold)
        self.assertEqual(list(obj.CertificateFaces), [])

    def test_properties_are_read_only_in_their_group(self):
        box = self.box()
        for obj in (mq.add_quality_mesh(box), mq.add_curved_mesh(box),
                    mq.add_boolean(box, self.box("Other", Height=20), "union")):
            for name in ("Certificate", "AskedClosed", "Closed", "Manifold"):
                self.assertEqual(obj.getGroupOfProperty(name), "Certificate")
                self.assertEqual(obj.getEditorMode(name), ["ReadOnly"])
                self.assertTrue(obj.getDocumentationOfProperty(name))
            self.assertEqual(obj.Certificate, "met")

    def test_what_it_says_is_kept_as_data(self):
        obj = mq.add_quality_mesh(self.feature(wedge()))
        certificate = phrases.stored(obj.Certificate, obj.CertificateData)
        self.assertIsInstance(verdict.said(certificate), phrases.Text)
        self.assertEqual(verdict.said(certificate), verdict.said(str(certificate)))
        found = properties.exempt_reasons(obj)
        report = mq.triangulate(obj.Source).report
        self.assertEqual(found, dict(report.exempt))
        self.assertTrue(all(isinstance(why, phrases.Text) for why in found.values()))
        self.assertEqual({why.cause for _, why in report.exempt_reasons}, {"narrow_corner"})
        for _, why in report.exempt_reasons:
            self.assertTrue(why.forced)
            self.assertAlmostEqual(why.angle, 4.57, delta=0.01)
            self.assertRegex(" ".join(why.entities), r"^Edge\d+ Edge\d+ Vertex\d+ Face\d+$")

    def test_documents_of_older_versions_have_the_texts_only(self):
        obj = mq.add_quality_mesh(self.feature(wedge()))
        found = properties.exempt_reasons(obj)
        for stale in ([], ["nothing"], ['["another text", [0]]']):
            obj.ExemptReasons = stale
            self.assertEqual(properties.exempt_reasons(obj), found)
        obj.CertificateData = ""
        self.assertIs(type(phrases.stored(obj.Certificate, obj.CertificateData)), str)

    def test_a_narrow_corner_is_missed_with_its_place(self):
        source = self.feature(wedge())
        obj = mq.add_quality_mesh(source)
        mesh = mq.triangulate(source)
        angles = helpers.smallest_angles(mesh)
        worst = int(np.argmin(angles))
        self.assertRegex(obj.Certificate, rf"^not met: smallest angle 4\.57° \(requested 25°\), triangle "
                                          rf"{worst} on Face{mesh.triangle_face[worst] + 1}\. Target angle not "
                                          r"reachable: the shape itself has a corner of 4\.57° between Edge\d+ "
                                          r"and Edge\d+ at Vertex\d+\. 1 more triangle is below 25°")
        self.assertAlmostEqual(angles[worst], mesh.report.min_angle, places=6)
        below = {f"Face{face + 1}" for face in mesh.triangle_face[angles < 25.0]}
        self.assertEqual(set(obj.CertificateFaces), below)

    def test_an_improved_mesh_has_no_faces_to_name(self):
        source = self.document.addObject("Mesh::Feature", "Source")
        source.Mesh = mq.triangulate(wedge()).to_mesh()
        obj = mq.add_improved_mesh(source)
        self.assertRegex(obj.Certificate, r"^not met: smallest angle [\d.]+° \(requested 25°\), triangle")
        self.assertEqual(list(obj.CertificateFaces), [])

    def test_an_open_shape_need_not_be_closed(self):
        obj = mq.add_quality_mesh(self.feature(Part.makePlane(10, 10)))
        self.assertEqual((obj.AskedClosed, obj.Closed, obj.Certificate), (False, False, "met"))

    def test_a_distance_that_is_not_kept(self):
        source = self.feature(Part.makeCylinder(5, 10))
        obj = mq.add_quality_mesh(source, method="star", refine_samples=False, chord_height=0.01)
        self.assertGreater(obj.MaxChordHeight.Value, 0.01)
        self.assertIn("max. deviation 0.0171 mm (requested 0.01 mm)", obj.Certificate)
        self.assertNotIn("smallest angle", obj.Certificate)

    def test_a_distance_that_is_not_kept_has_a_place(self):
        source = self.feature(Part.makeCylinder(5, 10, FreeCAD.Vector(30, 0, 0)))
        values = {"method": "star", "refine_samples": False, "chord_height": 0.01}
        obj = mq.add_quality_mesh(source, **values)
        report = mq.triangulate(source, **values).report
        worst = report.max_chord_triangle
        self.assertTrue(obj.Certificate.endswith(f" mm), triangle {worst} on Face1."))
        self.assertEqual(obj.CertificateFaces, ["Face1"])
        facet = obj.Mesh.Facets[worst]
        np.testing.assert_allclose([tuple(corner) for corner in obj.CertificatePlace], facet.Points,
                                   atol=1e-5)
        x, y, _ = report.max_chord_point
        self.assertAlmostEqual(abs(np.hypot(x - 30, y) - 5), report.max_chord_height, places=5)
        apart = mq.quality(obj, source)
        self.assertAlmostEqual(apart.max_chord_height, report.max_chord_height, places=5)
        self.assertGreaterEqual(apart.max_chord_triangle, 0)

    def test_a_mesh_that_is_not_closed_tells_where(self):
        whole = mq.triangulate(Part.makeBox(10, 10, 10))

        class Cut:
            vertices, origin = whole.vertices, np.zeros(3)
            triangles, triangle_face = whole.triangles[1:], whole.triangle_face[1:]

        report = mq.quality((Cut.vertices, Cut.triangles))
        fault, = verdict.topology(report, True, Cut)
        self.assertEqual(fault.text, "Not watertight: 3 open edges.")
        self.assertIn(f"Face{whole.triangle_face[0] + 1}", fault.faces)
        lost = {tuple(corner) for corner in whole.vertices[whole.triangles[0]].tolist()}
        self.assertEqual(len(lost & set(fault.place)), 2)
        self.assertEqual(verdict.topology(report, False, Cut), [])

    def test_work_that_a_limit_ended(self):
        obj = mq.add_quality_mesh(self.box(), max_edge=0.5, max_triangles=50)
        self.assertIn("a limit ended the work early", obj.Certificate)

    def test_curved_elements_that_fold(self):
        class Report:
            invalid, elements = 4, 90

        class Curved:
            report, nodes = Report, np.arange(12.0).reshape(4, 3)
            triangles = np.array([[0, 1, 2], [1, 2, 3], [2, 3, 0], [3, 0, 1], [0, 1, 3]])
            triangle_quality, triangle_face = np.array([0.5, np.nan, -1.0, 0.0, 0.0]), np.array([5, 0, 1, 0, 1])
            tetrahedra, tetrahedron_quality = np.zeros((0, 4), dtype=int), np.zeros(0)

        faults = verdict.elements(Curved)
        self.assertEqual(faults[0].place, ((3, 4, 5), (6, 7, 8), (9, 10, 11)))
        self.assertEqual(verdict.sentence(faults),
                         "not met: 4 of 90 elements are not proven valid: triangle 1 on Face1, triangle 2 on "
                         "Face2, triangle 3 on Face1 and 1 more.")
        self.assertEqual(verdict.faces(faults), ["Face1", "Face2"])

    def test_a_boolean_tells_its_tolerance(self):
        obj = mq.add_boolean(self.box(), self.feature(Part.makeSphere(6)), "union", tolerance=0.02)
        self.assertEqual((obj.AskedTolerance.Value, obj.Certificate), (0.02, "met"))
        self.assertLessEqual(obj.ErrorBound.Value, 0.02)
        mq.update(obj, tolerance=None, resolution=100)
        self.assertAlmostEqual(obj.AskedTolerance.Value, 3**0.5 * 16 / 100)

    def test_nothing_is_promised_of_an_empty_boolean(self):
        far = self.feature(Part.makeBox(1, 1, 1, FreeCAD.Vector(50, 0, 0)))
        obj = mq.add_boolean(self.box(), far, "intersection")
        self.assertEqual((obj.Triangles, obj.Certificate), (0, "met"))

    def test_documents_of_older_versions(self):
        for add in (mq.add_quality_mesh, mq.add_curved_mesh):
            obj = add(self.box())
            for name in ("Certificate", "Status", "Recompute"):
                obj.removeProperty(name)
            obj.Proxy.onDocumentRestored(obj)
            self.assertTrue(obj.Certificate.startswith("unknown"))
            self.assertEqual((obj.Recompute, obj.Status), ("Automatic", "up to date"))
            mq.update(obj)
            self.assertEqual(obj.Certificate, "met")


class WhatNoMeshShouldHave(CertificateTest):
    """Faults that are said, and never green."""

    def crossing_solid(self):
        """A closed shell whose faces cross: a bow tie pulled up."""
        corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (10, 10, 0), (10, 0, 0), (0, 10, 0))]
        side = [Part.Face(Part.makePolygon([a, b, b + up, a + up, a]))
                for up in [FreeCAD.Vector(0, 0, 5)]
                for a, b in zip(corners, corners[1:] + corners[:1])]
        return Part.makeShell(side)

    def test_faces_that_cross(self):
        source = self.feature(self.crossing_solid())
        obj = mq.add_quality_mesh(source)
        report = mq.triangulate(source).report
        self.assertGreater(report.self_intersections, 0)
        self.assertEqual([crossing[:2] for crossing in report.crossing_faces], [(0, 2)])
        self.assertIn("surface intersects itself", obj.Certificate)
        self.assertIn("Face1 and Face3 cross.", obj.Certificate)
        self.assertTrue(verdict.is_missed(obj.Certificate))
        self.assertEqual(list(obj.CertificateFaces), ["Face1", "Face3"])
        self.assertIn("not all limits met", repr(report))
        curved = mq.add_curved_mesh(source)
        self.assertIn("Face1 and Face3 cross.", curved.Certificate)

    def test_a_mesh_that_crosses_itself_after_improving(self):
        source = self.document.addObject("Mesh::Feature", "Source")
        source.Mesh = mq.triangulate(self.crossing_solid()).to_mesh()
        self.assertIn("surface intersects itself", mq.add_improved_mesh(source).Certificate)

    def test_edges_that_are_longer_than_requested(self):
        ball = Part.makeSphere(5)
        for values in ({"max_edge": 0.5}, {"local_sizes": {"Face1": 0.5}}):
            given = {"method": "star", "refine_samples": False, "chord_height": "none", **values}
            mesh = mq.triangulate(ball, **given)
            sides = mesh.vertices[mesh.triangles]
            longest = np.linalg.norm(sides - np.roll(sides, 1, axis=1), axis=2).max()
            self.assertGreater(longest, 0.5)
            finding = next(f for f in verdict.of_triangulation(mesh, True, given) if "longest edge" in f.text.lower())
            self.assertEqual(finding.faces, ("Face1",))
            fine = mq.triangulate(ball, chord_height="none", **values)
            self.assertEqual(verdict.of_triangulation(fine, True, values), [])

    def test_edges_of_the_shape_that_are_longer_than_requested(self):
        """A straight edge between corners, a circle, a seam, and around a vertex."""
        for shape, name, faces in (
                (Part.makeBox(10, 10, 10), "Edge7", {"Face2", "Face4"}), (Part.makeCylinder(5, 10), "Edge1", None),
                (Part.makeCylinder(5, 10), "Edge2", {"Face1"}), (Part.makeBox(10, 10, 10), "Vertex1", None)):
            with self.subTest(name):
                values = {"local_sizes": {name: 0.5}, "chord_height": "none"}
                coarse = mq.triangulate(shape, chord_height="none")
                finding, = verdict.of_triangulation(coarse, True, values, shape)
                self.assertIn("(requested 0.5 mm)", finding.text)
                if name.startswith("Edge"):
                    self.assertTrue(finding.text.endswith(f" at {name}."), finding.text)
                if faces:
                    self.assertLessEqual(set(finding.faces), faces)
                self.assertEqual(len(finding.place), 3)
                fine = mq.triangulate(shape, **values)
                self.assertEqual(verdict.of_triangulation(fine, True, values, shape), [])
                self.assertEqual(verdict.of_triangulation(coarse, True, {}, shape), [])

    def test_a_size_on_an_edge_in_the_certificate(self):
        obj = mq.add_quality_mesh(self.box(), local_sizes={"Edge1": 0.5}, method="star", refine_samples=False,
                                  chord_height="none", min_angle=1.0)
        self.assertRegex(obj.Certificate, r"ongest edge .* \(requested 0\.5 mm\), triangle \d+ on Face\d at Edge1\.")

    def test_surfaces_that_are_inside_out(self):
        whole = mq.triangulate(Part.makeBox(10, 10, 10))
        inward = mq.improve((np.array(whole.vertices), np.array(whole.triangles[:, ::-1])))
        self.assertLess(inward.report.volume, 0.0)
        finding, = verdict.of_improvement(inward, True)
        self.assertEqual(finding.text, "The surface is inside out: its triangles face inwards.")
        source = self.document.addObject("Mesh::Feature", "Source")
        mesh = whole.to_mesh()
        mesh.flipNormals()
        source.Mesh = mesh
        self.assertEqual(mq.add_improved_mesh(source).Certificate,
                         "not met: the surface is inside out: its triangles face inwards.")
        # A sheet with two sides has no inside.
        both = np.concatenate((whole.triangles[:1], whole.triangles[:1, ::-1]))
        self.assertNotIn("inside out", " ".join(f.text for f in verdict.topology(
            mq.quality((whole.vertices, both)), True)))

    def test_faces_that_were_left_out(self):
        class Report:
            triangles, min_angle, min_angle_asked, complete, self_intersections = 2, 45.0, 25.0, True, 0
            max_chord_height, chord_height_asked, max_chord_triangle, exempt_reasons = 0.0, 0.0, -1, ()
            closed, border_edges, nonmanifold_edges, pinched_vertices = False, 4, 0, 0
            degenerate_triangles, misoriented_edges, overlapping_bodies = 0, 0, ()
            missing_faces = [(6, "no triangulation"), (6, "no triangulation"), (1, "of another kind")]

        class Mesh:
            report = Report

        finding, = verdict.of_triangulation(Mesh, False)
        self.assertEqual(finding.text, "2 faces could not be meshed and were left out: Face7, Face2.")
        self.assertEqual(finding.faces, ("Face7", "Face2"))

    def test_faces_turned_the_wrong_way(self):
        whole = mq.triangulate(Part.makeBox(10, 10, 10))
        triangles = whole.triangles.copy()
        triangles[0] = triangles[0][::-1]
        found = verdict.topology(mq.quality((whole.vertices, triangles)), True)
        self.assertEqual([finding.text for finding in found],
                         ["The triangles on both sides of 3 edges disagree on the outside."])

    def test_all_kinds_of_faults_in_a_measured_mesh(self):
        mesh = mq.triangulate(Part.makeBox(10, 10, 10))
        self.assertEqual(verdict.of_measured(mesh, mesh.report, True), [])
        crossing = mq.triangulate(self.crossing_solid())
        texts = " ".join(finding.text for finding in verdict.of_measured(crossing, crossing.report, True))
        self.assertIn("Not watertight: ", texts)
        self.assertIn("The surface intersects itself: ", texts)

    def test_one_is_not_many(self):
        for count, text in ((1, "Not watertight: 1 open edge."), (2, "Not watertight: 2 open edges."),
                            (5584, "Not watertight: 5,584 open edges.")):
            self.assertEqual(phrases.counted_sentence(phrases.NOT_CLOSED, count), text)


class VolumeMeshes(CertificateTest):
    def test_distorted_elements_inside_are_a_finding(self):
        curved = mq.curve(Part.makeCylinder(5, 10), volume=True)
        self.assertEqual(verdict.of_curved(curved, True), [])

        class Report:
            invalid, self_intersections, max_shape_distortion = 0, 0, 39.9
            curved_intersections, overlapping_bodies = 0, ()
            max_deviation, chord_height_asked = 0.1, 0.0

        class Distorted:
            report, straight, nodes, tetrahedra = Report, None, curved.nodes, curved.tetrahedra
            triangles, tetrahedron_solid = curved.triangles, curved.tetrahedron_solid
            tetrahedron_distortion = np.ones(len(curved.tetrahedra))

        Distorted.tetrahedron_distortion[[3, 7]] = 39.9, 10.5
        finding, = verdict.of_curved(Distorted, True)
        self.assertEqual(finding.text, "Max. shape distortion 39.9 (limit 10), tetrahedron 3 of Solid1. 1 more "
                                       "element is distorted by more than 10.")
        self.assertEqual(len(finding.place), 3)
        self.assertTrue(verdict.sentence([finding]).startswith("not met: max. shape distortion 39.9"))

    def test_a_needle_of_a_part_is_not_met(self):
        source = self.feature(wedge(tip=0.2))
        obj = mq.add_curved_mesh(source, volume=True)
        self.assertGreater(obj.MaxShapeDistortion, verdict.SHAPE_DISTORTION_LIMIT)
        self.assertIn("max. shape distortion", obj.Certificate)
        self.assertTrue(verdict.is_missed(obj.Certificate))


class CurvedMeshes(CertificateTest):
    """What was requested of a mesh before curving counts for the curved one."""

    def test_a_smallest_angle_that_is_not_kept(self):
        source = self.feature(wedge())
        obj = mq.add_curved_mesh(source, min_angle=25)
        self.assertIn("before curving: smallest angle 4.57° (requested 25°), triangle ", obj.Certificate)
        self.assertIn("Target angle not reachable: the shape itself has a corner of 4.57°", obj.Certificate)
        self.assertTrue(verdict.is_missed(obj.Certificate))
        curved = mq.curve(source, min_angle=25)
        self.assertEqual((curved.report.straight.min_angle_asked, curved.report.self_intersections), (25.0, 0))
        finding, = verdict.of_curved(curved, True)
        plain, = verdict.of_triangulation(curved.straight, True)
        self.assertEqual(finding.text, f"Before curving: s{plain.text[1:]}")
        self.assertEqual((finding.faces, finding.place, finding.forced), (plain.faces, plain.place, True))
        loose = mq.curve(source, min_angle=4)
        self.assertEqual(verdict.of_curved(loose, True), [])

    def test_a_distance_that_is_not_kept(self):
        source = Part.makeCylinder(5, 10)
        rough = mq.triangulate(source, method="star", refine_samples=False, chord_height=0.01)
        flat = mq.curve(rough, order=1, shape=source)
        self.assertEqual(flat.report.chord_height_asked, 0.01)
        self.assertGreater(flat.report.max_deviation, 0.01)
        texts = [finding.text for finding in verdict.of_curved(flat, True)]
        self.assertTrue(any(text.startswith("Max. deviation 0.0") and "(requested 0.01 mm)" in text for text in texts))
        bent = mq.curve(rough, order=3, shape=source)
        self.assertLess(bent.report.max_deviation, 0.01)
        self.assertEqual(verdict.of_curved(bent, True), [])

    def test_edges_that_are_longer_than_requested(self):
        curved = mq.curve(Part.makeBox(10, 10, 10), max_edge=6)
        self.assertEqual(verdict.of_curved(curved, True, {"max_edge": 6}), [])
        finding, = verdict.of_curved(curved, True, {"max_edge": 1})
        self.assertIn("Before curving: longest edge ", finding.text)
        finding, = verdict.of_curved(curved, True, {"local_sizes": {"Face2": 1.0}})
        self.assertEqual(finding.faces, ("Face2",))

    def test_a_mesh_of_a_document_knows_nothing_of_it(self):
        obj = mq.add_curved_mesh(self.feature(wedge()))
        self.assertIsNone(mq.CurvedMesh.of(obj).straight)


class Overlaps(CertificateTest):
    """Bodies that cross and surfaces that cross themselves are findings."""

    def test_solids_that_overlap_are_a_finding_unless_allowed(self):
        boxes = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, FreeCAD.Vector(5, 4, 3))])
        mesh = mq.triangulate(boxes)
        self.assertEqual(mesh.report.self_intersections, 0)
        self.assertGreater(mesh.report.overlaps, 0)
        finding, = verdict.of_triangulation(mesh, True)
        self.assertEqual(finding.text, "1 pair of bodies overlaps. Solid1 and Solid2 overlap.")
        self.assertEqual(verdict.of_triangulation(mesh, True, {"overlap": "allow"}), [])
        line = verdict.line("Both", mesh.report, [])
        self.assertIn(f", {mesh.report.overlaps} pairs of triangles where bodies overlap; all requested", line)
        curved = mq.curve(boxes)
        self.assertGreater(curved.report.overlaps, 0)
        overlap, crossing = verdict.of_curved(curved, True)
        self.assertEqual(overlap.text, finding.text)
        self.assertIn("pairs of triangles cross", crossing.text)
        self.assertEqual(verdict.of_curved(curved, True, {"overlap": "allow"}), [])
        self.assertIn("where bodies overlap", verdict.line("Both", curved.report, []))

    def test_loose_faces_that_cross_are_a_finding(self):
        upright = Part.makePlane(10, 10, FreeCAD.Vector(3, 0, -5), FreeCAD.Vector(1, 0, 0))
        faces = Part.makeCompound([Part.makePlane(10, 10, FreeCAD.Vector(0, -5, 0)), upright])
        obj = mq.add_quality_mesh(self.feature(faces))
        self.assertIn("surface intersects itself", obj.Certificate)
        self.assertIn("Face1 and Face2 cross.", obj.Certificate)
        side_by_side = Part.makeCompound([face.copy() for face in Part.makeCylinder(5, 10).Faces])
        self.assertEqual(mq.add_quality_mesh(self.feature(side_by_side)).Certificate, "met")


class Words(CertificateTest):
    def test_only_corners_of_the_shape_are_told_apart(self):
        finding, = verdict.of_triangulation(mq.triangulate(wedge()), True)
        self.assertTrue(finding.forced)
        self.assertIn("Target angle not reachable: the shape itself has a corner of 4.57°", finding.text)
        stopped = verdict.of_triangulation(mq.triangulate(Part.makeBox(9, 9, 9), max_edge=0.5, max_triangles=50),
                                           True)
        self.assertFalse(any(finding.forced for finding in stopped))

    def test_numbers_are_told_from_their_limits(self):
        for value, limit, texts in ((24.99996, 25.0, ("24.99996", "25")), (0.0012345, 25.0, ("0.00123", "25")),
                                    (0.0100001, 0.01, ("0.0100001", "0.01")), (39.94, 10.0, ("39.9", "10")),
                                    (0.03, 0.0299999, ("0.03", "0.0299999")), (1e-9, 0.01, ("0", "0.01"))):
            self.assertEqual(verdict._told_apart(value, limit), texts)

    def test_older_documents_are_understood(self):
        for text, met, missed in (("kept", True, False), ("met", True, False),
                                  ("missed: smallest angle 4.57 of 25 degrees at triangle 3", False, True),
                                  ("not met: not watertight: 3 open edges.", False, True),
                                  (verdict.UNKNOWN, False, False)):
            self.assertEqual((verdict.is_met(text), verdict.is_missed(text)), (met, missed), text)
        self.assertEqual(verdict.said("missed: smallest angle"), "smallest angle")
        self.assertEqual(verdict.said("not met: smallest angle"), "smallest angle")

    def test_one_line_for_each_object_that_was_computed(self):
        source = self.feature(wedge())
        lines = []
        with mock.patch.object(FreeCAD, "Console", mock.Mock(
                PrintMessage=lambda text: lines.append(("message", text)),
                PrintWarning=lambda text: lines.append(("warning", text)))):
            good = mq.add_quality_mesh(self.box(), chord_height=0.01)
            bad = mq.add_quality_mesh(source)
            self.document.recompute()
            mq.update(good)
            good.touch()
            self.document.recompute()
        self.assertEqual([kind for kind, _ in lines], ["message", "warning"])
        self.assertEqual(lines[0][1], f"{good.Label}: 12 triangles, smallest angle 45°, max. deviation 0 mm; all "
                                      "requested limits are met.\n")
        self.assertTrue(lines[1][1].startswith(f"{bad.Label}: {bad.Triangles} triangles, smallest angle 4.57°, "))
        self.assertIn("; target not met: smallest angle 4.57° (requested 25°), triangle ", lines[1][1])

    def test_booleans_and_curved_meshes_have_their_line(self):
        box, lines = self.box(), []
        with mock.patch.object(FreeCAD, "Console", mock.Mock(
                PrintMessage=lines.append, PrintWarning=lines.append)):
            mq.add_boolean(box, self.box("Other", Height=20), "union")
            curved = mq.add_curved_mesh(box)
            mq.update(curved, deviation=0.5)  # shown in another way: no new mesh
        self.assertEqual(len(lines), 2)
        self.assertRegex(lines[0], r"^Box union: \d+ triangles, smallest angle [\d.]+°, max\. deviation [\d.]+ mm; all ")
        self.assertRegex(lines[1], r"^Box curved mesh: 12 elements, max\. shape distortion 1\.15, max\. deviation 0 mm")


class Failures(CertificateTest):
    def test_a_source_that_was_deleted(self):
        box, other = self.box(), self.box("Other", Length=20)
        made = [mq.add_quality_mesh(box), mq.add_curved_mesh(box), mq.add_boolean(box, other, "union")]
        self.document.removeObject(box.Name)
        for obj in made:
            self.assertEqual(obj.Status, mesh_object.SOURCE_DELETED)
        self.document.recompute()
        for obj in made:
            self.assertFalse(obj.isValid())
            self.assertEqual(obj.Status, mesh_object.SOURCE_DELETED)
            self.assertNotIn("NoneType", obj.getStatusString())
        self.assertIn("the source was deleted", made[0].getStatusString())
        self.assertGreater(made[0].Mesh.CountFacets, 0)

    def test_an_expression_without_a_value(self):
        obj = mq.add_quality_mesh(self.box())
        obj.setExpression("MaxEdge", "Box.Length")
        self.document.recompute()
        self.assertEqual(obj.Certificate, "met")
        self.document.Box.Length = 12
        obj.setExpression("MaxEdge", "sqrt(0 - 1) * Box.Length")
        self.document.recompute()
        self.assertFalse(obj.isValid())
        self.assertTrue(obj.Status.startswith("failed: "), obj.Status)
        self.assertEqual(obj.Certificate, verdict.NOT_COMPUTED)
        obj.setExpression("MaxEdge", "Box.Length")
        self.document.recompute()
        self.assertEqual((obj.Certificate, obj.Status), ("met", "up to date"))

    def test_what_cannot_be_computed_says_so_until_it_can(self):
        obj = mq.add_quality_mesh(self.box())
        obj.MaxEdge, obj.MinEdge = 1, 2
        self.document.recompute()
        self.assertTrue(obj.Status.startswith("failed: min_edge = 2 mm is longer"), obj.Status)
        obj.MinEdge = 0.1
        self.document.recompute()
        self.assertEqual(obj.Status, "up to date")


class RecomputeRules(CertificateTest):
    def three(self):
        box, other = self.box(), self.box("Other", Length=20)
        return box, [mq.add_quality_mesh(box), mq.add_curved_mesh(box),
                     mq.add_boolean(box, other, "union")]

    def test_automatic_follows_the_source(self):
        box, made = self.three()
        box.Height = 33
        self.document.recompute()
        for obj in made:
            self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 33.0, places=4)
            self.assertEqual(obj.Status, "up to date")

    def test_manual_waits_until_it_is_asked(self):
        box, made = self.three()
        for obj in made:
            obj.Recompute = "Manual"
        self.document.recompute()
        box.Height = 33
        self.document.recompute()
        for obj in made:
            with self.subTest(obj.Label):
                self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 10.0)
                self.assertEqual(obj.Status, mesh_object.OUT_OF_DATE)
                self.assertTrue(obj.isValid())
                self.assertNotIn("Touched", obj.State)
                mq.update(obj)
                self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 33.0, places=4)
                self.assertEqual((obj.Status, obj.Recompute), ("up to date", "Manual"))

    def test_a_change_taken_back_is_up_to_date_again(self):
        box, made = self.three()
        made[0].Recompute = "Manual"
        for height, status in ((33, mesh_object.OUT_OF_DATE), (10, mesh_object.UP_TO_DATE)):
            box.Height = height
            self.document.recompute()
            self.assertEqual(made[0].Status, status)

    def test_back_to_automatic_computes(self):
        box, made = self.three()
        made[0].Recompute = "Manual"
        box.Height = 33
        self.document.recompute()
        made[0].Recompute = "Automatic"
        self.document.recompute()
        self.assertAlmostEqual(made[0].Mesh.BoundBox.ZLength, 33.0, places=4)
        self.assertEqual(made[0].Status, "up to date")

    def test_it_is_saved(self):
        box, made = self.three()
        made[0].Recompute = "Manual"
        box.Height = 33
        self.document.recompute()
        self.reopen()
        obj = self.document.getObject("QualityMesh")
        self.assertEqual((obj.Recompute, obj.Status), ("Manual", mesh_object.OUT_OF_DATE))
        mq.update(obj)
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 33.0, places=4)

    def test_update_is_one_undo_step(self):
        _, made = self.three()
        steps, before = self.document.UndoCount, made[0].Triangles
        mq.update(made[0], max_edge=3.0)
        self.assertGreater(made[0].Triangles, before)
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.document.undo()
        self.assertEqual((made[0].Triangles, made[0].MaxEdge.Value), (before, 0.0))

    def test_update_can_be_cancelled(self):
        _, made = self.three()
        before = made[0].Triangles
        with self.assertRaises(mq.Cancelled):
            mq.update(made[0], max_edge=0.05, progress=lambda fraction, stage: False)
        self.assertEqual((made[0].Triangles, made[0].MaxEdge.Value), (before, 0.0))
