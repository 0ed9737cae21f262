# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a mesh, which faces of elements connect, that lie in one another.

A body in another one whose surfaces do not cross is found by rays, which from a point inside leave a body's surface more
often than they enter it. This is how verify looks for them; certify has the core look for points inside of two elements.
"""

import numpy as np

from . import boundary, kinds, lagrange

_POINTS = 3  # points of a body, in its largest elements, all of which must be inside
_FINER = 2  # flat triangles along an edge, times the order, where it is curved
_AT_A_TIME = 4_000_000  # pairs of points and triangles
_TURN = np.linalg.qr(np.array([[0.61, -0.37, 0.19], [0.23, 0.71, -0.43], [-0.31, 0.29, 0.83]]))[0]  # no ray along an edge


def inside_others(blocks, nodes):
    """[(body, body that it lies in, a point of it)]: numbers of bodies as `of_elements` has them; volume elements only."""
    whole = solids(blocks)
    body_of = of_elements(whole)
    if len(np.unique(body_of)) < 2:
        return []
    starts = np.cumsum([0, *(len(block.nodes) for block in whole)])
    body, points = _points(whole, nodes, [body_of[a:b] for a, b in zip(starts, starts[1:])])
    owner, triangles = [], []
    for rows, block, element in boundary.with_elements(whole):
        owner.append(body_of[starts[block] + element])
        triangles.append(_flat(nodes[rows], rows.shape[1]))
    owner = np.concatenate([np.repeat(part, len(flat) // max(len(part), 1)) for part, flat in zip(owner, triangles)])
    triangles = np.concatenate(triangles)
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


def solids(blocks):
    """The blocks of volume elements."""
    return [block for block in blocks if kinds.DIMENSION[block.kind] == 3]


def of_elements(whole):
    """int32 (E,): by element the lowest index of an element that faces connect with it: trees are hooked onto lower ones and
    made flat in turn (Shiloach and Vishkin 1982), in rounds that grow as the logarithm of the number of elements."""
    found = np.arange(sum(len(block.nodes) for block in whole))
    pairs = _neighbours(whole)
    while True:
        before = found.copy()
        trees = found[pairs]
        lowest = trees.min(axis=1)
        for k in (0, 1):
            np.minimum.at(found, trees[:, k], lowest)
        while (found[found] != found).any():
            found = found[found]
        if (found == before).all():
            return found.astype(np.int32)


def _neighbours(whole):
    """int (P, 2): elements that have the corners of a face in common."""
    pairs, starts = [np.empty((0, 2), dtype=int)], np.cumsum([0, *(len(block.nodes) for block in whole)])
    for corners in (3, 4):
        faces = [(np.sort(block.nodes[:, list(face)], axis=1), start + np.arange(len(block.nodes)))
                 for block, start in zip(whole, starts) for face in kinds.FACES[block.kind] if len(face) == corners]
        if faces:
            rows, owner = map(np.concatenate, zip(*faces))
            order = np.lexsort(rows.T[::-1])
            same = (rows[order][1:] == rows[order][:-1]).all(axis=1)
            pairs.append(np.stack([order[1:][same], order[:-1][same]], axis=1))
            pairs[-1] = owner[pairs[-1]]
    return np.concatenate(pairs)


def holds(block, element, nodes, point):
    """Whether a point is inside of an element, by rays."""
    shape = nodes[block.nodes[element]]
    triangles = np.concatenate([_flat(shape[local][None], len(local)) for _, local in kinds.faces_of(block.kind, len(shape))])
    return bool(_leaves(np.array([point]) @ _TURN, triangles @ _TURN)[0] != 0)


def _points(whole, nodes, body_of):
    """(body, point): _POINTS of each body, in its elements with the largest boxes, which may be one."""
    parts = []
    for block, owner in zip(whole, body_of):
        shape = nodes[block.nodes]
        if block.kind == "tetrahedron":
            middle = np.einsum("n,enx->ex", lagrange.values("tetrahedron", block.order, np.full((1, 4), 0.25))[0], shape)
        else:
            middle = shape[:, :kinds.CORNERS[block.kind]].mean(axis=1)
        size = np.prod(shape.max(axis=1) - shape.min(axis=1), axis=1)
        parts.append((owner, size, middle))
    body, size, middle = map(np.concatenate, zip(*parts))
    order = np.lexsort((-size, body))
    body, middle = body[order], middle[order]
    _, first, counts = np.unique(body, return_index=True, return_counts=True)
    chosen = np.concatenate([first + np.minimum(i, counts - 1) for i in range(_POINTS)])
    return body[chosen], middle[chosen]


def _flat(sides, count):
    """float64 (T, 3, 3): flat triangles that sides (F, nodes, 3) of this number of nodes are cut into, those of one after the
    other.
    """
    kind = "triangle" if kinds.order_of("triangle", count) else "quadrilateral"
    order = kinds.order_of(kind, count)
    at, cells = _lattice(kind, order if order == 1 and kind == "triangle" else _FINER * order)
    places = np.einsum("pn,fnx->fpx", lagrange.at_places(kind, count, at), sides)
    return places[:, cells].reshape(-1, 3, 3)


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
