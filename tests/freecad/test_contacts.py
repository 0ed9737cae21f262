# SPDX-License-Identifier: LGPL-2.1-or-later
"""imprint: solids that touch have the same triangles on both sides."""

import os
import tempfile
import unittest

import FreeCAD
import numpy as np
import Part
from FreeCAD import Placement, Rotation, Vector

import MeshQuality as mq
from MeshQuality.cli import parser


def assembly():
    """A block with a smaller block at its side, a disc on top, a bored block on that, and a pin through the bore."""
    bored = Part.makeBox(10, 10, 10, Vector(0, 0, 20)).cut(Part.makeCylinder(2, 10, Vector(5, 5, 20)))
    return Part.makeCompound([
        Part.makeBox(10, 10, 10), Part.makeBox(5, 5, 5, Vector(10, 2, 2)), Part.makeCylinder(3, 10, Vector(5, 5, 10)),
        bored, Part.makeCylinder(2, 15, Vector(5, 5, 20))])


CONTACTS = {(0, 1): 25.0, (0, 2): 9 * np.pi, (2, 3): 5 * np.pi, (2, 4): 4 * np.pi, (3, 4): 40 * np.pi}


class Contacts(unittest.TestCase):
    """Assemblies of solids."""

    def check(self, shape, mesh):
        """The two sides of each contact are the same triangles, the other way round; each is on its own solid."""
        corners = mesh.vertices[mesh.triangles]
        opposite = mesh.triangle_opposite
        sides = np.flatnonzero(opposite >= 0)
        np.testing.assert_array_equal(opposite[opposite[sides]], sides)
        self.assertTrue((mesh.triangle_solid[sides] != mesh.triangle_solid[opposite[sides]]).all())

        def turned(triangles):
            """From the least corner on, so that the same triangle has the same rows."""
            first = np.lexsort(triangles.transpose(2, 0, 1)[::-1], axis=-1)[:, 0]
            return [np.roll(t, -k, axis=0) for t, k in zip(triangles, first)]

        np.testing.assert_array_equal(turned(corners[sides]), turned(corners[opposite[sides]][:, ::-1]))
        faces_of = [{face.hashCode() for face in solid.Faces} for solid in shape.Solids]
        hashes = [face.hashCode() for face in shape.Faces]
        for face, solid in set(zip(mesh.triangle_face.tolist(), mesh.triangle_solid.tolist())):
            self.assertIn(hashes[face], faces_of[solid])

    def check_volumes(self, volumes, mesh, places):
        """The triangles of each solid enclose it."""
        corners = mesh.vertices[mesh.triangles] + mesh.origin
        six = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
        for number, volume in enumerate(volumes):
            self.assertAlmostEqual(six[mesh.triangle_solid == number].sum() / 6, volume, places)

    def test_the_triangles_are_the_same_on_both_sides(self):
        shape = assembly()
        mesh = mq.triangulate(shape, min_angle=25, chord_height=0.005, imprint=True)
        report = mesh.report
        self.assertTrue(report.closed and report.manifold and report.oriented and report.imprinted)
        self.assertEqual(report.self_intersections, 0)
        self.assertEqual(len(report.exempt), 0)
        self.assertGreaterEqual(report.min_angle, 25)
        self.assertLessEqual(report.max_chord_height, 0.005)
        self.check(shape, mesh)
        self.check_volumes([solid.Volume for solid in shape.Solids], mesh, 0)
        found = {(a, b): area for a, b, _, area in report.contacts}
        self.assertEqual(set(found), set(CONTACTS))
        for pair, area in CONTACTS.items():
            self.assertAlmostEqual(found[pair] / area, 1, 2)

    def test_without_it_sides_are_meshed_alone(self):
        mesh = mq.triangulate(assembly(), chord_height=0.05)
        self.assertEqual(len(mesh.triangle_opposite), 0)
        self.assertEqual(mesh.report.contacts, [])
        self.assertFalse(mesh.report.imprinted)
        self.assertEqual(set(mesh.triangle_solid.tolist()), set(range(5)))

    def test_a_face_that_a_contact_covers_keeps_its_name(self):
        shape = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, Vector(0, 0, 10))])
        mesh = mq.triangulate(shape, imprint=True, chord_height=0.1, local_sizes={"Face11": 1.0})
        self.check(shape, mesh)
        self.assertEqual(len(set(mesh.triangle_face.tolist())), 12)
        top, bottom = (int((mesh.triangle_face == face).sum()) for face in (5, 10))
        self.assertEqual(top, bottom)
        self.assertGreater(top, 200)  # the size of the lower side holds for the one triangulation there is

    def test_moved_and_turned(self):
        shape = assembly()
        shape.Placement = Placement(Vector(123, -45, 6), Rotation(Vector(1, 2, 3), 50))
        mesh = mq.triangulate(shape, chord_height=0.05, imprint=True)
        self.check(shape, mesh)
        self.assertEqual({(a, b) for a, b, _, _ in mesh.report.contacts}, set(CONTACTS))

    def test_solids_that_overlap_are_named_and_not_divided(self):
        shape = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, Vector(5, 5, 5))])
        mesh = mq.triangulate(shape, chord_height=0.1, imprint=True)
        self.assertEqual(mesh.report.contacts, [])
        self.assertEqual(len(mesh.triangles), 24)
        self.assertTrue(any("Solid1 and Solid2 overlap" in note for note in mesh.report.notes), mesh.report.notes)

    def test_one_solid_and_solids_apart_stay_as_they_are(self):
        for shape in (Part.makeBox(1, 2, 3),
                      Part.makeCompound([Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, Vector(3, 0, 0))])):
            alone, imprinted = (mq.triangulate(shape, imprint=imprint) for imprint in (False, True))
            np.testing.assert_array_equal(alone.vertices, imprinted.vertices)
            np.testing.assert_array_equal(alone.triangles, imprinted.triangles)

    def test_copies_at_several_places(self):
        one = Part.makeBox(10, 10, 10)
        copies = [one.copy() for _ in range(3)]
        for number, copy in enumerate(copies):
            copy.Placement = Placement(Vector(10 * number, 3 * number, 0), Rotation())
        shape = Part.makeCompound(copies)
        mesh = mq.triangulate(shape, chord_height=0.1, imprint=True)
        self.check(shape, mesh)
        self.check_volumes([1000] * 3, mesh, 3)
        self.assertEqual([(a, b, round(area, 6)) for a, b, _, area in mesh.report.contacts],
                         [(0, 1, 70.0), (1, 2, 70.0)])

    def test_the_shape_is_only_read(self):
        shape = assembly()
        before = shape.exportBrepToString()
        mq.triangulate(shape, chord_height=0.1, imprint=True)
        self.assertEqual(shape.exportBrepToString(), before)

    def test_the_same_with_creases(self):
        """A spline through corners on a block: its surface is cut along them, too."""
        points = [Vector(0, 0, 10), Vector(5, 0, 15), Vector(10, 0, 10)]
        curve = Part.BSplineCurve()
        curve.buildFromPolesMultsKnots(points, [2, 1, 2], [0, 1, 2], False, 1)
        roof = Part.Face(Part.Wire([curve.toShape(), Part.makeLine(points[2], points[0])])).extrude(Vector(0, 10, 0))
        shape = Part.makeCompound([Part.makeBox(10, 20, 10), roof])
        mesh = mq.triangulate(shape, chord_height=0.01, imprint=True)
        self.check(shape, mesh)
        self.check_volumes([2000, 250], mesh, 3)
        self.assertEqual([(a, b, round(area, 4)) for a, b, _, area in mesh.report.contacts], [(0, 1, 100.0)])

    def test_tetrahedra_of_both_solids_share_nodes(self):
        shape = assembly()
        mesh = mq.curve(shape, order=2, volume=True, chord_height=0.05, imprint=True)
        self.assertEqual(mesh.report.invalid, 0)
        faces = np.sort(mesh.tetrahedra[:, [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]].reshape(-1, 3), axis=1)
        solids = np.repeat(mesh.tetrahedron_solid, 4)
        shared = {}
        for key, solid in zip(map(tuple, faces.tolist()), solids.tolist()):
            shared.setdefault(key, []).append(solid)
        self.assertLessEqual(max(map(len, shared.values())), 2)
        between = {tuple(sorted(pair)) for pair in shared.values() if len(set(pair)) == 2}
        self.assertEqual(between, set(CONTACTS))
        self.assertEqual(len({tuple(node) for node in mesh.nodes.tolist()}), len(mesh.nodes))

    def test_what_lies_between_two_solids_is_a_patch(self):
        mesh = mq.triangulate(assembly(), chord_height=0.1, imprint=True, patch_rest="outside")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "regions.stl")
            mesh.write(path, ascii=True, interfaces=True)
            found, name = {}, None
            with open(path, encoding="utf-8") as stream:
                for line in stream:
                    words = line.split()
                    if words[0] == "solid":
                        name = words[1]
                    elif words[0] == "facet":
                        found[name] = found.get(name, 0) + 1
            counts = {frozenset((a, b)): count for a, b, count, _ in mesh.report.contacts}
            for (a, b) in CONTACTS:
                for one, other in ((a, b), (b, a)):
                    self.assertEqual(found.pop(f"Solid{one + 1}_to_Solid{other + 1}"), counts[frozenset((a, b))])
            self.assertEqual(found, {"outside": int((mesh.triangle_opposite < 0).sum())})
            with self.assertRaisesRegex(mq.InvalidInput, "imprint=True"):
                mq.triangulate(Part.makeBox(1, 1, 1)).write(path, interfaces=True)

    def test_a_contact_is_one_sheet_where_that_is_asked_for(self):
        """In the file the outside of each solid and the sheets that bound it enclose its volume, edge for edge."""
        three = [Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, Vector(10, 0, 0)),
                 Part.makeBox(20, 10, 10, Vector(0, 10, 0))]  # all have the edge from (10, 10, 0) upwards
        pin = Part.makeCylinder(2, 10, Vector(5, 5, 0))
        for solids, contacts in ((three[:2], [(1, 2)]), (three, [(1, 2), (1, 3), (2, 3)]),
                                 ([three[0].cut(pin), Part.makeCylinder(2, 10, Vector(5, 5, 0))], [(1, 2)])):
            with self.subTest(solids=len(solids), contacts=contacts), tempfile.TemporaryDirectory() as folder:
                self.check_sheets(Part.makeCompound(solids), contacts, folder)

    def check_sheets(self, shape, contacts, folder):
        ends = np.cumsum([0] + [len(solid.Faces) for solid in shape.Solids]).tolist()
        outside = {f"outside{number}": [f"Face{face + 1}" for face in range(ends[number - 1], ends[number])]
                   for number in range(1, len(ends))}
        mesh = mq.triangulate(shape, chord_height=0.02, imprint=True, patches=outside)
        path = os.path.join(folder, "regions")
        mesh.write(path + ".obj", interfaces="sheet")
        points, found, name = [], {}, None
        with open(path + ".obj", encoding="utf-8") as stream:
            for words in map(str.split, stream):
                if words[0] == "v":
                    points.append(tuple(map(float, words[1:])))
                elif words[0] == "g":
                    name = words[1]
                elif words[0] == "f":
                    found.setdefault(name, []).append([int(word) - 1 for word in words[1:]])
        self.assertEqual(len(set(points)), len(points))
        sheets = {f"Solid{a}_and_Solid{b}": (a, b) for a, b in contacts}
        self.assertEqual(set(found), {*outside, *sheets})
        self.assertEqual(sum(map(len, found.values())), len(mesh.triangles) - (mesh.triangle_opposite >= 0).sum() // 2)
        points = np.array(points)
        for number, solid in enumerate(shape.Solids, 1):
            around = [found[f"outside{number}"]]
            around += [np.array(found[sheet])[:, ::1 if number == a else -1] for sheet, (a, b) in sheets.items()
                       if number in (a, b)]
            around = np.concatenate(around)
            edges = set(map(tuple, around[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2).tolist()))
            self.assertEqual(len(edges), 3 * len(around))
            self.assertEqual(edges, {(b, a) for a, b in edges})
            corners = points[around]
            volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
            self.assertAlmostEqual(volume / solid.Volume, 1, 1)
        mesh.write(path + ".fms", interfaces="sheet")
        with open(path + ".fms", encoding="utf-8") as stream:
            lines = stream.read().splitlines()
        self.assertEqual(int(lines[len(found) + 3]), len(points))
        for suffix in (".msh", ".vtu", ".stl", ".unv"):
            mesh.write(path + suffix, interfaces="sheet")
            self.assertGreater(os.path.getsize(path + suffix), 0)

    def test_on_the_command_line(self):
        for words, interfaces in (([], False), (["--interfaces"], True), (["--interfaces", "sheet"], "sheet"),
                                  (["--interfaces=sheet"], "sheet")):
            found = parser.parse(["triangulate", "--imprint", *words, "part.step", "-o", "part.msh"])
            self.assertEqual((found.input, found.interfaces), ("part.step", interfaces))

    def test_an_odd_choice_of_interfaces_is_refused(self):
        with self.assertRaisesRegex(mq.InvalidInput, "interfaces = 'one'.*'sheet'"):
            mq.triangulate(Part.makeBox(1, 1, 1)).write("box.stl", interfaces="one")

    def test_each_solid_alone_is_closed(self):
        shape = assembly()
        mesh = mq.triangulate(shape, chord_height=0.02, imprint=True, patch_rest="all")
        for number, solid in enumerate(shape.Solids):
            part = mesh.of_solid(number)
            self.assertTrue(part.report.closed and part.report.manifold)
            self.assertAlmostEqual(part.report.volume / solid.Volume, 1, 1)
            self.assertEqual(part.patches, ("all",))
        with self.assertRaisesRegex(mq.InvalidInput, "solid 8"):
            mesh.of_solid(8)

    def test_groups_of_a_fem_mesh_have_both_names(self):
        shape = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, Vector(0, 0, 10))])
        mesh = mq.curve(shape, volume=True, chord_height=0.1, imprint=True)
        fem = mesh.to_fem_mesh(groups=True)
        groups = {fem.getGroupName(group): sorted(fem.getGroupElements(group)) for group in fem.Groups}
        self.assertEqual(groups["Face6"], groups["Face11"])  # the top of the lower box is the bottom of the upper one
        self.assertEqual(sum(name.startswith("Face") for name in groups), 12)

    def test_parts_of_faces_are_physical_groups(self):
        mesh = mq.triangulate(assembly(), chord_height=0.1, imprint=True)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "regions.msh")
            mesh.write(path, interfaces=True)
            with open(path, encoding="utf-8") as stream:
                text = stream.read()
        for a, b in CONTACTS:
            self.assertIn(f'"Solid{a + 1}_to_Solid{b + 1}"', text)
            self.assertIn(f'"Solid{b + 1}_to_Solid{a + 1}"', text)

    def test_a_solid_inside_of_another_is_no_contact(self):
        """It touches the top of the outer one from inside: they overlap."""
        shape = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(4, 4, 4, Vector(3, 3, 6))])
        mesh = mq.triangulate(shape, imprint=True, patches={"top": ["Face6"]}, patch_rest="rest")
        self.check(shape, mesh)
        self.assertEqual(mesh.report.contacts, [])
        self.assertTrue(any("they overlap there" in note for note in mesh.report.notes), mesh.report.notes)
        twice = Part.makeCompound([Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1)])
        self.assertEqual(set(mq.triangulate(twice, imprint=True).triangle_solid.tolist()), {0, 1})

    def test_spheres_with_other_seams(self):
        """The seam of one lies inside of the face that both share."""
        ball, cavity = Part.makeSphere(5), Part.makeSphere(5)
        ball.rotate(Vector(), Vector(1, 0, 0), 90)
        block = Part.makeBox(40, 40, 40, Vector(-20, -20, -20))
        shape = Part.makeCompound([ball, block.cut(cavity), Part.makeBox(5, 5, 5, Vector(20, 0, 0))])
        mesh = mq.triangulate(shape, chord_height=0.1, imprint=True)
        self.check(shape, mesh)
        self.assertTrue(mesh.report.closed)
        self.assertEqual([(a, b) for a, b, *_ in mesh.report.contacts], [(0, 1), (1, 2)])
        self.assertAlmostEqual(mesh.report.contacts[0][3] / (100 * np.pi), 1, 1)
        self.assertFalse([note for note in mesh.report.notes if "belongs to no face" in note])

    def test_certificates_of_curved_meshes(self):
        """Solids that share nodes are each manifold."""
        document = FreeCAD.newDocument("Contacts")
        self.addCleanup(FreeCAD.closeDocument, "Contacts")
        holder = document.addObject("Part::Feature", "Assembly")
        holder.Shape = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(5, 5, 5, Vector(10, 2, 2))])
        obj = mq.add_curved_mesh(holder, order=2, volume=True, imprint=True)
        self.assertEqual(obj.Certificate, "met")
        self.assertTrue(obj.Closed and obj.Manifold)
