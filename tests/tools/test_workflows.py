# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workflows of .github are thin: all that they run is Debian's packages and tools that exist and know what they are given."""

import re
import unittest
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[2]
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))


def commands(workflow):
    """The commands of all steps of a workflow that was read."""
    return [step["run"] for job in workflow["jobs"].values() for step in job["steps"] if "run" in step]


class Workflows(unittest.TestCase):
    def test_each_runs_only_packages_and_tools_with_options_that_they_have(self):
        self.assertGreaterEqual(len(WORKFLOWS), 3)
        for path in WORKFLOWS:
            calls = [command for command in commands(yaml.safe_load(path.read_text(encoding="utf-8")))
                     if not re.fullmatch(r"apt-get -q update && apt-get -q install -y [a-z0-9 -]+|git config --global [^&;|]+", command)]
            self.assertTrue(calls, path.name)
            for call in calls:
                parts = re.fullmatch(r"(bash|python3) (tools/[\w-]+)([^&;|]*)", re.sub(r"&&|\|\||[${}]", "", call))
                self.assertTrue(parts, f"{path.name}: {call}")
                interpreter, tool, arguments = parts.groups()
                text = (ROOT / tool).read_text(encoding="utf-8")
                self.assertEqual(text.partition("\n")[0], f"#!/usr/bin/env {interpreter}", f"{path.name}: {call}")
                for option in re.findall(r"--[\w-]+", arguments):
                    self.assertTrue(re.search(rf"(?<![\w-]){option}(?![\w-])", text), f"{path.name}: {call}: {option}")

    def test_scripts_have_the_options_that_they_are_given(self):
        for path in WORKFLOWS:
            for line in "\n".join(commands(yaml.safe_load(path.read_text(encoding="utf-8")))).splitlines():
                script = re.search(r"\b(?:bash|python3) +(tools/[\w./-]+)(.*)", line)
                for option in re.findall(r"(?<![\w-])--[a-z-]+", script[2]) if script else ():
                    self.assertRegex((ROOT / script[1]).read_text(encoding="utf-8"), rf"{option}\b", f"{path.name}: {line}")

    def test_each_job_has_a_machine_and_a_limit_of_time(self):
        for path in WORKFLOWS:
            for name, job in yaml.safe_load(path.read_text(encoding="utf-8"))["jobs"].items():
                self.assertIn("runs-on", job, f"{path.name}: {name}")
                self.assertLessEqual(job["timeout-minutes"], 360, f"{path.name}: {name}")
                for step in job["steps"]:
                    self.assertEqual(len({"run", "uses"} & set(step)), 1, f"{path.name}: {name}: {step}")


if __name__ == "__main__":
    unittest.main()
