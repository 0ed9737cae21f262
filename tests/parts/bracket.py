# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cast bearing bracket: foot plate, web with an eye, rib, fillets and holes."""

import math

import Part
from FreeCAD import Vector

FOOT_LENGTH, FOOT_WIDTH, FOOT_HEIGHT = 96.0, 60.0, 12.0
EYE_HEIGHT, EYE_RADIUS, EYE_BORE = 60.0, 22.0, 11.0
BOSS_RADIUS, BOSS_DEPTH = 17.0, 9.0
WEB_FOOT, WEB_FRONT, WEB_BACK = 32.0, 6.0, 22.0  # half width on the foot; y of front and back
RIB = 10.0
FILLET = 4.0


def bracket():
    """A bracket of planes, cylinders, cones, tori and rolling-ball fillets."""
    shape = _foot().fuse(_web()).fuse(_boss()).fuse(_rib()).removeSplitter()
    inner = [edge for edge in shape.Edges if _is_concave(shape, edge)]
    return _with_holes(shape.makeFillet(FILLET, inner)).Solids[0]


def _foot():
    corner = Vector(-FOOT_LENGTH / 2, -FOOT_WIDTH / 2, 0.0)
    foot = Part.makeBox(FOOT_LENGTH, FOOT_WIDTH, FOOT_HEIGHT, corner)
    upright = [e for e in foot.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.99]
    return foot.makeFillet(12.0, upright)


def _web():
    """The plate that carries the eye: two sides tangent to the round top."""
    bottom = FOOT_HEIGHT - 4.0
    rise = EYE_HEIGHT - bottom
    reach = math.hypot(WEB_FOOT, rise)
    angle = math.acos(EYE_RADIUS / reach) - math.atan2(rise, WEB_FOOT)
    touch = Vector(
        EYE_RADIUS * math.cos(angle), WEB_FRONT, EYE_HEIGHT + EYE_RADIUS * math.sin(angle)
    )
    mirrored = Vector(-touch.x, touch.y, touch.z)
    left, right = Vector(-WEB_FOOT, WEB_FRONT, bottom), Vector(WEB_FOOT, WEB_FRONT, bottom)
    top = Vector(0.0, WEB_FRONT, EYE_HEIGHT + EYE_RADIUS)
    outline = Part.Wire([
        Part.makeLine(left, right),
        Part.makeLine(right, touch),
        Part.Arc(touch, top, mirrored).toShape(),
        Part.makeLine(mirrored, left),
    ])
    return Part.Face(outline).extrude(Vector(0.0, WEB_BACK - WEB_FRONT, 0.0))


def _boss():
    """The eye's collar in front of the web."""
    start = Vector(0.0, WEB_FRONT - BOSS_DEPTH, EYE_HEIGHT)
    return Part.makeCylinder(BOSS_RADIUS, BOSS_DEPTH + 2.0, start, Vector(0.0, 1.0, 0.0))


def _rib():
    """A triangular rib in front of the web, under the collar."""
    x, front = -RIB / 2, -FOOT_WIDTH / 2 + 6.0
    outline = Part.makePolygon([
        Vector(x, WEB_FRONT + 2.0, FOOT_HEIGHT - 2.0),
        Vector(x, front, FOOT_HEIGHT - 2.0),
        Vector(x, WEB_FRONT + 2.0, EYE_HEIGHT - BOSS_RADIUS - 5.0),
        Vector(x, WEB_FRONT + 2.0, FOOT_HEIGHT - 2.0),
    ])
    return Part.Face(outline).extrude(Vector(RIB, 0.0, 0.0))


def _is_concave(shape, edge):
    """Whether the material around the edge fills more than 180 degrees."""
    faces = shape.ancestorsOfType(edge, Part.Face)
    if len(faces) != 2:
        return False
    middle = edge.valueAt((edge.FirstParameter + edge.LastParameter) / 2)
    first, second = (face.normalAt(*face.Surface.parameter(middle)) for face in faces)
    across = first - second
    return across.Length > 0.1 and shape.isInside(middle + across * 0.1, 1e-6, False)


def _with_holes(shape):
    """Two countersunk holes in the foot, and the bore of the eye."""
    y = -FOOT_WIDTH / 2 + 16.0
    for x in (-FOOT_LENGTH / 2 + 16.0, FOOT_LENGTH / 2 - 16.0):
        shape = shape.cut(Part.makeCylinder(4.5, FOOT_HEIGHT + 2.0, Vector(x, y, -1.0)))
        countersink = Vector(x, y, FOOT_HEIGHT - 4.0)
        shape = shape.cut(Part.makeCone(4.5, 8.5, 4.0, countersink))
    start = Vector(0.0, -FOOT_WIDTH, EYE_HEIGHT)
    return shape.cut(Part.makeCylinder(EYE_BORE, 2.0 * FOOT_WIDTH, start, Vector(0.0, 1.0, 0.0)))
