# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of docs/ that show FreeCAD:   python3 tests/gui/run.py doc_pictures"""

import os

import FreeCAD
import gui_helpers
import helpers
import Part

import MeshQuality as mq
from MeshQuality.gui import curved_view

DOCS = os.path.join(helpers.ROOT, "docs")


class Pictures(gui_helpers.GuiTest):
    def test_curved_elements(self):
        source = self.document.addObject("Part::Feature", "Elbow")
        source.Shape = Part.makeTorus(20, 8, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), -180, 180,
                                      110).cut(Part.makeTorus(20, 5))
        self.document.recompute()
        source.ViewObject.Visibility = False
        obj = mq.add_curved_mesh(source, order=3, volume=True, chord_height_relative=0.03)
        self.assertEqual(obj.Invalid, 0)
        self.picture("curved_elements", DOCS)
        obj.ViewObject.ColorBy = curved_view.JACOBIAN
        self.picture("curved_jacobian", DOCS)
