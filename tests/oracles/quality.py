# SPDX-License-Identifier: LGPL-2.1-or-later
"""quality: the deviation from the shape by OpenCASCADE; faults that were put in are found."""

import measures
import MeshQuality as mq
import numpy as np
import solids
from judge import Judge, dice_of

KINDS = [*solids.SOLIDS]
SAMPLES = 150


def check(shape, seed):
    dice, numbers = dice_of("quality", seed)
    size, judge = measures.size(shape), Judge()
    mesh = mq.triangulate(shape, chord_height=size * dice.choice([0.005, 0.02]))
    points, triangles = mesh.vertices + mesh.origin, mesh.triangles.copy()
    _deviation(judge, shape, points, triangles, size, numbers)
    for way in dice.sample(sorted(FAULTS), 2):
        spoilt, name, count = FAULTS[way](points, triangles, numbers)
        report = mq.quality((*spoilt,))
        found = getattr(report, name)
        judge.claim(found == count if count is not None else found > 0, f"{way}: {name} is {found}, {count or 'more'} is right")
    report = mq.quality((points, triangles))
    for name, right in {"area": measures.areas(points, triangles).sum(), "volume": measures.volume(points, triangles),
                        "min_angle": measures.angles(points, triangles).min()}.items():
        found = getattr(report, name)
        judge.claim(abs(found - right) <= 1e-4 * abs(right) + 1e-9 * size, f"{name} {found:.8g}, {right:.8g} is right")
    judge.claim(report.components == measures.components(triangles, len(points))[0], "components")
    return judge.verdict()


def _deviation(judge, shape, points, triangles, size, numbers):
    """Some vertices are moved aside: the report has the largest distance of corners, middles of edges and of triangles."""
    moved = points.copy()
    some = numbers.choice(len(points), max(1, len(points) // 20), replace=False)
    moved[some] += numbers.normal(size=(len(some), 3)) * 0.01 * size
    report = mq.quality((moved, triangles), shape)
    corners = moved[triangles]
    places = np.concatenate([moved[np.unique(triangles)], (corners + np.roll(corners, 1, axis=1)).reshape(-1, 3) / 2,
                             corners.mean(axis=1)])
    away = measures.distances(np.concatenate([moved[some], places[numbers.choice(len(places), SAMPLES)]]), measures.skin(shape))
    judge.claim(away.max() <= report.max_chord_height * 1.001 + measures.rounding(moved) + 1e-7 * size,
                f"a triangle is {away.max():.6g} mm from the shape, reported {report.max_chord_height:.6g}")
    own = measures.distances([report.max_chord_point + np.zeros(3)], measures.skin(shape))[0]
    judge.claim(abs(own - report.max_chord_height) <= 0.01 * report.max_chord_height + measures.rounding(moved),
                f"the place of the largest distance is {own:.6g} mm away, reported {report.max_chord_height:.6g}")


def _hole(points, triangles, numbers):
    return (points, np.delete(triangles, numbers.integers(len(triangles)), axis=0)), "border_edges", 3


def _turned(points, triangles, numbers):
    spoilt = triangles.copy()
    k = numbers.integers(len(triangles))
    spoilt[k] = spoilt[k][::-1]
    return (points, spoilt), "misoriented_edges", 3


def _twice(points, triangles, numbers):
    return (points, np.concatenate([triangles, triangles[numbers.integers(len(triangles))][None]])), "duplicate_triangles", None


def _crossing(points, triangles, numbers):
    """A second copy, moved by a tenth of its size."""
    aside = np.ptp(points, axis=0) * (0.1, 0.13, 0.17)
    both = np.concatenate([points, points + aside]), np.concatenate([triangles, triangles + len(points)])
    return both, "self_intersections", None


FAULTS = {"a triangle is missing": _hole, "a triangle is turned": _turned, "a triangle is there twice": _twice,
          "a copy crosses": _crossing}
