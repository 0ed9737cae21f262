# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects stand where the document has them: in containers, groups, bodies, links and link arrays."""

import os
import subprocess
import unittest
from unittest import mock

import FreeCAD
import helpers
import numpy as np
import Part
from FreeCAD import Placement, Rotation, Vector

import MeshQuality as mq
from MeshQuality.cli import input_files
from MeshQuality.core.sources import convert, frames

TURNED = Placement(Vector(20, -30, 40), Rotation(Vector(1, 2, 3), 50))
ASSEMBLY = os.path.join(os.environ.get("MESHQUALITY_DATA", os.path.join(helpers.ROOT, "..", "shared", "data")),
                        "cad", "as1-oc-214.stp")
COARSE = {"chord_height": 1.0}


def box_of_surface(shape, deviation=0.002):
    """Corners of the box of a shape by OpenCASCADE's own mesh of it, to that deviation in mm, as six numbers."""
    points, _ = shape.copy().tessellate(deviation)
    return box_of(np.array([tuple(p) for p in points]))


def box_of(points):
    """Corners of the box of points, or of a Part.Shape, as six numbers."""
    if isinstance(points, Part.Shape):
        # That of a copy: the box of a turned location encloses a turned box.
        points = np.array([tuple(v.Point) for v in points.copy().Vertexes])
    return np.concatenate((points.min(axis=0), points.max(axis=0)))


def box_in_document(obj):
    """The box of the mesh of an object where FreeCAD itself has it."""
    mesh = obj.Mesh.copy()
    mesh.Placement = obj.getGlobalPlacement()
    return box_of(helpers.points_and_facets(mesh)[0])


class PlacementTest(helpers.DocumentTest):
    """A test with containers."""

    def add(self, kind, name, placement=None, **values):
        obj = self.document.addObject(kind, name)
        if placement is not None:
            obj.Placement = placement
        for key, value in values.items():
            setattr(obj, key, value)
        return obj

    def part(self, name, placement, *objects):
        part = self.add("App::Part", name, placement)
        part.addObjects(list(objects))
        return part

    def assert_same_box(self, found, wanted, tolerance=1e-3):
        np.testing.assert_allclose(found, wanted, atol=tolerance)


