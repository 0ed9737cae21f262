# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a hostile script does: sizes beyond all limits, wrong arguments, callbacks that pull the document away,
leaving Python in the middle of the work.
"""

import os
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import FreeCAD
import helpers
import numpy as np
import Part

import MeshQuality as mq

MOD = os.path.join(helpers.ROOT, "Mod")
_SOON = 2.0  # s of CPU time, so that a busy machine is no fault: what is refused at once


def freecad(script, **environment):
    """Runs a script in a FreeCAD of its own; the finished process."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "attack.py")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(script)
        # sys.executable is FreeCAD itself here.
        program = os.environ.get("MESHQUALITY_FREECADCMD", "freecadcmd")
        return subprocess.run([program, "-P", MOD, path], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              errors="replace", timeout=120, env={**os.environ, **environment}, check=False)


class RefusedAtOnce(unittest.TestCase):
    """Sizes that cannot be reached cost neither time nor memory, and the error has the number that would do."""

    def refused(self, text, function, *args, **values):
        start = time.process_time()
        with self.assertRaisesRegex(mq.InvalidInput, text):
            function(*args, **values)
        self.assertLess(time.process_time() - start, _SOON)

    def test_edges_below_single_precision(self):
        box = Part.makeBox(1, 1, 1)
        self.refused("^max_edge is 1e-300 mm: .* from 1.652e-06 mm on; choose a larger", mq.triangulate, box,
                     max_edge=1e-300)
        self.refused("^the local size of Edge1 is 1e-20 mm: .* from 1.652e-06 mm on", mq.triangulate, box,
                     local_sizes={"Edge1": 1e-20})
        # What is allowed by the message ends by its limit.
        mesh = mq.triangulate(box, max_edge=1.7e-6, max_triangles=100)
        self.assertFalse(mesh.report.complete)

    def test_a_place_that_is_no_number(self):
        box = Part.makeBox(1, 1, 1)
        box.Placement = FreeCAD.Placement(FreeCAD.Vector(float("nan"), 0, 0), FreeCAD.Rotation())
        said = r"^vertex \d+ has a coordinate that is not a finite number$"
        self.refused(said, mq.triangulate, box)
        self.refused(said, mq.curve, box, order=2)
        self.refused(said, mq.triangulate, Part.makeCompound([Part.makeBox(1, 1, 1), box]), min_angle=30.0)

    def test_more_edges_a_circle_than_single_precision_tells_from_it(self):
        self.refused("edges_per_circle = 100000.0 .* at most 10000$", mq.triangulate, Part.makeSphere(1),
                     edges_per_circle=10**5)

    def test_lengths_in_errors_have_digits(self):
        box = Part.makeBox(1, 1, 1)
        self.refused("^chord_height is 1e-20 mm: single precision holds this shape to 4.13e-07 mm", mq.triangulate,
                     box, chord_height=1e-20)
        self.refused("tolerance is 1e-20 mm: .* to 4.768e-07 mm", mq.boolean, mq.triangulate(box),
                     mq.triangulate(box), "union", tolerance=1e-20)

    def test_a_tolerance_of_shapes_before_they_are_meshed(self):
        self.refused("tolerance is 1e-300 mm: .* to 9.537e-07 mm", mq.boolean, Part.makeBox(1, 1, 1),
                     Part.makeSphere(1), "union", tolerance=1e-300)

    def test_deviation_of_curved_elements(self):
        curved = mq.curve(Part.makeSphere(1))
        self.refused("^deviation is 1e-300 mm: single precision holds this mesh to .*e-07 mm", curved.tessellate,
                     1e-300)
        self.refused("deviation = 'a' is not allowed", curved.tessellate, "a")

    def test_memory_of_the_uniform_method(self):
        # Meshes are sampled in bands of rays; shapes are not, and take more.
        a, b = (Part.makeBox(1, 1, 1, FreeCAD.Vector(x, x, x)) for x in (0.0, 0.5))
        self.refused("about 3.9 GB at the resolution 4096.* at most 2049, a tolerance of at least 0.001271 mm",
                     mq.boolean, a, b, "union", method="uniform", resolution=4096)
        self.refused("GB at the resolution", mq.boolean, a, b, "union", method="uniform", tolerance=0.0008)
        # A large operand of which little lies in the grid costs no more than what lies there.
        large = mq.triangulate(Part.makeBox(1000, 1000, 1000, FreeCAD.Vector(-500, -500, 0.5)))
        result = mq.boolean(mq.triangulate(a), large, "intersection", method="uniform", resolution=64)
        self.assertAlmostEqual(result.report.volume, 0.5, places=2)

    def test_a_limit_of_triangles_ends_the_work(self):
        """Each of 30,000 triangles that meet in a corner once walked round all of them: 77 s."""
        start = time.process_time()
        mesh = mq.triangulate(Part.makeBox(1, 1, 1), local_sizes={"Edge1": 3e-5}, max_triangles=30000)
        self.assertFalse(mesh.report.complete)
        self.assertLessEqual(len(mesh.triangles), 30000)
        self.assertLess(time.process_time() - start, 10 * _SOON)

    def test_exempt_triangles_are_tried_again_only_where_something_changed(self):
        """Tips of thin blades, finer than single precision: all exempt triangles were tried seven times over."""
        blade = Part.makeCylinder(5, 10).cut(Part.makeSphere(6, FreeCAD.Vector(0, 0, 10)))
        matrix = FreeCAD.Matrix()
        matrix.scale(25, 0.05, -1)
        blade = blade.transformGeometry(matrix)
        blades = Part.makeCompound([blade.translated(FreeCAD.Vector(0, 10 * i, 0)) for i in range(3)])
        report = mq.triangulate(blades).report
        self.assertGreater(len(report.exempt), 1000)
        self.assertLess(report.queries, 15 * report.triangles)

    def test_distances_to_a_surface_of_many_spans(self):
        """The full search for each point looked at samples of all spans: a minute for 1,000 points."""
        count = 120
        poles = [[FreeCAD.Vector(i, k, 3 * np.sin(0.4 * i) * np.cos(0.3 * k)) for k in range(count)]
                 for i in range(count)]
        surface = Part.BSplineSurface()
        ends = [4] + [1] * (count - 4) + [4]
        knots = list(range(len(ends)))
        surface.buildFromPolesMultsKnots(poles, ends, ends, knots, knots, False, False, 3, 3)
        mesh = mq.triangulate(surface.toShape(), chord_height=0.5)
        start = time.process_time()
        report = mq.quality(mesh, surface.toShape())
        self.assertLess(time.process_time() - start, 10 * _SOON)
        worst = Part.Vertex(FreeCAD.Vector(*report.max_chord_point))
        self.assertAlmostEqual(report.max_chord_height, worst.distToShape(surface.toShape())[0], places=9)


