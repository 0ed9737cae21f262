# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinds of elements: where the nodes of each lie in Gmsh's order, its faces, and the orders that files have instead.

All orders are found by place: a node of a file's order is the node of Gmsh's order at the same point of the element.
"""

import functools
from dataclasses import dataclass

import numpy as np

from ...errors import InvalidInput

HIGHEST_ORDER = 5
# Corners of the reference elements; edges and faces as Gmsh orders the nodes on them. All faces look outward.
_CORNERS = {
    "line": ((0, 0, 0), (1, 0, 0)),
    "triangle": ((0, 0, 0), (1, 0, 0), (0, 1, 0)),
    "quadrilateral": ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)),
    "tetrahedron": ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "pyramid": ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)),
    "prism": ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)),
    "hexahedron": ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)),
}
EDGES = {
    "line": ((0, 1),),
    "triangle": ((0, 1), (1, 2), (2, 0)),
    "quadrilateral": ((0, 1), (1, 2), (2, 3), (3, 0)),
    "tetrahedron": ((0, 1), (1, 2), (2, 0), (3, 0), (3, 2), (3, 1)),
    "pyramid": ((0, 1), (0, 3), (0, 4), (1, 2), (1, 4), (2, 3), (2, 4), (3, 4)),
    "prism": ((0, 1), (0, 2), (0, 3), (1, 2), (1, 4), (2, 5), (3, 4), (3, 5), (4, 5)),
    "hexahedron": ((0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7)),
}
FACES = {
    "line": (), "triangle": ((0, 1, 2),), "quadrilateral": ((0, 1, 2, 3),),
    "tetrahedron": ((0, 2, 1), (0, 1, 3), (0, 3, 2), (3, 1, 2)),
    "pyramid": ((0, 1, 4), (3, 0, 4), (1, 2, 4), (2, 3, 4), (0, 3, 2, 1)),
    "prism": ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (0, 3, 5, 2), (1, 2, 5, 4)),
    "hexahedron": ((0, 3, 2, 1), (0, 1, 5, 4), (0, 4, 7, 3), (1, 2, 6, 5), (2, 3, 7, 6), (4, 5, 6, 7)),
}
DIMENSION = {"line": 1, "triangle": 2, "quadrilateral": 2, "tetrahedron": 3, "pyramid": 3, "prism": 3, "hexahedron": 3}
CORNERS = {kind: len(corners) for kind, corners in _CORNERS.items()}
PLURALS = {"line": "lines", "triangle": "triangles", "quadrilateral": "quadrilaterals", "tetrahedron": "tetrahedra",
           "pyramid": "pyramids", "prism": "prisms", "hexahedron": "hexahedra"}
_FLAT = {3: "triangle", 4: "quadrilateral"}
# Elements of orders 1 and 2 that most programs have, by number of nodes.
FLAT_OF = {3: "triangle", 6: "triangle", 4: "quadrilateral", 8: "quadrilateral"}
SOLID_OF = {4: "tetrahedron", 10: "tetrahedron", 5: "pyramid", 13: "pyramid", 6: "prism", 15: "prism", 8: "hexahedron",
            20: "hexahedron"}
_SHRINKS = {"line": 2, "triangle": 3, "quadrilateral": 2, "tetrahedron": 4, "pyramid": 3, "hexahedron": 2}
_SERENDIPITY = {"quadrilateral": 8, "pyramid": 13, "prism": 15, "hexahedron": 20}
_RING3, _RING4 = ((0, 1), (1, 2), (2, 0)), ((0, 1), (1, 2), (2, 3), (3, 0))
_TOP3, _TOP4 = ((3, 4), (4, 5), (5, 3)), ((4, 5), (5, 6), (6, 7), (7, 4))
_UP3, _UP4 = ((0, 3), (1, 4), (2, 5)), ((0, 4), (1, 5), (2, 6), (3, 7))
_BASES = {"tetrahedron": (*_RING3, (0, 3), (1, 3), (2, 3)), "pyramid": (*_RING4, (0, 4), (1, 4), (2, 4), (3, 4))}
_BASE4 = {"pyramid": ((0, 1, 2, 3),)}
_SIDES3 = ((0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5))


@dataclass(frozen=True, eq=False)
class Convention:
    """How a format orders nodes of order 2: the edges with their middle nodes, then the faces with theirs."""

    edges: dict
    faces: dict


# VTK, Abaqus, MED and SMESH: the edges below, above, then those between.
RINGS = Convention(
    {**_BASES, "prism": (*_RING3, *_TOP3, *_UP3), "hexahedron": (*_RING4, *_TOP4, *_UP4)},
    {**_BASE4, "prism": _SIDES3,
     "hexahedron": ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 2, 6, 7), (0, 1, 2, 3), (4, 5, 6, 7))})
_BY_LEVEL = {**_BASES, "prism": (*_RING3, *_UP3, *_TOP3), "hexahedron": (*_RING4, *_UP4, *_TOP4)}
# CGNS and Nastran: the edges below, between, above.
LEVELS = Convention(
    _BY_LEVEL,
    {**_BASE4, "prism": _SIDES3,
     "hexahedron": ((0, 1, 2, 3), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 3, 7, 4), (4, 5, 6, 7))})
# Exodus: likewise, but the middle of a hexahedron comes before those of its faces.
EXODUS = Convention(
    _BY_LEVEL,
    {**_BASE4, "prism": _SIDES3,
     "hexahedron": (tuple(range(8)), (0, 1, 2, 3), (4, 5, 6, 7), (0, 3, 7, 4), (1, 2, 6, 5), (0, 1, 5, 4), (3, 2, 6, 7))})


def count_of(kind, order, serendipity=False):
    """Nodes of an element."""
    n = order + 1
    if serendipity:
        return _SERENDIPITY[kind]
    return {"line": n, "triangle": n * (n + 1) // 2, "quadrilateral": n * n, "tetrahedron": n * (n + 1) * (n + 2) // 6,
            "pyramid": n * (n + 1) * (2 * n + 1) // 6, "prism": n * n * (n + 1) // 2, "hexahedron": n**3}[kind]


def serendipity_count(kind, count):
    """Nodes of an element of order 1 or 2 without those in the middle of faces and of volumes: in Gmsh's order the first ones."""
    return min(count, _SERENDIPITY.get(kind, count))


