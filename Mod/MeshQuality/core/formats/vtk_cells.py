# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cells of VTK as Sections."""

import numpy as np

from ...errors import IoError
from ..elements import kinds
from ..elements.parts import REMEDY, runs, unsupported

# The kind and the number of nodes by VTK's number; None: Lagrange cells, of any order.
CELLS = {3: ("line", 2), 5: ("triangle", 3), 9: ("quadrilateral", 4), 10: ("tetrahedron", 4), 12: ("hexahedron", 8),
          13: ("prism", 6), 14: ("pyramid", 5), 21: ("line", 3), 22: ("triangle", 6), 23: ("quadrilateral", 8),
          24: ("tetrahedron", 10), 25: ("hexahedron", 20), 26: ("prism", 15), 27: ("pyramid", 13), 28: ("quadrilateral", 9),
          29: ("hexahedron", 27), 32: ("prism", 18), 68: ("line", None), 69: ("triangle", None),
          70: ("quadrilateral", None), 71: ("tetrahedron", None)}
# Cells of files from version 2.2 on: older versions had other orders of nodes.
NEWER_CELLS = {**CELLS, 72: ("hexahedron", None), 73: ("prism", None)}
_POINTS = {0, 1, 2}
_NAMES = {4: "poly lines", 6: "triangle strips", 7: "polygons", 8: "pixels", 11: "voxels", 34: "triangles with 7 nodes",
          35: "cubic lines", 37: "pyramids with 19 nodes", 42: "polyhedra", 72: "hexahedra of VTK Lagrange",
          73: "prisms of VTK Lagrange", 74: "pyramids of VTK Lagrange"}
# Arrays of cells that hold numbers of groups, and their dimension: the CAD entities of our own files.
_GEOMETRY = {"cad_face": 2, "cad_solid": 3}
GROUP = "group"  # the array with the group of each cell in files of ElementMesh
TABLES = (*_GEOMETRY, "patch", GROUP, "CellEntityIds", "gmsh:geometrical")


def add(parts, connectivity, offsets, types, place, known=CELLS):
    """Adds Sections of cells; place is ({name of an array: its numbers}, number of the first node), known CELLS or NEWER_CELLS."""
    tables, first = place
    sizes = np.diff(np.concatenate([[0], offsets]))
    if len(offsets) != len(types) or (sizes < 0).any() or (len(offsets) and offsets[-1] > len(connectivity)):
        raise IoError(f"its cells have other numbers of nodes than it announces: {REMEDY}")
    for begin, end in runs(types.astype(np.int64) * 4096 + np.minimum(sizes, 4095)):
        number, count = int(types[begin]), int(sizes[begin])
        if number in _POINTS:
            continue
        kind = _kind(number, count, known)
        nodes = connectivity[offsets[begin] - count:offsets[end - 1]].reshape(-1, count)
        order = kinds.from_lagrange(kind, count) if known[number][1] is None else \
            kinds.from_convention(kind, count, kinds.RINGS)
        numbers = parts.add(kind, nodes[:, order] + first, _geometry(tables, kind, begin, end))
        for name in ("patch", GROUP):
            group = tables[name][begin:end] if len(tables.get(name, ())) >= end else np.zeros(0, dtype=np.int64)
            for i in np.unique(group[group >= 0]).tolist():
                parts.add_to_group(f"{name} {i}", numbers[group == i])


def _kind(number, count, known):
    kind, wanted = known.get(number, (None, None))
    if kind is None:
        raise unsupported(f"{_NAMES.get(number, f'cells of type {number}')} ({count} nodes)")
    if wanted not in (None, count):
        raise IoError(f"it has a {kind} with {count} nodes instead of {wanted}: {REMEDY}")
    if kinds.order_of(kind, count) is None:
        raise unsupported(f"{kinds.PLURALS[kind]} with {count} nodes")
    return kind


def _geometry(tables, kind, begin, end):
    for name, dimension in _GEOMETRY.items():
        if kinds.DIMENSION[kind] == dimension and len(tables.get(name, ())) >= end:
            return tables[name][begin:end]
    for name in ("CellEntityIds", "gmsh:geometrical"):
        if len(tables.get(name, ())) >= end:
            return np.maximum(tables[name][begin:end] - 1, -1)
    return None