class Sources(PlacementTest):
    """What may be meshed, and where it stands by FreeCAD's own path from the outermost object."""

    def sources(self):
        """{name: (source, its shape in the document)}"""
        box = self.box("B", Length=1, Width=2, Height=3)
        inner = self.part("Inner", Placement(Vector(0, 7, 0), Rotation(10, 20, 30)), box)
        outer = self.part("Outer", TURNED, inner)
        grouped = self.box("Grouped", Length=3)
        group = self.document.addObject("App::DocumentObjectGroup", "Group")
        group.addObject(grouped)
        self.part("WithGroup", TURNED, group)
        body = self.document.addObject("PartDesign::Body", "Body")
        feature = body.newObject("PartDesign::AdditiveBox", "Feature")
        body.Placement.Base = Vector(0, 50, 0)
        self.part("WithBody", TURNED, body)
        link = self.add("App::Link", "Link", LinkedObject=inner)
        link.Placement.Base = Vector(100, 0, 0)
        nested = self.add("App::Link", "Nested", LinkedObject=box)
        nested.Placement.Base = Vector(0, 0, 200)
        self.part("WithLink", TURNED, nested)
        array = self.add("App::Link", "Array", LinkedObject=box, ElementCount=2)
        self.document.recompute()
        array.ElementList[1].Placement.Base = Vector(0, 300, 0)
        array.Placement.Base = Vector(0, 0, 5)
        lent = self.box("Lent", Length=4)
        linked = self.add("App::LinkGroup", "LinkGroup", ElementList=[lent])
        linked.Placement = TURNED
        self.document.recompute()
        get = self.document.getObject
        return {
            "box in parts": (box, Part.getShape(outer, "Inner.B.")),
            "part in a part": (inner, Part.getShape(outer, "Inner.")),
            "box in a group in a part": (grouped, Part.getShape(get("WithGroup"), "Grouped.")),
            "body in a part": (body, Part.getShape(get("WithBody"), "Body.")),
            "feature of a body in a part": (feature, Part.getShape(get("WithBody"), "Body.Feature.")),
            "link in a part": (nested, Part.getShape(get("WithLink"), "Nested.")),
            "element of an array": (array.ElementList[1], Part.getShape(array, "1.")),
            "box in a link group": (lent, Part.getShape(linked, "Lent.")),
            "box in a linked part": ((link, "B."), Part.getShape(link, "B.")),
            "face in parts": ((box, "Face6"), Part.getShape(outer, "Inner.B.Face6", needSubElement=True)),
        }

    def test_shapes_and_meshes(self):
        for name, (source, wanted) in self.sources().items():
            with self.subTest(name):
                self.assert_same_box(box_of(convert.shape_of(source)), box_of(wanted), 1e-9)
                mesh = mq.triangulate(source)
                self.assert_same_box(box_of(mesh.vertices + mesh.origin), box_of(wanted))
                self.assertLess(mq.quality(mesh, source).max_chord_height, 1e-4)

    def test_document_objects(self):
        for name, (source, wanted) in self.sources().items():
            with self.subTest(name):
                obj = mq.add_quality_mesh(source)
                self.assert_same_box(box_in_document(obj), box_of(wanted))
                self.assert_same_box(box_of(convert.arrays_of_mesh(obj)[0]), box_of(wanted))
                curved = mq.add_curved_mesh(source)
                self.assert_same_box(box_in_document(curved), box_of(wanted))
                self.assert_same_box(box_of(mq.CurvedMesh.of(curved).nodes), box_of(wanted))

    def test_what_is_selected_is_named_by_itself_where_it_can_be(self):
        self.sources()
        get = self.document.getObject

        class Selected:
            pass

        for root, path, wanted in (
                ("Outer", "Inner.B.Face6", (get("B"), "Face6")), ("Outer", "Inner.", (get("Inner"), "")),
                ("WithGroup", "Group.Grouped.Edge1", (get("Grouped"), "Edge1")),
                ("WithBody", "Body.Feature.Face1", (get("Body"), "Face1")),
                ("WithLink", "Nested.Face1", (get("Nested"), "Face1")),
                ("Array", "1.Face1", (get("Array").ElementList[1], "Face1")),
                ("Link", "B.Vertex2", ((get("Link"), "B."), "Vertex2")), ("Link", "", (get("Link"), ""))):
            selected = Selected()
            selected.Object, selected.SubElementNames = get(root), (path,) if path else ()
            self.assertEqual(frames.paths_of_selection(selected), [wanted], (root, path))

    def test_a_source_that_a_path_no_longer_leads_to(self):
        box = self.box("B")
        part = self.part("Part", TURNED, box)
        link = self.add("App::Link", "Link", LinkedObject=part)
        self.document.recompute()
        with self.assertRaisesRegex(mq.InvalidInput, "Link.* has nothing at Gone"):
            mq.add_quality_mesh((link, "Gone."))

    def test_scaled_containers_are_refused_by_name(self):
        array = self.add("App::Link", "Scaled", LinkedObject=self.box("B"), ElementCount=2)
        array.Scale = 2.0
        self.document.recompute()
        with self.assertRaisesRegex(mq.InvalidInput, "lies in 'Scaled', which is scaled: choose 'Scaled' itself"):
            mq.triangulate(array.ElementList[1])
        self.assert_same_box(box_of(mq.triangulate(array).vertices), box_of(Part.getShape(array)))


