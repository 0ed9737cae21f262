# SPDX-License-Identifier: LGPL-2.1-or-later
"""What nobody can interrupt is named in the window, and Cancel is answered all the same."""

import gc
import os
import sys
import threading
import time
from unittest import mock

import FreeCADGui
import gui_helpers
import helpers
from PySide import QtCore

import MeshQuality as mq
from MeshQuality import compat
from MeshQuality.features import quality_mesh
from MeshQuality.gui import background, commands, jobs, pace

TEETH = 250  # OpenCASCADE's check of the face takes 4 s on an idle machine; with many more it is not asked


class Waits(gui_helpers.PanelTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.face = helpers.zigzag_face(TEETH)

    def setUp(self):
        super().setUp()
        window = FreeCADGui.getMainWindow()
        before = window.size()
        window.resize(1366, 768)
        self.addCleanup(window.resize, before)
        self.errors = []
        hook = mock.patch.object(sys, "excepthook", lambda *raised: self.errors.append(raised))
        hook.start()
        self.addCleanup(hook.stop)
        self.addCleanup(self.until, lambda: not len(jobs.queue()))

    def toothed(self):
        source = self.document.addObject("Part::Feature", "Toothed")
        source.Shape = self.face
        self.document.recompute()
        return source

    def until(self, condition):
        """Likewise; what a signal's receiver raises would go to the report view only."""
        super().until(condition)
        self.assertEqual(self.errors, [])

    def shot(self, name):
        gui_helpers.wait(0.1)
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, f"{name}.png"))

    def started(self, source, **values):
        """A panel whose job has just begun, without an estimate."""
        panel = self.panel(commands.Triangulate, source)
        panel.options.set_values({"chord_height": 1.0, "chord_height_relative": None, "max_triangles": 1000, **values})
        panel.apply()
        return panel

    def test_the_panel_names_opencascade_and_the_face(self):
        panel = self.started(self.toothed())
        job = panel.jobs[0]
        self.until(lambda: panel.doing.text().startswith("waits for OpenCASCADE: checking Face1"))
        self.assertTrue(job.works)
        self.assertTrue(panel.doing.isVisible())
        self.shot("waits_opencascade")
        self.narrow(panel, "waits_narrow")

    def test_cancel_is_answered_at_once_and_the_end_is_told(self):
        source = self.toothed()
        panel = self.started(source)
        job = panel.jobs[0]
        self.until(lambda: "OpenCASCADE: checking" in panel.doing.text())
        panel.reject()
        self.until(lambda: not panel.jobs)
        self.assertEqual(job.state, jobs.CANCELLED)
        self.assertTrue(job.works)  # OpenCASCADE's check was not waited for
        self.assertFalse(job.over)
        self.assertEqual(panel.said, "Cancelled; nothing was changed.\nOpenCASCADE still finishes: checking Face1")
        self.assertTrue(panel.options.isEnabled())
        self.assertTrue(panel.button.isVisible())
        self.until(background.indicator().isVisible)
        self.assertFalse(background.indicator().button.isVisible())
        self.shot("waits_cancelled")
        self.until(lambda: job.over)
        self.assertIn("has ended", panel.said)
        self.assertFalse(background.indicator().isVisible())
        self.assertIn("has ended", FreeCADGui.getMainWindow().statusBar().currentMessage())
        self.assertEqual(self.document.Objects, [source])
        panel.options.set_values({"max_edge": -1.0})
        panel.apply()
        self.assertIn("Longest edge", panel.said)  # the panel can be used

    def test_the_next_job_names_the_one_that_it_waits_for(self):
        panel = self.started(self.toothed())
        self.until(lambda: "OpenCASCADE: checking" in panel.doing.text())
        panel.reject()
        self.until(lambda: not panel.jobs)
        self.assertTrue(panel.reject())
        other = self.started(self.box())
        self.until(lambda: other.doing.text().startswith(
            "waits for “Quality mesh”: OpenCASCADE still finishes: checking Face1"))
        self.shot("waits_for_a_job")
        self.until(lambda: not other.jobs)
        self.assertIn("Mesh::FeaturePython", [obj.TypeId for obj in self.document.Objects])

    def test_the_user_of_the_shape_engine_is_named(self):
        ended = threading.Event()

        def use():
            mq.triangulate(self.face, chord_height=1.0, max_triangles=1000)
            ended.set()

        threading.Thread(target=use, name="Mesh of Bracket").start()
        self.until(lambda: dict(compat.extension().waits()).get("Mesh of Bracket") == "waits for OpenCASCADE: checking Face1")
        panel = self.started(self.box())
        self.until(lambda: panel.doing.text().startswith("waits for the shape engine, used by Mesh of Bracket"))
        self.shot("waits_engine")
        panel.reject()
        self.until(lambda: not panel.jobs)
        self.assertFalse(ended.is_set())  # the thread that uses the engine was not waited for
        self.assertEqual(panel.said, "Cancelled; nothing was changed.")  # it had only waited
        self.until(ended.is_set)

    def test_a_result_says_that_the_document_takes_it(self):
        panel, texts = self.panel(commands.Triangulate, self.box()), set()
        panel.apply()
        panel.jobs[0].changed.connect(lambda: texts.add(panel.doing.text()))
        self.until(lambda: not panel.jobs)
        self.assertIn("waits for FreeCAD: adding the mesh to the document", texts)

    def test_the_time_left(self):
        """By the clock of the test: steady work, work that stands still, work whose second half takes longer, and two parts one after the other."""
        clock, made = [0.0], pace.Pace(lambda: clock[0])

        def go_on(seconds, *fractions):
            for fraction in fractions:
                clock[0] += seconds
                made.note(fraction)

        go_on(1.0, 0.0, 0.01)
        self.assertEqual(made.text, "")  # short work
        go_on(1.0, *(0.01 * i for i in range(2, 31)))
        self.assertAlmostEqual(made.left, 70.0, delta=1.0)
        self.assertEqual(made.text, "30 s passed, about 1 min 15 s left")
        go_on(1.0, *[0.3] * 30)
        self.assertIsNone(made.left)
        self.assertEqual(made.text, "1 min passed")
        go_on(1.0, *(0.3 + 0.001 * i for i in range(40)))
        self.assertIsNone(made.left)  # ten times as slow as the beginning
        go_on(1.0, *(0.01 * i for i in range(11)))
        self.assertAlmostEqual(made.left, 90.0, delta=1.0)  # another part of it

    def test_a_panel_tells_the_time(self):
        gone_on = threading.Event()
        self.addCleanup(gone_on.set)
        source, real = self.box(), mq.triangulate
        panel = self.panel(commands.Triangulate, source)

        def slow(*args, progress, **values):
            for i in range(100):
                progress(0.004 * i, "filling")
                gone_on.wait(0.02)
            progress(0.4, "filling")
            gone_on.wait(gui_helpers.LIMIT)
            return real(*args, progress=progress, **values)

        with mock.patch.object(pace, "_SHORT", 0.5), mock.patch.object(quality_mesh, "triangulate", slow):
            panel.apply()
            self.until(lambda: "left" in panel.doing.text())
            self.assertRegex(panel.doing.text(), r"^filling.*; \d+ s passed, about \d+ s left$")
            self.shot("time_left")
            self.until(lambda: panel.doing.text().endswith("passed"))  # it stands still
            gone_on.set()
            self.until(lambda: not panel.jobs)

    def test_cycles_are_collected_on_the_thread_of_the_window(self):
        places, ended = [], threading.Event()
        self.addCleanup(ended.set)

        class Kept(QtCore.QObject):
            """As panels and timers are: what Qt has on the window's thread, in a cycle."""

            def __init__(self):
                super().__init__()
                self.itself = self

            def __del__(self):
                places.append(threading.get_ident())

        def compute(progress):
            while not ended.is_set():
                made = [[] for _ in range(20000)]  # enough for Python to collect by itself
                del made
                time.sleep(0.005)

        job = jobs.queue().add(jobs.Job("Cycles", compute, lambda result: None))
        self.until(lambda: job.works)
        self.assertFalse(gc.isenabled())
        for _ in range(2000):  # more than the collector waits for
            Kept()
        self.until(lambda: len(places) == 2000)
        self.assertTrue(job.works)
        self.assertEqual(set(places), {threading.get_ident()})
        ended.set()
        self.until(lambda: job.over)
        self.assertTrue(gc.isenabled())
