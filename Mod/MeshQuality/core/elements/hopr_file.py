# SPDX-License-Identifier: LGPL-2.1-or-later
"""HOPR's meshes (.h5) by h5py; boundary conditions as groups, zones as CAD entities."""

import numpy as np

from ...errors import IoError
from . import kinds
from .hopr_order import SIDE_FACES, of_gmsh
from .parts import REMEDY, Parts, Section, count_within, unsupported, words_of

_KINDS = {4: "tetrahedron", 5: "pyramid", 6: "prism", 8: "hexahedron"}  # by the last digit of the type


def read(path):
    """The Parts of a file."""
    try:
        import h5py
    except ImportError as error:
        raise IoError("files of HOPR need h5py, which is not there: install it (Debian: python3-h5py)") from error
    if not h5py.is_hdf5(path):
        raise IoError("it is no HDF5 file, which .h5 files are: write it anew")
    with h5py.File(path, "r") as file:
        missing = [name for name in ("ElemInfo", "SideInfo", "NodeCoords", "GlobalNodeIDs") if name not in file]
        if missing or "Ngeo" not in file.attrs:
            raise IoError(f"it has no {(missing or ['Ngeo'])[0]}: it is no mesh of HOPR")
        order = int(np.ravel(file.attrs["Ngeo"])[0])
        info, sides, points, numbers = (file[name][()] for name in ("ElemInfo", "SideInfo", "NodeCoords", "GlobalNodeIDs"))
        names = [words_of(bytes(name)) for name in file["BCNames"][()]] if "BCNames" in file else []
    if not 1 <= order <= kinds.HIGHEST_ORDER:
        raise unsupported(f"elements of order {order}")
    return _parts(order, (info, sides.astype(np.int64)), (points, numbers.astype(np.int64)), names)


def _parts(order, info_and_sides, nodes, names):
    (info, sides), (points, numbers) = info_and_sides, nodes
    if info.ndim != 2 or info.shape[1] != 6 or sides.ndim != 2 or sides.shape[1] < 5 or len(points) != len(numbers):
        raise IoError(f"its arrays have other sizes than HOPR's have: {REMEDY}")
    unique, first = np.unique(numbers, return_index=True)
    parts = Parts(points[first], [], unique, side_order=SIDE_FACES)
    info = info.astype(np.int64)
    for last in np.unique(np.abs(info[:, 0]) % 10).tolist():
        if last not in _KINDS:
            raise unsupported(f"elements of HOPR's type {int(info[np.abs(info[:, 0]) % 10 == last, 0][0])}")
        kind = _KINDS[last]
        which = np.flatnonzero(np.abs(info[:, 0]) % 10 == last)
        count = kinds.count_of(kind, order)
        begins, ends = info[which, 4], info[which, 5]
        if (ends - begins != count).any() or (begins < 0).any():
            raise IoError(f"it has {kinds.PLURALS[kind]} without the {count} nodes of order {order}: {REMEDY}")
        count_within(ends.max(), len(numbers), "nodes")
        listed = numbers[begins[:, None] + np.arange(count)]
        parts.sections.append(Section(kind, listed[:, np.argsort(of_gmsh(kind, order))], which + 1, info[which, 1] - 1))
    _conditions(parts, info, sides, names)
    return parts


def _conditions(parts, info, sides, names):
    """The sides with a boundary condition as groups."""
    per_element = info[:, 3] - info[:, 2]
    if (per_element < 0).any() or per_element.sum() != len(sides):
        raise IoError(f"its elements have other numbers of sides than it lists: {REMEDY}")
    if (sides[:, 2] < 0).any():
        raise unsupported("sides with several smaller ones on them (mortars)")
    element = np.repeat(np.arange(1, len(info) + 1), per_element)
    local = np.arange(len(sides)) - np.repeat(info[:, 2], per_element) + 1
    for number in np.unique(sides[sides[:, 4] > 0, 4]).tolist():
        name = names[number - 1] if number <= len(names) else ""
        which = sides[:, 4] == number
        parts.sides.append((name or f"condition {number}", element[which], local[which]))
