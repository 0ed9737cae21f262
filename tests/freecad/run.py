# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the tests of this folder inside FreeCAD; the last line is 'N passed, N failed'.

    freecadcmd -P <root>/Mod tests/freecad/run.py </dev/null
MESHQUALITY_TESTS=test_shapes[.Class[.method]] runs a part of them. MESHQUALITY_COVERAGE=FILE writes there which
lines of Mod they ran in this FreeCAD, for `python3 -m coverage report`.
"""

import contextlib
import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]


@contextlib.contextmanager
def counted_lines(path):
    """Writes the lines of Mod that run meanwhile into the file, of all threads."""
    import coverage  # noqa: PLC0415  needed here only

    counter = coverage.Coverage(data_file=path, branch=True, source=[str(HERE.parents[1] / "Mod")])
    counter.start()
    try:
        yield
    finally:
        counter.stop()
        counter.save()


def main():
    path = os.environ.get("MESHQUALITY_COVERAGE")
    with counted_lines(path) if path else contextlib.nullcontext():
        import helpers  # noqa: PLC0415  on the path only now

        chosen = os.environ.get("MESHQUALITY_TESTS", "").split()
        return 1 if helpers.run_tests(str(HERE), chosen, sys.stdout) else 0


sys.exit(main())
