# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exit statuses of the program, and of a job in FreeCAD."""

DONE, FAILED, USAGE, MISSED = 0, 1, 2, 3
