# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of adapt, a table as those of table.py. Imports nothing of FreeCAD."""

from .table import Option

ADAPT = (
    Option("target_error", float, 0.05, low=0.0, high=1.0, group="Adapt", title="Target of the error",
           help="Estimated relative error of the strains at which the work ends"),
    Option("max_unknowns", int, 200_000, low=1, high=2**31 - 1, above=False, group="Adapt", title="Most unknowns",
           help="No mesh is made that is expected to have more unknowns"),
    Option("steps", int, 8, low=1, high=100, above=False, group="Adapt", title="Steps", help="Most meshes that are made"),
)
