# SPDX-License-Identifier: LGPL-2.1-or-later
"""offset: distances of points by OpenCASCADE."""

import measures
import MeshQuality as mq
import numpy as np
import solids
from judge import Judge, dice_of
from MeshQuality.core.certify import verdict

KINDS = [kind for kind in solids.SOLIDS if kind not in ("thread", "pattern")]
SAMPLES, POINTS = 60, 150


def check(shape, seed):
    dice, numbers = dice_of("offset", seed)
    size = measures.size(shape)
    distance = dice.choice([-1, 1, 1]) * size * dice.choice([0.02, 0.05, 0.15])
    tolerance = abs(distance) * dice.choice([0.1, 0.05])
    mesh = mq.offset(shape, distance, tolerance=tolerance)
    judge = Judge(verdict.of_boolean(mesh))
    compare(judge, mesh, tolerance)
    points, triangles = mesh.vertices + mesh.origin, mesh.triangles
    skin, bound = measures.skin(shape), max(tolerance, mesh.report.error_bound) + measures.rounding(points)
    if len(triangles):
        places, _ = measures.samples(points, triangles, numbers, SAMPLES)
        away = measures.distances(places, skin)
        worst = np.abs(away - abs(distance)).max()
        judge.limit(worst <= bound, f"the offset is {worst:.4g} mm off, {bound:.4g} allowed")
        right = measures.inside(places, shape)
        judge.limit((right == (distance < 0)).all(), "the offset lies on the wrong side of the solid")
    places = measures.points_around(shape, numbers, POINTS, abs(distance) + 5 * bound)
    depth = measures.distances(places, skin) * np.where(measures.inside(places, shape), -1.0, 1.0) - distance
    sides(judge, mesh, places, depth, bound)
    return judge.verdict()


def sides(judge, mesh, places, depth, bound):
    """Points with depth below 0 are in the result; those nearer than the bound say nothing."""
    clear = np.abs(depth) > 1.05 * bound
    places, right = places[clear], depth[clear] < 0
    points, triangles = mesh.vertices + mesh.origin, mesh.triangles
    found = np.rint(measures.winding(places, points, triangles)) if len(triangles) else np.zeros(len(places))
    wrong = np.flatnonzero(found != right)
    judge.limit(not len(wrong), f"{len(wrong)} of {len(places)} points are on the wrong side, such as "
                f"{places[wrong[:1]].tolist()}: winding number {found[wrong[:1]]}, {right[wrong[:1]]} is right")


def compare(judge, mesh, tolerance):
    """The result is sound, and its bound is the one asked for."""
    triangles = mesh.triangles
    judge.limit(mesh.report.error_bound <= tolerance * 1.000001,
                f"error bound {mesh.report.error_bound:.4g} mm, {tolerance:.4g} requested, called met")
    if len(triangles):
        fault = measures.not_closed(triangles)
        judge.limit(not fault, fault)
        pairs = measures.crossings(mesh.vertices, triangles) if len(triangles) < 20000 else []
        judge.limit(not pairs, f"{len(pairs)} pairs of triangles cross, such as {pairs[:1]}")
