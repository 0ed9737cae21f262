# SPDX-License-Identifier: LGPL-2.1-or-later
"""certify, saved certificates and verify: the public API and the command line."""

import json
import os

import FreeCAD
import helpers
import numpy as np
import Part
from test_cli import run

import MeshQuality as mq
from MeshQuality.core.elements import kinds
from MeshQuality.core.elements.assembly import Content, ElementBlock
from MeshQuality.core.meshes.element_mesh import ElementMesh
from MeshQuality.core.verify import verifier

UNIT = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], dtype=float)


def mesh_of(nodes, *blocks):
    """An ElementMesh of [(kind, rows)]."""
    made = []
    for kind, rows in blocks:
        rows = np.array(rows, dtype=np.int32)
        none = np.full(len(rows), -1, dtype=np.int32)
        made.append(ElementBlock(kind, kinds.order_of(kind, rows.shape[1]), rows, none, none.copy()))
    return ElementMesh(Content(np.array(nodes, dtype=float), tuple(made), {}, ()))


def curved_file(folder, order=2, move=None, name="mesh.msh2", radius=5.0):
    """The path of a file with tetrahedra of a sphere, and the mesh in it; `move` has the distance of one middle node."""
    mesh = mq.curve(Part.makeSphere(radius), order=order, volume=True, chord_height_relative=0.05)
    path = os.path.join(folder, name)
    mesh.write(path)
    if move:
        node = int(mesh.tetrahedra[0, 4])
        with open(path, encoding="ascii") as stream:
            lines = stream.read().split("\n")
        start = lines.index("$Nodes") + 2
        number, x, y, z = lines[start + node].split()
        lines[start + node] = " ".join([number, repr(float(x) + move), y, z])
        with open(path, "w", encoding="ascii") as stream:
            stream.write("\n".join(lines))
    return path, mesh


class Certify(helpers.DocumentTest):
    def test_valid_meshes_of_every_order(self):
        for order in range(1, 5):
            path, mesh = curved_file(self.folder, order)
            certificate = mq.certify(path, Part.makeSphere(5))
            self.assertEqual(certificate.elements, {"tetrahedron": len(mesh.elements)})
            self.assertEqual((certificate.invalid, certificate.folded_on_cad), (0, 0), str(certificate))
            self.assertTrue(certificate.conforming and certificate.oriented)
            self.assertGreater(certificate.min_distortion, 0.0)
            self.assertEqual(len(certificate.triangle_deviation), len(mesh.triangles))
            self.assertAlmostEqual(certificate.max_deviation, mesh.report.max_deviation, delta=1e-3)

    def test_a_moved_middle_node_folds_tetrahedra(self):
        path, mesh = curved_file(self.folder, move=3.0)
        certificate = mq.certify(path)
        around = np.flatnonzero((mesh.tetrahedra == mesh.tetrahedra[0, 4]).any(axis=1))
        self.assertGreater(certificate.folded, 0)
        self.assertEqual(certificate.inverted, 0)
        for said in certificate.invalid_elements:
            self.assertIn(int(said.split()[1]), around)
            self.assertIn("folded at (", said)
        self.assertLess(certificate.min_distortion, 0.0)

    def test_inverted_numbering(self):
        certificate = mq.certify(mesh_of(UNIT, ("tetrahedron", [[0, 2, 1, 3], [1, 2, 3, 4]])))
        self.assertEqual((certificate.invalid, certificate.inverted, certificate.folded), (1, 1, 0))
        self.assertIn("tetrahedron 0 numbered the wrong way round", certificate.invalid_elements[0])
        self.assertFalse(certificate.oriented)
        self.assertTrue(certificate.conforming)

    def test_three_tetrahedra_at_a_face_do_not_conform(self):
        nodes = [*UNIT, [2, 2, 2]]
        certificate = mq.certify(mesh_of(nodes, ("tetrahedron", [[0, 1, 2, 3], [1, 2, 3, 4], [1, 2, 3, 5]])))
        self.assertEqual(certificate.invalid, 0)
        self.assertFalse(certificate.conforming)

    def test_hanging_faces_do_not_conform(self):
        """One tetrahedron on a face, two on its halves: their node lies on an edge of the first."""
        nodes = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0.5, 0.5, 0], [0, 0, -1]]
        certificate = mq.certify(mesh_of(nodes, ("tetrahedron", [[0, 1, 2, 3], [0, 4, 1, 5], [0, 2, 4, 5]])))
        self.assertEqual(certificate.invalid, 0, str(certificate))
        self.assertFalse(certificate.conforming)

    def test_the_solids_of_an_assembly(self):
        boxes = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(5, 5, 5, helpers.FreeCAD.Vector(10, 2, 2))])
        path = os.path.join(self.folder, "boxes.msh")
        mq.curve(boxes, order=2, volume=True, imprint=True).write(path)
        certificate = mq.certify(path, boxes)
        self.assertEqual(certificate.invalid, 0)
        self.assertIn("triangles between solids", certificate.notes[-1])

    def test_lines_alone_are_refused(self):
        with self.assertRaisesRegex(mq.InvalidInput, "lines only"):
            mq.certify(mesh_of(UNIT, ("line", [[0, 1]])))


