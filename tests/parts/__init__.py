# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts for tests, benchmarks and the demo, modelled on the spot by FreeCAD's Part module.

Every function returns a valid Part.Solid and takes no argument: the same part every time.
"""

from .bracket import bracket
from .die import die
from .wing import flap, wing_main

ALL = {"die": die, "wing_main": wing_main, "flap": flap, "bracket": bracket}

__all__ = ["ALL", "bracket", "die", "flap", "wing_main"]
