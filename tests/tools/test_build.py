# SPDX-License-Identifier: LGPL-2.1-or-later
"""tools/build installs the packages that the release of Debian has."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
# What apt-cache writes behind the candidate is more than a pipe holds: it ends by a signal where nobody reads it.
APT_CACHE = """#!/bin/bash
echo "$2:"
echo "  Installed: (none)"
case "$2" in
    python3-pyarrow) echo "  Candidate: (none)" ;;
    *) echo "  Candidate: 5.2-1" ;;
esac
echo "  Version table:"
for ((i = 0; i < 20000; ++i)); do echo "     5.2-1 500"; done
"""
APT_GET = """#!/bin/bash
echo "$@" >>"$APT_LOG"
"""
# All packages but the optional ones are there.
DPKG_QUERY = """#!/bin/bash
for name in "$@"; do
    case "$name" in
        -*|*Package*) ;;
        calculix-ccx|python3-pyarrow|gcovr|python3-coverage) ;;
        *) echo "$name installed" ;;
    esac
done
"""
SUDO = """#!/bin/bash
exec "$@"
"""


class Packages(unittest.TestCase):
    def test_optional_packages_of_the_release_are_installed(self):
        with tempfile.TemporaryDirectory() as folder:
            programs = {"apt-cache": APT_CACHE, "apt-get": APT_GET, "dpkg-query": DPKG_QUERY, "sudo": SUDO}
            for name, text in programs.items():
                Path(folder, name).write_text(text, encoding="utf-8")
                Path(folder, name).chmod(0o755)
            log = Path(folder, "log")
            log.touch()
            environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "APT_LOG": str(log)}
            done = subprocess.run(["bash", str(ROOT / "tools" / "build"), "--packages"], env=environment,
                                  capture_output=True, text=True, timeout=60, check=True)
            installed = log.read_text(encoding="utf-8")
        self.assertIn("not in this release of Debian: python3-pyarrow", done.stdout)
        for name in ("calculix-ccx", "gcovr", "python3-coverage"):
            self.assertIn(f" {name}", installed, done.stdout)
            self.assertNotIn(f"not in this release of Debian: {name}", done.stdout)


if __name__ == "__main__":
    unittest.main()