class WrongArguments(unittest.TestCase):
    """Whatever is given: an error of ours, or a result."""

    WRONG = ("a", b"x", None, 1, -1, 2**80, 10**400, 1j, object(), [], {}, (), float("nan"), float("inf"),
             1e-320, np.array([1, 2]), True, [1, 2, 3], FreeCAD.Vector(), type, "\0", "\udcff",
             FreeCAD.Units.Quantity("1 s"))

    def only_ours(self, call):
        for wrong in self.WRONG:
            with self.subTest(repr(wrong)):
                try:
                    call(wrong)
                except mq.Error as error:
                    self.assertTrue(str(error))

    def test_options(self):
        box = Part.makeBox(1, 1, 1)
        for name in ("min_angle", "chord_height", "max_edge", "min_edge", "method", "max_triangles", "polish", "seed",
                     "local_sizes", "edges_per_circle", "growth", "feature_angle", "cache"):
            values = {} if name == "max_triangles" else {"max_triangles": 100}
            self.only_ours(lambda wrong, n=name, v=values: mq.triangulate(box, **{n: wrong}, **v))
        for name in ("order", "volume", "min_angle", "chord_height"):
            self.only_ours(lambda wrong, n=name: mq.curve(box, **{n: wrong}))
        mesh = mq.triangulate(box)
        for name in ("operation", "resolution", "tolerance", "method"):
            self.only_ours(lambda wrong, n=name: mq.boolean(mesh, mesh, **{"operation": "union", n: wrong}))
        self.only_ours(mq.MeshCache)
        self.only_ours(lambda wrong: mq.MeshCache(1, wrong))

    def test_what_is_worked_on(self):
        mesh = mq.triangulate(Part.makeBox(1, 1, 1))
        for call in (mq.triangulate, mq.quality, mq.improve, mq.curve, mq.update, mq.add_quality_mesh,
                     mq.add_improved_mesh, mq.CurvedMesh.of, lambda wrong: mq.quality(mesh, wrong),
                     lambda wrong: mq.curve(mesh, shape=wrong), lambda wrong: mq.boolean(mesh, wrong, "union"),
                     lambda wrong: mq.boolean([mesh, wrong], operation="union"),
                     lambda wrong: mq.export_curved_mesh(wrong, os.path.join(tempfile.gettempdir(), "x.msh"))):
            self.only_ours(call)

    def test_names_of_sub_elements(self):
        for name in ("Face9999999999999999999", "Face2147483648", "Face999999999", "Face0", "Box.Face99999999999"):
            with self.assertRaises(mq.InvalidInput):
                mq.triangulate(Part.makeBox(1, 1, 1), local_sizes={name: 0.1})

    def test_arrays(self):
        mesh = mq.triangulate(Part.makeBox(1, 1, 1))
        vertices, triangles = np.array(mesh.vertices), np.array(mesh.triangles)
        for given, said in (
                ((vertices.astype(complex), triangles), "vertices must be numbers, not complex"),
                ((np.ma.masked_array(vertices, vertices > 0.5), triangles), "vertices is an array with masked"),
                ((vertices.astype(str), triangles), "vertices must be numbers, not <U"),
                ((vertices.astype(object), triangles), "vertices must be numbers, not object"),
                ((vertices, triangles.astype(complex)), "triangles must be whole numbers, not complex"),
                ((vertices, np.ma.masked_array(triangles, triangles > 5)), "triangles is an array with masked"),
                ((vertices, triangles.astype(str)), "triangles must be whole numbers, not <U"),
                ((vertices, triangles.astype(object)), "triangles must be whole numbers, not object"),
                ((vertices, triangles.astype(bool)), "triangles must be whole numbers, not bool"),
                ((vertices, [[2**70, 1, 2]]), "triangles must be whole numbers"),
                (([[1, 2], [3]], triangles), "needs")):
            for call in (mq.quality, mq.improve, lambda g: mq.boolean(g, mesh, "union")):
                with self.assertRaisesRegex(mq.InvalidInput, said):
                    call(given)
        # These are the numbers themselves.
        for same in (vertices.tolist(), [FreeCAD.Vector(*p) for p in vertices], np.ma.masked_array(vertices),
                     vertices.astype(">f8"), vertices.astype(np.float32)):
            self.assertEqual(mq.quality((same, triangles.astype(np.uint8))).volume, 1.0)

    def test_names_of_files(self):
        mesh = mq.triangulate(Part.makeBox(1, 1, 1))
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(mq.IoError, "NUL"):
                mesh.write(os.path.join(folder, "a\0b.stl"))
            with self.assertRaises(mq.InvalidInput):
                mesh.write(7)
            self.assertEqual(os.listdir(folder), [])
            odd = os.path.join(folder, "\udcff.stl")  # not UTF-8
            mesh.write(odd)
            self.assertEqual(os.path.getsize(odd), 84 + 12 * 50)
            with self.assertRaisesRegex(mq.IoError, "nowhere"):
                mesh.write(os.path.join(folder, "nowhere", "\udcff.stl"))


