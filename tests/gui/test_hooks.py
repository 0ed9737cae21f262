# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window answers all that document objects ask of it."""

import unittest

from MeshQuality.features import gui_hooks
from MeshQuality.gui import hooks


class Hooks(unittest.TestCase):
    def test_the_window_answers(self):
        self.assertIs(gui_hooks.window(), hooks.WINDOW)

    def test_it_leaves_no_question_open(self):
        asked = {name for name in vars(gui_hooks.Windowless) if not name.startswith("_")}
        self.assertEqual(asked - set(vars(hooks.Window)), set())
