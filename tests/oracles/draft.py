# SPDX-License-Identifier: LGPL-2.1-or-later
"""draft: normals and rays by OpenCASCADE."""

import measures
import MeshQuality as mq
import numpy as np
import Part
import solids
from judge import Judge, dice_of

KINDS = [kind for kind in solids.SOLIDS if kind != "micro"]  # OpenCASCADE's lines are not exact to 1e-7 mm
TRIANGLES = 30


def check(shape, seed):
    dice, numbers = dice_of("draft", seed)
    pull = np.array([dice.uniform(-1, 1) for _ in range(3)]) if dice.random() < 0.5 else np.eye(3)[dice.randrange(3)]
    pull /= np.linalg.norm(pull)
    found = mq.draft(shape, tuple(pull), min_draft=dice.uniform(0.5, 5))
    judge, mesh = Judge(), found.mesh
    points = mesh.vertices + mesh.origin
    skin, size = measures.skin(shape), measures.size(shape)
    for k in numbers.permutation(len(mesh.triangles))[:TRIANGLES]:
        _triangle(judge, shape, skin, found, points[mesh.triangles[k]].mean(axis=0), k, pull, size)
    area = measures.areas(points, mesh.triangles)
    judge.claim(abs(area[found.is_undercut].sum() - found.undercut_area) <= 1e-6 * area.sum(), "area of undercuts")
    judge.claim(abs(area[found.is_low].sum() - found.low_area) <= 1e-6 * area.sum(), "area of low draft")
    return judge.verdict()


def _triangle(judge, shape, skin, found, middle, k, pull, size):
    face = shape.Faces[found.mesh.triangle_face[k]]
    _, places, _ = face.distToShape(Part.Vertex(*map(float, middle)))
    on = np.array(tuple(places[0][0]))
    normal = np.array(tuple(face.normalAt(*face.Surface.parameter(measures.vector(on)))))
    angle = np.degrees(np.arcsin(np.clip(normal @ pull, -1, 1)))
    turns = np.degrees(4 * found.mesh.report.max_chord_height / size) + 0.5
    judge.claim(abs(angle - found.angles[k]) <= turns,
                f"draft {found.angles[k]:.3f} degrees at {on.tolist()}, {angle:.3f} is right")
    # Whether rays around this one leave the solid: where they differ an edge is near, and nothing is said.
    way, free = pull * (1.0 if angle >= 0 else -1.0), []
    if abs(angle) < 2:
        return
    for shift in (np.zeros(3), *(np.eye(3) * 2e-3 * size)):
        for height in (1.5e-3, 4e-3, 8e-3):
            start = on + shift + height * size * normal
            away = skin.distToShape(Part.makeLine(measures.vector(start), measures.vector(start + 4 * size * way)))[0]
            free.append(True if away > 1e-3 * size else False if away < 1e-9 * size else None)
    if len(set(free)) == 1 and free[0] is not None:
        judge.claim(bool(found.release[k]) == free[0], f"undercut {not found.release[k]} at {on.tolist()}, "
                    f"OpenCASCADE's ray {'leaves the solid' if free[0] else 'meets it again'}")
