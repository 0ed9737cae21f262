# SPDX-License-Identifier: LGPL-2.1-or-later
"""flow_sizes: sizes by the second derivatives of a field of OpenFOAM."""

import os

import numpy as np

from ...errors import InvalidInput
from ...listing import Public
from ..formats.openfoam_decomposed import read_case
from .points import from_rows

CHANGE = 4.0  # largest factor of sizes from those of the cells, each way
_SHARE = 0.01  # of the range of the field: the error where none is given
_BATCH = 50_000  # cells whose neighbours are gathered at a time
_FEW = 20  # neighbours, of which a polynomial of second order is not sure
_RIDGE = 1e-6  # weight of derivatives about which no neighbour says anything, as across the one cell of a plane case


class FlowSizes(metaclass=Public):
    """Sizes by the second derivatives of a field of OpenFOAM; size_field= takes it.

    points    float64 (n, 3), mm: the centres of the cells
    sizes     float64 (n,), mm
    values    float64 (n, k), the field of k components
    gradients float64 (n, 3 k), for each mm: by component x, y, z
    hessians  float64 (n, 6 k), for each mm^2: by component xx, yy, zz, xy, yz, zx
    cells     float64 (n,), mm: the cube roots of the volumes of the cells
    error     the error of interpolation that the sizes are for, in units of the field
    time      the name of the folder from which the field was read
    """

    __slots__ = {"cells": "cube roots of the volumes, mm", "error": "in units of the field", "gradients": "float64 (n, 3 k), for each mm",
                 "hessians": "float64 (n, 6 k), for each mm^2", "points": "centres of the cells, mm", "sizes": "float64 (n,), mm",
                 "time": "the folder that has the field", "values": "float64 (n, k)"}

    def __init__(self, points, cells, values, time):
        self.points, self.cells, self.values, self.time = points, cells, values, time

    def size_fields(self):
        """Itself as a list of one field."""
        return [from_rows(np.column_stack((self.points, self.sizes)), "flow_sizes")]

    def __repr__(self):
        return f"<FlowSizes: {len(self.sizes):,} cells, {self.sizes.min():.4g} to {self.sizes.max():.4g} mm>"


def flow_sizes(case, field, time=None, error=None, min_size=None, max_size=None, change=CHANGE, scale=0.001):
    """Sizes for a surface and for regions of refinement, by a field that OpenFOAM has computed: a FlowSizes.

    case      folder of the case, with constant/polyMesh, or decomposed, with processor0 ...; text or binary, also compressed
    field     name of a field of cells: "p", "U" ...
    time      number or name of the folder; None: the last one
    error     largest error of linear interpolation, in units of the field; None: 0.01 of its range
    min_size, max_size
              mm; None: no bound
    change    sizes differ from those of the cells by this factor at most, each way
    scale     factor from mm to the coordinates of the case; 0.001: metres

    h = sqrt(8 error / |d2|), where |d2| is the largest second derivative in any direction, of components that with the largest. It is that of a
    polynomial of second order through the value of the cell that fits best to the cells around and those around them.
    Raises IoError naming the file; InvalidInput.
    """
    _check(error, min_size, max_size, change, scale)
    case = os.fsdecode(case)
    mesh, values, time = read_case(case, field, time)
    centres, volumes = mesh.centres_and_volumes()
    bad = ~np.isfinite(values).all(axis=1)
    if bad.any():
        raise InvalidInput(f"{field} has no number in cell {int(np.argmax(bad))}, one of {int(bad.sum())} such cells: give a time before")
    found = FlowSizes(centres / scale, np.cbrt(np.abs(volumes)) / scale, values, time)
    found.gradients, found.hessians = derivatives(found.points, values, mesh.owner[:len(mesh.neighbour)], mesh.neighbour)
    found.error = float(_SHARE * np.ptp(values, axis=0).max()) if error is None else float(error)
    found.sizes = _sizes(found, min_size, max_size, change)
    return found


def _check(error, min_size, max_size, change, scale):
    for name, value in (("error", error), ("min_size", min_size), ("max_size", max_size), ("scale", scale)):
        if value is not None and not value > 0.0:
            raise InvalidInput(f"{name} = {value!r} is not allowed: it must be above 0")
    if not change >= 1.0:
        raise InvalidInput(f"change = {change!r} is not allowed: it must be at least 1")
    if min_size and max_size and min_size > max_size:
        raise InvalidInput(f"min_size = {min_size:g} mm is above max_size = {max_size:g} mm")


