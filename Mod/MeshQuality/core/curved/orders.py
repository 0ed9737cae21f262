# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved meshes of another order: the same polynomials, or those of a lower order through points of them."""

import numpy as np

from ...compat import extension
from ...errors import InvalidInput
from ..elements import kinds, lagrange, polynomials, skeleton

_HIGHEST = {"line": 5, "triangle": 5, "tetrahedron": 4}
_LISTS = {"tetrahedron": ("tetrahedra", "tetrahedron_solid"), "triangle": ("triangles", "triangle_face"),
          "line": ("edges", "edge_entity")}


def arrays_of_order(mesh, order):
    """(order, {name: array}) of a CurvedMesh at another order, as the core takes them. Raises InvalidInput for an order
    that its elements do not have.
    """
    volume = len(mesh.tetrahedra) > 0
    most = _HIGHEST["tetrahedron" if volume else "triangle"]
    if isinstance(order, bool) or not isinstance(order, (int, np.integer)) or not 1 <= order <= most:
        raise InvalidInput(f"order = {order!r} is not possible: {'volumes' if volume else 'surfaces'} have orders 1 to "
                           f"{most}")
    order = int(order)
    elements = {kind: np.asarray(getattr(mesh, name)) for kind, (name, _) in _LISTS.items() if len(getattr(mesh, name))}
    made = _Nodes(mesh, elements, order)
    arrays = {"nodes": made.points, "node_entity": made.entities, "triangle_face_behind": mesh.triangle_face_behind}
    for kind, (name, entity) in _LISTS.items():
        arrays[name] = made.elements.get(kind, np.zeros((0, kinds.count_of(kind, order)), dtype=np.int32))
        arrays[entity] = getattr(mesh, entity)
    arrays["triangle_quality"], arrays["tetrahedron_quality"] = _qualities(mesh, arrays, order)
    return order, {name: np.ascontiguousarray(array) for name, array in arrays.items()}


class _Nodes:
    """The corners stay as they are; then come the nodes inside of edges, of faces and of tetrahedra, each once."""

    def __init__(self, mesh, elements, order):
        self._old, self._order = mesh.order, order
        corners = int(max(nodes[:, :kinds.CORNERS[kind]].max() for kind, nodes in elements.items())) + 1
        self._points, self._entities = [mesh.nodes[:corners]], [mesh.node_entity[:corners]]
        self._count = corners
        self.elements = {kind: np.zeros((len(nodes), kinds.count_of(kind, order)), dtype=np.int32)
                         for kind, nodes in elements.items()}
        for kind, nodes in elements.items():
            self.elements[kind][:, :kinds.CORNERS[kind]] = nodes[:, :kinds.CORNERS[kind]]
        for flat, sides in (("line", skeleton.edges_of(elements, self._old)),
                            ("triangle", skeleton.faces_of(elements, self._old))):
            entity = np.zeros((len(sides.corners), 2), dtype=np.int32)
            for dimension, kind in ((3, "tetrahedron"), (2, "triangle"), (1, "line")):  # the lowest says where it is
                if kind in sides.of:
                    owner = np.repeat(getattr(mesh, _LISTS[kind][1]), sides.of[kind].shape[1])
                    entity[sides.of[kind].ravel()] = np.column_stack([np.full(len(owner), dimension), owner])
            numbers = self._add(flat, mesh.nodes[sides.nodes], entity)
            for kind in sides.of:
                skeleton.fill(sides, kind, order, flat, self.elements[kind], numbers)
        if "tetrahedron" in elements:
            solid = np.column_stack([np.full(len(mesh.tetrahedron_solid), 3), mesh.tetrahedron_solid])
            numbers = self._add("tetrahedron", mesh.nodes[elements["tetrahedron"]], solid)
            if numbers.shape[1]:
                self.elements["tetrahedron"][:, -numbers.shape[1]:] = numbers
        self.points = np.concatenate(self._points)
        self.entities = np.concatenate(self._entities).astype(np.int32)

    def _add(self, kind, nodes, entity):
        """Numbers (n, inner nodes) of new nodes inside of n parts of elements with these nodes."""
        inner = _inner(kind, self._order)
        found = np.einsum("ij,njk->nik", polynomials.between(kind, self._old, self._order)[inner], nodes)
        numbers = self._count + np.arange(found.shape[0] * found.shape[1]).reshape(found.shape[:2])
        self._points.append(found.reshape(-1, 3))
        self._entities.append(np.repeat(entity, found.shape[1], axis=0))
        self._count += numbers.size
        return numbers


def _inner(kind, order):
    """The nodes of an element that lie on none of its sides."""
    at = lagrange.shares(kind, kinds.places(kind, kinds.count_of(kind, order)))
    return np.flatnonzero((at > 1e-9).all(axis=1))


def _qualities(mesh, arrays, order):
    """Bounds of J of the elements as they are now; those of an order that is raised have the same polynomials."""
    if order >= mesh.order:
        return mesh.triangle_quality, mesh.tetrahedron_quality
    found = []
    for kind, name in (("triangle", "triangles"), ("tetrahedron", "tetrahedra")):
        low = np.zeros(0)
        if len(arrays[name]):
            low, _, _ = extension().check_elements(kind, order, arrays["nodes"], arrays[name], None)
        found.append(low)
    return found
