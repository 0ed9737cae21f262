# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes what an ElementMesh has of the Parts of a file: checked indices, one block a kind and order, groups."""

import itertools
from collections import namedtuple
from typing import NamedTuple

import numpy as np

from ...errors import InvalidInput
from . import kinds

_MOST = 2**31 - 1
_FAR = 1e100  # squares and products of three coordinates are still numbers
_SAMPLE = 20000  # elements by which the orientation of all is told


class ElementBlock(namedtuple("ElementBlock", "kind order nodes group geometry")):
    """The elements of one kind and order of an ElementMesh.

    kind      "line", "triangle", "quadrilateral", "tetrahedron", "pyramid", "prism" or "hexahedron"
    order     1 to 5
    nodes     int32 (E, nodes per element), rows of ElementMesh.nodes in Gmsh's order; quadrilaterals of 8 nodes,
              pyramids of 13, prisms of 15 and hexahedra of 20 are of order 2
    group     int32 (E,), element i is in ElementMesh.groups[group[i]], the first one of its groups; -1: in none
    geometry  int32 (E,), the CAD entity that the file names, from 0: volume, face or edge; -1: none

    The arrays are read-only.
    """

    __slots__ = ()


class Content(NamedTuple):
    """What an ElementMesh has; see there."""

    nodes: np.ndarray
    blocks: tuple
    members: dict
    faults: tuple


def assembled(parts, scale=1.0):
    """The Content of the Parts of a file. Raises InvalidInput naming the element at fault."""
    if parts.point_numbers is not None:  # nodes and elements go by their numbers, wherever the file has them
        _sort(parts)
    nodes = _points(parts, scale)
    places = _Places(parts.point_numbers, len(nodes), "node")
    sections, first = [], 1
    for section in parts.sections:
        if not len(section.nodes):
            continue
        if section.numbers is None:
            section.numbers = np.arange(first, first + len(section.nodes))
        first = int(section.numbers[-1]) + 1
        sections.append(section)
    if not sections:
        raise InvalidInput("there are no elements in it: mesh the part before writing")
    return _Assembly(nodes, places, sections, parts).content()


def _sort(parts):
    numbers = np.asarray(parts.point_numbers)
    if not (numbers[1:] > numbers[:-1]).all() and len(numbers) == len(parts.points):
        order = np.argsort(numbers, kind="stable")
        parts.point_numbers, parts.points = numbers[order], np.asarray(parts.points)[order]
        again = int((parts.point_numbers[1:] == parts.point_numbers[:-1]).sum())
        if again:
            parts.notes.append(f"{_counted(again, 'node')} with the number of another one, whose place was taken")


def _points(parts, scale):
    points = np.asarray(parts.points, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] not in (2, 3) or not len(points):
        raise InvalidInput("there are no nodes in it: write the mesh anew")
    if points.shape[1] == 2:
        points = np.concatenate([points, np.zeros((len(points), 1))], axis=1)
    bad = np.flatnonzero(~(np.abs(points) < _FAR).all(axis=1))
    if len(bad):
        number = int(bad[0] if parts.point_numbers is None else parts.point_numbers[bad[0]])
        raise InvalidInput(f"node {number} has coordinates that are not finite, or beyond all bounds: correct the file, or write it "
                           "anew")
    if len(points) > _MOST:
        raise InvalidInput(f"there are {len(points):,} nodes, more than {_MOST:,}: write parts of the mesh")
    return np.ascontiguousarray(points * scale)


class _Places:
    """Where the nodes of the file's numbers are."""

    def __init__(self, numbers, count, what):
        self._count, self._what = count, what
        self._first, self._order = 0, None
        if numbers is not None:
            numbers = np.asarray(numbers)
            self._first = int(numbers[0]) if count else 0
            if count and not (len(numbers) == count and (numbers == np.arange(self._first, self._first + count)).all()):
                self._order = np.argsort(numbers, kind="stable")
                self._sorted = numbers[self._order]

    def of(self, numbers):
        """(indices, whether each is there)."""
        if self._order is None:
            found = numbers - self._first
            there = (found >= 0) & (found < self._count)
            return np.where(there, found, 0), there
        at = np.minimum(np.searchsorted(self._sorted, numbers), len(self._sorted) - 1)
        return self._order[at], self._sorted[at] == numbers


