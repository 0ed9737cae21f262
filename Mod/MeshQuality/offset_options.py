# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of offsets and hollowed solids, in tables as those of options. Imports nothing of FreeCAD."""

from .options import THREADS, Option

TOLERANCE = Option("tolerance", float, None, unit="mm", low=0.0, title="Tolerance", group="Accuracy",
                   unset="size / 1000, at most a tenth of the distance",
                   help="Largest distance between the result and the exact one, in both directions")

OFFSET = (
    Option("distance", float, None, unit="mm", title="Distance", group="Offset", unset="must be given",
           help="How far the surface moves: outward, or inward where it is below 0"),
    TOLERANCE, THREADS,
)

HOLLOW = (
    Option("thickness", float, None, unit="mm", low=0.0, title="Thickness", group="Hollow", unset="must be given",
           help="Thickness of the wall, which grows inward from the surface"),
    TOLERANCE, THREADS,
)