class Following(PlacementTest):
    """The mesh lies on its source, whatever happens to the containers around them."""

    def check(self, obj, source):
        self.assert_same_box(box_in_document(obj), box_of(convert.shape_of(source)))

    def setUp(self):
        super().setUp()
        self.source = self.box("B", Length=1, Width=2, Height=3)
        self.home = self.part("Home", TURNED, self.source)
        self.document.recompute()

    def test_the_container_of_the_source_moves(self):
        for add in (mq.add_quality_mesh, mq.add_curved_mesh):
            obj = add(self.source)
            fingerprint = obj.Fingerprint
            self.home.Placement = Placement(Vector(1, 2, 3), Rotation(70, 0, 10))
            self.check(obj, self.source)  # at once
            self.document.recompute()
            self.check(obj, self.source)
            self.assertEqual(obj.Fingerprint, fingerprint)  # not meshed anew
            self.assertEqual(obj.Certificate, mq.update(obj) or obj.Certificate)
            if add is mq.add_curved_mesh:
                self.assert_same_box(box_of(mq.CurvedMesh.of(obj).nodes), box_of(convert.shape_of(self.source)))

    def test_the_source_is_put_into_another_container(self):
        obj = mq.add_quality_mesh(self.source)
        other = self.part("Other", Placement(Vector(0, 0, 500), Rotation(0, 0, 45)), self.source)
        self.check(obj, self.source)
        self.document.recompute()
        self.check(obj, self.source)
        other.removeObject(self.source)
        self.document.recompute()
        self.check(obj, self.source)
        self.assert_same_box(box_in_document(obj), (0, 0, 0, 1, 2, 3))

    def test_the_mesh_is_put_into_its_own_source(self):
        """The two would wait for each other for ever: FreeCAD calls that a graph with cycles."""
        outer = self.part("Outer", TURNED, self.home)
        inner = self.part("Inner", Placement())
        self.home.addObject(inner)
        group = self.add("App::DocumentObjectGroup", "Group")
        link = self.add("App::Link", "Link", LinkedObject=self.home)
        self.document.recompute()
        for sources in ([self.home], [outer], [link], [self.home, self.box("Beside")]):
            obj = mq.add_boolean(sources) if len(sources) > 1 else mq.add_quality_mesh(sources[0])
            for put in (lambda: self.home.addObject(obj), lambda: setattr(inner, "Group", [obj]),
                        lambda: setattr(self.home, "Group", [*self.home.Group, obj])):
                said = []
                with mock.patch.object(FreeCAD, "Console", mock.Mock(PrintError=said.append)):
                    put()
                self.assertEqual(len(said), 1)
                self.assertRegex(said[0], rf"^{obj.Label}: it is made of '(Outer|Home|Inner)' and cannot lie in that, as each "
                                          "would wait for the other: it was taken out again, and follows from outside, too\n$")
                for container in (outer, self.home, inner):
                    self.assertNotIn(obj, [*container.Group, *container.OutList])
                self.assertIsNone(obj.getParentGeoFeatureGroup())
            self.check_updates(obj)
            group.addObject(obj)  # beside it
            self.assertIn(obj, group.Group)
            self.check_updates(obj)

    def check_updates(self, obj):
        """A change of the box reaches the mesh in one recompute, and leaves nothing touched."""
        size, fingerprint = self.source.Length.Value, obj.Fingerprint
        self.source.Length = 2.0 * size
        self.document.recompute()
        self.assertNotEqual(obj.Fingerprint, fingerprint)
        self.assertEqual(obj.State, ["Up-to-date"])
        self.source.Length = size
        self.document.recompute()

    def test_a_source_that_holds_the_mesh(self):
        obj = mq.add_quality_mesh(self.source)
        self.home.addObject(obj)
        self.assertIn(obj, self.home.Group)  # of what is in there, too: no cycle
        held = obj.Fingerprint
        obj.Source = self.home
        obj.recompute()
        self.assertRegex(obj.Status, "^failed: it is made of 'Home' and cannot lie in that")
        self.assertEqual(obj.Fingerprint, held)
        self.home.removeObject(obj)
        obj.touch()
        self.document.recompute()
        self.assertEqual(obj.Status, "up to date")

    def test_the_mesh_is_put_into_a_container(self):
        for container in (self.home, self.part("Other", Placement(Vector(0, 0, 500), Rotation(0, 0, 45)))):
            obj = mq.add_quality_mesh(self.source)
            container.addObject(obj)
            self.check(obj, self.source)
            self.document.recompute()
            self.check(obj, self.source)
            container.Placement.Base = Vector(-70, 0, 0)
            self.document.recompute()
            self.check(obj, self.source)
            self.assertLess(mq.quality(obj, self.source).max_chord_height, 1e-4)

    def test_an_expression_moves_the_container(self):
        obj = mq.add_quality_mesh(self.source)
        self.home.setExpression("Placement.Base.x", "B.Height * 100")
        self.document.recompute()
        self.check(obj, self.source)
        self.assertAlmostEqual(self.home.Placement.Base.x, 300)
        self.source.Height = 5
        self.document.recompute()
        self.assertAlmostEqual(self.home.Placement.Base.x, 500)
        self.check(obj, self.source)

    def test_undo_of_a_moved_container(self):
        self.document.UndoMode = 1
        obj = mq.add_quality_mesh(self.source)
        before = box_in_document(obj)
        self.document.openTransaction("Move")
        self.home.Placement = Placement()
        self.document.recompute()
        self.document.commitTransaction()
        self.check(obj, self.source)
        self.document.undo()
        self.document.recompute()
        self.assert_same_box(box_in_document(obj), before)
        self.check(obj, self.source)

    def test_saved_and_opened(self):
        obj = mq.add_quality_mesh(self.source)
        self.home.addObject(obj)
        self.document.recompute()
        name = obj.Name
        self.reopen()
        get = self.document.getObject
        self.check(get(name), get("B"))
        get("Home").Placement = Placement()
        self.document.recompute()
        self.check(get(name), get("B"))

    def test_opened_in_a_new_session(self):
        obj = mq.add_quality_mesh(self.source)
        path = os.path.join(self.folder, "saved.FCStd")
        self.document.saveAs(path)
        script = os.path.join(self.folder, "session.py")
        with open(script, "w", encoding="utf-8") as stream:
            stream.write(f"""import FreeCAD, sys
document = FreeCAD.openDocument({path!r})
document.getObject("Home").Placement = FreeCAD.Placement()
document.recompute()
points = document.getObject({obj.Name!r}).Mesh.Topology[0]
least = [min(point[k] for point in points) for k in range(3)]
sys.exit(0 if max(map(abs, least)) < 1e-4 else 3)
""")
        # Documents may load proxies from installed addons only.
        os.makedirs(os.path.join(self.folder, "home", "Mod"))
        os.symlink(helpers.ROOT, os.path.join(self.folder, "home", "Mod", "MeshQuality"))
        done = subprocess.run(["freecadcmd", script], check=False, stdin=subprocess.DEVNULL, timeout=120,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              env={**os.environ, "FREECAD_USER_HOME": os.path.join(self.folder, "home")})
        self.assertEqual(done.returncode, 0)

    def test_an_object_of_an_older_version_is_put_in_its_place(self):
        obj = mq.add_quality_mesh(self.source)
        # These computed in the frame of the container, and knew neither property.
        local = mq.triangulate(convert.own_shape_of(self.source)).to_mesh()
        obj.Mesh = local
        obj.removeProperty("SourceFrame")
        obj.removeProperty("MeshOrigin")
        obj.Proxy.onDocumentRestored(obj)
        obj.touch()
        self.document.recompute()
        self.check(obj, self.source)

    def test_what_was_not_moved_has_the_certified_coordinates(self):
        obj = mq.add_quality_mesh(self.source)
        mesh = mq.triangulate(self.source)
        self.assertTrue(frames.same(obj.Placement, frames.translation(Vector(*mesh.origin))))
        np.testing.assert_array_equal(convert.arrays_of_mesh(obj)[0], mesh.vertices + mesh.origin)