class Saved(helpers.DocumentTest):
    def saved(self, **how):
        mesh, _ = curved_file(self.folder, **how)
        path = os.path.join(self.folder, "mesh.json")
        mq.certify(mesh).save(path)
        return mesh, path

    def change(self, path, change):
        with open(path, encoding="ascii") as stream:
            content = json.load(stream)
        change(content)
        with open(path, "w", encoding="ascii") as stream:
            json.dump(content, stream)

    def test_true_certificates_hold(self):
        for how in ({}, {"order": 1}, {"order": 3}, {"move": 3.0}, {"name": "mesh.vtu"}):
            mesh, path = self.saved(**how)
            found = mq.verify(path)
            self.assertTrue(found.holds, f"{how}: {found.faults}")
            self.assertEqual(found.shown, found.elements)
            os.remove(mesh)

    def test_every_kind_and_order_holds(self):
        """The verifier and the core, which share no code, agree on random elements."""
        random = np.random.default_rng(11)
        for kind in ("triangle", "quadrilateral", "tetrahedron", "prism", "pyramid", "hexahedron"):
            counts = [kinds.count_of(kind, order) for order in range(1, 4)]
            counts += [kinds.count_of(kind, 2, serendipity=True)] if kind in kinds._SERENDIPITY else []
            for count in counts:
                order = kinds.order_of(kind, count)
                shift = random.uniform(-1, 1, (30, count, 3)) * np.linspace(0.02, 0.4, 30)[:, None, None] / order**2
                if kinds.DIMENSION[kind] == 2:
                    shift[:, :, 2] = 0
                apart = 4.0 * np.arange(30)[:, None, None]  # whether they cross is another question, which takes long where all do
                nodes = (kinds.places(kind, count)[None] + shift + apart).reshape(-1, 3)
                rows = np.arange(len(nodes)).reshape(30, count)
                low = np.concatenate(mq.certify(mesh_of(nodes, (kind, rows))).distortion)
                J, distortion = verifier.examine(kind, order, nodes, rows)
                np.testing.assert_array_equal(J == verifier.POSITIVE, low > 0, f"{kind} {count}")
                self.assertTrue((low <= distortion + 1e-9).all(), f"{kind} {count}")
                self.assertGreater((J == verifier.POSITIVE).sum(), 3, f"{kind} {count}")

    def test_elements_without_volume_touch_zero(self):
        flat = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
        J, _ = verifier.examine("tetrahedron", 1, np.array(flat, dtype=float), np.array([[0, 1, 2, 3]]))
        self.assertEqual(J.tolist(), [verifier.TOUCHING])

    def test_a_moved_node(self):
        _, path = self.saved()
        curved_file(self.folder, move=3.0)
        found = mq.verify(path)
        self.assertFalse(found.holds)
        self.assertIn("is not the file that was certified: its SHA-256 is another one", found.faults[0])
        self.assertTrue(any("is certified valid, but there is a point with J <= 0" in fault for fault in found.faults),
                        found.faults)

    def test_another_mesh(self):
        _, path = self.saved()
        other = mq.curve(Part.makeBox(1, 2, 3), order=2, volume=True)
        other.write(os.path.join(self.folder, "other.msh"))
        found = mq.verify(path, mesh=os.path.join(self.folder, "other.msh"))
        self.assertIn("SHA-256", found.faults[0])
        self.assertIn("the mesh has other elements than the certificate", found.faults[1])

    def test_changed_certificates(self):
        _, path = self.saved(move=3.0)
        with open(path, encoding="ascii") as stream:
            folded = json.load(stream)["proven"]["folded"]

        def claim_valid(content):
            content["proven"].update(invalid=0, folded=0)
            content["blocks"][0]["folded"] = []

        cases = [(lambda content: content["proven"].update(invalid=0), f"says invalid = 0, but lists {folded} such elements"),
                 (claim_valid, "is certified valid, but there is a point with J <= 0"),
                 (lambda content: content["blocks"][0]["folded"].append(0 if 0 not in content["blocks"][0]["folded"] else 1),
                  "says folded"),
                 (lambda content: content["proven"].update(min_distortion=0.9), "says min_distortion = 0.9"),
                 (lambda content: content["proven"].update(conforming=False), "says conforming = False, but it is True"),
                 (lambda content: content["mesh"].update(sha256="0" * 64), "its SHA-256 is another one")]
        for change, words in cases:
            with open(path, "rb") as stream:
                whole = stream.read()
            self.change(path, change)
            found = mq.verify(path)
            self.assertTrue(any(words in fault for fault in found.faults), f"{words}: {found.faults}")
            with open(path, "wb") as stream:
                stream.write(whole)

    def test_a_better_bound_than_there_can_be(self):
        _, path = self.saved()
        self.change(path, lambda content: content["blocks"][0]["distortion"].__setitem__(0, 0.9999))
        self.assertIn("tetrahedron 0 is certified with a better bound of distortion", mq.verify(path).faults[0])

    def test_a_valid_element_that_is_called_folded(self):
        _, path = self.saved()

        def call_folded(content):
            content["blocks"][0]["folded"] = [7]
            content["proven"].update(invalid=1, folded=1)

        self.change(path, call_folded)
        self.assertEqual(mq.verify(path).faults,
                         ["tetrahedron 7 is certified folded, but no point with J <= 0 was found",
                          "tetrahedron 7 is certified not valid, but with a bound of distortion above 0"])

    def test_the_cad_file_is_compared(self):
        mesh, _ = curved_file(self.folder)
        cad, path = os.path.join(self.folder, "ball.brep"), os.path.join(self.folder, "mesh.json")
        Part.makeSphere(5).exportBrep(cad)
        mq.certify(mesh, Part.makeSphere(5)).save(path, cad=cad)
        self.assertTrue(mq.verify(path).holds)
        Part.makeSphere(6).exportBrep(cad)
        self.assertIn("is not the one that was measured against", mq.verify(path).faults[0])
        os.remove(cad)
        self.assertTrue(mq.verify(path).holds)
        self.assertIn("is not there", mq.verify(path).notes[0])

    def test_errors(self):
        certificate = mq.certify(mesh_of(UNIT, ("tetrahedron", [[0, 1, 2, 3]])))
        with self.assertRaisesRegex(mq.InvalidInput, "give certify the path of one"):
            certificate.save(os.path.join(self.folder, "a.json"))
        mesh, path = self.saved()
        with self.assertRaisesRegex(mq.IoError, "no folder"):
            mq.certify(mesh).save(os.path.join(self.folder, "none", "a.json"))
        for text, words in (("", "it is not JSON"), ("[]", "no certificate"), ('{"format": "other"}', "no certificate"),
                            ('{"format": "MeshQuality mesh certificate", "version": 99}', "version 99"),
                            ('{"format": "MeshQuality mesh certificate", "version": 1}', "'mesh' does not name a file")):
            with open(path, "w", encoding="ascii") as stream:
                stream.write(text)
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mq.verify(path)
        with self.assertRaisesRegex(mq.IoError, "cannot read"):
            mq.verify(os.path.join(self.folder, "none.json"))

    def test_damaged_certificates_raise_errors_of_ours(self):
        _, path = self.saved(move=3.0)
        with open(path, encoding="ascii") as stream:
            whole = json.load(stream)
        damaged = [(part, value) for part in ("mesh", "cad", "proven", "blocks", "options")
                   for value in (3, "x", [], {}, [None], [{}], None) if (part, value) != ("cad", None)]
        for part, value in damaged:
            with open(path, "w", encoding="ascii") as stream:
                json.dump({**whole, part: value}, stream)
            try:
                self.assertFalse(mq.verify(path).holds, f"{part} {value}")
            except mq.InvalidInput as error:
                self.assertIn("certify the mesh again", str(error))


