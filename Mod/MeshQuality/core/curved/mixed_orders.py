# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes whose elements have orders of their own (p-adaptivity): what elements share has the lowest order of these."""

from typing import NamedTuple

import numpy as np

from ...compat import extension
from ...errors import InvalidInput
from ..elements import kinds, polynomials
from ..elements.assembly import Content, ElementBlock
from ..elements.entity_groups import entity_groups

_UNITS = 3600  # weights of corners at nodes on sides are whole numbers of its parts, for orders 1 to 5


class _Sides(NamedTuple):
    """Edges or faces, each once."""

    kind: str
    nodes: np.ndarray  # (n, nodes), those of the first element with it
    order: np.ndarray  # (n,)
    keys: dict  # corners, ascending: which


def with_orders(mesh, order, orders, raise_invalid):
    """(Content, quality by block) of elements of one order, when each has an order of its own.

    mesh           has nodes, blocks and group_members as an ElementMesh, all full elements of `order`
    orders         of the elements of the highest dimension, block by block
    raise_invalid  whether orders are raised, of elements that would not be proven valid and all that share a corner with
                   these, until none is left or they have the order of the mesh
    """
    orders = _checked(mesh, order, orders)
    found, element = _made(mesh, order, orders)
    while raise_invalid:
        beside = _beside_invalid(mesh, found, element) & (orders < order)
        if not beside.any():
            break
        orders = orders + beside
        found, element = _made(mesh, order, orders)
    return found


def _beside_invalid(mesh, found, element):
    """bool (E,): whether an element shares a corner with an element that is not proven valid."""
    whole = [block for block in mesh.blocks if kinds.DIMENSION[block.kind] == mesh.dimension]
    invalid = np.zeros(sum(len(block.nodes) for block in whole), dtype=bool)
    for quality, rows in zip(found[1], element):
        invalid[rows[~(quality > 0.0)]] = True
    corners = [block.nodes[:, :kinds.CORNERS[block.kind]] for block in whole]
    bad = np.zeros(len(mesh.nodes), dtype=bool)
    parts = np.split(invalid, np.cumsum([len(part) for part in corners])[:-1])
    for part, of_part in zip(corners, parts):
        bad[part[of_part]] = True
    return np.concatenate([bad[part].any(axis=1) for part in corners])


def _made(mesh, order, orders):
    """((Content, quality), [int (n,) by block of these that has the highest dimension: which elements these are])."""
    whole = [block for block in mesh.blocks if kinds.DIMENSION[block.kind] == mesh.dimension]
    rest = [block for block in mesh.blocks if kinds.DIMENSION[block.kind] < mesh.dimension]
    parts = np.split(orders, np.cumsum([len(block.nodes) for block in whole])[:-1])
    nodes = mesh.nodes.copy()
    edges = _edges(whole, parts, order)
    _lower(edges, mesh.nodes, nodes, order)
    known = dict(edges.keys)
    low = {key: int(edges.order[i]) for key, i in known.items()}
    if mesh.dimension == 3:
        for sides in _faces(whole, parts, order):
            _lower(sides, mesh.nodes, nodes, order)
            low.update({key: int(sides.order[i]) for key, i in sides.keys.items()})
    of_rest = [np.array([low.get(tuple(sorted(corners)), order) for corners in
                         block.nodes[:, :kinds.CORNERS[block.kind]].tolist()], dtype=int) for block in rest]
    made = _Made(mesh, nodes, order)
    for number, (block, of_elements) in enumerate(zip([*whole, *rest], [*parts, *of_rest])):
        made.add(number, block, of_elements)
    found = made.mesh([*whole, *rest])
    starts = np.cumsum([0, *(len(part) for part in parts)])
    return found, [starts[number] + rows for number, rows, *_ in made.parts if number < len(whole)]


def _checked(mesh, order, orders):
    parts = [np.asarray(part) for part in (orders if isinstance(orders, (tuple, list)) and len(orders) and
                                           np.ndim(orders[0]) else [orders])]
    found = np.concatenate([np.atleast_1d(part) for part in parts])
    count = sum(len(block.nodes) for block in mesh.blocks if kinds.DIMENSION[block.kind] == mesh.dimension)
    if len(found) != count:
        raise InvalidInput(f"orders has {len(found):,} numbers for {count:,} elements: give one for each")
    if found.dtype.kind not in "iu" or (found < 1).any() or (found > order).any():
        raise InvalidInput(f"orders must be whole numbers from 1 to {order}, the order of the mesh")
    return found.astype(int)


def _edges(blocks, orders, order):
    inner = np.arange(1, order)[:, None] / order
    parts = []
    for block, of_elements in zip(blocks, orders):
        corners = kinds.places(block.kind, kinds.CORNERS[block.kind])
        for a, b in kinds.EDGES[block.kind]:
            local = kinds.matching(block.kind, block.nodes.shape[1],
                                   np.concatenate([corners[[a, b]], corners[a] + (corners[b] - corners[a]) * inner]))
            parts.append((block.nodes[:, local], of_elements))
    return _once("line", parts)


def _faces(blocks, orders, order):
    parts = {}
    for block, of_elements in zip(blocks, orders):
        for kind, local in kinds.faces_of(block.kind, block.nodes.shape[1]):
            parts.setdefault(kind, []).append((block.nodes[:, local], of_elements))
    return [_once(kind, of_kind) for kind, of_kind in parts.items()]