class Findings(unittest.TestCase):
    def test_thin_parts_tell_of_the_volume_that_they_lose(self):
        for size in ((1000, 1000, 1e-6), (1e4, 1e-3, 1e-3)):
            part = Part.makeBox(*size)
            report = mq.triangulate(part, max_triangles=2000).report
            self.assertGreater(abs(report.volume - part.Volume), 0.1 * part.Volume)
            self.assertIn("single precision changes its volume", " ".join(report.notes))
        for part in (Part.makeBox(1, 1, 1), Part.makeBox(1000, 1000, 1), Part.makeSphere(1)):
            self.assertNotIn("volume", " ".join(mq.triangulate(part).report.notes))

    def test_a_symmetric_difference_within_the_tolerance_says_so(self):
        sphere = mq.triangulate(Part.makeSphere(10))
        noise = np.random.default_rng(1).uniform(-1e-3, 1e-3, sphere.vertices.shape)
        near = ((sphere.vertices + noise).astype(np.float32), sphere.triangles)
        report = mq.boolean(sphere, near, "symmetric_difference").report
        self.assertEqual(report.triangles, 0)
        self.assertIn("the same within the tolerance of 0.06766 mm; a smaller tolerance", " ".join(report.notes))
        finer = mq.boolean(sphere, near, "symmetric_difference", tolerance=2e-4).report
        self.assertGreater(finer.volume, 0.0)
        self.assertNotIn("the same within", " ".join(finer.notes))

    def test_a_mesh_of_another_shape_is_not_curved_to_it(self):
        box = Part.makeBox(1, 1, 1)
        mesh = mq.triangulate(box)
        larger = mq.triangulate(box.fuse(Part.makeBox(1, 1, 1, FreeCAD.Vector(0.5, 0.5, 0.5))))
        for given, shape in ((mesh, Part.makeBox(10, 10, 10)), (mesh, Part.makeBox(1, 1, 1, FreeCAD.Vector(0, 0, 1))),
                             (mesh, Part.makeSphere(1)), (larger, box)):
            with self.assertRaisesRegex(mq.InvalidInput, "does not belong to the shape: its vertex .* Vertex"):
                mq.curve(given, shape=shape)
        self.assertEqual(mq.curve(mesh, shape=box).report.invalid, 0)


