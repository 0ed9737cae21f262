# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of volume meshes with layers, a table as those of table.py. Imports nothing of FreeCAD."""

from .table import MUST_BE_GIVEN, TRIANGULATE, Option

# Of the surface that is filled: as triangulate has them.
SURFACE = tuple(option for option in TRIANGULATE if option.name in ("min_angle", "chord_height", "chord_height_relative", "max_edge",
                                                                    "local_sizes"))

VOLUME = (
    Option("layers", int, None, low=1, high=100, above=False, group="Layers", title="Layers", unset=MUST_BE_GIVEN,
           help="Number of layers of prisms on the walls"),
    Option("first_height", float, None, unit="mm", low=0.0, group="Layers", title="First height", unset=MUST_BE_GIVEN,
           suggested=(0.002, 0.1), help="Height of the layer on the wall"),
    Option("growth_rate", float, 1.2, low=1.0, high=4.0, above=False, group="Layers", title="Growth of layers",
           help="How many times as high each layer is as the one before it"),
    Option("far_edge", float, None, unit="mm", low=0.0, group="Far field", title="Longest edge far away", unset="a fifth of its distance",
           help="Longest edges of triangles on the far field"),
    *SURFACE,
)
