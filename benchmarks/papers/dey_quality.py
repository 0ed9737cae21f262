#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Equation (4) of Dey, O'Bara, Shephard at sample points beside proven bounds of equation (3), on the same elements.

    /usr/bin/python3 benchmarks/papers dey-quality [--order 2] [--random 20000]

Equation (4) is min J N / sum J over N points. The paper's points are the corners, the middles of edges and faces, and the centroid:
15. The others are all points of a lattice in the tetrahedron. Equation (3) is min J / max J over the whole element, for which the
core proves bounds 0.01 apart. Missed: elements that are proven to be folded, although J is positive at all of the points.

At last the allowable deviation, inequality (14): the largest alpha at which an equilateral triangle of unit edges is proven valid when
the middle of one edge is moved inwards by alpha.

The meshes are those of mq.curve on solids of curve_models.py. The random ones are equilateral tetrahedra whose nodes other than
corners are moved by up to the given fraction of an edge, from one seed. Missed ones are counted there.
"""

from pathlib import Path

import inside_freecad
import numpy as np

SOLIDS = ("torus", "elbow", "tee", "filletbox", "wavyplate", "thinshell")
OFFSETS = (0.15, 0.2, 0.3)
LATTICES = (4, 8, 16)
FOLDED = 1  # the core's verdict


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--order", type=int, default=2, choices=(2, 3, 4))
    result.add_argument("--random", type=int, default=20_000, help="tetrahedra of each offset")
    return result


def lattice(count):
    """All points of the reference tetrahedron with coordinates i / count."""
    steps = range(count + 1)
    return np.array([(i, j, k) for i in steps for j in steps for k in steps if i + j + k <= count]) / count


def paper_points():
    """Section 5.2: corners, middles of edges and faces, centroid."""
    corners = np.vstack([np.zeros(3), np.eye(3)])
    edges = [(corners[i] + corners[j]) / 2 for i in range(4) for j in range(i)]
    faces = [corners[[i for i in range(4) if i != k]].mean(axis=0) for k in range(4)]
    return np.vstack([corners, edges, faces, corners.mean(axis=0)])


def places(order):
    """Of the nodes in the reference tetrahedron, in the core's order: from an element that is straight."""
    import Part
    import poisson

    import MeshQuality as mq

    box = mq.curve(Part.makeBox(1, 1, 1), order=order, volume=True)
    return poisson.places_of_nodes(box.nodes, box.elements, order)


def jacobians(nodes, elements, element, points):
    """J (elements, points)."""
    slopes = element.gradients(points)
    return np.linalg.det(np.einsum("qnr,enx->eqxr", slopes, nodes[elements], optimize=True))


def random_elements(order, count, offset, at):
    regular = np.array([[1, 0.5, 0.5], [0, np.sqrt(0.75), np.sqrt(1 / 12)], [0, 0, np.sqrt(2 / 3)]])
    nodes = np.tile(at @ regular.T, (count, 1, 1))
    dice = np.random.default_rng(1)
    nodes[:, 4:] += dice.uniform(-offset, offset, nodes[:, 4:].shape)
    return nodes.reshape(-1, 3), np.arange(nodes.shape[0] * nodes.shape[1], dtype=np.int32).reshape(count, -1)


def measured(nodes, elements, order, element):
    from MeshQuality.compat import extension

    low, high, verdict = extension().check_elements("tetrahedron", order, np.ascontiguousarray(nodes),
                                                    np.ascontiguousarray(elements, dtype=np.int32))
    sampled = jacobians(nodes, elements, element, paper_points())
    fourth = sampled.min(axis=1) * sampled.shape[1] / sampled.sum(axis=1)
    folded = verdict == FOLDED
    row = {"elements": len(elements), "low": float(low.min()), "high": float(high[low.argmin()]), "mean_low": float(low.mean()),
           "fourth": float(fourth.min()), "mean_fourth": float(fourth.mean()),
           "third_sampled": float((sampled.min(axis=1) / sampled.max(axis=1)).min()), "folded": int(folded.sum()),
           "not_proven": int((verdict > FOLDED).sum()), "missed": {15: int((sampled.min(axis=1)[folded] > 0).sum())}}
    for count in LATTICES if folded.any() else ():
        points = lattice(count)
        least = jacobians(nodes, elements[folded], element, points).min(axis=1)
        row["missed"][len(points)] = int((least > 0).sum())
    return row


def head(title):
    print(f"\n{title:<12} {'elements':>8} {'(3) proven: least':>17} {'mean':>5} {'(3) at 15 points':>16} {'(4) at 15 points':>16} {'mean':>5} "
          f"{'folded':>6} {'missed':>6}")


def text(name, row):
    return f"{name:<12} {row['elements']:8,} {row['low']:17.3f} {row['mean_low']:5.2f} {row['third_sampled']:16.3f} {row['fourth']:16.3f} " \
           f"{row['mean_fourth']:5.2f} {row['folded']:6,} {', '.join(f'{n:,} of {k} points' for k, n in row['missed'].items())}"


def allowable_deviation():
    """By halving; the paper derives sqrt(3) / 4."""
    from MeshQuality.compat import extension

    corners = np.array([[0, 0, 0], [1, 0, 0], [0.5, np.sqrt(0.75), 0]])
    low, high = 0.0, 1.0
    while high - low > 1e-6:
        alpha = (low + high) / 2
        middles = (corners + np.roll(corners, -1, axis=0)) / 2 + np.array([[0, alpha, 0], [0, 0, 0], [0, 0, 0]])
        verdict = extension().check_elements("triangle", 2, np.vstack([corners, middles]), np.arange(6, dtype=np.int32)[None])[2]
        low, high = (alpha, high) if verdict[0] == 0 else (low, alpha)
    return low


def work(arguments):
    import curve_models
    import poisson

    import MeshQuality as mq

    order = arguments.order
    element = poisson.Element(order, places(order))
    found = {"order": order, "solids": {}, "random": {}}
    head(f"order {order}")
    for name in SOLIDS:
        mesh = mq.curve(curve_models.load(name, Path()), order=order, volume=True)
        found["solids"][name] = measured(mesh.nodes, mesh.tetrahedra, order, element)
        print(text(name, found["solids"][name]), flush=True)
    head("random")
    for offset in OFFSETS:
        row = found["random"][offset] = measured(*random_elements(order, arguments.random, offset, element.places), order, element)
        print(text(f"{offset:.2f}", row), flush=True)
    found["alpha"] = allowable_deviation()
    print(f"\nallowable deviation: proven valid up to {found['alpha']:.5f} of the edge; sqrt(3) / 4 = {np.sqrt(3) / 4:.5f}")
    return found


inside_freecad.start(__file__, parser(), work)
