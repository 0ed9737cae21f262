# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of wraps, in tables as those of table. Imports nothing of FreeCAD."""

import math

from .table import MUST_BE_GIVEN, THREADS, Option

GAP = Option("gap", float, None, unit="mm", low=0.0, title="Gap", group="Wrap", unset=MUST_BE_GIVEN, suggested=(0.02, math.inf),
             help="Width of a ball that rolls over the objects from outside: openings narrower than this are closed")
TOLERANCE = Option("tolerance", float, None, unit="mm", low=0.0, title="Max. deviation", group="Wrap",
                   unset="by size and gap",
                   help="Largest distance between the wrap and the surfaces that it lies on, at most half of the gap; unless "
                        "given, a quarter of the gap, at most a fiftieth of the size")

WRAP = (GAP, TOLERANCE, THREADS)

# Of document objects.
WRAP_OBJECT = (GAP, TOLERANCE)
