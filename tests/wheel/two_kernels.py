# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two OpenCASCADEs in one FreeCAD: its own makes, cuts, writes and reads solids, ours meshes them, in random order.

    MESHQUALITY_STEPS=1000 freecadcmd tests/wheel/two_kernels.py
Each step is checked by volumes or by the error that it must give. The last line is 'N passed, N failed'.
"""

import collections
import math
import os
import random
import sys
import tempfile
import traceback

import FreeCAD
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality import compat

NEAR = 1e-9  # of a volume: FreeCAD's own results of the same solid
MESHED = 0.02  # of a volume: meshes within a five-hundredth of the size
GROWTH = 1.05  # of the memory, from the second quarter of the steps to the last


class Wrong(Exception):
    """A result is not what it must be."""


def must(holds, what):
    if not holds:
        raise Wrong(what)


def near(found, expected, share):
    must(math.isclose(found, expected, rel_tol=share), f"volume {found}, not {expected}")


def memory():
    """The resident set of this process in MB, without the copies of shapes, whose cache has a bound of its own."""
    with open("/proc/self/statm", encoding="ascii") as stream:
        resident = int(stream.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    _, copied, most = compat.extension().copied_shapes()
    must(copied <= most, "the cache of copied shapes is larger than its bound")
    return (resident - copied) / 1e6


def volume_of(mesh):
    corners = mesh.vertices[mesh.triangles]
    first, second, third = corners[:, 0], corners[:, 1], corners[:, 2]
    return float((first * np.cross(second, third)).sum()) / 6


class Steps:
    """A document with a Cut of two solids, and what is done to it."""

    def __init__(self, seed, folder):
        self.random, self.folder = random.Random(seed), folder
        self.document = FreeCAD.newDocument("TwoKernels")
        self.document.UndoMode = 1
        self.box = self.document.addObject("Part::Box", "Box")
        self.cylinder = self.document.addObject("Part::Cylinder", "Cylinder")
        self.cut = self.document.addObject("Part::Cut", "Cut")
        self.cut.Base, self.cut.Tool = self.box, self.cylinder
        self.document.recompute()

    def change(self):
        """FreeCAD's own Boolean."""
        self.document.openTransaction("change")
        self.box.Length, self.box.Height = (self.random.uniform(5, 15) for _ in range(2))
        self.cylinder.Radius = self.random.uniform(1, 4)
        self.document.recompute()
        self.document.commitTransaction()
        quarter = math.pi * self.cylinder.Radius.Value ** 2 / 4 * min(self.box.Height.Value, 10)
        near(self.cut.Shape.Volume, self.box.Shape.Volume - quarter, 1e-6)

    def undo(self):
        before = self.cut.Shape.Volume
        self.change()
        self.document.undo()
        self.document.recompute()
        near(self.cut.Shape.Volume, before, NEAR)

    def exchange(self):
        """STEP, written and read by FreeCAD."""
        path = os.path.join(self.folder, "cut.step")
        self.cut.Shape.exportStep(path)
        near(Part.read(path).Volume, self.cut.Shape.Volume, 1e-6)

    def fillet(self):
        solid = Part.makeBox(10, 10, self.random.uniform(5, 9))
        round_one = solid.makeFillet(self.random.uniform(0.5, 1.5), solid.Edges[:1])
        must(round_one.isValid() and round_one.Volume < solid.Volume, "the fillet is wrong")
        self.mesh_of(round_one)

    def display(self):
        """FreeCAD's own triangles, and those that are on the shape, as ours must not change."""
        before = self.cut.Shape.tessellate(0.1)
        self.mesh()
        must(len(self.cut.Shape.tessellate(0.1)[1]) == len(before[1]), "the shape lost its triangles")

    def mesh_of(self, shape):
        mesh = mq.triangulate(shape, min_angle=25, chord_height_relative=0.002, threads=self.random.choice((1, 2)))
        must(mesh.report.closed and mesh.report.min_angle_unexempted >= 25, "the mesh is not what was requested")
        near(volume_of(mesh), shape.Volume, MESHED)

    def mesh(self):
        self.mesh_of(self.cut.Shape)

    def boolean(self):
        """Ours, of two shapes, against FreeCAD's."""
        joined = mq.boolean(self.box.Shape, self.cylinder.Shape, "union", threads=1)
        near(volume_of(joined), self.box.Shape.fuse(self.cylinder.Shape).Volume, MESHED)

    def curve(self):
        sphere = Part.makeSphere(self.random.uniform(2, 5))
        report = mq.curve(sphere, order=2).report
        must(report.elements > 0 and report.invalid == 0, "curved elements are missing or invalid")
        near(report.volume, sphere.Volume, MESHED)

    def their_error(self):
        """An exception within FreeCAD's OpenCASCADE; which one Python gets depends on FreeCAD's version."""
        solid = Part.makeBox(10, 10, 10)
        try:
            solid.makeFillet(50, solid.Edges)
        except (Part.OCCError, FreeCAD.Base.CADKernelError):
            return
        raise Wrong("FreeCAD made a fillet that cannot be")

    def our_error(self):
        """An exception within ours."""
        try:
            mq.triangulate(Part.Shape())
        except mq.InvalidInput:
            return
        raise Wrong("a null shape was meshed")


def run(steps):
    done, failed, sets = collections.Counter(), 0, []
    with tempfile.TemporaryDirectory() as folder:
        state = Steps(7, folder)
        kinds = [state.change, state.undo, state.exchange, state.fillet, state.display, state.mesh, state.boolean, state.curve,
                 state.their_error, state.our_error]
        for step in range(steps):
            kind = state.random.choice(kinds)
            done[kind.__name__] += 1
            try:
                kind()
            except Exception:
                failed += 1
                print(f"step {step}, {kind.__name__}:", flush=True)
                traceback.print_exc()
            sets.append(memory())
    quarter = max(1, steps // 4)
    second, last = (max(sets[place:place + quarter]) for place in (quarter, len(sets) - quarter))
    print(f"{dict(done)}; memory without copied shapes {sets[0]:.0f} MB after the first step, {second:.0f} MB at most in the second quarter, "
          f"{last:.0f} MB in the last; OpenCASCADE {Part.OCC_VERSION} and {compat.extension().occt_version}")
    if last > GROWTH * second:
        failed += 1
        print(f"the memory grew by more than {GROWTH}")
    print(f"{steps - failed} passed, {failed} failed", flush=True)
    return 1 if failed else 0


sys.exit(run(int(os.environ.get("MESHQUALITY_STEPS", "1000"))))
