# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes an ElementMesh into files, whatever kinds of elements it has."""

import importlib
import os

import numpy as np

from .. import formats
from ..errors import InvalidInput, IoError
from .sources import convert
from . import writing
from .element_writers import hopr_file
from .element_writers.numbered import Numbered
from .elements import kinds

_HOPR = ".h5"


def write(mesh, path, scale=1.0, format=None):  # noqa: A002 - an option of ElementMesh.write
    """See ElementMesh.write."""
    name = os.fsdecode(convert.file_name(path))
    suffix, scale = _suffix_of(name, format), writing.checked_scale(scale)
    writing.require_in_range(mesh.nodes, scale)
    formats.check_names(suffix, mesh.groups)
    if suffix == _HOPR:
        writing.atomically(name, suffix, lambda ready: _write_hopr(mesh, ready, scale))
        return
    writer = importlib.import_module(f".element_writers.{formats.ELEMENTS_WRITTEN[suffix]}", __package__)
    for block in _written(mesh, writer):
        if not _has_type(writer, block):
            raise InvalidInput(f"{suffix} files hold no {kinds.PLURALS[block.kind]} of order {block.order} with "
                               f"{block.nodes.shape[1]} nodes: choose one of {' '.join(suffixes_for(mesh))}")
    writing.atomically(name, suffix, lambda ready: writer.write(Numbered(mesh, scale), ready))


def _suffix_of(path, name):
    known = tuple(formats.ELEMENTS_WRITTEN)
    suffix = formats.known_suffix(os.path.splitext(path)[1] if name is None else f".{str(name).lstrip('.')}", known)
    if suffix is not None:
        return suffix
    if name is not None:
        raise InvalidInput(f"format = {name!r} is not known: elements are written as one of "
                           + ", ".join(other[1:] for other in known))
    raise IoError(f"cannot write '{path}': elements are written into files with a name that ends in one of {' '.join(known)}")


def suffixes_for(mesh):
    """The extensions of the formats that hold all elements of an ElementMesh."""
    return tuple(suffix for suffix in formats.ELEMENTS_WRITTEN if _holds(mesh, suffix))


def _holds(mesh, suffix):
    if suffix == _HOPR:
        orders = {block.order for block in mesh.blocks if kinds.DIMENSION[block.kind] == 3}
        return len(orders) == 1
    writer = importlib.import_module(f".element_writers.{formats.ELEMENTS_WRITTEN[suffix]}", __package__)
    return all(_has_type(writer, block) for block in _written(mesh, writer))


def _has_type(writer, block):
    """Whether a format has elements of this kind with this number of nodes, or with any number, which its table has as None."""
    return (block.kind, block.nodes.shape[1]) in writer.TYPES or (block.kind, None) in writer.TYPES


def _written(mesh, writer):
    """The blocks that a format takes as elements: others are the boundaries of these at most, and go as groups."""
    lowest = mesh.dimension - writer.BOUNDARIES
    return [block for block in mesh.blocks if kinds.DIMENSION[block.kind] >= lowest]


def _write_hopr(mesh, path, scale):
    """Zones are the CAD volumes that the mesh knows of, else its groups of volumes; groups of faces are conditions."""
    volumes, members = [], mesh.group_members
    for block in mesh.blocks:
        if kinds.DIMENSION[block.kind] == 3:
            zone = block.geometry if (block.geometry >= 0).all() else block.group
            volumes.append((block.kind, block.nodes, zone.astype(np.int64)))
    numbers = np.unique(np.concatenate([np.zeros(0, dtype=np.int64), *(zone for _, _, zone in volumes)]))
    volumes = [(kind, nodes, np.searchsorted(numbers, zone) + 1) for kind, nodes, zone in volumes]
    boundary = []
    for name, parts in members.items():
        for i, rows in parts:
            block = mesh.blocks[i]
            if kinds.DIMENSION[block.kind] == 2:
                boundary.append((name, block.nodes[rows][:, :kinds.CORNERS[block.kind]]))
    hopr_file.write(path, mesh.nodes * scale, volumes, boundary)
