# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volume meshes of higher order: layers follow the CAD by the core's curving of given meshes with prisms."""

from typing import NamedTuple

import numpy as np

from ... import options
from ...compat import extension
from ...errors import GeometryError, InvalidInput, TopologyError
from ..curved import simplex_arrays
from ..elements import kinds
from ..elements.assembly import Content
from ..formats.completion import blended
from .layers import proven_bounds


class Curved(NamedTuple):
    """What came of curving.

    content       the Content of the mesh, blocks and groups as before
    volume        mm^3, of the curved elements
    deviation     mm, largest distance of the curved surface from the shape
    straightened  names of elements that had to bend less than the shape, or not at all, to be valid
    """

    content: Content
    volume: float
    deviation: float
    straightened: tuple


def curved(mesh, shape, order, progress):
    """The Curved of a VolumeMesh with straight sides; shape is the Part.Shape of its region.

    Raises GeometryError where the surface is not found on the shape; Cancelled.
    """
    curving = extension().CurveOptions()
    options.hand_over({"order": order, "volume": True, "straighten_invalid": True}, curving)
    try:
        found = extension().curve_mixed(*simplex_arrays.blocks_of(mesh, 1), shape, curving, False, progress)
    except (GeometryError, InvalidInput, TopologyError) as error:
        raise GeometryError(f"elements of order {order} need every edge of the part to be followed by the mesh: {error}; "
                            "give order=1, or repair the part") from error
    of_kind = {kind: nodes.reshape(len(entity), -1) for kind, nodes, entity, _, _ in found["blocks"]}
    blocks = tuple(block._replace(order=order, nodes=_rows_of(block, of_kind[block.kind])) for block in mesh.blocks)
    nodes, report = found["nodes"].reshape(-1, 3), found["report"]
    content = Content(_without_middles(nodes, blocks) if order == 2 else nodes, blocks, mesh.group_members, ())
    return Curved(content, report.volume, report.max_deviation, _named(mesh, report.straightened))


def _without_middles(nodes, blocks):
    """float64 (N, 3): nodes for which programs without nodes amid quadrilaterals have the same elements; those given where not all elements
    would be valid so.
    """
    solids = [block for block in blocks if kinds.DIMENSION[block.kind] == 3]
    found = blended(nodes, [(block.kind, block.nodes) for block in solids])
    return found if all((proven_bounds(found, block.kind, block.nodes, 2) > 0.0).all() for block in solids) else nodes


def _rows_of(block, curved_rows):
    """int32 (E, nodes): the curved elements in the order of the straight ones. The core keeps the order of solids; faces of the boundary
    are found by their corners.
    """
    if kinds.DIMENSION[block.kind] == 3:
        return curved_rows
    corners = kinds.CORNERS[block.kind]
    ours, theirs = (np.lexsort(np.sort(rows[:, :corners], axis=1).T) for rows in (block.nodes, curved_rows))
    found = np.empty_like(curved_rows)
    found[ours] = curved_rows[theirs]
    return found


def _named(mesh, names):
    """The core's names of elements, such as "prism 3 of Solid1", with their places."""
    corners_of, found = dict(mesh.solid_blocks), []
    for name in names:
        kind, number = name.split()[:2]
        x, y, z = mesh.nodes[corners_of[kind][int(number)]].mean(axis=0)
        found.append(f"{kind} {number} at ({x:.4g}, {y:.4g}, {z:.4g}) mm")
    return tuple(found)
