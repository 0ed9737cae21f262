# SPDX-License-Identifier: LGPL-2.1-or-later
"""draft: normals and rays by OpenCASCADE."""

import measures
import MeshQuality as mq
import numpy as np
import Part
import solids
from judge import Judge, dice_of

KINDS = [*solids.SOLIDS]
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
        start = on + shift + 4e-3 * size * normal
        line = Part.makeLine(measures.vector(start), measures.vector(start + 4 * size * way))
        free.append(skin.distToShape(line)[0] > 2e-3 * size)
    if len(set(free)) == 1:
        judge.claim(bool(found.release[k]) == free[0], f"undercut {not found.release[k]} at {on.tolist()}, "
                    f"OpenCASCADE's ray {'leaves the solid' if free[0] else 'meets it again'}")
