# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program, and a job in FreeCAD, ends with."""

DONE, FAILED, USAGE, MISSED = 0, 1, 2, 3
