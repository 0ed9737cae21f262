# SPDX-License-Identifier: LGPL-2.1-or-later
"""What run.py has FreeCAD execute: all tests of this folder, once the window is up; then it closes."""

import os
import sys
import traceback
import unittest

import FreeCAD
import FreeCADGui
from PySide import QtCore

HERE = os.path.dirname(os.path.abspath(__file__))
START = 300  # ms until the window has been drawn


def run_tests(stream):
    """Runs the tests and writes 'N passed, N failed'."""
    sys.path[:0] = [HERE, os.path.join(os.path.dirname(HERE), "freecad")]
    loader = unittest.TestLoader()
    chosen = os.environ["MESHQUALITY_GUI_TESTS"].split()
    suite = loader.loadTestsFromNames(chosen) if chosen else loader.discover(HERE)
    result = unittest.TextTestRunner(stream=stream, verbosity=2).run(suite)
    faults = [test for test, _ in result.failures + result.errors] + result.unexpectedSuccesses
    failed = len({getattr(test, "test_case", test).id() for test in faults})
    for test, why in result.skipped:
        stream.write(f"skipped: {test.id()}: {why}\n")
    passed = result.testsRun - failed - len(result.skipped)
    stream.write(f"{passed} passed, {max(failed, int(result.testsRun == 0))} failed\n")


def main():
    with open(os.environ["MESHQUALITY_GUI_RESULT"], "w", encoding="utf-8") as stream:
        try:
            run_tests(stream)
        except Exception:  # noqa: BLE001 - what goes wrong must reach the result, not a report view
            stream.write(traceback.format_exc() + "0 passed, 1 failed\n")
    # An open document would have the window ask whether to save.
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    FreeCADGui.getMainWindow().close()


QtCore.QTimer.singleShot(START, main)
