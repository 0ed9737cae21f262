# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of offsets and hollowed solids, in tables as those of table. Imports nothing of FreeCAD."""

from .table import MUST_BE_GIVEN, THREADS, Option

TOLERANCE = Option("tolerance", float, None, unit="mm", low=0.0, title="Max. deviation", group="Accuracy",
                   unset="by size",
                   help="Largest distance between the result and the exact one, in both directions; unless given, a "
                        "thousandth of the size, at most a tenth of the distance")

DISTANCE = Option("distance", float, None, unit="mm", title="Distance", group="Offset", unset=MUST_BE_GIVEN, suggested=(0.02, 2.0),
                  help="How far the surface moves: outward, or inward where it is below 0")
THICKNESS = Option("thickness", float, None, unit="mm", low=0.0, title="Thickness", group="Hollow", unset=MUST_BE_GIVEN,
                   suggested=(0.1, 2.0), help="Thickness of the wall, which grows inward from the surface")
OPENINGS = Option("openings", list, None, title="Openings", group="Hollow", unset="none",
                  help="Faces of the shape that get no wall, so that the hollow reaches them; none: the hollow is closed")

OFFSET = (DISTANCE, TOLERANCE, THREADS)
HOLLOW = (THICKNESS, TOLERANCE, THREADS)

# Of document objects.
OFFSET_OBJECT = (DISTANCE, TOLERANCE)
HOLLOW_OBJECT = (THICKNESS, OPENINGS, TOLERANCE)
