# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/reference.md says what the docstrings say, and these are there."""

import inspect
import sys
import unittest
from pathlib import Path

import MeshQuality as mq

ROOT = Path(__file__).resolve().parents[2]


class Reference(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, str(ROOT / "tools"))
        try:
            import reference  # noqa: PLC0415
        finally:
            sys.path.pop(0)
        cls.reference = reference

    def test_the_page_is_up_to_date(self):
        self.assertEqual(self.reference.PAGE.read_text(encoding="utf-8"), self.reference.page(),
                         "run tools/reference")

    def test_everything_public_has_a_docstring(self):
        for name in self.reference.public_names():
            value = getattr(mq, name)
            self.assertTrue(inspect.getdoc(value), name)
            for member, held in self.reference.members(value) if inspect.isclass(value) else []:
                self.assertTrue(inspect.getdoc(held), f"{name}.{member}")

    def test_docstrings_name_every_parameter(self):
        for name in self.reference.public_names():
            value = getattr(mq, name)
            if not inspect.isfunction(value):
                continue
            text = inspect.getdoc(value)
            for parameter in inspect.signature(value).parameters.values():
                if parameter.kind in (parameter.VAR_KEYWORD, parameter.VAR_POSITIONAL):
                    continue
                self.assertIn(parameter.name, text, name)
