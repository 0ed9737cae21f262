# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces picked in the 3D view get a size of their own in the panel."""

import FreeCADGui
import gui_helpers

from MeshQuality.gui import commands
from MeshQuality.gui.panels.mesh_panel import MeshPanel


class LocalSizes(gui_helpers.GuiTest):
    def test_picked_faces_are_added_once(self):
        box = self.box()
        panel = MeshPanel(commands.Triangulate().operations([box]))
        FreeCADGui.Control.showDialog(panel)
        self.addCleanup(FreeCADGui.Control.closeDialog)
        gui_helpers.wait()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(box, "Face3")
        FreeCADGui.Selection.addSelection(box, "Edge2")
        field = panel.options._fields["local_sizes"]
        field.button.click()
        self.assertRegex(field.value(), r"^Face3=[\d.]+, Edge2=[\d.]+$")
        field.button.click()
        self.assertEqual(field.value().count("Face3"), 1)
        panel.accept()
        self.until(lambda: not panel.jobs)
        obj = self.document.Objects[-1]
        self.assertIn("Face3=", obj.LocalSizes)
        self.assertGreater(obj.Mesh.CountFacets, 500)

    def test_nonsense_is_said_in_the_panel(self):
        panel = MeshPanel(commands.Triangulate().operations([self.box()]))
        FreeCADGui.Control.showDialog(panel)
        self.addCleanup(FreeCADGui.Control.closeDialog)
        panel.options.set_values({"local_sizes": "Face3"})
        panel.accept()
        self.until(lambda: not panel.jobs)
        self.assertIn("Face3=0.5", panel.said)


class OfContainers(gui_helpers.PanelTest):
    """Names say which object of a container has the face."""

    def setUp(self):
        super().setUp()
        self.part = self.document.addObject("App::Part", "Asm")
        for i in (1, 2):
            box = self.document.addObject("Part::Box", f"B{i}")
            box.Placement.Base.x = 20 * i
            self.part.addObject(box)
        self.other = self.document.addObject("Part::Box", "Other")
        self.document.recompute()

    def add(self, panel, root, *paths):
        FreeCADGui.Selection.clearSelection()
        for path in paths:
            FreeCADGui.Selection.addSelection(self.document.Name, root.Name, path)
        field = panel.options._fields["local_sizes"]
        field.button.click()
        return field

    def test_a_face_of_a_part_is_refined_there(self):
        panel = self.panel(commands.Triangulate, self.part)
        field = self.add(panel, self.part, "B2.Face6")
        self.assertRegex(field.value(), r"^B2\.Face6=[\d.]+$")
        panel.options.set_values({"local_sizes": "B2.Face6=0.5"})
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertEqual(obj.LocalSizes, "B2.Face6=0.5")
        counts = self.counts(obj)
        self.assertGreater(counts[11], 500)  # the sixth face of the second box
        self.assertLess(counts[5], 20)

    def counts(self, obj):
        runs = obj.FaceRuns
        return {face: sum(n for f, n in zip(runs[::2], runs[1::2]) if f == face)
                for face in set(runs[::2])}

    def test_faces_of_others_are_refused_by_name(self):
        panel = self.panel(commands.Triangulate, self.part)
        field = self.add(panel, self.other, "Face1", "Face2")
        self.assertIsNone(field.value())
        self.assertIn("Other", field.refusal.text())
        self.assertIn("Asm", field.refusal.text())
        field = self.add(panel, self.part, "B1.Edge2")
        self.assertEqual(field.refusal.text(), "")
        self.assertIn("B1.Edge2=", field.value())
        panel.reject()

    def test_the_source_inside_a_container(self):
        panel = self.panel(commands.Triangulate, self.document.B2)
        field = self.add(panel, self.part, "B2.Face6")
        self.assertRegex(field.value(), r"^Face6=")
        field = self.add(panel, self.part, "B1.Face6")
        self.assertEqual(field.value().count("="), 1)
        self.assertIn("B1", field.refusal.text())
        panel.reject()

    def test_a_link_to_a_container(self):
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.part
        link.Placement.Base.y = 100
        self.document.recompute()
        panel = self.panel(commands.Triangulate, link)
        self.assertRegex(self.add(panel, link, "B2.Face6").value(), r"^B2\.Face6=")
        panel.options.set_values({"local_sizes": "B2.Face6=0.5"})
        self.finish(panel)
        self.assertEqual(panel.said, "")
        self.assertGreater(self.counts(self.document.Objects[-1])[11], 500)

    def test_a_body_has_the_faces_of_its_tip(self):
        body = self.document.addObject("PartDesign::Body", "Body")
        body.newObject("PartDesign::AdditiveBox", "Feature")
        self.document.recompute()
        panel = self.panel(commands.Triangulate, body)
        self.assertRegex(self.add(panel, body, "Feature.Face6").value(), r"^Face6=")
        panel.reject()

    def test_of_several_objects_none_is_taken(self):
        panel = self.panel(commands.Triangulate, self.document.B1, self.document.B2)
        field = self.add(panel, self.document.B1, "Face6")
        self.assertIsNone(field.value())
        self.assertIn("one object", field.refusal.text())
        panel.reject()

    def test_nothing_selected(self):
        panel = self.panel(commands.Triangulate, self.part)
        self.assertIn("Select", self.add(panel, self.part).refusal.text())
        panel.reject()
