# SPDX-License-Identifier: LGPL-2.1-or-later
"""What run.py has FreeCAD execute: all tests of this folder, once the window is up; then it closes."""

import faulthandler
import os
import sys
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore

HERE = os.path.dirname(os.path.abspath(__file__))
START = 300  # ms until the window has been drawn


def run_tests(stream):
    """Runs the tests and writes 'N passed, N failed'."""
    sys.path[:0] = [HERE, os.path.join(os.path.dirname(HERE), "freecad")]
    import helpers  # noqa: PLC0415  on the path only now

    helpers.run_tests(HERE, os.environ["MESHQUALITY_GUI_TESTS"].split(), stream)


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


faulthandler.enable(sys.__stderr__)  # the line of Python at which FreeCAD crashes, before FreeCAD's own words
QtCore.QTimer.singleShot(START, main)
