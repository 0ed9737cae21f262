# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes an ElementMesh into files, whatever kinds of elements it has."""

import os

import numpy as np

from ... import formats
from ...compat import extension
from ...errors import InvalidInput
from ..elements import kinds
from ..formats import cgns, hopr, mfem, nek
from ..formats.sides import faces_of_groups
from ..sources import convert
from . import writing

_HOPR, _MFEM = ".h5", ".mesh"
# By suffix: how much lower dimensions of elements may be than the highest, the (kind, nodes) it holds, and who writes it.
_OWN = {".cgns": (1, cgns.TYPES, cgns.write_elements), ".re2": (0, nek.TYPES, nek.write),
        _MFEM: (0, mfem.TYPES, mfem.write_elements)}


def write(mesh, path, scale=1.0, format=None):  # noqa: A002 - an option of ElementMesh.write
    """See ElementMesh.write."""
    name = os.fsdecode(convert.file_name(path))
    suffix = writing.suffix_of(name, format, formats.ELEMENTS_WRITTEN, ("elements are", ""))
    scale = writing.checked_scale(scale)
    writing.require_in_range(mesh.nodes, scale)
    formats.check_names(suffix, mesh.groups)
    if suffix == _HOPR:
        writing.atomically(name, suffix, lambda ready: _write_hopr(mesh, ready, scale))
        return
    if suffix == _MFEM and len(_orders(mesh)) > 1:
        raise InvalidInput(f"{suffix} files hold volumes of one order: choose one of {' '.join(suffixes_for(mesh))}")
    below, types = _held(suffix)
    for block in _written(mesh, below):
        if (block.kind, block.nodes.shape[1]) not in types:
            raise InvalidInput(f"{suffix} files hold no {kinds.PLURALS[block.kind]} of order {block.order} with "
                               f"{block.nodes.shape[1]} nodes: choose one of {' '.join(suffixes_for(mesh))}")
    if suffix in _OWN:
        writing.atomically(name, suffix, lambda ready: _OWN[suffix][2](mesh, ready, scale))
        return
    blocks = [(block.kind, block.nodes, block.geometry, _lagrange_order(block)) for block in mesh.blocks]
    groups = [(group, [part for part in parts if len(part[1])]) for group, parts in mesh.group_members.items()]
    writing.atomically(name, suffix, lambda ready: extension().write_elements(
        os.fsencode(ready), suffix[1:], mesh.nodes, blocks, groups, scale))


def _lagrange_order(block):
    """By place in VTK's Lagrange cells the place in Gmsh's order; empty where VTK has other cells or none."""
    if block.order <= 2 or block.kind == "pyramid":
        return []
    return np.argsort(kinds.from_lagrange(block.kind, block.nodes.shape[1]))


def suffixes_for(mesh):
    """The extensions of the formats that hold all elements of an ElementMesh."""
    return tuple(suffix for suffix in formats.ELEMENTS_WRITTEN if _holds(mesh, suffix))


def _orders(mesh):
    """The orders of its volumes."""
    return {block.order for block in mesh.blocks if kinds.DIMENSION[block.kind] == 3}


def _holds(mesh, suffix):
    if suffix in (_HOPR, _MFEM) and len(_orders(mesh)) != 1:
        return False
    if suffix == _HOPR:
        return True
    below, types = _held(suffix)
    return all((block.kind, block.nodes.shape[1]) in types for block in _written(mesh, below))


def _held(suffix):
    """How much lower dimensions of elements in a format may be than the highest, and the (kind, nodes) that it holds."""
    return _OWN[suffix][:2] if suffix in _OWN else extension().element_formats()[suffix[1:]]


def _written(mesh, below):
    """The blocks that a format takes as elements: others are the boundaries of these at most, and go as groups."""
    return [block for block in mesh.blocks if kinds.DIMENSION[block.kind] >= mesh.dimension - below]


def _write_hopr(mesh, path, scale):
    """Zones are the CAD volumes that the mesh knows of, else its groups of volumes; groups of faces are conditions."""
    volumes = []
    for block in mesh.blocks:
        if kinds.DIMENSION[block.kind] == 3:
            zone = block.geometry if (block.geometry >= 0).all() else block.group
            volumes.append((block.kind, block.nodes, zone.astype(np.int64)))
    numbers = np.unique(np.concatenate([np.zeros(0, dtype=np.int64), *(zone for _, _, zone in volumes)]))
    volumes = [(kind, nodes, np.searchsorted(numbers, zone) + 1) for kind, nodes, zone in volumes]
    hopr.write(path, mesh.nodes * scale, volumes, faces_of_groups(mesh))
