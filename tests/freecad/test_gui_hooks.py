# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects where there is no window: they ask, and load nothing of it."""

import sys

import helpers

import MeshQuality as mq
from MeshQuality.features import gui_hooks


class Windowless(helpers.DocumentTest):
    def test_objects_load_nothing_of_the_window(self):
        box = self.box()
        # Only these: what objects load meanwhile, such as Fem, cannot be loaded twice.
        loaded = {name: sys.modules.pop(name) for name in gui_modules()}  # that other tests have loaded
        self.addCleanup(sys.modules.update, loaded)
        mesh = mq.add_quality_mesh(box)
        mq.add_curved_mesh(box)
        mq.add_fem_mesh(box)
        mq.add_improved_mesh(mesh)
        mq.add_boolean(mesh, box)
        self.assertEqual(gui_modules(), [])
        self.assertIs(gui_hooks.window(), gui_hooks.WINDOWLESS)


def gui_modules():
    """Those of the window that are loaded."""
    return [name for name in sys.modules if name.startswith("MeshQuality.gui")]
