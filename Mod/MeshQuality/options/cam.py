# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of meshes for machining, a table as those of table.py. Imports nothing of FreeCAD."""

from .table import MUST_BE_GIVEN, Option

SIDES = ("outside", "inside")

CAM = (
    Option("tolerance", float, None, unit="mm", low=0.0, group="Accuracy", title="Max. deviation", unset=MUST_BE_GIVEN,
           suggested=(0.001, 0.05), help="Largest distance between the mesh and the part, on one side of it"),
    Option("side", str, "outside", choices=SIDES, group="Accuracy", title="Side", choice_titles=("Never inside the part", "Never outside the part"),
           help="outside: a tool that touches the mesh never cuts into the part; inside: the mesh never sticks out of it"),
)