def plate_with_square_hole():
    """(a square sheet with a round bore, its mesh with a square hole whose corners are on the bore)."""
    V = FreeCAD.Vector
    face = Part.makePlane(10, 10, V(-5, -5, 0)).cut(Part.makeCylinder(3, 2, V(0, 0, -1))).Faces[0]
    nodes = np.array([[-5, -5, 0], [5, -5, 0], [5, 5, 0], [-5, 5, 0], [0, -3, 0], [3, 0, 0], [0, 3, 0], [-3, 0, 0]], dtype=float)
    rows = [[i, (i + 1) % 4, 4 + i] for i in range(4)] + [[(i + 1) % 4, 4 + (i + 1) % 4, 4 + i] for i in range(4)]
    return face, mesh_of(nodes, ("triangle", rows))


class Distances(helpers.DocumentTest):
    """Of meshes from the trimmed faces of their shapes: the same in the certificate and the verifier."""

    def test_a_square_hole_in_a_round_bore(self):
        face, mesh = plate_with_square_hole()
        found = mq.certify(mesh, face)
        self.assertAlmostEqual(found.max_deviation, 3 - 3 / np.sqrt(2), places=6)
        self.assertLess(found.cad_deviation, 1e-9)

    def certified(self, shape, **how):
        mesh, cad, path = (os.path.join(self.folder, name) for name in ("mesh.msh", "part.brep", "mesh.json"))
        shape.exportBrep(cad)
        mq.curve(shape, **how).write(mesh)
        mq.certify(mesh, Part.read(cad)).save(path, cad=cad)
        return path

    def test_honest_certificates_of_bores_and_fillets_hold(self):
        V = FreeCAD.Vector
        bored, box = Part.makeBox(20, 20, 10).cut(Part.makeCylinder(4, 10, V(10, 10, 0))), Part.makeBox(9, 9, 9)
        for shape, how in ((bored, {"order": 2, "volume": True}), (Part.makeCone(5, 2, 8), {"order": 3}),
                           (box.makeFillet(2, box.Edges[:3]), {"order": 2})):
            path = self.certified(shape, **how)
            found = mq.verify(path)
            self.assertTrue(found.holds, found.faults)

    def test_no_distance_can_be_edited_away(self):
        path = self.certified(Part.makeCylinder(5, 10), order=2)
        with open(path, encoding="ascii") as stream:
            whole = stream.read()
        proven = json.loads(whole)["proven"]
        for edit in ({"cad_deviation": proven["cad_deviation"] / 2}, {"cad_spacing": 1e-9}, {"folded_on_cad": 3},
                     {"folded_on_cad": None}, {"not_on_shape": "it is elsewhere"}, {"max_deviation": None},
                     {"max_deviation": None, "not_on_shape": "it is elsewhere"}, {"cad_deviation": None, "cad_spacing": None}):
            content = json.loads(whole)
            content["proven"].update(edit)
            with open(path, "w", encoding="ascii") as stream:
                json.dump(content, stream)
            self.assertFalse(mq.verify(path).holds, edit)
        for name in ("face_grids", "edge_grids"):
            content = json.loads(whole)
            content["surface"][name].pop()
            with open(path, "w", encoding="ascii") as stream:
                json.dump(content, stream)
            self.assertFalse(mq.verify(path).holds, name)

    def test_what_a_mesh_leaves_out_is_found(self):
        """A mesh of a box is certified of a box with a boss: the true certificate says how far that is."""
        boss = Part.makeBox(10, 10, 5).fuse(Part.makeCylinder(2, 4, FreeCAD.Vector(5, 5, 5)))
        mesh, cad, path = (os.path.join(self.folder, name) for name in ("mesh.msh", "part.brep", "mesh.json"))
        boss.exportBrep(cad)
        mq.curve(Part.makeBox(10, 10, 5), order=1).write(mesh)
        certificate = mq.certify(mesh, Part.read(cad))
        self.assertAlmostEqual(certificate.cad_deviation, 4.0, delta=1e-6)
        certificate.save(path, cad=cad)
        self.assertEqual([fault for fault in mq.verify(path).faults if "cad_deviation" in fault], [])
        with open(path, encoding="ascii") as stream:
            content = json.load(stream)
        content["proven"]["cad_deviation"] = 2.0
        with open(path, "w", encoding="ascii") as stream:
            json.dump(content, stream)
        self.assertTrue(any("cad_deviation = 2.0" in fault for fault in mq.verify(path).faults))


