# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes go to C++ without a copy, and come back unchanged."""

import resource
import unittest
from unittest import mock

import FreeCAD
import helpers
import Part

import MeshQuality as mq
from MeshQuality import _core


class SharedShape(helpers.DocumentTest):
    def test_the_core_sees_the_very_same_tshape(self):
        obj = self.box()
        shape = obj.Shape
        address, shape_hash = _core.shape_identity(shape)
        self.assertEqual((address, shape_hash), _core.shape_identity(obj.Shape))
        # FreeCAD 1.1 takes the hash for a number with a sign.
        self.assertEqual(shape_hash, shape.hashCode() & 0x7FFFFFFF)
        moved = shape.copy()
        self.assertNotEqual(address, _core.shape_identity(moved)[0])

    def test_the_fallback_by_text_gives_another_tshape(self):
        shape = self.box().Shape
        self.assertNotEqual(_core.shape_identity(shape)[0],
                            _core.shape_identity(shape, copy=True)[0])

    def test_handing_over_does_not_leak(self):
        shape = Part.makeSphere(1)
        _core.shape_identity(shape)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        for _ in range(20000):
            _core.shape_identity(shape)
        after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        self.assertLess(after - before, 4096, "kB grown by 20000 shapes")

    def test_the_kernels_agree(self):
        self.assertEqual(Part.OCC_VERSION.split(".")[:2], _core.occt_version.split(".")[:2])


class Fallback(unittest.TestCase):
    def test_a_build_that_cannot_share_gets_the_same_mesh_and_says_so(self):
        shape = helpers.simple_parts()["cut"]
        live = mq.triangulate(shape, chord_height=0.2)
        with mock.patch.object(Part, "__toPythonOCC__", side_effect=RuntimeError("no SWIG")):
            copied = mq.triangulate(shape, chord_height=0.2)
        self.assertEqual(live.triangles.tobytes(), copied.triangles.tobytes())
        self.assertEqual(live.triangle_face.tobytes(), copied.triangle_face.tobytes())
        self.assertIn("BREP text", " ".join(copied.report.notes))
        self.assertNotIn("BREP text", " ".join(live.report.notes))


class UntouchedDocument(helpers.DocumentTest):
    def test_shape_and_display_triangulation_stay_as_they_are(self):
        obj = self.document.addObject("Part::Cylinder", "Cylinder")
        self.document.recompute()
        obj.Shape.tessellate(0.5)
        before = self.state_of(obj)
        mq.triangulate(obj, min_angle=25, chord_height=0.05)
        mq.triangulate(obj.Shape)
        self.assertEqual(before, self.state_of(obj))
        self.assertNotIn("Touched", obj.State)

    def state_of(self, obj):
        # A deflection coarser than the stored triangulation returns that one as it is.
        points, triangles = obj.Shape.tessellate(0.5)
        path = f"{self.folder}/state.bin"
        obj.Shape.exportBinary(path)
        with open(path, "rb") as stream:
            binary_with_triangulation = stream.read()
        return (obj.Shape.exportBrepToString(), [tuple(p) for p in points], triangles,
                binary_with_triangulation, obj.Shape.hashCode())

    def test_an_untessellated_shape_gets_no_triangulation(self):
        shape = Part.makeSphere(5)
        path = f"{self.folder}/state.bin"
        shape.exportBinary(path)
        with open(path, "rb") as stream:
            before = stream.read()
        mq.triangulate(shape)
        shape.exportBinary(path)
        with open(path, "rb") as stream:
            self.assertEqual(before, stream.read())


class Wrong(unittest.TestCase):
    def test_null_shape(self):
        with self.assertRaisesRegex(mq.InvalidInput, "null"):
            mq.triangulate(Part.Shape())
        with self.assertRaisesRegex(mq.InvalidInput, "null"):
            _core.shape_identity(Part.Shape())

    def test_shapes_without_faces(self):
        wire = Part.makePolygon([FreeCAD.Vector(*p) for p in ((0, 0, 0), (1, 0, 0), (1, 1, 0))])
        for shape in (wire, wire.Edges[0], wire.Vertexes[0], Part.makeCompound([wire])):
            with self.assertRaisesRegex(mq.InvalidInput, "no faces"):
                mq.triangulate(shape)

    def test_things_that_are_no_shapes(self):
        for thing in (None, 5, "Box", [1, 2], FreeCAD.Vector()):
            with self.assertRaisesRegex(mq.InvalidInput, type(thing).__name__):
                mq.triangulate(thing)
        with self.assertRaises(TypeError):
            _core.triangulate("Box", _core.TriangulateOptions())
