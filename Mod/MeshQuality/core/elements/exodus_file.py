# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exodus II files by netCDF: blocks, and side sets as faces."""

import numpy as np

from ...errors import IoError
from . import kinds
from .parts import Parts, Section, count_within, unsupported, words_of

# Faces of kinds.FACES, in the order of Exodus' sides.
SIDES = {"tetrahedron": (1, 3, 2, 0), "hexahedron": (1, 3, 4, 2, 0, 5), "prism": (2, 4, 3, 0, 1), "pyramid": (0, 2, 3, 1, 4)}
_KINDS = {"TET": "tetrahedron", "PYR": "pyramid", "WED": "prism", "HEX": "hexahedron", "TRI": "triangle", "QUA": "quadrilateral",
          "SHE": "quadrilateral", "BAR": "line", "BEA": "line", "TRU": "line", "EDG": "line"}


def read(path):
    """The Parts of a file."""
    try:
        import netCDF4
    except ImportError as error:
        raise IoError("Exodus files need netCDF for Python, which is not there: install it (Debian: python3-netcdf4)") \
            from error
    with netCDF4.Dataset(path) as data:
        data.set_auto_mask(False)
        return _parts(data)


def _parts(data):
    if "num_nodes" not in data.dimensions or "num_el_blk" not in data.dimensions:
        raise IoError("it is a netCDF file without a mesh: it has no num_nodes or num_el_blk")
    parts, last = Parts(_points(data), [], side_order=SIDES), 0
    blocks = len(data.dimensions["num_el_blk"])
    names = _names(data, "eb", count_within(blocks, len(data.variables), "blocks"), "block")
    for i in range(1, blocks + 1):
        if f"connect{i}" not in data.variables:
            continue
        connected = data.variables[f"connect{i}"]
        nodes, kind = np.asarray(connected[:], dtype=np.int64), _kind(connected)
        numbers = np.arange(last + 1, last + 1 + len(nodes))
        last += len(nodes)
        if kind is not None:
            order = kinds.from_convention(kind, nodes.shape[1], kinds.EXODUS)
            parts.sections.append(Section(kind, nodes[:, order] - 1, numbers))
            parts.add_to_group(names[i - 1], numbers)
    _side_sets(data, parts)
    return parts


def _points(data):
    if "coord" in data.variables:
        return np.asarray(data.variables["coord"][:]).T
    axes = [axis for axis in ("coordx", "coordy", "coordz") if axis in data.variables]
    return np.stack([np.asarray(data.variables[axis][:]) for axis in axes], axis=1)


def _names(data, prefix, count, default):
    numbers = np.asarray(data.variables[f"{prefix}_prop1"][:]).tolist() if f"{prefix}_prop1" in data.variables else []
    given = data.variables.get(f"{prefix}_names")
    given = [words_of(b"".join(row.tolist()).split(b"\0")[0]) for row in given[:]] if given is not None else []
    given += [""] * (count - len(given))
    numbers += list(range(len(numbers) + 1, count + 1))
    return [name or f"{default} {number}" for name, number in zip(given, numbers)]


def _kind(connected):
    """The kind of a block's elements; None for points."""
    name, count = str(connected.elem_type).upper(), connected.shape[1]
    kind = _KINDS.get(name[:3])
    if name[:3] == "SHE" and count in (3, 6):
        kind = "triangle"
    if name[:3] in ("SPH", "CIR", "POI"):
        return None
    order = kinds.order_of(kind, count) if kind else None
    if order not in (1, 2):
        raise unsupported(f"elements of type {name} with {count} nodes")
    return kind


def _side_sets(data, parts):
    count = len(data.dimensions["num_side_sets"]) if "num_side_sets" in data.dimensions else 0
    names = _names(data, "ss", count_within(count, len(data.variables), "side sets"), "side set")
    flat = np.concatenate([np.zeros(0, dtype=np.int64), *(section.numbers for section in parts.sections
                                                          if kinds.DIMENSION[section.kind] < 3)])
    for i, name in enumerate(names, 1):
        if f"elem_ss{i}" not in data.variables or f"side_ss{i}" not in data.variables:
            continue
        numbers, sides = (np.asarray(data.variables[f"{what}_ss{i}"][:]).astype(np.int64) for what in ("elem", "side"))
        of_flat = np.isin(numbers, flat)
        parts.add_to_group(name, numbers[of_flat & (sides <= 2)])  # of shells: either side of theirs
        parts.sides.append((name, numbers[~of_flat], sides[~of_flat]))
