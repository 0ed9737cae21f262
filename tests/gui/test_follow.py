# SPDX-License-Identifier: LGPL-2.1-or-later
"""Automatic meshes follow their sources in the background when the window changes these."""

import _thread

import FreeCAD
import FreeCADGui
import gui_helpers
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.features import mesh_object
from MeshQuality.gui import background_recompute, jobs, preferences


class Follow(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        self.source = self.box()
        self.mesh = mq.add_quality_mesh(self.source, max_edge=1.0)

    def refresh(self):
        """Presses the window's button that recomputes, which Python code does not wait for."""
        action = next(action for action in FreeCADGui.getMainWindow().findChildren(QtGui.QAction)
                      if action.objectName() == "Std_Refresh")
        action.setEnabled(True)  # FreeCAD 1.1 does so only a moment after a change
        QtCore.QTimer.singleShot(0, action.trigger)
        self.until(lambda: "Touched" not in self.source.State)

    def settle(self):
        """Waits until nothing is computed any more."""
        gui_helpers.wait(0.1)  # until meshes follow after undo
        self.until(lambda: len(jobs.queue()) == 0)

    def change(self, height):
        """Another height, as by the property editor."""
        self.document.openTransaction("Edit Box")
        self.source.Height = height
        self.refresh()
        self.document.commitTransaction()

    def height(self, obj=None):
        return round((obj or self.mesh).Mesh.BoundBox.ZLength, 3)

    def in_front_of_python(self):
        """The refresh of these tests comes from an event loop that Python code runs."""
        return self.replace_for_test(background_recompute, "_python_waits", lambda: False)

    def replace_for_test(self, owner, name, value):
        before = getattr(owner, name)
        setattr(owner, name, value)
        self.addCleanup(setattr, owner, name, before)

    def test_the_window_goes_on_and_the_mesh_lands_later(self):
        self.in_front_of_python()
        self.change(20)
        self.assertEqual((self.mesh.Status, self.height()), (mesh_object.COMPUTING, 10))
        self.assertTrue(background_recompute.is_computing(self.mesh))
        steps = self.document.UndoCount
        self.settle()
        self.assertEqual((self.mesh.Status, self.height()), (mesh_object.UP_TO_DATE, 20))
        self.assertNotIn("Touched", self.mesh.State)
        self.assertEqual(self.document.UndoCount, steps)
        self.assertEqual(self.mesh.Mesh.CountFacets, self.mesh.Triangles)

    def test_python_code_finds_the_new_mesh(self):
        self.source.Height = 20
        self.document.recompute()
        self.assertEqual((self.mesh.Status, self.height()), (mesh_object.UP_TO_DATE, 20))
        self.assertFalse(background_recompute.is_computing(self.mesh))
        self.in_front_of_python()
        self.change(30)
        mq.update(self.mesh)
        self.assertEqual((self.mesh.Status, self.height()), (mesh_object.UP_TO_DATE, 30))
        self.settle()
        self.assertEqual((self.mesh.Status, self.height()), (mesh_object.UP_TO_DATE, 30))

    def test_lines_of_the_window_are_told_from_code_that_waits(self):
        for name, waits in (("<string>", False), ("<input>", True), ("/home/me/macro.FCMacro", True)):
            found = []
            line = compile("found.append(asked())", name, "exec")
            # A thread of its own, as this file would be beneath.
            _thread.start_new_thread(exec, (line, {"found": found, "asked": background_recompute._python_waits}))
            self.until(lambda seen=found: seen)
            self.assertEqual(found, [waits], name)
        self.assertTrue(background_recompute._python_waits())

    def test_the_newest_of_many_changes_wins(self):
        self.in_front_of_python()
        computed = []
        take = type(self.mesh.Proxy).take
        self.replace_for_test(type(self.mesh.Proxy), "take", lambda proxy, obj, result: (
            computed.append(obj.Name), take(proxy, obj, result))[1])
        mq.update(self.mesh, max_edge=0.2)
        computed.clear()
        for height in (11, 12, 13, 14):
            self.change(height)
        self.settle()
        self.assertEqual(self.height(), 14)
        self.assertLess(len(computed), 4)
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)

    def test_undo_and_redo(self):
        self.in_front_of_python()
        before = str(self.mesh.Mesh.Topology)
        self.change(20)
        self.settle()
        after = str(self.mesh.Mesh.Topology)
        for _ in range(2):
            self.document.undo()
            self.settle()
            self.assertEqual(self.source.Height.Value, 10)
            self.assertEqual((self.mesh.Status, str(self.mesh.Mesh.Topology)),
                             (mesh_object.UP_TO_DATE, before))
            self.document.redo()
            self.settle()
            self.assertEqual((self.mesh.Status, str(self.mesh.Mesh.Topology)),
                             (mesh_object.UP_TO_DATE, after))

    def test_undo_while_it_works(self):
        self.in_front_of_python()
        mq.update(self.mesh, max_edge=0.2)
        self.change(20)
        self.document.undo()
        self.settle()
        self.assertEqual((self.source.Height.Value, self.height()), (10, 10))
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)

    def test_a_step_that_is_given_up(self):
        self.in_front_of_python()
        self.document.openTransaction("given up")
        self.source.Height = 20
        self.refresh()
        self.settle()
        self.assertEqual(self.height(), 20)
        self.document.abortTransaction()
        self.settle()
        self.assertEqual((self.source.Height.Value, self.height()), (10, 10))
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)

    def test_what_is_made_of_the_mesh_follows(self):
        other = self.document.addObject("Part::Box", "Other")
        other.Placement.Base = FreeCAD.Vector(5, 5, -1)
        self.document.recompute()
        both = mq.add_boolean(self.mesh, other, "union")
        self.in_front_of_python()
        self.change(20)
        self.settle()
        self.assertEqual((self.height(), self.height(both)), (20, 21))
        self.assertEqual(both.Status, mesh_object.UP_TO_DATE)

    def test_an_error_marks_the_object_and_keeps_its_mesh(self):
        self.in_front_of_python()
        self.mesh.MinAngle = 80
        self.refresh()
        self.settle()
        self.assertFalse(self.mesh.isValid())
        self.assertTrue(self.mesh.Status.startswith(f"{mesh_object.FAILED}min_angle = 80"), self.mesh.Status)
        self.assertEqual(self.height(), 10)
        self.mesh.MinAngle = 20
        self.refresh()
        self.settle()
        self.assertTrue(self.mesh.isValid())
        self.assertEqual(self.mesh.Status, mesh_object.UP_TO_DATE)

    def test_it_can_be_stopped(self):
        self.in_front_of_python()
        mq.update(self.mesh, max_edge=0.2)
        self.change(20)
        background_recompute.stop(self.mesh)
        self.settle()
        self.assertEqual((self.mesh.Status, self.height()), (mesh_object.OUT_OF_DATE, 10))
        self.source.touch()
        self.refresh()
        self.settle()
        self.assertEqual((self.mesh.Status, self.height()), (mesh_object.UP_TO_DATE, 20))

    def test_object_or_document_gone_meanwhile(self):
        self.in_front_of_python()
        mq.update(self.mesh, max_edge=0.2)
        self.change(20)
        self.document.removeObject(self.mesh.Name)
        self.settle()
        self.assertEqual(self.document.Objects, [self.source])
        self.mesh = mq.add_quality_mesh(self.source, max_edge=0.1)
        self.change(30)
        name = self.document.Name
        FreeCAD.closeDocument(name)
        self.until(lambda: len(jobs.queue()) == 0)
        self.assertEqual(background_recompute._followers, {})
        self.document = FreeCAD.newDocument(name)

    def test_saved_meanwhile_it_is_taken_up_again(self):
        self.in_front_of_python()
        self.change(20)
        name = self.mesh.Name
        self.reopen()
        self.mesh = self.document.getObject(name)
        self.assertEqual(self.height(), 10)
        self.until(lambda: self.mesh.Status == mesh_object.UP_TO_DATE)
        self.assertEqual(self.height(), 20)

    def test_without_the_background_the_window_waits(self):
        self.in_front_of_python()
        preferences.stored().SetBool("Background", False)
        self.change(20)
        self.assertEqual((self.mesh.Status, self.height()), (mesh_object.UP_TO_DATE, 20))
