# SPDX-License-Identifier: LGPL-2.1-or-later
"""boolean and Solid: OpenCASCADE's fuse, common and cut; points by isInside."""

import bodies
import measures
import MeshQuality as mq
import numpy as np
from judge import Judge, dice_of
from MeshQuality.core.certify import verdict

KINDS = [*bodies.BODIES]
POINTS = 300
OPERATIONS = {"union": (lambda a, b: a.fuse(b), np.logical_or), "intersection": (lambda a, b: a.common(b), np.logical_and),
              "difference": (lambda a, b: a.cut(b), lambda a, b: a & ~b),
              "symmetric_difference": (None, np.logical_xor)}


def check(shape, seed):
    dice, numbers = dice_of("boolean", seed)
    a, b = shape.Solids
    operation = dice.choice(["union", "union", *OPERATIONS])
    tolerance = measures.size(shape) * dice.choice([5e-4, 2e-3, 0.01])
    if dice.random() < 0.2:
        solid = {"union": lambda p, q: p | q, "intersection": lambda p, q: p & q, "difference": lambda p, q: p - q,
                 "symmetric_difference": lambda p, q: p ^ q}[operation](mq.Solid(a), mq.Solid(b))
        mesh = solid.evaluate(tolerance=tolerance)
    else:
        mesh = mq.boolean(a, b, operation, tolerance=tolerance)
    judge = Judge(verdict.of_boolean(mesh))
    points, triangles = mesh.vertices + mesh.origin, mesh.triangles
    bound = max(mesh.report.error_bound, tolerance)
    judge.limit(mesh.report.error_bound <= tolerance * 1.000001, f"error bound {mesh.report.error_bound:.4g} mm, called met")
    _sound(judge, points, triangles)
    _inside(judge, (a, b), operation, (points, triangles), bound, numbers)
    _same(judge, (a, b), operation, (points, triangles), bound)
    return judge.verdict()


def _sound(judge, points, triangles):
    if len(triangles):
        fault = measures.not_closed(triangles)
        judge.limit(not fault, fault)
        pairs = measures.crossings(points, triangles) if len(triangles) < 20000 else []
        judge.limit(not pairs, f"{len(pairs)} pairs of triangles cross, such as {pairs[:1]}")


def _inside(judge, solids, operation, mesh, bound, numbers):
    """Points farther from the skins of both bodies than the bound are in the result or not, as they are in the bodies."""
    near = [measures.points_around(solid, numbers, POINTS // 2, 5 * bound) for solid in solids]
    places = np.concatenate(near)
    for solid in solids:
        places = places[measures.distances(places, measures.skin(solid)) > 1.05 * bound]
    in_a, in_b = (measures.inside(places, solid) for solid in solids)
    right = OPERATIONS[operation][1](in_a, in_b)
    found = np.rint(measures.winding(places, *mesh)) if len(mesh[1]) else np.zeros(len(places))
    wrong = np.flatnonzero(found != right)
    judge.limit(not len(wrong), f"{len(wrong)} of {len(places)} points are on the wrong side, such as "
                f"{places[wrong[:1]].tolist()}: winding number {found[wrong[:1]]}, {right[wrong[:1]]} is right")


def _same(judge, solids, operation, mesh, bound):
    """Volume, area and components are OpenCASCADE's, where its own results agree with each other."""
    exact = OPERATIONS[operation][0]
    points, triangles = mesh
    both, shared = solids[0].fuse(solids[1]), solids[0].common(solids[1])
    sum_of_both = solids[0].Volume + solids[1].Volume
    if exact is None or abs(both.Volume + shared.Volume - sum_of_both) > 1e-6 * sum_of_both or not both.isValid():
        return
    right = exact(*solids)
    kept = [solid for solid in right.Solids if solid.Volume > solid.Area * bound]
    if sum(solid.Volume for solid in right.Solids) - sum(solid.Volume for solid in kept) > 0.0:
        return  # what is thinner than the bound may be left out
    area = sum(solid.Area for solid in kept)
    found = measures.volume(points, triangles) if len(triangles) else 0.0
    volume = sum(measures.volume_of(solid)[0] for solid in kept)
    allowed = (area + 1e-3 * sum(s.Area for s in solids)) * bound + sum(measures.volume_of(solid)[1] for solid in kept)
    judge.limit(abs(found - volume) <= allowed, f"volume {found:.6g} mm3, {volume:.6g} is right, {allowed:.3g} allowed")
    found = measures.areas(points, triangles).sum()
    length = sum(edge.Length for edge in right.Edges)
    allowed = 0.01 * area + 4 * bound * length
    judge.limit(abs(found - area) <= allowed, f"area {found:.6g} mm2, {area:.6g} is right, {allowed:.3g} allowed")
    if 0.0 < solids[0].distToShape(solids[1])[0] < 2.0 * bound:
        return  # whether bodies as near as that are joined is open
    right = right.removeSplitter() if right.Solids else right
    pieces, shells = measures.components(triangles, len(points))[0], sum(len(solid.Shells) for solid in right.Solids)
    judge.limit(pieces == shells, f"{pieces} closed surfaces, {shells} are right")
