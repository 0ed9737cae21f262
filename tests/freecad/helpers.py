# SPDX-License-Identifier: LGPL-2.1-or-later
"""What several test modules share: how they are run, parts, checks of properties, documents."""

import os
import resource
import shutil
import tempfile
import time
import unittest

import FreeCAD
import numpy as np
import Part

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SLOWEST = 10  # tests that are named with their seconds


def simple_parts():
    """{name: solid} of every elementary surface, and one with fused ones."""
    box = Part.makeBox(10, 20, 30)
    hole = Part.makeCylinder(3, 40, FreeCAD.Vector(5, 10, -5))
    boss = Part.makeCylinder(4, 10, FreeCAD.Vector(5, 10, 25))
    return {
        "box": box,
        "cylinder": Part.makeCylinder(5, 10),
        "sphere": Part.makeSphere(5),
        "cone": Part.makeCone(5, 0, 10),
        "frustum": Part.makeCone(5, 2, 10),
        "torus": Part.makeTorus(10, 3),
        "fused": box.fuse(boss),
        "cut": box.cut(hole),
    }


def cpu_seconds_of_children():
    """CPU time of the processes that were started here and have ended: what else the machine does is no part of it."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def zigzag_face(teeth):
    """A face that OpenCASCADE checks for about `teeth` * 0.015 s without a break, longer on a slow machine: the
    boxes of its edges all overlap. For at most 250 teeth: the checks of larger faces are our own.
    """
    points, along, aside = 40, FreeCAD.Vector(1, 1, 0), FreeCAD.Vector(1, -1, 0)

    def edge(start, end):
        waves = [start + (end - start) * (k / points) + aside * (0.05 * np.sin(np.pi * k / 4)) for k in range(points + 1)]
        curve = Part.BSplineCurve()
        curve.interpolate([start, *waves[1:-1], end])
        return curve.toShape()

    corners = [along * (100 if i % 2 else 0) + aside * (0.5 * i) for i in range(2 * teeth + 1)]
    below = along * -20
    rest = Part.makePolygon([corners[-1], corners[-1] + below, corners[0] + below, corners[0]])
    return Part.Face(Part.Wire([*map(edge, corners, corners[1:]), *rest.Edges]))


def distances_to_faces(shape, mesh, samples=40):
    """Distances from some triangles' centroids to the face that each is said to lie on, mm."""
    count = len(mesh.triangles)
    chosen = np.unique(np.linspace(0, count - 1, min(samples, count)).astype(int))
    centroids = mesh.vertices[mesh.triangles[chosen]].mean(axis=1) + mesh.origin
    return [Part.Vertex(FreeCAD.Vector(*p)).distToShape(shape.Faces[mesh.triangle_face[k]])[0]
            for k, p in zip(chosen, centroids)]


def smallest_angles(mesh):
    """The smallest angle of each triangle in degrees, by the law of cosines."""
    corners = mesh.vertices[mesh.triangles]
    sides = np.linalg.norm(np.roll(corners, -1, axis=1) - np.roll(corners, -2, axis=1), axis=2)
    a, b, c = np.sort(sides, axis=1).T
    return np.degrees(np.arccos(np.clip((b * b + c * c - a * a) / (2.0 * b * c), -1.0, 1.0)))


def points_and_facets(mesh):
    """The arrays of a Mesh.Mesh, read the slow way that shares no code with the product."""
    points, facets = mesh.Topology
    return np.array([tuple(p) for p in points]), np.array(facets, dtype=np.int32)


def copy_without_binary(folder):
    """Copies the addon into a new folder, as a user has it who copied the sources only."""
    os.mkdir(folder)
    for name in ("Init.py", "InitGui.py", "package.xml"):
        shutil.copy(os.path.join(ROOT, name), folder)
    for name in ("Mod", "Resources", "bin"):
        shutil.copytree(os.path.join(ROOT, name), os.path.join(folder, name),
                        ignore=shutil.ignore_patterns("*.so", "__pycache__"))


class TimedResult(unittest.TextTestResult):
    """Also has how long each test took, in seconds by its name."""

    def __init__(self, *arguments, **values):
        super().__init__(*arguments, **values)
        self.seconds = {}

    def startTest(self, test):
        super().startTest(test)
        self.seconds[test.id()] = -time.monotonic()

    def stopTest(self, test):
        self.seconds[test.id()] += time.monotonic()
        super().stopTest(test)


def run_tests(folder, chosen, stream):
    """Runs the tests of a folder, or those with the chosen names, and returns how many failed.

    The last line that it writes is 'N passed, N failed'. No test at all is a failure.
    """
    loader = unittest.TestLoader()
    suite = loader.loadTestsFromNames(chosen) if chosen else loader.discover(folder)
    result = unittest.TextTestRunner(stream=stream, verbosity=2, resultclass=TimedResult).run(suite)
    for name, seconds in sorted(result.seconds.items(), key=lambda item: -item[1])[:SLOWEST]:
        stream.write(f"{seconds:8.2f} s  {name}\n")
    # A test with several failed sub-tests counts once.
    faults = [test for test, _ in result.failures + result.errors] + result.unexpectedSuccesses
    failed = len({getattr(test, "test_case", test).id() for test in faults})
    for test, why in result.skipped:
        stream.write(f"skipped: {test.id()}: {why}\n")
    passed = result.testsRun - failed - len(result.skipped)
    failed = max(failed, int(result.testsRun == 0))
    stream.write(f"{passed} passed, {failed} failed\n")
    stream.flush()
    return failed


def faces_as_fem_finds_them(part):
    """The faces of an object where FreeCAD's FEM workbench looks for their nodes."""
    from femmesh import meshtools

    found = getattr(meshtools, "sub_shape_at_global_placement", None)  # since FreeCAD 1.0
    return [face if found is None else found(part, f"Face{i + 1}") for i, face in enumerate(part.Shape.Faces)]


class DocumentTest(unittest.TestCase):
    """A test with a fresh document, undo switched on, and a folder for files."""

    def setUp(self):
        self.document = FreeCAD.newDocument("Test")
        self.document.UndoMode = 1
        self.names = [self.document.Name]
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name

    def tearDown(self):
        for name in self.names:
            if name in FreeCAD.listDocuments():
                FreeCAD.closeDocument(name)

    def reopen(self):
        """Saves the document, closes it and opens it again; `document` is the one read."""
        path = os.path.join(self.folder, "saved.FCStd")
        self.document.saveAs(path)
        self.replace(path)

    def replace(self, path):
        """Closes the document and opens a file in its place."""
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        self.names.append(self.document.Name)

    def box(self, name="Box", **sizes):
        obj = self.document.addObject("Part::Box", name)
        for key, value in sizes.items():
            setattr(obj, key, value)
        self.document.recompute()
        return obj
