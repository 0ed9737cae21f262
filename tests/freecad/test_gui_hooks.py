# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects where there is no window: they ask, and load nothing of it. What FreeCAD's window loads as it starts."""

import os
import subprocess
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


class Start(helpers.DocumentTest):
    def test_registration_loads_neither_numpy_nor_the_binary(self):
        with open(os.path.join(helpers.ROOT, "InitGui.py"), encoding="utf-8") as stream:
            imports = [line for line in stream if line.startswith(("import ", "from "))]
        self.assertIn("from MeshQuality.gui import preferences, translation\n", imports)
        script = os.path.join(self.folder, "start.py")
        with open(script, "w", encoding="utf-8") as stream:
            stream.write("".join(imports) + "import sys\nprint('loaded', [name for name in ('MeshQuality.gui', 'numpy', 'MeshQuality._core') "
                         "if name in sys.modules], flush=True)\nsys.exit(0)\n")
        told = subprocess.run(["freecadcmd", "-P", os.path.join(helpers.ROOT, "Mod"), script], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=True).stdout
        self.assertIn("loaded ['MeshQuality.gui']\n", told)


def gui_modules():
    """Those of the window that are loaded."""
    return [name for name in sys.modules if name.startswith("MeshQuality.gui")]
