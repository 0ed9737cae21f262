# SPDX-License-Identifier: LGPL-2.1-or-later
"""How curved meshes look: smooth elements, their curved edges, colours by quality."""

import os
import subprocess

import FreeCAD
import FreeCADGui
import gui_helpers
import helpers
import numpy as np

import MeshQuality as mq
from MeshQuality.gui import curved_view

HEADLESS = """
import sys
import FreeCAD
import MeshQuality as mq
document = FreeCAD.newDocument()
sphere = document.addObject("Part::Sphere", "Sphere")
document.recompute()
mq.add_curved_mesh(sphere, order=3, chord_height_relative=0.05)
document.saveAs({path!r})
sys.exit(0)  # FreeCAD 1.1 crashes when it ends by itself with a document that has a mesh
"""


def share(pixels, chosen):
    """Which part of all pixels that are not background is chosen."""
    return (chosen & ~background(pixels)).sum() / max((~background(pixels)).sum(), 1)


def background(pixels):
    return (pixels > 250).all(axis=2)


class CurvedView(gui_helpers.GuiTest):
    def sphere(self, **values):
        source = self.document.addObject("Part::Sphere", "Sphere")
        source.Radius = 10
        self.document.recompute()
        source.ViewObject.Visibility = False
        obj = mq.add_curved_mesh(source, chord_height_relative=0.05, **values)
        gui_helpers.wait()
        return obj

    def test_it_shows_curved_elements_with_their_edges(self):
        obj = self.sphere(order=3)
        self.assertEqual(obj.ViewObject.DisplayMode, curved_view.MODE)
        self.assertIn("Shaded", obj.ViewObject.listDisplayModes())
        with_edges = self.picture("curved_edges")
        # A sphere's outline is a circle, however few elements there are.
        rows, columns = np.nonzero(~background(with_edges))
        filled = len(rows) / ((np.ptp(rows) + 1) * (np.ptp(columns) + 1))
        self.assertAlmostEqual(filled, np.pi / 4, delta=0.01)
        obj.ViewObject.DisplayMode = "Shaded"
        plain = self.picture("curved_shaded")
        drawn = (with_edges < 40).all(axis=2) & (plain > 100).all(axis=2)
        self.assertGreater(share(with_edges, drawn), 0.02)

    def test_edges_are_those_of_elements_not_of_the_triangles_shown(self):
        coarse = self.picture_of_edges(self.sphere(order=3, deviation=0.2))
        fine = self.picture_of_edges(self.sphere(order=3, deviation=0.002))
        self.assertAlmostEqual(coarse, fine, delta=0.25 * coarse)

    def picture_of_edges(self, obj):
        pixels = self.picture("curved_fine")
        obj.ViewObject.Visibility = False
        return share(pixels, (pixels < 60).all(axis=2))

    def test_hiding_hides_the_edges(self):
        obj = self.sphere()
        obj.ViewObject.Visibility = False
        self.assertTrue(background(self.picture("curved_hidden")).all())

    def test_colours_show_the_scaled_jacobian(self):
        source = self.document.addObject("Part::Torus", "Torus")
        self.document.recompute()
        source.ViewObject.Visibility = False
        obj = mq.add_curved_mesh(source, order=2, volume=True)
        grey = self.picture("curved_torus")
        self.assertLess(share(grey, np.ptp(grey, axis=2) > 60), 0.01)
        obj.ViewObject.ColorBy = curved_view.JACOBIAN
        coloured = self.picture("curved_jacobian")
        self.assertGreater(share(coloured, np.ptp(coloured, axis=2) > 60), 0.5)
        self.assertFalse(obj.MustExecute or "Touched" in obj.State)
        obj.ViewObject.ColorBy = curved_view.PLAIN
        obj.ViewObject.ShapeColor = (1.0, 0.2, 0.2)
        red = self.picture("curved_red")
        self.assertGreater(share(red, red[:, :, 0] > red[:, :, 2] + 60), 0.5)

    def test_it_follows_the_source_and_its_placement(self):
        obj = self.sphere()
        obj.Source.Radius = 20
        self.document.recompute()
        self.assertAlmostEqual(obj.ViewObject.RootNode and obj.Mesh.BoundBox.XLength, 40, delta=0.2)
        first = self.picture("curved_twenty")
        obj.Source.Placement.Base = FreeCAD.Vector(1e5, 0, 0)
        self.document.recompute()
        self.assertGreater(obj.Mesh.BoundBox.Center.x, 9e4)
        moved = self.picture("curved_far")
        self.assertLess(np.abs(background(first).sum() - background(moved).sum()),
                        0.02 * background(first).size)

    def test_it_comes_back_from_a_file(self):
        obj = self.sphere(order=4)
        obj.ViewObject.ColorBy = curved_view.JACOBIAN
        name, before = obj.Name, self.picture("curved_saved")
        self.reopen()
        gui_helpers.wait(0.2)
        view = self.document.getObject(name).ViewObject
        self.assertEqual((view.DisplayMode, view.ColorBy), (curved_view.MODE,
                                                            curved_view.JACOBIAN))
        self.view = FreeCADGui.getDocument(self.document.Name).activeView()
        after = self.picture("curved_reloaded")
        self.assertLess((np.abs(after - before).max(axis=2) > 40).mean(), 0.01)

    def test_a_document_that_was_saved_without_a_window_gets_the_view(self):
        path = os.path.join(self.folder, "headless.FCStd")
        script = os.path.join(self.folder, "make.py")
        with open(script, "w", encoding="utf-8") as stream:
            stream.write(HEADLESS.format(path=path))
        subprocess.run(["freecadcmd", "-P", os.path.join(helpers.ROOT, "Mod"), script], timeout=120,
                       stdin=subprocess.DEVNULL, capture_output=True, check=True)
        self.replace(path)
        gui_helpers.wait(0.2)
        obj = self.document.getObject("CurvedMesh")
        obj.ViewObject.Visibility = True  # FreeCAD hides all of what was made without a window
        self.assertEqual(obj.ViewObject.DisplayMode, curved_view.MODE)
        self.view = FreeCADGui.getDocument(self.document.Name).activeView()
        shown = self.picture("curved_headless")
        obj.ViewObject.DisplayMode = "Shaded"
        plain = self.picture("curved_headless_shaded")
        drawn = (shown < 40).all(axis=2) & (plain > 100).all(axis=2)
        self.assertGreater(share(shown, drawn), 0.02)

    def test_it_can_be_picked_and_shows_that_it_is_selected(self):
        obj = self.sphere()
        plain = self.picture("curved_unselected")
        width, height = self.view.getSize()
        picked = self.view.getObjectInfo((width // 2, height // 2))
        self.assertEqual(picked["Object"], obj.Name)
        FreeCADGui.Selection.addSelection(obj)
        selected = self.picture("curved_selected")
        FreeCADGui.Selection.clearSelection()
        self.assertGreater((np.abs(selected - plain).max(axis=2) > 40).mean(), 0.0005)

    def test_undo_and_redo(self):
        obj = self.sphere()
        shown, name = self.picture("curved_before_undo"), obj.Name
        self.document.undo()
        self.assertTrue(background(self.picture("curved_undone")).all())
        self.document.redo()
        self.assertIsNotNone(self.document.getObject(name))
        again = self.picture("curved_redone")
        self.assertLess((np.abs(again - shown).max(axis=2) > 40).mean(), 0.01)
