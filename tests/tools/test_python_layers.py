# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layers of Mod/MeshQuality hold on this tree, and the checks find each kind of fault on a small one."""

import tempfile
import unittest
from pathlib import Path

import python_layers

ROOT = Path(__file__).resolve().parents[2]
GOOD = {
    "__init__": "from .errors import Error\n",
    "errors": "import json\n",
    "core/sources": "from ..errors import Error\n",
    "core/curving": "from .. import errors\nfrom . import sources\n",
    "features/__init__": "",
    "features/quality_mesh": "from ..core.curving import triangulate\nfrom . import work\n",
    "features/work": "import FreeCAD\n",
    "gui/__init__": "",
    "gui/panel": "from ..features import quality_mesh\nimport MeshQuality.errors\n",
}


class Tree(unittest.TestCase):
    """One test a rule on the tree itself."""

    def assert_kept(self, check):
        faults = check(ROOT)
        self.assertFalse(faults, "\n" + "\n".join(faults))

    def test_layers_are_declared_from_low_to_high(self):
        self.assert_kept(python_layers.check_declared)

    def test_imports_follow_the_layers(self):
        self.assert_kept(python_layers.check_layers)

    def test_core_has_rows(self):
        self.assert_kept(python_layers.check_core)

    def test_no_circles(self):
        self.assert_kept(python_layers.check_circles)

    def test_private_names_stay_in_their_modules(self):
        self.assert_kept(python_layers.check_private_names)


class SmallTree(unittest.TestCase):
    """The checks on temporary trees."""

    def faults(self, check, **changes):
        """Faults of the good tree with modules added or replaced; `__` between two letters stands for a slash."""
        texts = {**GOOD, **{name.replace("__", "/"): text for name, text in changes.items()}}
        with tempfile.TemporaryDirectory() as folder:
            for name, text in texts.items():
                path = Path(folder, "Mod", "MeshQuality", f"{name}.py")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return check(Path(folder))

    def test_good_tree_passes(self):
        for check in python_layers.CHECKS:
            self.assertEqual(self.faults(check), [], check.__name__)

    def test_an_import_of_a_higher_layer(self):
        found = self.faults(python_layers.check_layers, features__work="from ..gui import panel\n")
        self.assertEqual(found, ["MeshQuality.features.work:1: features may not import MeshQuality.gui.panel"])

    def test_an_import_of_a_higher_row_of_core(self):
        found = self.faults(python_layers.check_core, core__sources__shape="from ..certify import verdict\n", core__certify__verdict="")
        self.assertEqual(found, ["MeshQuality.core.sources.shape:1: core.sources may not import MeshQuality.core.certify.verdict"])

    def test_one_inside_a_function(self):
        text = "def add():\n    from ..features.work import x\n"
        self.assertEqual(self.faults(python_layers.check_layers, core__curving=text),
                         ["MeshQuality.core.curving:2: core may not import MeshQuality.features.work"])

    def test_ways_to_write_it(self):
        for text in ("import MeshQuality.gui.panel\n", "from MeshQuality.gui import panel\n",
                     "from MeshQuality.gui.panel import x\n", "from ..gui.panel import x\n"):
            self.assertEqual(len(self.faults(python_layers.check_layers, features__work=text)), 1, text)

    def test_the_package_itself_is_no_way_around(self):
        found = self.faults(python_layers.check_layers, core__sources="import MeshQuality as mq\n")
        self.assertEqual(found, ["MeshQuality.core.sources:1: core may not import MeshQuality"])

    def test_a_layer_beside(self):
        found = self.faults(python_layers.check_layers, cli__job="from ..gui.panel import x\n")
        self.assertEqual(found, ["MeshQuality.cli.job:1: cli may not import MeshQuality.gui.panel"])

    def test_a_module_without_layer(self):
        found = self.faults(python_layers.check_layers, heap="")
        self.assertEqual(found, ["MeshQuality.heap has no layer in tests/tools/python_layers.py"])

    def test_a_circle_within_a_layer(self):
        text = "def compute():\n    from . import quality_mesh\n"
        found = self.faults(python_layers.check_circles, features__work=text)
        self.assertEqual(found, ["MeshQuality.features.quality_mesh -> MeshQuality.features.work -> "
                                 "MeshQuality.features.quality_mesh is a circle"])

    def test_each_circle_once(self):
        found = self.faults(python_layers.check_circles, errors="from .core import curving\n")
        self.assertEqual(len(found), 1)

    def test_a_private_name(self):
        found = self.faults(python_layers.check_private_names, features__work="from ..core.curving import _check, x\n")
        self.assertEqual(found, ["MeshQuality.features.work:1: _check is private to MeshQuality.core.curving"])


if __name__ == "__main__":
    unittest.main()
