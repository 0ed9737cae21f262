# SPDX-License-Identifier: LGPL-2.1-or-later
"""clearance: OpenCASCADE's distances of the solids, their common volume, and points by isInside."""

import bodies
import measures
import MeshQuality as mq
from judge import Judge, dice_of

KINDS = [*bodies.BODIES]


def check(shape, seed):
    dice, numbers = dice_of("clearance", seed)
    a, b = shape.Solids
    found = mq.clearance([a, b] if dice.random() < 0.5 else shape)
    judge = Judge()
    (pair,) = found.pairs
    shared = a.common(b).Volume
    least, gap = min(a.Volume, b.Volume), measures.skin(a).distToShape(measures.skin(b))[0]
    size = measures.size(shape)
    if shared > 0.999999 * least and gap > 1e-6 * size:
        right = "inside"
    elif shared > 0.999999 * max(a.Volume, b.Volume):
        right = "equal"
    elif shared > 1e-6 * least:
        right = "overlapping"
    else:
        right = "touching" if gap <= 1e-9 * size else "apart"
    # One that lies in the other and meets its skin is inside or overlapping: both say that material is in material.
    named = pair.relation == right or (right == "overlapping" and pair.relation == "inside")
    # OpenCASCADE's own tolerance is 1e-7 mm; and meshes that meet say no more than that the shapes may.
    unresolved = {right, pair.relation} == {"apart", "touching"} and (gap <= 2e-7 or pair.upper >= gap)
    judge.claim(named or unresolved, f"{pair.relation}, {right} is right: {shared:.4g} mm3 in common, distance {gap:.6g} mm")
    if right in ("apart", "inside"):
        judge.claim(pair.lower - 1e-7 * size <= gap <= pair.upper + 1e-7 * size,
                    f"the distance {gap:.8g} mm is not between {pair.lower:.8g} and {pair.upper:.8g} mm")
        if pair.method == "OpenCASCADE":
            judge.claim(abs(pair.distance - gap) <= 1e-6 * size, f"distance {pair.distance:.8g} mm, {gap:.8g} is right")
        away = sum((p - q) ** 2 for p, q in zip(*pair.points)) ** 0.5
        judge.claim(abs(away - pair.distance) <= 1e-6 * size, f"places {away:.6g} mm apart, distance {pair.distance:.6g} mm")
    for body, point in zip((a, b), pair.points):
        off = measures.distances([point], measures.skin(body))[0]
        judge.claim(off <= max(2e-3 * size, pair.upper - pair.lower), f"a place is {off:.4g} mm from its body")
    return judge.verdict()
