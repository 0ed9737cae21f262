# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of the simplification of meshes, a table as those of table.py. Imports nothing of FreeCAD."""

from .table import Option

SIMPLIFY = (
    Option("tolerance", float, None, unit="mm", low=0.0, group="Accuracy", title="Max. deviation", unset="size / 1000",
           help="Largest distance between the given mesh and the simplified one"),
    Option("feature_angle", float, 35.0, unit="degrees", low=0.0, high=180.0, group="Accuracy", title="Feature angle",
           help="Edges where the surface turns by more than this are sharp and keep their place"),
)
