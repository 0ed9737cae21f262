# SPDX-License-Identifier: LGPL-2.1-or-later
"""wrap: distances both ways and winding numbers of points."""

import bodies
import measures
import MeshQuality as mq
import numpy as np
import solids
from judge import Judge, dice_of
from MeshQuality.core.certify import verdict

KINDS = [kind for kind in (*solids.PLAIN, *bodies.BODIES) if kind not in ("thread", "pattern", "thin plate", "thin tube")]
SAMPLES, POINTS = 60, 100


def check(shape, seed):
    dice, numbers = dice_of("wrap", seed)
    gap = measures.size(shape) * dice.choice([0.05, 0.1])
    tolerance = gap / 4
    mesh = mq.wrap(shape if dice.random() < 0.5 else shape.Solids, gap, tolerance=tolerance)
    judge = Judge(verdict.of_boolean(mesh))
    points, triangles = mesh.vertices + mesh.origin, mesh.triangles
    fault = measures.not_closed(triangles)
    judge.limit(not fault, fault)
    pairs = measures.crossings(points, triangles) if len(triangles) < 20000 else []
    judge.limit(not pairs, f"{len(pairs)} pairs of triangles cross, such as {pairs[:1]}")
    skin, slack = measures.skin(shape), measures.rounding(points)
    closing = mesh.triangle_face < 0
    if not closing.all():
        places, _ = measures.samples(points, triangles[~closing], numbers, SAMPLES)
        away = measures.distances(places, skin).max()
        judge.limit(away <= tolerance + slack, f"the wrap is {away:.4g} mm from what it lies on, {tolerance:.4g} allowed")
        judge.claim(away <= 1.2 * max(mesh.distance_to_input, mesh.report.error_bound) + slack,
                    f"the wrap is {away:.4g} mm from what it lies on, reported {mesh.distance_to_input:.4g}")
    _around(judge, shape, mesh, tolerance + slack, numbers, gap)
    return judge.verdict()


def _around(judge, shape, mesh, bound, numbers, gap):
    """What is in a solid is in the wrap; what is farther from the shape's outside than the gap is not, but for its gaps."""
    points, triangles = mesh.vertices + mesh.origin, mesh.triangles
    places = measures.points_around(shape, numbers, POINTS, 3 * gap)
    away = measures.distances(places, measures.skin(shape))
    material = measures.inside(places, shape) & (away > 1.05 * bound)
    found = np.rint(measures.winding(places, points, triangles))
    judge.limit((found[material] == 1).all(), f"{(found[material] != 1).sum()} points in a solid are not in the wrap")
    box = shape.BoundBox
    low, high = np.array([box.XMin, box.YMin, box.ZMin]) - bound, np.array([box.XMax, box.YMax, box.ZMax]) + bound
    outside = ((places < low) | (places > high)).any(axis=1)
    judge.limit((found[outside] == 0).all(), "the wrap reaches beyond the box of the shape")
    judge.claim(np.isin(found, (0, 1)).all(), "a winding number of the wrap is neither 0 nor 1")