class Programs(helpers.DocumentTest):
    """bin/meshquality certify and verify."""

    def test_certify(self):
        good, _ = curved_file(self.folder)
        folded, _ = curved_file(self.folder, move=3.0, name="folded.msh2")
        cad = os.path.join(self.folder, "ball.step")
        Part.makeSphere(5).exportStep(cad)
        status, said, lines = run("certify", good, "--shape", cad, "--json", "--strict")
        self.assertEqual(status, 0, lines)
        found = json.loads(said)
        self.assertEqual((found["invalid"], found["verdict"]), (0, "met"))
        self.assertLess(found["max_deviation"], 0.05)
        self.assertIn("no faults were found", lines[-1])
        status, said, _ = run("certify", folded, "--json")
        self.assertEqual(status, 0)
        self.assertGreater(json.loads(said)["invalid"], 0)
        status, said, lines = run("certify", folded, "--strict")
        self.assertEqual(status, 3)
        self.assertIn("folded at", said)
        self.assertIn("not proven valid", lines[-1])

    def test_certificates(self):
        mesh, _ = curved_file(self.folder)
        path = os.path.join(self.folder, "mesh.json")
        self.assertEqual(run("certify", mesh, "--save", path)[0], 0)
        status, said, lines = run("verify", path, "--json")
        self.assertEqual(status, 0, lines)
        self.assertTrue(json.loads(said)["holds"])
        self.assertIn("all of it holds", lines[-1])
        curved_file(self.folder, move=3.0)
        status, said, lines = run("verify", path, "--json")
        self.assertEqual(status, 3)
        self.assertFalse(json.loads(said)["holds"])
        self.assertIn("SHA-256", lines[-1])

    def test_meshes_in_metres(self):
        mesh, path = os.path.join(self.folder, "metres.vtu"), os.path.join(self.folder, "mesh.json")
        cad = os.path.join(self.folder, "ball.step")
        Part.makeSphere(5).exportStep(cad)
        mq.curve(Part.makeSphere(5), volume=True).write(mesh, scale=0.001)
        status, said, lines = run("certify", mesh, "--shape", cad, "--mesh-scale", 1000, "--save", path, "--json", "--strict")
        self.assertEqual(status, 0, lines)
        self.assertLess(json.loads(said)["max_deviation"], 0.05)
        with open(path, encoding="ascii") as stream:
            self.assertEqual(json.load(stream)["options"], {"scale": 1000.0})
        self.assertTrue(mq.verify(path).holds)
        status, said, lines = run("certify", mesh, "--shape", cad, "--json")
        self.assertIn("as if it were in metres: give mesh_scale=1000, on the command line --mesh-scale 1000",
                      json.loads(said)["not_on_shape"])
        out = os.path.join(self.folder, "out.msh")
        status, said, lines = run("curve", cad, "--mesh", mesh, "--mesh-scale", 1000, "-o", out, "--json", "--strict")
        self.assertEqual((status, json.loads(said)["invalid"]), (0, 0), lines)
        self.assertLess(mq.certify(out, Part.makeSphere(5)).max_deviation, 0.05)
        with self.assertRaisesRegex(mq.InvalidInput, "mesh_scale= is for a mesh that is given by the path"):
            mq.certify(mq.read_mesh(mesh), mesh_scale=1000)
        with self.assertRaisesRegex(mq.InvalidInput, "mesh_scale = 0 is not possible.*1000 for metres"):
            mq.certify(mesh, mesh_scale=0)

    def test_bad_usage(self):
        mesh, _ = curved_file(self.folder)
        damaged = os.path.join(self.folder, "damaged.json")
        with open(damaged, "w", encoding="ascii") as stream:
            stream.write("{")
        for arguments, words in ((("certify", mesh, "--save", "a.txt"), "a certificate is .json"),
                                 (("certify", mesh, "--save", "/nowhere/a.json"), "cannot be written"),
                                 (("certify", "-", "--input-format", "msh", "--save", "a.json"), "--save is for"),
                                 (("certify", os.path.join(self.folder, "none.msh")), "there is no file"),
                                 (("certify", mesh, "--mesh-scale", "-1"), "it must be greater than 0"),
                                 (("verify", mesh), "no known extension"), (("verify", damaged), "it is not JSON"),
                                 (("verify", "-", "--input-format", "json"), "name the mesh with --mesh")):
            status, _, lines = run(*arguments)
            self.assertEqual(status, 2, f"{arguments}: {lines}")
            self.assertIn(words, lines[-1])
