# SPDX-License-Identifier: LGPL-2.1-or-later
"""voids: the inner shells of the solids, by OpenCASCADE."""

import bodies
import measures
import MeshQuality as mq
import Part
import solids
from judge import Judge, dice_of

KINDS = ["hollow body", *solids.SOLIDS, *bodies.APART, "nested", "hollow body"]


def check(shape, seed):
    dice_of("voids", seed)
    found = mq.voids(shape)
    judge, right = Judge(), []
    for solid in shape.Solids:
        outer = solid.OuterShell
        right += [measures.volume_of(Part.Solid(shell)) for shell in solid.Shells if not shell.isSame(outer)]
    right.sort(reverse=True)
    judge.claim(len(found.voids) == len(right), f"{len(found.voids)} voids, {len(right)} are right")
    for void, (volume, error) in zip(found.voids, right):
        allowed = error + void.area * found.chord_height * 1.1 + 1e-6 * volume
        judge.claim(abs(void.volume - volume) <= allowed, f"a void of {void.volume:.6g} mm3, {volume:.6g} is right")
    volume, error = measures.volume_of(shape)
    allowed = error + shape.Area * found.chord_height * 1.1 + 1e-6 * volume
    judge.claim(abs(found.solid_volume - volume) <= allowed,
                f"material {found.solid_volume:.6g} mm3, {volume:.6g} is right, {allowed:.3g} allowed")
    return judge.verdict()