class CancelWhileTheEngineIsBusy(unittest.TestCase):
    def test_it_is_not_waited_for(self):
        many = Part.makeCompound([Part.makeBox(1, 1, 1, FreeCAD.Vector(2 * i, 2 * j, 0))
                                  for i in range(60) for j in range(50)])
        box, begun, stop = Part.makeBox(1, 1, 1), threading.Event(), threading.Event()
        reads = []  # the stages of the other thread

        def read_many():
            def progress(_fraction, stage):
                reads.append(stage)
                if stage == "reading the shape":
                    begun.set()
                return not stop.is_set()
            try:
                mq.triangulate(many, progress=progress)
            except mq.Cancelled:
                pass

        reader = threading.Thread(target=read_many)
        reader.start()
        self.assertTrue(begun.wait(60))
        stages = []

        def cancel(_fraction, stage):
            stages.append(stage)
            return False if len(stages) > 2 else None

        with self.assertRaises(mq.Cancelled):
            mq.triangulate(box, progress=cancel)
        still_read = reader.is_alive() and reads[-1] == "reading the shape"
        stop.set()
        reader.join()
        self.assertEqual(stages[2], "reading the shape")
        self.assertTrue(still_read, "the reading of the other thread was waited for")


class Callbacks(helpers.DocumentTest):
    """What a callback of update does to the document has a defined result."""

    def setUp(self):
        super().setUp()
        self.document.openTransaction("box")
        self.source = self.box()
        self.document.commitTransaction()
        self.mesh = mq.add_quality_mesh(self.source)
        self.document.openTransaction("length")
        self.source.Length = 20
        self.document.recompute()
        self.document.commitTransaction()

    def update(self, action):
        """Updates the mesh with a callback that acts at its second call."""
        calls = []

        def progress(_fraction, _stage):
            calls.append(1)
            if len(calls) == 2:
                action()

        mq.update(self.mesh, progress, min_angle=28.0, chord_height=0.01)

    def refused(self, said, action):
        with self.assertRaisesRegex(mq.Error, said):
            self.update(action)

    def unchanged(self):
        self.assertEqual((self.mesh.MinAngle.Value, self.mesh.Status), (25.0, "up to date"))

    def test_undo_of_the_source(self):
        self.refused("source of 'Box quality mesh' was changed", self.document.undo)
        self.unchanged()
        self.document.recompute()
        self.assertEqual(self.mesh.Mesh.BoundBox.XMax, 10.0)
        self.document.redo()
        self.document.recompute()
        self.assertEqual(self.mesh.Mesh.BoundBox.XMax, 20.0)

    def test_change_of_the_source(self):
        def longer():
            self.source.Length = 33
            self.document.recompute()

        self.refused("was changed", longer)
        self.unchanged()
        self.assertEqual(self.mesh.Mesh.BoundBox.XMax, 33.0)

    def test_removal_of_the_object_and_of_the_source(self):
        self.refused("'Box quality mesh' was removed", lambda: self.document.removeObject("QualityMesh"))
        self.document.undo()
        self.mesh = self.document.getObject("QualityMesh")
        self.unchanged()
        self.refused("source was deleted", lambda: self.document.removeObject("Box"))

    def test_closing_the_document(self):
        self.refused("its document closed", lambda: FreeCAD.closeDocument(self.document.Name))

    def test_what_it_raises_comes_out(self):
        for error in (KeyError("mine"), SystemExit(3), KeyboardInterrupt(), mq.GeometryError("mine")):
            def fail(error=error):
                raise error

            with self.assertRaises(type(error)) as caught:
                self.update(fail)
            self.assertIs(caught.exception, error)
            self.unchanged()

    def test_calls_within_calls(self):
        inner = []
        self.update(lambda: inner.append(mq.triangulate(
            Part.makeBox(1, 1, 1), progress=lambda *_: inner.append(mq.quality(mq.triangulate(Part.makeBox(2, 2, 2)))))))
        self.assertEqual(inner[0].volume, 8.0)
        self.assertEqual(inner[-1].report.volume, 1.0)
        self.assertEqual(self.mesh.MinAngle.Value, 28.0)

    def test_an_update_within_the_update(self):
        self.update(lambda: mq.update(self.mesh, lambda *_: None, min_angle=20.0))
        self.assertEqual((self.mesh.MinAngle.Value, self.mesh.Status), (28.0, "up to date"))

    def test_a_shape_whose_document_is_closed_is_meshed(self):
        closed = []

        def close(_fraction, _stage):
            if not closed:
                closed.append(FreeCAD.closeDocument(self.document.Name))

        mesh = mq.triangulate(self.source, progress=close)
        self.assertEqual(mesh.report.volume, 20 * 10 * 10)


