# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python lines of docs/use/mesh-objects.md run, and say what the guide says."""

import contextlib
import io
import os
import re
import warnings

import FreeCAD
import helpers


class Guide(helpers.DocumentTest):
    def test_its_lines_run(self):
        path = os.path.join(helpers.ROOT, "docs", "use", "mesh-objects.md")
        with open(path, encoding="utf-8") as stream:
            blocks = re.findall(r"```python\n(.*?)```", stream.read(), re.DOTALL)
        self.assertEqual(len(blocks), 9)
        FreeCAD.setActiveDocument(self.document.Name)
        names, printed = {"App": FreeCAD, "folder": self.folder}, io.StringIO()
        with contextlib.redirect_stdout(printed), warnings.catch_warnings():
            warnings.filterwarnings("error", "MeshQuality", DeprecationWarning)
            for block in blocks:
                exec(block, names)  # noqa: S102 - what a reader types
        lines = printed.getvalue().splitlines()
        self.assertTrue(lines[0].startswith("max_edge cannot be changed: the property MaxEdge of 'Box quality mesh' is set"))
        self.assertEqual(lines[1], "Absolute")
        self.assertEqual(lines[2], "met")
        self.assertTrue(lines[3].startswith("out of date"))
        self.assertEqual(lines[4], "up to date")
        self.assertEqual(lines[5], "6")
        self.assertEqual(names["mesh"].DistanceBound, "Relative")
        self.assertEqual(names["mesh"].MaxEdge.Value, 2.0)
        self.assertAlmostEqual(names["mesh"].Mesh.BoundBox.ZLength, 10)
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "box.msh")), 100)
