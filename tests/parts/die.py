# SPDX-License-Identifier: LGPL-2.1-or-later
"""A manufacturing die of 14 faces, after figure 2 of Aftosmis 1999."""

import Part
from FreeCAD import Vector

LENGTH, WIDTH, HEIGHT = 120.0, 80.0, 50.0
WALL = 22.0  # around the pocket, on three sides; the fourth is open
SHALLOW, DEEP, STEP_AT = 16.0, 34.0, 70.0
CORNER_RADIUS = 14.0


def die():
    """A block with a pocket open to one side, whose floor has a step: 14 faces.

    All faces are planar but the two rounded upright corners inside.
    """
    block = Part.makeBox(LENGTH, WIDTH, HEIGHT)
    right = LENGTH - WALL
    shape = block.cut(_pocket(right, SHALLOW, [WALL, right]))
    return shape.cut(_pocket(STEP_AT, DEEP, [WALL])).removeSplitter().Solids[0]


def _pocket(right, depth, rounded):
    """The tool from x = WALL to `right`; its inner corners at the x in `rounded` are round."""
    start = Vector(WALL, WALL, HEIGHT - depth)
    box = Part.makeBox(right - WALL, WIDTH - WALL + 1.0, depth + 1.0, start)
    corners = [edge for edge in box.Edges if _is_corner(edge, rounded)]
    return box.makeFillet(CORNER_RADIUS, corners)


def _is_corner(edge, rounded):
    upright = abs(edge.tangentAt(edge.FirstParameter).z) > 0.99
    middle = edge.CenterOfMass
    return upright and middle.y < WALL + 1e-6 and any(abs(middle.x - x) < 1e-6 for x in rounded)
