# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the tests of this folder inside FreeCAD; the last line is 'N passed, N failed'.

    freecadcmd -P <root>/Mod tests/freecad/run.py </dev/null
MESHQUALITY_TESTS=test_shapes[.Class[.method]] runs a part of them.
"""

import os
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]


def main():
    loader = unittest.TestLoader()
    chosen = os.environ.get("MESHQUALITY_TESTS")
    suite = loader.loadTestsFromNames(chosen.split()) if chosen else loader.discover(str(HERE))
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    # A test with several failed sub-tests counts once.
    faults = [test for test, _ in result.failures + result.errors] + result.unexpectedSuccesses
    failed = len({getattr(test, "test_case", test).id() for test in faults})
    for test, why in result.skipped:
        print(f"skipped: {test.id()}: {why}")
    passed = result.testsRun - failed - len(result.skipped)
    print(f"{passed} passed, {failed} failed", flush=True)
    return 1 if failed or result.testsRun == 0 else 0


sys.exit(main())
