# SPDX-License-Identifier: LGPL-2.1-or-later
"""HOPR's meshes (.h5) by h5py, as FLEXI and its relatives read them: each element has nodes and sides of its own. Read are
boundary conditions as groups and zones as CAD entities.

The format: https://github.com/hopr-framework/hopr, docs/Meshformat.
"""

import numpy as np

from ...errors import InvalidInput, IoError
from ..elements import kinds
from ..elements.parts import REMEDY, Parts, Section, count_within, hdf5, unsupported, words_of
from .completion import completed
from .hopr_order import SIDE_FACES, SIDES, of_gmsh
from .sides import alike, keys_of

_STRAIGHT = {"tetrahedron": 104, "pyramid": 115, "prism": 116, "hexahedron": 118}
_CURVED = {"tetrahedron": 204, "pyramid": 205, "prism": 206, "hexahedron": 208}
_COUNTED = (104, 204, 105, 115, 205, 106, 116, 206, 108, 118, 208)  # types in the order of ElemCounter
_OTHERS = "others"  # the boundary condition of sides in no group
_BC_TYPE = (2, 0, 0, 0)  # no condition yet: the parameters of a solver say it
_KINDS = {4: "tetrahedron", 5: "pyramid", 6: "prism", 8: "hexahedron"}  # the kind by the last digit of the type
_WHAT = "files of HOPR"
_NAME = 255
_BITS = 21  # bits of each coordinate on the curve by which elements are ordered
_MOST = 2**31 - 1


def write(path, points, volumes, boundary):
    """Writes volume elements of one order.

    points    float64 (N, 3), in the file's coordinates
    volumes   [(kind, int (E, nodes) in Gmsh's order, int (E,) zones from 1), ...]
    boundary  [(name, int (F, corners)), ...]: the corners of faces by boundary condition
    """
    order, zones = _order_of(volumes), np.concatenate([part[2] for part in volumes])
    points, volumes = completed(points, [(kind, nodes.astype(np.int64)) for kind, nodes, _ in volumes])
    elements = _Elements(points, volumes, zones, order)
    sides = _Sides(elements)
    names, conditions = sides.conditions(boundary)
    numbers = np.unique(elements.nodes, return_inverse=True)[1].ravel() + 1
    arrays = {"ElemInfo": elements.info(), "SideInfo": sides.info(conditions, order), "NodeCoords": points[elements.nodes],
              "GlobalNodeIDs": numbers.astype(np.int32), "BCType": np.tile(_BC_TYPE, (len(names), 1)).astype(np.int32),
              "BCNames": np.array([name.encode()[:_NAME].ljust(_NAME) for name in names], dtype=f"S{_NAME}"),
              "ElemBarycenters": elements.centres, "ElemWeight": np.ones(len(zones)),
              "ElemCounter": np.array([(number, (elements.types == number).sum()) for number in _COUNTED], dtype=np.int32)}
    counts = {"Ngeo": order, "nElems": len(zones), "nSides": len(sides.number), "nNodes": len(numbers),
              "nUniqueSides": np.abs(sides.number).max(), "nUniqueNodes": numbers.max(), "nBCs": len(names)}
    # In memory, as HDF5 ends the process where a disk is full.
    with hdf5(path, _WHAT, "w", driver="core", backing_store=False) as file:
        file.attrs["Version"] = np.array([1.0])
        for name, count in counts.items():
            file.attrs[name] = np.array([count], dtype=np.int32)
        for name, array in arrays.items():
            file[name] = array
        file.flush()
        image = file.id.get_file_image()
    with open(path, "wb") as stream:
        stream.write(image)


def _order_of(volumes):
    if not volumes:
        raise InvalidInput(".h5 files of HOPR hold volumes, of which the mesh has none: mesh with volume=True, or choose another "
                           "format")
    orders = sorted({kinds.order_of(kind, nodes.shape[1]) for kind, nodes, _ in volumes})
    if len(orders) > 1:
        raise InvalidInput(f".h5 files of HOPR hold elements of one order, not of {' and '.join(map(str, orders))}: choose "
                           ".msh or .vtu")
    if sum(nodes.size for _, nodes, _ in volumes) > _MOST:
        raise InvalidInput(f".h5 files of HOPR hold at most {_MOST:,} nodes of elements: write parts of the mesh")
    return orders[0]