class Booleans(PlacementTest):
    """Operands are joined where they stand."""

    def test_operands_in_different_containers(self):
        first, second = self.box("First"), self.box("Second")
        one = self.part("One", Placement(Vector(100, 0, 0), Rotation()), first)
        self.part("Two", Placement(Vector(105, 5, 5), Rotation()), second)
        self.document.recompute()
        result = mq.boolean(first, second, "intersection")
        self.assertAlmostEqual(result.report.volume, 125.0, delta=1e-3)
        obj = mq.add_boolean(first, second, "intersection")
        self.assertAlmostEqual(obj.Volume.Value, 125.0, delta=1e-3)
        self.assert_same_box(box_in_document(obj), (105, 5, 5, 110, 10, 10))
        one.Placement.Base.x = 103
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 200.0, delta=1e-3)
        self.assert_same_box(box_in_document(obj), (105, 5, 5, 113, 10, 10))

    def test_changes_of_containers_of_one_operand(self):
        first, second = self.box("First"), self.box("Second")
        one, two = self.part("One", Placement(), first), self.part("Two", Placement(Vector(5, 5, 5), Rotation()), second)
        self.document.recompute()
        obj = mq.add_boolean(first, second, "intersection")

        def check(volume):
            self.document.recompute()
            self.assertAlmostEqual(obj.Volume.Value, volume, delta=1e-2)

        check(125.0)
        self.document.openTransaction("Move")
        two.Placement.Base = Vector(2, 0, 0)
        check(800.0)
        self.document.commitTransaction()
        self.document.undo()
        check(125.0)
        two.removeObject(second)
        check(1000.0)
        two.addObject(second)
        check(125.0)
        one.Placement.Base = Vector(5, 0, 0)
        check(250.0)
        one.removeObject(first)
        check(125.0)
        self.document.removeObject(two.Name)
        check(1000.0)

    def test_what_is_made_of_a_mesh_follows_it(self):
        source = self.box("B")
        part = self.part("Part", Placement(Vector(50, 0, 0), Rotation()), source)
        self.document.recompute()
        mesh = mq.add_quality_mesh(source)
        better = mq.add_improved_mesh(mesh)
        joined = mq.add_boolean(mesh, self.box("Other"), "intersection")
        self.assertEqual(joined.Triangles, 0)
        part.removeObject(source)
        self.document.recompute()
        self.assert_same_box(box_in_document(mesh), (0, 0, 0, 10, 10, 10))
        self.assert_same_box(box_in_document(better), (0, 0, 0, 10, 10, 10))
        self.assertAlmostEqual(joined.Volume.Value, 1000.0, delta=1e-2)

    def test_operands_keep_their_triangles_when_all_containers_move(self):
        first, second = self.box("First"), self.box("Second")
        one, two = self.part("One", TURNED, first), self.part("Two", Placement(Vector(3, 3, 3), Rotation()), second)
        outer = self.part("Outer", Placement(), one, two)
        self.document.recompute()
        obj = mq.add_boolean(first, second)
        before = obj.Mesh.Topology[1]
        outer.Placement = Placement(Vector(7, 8, 9), Rotation(10, 20, 30))
        self.document.recompute()
        self.assertEqual(obj.Mesh.Topology[1], before)
        self.assert_same_box(box_in_document(obj), box_of(Part.makeCompound(
            [convert.shape_of(first), convert.shape_of(second)])))

    def test_operands_of_one_container_move_with_it(self):
        first, second = self.box("First"), self.box("Second")
        second.Placement.Base = Vector(5, 5, 5)
        home = self.part("Home", TURNED, first, second)
        self.document.recompute()
        obj = mq.add_boolean(first, second, "intersection")
        self.assertAlmostEqual(obj.Volume.Value, 125.0, delta=1e-2)
        home.Placement = Placement(Vector(1000, 0, 0), Rotation())
        self.document.recompute()
        self.assert_same_box(box_in_document(obj), (1005, 5, 5, 1010, 10, 10))

    def test_an_operand_that_only_a_link_leads_to(self):
        first, second = self.box("First"), self.box("Second")
        part = self.part("Part", Placement(), second)
        link = self.add("App::Link", "Link", LinkedObject=part)
        link.Placement.Base = Vector(5, 5, 5)
        self.document.recompute()
        obj = mq.add_boolean(first, (link, "Second."), "intersection")
        self.assertAlmostEqual(obj.Volume.Value, 125.0, delta=1e-3)
        link.Placement.Base = Vector(9, 5, 5)
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 25.0, delta=1e-3)

    def test_meshes_in_containers(self):
        first, second = self.box("First"), self.box("Second")
        meshes = []
        for source, base in ((first, (100, 0, 0)), (second, (105, 5, 5))):
            feature = self.add("Mesh::Feature", "Scan", Mesh=mq.triangulate(source).to_mesh())
            self.part("Of" + source.Name, Placement(Vector(*base), Rotation()), feature)
            meshes.append(feature)
        self.document.recompute()
        obj = mq.add_boolean(*meshes, "intersection")
        self.assertAlmostEqual(obj.Volume.Value, 125.0, delta=1e-3)
        better = mq.add_improved_mesh(meshes[0])
        self.assert_same_box(box_in_document(better), (100, 0, 0, 110, 10, 10))


