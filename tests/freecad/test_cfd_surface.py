# SPDX-License-Identifier: LGPL-2.1-or-later
"""CFD surfaces: shapes of patches, as CfdOF asks for them; undo, following, files, errors."""

import FreeCAD
import helpers
import Mesh
import MeshPart
import numpy as np
import Part

import MeshQuality as mq


def triangles_of(shape):
    """The triangles by their corners, as MeshPart gives them to CfdOF; sorted."""
    mesh = MeshPart.meshFromShape(shape, LinearDeflection=0.5, Relative=True)
    points = np.array([tuple(point.Vector) for point in mesh.Points], dtype=np.float32)
    return sorted_corners(points[np.array(mesh.Topology[1])])


def sorted_corners(corners):
    """Corners of triangles, the first one least, sorted."""
    turned = []
    for triangle in np.asarray(corners, dtype=np.float32).tolist():
        first = triangle.index(min(triangle))
        turned.append(triangle[first:] + triangle[:first])
    return sorted(turned)


class CfdSurfaces(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.source = self.document.addObject("Part::Cylinder", "Pipe")
        self.source.Radius, self.source.Height = 5, 20
        self.document.recompute()
        self.mesh = mq.add_quality_mesh(self.source, chord_height=0.05)
        mq.set_patches(self.mesh, {"outlet": ["Face2"], "inlet": ["Face3"]}, patch_rest="walls")

    def corners(self):
        points, faces = self.mesh.Mesh.Topology
        return np.array([tuple(point) for point in points])[np.array(faces)]

    def test_its_faces_are_the_patches_with_their_triangles(self):
        obj = mq.add_cfd_surface(self.mesh)
        self.assertTrue(obj.isDerivedFrom("Part::Feature"))
        self.assertEqual(obj.Patches, ["Face1: outlet", "Face2: inlet", "Face3: walls"])
        self.assertEqual(len(obj.Shape.Faces), 3)
        self.assertEqual(triangles_of(obj.Shape), sorted_corners(self.corners()))
        whole = Mesh.Mesh()
        for face, z in zip(obj.Shape.Faces, (0.0, 20.0, 10.0)):
            part = MeshPart.meshFromShape(Part.makeCompound([face]), LinearDeflection=0.5, Relative=True)
            self.assertAlmostEqual(face.CenterOfMass.z, z, delta=1e-3)
            self.assertAlmostEqual(face.Area, part.Area, delta=1e-4 * part.Area)
            self.assertEqual(len(face.Vertexes), 1)  # by which CfdOF finds faces of boundaries again
            whole.addMesh(part)
        whole.removeDuplicatedPoints()
        self.assertTrue(whole.isSolid())
        self.assertAlmostEqual(obj.Shape.BoundBox.ZLength, 20.0, delta=1e-3)
        point = np.array(obj.PointInside)
        self.assertTrue(np.hypot(*point[:2]) < 5 and 0 < point[2] < 20, point)

    def test_without_patches_each_face_is_one(self):
        mq.set_patches(self.mesh, None)
        self.assertEqual(mq.add_cfd_surface(self.mesh).Patches, ["Face1: Face1", "Face2: Face2", "Face3: Face3"])

    def test_it_is_one_step_and_follows_the_mesh(self):
        self.document.UndoMode = 1
        steps = self.document.UndoCount
        obj = mq.add_cfd_surface(self.mesh)
        self.assertEqual((self.document.UndoCount, self.document.UndoNames[0]), (steps + 1, "CFD surface"))
        self.assertNotIn("Touched", obj.State)
        self.source.Height = 30
        self.document.recompute()
        self.assertEqual(triangles_of(obj.Shape), sorted_corners(self.corners()))
        self.assertAlmostEqual(obj.Shape.BoundBox.ZLength, 30.0, delta=1e-3)
        mq.set_patches(self.mesh, None, patch_rest="all")
        self.document.recompute()
        self.assertEqual(obj.Patches, ["Face1: all"])

    def test_it_comes_back_from_a_file(self):
        name, before = mq.add_cfd_surface(self.mesh).Name, self.corners()
        self.reopen()
        obj = self.document.getObject(name)
        self.assertEqual(triangles_of(obj.Shape), sorted_corners(before))
        self.assertEqual(type(obj.Proxy).__module__, "MeshQuality.features.cfd_surface")

    def test_any_closed_mesh_and_links_to_it(self):
        plain = self.document.addObject("Mesh::Feature", "Plain")
        plain.Mesh = self.mesh.Mesh.copy()
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.mesh
        link.Placement.Base = FreeCAD.Vector(100, 0, 0)
        self.document.recompute()
        self.assertEqual(mq.add_cfd_surface(plain).Patches, ["Face1: Surface"])
        moved = mq.add_cfd_surface(link)
        self.assertEqual(moved.Patches[1], "Face2: inlet")
        self.assertAlmostEqual(moved.Shape.BoundBox.XMin, 95.0, delta=1e-2)

    def test_what_cannot_be_one(self):
        face = self.document.addObject("Part::Feature", "Face")
        face.Shape = self.source.Shape.Face1
        opened = mq.add_quality_mesh(face, chord_height=0.05)
        objects = list(self.document.Objects)
        for wrong, words in ((opened, "open edges"), (self.source, "holds no mesh"), (7, "holds no mesh")):
            with self.subTest(words), self.assertRaisesRegex(mq.InvalidInput, words):
                mq.add_cfd_surface(wrong)
        self.assertEqual(self.document.Objects, objects)