class UndoOfTheObject(unittest.TestCase):
    """In a FreeCAD of its own: it crashed."""

    def test_undo_in_the_callback(self):
        done = freecad("""
import FreeCAD, os, sys, MeshQuality as mq
document = FreeCAD.newDocument("T")
document.UndoMode = 1
document.openTransaction("box")
box = document.addObject("Part::Box", "Box")
document.recompute()
document.commitTransaction()
mesh = mq.add_quality_mesh(box)
undone = []
def progress(fraction, stage):
    if not undone:
        undone.append(document.undo())
try:
    mq.update(mesh, progress, min_angle=28.0)
except mq.Error as error:
    print("REFUSED", error)
document.recompute()
document.redo()
print("OBJECTS", [o.Name for o in document.Objects])
sys.stdout.flush()
sys.exit(0)  # at the end of a script FreeCAD 1.1 crashes with any Mesh::FeaturePython that Python has read
""")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("REFUSED 'Box quality mesh' was removed", done.stdout)
        self.assertIn("OBJECTS ['Box', 'QualityMesh']", done.stdout)


WORKS = {
    "triangulate": "mq.triangulate(Part.makeSphere(10), chord_height=0.0005)",
    "triangulate with a callback": "mq.triangulate(Part.makeSphere(10), chord_height=0.0005, progress=lambda *_: None)",
    "a callback that sleeps": "mq.triangulate(Part.makeSphere(10), progress=lambda *_: time.sleep(600))",
    "boolean": "mq.boolean(Part.makeSphere(10), Part.makeBox(10, 10, 10), 'union', resolution=4096)",
    "curve": "mq.curve(Part.makeSphere(10), order=3, volume=True, chord_height=0.02)",
    "write": "[mesh.write(path) for _ in range(10**6)]",
}
LEAVE = """
import os, sys, tempfile, threading, time
import FreeCAD, Part, MeshQuality as mq
mesh = mq.triangulate(Part.makeSphere(10), chord_height=0.01)
path = os.path.join(os.path.dirname(os.path.abspath(sys.argv[-1])), "mesh.ply")
threading.Thread(target=lambda: WORK, daemon=True).start()
time.sleep(0.7)
"""


