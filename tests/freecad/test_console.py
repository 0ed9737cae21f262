# SPDX-License-Identifier: LGPL-2.1-or-later
"""What somebody at the Python console meets: names, completion, one line for each result, help."""

import importlib
import importlib.util
import inspect
import pydoc
import re
import unittest

import Part

import MeshQuality as mq
from MeshQuality.core.certify import verdict
from MeshQuality.version import __version__


class Names(unittest.TestCase):
    def test_the_version(self):
        self.assertEqual(mq.__version__, __version__)

    def test_completion_has_what_scripts_use_and_nothing_else(self):
        names = dir(mq)
        self.assertEqual(set(names), {*mq.__all__, "__version__"})
        self.assertEqual([name for name in names if name.startswith("_")], ["__version__"])
        for name in mq.__all__:
            self.assertTrue(inspect.getdoc(getattr(mq, name)), name)
            self.assertIsNone(importlib.util.find_spec(f"MeshQuality.{name}"), f"{name} is a module")

    def test_completion_of_classes_and_their_objects_has_no_helpers(self):
        mesh, curved = mq.triangulate(Part.makeBox(1, 1, 1)), mq.curve(Part.makeBox(1, 1, 1))
        union = mq.boolean(Part.makeBox(1, 1, 1), Part.makeBox(2, 2, 2), "union", tolerance=0.1)
        things = [getattr(mq, name) for name in mq.__all__ if inspect.isclass(getattr(mq, name))]
        things += [mesh, mesh.report, curved, curved.report, union, union.report, mq.MeshCache()]
        for thing in things:
            names = [name for name in dir(thing) if not name.startswith("__")]
            self.assertEqual([name for name in names if re.match("_(?!pybind11_)", name)], [], thing)
            self.assertFalse({"held", "store_in", "loader_of", "lists", "taken_from"} & set(names), thing)
        self.assertLess({"nodes", "elements", "of", "write", "report"}, set(dir(mq.CurvedMesh)))
        self.assertLess({"vertices", "triangle_source", "to_mesh"}, set(dir(union)))
        self.assertIn("bytes", dir(mq.MeshCache()))

    def test_names_that_are_none(self):
        with self.assertRaisesRegex(AttributeError, "no attribute 'triangulat'"):
            _ = mq.triangulat


class Lines(unittest.TestCase):
    """repr() says in one line what a thing is."""

    def test_meshes_and_their_reports(self):
        mesh = mq.triangulate(Part.makeCylinder(5, 10), chord_height=0.1)
        figures = rf"{len(mesh.triangles):,} triangles, closed, smallest angle [\d.]+°"
        self.assertRegex(repr(mesh), rf"^<SurfaceMesh: {figures}>$")
        self.assertRegex(repr(mesh.report), rf"^<MeshReport: {figures}>$")
        measured = mq.quality((mesh.vertices, mesh.triangles))
        self.assertRegex(repr(measured), rf"^<MeshReport: {figures}>$")
        stopped = mq.triangulate(Part.makeBox(9, 9, 9), max_edge=0.1, max_triangles=2000)
        self.assertRegex(repr(stopped), r"^<SurfaceMesh: \d,\d{3} triangles, closed, .*, not all limits met>$")
        opened = mq.quality((mesh.vertices, mesh.triangles[1:]))
        self.assertIn(" triangles, open, ", repr(opened))

    def test_booleans(self):
        result = mq.boolean(Part.makeBox(10, 10, 10), Part.makeSphere(6), "union", tolerance=0.1)
        figures = (rf"{len(result.triangles):,} triangles, closed, smallest angle [\d.]+°, max\. deviation [\de.-]+ mm of "
                   "0.1 mm")
        self.assertRegex(repr(result), f"^<BooleanMesh: {figures}>$")
        self.assertRegex(repr(result.report), f"^<BooleanReport: {figures}>$")

    def test_curved_meshes(self):
        shape = Part.makeCylinder(5, 10)
        surface, volume = mq.curve(shape), mq.curve(shape, order=1, volume=True)
        self.assertEqual(repr(surface), f"<CurvedMesh: {len(surface.elements):,} triangles of order 2, all valid>")
        self.assertEqual(repr(volume), f"<CurvedMesh: {len(volume.elements):,} tetrahedra of order 1, all valid>")
        self.assertRegex(repr(volume.report), rf"^<CurveReport: {len(volume.elements):,} elements, all valid, shape "
                                              r"distortion at most [\d.]+, max\. deviation [\de.-]+ mm>$")

    def test_angles_that_are_rounding_alone(self):
        report = mq.quality(([(0, 0, 0), (1, 0, 0), (0.5, 1e-12, 0)], [(0, 1, 2)]))
        self.assertGreater(report.min_angle, 0)
        self.assertIn("1 triangle, smallest angle 0°;", verdict.line("Scan", report, []))

    def test_caches(self):
        cache = mq.MeshCache()
        self.assertEqual(repr(cache), "<MeshCache: 0 calls of triangulate, 0.0 MiB>")
        mq.triangulate(Part.makeBox(1, 1, 1), cache=cache)
        self.assertRegex(repr(cache), r"^<MeshCache: 1 call of triangulate, [\d.]+ MiB>$")


class Help(unittest.TestCase):
    def test_of_the_package(self):
        page = pydoc.plain(pydoc.render_doc(mq))
        for heading in ("First steps", "Meshes for scripts", "Objects of the document", "Results and reports",
                        "Errors"):
            self.assertIn(f"\n    {heading}", page)
        functions = page.partition("\nFUNCTIONS\n")[2]
        for name in mq.__all__:
            if inspect.isfunction(getattr(mq, name)):
                self.assertIn(f"\n    {name}(", "\n" + functions)
        # Python 3.13 puts each parameter of a long signature on a line of its own.
        self.assertRegex(functions, r"triangulate\(\s*shape,\s+min_angle=25.0,\s+chord_height=None")
        self.assertIn(f"VERSION\n    {__version__}", page)

    def test_the_page_has_no_modules_of_the_package(self):
        page = pydoc.plain(pydoc.render_doc(mq))
        self.assertNotIn("SUBMODULES", page)
        self.assertRegex(page, r"\nPACKAGE CONTENTS\n\s*\nCLASSES\n")  # pydoc writes this heading above nothing, too
        self.assertNotIn("MeshQuality.", page.partition("\nCLASSES\n")[2].partition("\n    class ")[0])
        for name in ("cli (package)", "phrases", "core (package)", "gui (package)"):
            self.assertNotIn(f"\n    {name}", page)
        self.assertNotRegex(page, r"\n     \|  (_\w*[^_\W]|store_in|loader_of|lists|taken_from)\b(?!_)")
        # They are found as ever.
        importlib.invalidate_caches()
        self.assertIsNotNone(importlib.util.find_spec("MeshQuality.batch.worker_loop"))
        self.assertIsNotNone(importlib.util.find_spec("MeshQuality.core.meshes.writing"))
        self.assertIsNone(importlib.util.find_spec("MeshQuality.nothing"))

    def test_the_page_names_every_function(self):
        for name in mq.__all__:
            self.assertIn(name, mq.__doc__.replace("MeshReport", "MeshReport SurfaceMesh"))

    def test_of_a_function_all_its_arguments(self):
        for function in (mq.triangulate, mq.curve, mq.boolean, mq.improve, mq.quality):
            page = pydoc.plain(pydoc.render_doc(function))
            for name in inspect.signature(function).parameters:
                self.assertRegex(inspect.getdoc(function), rf"\b{name}\b", function.__name__)
            self.assertIn(f"{function.__name__}(", page)
