# SPDX-License-Identifier: LGPL-2.1-or-later
"""Editing of objects that are there: double click, OK, Apply, Cancel, and what the macro records."""

import os
from unittest import mock

import FreeCAD
import FreeCADGui
import gui_helpers

import MeshQuality as mq
from MeshQuality.gui import commands, mesh_view


class Editing(gui_helpers.PanelTest):
    def all_three(self):
        """An object of each kind, and an option to change."""
        first, second = self.two_boxes()
        return [(mq.add_quality_mesh(first, min_angle=21.0), "max_edge", 2.5),
                (mq.add_curved_mesh(first, order=3), "max_edge", 3.0),
                (mq.add_boolean(first, second, "union"), "operation", "difference")]

    def test_a_double_click_shows_the_options_of_the_object(self):
        for obj, _, _ in self.all_three():
            with self.subTest(obj.Label):
                panel = self.edit(obj)
                values = panel.operations[0].values()
                self.assertEqual(panel.options.values(), values)
                self.assertEqual(FreeCADGui.getDocument(self.document.Name).getInEdit().Object, obj)
                panel.reject()
                self.assertFalse(FreeCADGui.Control.activeDialog())
                self.assertIsNone(FreeCADGui.getDocument(self.document.Name).getInEdit())

    def test_ok_changes_the_object_in_one_undo_step(self):
        for obj, name, value in self.all_three():
            with self.subTest(obj.Label):
                before, label = (obj.Proxy, mesh_of(obj), obj.Fingerprint), obj.Label  # that of a Boolean has its operation
                steps, objects = self.document.UndoCount, len(self.document.Objects)
                panel = self.edit(obj)
                panel.options.set_values({name: value})
                self.finish(panel)
                self.assertEqual(panel.said, "")
                self.assertFalse(FreeCADGui.Control.activeDialog())
                self.assertEqual(panel.operations[0].values()[name], value)
                self.assertNotEqual(mesh_of(obj), before[1])
                self.assertEqual(len(self.document.Objects), objects)
                self.assertEqual(self.document.UndoCount, steps + 1)
                self.assertEqual(self.document.UndoNames[0], f"Edit {label}")
                self.document.undo()
                self.assertEqual((obj.Proxy, mesh_of(obj), obj.Fingerprint), before)
                self.document.redo()
                self.assertEqual(panel.operations[0].values()[name], value)

    def test_the_recorded_lines_do_the_same(self):
        for obj, name, value in self.all_three():
            with self.subTest(obj.Label):
                lines = []
                real = FreeCADGui.doCommand
                panel = self.edit(obj)
                panel.options.set_values({name: value})
                with mock.patch.object(FreeCADGui, "doCommand",
                                       lambda line, keep=lines: (keep.append(line), real(line))):
                    self.finish(panel)
                wanted = mesh_of(obj)
                self.document.undo()
                self.assertNotEqual(mesh_of(obj), wanted)
                exec("\n".join(lines), {"App": FreeCAD})  # noqa: S102 - what a macro does
                self.assertEqual(mesh_of(obj), wanted)

    def test_cancel_leaves_all_as_it_was(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        before, steps = mesh_of(obj), self.document.UndoCount
        panel = self.edit(obj)
        panel.options.set_values({"max_edge": 0.01})
        panel.accept()
        self.until(lambda: panel.jobs[0].fraction > 0)
        self.assertFalse(panel.reject())
        self.until(lambda: not panel.jobs)
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.assertTrue(panel.reject())
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertEqual((mesh_of(obj), self.document.UndoCount), (before, steps))
        self.assertEqual(obj.MaxEdge.Value, 0.0)
        self.assertNotIn("Touched", obj.State)

    def test_an_error_leaves_all_as_it_was(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        before = mesh_of(obj)
        panel = self.edit(obj)
        panel.options.set_values({"min_angle": 50.0})
        panel.accept()
        self.assertIn("Smallest angle", panel.said)
        self.assertEqual((mesh_of(obj), obj.MinAngle.Value), (before, 25.0))
        self.assertTrue(obj.isValid())
        with self.assertRaises(mq.InvalidInput):
            mq.update(obj, min_angle=50.0)
        with self.assertRaises(mq.InvalidInput):
            mq.update(box)
        self.assertEqual((mesh_of(obj), obj.MinAngle.Value), (before, 25.0))
        self.assertTrue(obj.isValid())

    def test_nothing_is_done_where_nothing_was_changed(self):
        obj = mq.add_quality_mesh(self.box())
        steps = self.document.UndoCount
        self.finish(self.edit(obj))
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertEqual(self.document.UndoCount, steps)

    def test_options_that_expressions_set_are_shown_and_not_edited(self):
        box = self.box()
        obj = mq.add_quality_mesh(box, chord_height=0.1)
        obj.setExpression("MaxEdge", "Box.Length / 4")
        obj.setExpression("ChordHeight", "Box.Length / 50")
        self.document.recompute()
        panel = self.edit(obj)
        for name, shown in (("max_edge", 2.5), ("chord_height", 0.2)):
            field = panel.options.field(name)
            self.assertFalse(field.isEnabled())
            self.assertIn("Set by the expression Box.Length / ", field.toolTip())
            self.assertEqual(panel.options.values()[name], shown)
        self.assertTrue(panel.options.field("min_angle").isEnabled())
        panel.options.reset.click()
        self.assertEqual(panel.options.values()["max_edge"], 2.5)
        # The values are those of the expression when the work begins.
        box.Length = 8.0
        self.document.recompute()
        panel.options.set_values({"min_angle": 20.0})
        self.apply(panel)
        self.assertEqual(panel.said, "")
        self.assertEqual((obj.MinAngle.Value, obj.MaxEdge.Value, obj.ChordHeight.Value), (20.0, 2.0, 0.16))
        # They can be edited again once the expression is cleared.
        obj.setExpression("MaxEdge", None)
        panel.options.set_values({"min_angle": 21.0})
        self.apply(panel)
        field = panel.options.field("max_edge")
        self.assertTrue(field.isEnabled())
        self.assertNotIn("expression", field.toolTip())
        panel.options.set_values({"max_edge": 1.0})
        self.finish(panel)
        self.assertEqual(obj.MaxEdge.Value, 1.0)

    def test_a_mesh_that_is_put_into_its_own_source(self):
        box, part = self.box(), self.document.addObject("App::Part", "Part")
        part.addObject(box)
        self.document.recompute()
        obj = mq.add_quality_mesh(part)
        gui_helpers.wait()
        part.addObject(obj)
        gui_helpers.wait()
        self.assertEqual(part.Group, [box])
        self.assertNotIn(obj, part.OutList)
        box.Length = 20.0
        self.document.recompute()
        self.assertEqual(obj.State, ["Up-to-date"])
        self.assertEqual(obj.Mesh.BoundBox.XLength, 20.0)

    def test_apply_adds_once_and_edits_then(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        self.apply(panel)
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.assertTrue(panel.options.isEnabled())
        obj = self.document.Objects[-1]
        few = obj.Triangles
        panel.options.set_values({"max_edge": 2.0})
        self.apply(panel)
        self.assertEqual(self.document.Objects, [box, obj])
        self.assertGreater(obj.Triangles, few)
        self.finish(panel)
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertEqual(self.document.Objects, [box, obj])
        self.document.undo()
        self.assertEqual(obj.Triangles, few)
        self.document.undo()
        self.assertEqual(self.document.Objects, [box])

    def test_apply_edits_what_it_made_of_several_objects(self):
        sources = self.two_boxes()
        panel = self.panel(commands.Triangulate, *sources)
        self.apply(panel)
        made = self.document.Objects[2:]
        few = [obj.Triangles for obj in made]
        panel.options.set_values({"max_edge": 2.0})
        self.apply(panel)
        self.assertEqual(self.document.Objects[2:], made)
        self.assertEqual([obj.Source for obj in made], list(sources))
        for obj, before in zip(made, few):
            self.assertGreater(obj.Triangles, before)
        panel.reject()

    def test_a_double_click_leaves_a_panel_that_is_open(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        panel = self.panel(commands.Triangulate, box)
        panel.options.set_values({"max_edge": 2.0})
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        gui_helpers.wait()
        self.assertIsNone(FreeCADGui.getDocument(self.document.Name).getInEdit())
        self.assertTrue(panel.form.isVisible())
        self.assertEqual(panel.options.values()["max_edge"], 2.0)

    def test_after_undo_apply_adds_again(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        self.apply(panel)
        self.document.undo()
        self.assertEqual(self.document.Objects, [box])
        self.apply(panel)
        self.assertEqual(len(self.document.Objects), 2)
        panel.reject()

    def test_a_source_that_changes_meanwhile_leaves_the_object_touched(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        panel.options.set_values({"max_edge": 0.2})
        panel.accept()
        box.Height = 20
        self.document.recompute()
        self.until(lambda: not panel.jobs)
        obj = self.document.Objects[-1]
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 10)
        self.assertIn("Touched", obj.State)
        self.document.recompute()
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 20)

    def test_the_object_deleted_meanwhile_closes_the_panel(self):
        obj = mq.add_quality_mesh(self.box())
        panel = self.edit(obj)
        panel.options.set_values({"max_edge": 0.01})
        panel.accept()
        self.until(lambda: panel.jobs[0].fraction > 0)
        job = panel.jobs[0]
        self.document.removeObject(obj.Name)
        self.until(lambda: not job.active)
        self.assertEqual(job.state, "cancelled")
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_what_is_made_of_an_edited_mesh_is_computed_anew(self):
        first, second = self.two_boxes()
        mesh = mq.add_quality_mesh(first)
        both = mq.add_boolean(mesh, second, "union")
        mq.update(mesh, max_edge=2.0)
        self.assertIn("Touched", both.State)
        before = both.Triangles
        self.document.recompute()
        self.assertGreater(both.Triangles, before)

    def test_every_object_has_the_icon_of_its_command(self):
        for obj, _, _ in self.all_three():
            path = obj.ViewObject.Proxy.getIcon()
            self.assertTrue(os.path.isfile(path))
            self.assertIn(obj.Proxy.COMMAND, path)
            self.assertFalse(obj.ViewObject.Icon.isNull())

    def test_documents_of_older_versions_get_editing(self):
        obj = mq.add_quality_mesh(self.box())
        obj.ViewObject.Proxy = 0
        self.reopen()
        gui_helpers.wait()
        again = self.document.getObject("QualityMesh")
        self.assertIsInstance(again.ViewObject.Proxy, mesh_view.MeshView)
        panel = self.edit(again)
        self.assertEqual(panel.operations[0].obj, again)
        panel.reject()


def mesh_of(obj):
    """What can be compared of the object's mesh."""
    return obj.Mesh.CountFacets, obj.Mesh.countSegments(), str(obj.Mesh.Topology)
