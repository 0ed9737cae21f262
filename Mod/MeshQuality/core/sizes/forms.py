# SPDX-License-Identifier: LGPL-2.1-or-later
"""The forms in which a size field is given, each as an object that has sizes(points) and marks()."""

import os

import numpy as np

from ...errors import InvalidInput
from . import mesh_values
from .flow_sizes import flow_sizes
from .interpolated import interpolated
from .points import from_csv, from_rows

ACCEPTED = ("a function of points (n, 3), an array (n, 4) of x, y, z and size, (points, sizes), (mesh, sizes), the path of a "
            "file, a Size region or result of the document, a SizeField, or a list of these")
_NO_POINTS = np.zeros((0, 3)), np.zeros(0)


class Function:
    """A function of points (n, 3) that returns n sizes; it is called on the thread that asks."""

    def __init__(self, function):
        self._function = function
        self.name = getattr(function, "__name__", "") or type(function).__name__

    def sizes(self, points):
        """float64 (n,), mm, with infinity where there is no bound."""
        found = self._function(points)
        try:
            sizes = np.array(found, dtype=np.float64)
        except (TypeError, ValueError) as error:
            raise InvalidInput(f"size_field: {self.name} returned {type(found).__name__}, which is no array of numbers") from error
        if sizes.shape == ():
            sizes = np.full(len(points), float(sizes))
        if sizes.shape != (len(points),):
            raise InvalidInput(f"size_field: {self.name} returned an array of shape {sizes.shape} for {len(points)} points: "
                               f"it must return one size for each, of shape ({len(points)},)")
        return sizes

    def marks(self):
        """Places with small features, and how small: none is known of a function."""
        return _NO_POINTS


class Octree:
    """A field that was sampled before."""

    def __init__(self, core):
        self.name, self._core = "size_field", core
        self.sizes = core.at

    def arrays(self):
        """Low corner and side, cells and leaves, as size_field_from_arrays takes them."""
        return [*self._core.low, self._core.side], self._core.children, self._core.leaves

    def marks(self):
        """Everything that the octree has divided has features."""
        leaves, low, side = [], np.array(self._core.low), self._core.side
        children = self._core.children
        stack = [(np.array([0]), low[None], side)]
        while stack:  # one depth at a time
            cells, lows, side = stack.pop()
            inner = children[cells] >= 0
            leaves.append((lows[~inner] + side / 2, np.full(int((~inner).sum()), side)))
            if inner.any():
                offsets = np.array([[i & 1, i >> 1 & 1, i >> 2] for i in range(8)]) * (side / 2)
                stack.append(((children[cells[inner]][:, None] + np.arange(8)).ravel(),
                              (lows[inner][:, None] + offsets).reshape(-1, 3), side / 2))
        points, lengths = zip(*leaves)
        return np.concatenate(points), np.concatenate(lengths)


def fields_of(form):
    """The list of fields that a form stands for: the least of them holds. Raises InvalidInput naming what is wrong."""
    if form is None:
        return []
    if hasattr(form, "size_fields"):  # a SizeField of ours
        return form.size_fields()
    if callable(form):
        return [Function(form)]
    if isinstance(form, (str, bytes, os.PathLike)):
        return [_of_file(os.fsdecode(form))]
    if isinstance(form, np.ndarray):
        return [from_rows(form, "size_field")]
    if isinstance(form, tuple) and len(form) == 2:
        return [_of_pair(*form)]
    if isinstance(form, (list, tuple)):
        if form and all(isinstance(row, (list, tuple)) and len(row) == 4 for row in form):
            return [from_rows(form, "size_field")]
        return [field for one in form for field in fields_of(one)]
    found = _of_object(form)
    if found is None:
        raise InvalidInput(f"size_field = {getattr(form, 'Label', type(form).__name__)} is not allowed: it must be {ACCEPTED}")
    return found


def _of_file(path):
    case, _, field = path.partition("#")
    if os.path.isdir(case):
        if not field:
            raise InvalidInput(f"'{path}' is a folder: name a field of a case of OpenFOAM as '{path}#U'")
        return flow_sizes(case, field).size_fields()[0]
    return from_csv(path) if os.path.splitext(path)[1].lower() in (".csv", ".txt") else interpolated(*mesh_values.of_file(path), path)


def _of_pair(first, second):
    """(points, sizes), or (mesh, sizes)."""
    if hasattr(first, "blocks") or hasattr(first, "triangles"):
        return interpolated(*mesh_values.of_mesh(first, second), "size_field")
    try:
        points, sizes = np.asarray(first, dtype=np.float64), np.asarray(second, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InvalidInput(f"size_field: points and sizes are no arrays of numbers ({error})") from error
    if points.ndim != 2 or points.shape[1] != 3:
        raise InvalidInput(f"size_field: points have the shape {points.shape}: give an array (n, 3)")
    if sizes.shape != (len(points),):
        raise InvalidInput(f"size_field: {len(points)} points, but sizes of shape {sizes.shape}: give one size for each point")
    return from_rows(np.column_stack((points, sizes)), "size_field")


def _of_object(source):
    proxy = getattr(source, "Proxy", None)
    if hasattr(proxy, "size_fields"):
        return proxy.size_fields(source)
    if hasattr(source, "isDerivedFrom") and source.isDerivedFrom("Fem::FemResultObject"):
        return [interpolated(*mesh_values.of_result(source), source.Label)]
    return None
