# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a mesh, which share no nodes, that lie in one another.

Where their surfaces do not cross, one point of each says whether it is inside of another one: as often as a ray from the
point leaves the other body's surface more than it enters it.
"""

import numpy as np

from . import boundary, kinds, lagrange

_POINTS = 3  # of a body, in its largest elements, all of which must be inside
_FINER = 2  # flat triangles along an edge, times the order, where it is curved
_AT_A_TIME = 4_000_000  # pairs of points and triangles
_TURN = np.linalg.qr(np.array([[0.61, -0.37, 0.19], [0.23, 0.71, -0.43], [-0.31, 0.29, 0.83]]))[0]  # no ray along an edge


def inside_others(blocks, nodes):
    """[(body, body that it lies in, a point of it)]: numbers of bodies by their lowest nodes; volume elements only."""
    whole = [block for block in blocks if kinds.DIMENSION[block.kind] == 3]
    body_of_node = _bodies(whole, len(nodes))
    if len(np.unique(np.concatenate([body_of_node[block.nodes[:, 0]] for block in whole]))) < 2:
        return []
    body, points = _points(whole, nodes, body_of_node)
    owner, triangles = _flat(whole, nodes, body_of_node)
    found = []
    turned, corners = points @ _TURN, triangles @ _TURN
    order = np.argsort(owner, kind="stable")
    owner, corners = owner[order], corners[order]
    names, first = np.unique(owner, return_index=True)
    for number, start, end in zip(names.tolist(), first, [*first[1:], len(owner)]):
        part = corners[start:end]
        low, high = part.min(axis=(0, 1)), part.max(axis=(0, 1))
        near = np.flatnonzero(((turned > low) & (turned < high)).all(axis=1) & (body != number))
        near = near[_leaves(turned[near], part) != 0]
        inside, counts = np.unique(body[near], return_counts=True)
        for other in inside[counts == _POINTS].tolist():
            found.append((other, number, tuple(points[near[body[near] == other][0]].tolist())))
    return found


def _bodies(whole, count):
    """By node the lowest node that elements connect it with: trees are hooked onto lower ones and made flat in turn (Shiloach
    and Vishkin 1982), in rounds that grow as the logarithm of the number of nodes."""
    found = np.arange(count)
    while True:
        before = found.copy()
        for block in whole:
            trees = found[block.nodes]
            np.minimum.at(found, trees, trees.min(axis=1)[:, None])
        while (found[found] != found).any():
            found = found[found]
        if (found == before).all():
            return found


def _points(whole, nodes, body_of_node):
    """(body, point): _POINTS of each body, in its elements with the largest boxes, which may be one."""
    parts = []
    for block in whole:
        shape = nodes[block.nodes]
        if block.kind == "tetrahedron":
            middle = np.einsum("n,enx->ex", lagrange.values("tetrahedron", block.order, np.full((1, 4), 0.25))[0], shape)
        else:
            middle = shape[:, :kinds.CORNERS[block.kind]].mean(axis=1)
        size = np.prod(shape.max(axis=1) - shape.min(axis=1), axis=1)
        parts.append((body_of_node[block.nodes[:, 0]], size, middle))
    body, size, middle = map(np.concatenate, zip(*parts))
    order = np.lexsort((-size, body))
    body, middle = body[order], middle[order]
    _, first, counts = np.unique(body, return_index=True, return_counts=True)
    chosen = np.concatenate([first + np.minimum(i, counts - 1) for i in range(_POINTS)])
    return body[chosen], middle[chosen]


def _flat(whole, nodes, body_of_node):
    """(body (T,), corners (T, 3, 3)) of flat triangles that the surface is cut into."""
    owners, found = [], []
    for rows, _, _ in boundary.with_elements(whole):
        count = rows.shape[1]
        kind = "triangle" if kinds.order_of("triangle", count) else "quadrilateral"
        order = kinds.order_of(kind, count)
        at, cells = _lattice(kind, order if order == 1 and kind == "triangle" else _FINER * order)
        places = np.einsum("pn,fnx->fpx", lagrange.at_places(kind, count, at), nodes[rows])
        found.append(places[:, cells].reshape(-1, 3, 3))
        owners.append(np.repeat(body_of_node[rows[:, 0]], len(cells)))
    return np.concatenate(owners), np.concatenate(found)


def _lattice(kind, steps):
    """(places (n, 3), triangles (m, 3)) that divide a reference triangle or quadrilateral."""
    number, at, cells = {}, [], []
    for j in range(steps + 1):
        for i in range(steps + 1 - (j if kind == "triangle" else 0)):
            number[i, j] = len(at)
            at.append((i / steps, j / steps, 0.0))
    for i, j in number:
        for cell in (((i, j), (i + 1, j), (i, j + 1)), ((i + 1, j), (i + 1, j + 1), (i, j + 1))):
            if all(corner in number for corner in cell):
                cells.append([number[corner] for corner in cell])
    return np.array(at), np.array(cells)


def _leaves(points, triangles):
    """int (n,): how often a ray upwards from each point leaves the surface, less how often it enters it."""
    found = np.zeros(len(points), dtype=int)
    low, high = triangles[:, :, :2].min(axis=1), triangles[:, :, :2].max(axis=1)
    step = max(1, _AT_A_TIME // max(len(triangles), 1))
    for start in range(0, len(points), step):
        some = points[start:start + step]
        over = ((some[:, None, 0] >= low[:, 0]) & (some[:, None, 0] <= high[:, 0])
                & (some[:, None, 1] >= low[:, 1]) & (some[:, None, 1] <= high[:, 1]))
        point, triangle = np.nonzero(over)
        corners = triangles[triangle] - some[point][:, None]
        x, y, z = np.moveaxis(corners, 2, 0)
        areas = np.stack([x[:, i] * y[:, j] - x[:, j] * y[:, i] for i, j in ((1, 2), (2, 0), (0, 1))], axis=1)
        total = areas.sum(axis=1)
        hit = (np.sign(areas) == np.sign(total)[:, None]).all(axis=1)
        hit[hit] &= (areas[hit] * z[hit]).sum(axis=1) / total[hit] > 0
        np.add.at(found, start + point[hit], np.sign(total[hit]).astype(int))
    return found
