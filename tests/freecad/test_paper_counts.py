# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/papers.md has what its commands give: counts and qualities, of commands that take seconds."""

import os
import re
import subprocess
import unittest

import helpers


class DeyQuality(unittest.TestCase):
    def test_the_page_has_what_the_command_prints(self):
        with open(os.path.join(helpers.ROOT, "docs", "papers.md"), encoding="utf-8") as stream:
            section = stream.read().partition("benchmarks/papers dey-quality")[2].partition("\n### ")[0]
        page = {row[0]: row[1:] for line in section.splitlines() if line.startswith("| ")
                for row in [[cell.strip() for cell in line.strip("|").split("|")]] if len(row) == 7}
        command = ["/usr/bin/python3", os.path.join(helpers.ROOT, "benchmarks", "papers"), "dey-quality"]
        done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        names = [name for name in page if re.fullmatch("[a-z]+", name) and name != "solid"]
        self.assertEqual(len(names), 6)
        for name in names:
            with self.subTest(name):
                printed = re.search(rf"^{name} +(.*)$", done.stdout, re.M)
                self.assertEqual(printed[1].split()[:6], page[name])
