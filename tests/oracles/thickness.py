# SPDX-License-Identifier: LGPL-2.1-or-later
"""thickness: OpenCASCADE's section of the solid with the ray at each place; balls by distToShape."""

import measures
import MeshQuality as mq
import numpy as np
import Part
import solids
from judge import Judge, dice_of

KINDS = [*solids.SOLIDS]
RAYS = 25


def check(shape, seed):
    dice, numbers = dice_of("thickness", seed)
    found = mq.thickness(shape, measure="rays", spacing=measures.size(shape) / 10)
    judge = Judge()
    skin, size = measures.skin(shape), measures.size(shape)
    walls = np.flatnonzero(found.is_wall & np.isfinite(found.by_rays))
    for k in numbers.permutation(walls)[:RAYS]:
        _ray(judge, shape, skin, found, k, size)
    balls = found.by("spheres")
    for k in numbers.permutation(np.flatnonzero(balls.is_wall & np.isfinite(balls.values)))[:RAYS]:
        _ball(judge, shape, skin, balls, k, size)
    if len(walls):
        judge.claim(abs(found.minimum - found.values[found.is_wall].min()) <= 1e-9 * size, "the minimum is not the smallest")
    return judge.verdict()


def _normal(shape, face, point):
    surface = shape.Faces[face].Surface
    return np.array(tuple(shape.Faces[face].normalAt(*surface.parameter(measures.vector(point)))))


def _ray(judge, shape, skin, found, k, size):
    """The first place where the ray against the normal leaves the solid; with slightly turned rays, as where it grazes an
    edge each of the lengths is right.
    """
    point, face = found.points[k], int(found.mesh.triangle_face[k])
    normal = _normal(shape, face, point)
    deviation = max(found.chord_height, 1e-6 * size)
    lengths = []
    aside = np.cross(normal, [1.0, 0.3, 0.7])
    for turn in (0.0, 0.02, -0.02):
        way = -(normal + turn * aside)
        way /= np.linalg.norm(way)
        start = point + way * (2 * deviation + 1e-5 * size)
        meets = skin.distToShape(Part.makeLine(measures.vector(start), measures.vector(start + 4 * size * way)))
        if meets[0] < 1e-7 * size:
            lengths.append(min(np.linalg.norm(np.array(tuple(where[0])) - point) for where in meets[1]))
    if len(lengths) < 3:
        return
    slack = 4 * deviation + 0.03 * max(lengths)
    judge.claim(min(lengths) - slack <= found.by_rays[k] <= max(lengths) + slack,
                f"thickness {found.by_rays[k]:.5g} mm at {point.tolist()} on Face{face + 1}, OpenCASCADE's ray is "
                f"{lengths[0]:.5g} mm long")


def _ball(judge, shape, skin, found, k, size):
    """The ball of this diameter that touches the surface there is in the solid."""
    point, face = found.points[k], int(found.mesh.triangle_face[k])
    radius = found.values[k] / 2.0
    center = point - radius * _normal(shape, face, point)
    away = measures.distances([center], skin)[0]
    slack = 4 * max(found.chord_height, 1e-6 * size) + 0.02 * radius
    judge.claim(away >= radius - slack and measures.inside([center], shape)[0],
                f"a ball of {2 * radius:.5g} mm at {point.tolist()} leaves the solid: its middle is {away:.5g} mm from it")
