# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of every operation, in tables: those of triangulate, curve, boolean and improve here, the others in a module
an operation. Imports nothing of FreeCAD.
"""

from . import adapt, cam, fem, inspection, offset, repair, simplify, volume, wrap  # noqa: F401
from .table import *  # noqa: F403
