# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the tests of this folder inside FreeCAD; the last line is 'N passed, N failed'.

    freecadcmd -P <root>/Mod tests/freecad/run.py </dev/null
MESHQUALITY_TESTS=test_shapes[.Class[.method]] runs a part of them.
"""

import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]


def main():
    import helpers  # noqa: PLC0415  on the path only now

    chosen = os.environ.get("MESHQUALITY_TESTS", "").split()
    return 1 if helpers.run_tests(str(HERE), chosen, sys.stdout) else 0


sys.exit(main())