class ListedAgain(unittest.TestCase):
    """A compound that lists solids, and beside them their shells, faces and edges again, as Gmsh writes
    BREP files: each is there once.
    """

    def setUp(self):
        box, ball = Part.makeBox(10, 10, 10), Part.makeSphere(4, Vector(30, 0, 0))
        self.solids = Part.makeCompound([box, ball])
        self.listed = Part.makeCompound([box, ball, *box.Shells, *ball.Shells, *box.Faces, *ball.Faces,
                                         *box.Edges, *ball.Vertexes])

    def test_meshes(self):
        plain, again = (mq.triangulate(shape) for shape in (self.solids, self.listed))
        self.assertEqual(again.report.components, 2)
        self.assertTrue(again.report.closed and again.report.manifold)
        np.testing.assert_array_equal(again.vertices, plain.vertices)
        np.testing.assert_array_equal(again.triangles, plain.triangles)

    def test_booleans(self):
        cut = mq.boolean(self.listed, Part.makeBox(5, 10, 10), "difference", tolerance=0.004)
        self.assertAlmostEqual(cut.report.volume, self.solids.Volume - 500, delta=0.5)
        self.assertEqual(cut.report.components, 2)

    def test_curved_meshes(self):
        plain, again = (mq.curve(shape, volume=True) for shape in (self.solids, self.listed))
        self.assertEqual(again.report.elements, plain.report.elements)
        self.assertAlmostEqual(again.report.cad_volume, self.solids.Volume, delta=1e-2)
        self.assertLess(again.report.volume_error, 1e-3)

    def test_document_objects(self):
        document = FreeCAD.newDocument("Listed")
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        source = document.addObject("Part::Feature", "Listed")
        source.Shape = self.listed
        obj = mq.add_quality_mesh(source)
        self.assertTrue(obj.AskedClosed and obj.Closed)
        self.assertEqual(mq.quality(obj).components, 2)


