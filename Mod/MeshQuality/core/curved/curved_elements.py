# SPDX-License-Identifier: LGPL-2.1-or-later
"""CurvedElementMesh: curved elements of several kinds, as boundary layers have them."""

import numpy as np

from ...errors import InvalidInput
from ..elements import conformity, kinds
from ..elements.assembly import Content, ElementBlock
from ..elements.entity_groups import entity_groups
from ..meshes.element_mesh import ElementMesh
from . import mixed_orders


class CurvedElementMesh(ElementMesh):
    """Curved elements of any kinds and orders with their link to the CAD and a report.

    An ElementMesh: nodes, blocks, groups and boundary() are as there; group_members has the elements of each CAD entity by
    FreeCAD's name: Solid1, Face1, Edge1. Volumes come first, then what lies on the CAD faces, then on the CAD edges.

    report       CurveReport; None of a mesh that with_orders made
    quality      tuple of float64 (E,) by block, lower bounds of min J / max |J|; not positive: not proven valid; 1 of lines
    given_node   int32 (corners,), of a mesh that another program made (curve(..., mesh=)): its node at each corner
    moved_nodes  int32, its nodes that are not where they were
    """

    __slots__ = ("_given_node", "_moved_nodes", "_quality", "_report")

    def __init__(self, content, quality, report=None, given=(None, None)):
        super().__init__(content)
        self._quality, self._report = tuple(quality), report
        self._given_node, self._moved_nodes = (np.zeros(0, dtype=np.int32) if part is None else part for part in given)
        for array in (*self._quality, self._given_node, self._moved_nodes):
            array.flags.writeable = False

    report = property(lambda self: self._report, doc="CurveReport, or None")
    quality = property(lambda self: self._quality, doc="tuple of float64 (E,) by block")
    given_node = property(lambda self: self._given_node, doc="int32 (corners,)")
    moved_nodes = property(lambda self: self._moved_nodes, doc="int32")

    @property
    def order(self):
        """The highest order of the elements."""
        return max(block.order for block in self.blocks)

    @property
    def surface_triangles(self):
        """int32 (T, 3): the corners of triangles on the CAD faces; quadrilaterals count as two triangles."""
        flat = [(block.kind, block.nodes) for block in self.blocks if kinds.DIMENSION[block.kind] == 2]
        parts = [nodes[:, :3] for _, nodes in flat]
        parts += [nodes[:, [0, 2, 3]] for kind, nodes in flat if kind == "quadrilateral"]
        return np.concatenate([np.zeros((0, 3), dtype=np.int32), *parts])

    @property
    def conforming(self):
        """Whether the elements fit together, corner by corner and node by node."""
        return conformity.of_blocks(self.blocks, self.nodes)[0]

    def with_orders(self, orders, raise_invalid=False):
        """The same elements, each with an order of its own, as p-adaptive solvers take them: a new CurvedElementMesh.

        orders         whole numbers from 1 to the order of this mesh, one for each element of the highest dimension, block by
                       block; or a tuple of such arrays, one a block
        raise_invalid  raise the orders around elements that would not be proven valid: thin layers on walls of order 1
        Edges and faces have the lowest order of their elements, and elements beside fit: their nodes there lie on the same
        polynomial. quality is measured anew; report is None. Raises InvalidInput where this mesh has several orders.
        """
        if len({block.order for block in self.blocks}) > 1:
            raise InvalidInput("the mesh has elements of several orders already: take the orders from the mesh of one order")
        return with_orders(self, self.order, orders, raise_invalid)

    def __repr__(self):
        folded = sum(int((~(quality > 0.0)).sum()) for quality in self._quality)
        valid = f"{folded:,} not proven valid" if folded else "all valid"
        return f"{super().__repr__()[:-1]}, {valid}>"


def with_orders(mesh, order, orders, raise_invalid):
    """The CurvedElementMesh of an ElementMesh of one order; see CurvedElementMesh.with_orders."""
    return CurvedElementMesh(*mixed_orders.with_orders(mesh, order, orders, raise_invalid))


def of_core(found, order, given):
    """The CurvedElementMesh of what the core's curve_mixed gives, with the groups of the ElementMesh that was given."""
    blocks, quality, rows = [], [], []
    parts = [*found["blocks"], ("line", found["edges"], found["edge_entity"], np.ones(len(found["edge_entity"])), None)]
    for kind, nodes, entity, bounds, of_given in parts:
        if not len(entity):
            continue
        blocks.append(_block(kind, order, nodes.reshape(len(entity), -1), entity))
        quality.append(bounds)
        rows.append(of_given)
    members = {**carried_groups(given, blocks, rows), **entity_groups(blocks)}
    content = Content(found["nodes"].reshape(-1, 3), tuple(blocks), members, ())
    return CurvedElementMesh(content, quality, found["report"], (found["given_node"], found["moved_nodes"]))


def _block(kind, order, nodes, entity):
    return ElementBlock(kind, order, np.ascontiguousarray(nodes, dtype=np.int32), np.full(len(nodes), -1, dtype=np.int32),
                        np.array(entity, dtype=np.int32))


def carried_groups(given, blocks, rows):
    """Groups of the solid elements, or of the surface where there are none, of the mesh that was given.

    rows  by block: which given element each is, counted through the given blocks of the highest dimension
    """
    starts, count = {}, 0
    for number, block in enumerate(given.blocks):
        if kinds.DIMENSION[block.kind] == given.dimension:
            starts[number] = count
            count += len(block.nodes)
    members = {}
    for name, parts in given.group_members.items():
        chosen = np.zeros(count, dtype=bool)
        for number, of_group in parts:
            if number in starts:
                chosen[starts[number] + of_group] = True
        found = tuple((number, np.flatnonzero(chosen[of_given]).astype(np.int32)) for number, of_given in enumerate(rows)
                      if of_given is not None and (of_given >= 0).all() and chosen[of_given].any())
        if found:
            members[name] = found
    return members