def order_of(kind, count):
    """The order of elements of a kind by their number of nodes; None where there is no such element."""
    if _SERENDIPITY.get(kind) == count:
        return 2
    return next((order for order in range(1, HIGHEST_ORDER + 1) if count_of(kind, order) == count), None)


@functools.lru_cache(maxsize=None)
def places(kind, count):
    """float64 (count, 3): where the nodes lie in the reference element, in Gmsh's order."""
    corners = np.array(_CORNERS[kind], dtype=float)
    order = order_of(kind, count)
    found = _fill(kind, corners, order, (EDGES[kind], FACES[kind]))
    if _SERENDIPITY.get(kind) == count:
        found = found[:count]
    found.flags.writeable = False
    return found


def _fill(kind, corners, order, sides):
    """The nodes of an element with these corners: corners, edges, faces, then what is inside as a smaller element;
    sides are its edges and faces.
    """
    if order == 0:
        return corners.mean(axis=0)[None] if kind != "pyramid" else corners[-1:]
    parts = [corners]
    for edge in sides[0] if order > 1 else ():
        a, b = corners[list(edge)]
        parts.append(a + (b - a) * np.arange(1, order)[:, None] / order)
    for face in sides[1] if DIMENSION[kind] == 3 and order > 1 else ():
        flat = _FLAT[len(face)]
        parts.append(_inside(flat, corners[list(face)], order, (EDGES[flat], ())))
    if DIMENSION[kind] > 1:
        parts.append(_inside(kind, corners, order, sides))
    return np.concatenate(parts)


def _inside(kind, corners, order, sides):
    """The nodes inside of an element, edges and faces apart."""
    if kind == "prism":
        flat = _inside("triangle", corners[:3], order, (EDGES["triangle"], ()))
        up = corners[3] - corners[0]
        levels = [*{1, order - 1}, *range(2, order - 1)] if order > 1 else []  # inner nodes of a line: its ends first
        return np.concatenate([point + np.outer(levels, up) / order for point in flat] or [flat])
    left = order - _SHRINKS[kind]
    if left < 0:
        return corners[:0]
    middle = _SHRINKS[kind] / order
    centre = corners.mean(axis=0) if kind != "pyramid" else (corners[:4].mean(axis=0) * 2 + corners[4]) / 3
    return _fill(kind, corners + (centre - corners) * middle, left, sides)


def matching(kind, count, wanted):
    """int (len(wanted),): the nodes of an element at these places of the reference element."""
    distance = np.abs(places(kind, count)[None] - np.asarray(wanted)[:, None]).max(axis=2)
    found = distance.argmin(axis=1)
    if distance[np.arange(len(found)), found].max(initial=0.0) > 1e-9:
        raise InvalidInput(f"{PLURALS[kind]} with {count} nodes have no nodes at these places")
    return found


@functools.lru_cache(maxsize=None)
def faces_of(kind, count):
    """[(kind of the face, its nodes within the element in Gmsh's order, outward), ...]."""
    order, full = order_of(kind, count), _SERENDIPITY.get(kind) != count
    found = []
    for face in FACES[kind]:
        flat = _FLAT[len(face)]
        if DIMENSION[kind] == 2:
            found.append((kind, np.arange(count)))
            continue
        number = count_of(flat, order, serendipity=not full and flat == "quadrilateral")
        corners = places(kind, count)[list(face)]
        found.append((flat, matching(kind, count, _mapped(flat, corners, places(flat, number)))))
    return found


def _mapped(kind, corners, at):
    u, v = at[:, :1], at[:, 1:2]
    if kind == "triangle":
        return corners[0] * (1 - u - v) + corners[1] * u + corners[2] * v
    return (corners[0] * (1 - u) + corners[1] * u) * (1 - v) + (corners[3] * (1 - u) + corners[2] * u) * v


