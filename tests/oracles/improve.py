# SPDX-License-Identifier: LGPL-2.1-or-later
"""improve: no new faults, and the distance from what was given, by VTK."""

import measures
import Mesh
import MeshPart
import MeshQuality as mq
import numpy as np
import solids
from judge import Judge, dice_of
from MeshQuality.core.certify import verdict

KINDS = [*solids.SOLIDS]
SAMPLES = 4000


def given_mesh(shape, dice):
    """A mesh of OpenCASCADE with its needles; or the wrap of it, or some of its triangles taken away."""
    size = measures.size(shape)
    made = MeshPart.meshFromShape(Shape=shape.copy(), LinearDeflection=0.005 * size, AngularDeflection=0.5)
    way = dice.choice(["whole", "whole", "open", "wrap"])
    if way == "open":
        made.removeFacets(list(range(0, max(1, made.CountFacets // 10))))
    if way == "wrap":
        return mq.wrap(shape, 0.1 * size).to_mesh()
    return made


def check(shape, seed):
    dice, numbers = dice_of("improve", seed)
    given = given_mesh(shape, dice)
    before = _arrays(given)
    tolerance = measures.size(shape) * dice.choice([1e-3, 5e-3])
    mesh = mq.improve(given, min_angle=dice.choice([20.0, 25.0]), tolerance=tolerance)
    after = mesh.vertices + mesh.origin, mesh.triangles
    closed = not measures.not_closed(before[1])
    judge = Judge(verdict.of_improvement(mesh, closed))
    fault = measures.not_closed(after[1])
    judge.limit(not closed or not fault, f"closed before, now {fault}")
    crossing = [len(measures.crossings(*one)) if len(one[1]) < 20000 else 0 for one in (before, after)]
    judge.claim(crossing[1] <= crossing[0], f"{crossing[1]} crossings, {crossing[0]} before")
    worst = [measures.angles(*one).min() for one in (before, after)]
    judge.claim(worst[1] >= worst[0] - 0.01, f"smallest angle {worst[1]:.5f} degrees, {worst[0]:.5f} before")
    slack = measures.rounding(after[0])
    for name, (mine, other) in {"new": (after, before), "old": (before, after)}.items():
        places = mine[0][np.unique(mine[1])]
        if name == "new":  # corners, middles of edges, centres: what is promised
            corners = mine[0][mine[1]]
            places = np.concatenate([places, (corners + np.roll(corners, 1, axis=1)).reshape(-1, 3) / 2, corners.mean(axis=1)])
        away = measures.Nearest(*other).distances(numbers.permutation(places)[:SAMPLES]).max()
        judge.limit(away <= tolerance + slack, f"the {name} surface is {away:.4g} mm off, {tolerance:.4g} allowed")
    if closed and not fault:
        volumes = [measures.volume(*one) for one in (before, after)]
        allowed = measures.areas(*before).sum() * tolerance
        judge.limit(abs(volumes[0] - volumes[1]) <= allowed, f"volume {volumes[1]:.6g} mm3, {volumes[0]:.6g} before")
    return judge.verdict()


def _arrays(mesh):
    assert isinstance(mesh, Mesh.Mesh)
    points, facets = mesh.Topology
    return np.array([tuple(p) for p in points]), np.array(facets, dtype=int)
