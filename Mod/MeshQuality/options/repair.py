# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of repairs, in tables as those of table. Imports nothing of FreeCAD."""

from .table import THREADS, Option

TOLERANCE = Option("tolerance", float, None, unit="mm", low=0.0, title="Max. deviation", group="Repair", unset="size / 300",
                   help="Largest distance between the repaired surface and the given one, but for holes that are closed")

REPAIR = (TOLERANCE, THREADS)

# For document objects.
REPAIR_OBJECT = (TOLERANCE,)
