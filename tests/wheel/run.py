# SPDX-License-Identifier: LGPL-2.1-or-later
"""Works with an unpacked wheel of tools/wheel in the FreeCAD that is here, for tools/wheel-test.

    /usr/bin/python3 tests/wheel/run.py PACKAGES [TEST ... | STAGE ... | bytes]
How long the import takes is measured. Without a stage, tests of tests/freecad (default: those of triangles, Booleans and bridges)
and 1,000 steps with two OpenCASCADEs in one process (MESHQUALITY_STEPS) are run with the package where FreeCAD's addon manager
would have put it. Stages are those of tests/jobs.py, such as freecad or gui. 'bytes' writes digests of meshes
(benchmarks/same_bytes.py) and compares them with BEFORE, where that is there. For both the package lies in Mod of this
tree. The last line is 'N passed, N failed'.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
LOGS, BEFORE = ROOT / "build" / "test-logs", ROOT / "before.json"
# Files that every FreeCAD reads alike, and meshes.
SAME = "refine *.brep", "boolean default *", "improve *"
DEFAULT = "test_triangulate", "test_boolean", "test_bridge"
LONGEST_IMPORT = 0.3  # s
IMPORT = ("import time, numpy, MeshQuality; from MeshQuality import compat; begin = time.perf_counter(); compat.extension(); "
          "print(time.perf_counter() - begin)")


def import_time(packages):
    """Whether the binary is imported fast enough: the least of five times, NumPy and the Python part of MeshQuality aside."""
    environment = {**os.environ, "PYTHONPATH": f"{ROOT / 'Mod'}:{packages}"}
    seconds = min(float(subprocess.run([sys.executable, "-c", IMPORT], env=environment, check=True, capture_output=True,
                                       text=True).stdout) for _ in range(5))
    print(f"import: {seconds:.3f} s", flush=True)
    return (1, 0) if seconds <= LONGEST_IMPORT else (0, 1)


def counted(*command, **environment):
    """(passed, failed) as a command says in its last line; one that ends without it failed."""
    process = subprocess.Popen([str(word) for word in command], env={**os.environ, **environment}, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    said = ""
    for line in process.stdout:
        print(line, end="", flush=True)
        said = line if re.match(r"\d+ passed, \d+ failed$", line) else said
    process.wait()
    passed, failed = map(int, re.findall(r"\d+", said)) if said else (0, 1)
    return passed, max(failed, int(process.returncode != 0))


def same_bytes():
    """Whether all meshes of SAME are made, and with the bytes of BEFORE where that is there."""
    LOGS.mkdir(parents=True, exist_ok=True)
    command = [sys.executable, ROOT / "benchmarks" / "same_bytes.py", "--seconds", 25, "--jobs", 1, "--out", LOGS / "same_bytes.json"]
    command += [word for pattern in SAME for word in ("--only", pattern)]
    command += ["--against", BEFORE] if BEFORE.exists() else []
    done = subprocess.run([str(word) for word in command], check=False)
    return (0, 1) if done.returncode else (1, 0)


def in_addon_managers_folder(packages, tests):
    with tempfile.TemporaryDirectory(prefix="wheel-") as home:
        Path(home, "AdditionalPythonPackages").symlink_to(packages)
        return [counted("freecadcmd", "-P", ROOT / "Mod", ROOT / "tests" / script, FREECAD_USER_HOME=home,
                        MESHQUALITY_TESTS=" ".join(tests))
                for script in ("freecad/run.py", "wheel/two_kernels.py")]


def main():
    packages, chosen = Path(sys.argv[1]).resolve(), sys.argv[2:]
    counts = [import_time(packages)]
    if not chosen or chosen[0].startswith("test_"):
        counts += in_addon_managers_folder(packages, chosen or DEFAULT)
    else:
        (ROOT / "Mod" / "meshquality_core").symlink_to(packages / "meshquality_core")
        jobs = sys.executable, ROOT / "tests" / "jobs.py", "--no-chance"
        counts.append(same_bytes() if chosen == ["bytes"] else counted(*jobs, *chosen))
    passed, failed = (sum(column) for column in zip(*counts))
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