class CommandLine(PlacementTest):
    def test_documents_with_containers(self):
        box = self.box("B", Length=1, Width=2, Height=3)
        home = self.part("Home", TURNED, box)
        self.document.recompute()
        path = os.path.join(self.folder, "nested.FCStd")
        self.document.saveAs(path)
        wanted = box_of(Part.getShape(home, "B."))
        self.assert_same_box(box_of(input_files.read_shape(path)), wanted)
        self.assert_same_box(box_of(input_files.read_shape(path, "B")), wanted)


@unittest.skipUnless(os.path.exists(ASSEMBLY), f"there is no {ASSEMBLY}")
class Assembly(PlacementTest):
    """A STEP assembly with its tree of App::Part: 18 bodies, each in its place."""

    def setUp(self):
        super().setUp()
        import Import  # noqa: PLC0415  slow to load

        Import.insert(ASSEMBLY, self.document.Name, merge=False, useLinkGroup=False)
        self.bodies = [obj for obj in self.document.Objects if obj.isDerivedFrom("Part::Feature")]
        self.root, = [obj for obj in self.document.RootObjects if obj.isDerivedFrom("App::Part")]

    def in_document(self, body):
        """The shape by FreeCAD's path from the root."""
        path = next(path for root, path in body.Parents if root == self.root)
        return Part.getShape(self.root, path)

    def test_each_body_is_meshed_measured_curved_and_improved_in_its_place(self):
        self.assertEqual(len(self.bodies), 18)
        for body in self.bodies:
            wanted = self.in_document(body)
            of_body = box_of_surface(wanted, 0.01)
            mesh = mq.add_quality_mesh(body, chord_height=0.005)
            self.assertLess(mq.quality(mesh, body).max_chord_height, 1.001 * 0.005)
            for obj in (mesh, mq.add_curved_mesh(body, chord_height=0.5), mq.add_improved_mesh(mesh)):
                # What is shown of curved elements is flat and has less volume than they have.
                volume = getattr(obj, "EnclosedVolume", None) or obj.Mesh.Volume
                self.assertAlmostEqual(getattr(volume, "Value", volume), wanted.Volume, delta=1e-3 * wanted.Volume)
                self.assert_same_box(box_in_document(obj), of_body, 1e-3 * np.linalg.norm(of_body[3:] - of_body[:3]))

    def test_volumes_of_splines_that_are_lines_are_measured_at_once(self):
        bracket = next(b for b in self.bodies if b.Label == "l-bracket")
        report = mq.curve(self.in_document(bracket), chord_height=0.5).report
        # Integrals along edges that are lines of (u, v) but for rounding were halved in vain for 26 s.
        self.assertLess(report.seconds["measuring the solids"], 5.0)

    def test_bodies_are_joined_and_improved_in_their_places(self):
        rod = next(b for b in self.bodies if b.Label == "rod")
        bracket = next(b for b in self.bodies if b.Label == "l-bracket")
        wanted = self.in_document(rod).fuse(self.in_document(bracket))
        obj = mq.add_boolean(rod, bracket, "union", tolerance=0.02)
        self.assertAlmostEqual(obj.Volume.Value, wanted.Volume, delta=1e-3 * wanted.Volume)
        better = mq.add_improved_mesh(obj)
        self.assert_same_box(box_in_document(better), box_of_surface(wanted), 0.05)
        mesh = mq.add_quality_mesh(bracket)
        self.assertLess(mq.quality(mesh, bracket).max_chord_height,
                        1.01 * 0.003 * max(self.in_document(bracket).BoundBox.XLength, 200))

    def test_the_whole_assembly(self):
        mesh = mq.triangulate(self.root, chord_height_relative=0.0002)
        volume = sum(self.in_document(body).Volume for body in self.bodies)
        self.assertAlmostEqual(mesh.report.volume, volume, delta=1e-3 * volume)
        self.assertEqual(mesh.report.components, 18)


class LinkArrays(PlacementTest):
    def test_an_array_of_a_mesh_is_all_of_its_elements(self):
        feature = self.add("Mesh::Feature", "Scan", Mesh=mq.triangulate(Part.makeBox(1, 1, 1)).to_mesh())
        feature.Placement.Base = Vector(8, 0, 0)
        for shown in (True, False):
            array = self.add("App::Link", "Array", LinkedObject=feature, ShowElement=shown)
            array.ElementCount = 2
            array.Placement.Base = Vector(0, 0, 50)
            self.document.recompute()
            array.PlacementList = [Placement(Vector(0, 0, 0), Rotation()), Placement(Vector(0, 20, 0), Rotation())]
            if shown:
                array.ElementList[1].Placement.Base = Vector(0, 20, 0)
                array.ElementList[0].Placement.Base = Vector(0, 0, 0)
            self.document.recompute()
            points, triangles = convert.arrays_of_mesh(array)
            self.assertEqual(len(triangles), 24)
            self.assert_same_box(box_of(points), (0, 0, 50, 1, 21, 51))
            self.assertEqual(mq.quality(array).components, 2)