class LeavingInTheMiddle(unittest.TestCase):
    """A daemon thread still works when Python ends."""

    def test_freecad_reaches_the_end_of_its_input(self):
        for name, work in WORKS.items():
            with self.subTest(name):
                before = helpers.cpu_seconds_of_children()
                done = freecad(LEAVE.replace("WORK", work))
                self.assertEqual(done.returncode, 0, done.stderr[-500:])
                self.assertLess(helpers.cpu_seconds_of_children() - before, 30.0)

    def test_sys_exit(self):
        for name, work in WORKS.items():
            with self.subTest(name):
                done = freecad(LEAVE.replace("WORK", work) + "sys.exit(7)\n")
                self.assertEqual(done.returncode, 7, done.stderr[-500:])

    def test_tables_of_the_work_outlive_it(self):
        """The exit destroys static objects, at any time within the work."""
        for seconds in (0.8, 0.9, 1.0, 1.1):
            with self.subTest(seconds):
                done = freecad(LEAVE.replace("WORK", WORKS["curve"]).replace("0.7", str(seconds)) + "sys.exit(7)\n")
                self.assertEqual(done.returncode, 7, done.stderr[-500:])

    def test_python_with_freecad_as_a_module(self):
        library = os.path.join(FreeCAD.getHomePath(), "lib")
        script = f"import sys; sys.path[:0] = [{library!r}, {MOD!r}]\n{LEAVE}sys.exit(7)\n"
        interpreter = os.path.join(sys.base_exec_prefix, "bin", "python3")
        if subprocess.run([interpreter, "-c", f"import sys; sys.path.insert(0, {library!r}); import FreeCAD"],
                          capture_output=True, check=False).returncode:
            self.skipTest("this FreeCAD is no module for its Python")
        for name in ("triangulate", "a callback that sleeps", "curve"):
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "leave.py")
                with open(path, "w", encoding="utf-8") as stream:
                    stream.write(script.replace("WORK", WORKS[name]))
                done = subprocess.run([interpreter, path], capture_output=True, text=True, timeout=120, check=False)
                self.assertEqual(done.returncode, 7, done.stderr[-500:])