@functools.lru_cache(maxsize=None)
def turned(kind, count):
    """The order by which the nodes of an element make the mirrored one."""
    swapped = (1, 0, 2) if kind != "line" else (0, 1, 2)
    return matching(kind, count, places(kind, count)[:, swapped])


@functools.lru_cache(maxsize=None)
def from_convention(kind, count, convention):
    """The indices that bring nodes in the order of a Convention into Gmsh's: nodes[:, order]; of order 1 and 2."""
    corners = np.array(_CORNERS[kind], dtype=float)
    edges, faces = convention.edges.get(kind, EDGES[kind]), convention.faces.get(kind, ())
    wanted = [*corners, *(corners[list(part)].mean(axis=0) for part in (*edges, *faces)), corners.mean(axis=0)]
    return np.argsort(matching(kind, count, wanted[:count]))


@functools.lru_cache(maxsize=None)
def from_mirrored(kind, count):
    """As from_convention, for MED and SMESH, whose volumes are the other way round than Gmsh's."""
    order = from_convention(kind, count, RINGS)
    return order[turned(kind, count)] if DIMENSION[kind] == 3 else order


# CGNS' edges and faces of tetrahedra of orders 3 and 4, as Gmsh has them.
_CGNS_TETRAHEDRON = (_BASES["tetrahedron"], ((0, 1, 2), (0, 1, 3), (1, 2, 3), (2, 0, 3)))


@functools.lru_cache(maxsize=None)
def from_cgns(kind, count):
    """As from_convention, for CGNS: triangles and tetrahedra up to order 4, other elements up to order 2."""
    if order_of(kind, count) <= 2:
        return from_convention(kind, count, LEVELS)
    sides = _CGNS_TETRAHEDRON if kind == "tetrahedron" else (EDGES[kind], FACES[kind])
    wanted = _fill(kind, np.array(_CORNERS[kind], dtype=float), order_of(kind, count), sides)
    return np.argsort(matching(kind, count, wanted))


# VTK's edges and faces of tetrahedra of any order.
_LAGRANGE_TETRAHEDRON = (_BASES["tetrahedron"], ((0, 1, 3), (2, 3, 1), (0, 3, 2), (0, 2, 1)))


# VTK's edges and quadrilateral faces of hexahedra and prisms of any order, with the nodes in the directions of VTK.
_LAGRANGE_EDGES = {
    "hexahedron": ((0, 1), (1, 2), (3, 2), (0, 3), (4, 5), (5, 6), (7, 6), (4, 7), (0, 4), (1, 5), (2, 6), (3, 7)),
    "prism": ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5))}
_LAGRANGE_QUADRILATERALS = {
    "hexahedron": ((0, 3, 7, 4), (1, 2, 6, 5), (0, 1, 5, 4), (3, 2, 6, 7), (0, 1, 2, 3), (4, 5, 6, 7)),
    "prism": ((0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5))}


def _lagrange_places(kind, order):
    """Where VTK has the nodes of a hexahedron or a prism, the inner ones of quadrilaterals row by row."""
    corners, inner = np.array(_CORNERS[kind], dtype=float), np.arange(1, order) / order
    wanted = [corners, *(corners[a] + (corners[b] - corners[a]) * inner[:, None] for a, b in _LAGRANGE_EDGES[kind])]
    v, u = (grid.ravel() for grid in np.meshgrid(inner, inner, indexing="ij"))
    flat = np.stack([u, v, 0 * u], axis=1)
    if kind == "prism":
        within = _inside("triangle", corners[:3], order, (EDGES["triangle"], ()))
        wanted += [within, within + corners[3]]
    wanted += [_mapped("quadrilateral", corners[list(face)], flat) for face in _LAGRANGE_QUADRILATERALS[kind]]
    levels = flat if kind == "hexahedron" else within
    return np.concatenate([*wanted, *(levels + np.array([0, 0, z]) for z in inner)])


@functools.lru_cache(maxsize=None)
def from_lagrange(kind, count):
    """Likewise for VTK's elements of any order: all but pyramids."""
    order, corners = order_of(kind, count), np.array(_CORNERS[kind], dtype=float)
    if kind == "tetrahedron":
        wanted = _fill(kind, corners, order, _LAGRANGE_TETRAHEDRON)
    elif kind == "quadrilateral":
        inner = np.arange(1, order) / order
        v, u = (grid.ravel() for grid in np.meshgrid(inner, inner, indexing="ij"))
        edges = [corners[a] + (corners[b] - corners[a]) * inner[:, None] for a, b in ((0, 1), (1, 2), (3, 2), (0, 3))]
        wanted = np.concatenate([corners, *edges, np.stack([u, v, 0 * u], axis=1)])
    elif kind in _LAGRANGE_EDGES:
        wanted = _lagrange_places(kind, order)
    else:
        wanted = places(kind, count)
    return np.argsort(matching(kind, count, wanted))
