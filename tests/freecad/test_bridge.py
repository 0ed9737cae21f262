# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes go to C++ in place, or as a copy with all their bits, and come back unchanged."""

import contextlib
import os
import random
import resource
import tempfile
import threading
import unittest
from unittest import mock

import FreeCAD
import helpers
import Part

import MeshQuality as mq
from MeshQuality.compat import extension
from MeshQuality.core.sources import shape_stream

_core = extension()
OWN_KERNEL = os.path.basename(os.path.dirname(_core.__file__)) == "meshquality_core"
NEEDS_LIVE = unittest.skipIf(OWN_KERNEL, "this core has an OpenCASCADE of its own, to which shapes always come as a copy")


def bridge(name):
    """Forces a bridge within a `with`."""
    return mock.patch.dict(os.environ, MESHQUALITY_BRIDGE=name)


def peak_memory():
    """Bytes of this process, at most so far."""
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def own_choice():
    """Lets the bridge choose itself within a `with`."""
    without = {name: value for name, value in os.environ.items() if name != "MESHQUALITY_BRIDGE"}
    return mock.patch.dict(os.environ, without, clear=True)


def turned(shape, angle=37.0):
    """A copy that is moved and turned about no axis of coordinates."""
    moved = shape.copy()
    moved.rotate(FreeCAD.Vector(1, 2, 3), FreeCAD.Vector(0.3, -0.5, 0.7), angle)
    moved.translate(FreeCAD.Vector(0.1, 0.2, 0.3))
    return moved


def nested():
    """Compounds in one another, each moved."""
    inner = turned(Part.makeCompound([Part.makeTorus(10, 3), turned(Part.makeBox(1, 2, 3), 11.0)]))
    return turned(Part.makeCompound([inner, turned(inner, 71.0), Part.makeCone(3, 0, 4)]), 23.0)


def stretched(shape):
    """A copy with splines in place of its surfaces, scaled along one axis."""
    matrix = FreeCAD.Matrix()
    matrix.scale(FreeCAD.Vector(1.3, 1.0, 0.7))
    return shape.transformGeometry(matrix)


def mirrored(shape):
    """A copy on the other side of a plane."""
    return shape.mirror(FreeCAD.Vector(1, 1, 0), FreeCAD.Vector(1.0, 0.3, 0.2))


def placed_parts(chance):
    """{name: shape} in two or three placements at random, which leave the scales of half of their matrices off 1."""
    def placed(shape):
        moved = shape.copy()
        axis = FreeCAD.Vector(chance.random(), 2, chance.random())
        moved.Placement = FreeCAD.Placement(FreeCAD.Vector(chance.uniform(-9, 9), chance.uniform(-99, 99), 3),
                                            FreeCAD.Rotation(axis, chance.uniform(0, 360)))
        return moved

    drum = Part.makeCylinder(chance.uniform(1, 9), chance.uniform(1, 9)).cut(Part.makeSphere(chance.uniform(0.3, 3)))
    twice = placed(Part.makeCompound([placed(drum)]))
    several = [placed(drum), placed(drum), mirrored(placed(drum)), placed(Part.makeBox(3, 2, 1))]
    joined = placed(drum).fuse(placed(Part.makeBox(3, 2, 1)))
    joined.Placement = placed(drum).Placement.multiply(joined.Placement)
    return {"twice": twice, "three times": placed(Part.makeCompound([twice])),
            "several": placed(Part.makeCompound(several)), "Boolean of placed operands": joined}


def all_parts():
    """{name: shape} with seams, degenerate edges, locations in one another, and other orientations."""
    parts = helpers.simple_parts()
    return {**parts, "nested": nested(), "turned": turned(parts["cut"]), "mirrored": mirrored(turned(parts["cone"])),
            "stretched": stretched(parts["cut"]), "reversed": parts["cut"].reversed(),
            "face": parts["cut"].Faces[3], "shell": parts["fused"].Shells[0]}


