#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a bound on the smallest angle bounds besides it, and equations (3) and (4) of Aftosmis 1999, on meshes.

    /usr/bin/python3 benchmarks/papers aftosmis-bounds

With the smallest angle a of a mesh, every triangle has
    largest angle <= 180 - 2 a
    longest edge / shortest edge <= 1 / sin a', with its own smallest angle a'; at least the smaller one of
        2 cos a' (an isosceles triangle with two such angles) and 1 / (2 sin(a'/2)) (with one)
    1 / sin a' <= longest edge / height above it <= 2 / sin a'
neighbours have longest edges that differ by at most 1 / sin a, and a vertex whose angles sum up to S has at most S / a
edges. Equation (4): sites within f circumradii of the circumcentre keep edges from shrinking up to asin((1 - f) / 2).
"""

import math

import inside_freecad

NAMES = ("die", "wing_main", "flap")
RULES = ("circumcentre", "off-centre")
ANGLE = 25.0
COARSE, NEXT = 20.0, 30.0  # sites are looked at in meshes of the first, for triangles below the second


def parser():
    return inside_freecad.command_line(__doc__)


def shapes(mesh):
    """Arrays by triangle: corners (T, 3, 3), lengths of the sides (T, 3) opposite them, angles (T, 3) in radians."""
    import numpy as np

    corners = mesh.vertices[mesh.triangles]
    sides = np.linalg.norm(corners[:, [2, 0, 1]] - corners[:, [1, 2, 0]], axis=2)
    a, b, c = sides.T
    area2 = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    dots = np.stack([b * b + c * c - a * a, c * c + a * a - b * b, a * a + b * b - c * c], axis=1) / 2.0
    return corners, sides, np.arctan2(area2[:, None], dots)


def check(name, rule, mesh):
    """One row: what is bounded, its bound, and in how many triangles an inequality fails."""
    import numpy as np

    _, sides, angles = shapes(mesh)
    least = angles.min(axis=1)
    ratio = sides.max(axis=1) / sides.min(axis=1)
    height = sides.min(axis=1) * np.sin(np.sort(angles, axis=1)[:, 1])  # the shorter side at the middle angle
    steep = sides.max(axis=1) / height
    slack = 1.0 + 1e-9
    alpha, report = least.min(), mesh.report
    return {
        "part": name, "rule": rule, "triangles": report.triangles, "alpha": math.degrees(alpha),
        "max_angle": report.max_angle, "max_angle_bound": 180.0 - 2.0 * math.degrees(alpha),
        "max_aspect": report.max_aspect, "aspect_bound": 1.0 / math.sin(alpha), "max_over_height": float(steep.max()),
        "max_stretching": report.max_stretching, "max_degree": report.max_degree,
        "degree_bound": math.floor(2.0 * math.pi / alpha),
        "fails_paper_3_edges": int((ratio * slack < 1.0 / np.sin(least)).sum()),
        "fails_edges": int(((ratio * slack < np.minimum(2.0 * np.cos(least), 0.5 / np.sin(least / 2.0)))
                            | (ratio > slack / np.sin(least))).sum()),
        "fails_height": int(((steep * slack < 1.0 / np.sin(least)) | (steep > 2.0 * slack / np.sin(least))).sum()),
    }


def twins_over_longest(triangles, sides):
    """By triangle: the one beyond its longest side, -1 where the mesh ends."""
    at = {}
    for t, corners in enumerate(triangles.tolist()):
        for i in range(3):
            at[corners[i], corners[(i + 1) % 3]] = t
    longest = sides.argmax(axis=1)
    return [at.get((int(tri[(i + 2) % 3]), int(tri[(i + 1) % 3])), -1) for tri, i in zip(triangles, longest)]


def circumcentres(corners, sides):
    import numpy as np

    squares = sides**2
    weights = squares * (squares.sum(axis=1, keepdims=True) - 2.0 * squares)
    weights /= weights.sum(axis=1, keepdims=True)
    centres = np.einsum("ti,tij->tj", weights, corners)
    return centres, np.linalg.norm(centres - corners[:, 0], axis=1)


def sites(name, mesh):
    """f of equation (4) for the triangles that a larger bound would refine next, by the paper's rule."""
    import numpy as np

    corners, sides, angles = shapes(mesh)
    centres, radii = circumcentres(corners, sides)
    beyond = np.array(twins_over_longest(mesh.triangles, sides))
    bad = np.degrees(angles.min(axis=1)) < NEXT
    obtuse = bad & (angles.max(axis=1) > 0.5 * math.pi + 1e-12)
    inside = obtuse & (mesh.triangle_face[beyond] == mesh.triangle_face)
    f = np.linalg.norm(corners[beyond].mean(axis=1) - centres, axis=1)[inside] / radii[inside]
    allowed = 1.0 - 2.0 * math.sin(math.radians(ANGLE))
    return {"part": name, "bad": int(bad.sum()), "obtuse": int(obtuse.sum()), "inside": int(inside.sum()),
            "median_f": float(np.median(f)), "largest_f": float(f.max()), "allowed_f": allowed,
            "share_allowed": float((f <= allowed).mean())}


def work(_):
    import parts

    import MeshQuality as mq

    rows, sited = [], []
    print(f"{'part':<10} {'rule':<13} {'alpha':>6} {'largest angle':>15} {'edges':>13} {'over height':>13} "
          f"{'stretching':>11} {'degree':>9} {'fails: (3) with edges':>22} {'edges':>6} {'height':>7}")
    for name in NAMES:
        shape = parts.ALL[name]()
        for rule in RULES:
            row = check(name, rule, mq.triangulate(shape, min_angle=ANGLE, chord_height="none", insertion=rule))
            rows.append(row)
            print(f"{name:<10} {rule:<13} {row['alpha']:6.2f} {row['max_angle']:7.2f}<{row['max_angle_bound']:7.2f} "
                  f"{row['max_aspect']:6.3f}<{row['aspect_bound']:6.3f} {row['max_over_height']:6.3f}<"
                  f"{2.0 * row['aspect_bound']:6.3f} {row['max_stretching']:11.3f} {row['max_degree']:3} <= "
                  f"{row['degree_bound']:2} {row['fails_paper_3_edges']:22,} {row['fails_edges']:6} "
                  f"{row['fails_height']:7}", flush=True)
        sited.append(sites(name, mq.triangulate(shape, min_angle=COARSE, chord_height="none", insertion="circumcentre")))
    print(f"\n{'part':<10} {'below 30':>9} {'obtuse':>7} {'site on the face':>17} {'median f':>9} {'largest f':>10} "
          f"{'f <= ' + format(sited[0]['allowed_f'], '.3f'):>12}")
    for row in sited:
        print(f"{row['part']:<10} {row['bad']:9,} {row['obtuse']:7,} {row['inside']:17,} {row['median_f']:9.3f} "
              f"{row['largest_f']:10.3f} {row['share_allowed']:12.1%}")
    return {"rows": rows, "sites": sited}


inside_freecad.start(__file__, parser(), work)
