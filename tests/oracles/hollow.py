# SPDX-License-Identifier: LGPL-2.1-or-later
"""hollow: distances of points by OpenCASCADE."""

import measures
import MeshQuality as mq
import numpy as np
import offset
import solids
from judge import Judge, dice_of
from MeshQuality.core.certify import verdict

KINDS = [kind for kind in solids.SOLIDS if kind not in ("thread", "pattern", "hollow body")]
POINTS = 200


def check(shape, seed):
    dice, numbers = dice_of("hollow", seed)
    thickness = measures.size(shape) * dice.choice([0.03, 0.08])
    tolerance = thickness * dice.choice([0.1, 0.05])
    planes = [k for k, face in enumerate(shape.Faces) if type(face.Surface).__name__ == "Plane"]
    openings = sorted(dice.sample(planes, 1)) if planes and dice.random() < 0.4 else []
    mesh = mq.hollow(shape, thickness, openings=[f"Face{k + 1}" for k in openings] or None, tolerance=tolerance)
    judge = Judge(verdict.of_boolean(mesh))
    offset.compare(judge, mesh, tolerance)
    bound = max(tolerance, mesh.report.error_bound) + measures.rounding(mesh.vertices + mesh.origin)
    places = measures.points_around(shape, numbers, POINTS, thickness + 5 * bound)
    skin = measures.distances(places, measures.skin(shape))
    walls = skin
    if openings:
        kept = [face for k, face in enumerate(shape.Faces) if k not in openings]
        walls = np.array([measures.distances([place], measures.Part.makeCompound(kept))[0] for place in places])
    inner = measures.inside(places, shape)
    # Depth in the wall: outside of the solid its distance, inside how far beyond the thickness, negative in the wall.
    depth = np.where(inner, np.where(walls > thickness, walls - thickness, -np.minimum(skin, thickness - walls)), skin)
    offset.sides(judge, mesh, places, depth, bound)
    return judge.verdict()