def _once(kind, parts):
    nodes = np.concatenate([part for part, _ in parts])
    orders = np.concatenate([part for _, part in parts])
    keys, first, number = np.unique(np.sort(nodes[:, :kinds.CORNERS[kind]], axis=1), axis=0, return_index=True,
                                    return_inverse=True)
    lowest = np.full(len(keys), orders.max(initial=1))
    np.minimum.at(lowest, number.ravel(), orders)
    return _Sides(kind, nodes[first], lowest, {tuple(key): i for i, key in enumerate(keys.tolist())})


def _lower(sides, before, nodes, order):
    """Puts the nodes of sides on polynomials of the orders of the sides, which go through the present borders."""
    inner, weights = _blending(sides.kind, order)
    for lower in np.unique(sides.order).tolist():
        rows = sides.nodes[sides.order == lower]
        places = _blended(before[rows], nodes[rows], inner, weights)
        if lower < order:
            places = np.einsum("ij,njk->nik", polynomials.lowered(sides.kind, order, lower), places)
        nodes[rows[:, kinds.CORNERS[sides.kind]:]] = places[:, kinds.CORNERS[sides.kind]:]


def _blending(kind, order):
    if kind == "line":
        return np.zeros(0, dtype=int), np.zeros((0, order + 1))
    inner, weights = extension().blending(kind, order)
    return inner, weights.reshape(len(inner), kinds.count_of(kind, order))


def _blended(before, now, inner, weights):
    """The nodes now; those inside are moved by what is moved around them."""
    if len(inner):
        now[:, inner] = before[:, inner] + np.einsum("ij,njk->nik", weights, now - before)
    return now


class _Made:
    """Blocks of one kind and order, whose nodes on sides are known by the corners they lie between."""

    def __init__(self, mesh, nodes, order):
        self._mesh, self._nodes, self._order = mesh, nodes, order
        self.parts = []  # (block of before, rows, order, places (n, nodes, 3), keys (n, nodes, 8))
        self._inside = 0

    def add(self, number, block, orders):
        """The elements of a block, by their orders."""
        inner, weights = _blending(block.kind, self._order)
        whole = kinds.DIMENSION[block.kind] == self._mesh.dimension
        for order in np.unique(orders).tolist():
            rows = np.flatnonzero(orders == order)
            places = self._nodes[block.nodes[rows]]
            if whole:
                places = _blended(self._mesh.nodes[block.nodes[rows]], places, inner, weights)
            places = np.einsum("ij,njk->nik", polynomials.between(block.kind, self._order, order), places)
            corners = block.nodes[rows, :kinds.CORNERS[block.kind]]
            places[:, :corners.shape[1]] = self._mesh.nodes[corners]
            self.parts.append((number, rows, order, places, self._keys(block.kind, order, corners)))

    def _keys(self, kind, order, corners):
        weights = np.rint(polynomials.corner_weights(kind, order) * _UNITS).astype(np.int64)
        keys = np.full((len(corners), len(weights), 8), -1, dtype=np.int64)
        for node, of_node in enumerate(weights):
            carriers = np.flatnonzero(of_node)
            if len(carriers) > 4 or (len(carriers) == 4 and kind == "tetrahedron"):  # inside of one element
                keys[:, node, 0] = -2 - self._inside - np.arange(len(corners))
                self._inside += len(corners)
                continue
            chosen = corners[:, carriers]
            by_number = np.argsort(chosen, axis=1)
            keys[:, node, 0:2 * len(carriers):2] = np.take_along_axis(chosen, by_number, axis=1)
            keys[:, node, 1:2 * len(carriers):2] = of_node[carriers][by_number]
        return keys

    def mesh(self, before):
        """(Content, quality)."""
        keys = np.concatenate([part[4].reshape(-1, 8) for part in self.parts])
        places = np.concatenate([part[3].reshape(-1, 3) for part in self.parts])
        _, first, number = np.unique(keys, axis=0, return_index=True, return_inverse=True)
        is_corner = (keys[first][:, 1] == _UNITS)
        rank = np.empty(len(first), dtype=np.int64)
        rank[np.lexsort((first, ~is_corner))] = np.arange(len(first))  # corners first
        nodes = np.empty((len(first), 3))
        nodes[rank] = places[first]
        number, blocks, rows_of, at = rank[number.ravel()], [], [], 0
        for of_block, rows, order, part, _ in self.parts:
            count = part.shape[0] * part.shape[1]
            old = before[of_block]
            made = np.ascontiguousarray(number[at:at + count].reshape(part.shape[:2]), dtype=np.int32)
            blocks.append(ElementBlock(old.kind, order, made, np.full(len(rows), -1, dtype=np.int32),
                                       old.geometry[rows].copy()))
            rows_of.append((of_block, rows))
            at += count
        members = {**self._carried(before, rows_of), **entity_groups(blocks)}
        quality = [self._quality(block, nodes) for block in blocks]
        return Content(nodes, tuple(blocks), members, ()), quality

    @staticmethod
    def _quality(block, nodes):
        if block.kind == "line":
            return np.ones(len(block.nodes))
        low, _, verdict = extension().check_elements(block.kind, block.order, nodes, block.nodes, None)
        return np.where(verdict == 0, low, np.minimum(low, 0.0))

    def _carried(self, before, rows_of):
        numbers = {id(block): i for i, block in enumerate(self._mesh.blocks)}
        members = {}
        for name, parts in self._mesh.group_members.items():
            within = {number: np.isin(np.arange(len(self._mesh.blocks[number].nodes)), rows) for number, rows in parts}
            found = []
            for i, (of_block, rows) in enumerate(rows_of):
                chosen = within.get(numbers[id(before[of_block])])
                if chosen is not None and chosen[rows].any():
                    found.append((i, np.flatnonzero(chosen[rows]).astype(np.int32)))
            if found:
                members[name] = tuple(found)
        return members