class _Elements:
    """The elements along a curve that fills space, so that ranges of them are near each other.

    nodes    int64: those of one element after the other, as HOPR orders them
    corners  int64 (S, 4): those of all sides of one element after the other, -1 as the fourth one of triangles
    types, zones, centres, element (of each side), local (number of each side in its element)
    """

    def __init__(self, points, volumes, zones, order):
        names = [kind for kind, _ in volumes]
        kind = np.repeat(np.arange(len(volumes)), [len(nodes) for _, nodes in volumes])
        row = np.concatenate([np.arange(len(nodes)) for _, nodes in volumes])
        centres = np.concatenate([points[nodes[:, :kinds.CORNERS[name]]].mean(axis=1) for name, nodes in volumes])
        along = np.argsort(_along_curve(centres), kind="stable")
        kind, row, self.zones, self.centres = kind[along], row[along], zones[along], centres[along]
        self.types = np.array([(_STRAIGHT if order == 1 else _CURVED)[name] for name in names])[kind]
        self._node_ends = np.cumsum(np.array([nodes.shape[1] for _, nodes in volumes])[kind])
        self._side_ends = np.cumsum(np.array([len(SIDES[name]) for name in names])[kind])
        self.nodes = np.empty(self._node_ends[-1], dtype=np.int64)
        self.corners = np.full((self._side_ends[-1], 4), -1)
        self.element, self.local = (np.empty(len(self.corners), dtype=np.int64) for _ in range(2))
        for i, (name, nodes) in enumerate(volumes):
            which = np.flatnonzero(kind == i)
            listed = nodes[row[which]]
            at = self._node_ends[which] - nodes.shape[1]
            self.nodes[at[:, None] + np.arange(nodes.shape[1])] = listed[:, of_gmsh(name, order)]
            for side, corners in enumerate(SIDES[name]):
                at = self._side_ends[which] - len(SIDES[name]) + side
                self.corners[at, :len(corners)] = listed[:, corners]
                self.element[at], self.local[at] = which, side

    def info(self):
        """int32 (E, 6): type, zone, where sides and nodes begin and end."""
        ends = [array for ends in (self._side_ends, self._node_ends) for array in (np.concatenate([[0], ends[:-1]]), ends)]
        return np.column_stack([self.types, self.zones, *ends]).astype(np.int32)


class _Sides:
    """The sides of _Elements, and which are the same. The first one of two is the master: the other one has its number with
    a minus.
    """

    def __init__(self, elements):
        self._elements, self._keys = elements, keys_of(elements.corners)
        first, same, count = alike(self._keys)
        if (count > 2).any():
            x, y, z = elements.centres[elements.element[first[count.argmax()]]]
            raise InvalidInput(f".h5 files of HOPR hold meshes whose sides have two elements at most: one at ({x:.4g}, {y:.4g}, "
                               f"{z:.4g}) has {count.max()}; write the solids apart, or mend the mesh")
        index = np.arange(len(same))
        master = first[same] == index
        number = np.cumsum(master)
        self.number = np.where(master, number, -number[first[same]])
        last = np.empty(len(first), dtype=np.int64)
        last[same] = index  # the later of two equal sides stays
        self._other = np.where(master, last[same], first[same])
        self.outer = self._other == index

    def conditions(self, boundary):
        """(names, int (S,) the number of each side's condition, 0 of inner ones)."""
        names = [name for name, _ in boundary]
        _, same, count = alike(np.concatenate([self._keys, *(keys_of(corners) for _, corners in boundary)]))
        of_key, last = np.zeros(len(count), dtype=np.int64), len(same)
        for i, (_, corners) in reversed(list(enumerate(boundary, 1))):  # the first one of several counts
            of_key[same[last - len(corners):last]] = i
            last -= len(corners)
        found = np.where(self.outer, of_key[same[:len(self.number)]], 0)
        left = self.outer & (found == 0)
        if left.any():
            names.append(_OTHERS if _OTHERS not in names else f"{_OTHERS}_{len(names)}")
            found[left] = len(names)
        used = np.unique(found[found > 0])
        number = np.zeros(len(names) + 1, dtype=np.int64)
        number[used] = np.arange(1, len(used) + 1)
        return [names[i - 1] for i in used.tolist()], number[found]

    def info(self, conditions, order):
        """int32 (S, 5): type, number, neighbour, ten times its side and the flip, condition."""
        elements, other = self._elements, self._other
        triangle = elements.corners[:, 3] < 0
        kind = np.where(triangle, 3 if order == 1 else 23, 14 if order == 1 else 24)
        # The corner of the slave, from 1, that is the first one of the master.
        slave = self.number < 0
        flip = np.zeros(len(other), dtype=np.int64)
        flip[slave] = (elements.corners[slave] == elements.corners[other[slave], :1]).argmax(axis=1) + 1
        flip[other[slave]] = flip[slave]
        neighbour = np.where(self.outer, 0, elements.element[other] + 1)
        turned = np.where(self.outer, 0, 10 * (elements.local[other] + 1) + flip)
        return np.column_stack([kind, self.number, neighbour, turned, conditions]).astype(np.int32)


def _along_curve(points):
    """Where points are along Z-order, which HOPR takes, too."""
    low = points.min(axis=0)
    size = max(float((points.max(axis=0) - low).max()), 1e-300)
    steps = ((points - low) / size * (2**_BITS - 1)).astype(np.uint64)
    found = np.zeros(len(points), dtype=np.uint64)
    for bit in range(_BITS):
        for axis in range(3):
            found |= (steps[:, axis] >> np.uint64(bit) & np.uint64(1)) << np.uint64(3 * bit + 2 - axis)
    return found


def read(path):
    """The Parts of a file."""
    with hdf5(path, _WHAT) as file:
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
