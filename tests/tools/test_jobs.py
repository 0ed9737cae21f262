# SPDX-License-Identifier: LGPL-2.1-or-later
"""tests/jobs.py counts what its jobs say, and those that say nothing; tools/unity_groups keeps apart what would not compile."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests"))
import jobs  # noqa: E402  on the path only now


def job(text):
    return jobs.Job("tools", "one", ["bash", "-c", text]).run()


class Jobs(unittest.TestCase):
    def test_counts(self):
        done = job("echo 1 passed, 1 failed; echo '12 passed, 3 failed'; exit 1")
        self.assertEqual((done.passed, done.failed), (12, 3))
        done = job("echo 12 passed, 0 failed")
        self.assertEqual((done.passed, done.failed, done.text), (12, 0, "12 passed, 0 failed\n"))

    def test_one_that_crashes_fails_and_is_named(self):
        done = job("echo test_it; kill -SEGV $$")
        self.assertEqual((done.passed, done.failed), (0, 1))
        self.assertRegex(done.text, "^test_it\\n\\ntools: one: ended with -11")
        self.assertEqual(job("echo 12 passed, 0 failed; exit 3").failed, 1)
        self.assertEqual(job("echo nothing to do").failed, 1)

    def test_one_that_hangs_fails_with_all_that_it_started(self):
        with mock.patch.object(jobs, "LIMIT", 0.3):
            done = job("sleep 60 & wait")
        self.assertEqual(done.failed, 1)
        self.assertLess(done.seconds, 30)
        self.assertIn("ended with -9", done.text)

    def test_each_has_folders_of_its_own(self):
        said = [job("echo $TMPDIR $FREECAD_USER_HOME; touch $TMPDIR/left; echo 1 passed, 0 failed").text for _ in range(2)]
        self.assertNotEqual(*said)
        self.assertFalse(any(Path(text.split()[0]).exists() for text in said))

    def test_nothing_is_left_out(self):
        names = {stage: {name for one in jobs.jobs_of(stage, True) for name in one.name.split()} for stage in jobs.STAGES}
        for stage in ("freecad", "gui"):
            self.assertEqual(names[stage], {path.stem for path in (ROOT / "tests" / stage).glob("test_*.py")})
        self.assertTrue({"known", "documents_edited", "command_line", "folders"} <= names["attacks"])
        self.assertTrue({"triangulate", "objects"} <= names["oracles"])
        known = {f"{stage}/{name}" for stage, these in names.items() for name in these}
        self.assertEqual(set(jobs.LONGEST) - known, set())
        self.assertNotIn("folders", [one.name for one in jobs.jobs_of("attacks", False)])


class UnityGroups(unittest.TestCase):
    def groups(self, **files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                Path(folder, name.replace("_h", ".h")).write_text(text, encoding="utf-8")
            sources = [name for name in files if not name.endswith("_h")]
            return subprocess.run([sys.executable, str(ROOT / "tools" / "unity_groups"), "3", *sources], cwd=folder,
                                  capture_output=True, text=True, check=True).stdout.splitlines()

    def test_names_of_anonymous_namespaces_are_kept_apart(self):
        inside = "namespace mq {\nnamespace {\n%s\n}  // namespace\nint f() { return 1; }\n}  // namespace mq\n"
        self.assertEqual(self.groups(a=inside % "constexpr int kOne = 1;", b=inside % "int kTwo() { return 2; }"), ["0 a", "0 b"])
        self.assertEqual(self.groups(a=inside % "constexpr int kOne = 1;", b=inside % "struct kOne {\n    int n;\n};"), [])
        self.assertEqual(self.groups(a=inside % "struct Leaf {\n    int n;\n};", c="int n;",
                                     b='#include "b.h"\n', b_h="namespace mq {\nstruct Leaf {};\n}  // namespace mq\n"),
                         ["0 a", "0 c"])

    def test_no_group_is_larger_than_allowed(self):
        self.assertEqual(self.groups(a="", b="", c="", d="", e=""), ["0 a", "0 b", "0 c", "1 d", "1 e"])


if __name__ == "__main__":
    unittest.main()