@NEEDS_LIVE
class Live(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        forced = bridge("live")
        forced.start()
        self.addCleanup(forced.stop)

    def test_the_core_sees_the_very_same_tshape(self):
        obj = self.box()
        shape = obj.Shape
        address, shape_hash = _core.shape_identity(shape)
        self.assertEqual((address, shape_hash), _core.shape_identity(obj.Shape))
        # FreeCAD 1.1 takes the hash for a number with a sign.
        self.assertEqual(shape_hash, shape.hashCode() & 0x7FFFFFFF)
        moved = shape.copy()
        self.assertNotEqual(address, _core.shape_identity(moved)[0])

    def test_handing_over_does_not_leak(self):
        shape = Part.makeSphere(1)
        _core.shape_identity(shape)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        for _ in range(20000):
            _core.shape_identity(shape)
        after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        self.assertLess(after - before, 4096, "kB grown by 20000 shapes")

    def test_the_kernels_agree(self):
        self.assertEqual(Part.OCC_VERSION, _core.occt_version)


class Choice(unittest.TestCase):
    def setUp(self):
        with own_choice():
            _core.take(Part.makeBox(1, 1, 1))  # what this FreeCAD can is found out once

    def test_shapes_are_live_where_they_can_be(self):
        with own_choice():
            self.assertEqual(_core.take(Part.makeBox(1, 1, 1)), "stream" if OWN_KERNEL else "live")

    @NEEDS_LIVE
    def test_a_build_that_cannot_share_gets_the_same_mesh_and_says_so(self):
        shape = helpers.simple_parts()["cut"]
        with own_choice():
            live = mq.triangulate(shape, chord_height=0.2)
            with mock.patch.object(Part, "__toPythonOCC__", side_effect=RuntimeError("no SWIG")):
                copied = mq.triangulate(shape, chord_height=0.2)
        self.assertEqual((live.report.bridge, copied.report.bridge), ("live", "stream"))
        self.assertEqual(live.triangles.tobytes(), copied.triangles.tobytes())
        self.assertEqual(live.triangle_face.tobytes(), copied.triangle_face.tobytes())

    def test_a_forced_bridge_that_does_not_work_is_an_error(self):
        why = "of its own" if OWN_KERNEL else "cannot share"
        with bridge("live"), mock.patch.object(Part, "__toPythonOCC__", side_effect=RuntimeError("no SWIG")), \
                self.assertRaisesRegex(mq.InvalidInput, f"MESHQUALITY_BRIDGE is 'live'.*{why}.*do not set it"):
            mq.triangulate(Part.makeBox(1, 1, 1))

    def test_unknown_bridges_are_named(self):
        with bridge("ferry"), self.assertRaisesRegex(mq.InvalidInput, "MESHQUALITY_BRIDGE = 'ferry'.*'live', 'stream'"):
            mq.triangulate(Part.makeBox(1, 1, 1))

    def test_all_reports_name_it(self):
        box, tall = Part.makeBox(10, 10, 10), Part.makeBox(5, 5, 20)
        for name in ("stream",) if OWN_KERNEL else ("live", "stream"):
            with bridge(name):
                mesh = mq.triangulate(box, chord_height=0.5)
                made = {
                    "triangulate": mesh.report, "curve": mq.curve(box, chord_height=0.5).report,
                    "curve of a surface": mq.curve(mesh, shape=box).report, "quality": mq.quality(mesh, shape=box),
                    "boolean": mq.boolean(box, tall, "union").report, "offset": mq.offset(box, 0.5).report,
                    "hollow": mq.hollow(box, 1.0).report, "wrap": mq.wrap([box, tall], 1.0).report,
                    "thickness": mq.thickness(box), "draft": mq.draft(box, "z"), "voids": mq.voids(box),
                    "clearance": mq.clearance([box, Part.makeBox(1, 1, 1, FreeCAD.Vector(20, 0, 0))]),
                }
                self.assertEqual({what: report.bridge for what, report in made.items()}, dict.fromkeys(made, name))
        self.assertEqual(mq.quality((mesh.vertices, mesh.triangles)).bridge, "")


class Stream(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        forced = bridge("stream")
        forced.start()
        self.addCleanup(forced.stop)

    def test_copies_have_all_bits(self):
        for name, shape in all_parts().items():
            with self.subTest(name):
                self.assertEqual(_core.shape_stream(shape), shape_stream.bytes_of(shape))

    @NEEDS_LIVE
    def test_meshes_are_those_of_live_shapes(self):
        for name, shape in all_parts().items():
            with self.subTest(name):
                self.assert_meshes_agree(shape, chord_height=0.3)

    @NEEDS_LIVE
    def test_meshes_of_shapes_in_placements_within_each_other_are(self):
        for seed in range(8):
            for name, shape in placed_parts(random.Random(seed)).items():
                with self.subTest(name, seed=seed):
                    self.assert_meshes_agree(shape, min_angle=25, chord_height_relative=0.01)

    def assert_meshes_agree(self, shape, **options):
        copied = mq.triangulate(shape, **options)
        with bridge("live"):
            live = mq.triangulate(shape, **options)
        for array in ("vertices", "triangles", "triangle_face", "vertex_entity"):
            self.assertEqual(getattr(live, array).tobytes(), getattr(copied, array).tobytes(), array)

    def test_sub_elements_have_their_names(self):
        shape, sizes = nested(), {"Face3": 0.4, "Edge5": 0.2, "Vertex2": 0.1}
        mesh = mq.triangulate(shape, chord_height=0.1)
        self.assertLess(max(helpers.distances_to_faces(shape, mesh)), 0.1)
        sized = mq.triangulate(shape, chord_height=0.1, local_sizes=sizes)
        self.assertGreater(len(sized.triangles), len(mesh.triangles))
        if not OWN_KERNEL:
            self.assert_meshes_agree(shape, chord_height=0.1, local_sizes=sizes)

    def test_solids_share_their_faces(self):
        shape = Part.makeBox(1, 1, 1).generalFuse([Part.makeBox(1, 1, 1, FreeCAD.Vector(1, 0, 0))])[0]
        self.assertEqual(len(shape.Faces), 11)
        mesh = mq.triangulate(shape, chord_height=0.1)
        self.assertEqual(len(set(mesh.triangle_face.tolist())), 11)

    def test_a_shape_that_was_changed_in_place_is_taken_anew(self):
        shape = Part.makeBox(1, 1, 1)
        first = _core.shape_identity(shape)[0]
        self.assertEqual(first, _core.shape_identity(shape)[0])
        shape.fixTolerance(0.01)  # of the same TShape
        self.assertNotEqual(first, _core.shape_identity(shape)[0])
        self.assertEqual(_core.shape_stream(shape), shape_stream.bytes_of(shape))

    def test_a_moved_shape_is_taken_anew(self):
        shape = Part.makeBox(1, 1, 1)
        first = mq.triangulate(shape)
        shape.translate(FreeCAD.Vector(5, 0, 0))
        second = mq.triangulate(shape)
        self.assertEqual((first.vertices + first.origin)[:, 0].max(), 1.0)
        self.assertEqual((second.vertices + second.origin)[:, 0].min(), 5.0)

    def test_one_change_of_a_document_is_one_copy(self):
        box = self.box()
        read = {_core.shape_identity(box.Shape)[0] for _ in range(5)}
        box.Length = 7
        self.document.recompute()
        read |= {_core.shape_identity(box.Shape)[0] for _ in range(5)}
        self.assertEqual(len(read), 2)

    def test_other_threads_find_what_the_main_thread_took(self):
        shape, found = Part.makeTorus(10, 3), []
        taken = _core.shape_identity(shape)
        with mock.patch.object(shape_stream, "bytes_of", side_effect=AssertionError("FreeCAD was asked")):
            thread = threading.Thread(target=lambda: found.append(_core.shape_identity(shape)))
            thread.start()
            thread.join()
        self.assertEqual(found, [taken])

    def test_shapes_take_no_more_memory_than_the_cache_counts(self):
        def take(count):
            for i in range(count):
                _core.take(stretched(Part.makeTorus(10 + 0.01 * i, 3)))

        take(20)
        counted, used = _core.copied_shapes()[1], peak_memory()
        take(200)
        self.assertLess(peak_memory() - used, _core.copied_shapes()[1] - counted + 2**24)

    def test_the_cache_is_bounded(self):
        torus = stretched(Part.makeTorus(10, 3))
        large = Part.makeCompound([turned(torus, i) for i in range(1500)])
        peaks = []
        for i in range(16):
            _core.take(turned(large, i))
            count, used, most = _core.copied_shapes()
            self.assertLessEqual(used, most)
            peaks.append(peak_memory())
        self.assertLess(count, 12)
        self.assertLess(peaks[-1] - peaks[11], most / 8)

    def test_null_and_faceless_shapes_are_named(self):
        with self.assertRaisesRegex(mq.InvalidInput, "null"):
            mq.triangulate(Part.Shape())
        with self.assertRaisesRegex(mq.InvalidInput, "no faces"):
            mq.triangulate(Part.makeLine(FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0)))


@contextlib.contextmanager
def temporary_folder(path):
    """No files in memory, and others in a folder."""
    with mock.patch.object(os, "memfd_create", side_effect=OSError(38, "not there")), \
            mock.patch.object(tempfile, "tempdir", str(path)):
        yield


class FilesOfStreams(helpers.DocumentTest):
    def test_a_file_gives_the_same_bytes(self):
        shape = nested()
        expected = shape_stream.bytes_of(shape)
        folder = os.path.join(self.folder, "Körper 部品")
        os.mkdir(folder)
        with temporary_folder(folder):
            self.assertEqual(shape_stream.bytes_of(shape), expected)
        self.assertEqual(os.listdir(folder), [])

    def test_a_folder_that_cannot_be_written_is_named(self):
        folder = os.path.join(self.folder, "absent")
        with temporary_folder(folder), self.assertRaisesRegex(mq.IoError, "absent.*TMPDIR"):
            shape_stream.bytes_of(Part.makeBox(1, 1, 1))

    def test_nothing_needs_a_temporary_folder_where_files_can_be_in_memory(self):
        with mock.patch.object(tempfile, "tempdir", os.path.join(self.folder, "absent")), bridge("stream"):
            self.assertEqual(mq.triangulate(Part.makeBox(1, 1, 1)).report.bridge, "stream")


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
