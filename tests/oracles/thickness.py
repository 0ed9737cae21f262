# SPDX-License-Identifier: LGPL-2.1-or-later
"""thickness: OpenCASCADE's section of the solid with the ray at each place; balls by distToShape."""

import measures
import MeshQuality as mq
import numpy as np
import Part
import solids
from judge import Judge, dice_of

KINDS = [kind for kind in solids.SOLIDS if kind != "micro"]  # OpenCASCADE's lines are not exact to 1e-7 mm
RAYS = 20


def check(shape, seed):
    dice, numbers = dice_of("thickness", seed)
    found = mq.thickness(shape, measure="rays", spacing=measures.size(shape) / 10)
    judge = Judge()
    skin, size = measures.skin(shape), measures.size(shape)
    walls = np.flatnonzero(found.is_wall & np.isfinite(found.by_rays))
    for k in numbers.permutation(walls)[:RAYS]:
        _ray(judge, shape, found, k, size)
    balls = found.by("spheres")
    for k in numbers.permutation(np.flatnonzero(balls.is_wall & np.isfinite(balls.values)))[:RAYS]:
        _ball(judge, shape, skin, balls, k, size)
    if len(walls):
        judge.claim(abs(found.minimum - found.values[found.is_wall].min()) <= 1e-9 * size, "the minimum is not the smallest")
    return judge.verdict()


def _normal(shape, face, point):
    surface = shape.Faces[face].Surface
    return np.array(tuple(shape.Faces[face].normalAt(*surface.parameter(measures.vector(point)))))


TILT = 0.05  # radians: what the normals of two meshes of one surface may differ by


def _ray(judge, shape, found, k, size):
    """The first place where the ray against the normal leaves the solid; with slightly turned rays, as where it grazes an
    edge each of the lengths is right. By Boolean operations: distToShape leaves out places where a line meets a torus.
    """
    point, face = found.points[k], int(found.mesh.triangle_face[k])
    normal, lengths = _normal(shape, face, point), []
    deviation = max(found.chord_height, 1e-6 * size)
    aside = np.cross(normal, [0.3, 0.5, 0.8])
    other = np.cross(normal, aside)
    for turn in (0 * aside, TILT * aside, -TILT * aside, TILT * other, -TILT * other):
        way = turn - normal
        way /= np.linalg.norm(way)
        start = point + way * (2 * deviation + 1e-5 * size)
        line = Part.makeLine(measures.vector(start), measures.vector(start + 4 * size * way))
        ends = [np.array([tuple(vertex.Point) for vertex in edge.Vertexes]) - point for edge in shape.common(line).Edges]
        if ends:
            lengths.append(min(float((end @ way).max()) for end in ends))
    if not lengths:
        return
    slack = 4 * deviation + 0.01 * max(lengths)
    judge.claim(min(lengths) - slack <= found.by_rays[k] <= max(lengths) + slack,
                f"thickness {found.by_rays[k]:.5g} mm at {point.tolist()} on Face{face + 1}, OpenCASCADE's rays are "
                f"{min(lengths):.5g} to {max(lengths):.5g} mm long")


def _ball(judge, shape, skin, found, k, size):
    """The ball of this diameter that touches the surface there is in the solid."""
    point, face = found.points[k], int(found.mesh.triangle_face[k])
    radius = found.values[k] / 2.0
    center = point - radius * _normal(shape, face, point)
    away = measures.distances([center], skin)[0]
    slack = 4 * max(found.chord_height, 1e-6 * size) + TILT * radius
    judge.claim(away >= radius - slack and measures.inside([center], shape)[0],
                f"a ball of {2 * radius:.5g} mm at {point.tolist()} leaves the solid: its middle is {away:.5g} mm from it")
