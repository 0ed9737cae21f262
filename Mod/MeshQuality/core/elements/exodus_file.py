# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exodus II files: blocks, and side sets as faces. Those that are HDF5 need h5py."""

import re

import numpy as np

from ...errors import IoError
from . import kinds, netcdf_classic
from .parts import Parts, Section, content, unsupported, words_of

_WANTED = ("connect", "coord", "eb_", "ss_", "elem_ss", "side_ss")

# Faces of kinds.FACES, in the order of Exodus' sides.
SIDES = {"tetrahedron": (1, 3, 2, 0), "hexahedron": (1, 3, 4, 2, 0, 5), "prism": (2, 4, 3, 0, 1), "pyramid": (0, 2, 3, 1, 4)}
_KINDS = {"TET": "tetrahedron", "PYR": "pyramid", "WED": "prism", "HEX": "hexahedron", "TRI": "triangle", "QUA": "quadrilateral",
          "SHE": "quadrilateral", "BAR": "line", "BEA": "line", "TRU": "line", "EDG": "line"}


def read(path):
    """The Parts of a file."""
    data = content(path)
    return _parts(_variables_of_hdf5(path) if data.startswith(b"\x89HDF") else netcdf_classic.variables(data))


def _variables_of_hdf5(path):
    try:
        import h5py
    except ImportError as error:
        raise IoError("Exodus files that are HDF5 need h5py, which is not there: install it (Debian: python3-h5py)") from error
    with h5py.File(path, "r") as file:
        wanted = [name for name in file if name.startswith(_WANTED) and isinstance(file[name], h5py.Dataset)]
        return {name: (file[name][()], {"elem_type": _bytes(file[name].attrs.get("elem_type", b""))}) for name in wanted}


def _bytes(text):
    return text.encode() if isinstance(text, str) else bytes(text)


def _parts(data):
    blocks = _numbered(data, "connect")
    if not blocks:
        raise IoError("it is a netCDF file without a mesh: it has no connect1")
    parts, last = Parts(_points(data), [], side_order=SIDES), 0
    names = _names(data, "eb", blocks[-1], "block")
    for i in blocks:
        nodes, attributes = data[f"connect{i}"]
        nodes = nodes.astype(np.int64)
        kind = _kind(words_of(attributes.get("elem_type", b"")).upper(), nodes.shape[1])
        numbers = np.arange(last + 1, last + 1 + len(nodes))
        last += len(nodes)
        if kind is not None:
            order = kinds.from_convention(kind, nodes.shape[1], kinds.EXODUS)
            parts.sections.append(Section(kind, nodes[:, order] - 1, numbers))
            parts.add_to_group(names[i - 1], numbers)
    _side_sets(data, parts)
    return parts


def _numbered(data, prefix):
    """The numbers behind a prefix of variables, which go up to a few thousand."""
    return sorted(int(name[len(prefix):]) for name in data if re.fullmatch(prefix + r"[1-9]\d{0,5}", name))


def _points(data):
    if "coord" in data:
        return data["coord"][0].T
    return np.stack([data[axis][0] for axis in ("coordx", "coordy", "coordz") if axis in data], axis=1)


def _names(data, prefix, count, default):
    numbers = data[f"{prefix}_prop1"][0].tolist() if f"{prefix}_prop1" in data else []
    given = data[f"{prefix}_names"][0] if f"{prefix}_names" in data else []
    given = [words_of(row.tobytes().split(b"\0")[0]) for row in given]
    given += [""] * (count - len(given))
    numbers += list(range(len(numbers) + 1, count + 1))
    return [name or f"{default} {number}" for name, number in zip(given, numbers)]


def _kind(name, count):
    """The kind of a block's elements; None for points."""
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
    sets = _numbered(data, "elem_ss")
    names = _names(data, "ss", sets[-1] if sets else 0, "side set")
    flat = np.concatenate([np.zeros(0, dtype=np.int64), *(section.numbers for section in parts.sections
                                                          if kinds.DIMENSION[section.kind] < 3)])
    for i in sets:
        if f"side_ss{i}" not in data:
            continue
        name = names[i - 1]
        numbers, sides = (data[f"{what}_ss{i}"][0].astype(np.int64) for what in ("elem", "side"))
        of_flat = np.isin(numbers, flat)
        parts.add_to_group(name, numbers[of_flat & (sides <= 2)])  # of shells: either side of theirs
        parts.sides.append((name, numbers[~of_flat], sides[~of_flat]))