def _sizes(found, min_size, max_size, change):
    parts = found.hessians.reshape(len(found.points), -1, 6)
    matrices = parts[..., [[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
    largest = np.abs(np.linalg.eigvalsh(matrices)).max(axis=(1, 2))
    with np.errstate(divide="ignore"):
        sizes = np.sqrt(8.0 * found.error / largest) if found.error > 0.0 else np.full(len(largest), np.inf)
    sizes = np.clip(sizes, found.cells / change, found.cells * change)
    return np.clip(sizes, min_size or 0.0, max_size or np.inf)


def derivatives(points, values, one, other):
    """First (n, 3 k) and second derivatives (n, 6 k: xx, yy, zz, xy, yz, zx) of values (n, k) at points, by the polynomial of second order
    that has the value of each point and fits best to those of its neighbours and of theirs; one, other: int (m,), pairs of neighbours.
    """
    count, components = values.shape
    first, second = np.concatenate([one, other]), np.concatenate([other, one])
    order = np.argsort(first, kind="stable")
    first, second = first[order], second[order]
    starts = np.concatenate([[0], np.cumsum(np.bincount(first, minlength=count))])
    found = np.zeros((count, 9, components))
    for low in range(0, count, _BATCH):
        high = min(low + _BATCH, count)
        cell, near = _around(low, high, starts, second)
        found[low:high] = _fits(points, values, low, high, cell, near)
    gradients = np.swapaxes(found[:, :3], 1, 2).reshape(count, -1)
    return gradients, np.swapaxes(found[:, 3:], 1, 2).reshape(count, -1)


def _around(low, high, starts, second):
    """(point, neighbour): the neighbours of points low to high, and those of these, each once; of points with few of these those of a
    third ring, too.
    """
    def spread(cell, at):
        counts = starts[at + 1] - starts[at]
        places = np.repeat(starts[at] - np.concatenate([[0], np.cumsum(counts)[:-1]]), counts) + np.arange(counts.sum())
        return np.repeat(cell, counts), second[places]

    def joined(cell, near):
        farther_cell, farther = spread(cell, near)
        keys = np.unique(np.concatenate([cell, farther_cell]) * len(starts) + np.concatenate([near, farther]))
        cell, near = keys // len(starts), keys % len(starts)
        return cell[cell != near], near[cell != near]

    own = np.arange(low, high)
    cell, near = joined(*spread(own, own))
    few = (np.bincount(cell - low, minlength=high - low) < _FEW)[cell - low]
    third = joined(cell[few], near[few])
    return np.concatenate([cell[~few], third[0]]), np.concatenate([near[~few], third[1]])


def _fits(points, values, low, high, cell, near):
    """float64 (high - low, 9, k): derivatives x, y, z, xx, yy, zz, xy, yz, zx."""
    count, row = high - low, cell - low
    offsets = points[near] - points[cell]
    distances = np.linalg.norm(offsets, axis=1)
    lengths = np.full(count, 1e-300)
    np.maximum.at(lengths, row, distances)
    x, y, z = (offsets / lengths[row, None]).T
    basis = np.stack([x, y, z, x * x / 2, y * y / 2, z * z / 2, x * y, y * z, z * x], axis=1)
    weights = (lengths[row] / np.maximum(distances, 1e-300))**2
    heavy = basis * weights[:, None]
    matrices, rights = np.zeros((count, 9, 9)), np.zeros((count, 9, values.shape[1]))
    steps = values[near] - values[cell]
    for i in range(9):
        for j in range(i, 9):
            matrices[:, i, j] = matrices[:, j, i] = np.bincount(row, heavy[:, i] * basis[:, j], count)
        for k in range(values.shape[1]):
            rights[:, i, k] = np.bincount(row, heavy[:, i] * steps[:, k], count)
    ridge = _RIDGE * np.maximum(np.trace(matrices, axis1=1, axis2=2) / 9.0, 1e-300)
    matrices[:, range(9), range(9)] += ridge[:, None]
    found = np.linalg.solve(matrices, rights)
    scale = lengths[:, None, None]
    return np.concatenate([found[:, :3] / scale, found[:, 3:] / scale**2], axis=1)
