# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts at which times fell off a cliff."""

import FreeCAD
import Part

V = FreeCAD.Vector


def bars(count):
    """Bars of 20 x 2 x 2 through the z-axis, turned evenly."""
    found = []
    for i in range(count):
        bar = Part.makeBox(20, 2, 2, V(-10, -1, -1))
        bar.rotate(V(0, 0, 0), V(0, 0, 1), 180.0 * i / count)
        found.append(bar)
    return found


def strip(width, length):
    """A bar of 20 x 20 with two fillets that leave a strip of this width between them."""
    box = Part.makeBox(length, 20, 20)
    edges = [edge for edge in box.Edges
             if abs(edge.CenterOfMass.z - 20) < 1e-6 and abs(edge.CenterOfMass.x - length / 2) < 1e-6]
    return box.makeFillet((20 - width) / 2, edges)
