# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python lines of docs/mesh-objects.md run, and say what the guide says."""

import contextlib
import io
import os
import re

import FreeCAD
import helpers


class Guide(helpers.DocumentTest):
    def test_its_lines_run(self):
        path = os.path.join(helpers.ROOT, "docs", "mesh-objects.md")
        with open(path, encoding="utf-8") as stream:
            blocks = re.findall(r"```python\n(.*?)```", stream.read(), re.DOTALL)
        self.assertEqual(len(blocks), 8)
        FreeCAD.setActiveDocument(self.document.Name)
        names, printed = {"App": FreeCAD, "folder": self.folder}, io.StringIO()
        with contextlib.redirect_stdout(printed):
            for block in blocks:
                exec(block, names)  # noqa: S102 - what a reader types
        lines = printed.getvalue().splitlines()
        self.assertEqual(lines[0], "Absolute")
        self.assertEqual(lines[1], "met")
        self.assertTrue(lines[2].startswith("out of date"))
        self.assertEqual(lines[3], "up to date")
        self.assertEqual(lines[4], "6")
        self.assertEqual(names["mesh"].DistanceBound, "Relative")
        self.assertEqual(names["mesh"].MaxEdge.Value, 2.0)
        self.assertAlmostEqual(names["mesh"].Mesh.BoundBox.ZLength, 10)
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "box.msh")), 100)
