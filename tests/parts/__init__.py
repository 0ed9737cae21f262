# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts for tests, benchmarks and the demo, modelled on the spot by FreeCAD's Part module.

Every function returns a valid Part.Solid (bearing: a compound of solids) and takes no argument: the same part every time.
"""

from .bracket import bracket
from .die import die
from .sampled import bearing, crank, helix, support, warped_face
from .wing import flap, wing_main

ALL = {"die": die, "wing_main": wing_main, "flap": flap, "bracket": bracket, "bearing": bearing,
       "helix": helix, "crank": crank, "support": support}

__all__ = ["ALL", "bearing", "bracket", "crank", "die", "flap", "helix", "support", "warped_face",
           "wing_main"]