class _Assembly:
    """Makes blocks of the sections that are alike, and groups of the numbers of elements."""

    def __init__(self, nodes, places, sections, parts):
        self._nodes, self._parts, self.faults = nodes, parts, list(parts.notes)
        alike = {}
        for section in sections:
            alike.setdefault((section.kind, np.shape(section.nodes)[1]), []).append(section)
        order = list(kinds.CORNERS)
        self._blocks, self._numbers, self._turned = [], [], set()
        for kind, count in sorted(alike, key=lambda key: (-kinds.DIMENSION[key[0]], order.index(key[0]), key[1])):
            numbers = np.concatenate([section.numbers for section in alike[kind, count]]).astype(np.int64)
            indices = np.concatenate([self._indices(section, places) for section in alike[kind, count]])
            self._check(kind, count, indices, numbers)
            geometry = np.concatenate([_geometry(section) for section in alike[kind, count]])
            if not (numbers[1:] > numbers[:-1]).all():
                by_number = np.argsort(numbers, kind="stable")
                numbers, indices, geometry = numbers[by_number], indices[by_number], geometry[by_number]
            indices = self._righted(kind, self._ordered(kind, indices))
            self._blocks.append([kind, kinds.order_of(kind, count), indices, geometry])
            self._numbers.append(numbers)

    def _indices(self, section, places):
        nodes = np.asarray(section.nodes)
        found, there = places.of(nodes)
        if not there.all():
            row, column = np.argwhere(~there)[0]
            raise InvalidInput(f"{section.kind} {int(section.numbers[row])} has node {int(nodes[row, column])}, which is not "
                               "there: write the file anew, with all nodes")
        return found.astype(np.int32)

    def _check(self, kind, count, indices, numbers):
        if kinds.order_of(kind, count) is None:
            raise InvalidInput(f"{kind} {int(numbers[0])} has {count} nodes, which no {kind} of order 1 to "
                               f"{kinds.HIGHEST_ORDER} has: write the mesh with another order")
        corners = range(kinds.CORNERS[kind])
        again = np.zeros(len(indices), dtype=bool)
        for a, b in itertools.combinations(corners, 2):
            again |= indices[:, a] == indices[:, b]
        again = np.flatnonzero(again)
        if len(again):
            shown = ", ".join(str(number) for number in numbers[again[:5]].tolist())
            more = ", ..." if len(again) > 5 else ""
            self.faults.append(f"{_counted(len(again), kind)} with a corner twice: {shown}{more}")

    def _ordered(self, kind, indices):
        """The elements of order 2 by the order of nodes in which their middle nodes lie in the middle of edges: some programs
        write another order than the format has.
        """
        count = indices.shape[1]
        off = _off_middle(self._nodes, kind, indices) if kinds.order_of(kind, count) == 2 else 0
        if not off:
            return indices
        for convention in (kinds.RINGS, kinds.LEVELS):
            other = indices[:, np.argsort(kinds.from_convention(kind, count, convention))]
            if off > len(indices) / 2 and _off_middle(self._nodes, kind, other) < len(indices) / 10:
                self.faults.append(f"{_counted(len(indices), kind)} with their nodes in Gmsh's order, not in that of the format: "
                                   "taken so")
                return np.ascontiguousarray(other)
        self.faults.append(f"{_counted(off, kind)} with a middle node that is farther from the middle of its edge than the "
                           "edge's ends")
        return indices

    def _righted(self, kind, indices):
        """The elements, mirrored where most of them are inside out: formats differ in what is positive."""
        some = indices[::max(1, len(indices) // _SAMPLE)]
        if kinds.DIMENSION[kind] == 3 and _inverted(self._nodes, kind, some) > len(some) / 2:
            indices = np.ascontiguousarray(indices[:, kinds.turned(kind, indices.shape[1])])
            self._turned.add(len(self._blocks))
            self.faults.append(f"{_counted(len(indices), kind)} that the file has inside out, as some formats do: turned")
        return indices

    def content(self):
        """The Content."""
        members = self._members()
        names = list(members)
        blocks = []
        for i, (kind, order, nodes, geometry) in enumerate(self._blocks):
            group = np.full(len(nodes), -1, dtype=np.int32)
            for rank in range(len(names) - 1, -1, -1):
                for block, rows in members[names[rank]]:
                    if block == i:
                        group[rows] = rank
            blocks.append(ElementBlock(kind, order, np.ascontiguousarray(nodes), group, geometry))
        self.faults += _odd_nodes(self._nodes, blocks)
        return Content(self._nodes, tuple(blocks), members, tuple(self.faults))

    def _members(self):
        places = [_Places(numbers, len(numbers), "element") for numbers in self._numbers]
        members = {}
        for name, lists in self._parts.groups.items():
            wanted, found = np.unique(np.concatenate(lists).astype(np.int64)), []
            left = np.ones(len(wanted), dtype=bool)
            for i, place in enumerate(places):
                rows, there = place.of(wanted)
                left &= ~there
                if there.any():
                    found.append((i, np.sort(rows[there]).astype(np.int32)))
            if left.any():
                self.faults.append(f"group {name!r} names {_counted(int(left.sum()), 'element')} that are not there, such as "
                                   f"{int(wanted[left][0])}")
            members[name] = tuple(found)
        for name, found in self._faces_of_sides(places):
            members[name] = _joined(members.get(name, ()), found)
        return members

    def _faces_of_sides(self, places):
        """(name, [(block, rows)]) of new elements: the faces by which a file names a part of the boundary."""
        for name, numbers, sides in self._parts.sides:
            found, sides = {}, np.asarray(sides)
            for i, place in enumerate(places):
                rows, there = place.of(np.asarray(numbers, dtype=np.int64))
                for side in np.unique(sides[there]).tolist() if kinds.DIMENSION[self._blocks[i][0]] == 3 else ():
                    flat, nodes = self._side(name, i, rows[there & (sides == side)], side)
                    found.setdefault((flat, nodes.shape[1]), []).append(nodes)
            yield name, [self._appended(flat, np.concatenate(parts)) for (flat, _), parts in found.items()]

    def _side(self, name, block, rows, side):
        """(kind, nodes) of a side of elements; the file counts those of the elements as it has them."""
        kind, nodes = self._blocks[block][0], self._blocks[block][2][rows]
        order = self._parts.side_order[kind]
        if not 1 <= side <= len(order):
            raise InvalidInput(f"group {name!r} names side {side} of a {kind}, which has {len(order)}: write the file anew")
        mirrored = block in self._turned
        if mirrored:
            nodes = nodes[:, kinds.turned(kind, nodes.shape[1])]
        flat, local = kinds.faces_of(kind, nodes.shape[1])[order[side - 1]]
        faces = nodes[:, local]
        return flat, faces[:, kinds.turned(flat, len(local))] if mirrored else faces

    def _appended(self, kind, nodes):
        """Puts elements behind those of their block; (index of the block, their rows)."""
        for i, block in enumerate(self._blocks):
            if block[0] == kind and block[2].shape[1] == nodes.shape[1]:
                break
        else:
            i = len(self._blocks)
            empty = np.zeros((0, nodes.shape[1]), dtype=np.int32)
            self._blocks.append([kind, kinds.order_of(kind, nodes.shape[1]), empty, np.zeros(0, dtype=np.int32)])
        block = self._blocks[i]
        rows = np.arange(len(block[2]), len(block[2]) + len(nodes), dtype=np.int32)
        block[2] = np.concatenate([block[2], nodes])
        block[3] = np.concatenate([block[3], np.full(len(nodes), -1, dtype=np.int32)])
        return i, rows


def _joined(parts, more):
    found = {}
    for block, rows in (*parts, *more):
        found[block] = np.union1d(found[block], rows).astype(np.int32) if block in found else rows
    return tuple(sorted(found.items()))


def _geometry(section):
    if section.geometry is None:
        return np.full(len(section.nodes), -1, dtype=np.int32)
    return np.where(np.abs(section.geometry) > _MOST, -1, section.geometry).astype(np.int32)


def _inverted(nodes, kind, indices):
    """How many elements are inside out by their corners; those without volume are half of one."""
    at = kinds.places(kind, indices.shape[1])[:kinds.CORNERS[kind]]
    centre = nodes[indices[:, :len(at)]].mean(axis=1)
    volume = np.zeros(len(indices))
    for face in kinds.FACES[kind]:
        corners = [nodes[indices[:, k]] - centre for k in face]
        for second, third in zip(corners[1:], corners[2:]):
            volume += np.einsum("ij,ij->i", corners[0], np.cross(second, third))
    return np.count_nonzero(volume < 0)


def _off_middle(nodes, kind, indices):
    """How many elements of order 2 have a middle node that is farther from the middle of its edge than the ends are."""
    off = np.zeros(len(indices), dtype=bool)
    for i, (a, b) in enumerate(kinds.EDGES[kind]):
        start, end, between = (nodes[indices[:, k]] for k in (a, b, kinds.CORNERS[kind] + i))
        reach = ((end - start) ** 2).sum(axis=1)
        off |= ((2 * between - start - end) ** 2).sum(axis=1) > reach
    return np.count_nonzero(off)


def _odd_nodes(nodes, blocks):
    """Sentences about nodes that no element has and about those at the same place."""
    used = np.zeros(len(nodes), dtype=bool)
    for block in blocks:
        used[block.nodes] = True
    found = []
    unused = int(len(nodes) - used.sum())
    if unused:
        found.append(f"{_counted(unused, 'node')} that no element has")
    order = np.lexsort(nodes.T)
    again = int((nodes[order[1:]] == nodes[order[:-1]]).all(axis=1).sum())
    if again:
        found.append(f"{_counted(again, 'node')} at the place of another one: parts may not be joined there")
    return found


def _counted(count, kind):
    plural = kinds.PLURALS.get(kind, f"{kind}s")
    return f"{count:,} {plural if count != 1 else kind}"
