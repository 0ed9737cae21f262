# SPDX-License-Identifier: LGPL-2.1-or-later
"""triangulate: distances both ways, angles, volume, winding and crossings."""

import bodies
import measures
import MeshQuality as mq
import numpy as np
import solids
from judge import Judge, dice_of
from MeshQuality.core.certify import verdict

KINDS = [*solids.SOLIDS, *bodies.BODIES]
SAMPLES = 60


def check(shape, seed):
    dice, numbers = dice_of("triangulate", seed)
    values = {"min_angle": dice.choice([20.0, 25.0, 30.0]), "chord_height": measures.size(shape) * dice.choice([2e-3, 5e-3, 0.02]),
              "keep_edges": dice.choice(["all", "all", "feature"]), "insertion": dice.choice(["off-centre", "circumcentre"])}
    mesh = mq.triangulate(shape, **values)
    judge = Judge(verdict.of_triangulation(mesh, verdict.must_be_closed(shape), values, shape))
    points, triangles = mesh.vertices + mesh.origin, mesh.triangles
    _topology(judge, mesh, shape, triangles)
    _angles(judge, mesh, points, values["min_angle"])
    _distances(judge, mesh, shape, points, values["chord_height"], numbers)
    _volume(judge, mesh, shape, points, values["chord_height"])
    _bodies(judge, mesh, shape, points)
    return judge.verdict()


def _topology(judge, mesh, shape, triangles):
    fault = measures.not_closed(triangles)
    judge.claim(bool(fault) != (mesh.report.closed and mesh.report.oriented and not mesh.report.nonmanifold_edges),
                f"closed {mesh.report.closed}, oriented {mesh.report.oriented}, yet {fault or 'no fault'}")
    judge.limit(not fault, fault)
    judge.claim(set(mesh.triangle_face.tolist()) == set(range(len(shape.Faces))) or bool(mesh.report.spanning) or judge.findings,
                "a face has no triangle")


def _angles(judge, mesh, points, asked):
    found = measures.angles(points, mesh.triangles)
    judge.claim(abs(found.min() - mesh.report.min_angle) <= 0.01 + 0.01 * found.min(),
                f"smallest angle {found.min():.4f} degrees, reported {mesh.report.min_angle:.4f}")
    rest = np.ones(len(found), dtype=bool)
    rest[[triangle for triangle, *_ in mesh.report.exempt]] = False
    least = found[rest].min(initial=180.0)
    judge.limit(least >= asked - 0.01, f"an angle of {least:.3f} degrees that is not exempt; {asked} requested")


def _distances(judge, mesh, shape, points, asked, numbers):
    slack = measures.rounding(points)
    skin, nearest = measures.skin(shape), measures.Nearest(points, mesh.triangles)
    places, chosen = measures.samples(points, mesh.triangles, numbers, SAMPLES)
    away = measures.distances(places, skin).max()
    judge.limit(away <= asked + slack, f"a triangle is {away:.4g} mm from the shape, {asked:.4g} requested")
    judge.claim(away <= mesh.report.max_chord_height * 1.2 + slack + 0.01 * asked,
                f"a triangle is {away:.4g} mm from the shape, reported {mesh.report.max_chord_height:.4g}")
    back, _ = measures.points_on(shape, numbers, SAMPLES)
    away = nearest.distances(back).max(initial=0.0)
    judge.limit(away <= asked + slack, f"the shape is {away:.4g} mm from the mesh, {asked:.4g} requested")
    if not mesh.report.spanning:
        own = [measures.distances([place], shape.Faces[mesh.triangle_face[k]])[0] for place, k in zip(places[:30], chosen)]
        judge.limit(max(own) <= asked + slack, f"a triangle is {max(own):.4g} mm from its own face")


def _volume(judge, mesh, shape, points, asked):
    right, error = measures.volume_of(shape)
    found = measures.volume(points, mesh.triangles)
    allowed = error + sum(solid.Area for solid in shape.Solids) * (asked + measures.rounding(points)) * 1.1
    judge.limit(abs(found - right) <= allowed, f"volume {found:.6g} mm3, {right:.6g} is right, {allowed:.3g} allowed")
    judge.limit(found > 0, "the mesh is inside out")


def _bodies(judge, mesh, shape, points):
    """Bodies that the CAD keeps apart do not cross in the mesh; those that contain or overlap each other are named."""
    if len(shape.Solids) < 2:
        pairs = measures.crossings(points, mesh.triangles) if len(mesh.triangles) < 6000 else []
        judge.limit(not pairs, f"{len(pairs)} pairs of triangles cross, such as {pairs[:1]}")
        return
    a, b = shape.Solids
    if a.common(b).Volume > 1e-6 * min(a.Volume, b.Volume):
        judge.claim(judge.findings, "two bodies overlap, or one contains the other, and the mesh is called met")
        return
    pairs = measures.crossings(points, mesh.triangles, mesh.triangle_solid)
    touching = a.distToShape(b)[0] < 1e-7
    judge.limit(touching or not pairs, f"bodies apart cross in the mesh: {len(pairs)} pairs of triangles")
