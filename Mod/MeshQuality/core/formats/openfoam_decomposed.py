# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes and fields of a case of OpenFOAM that may be decomposed, as folders processor0, processor1, ..."""

import os
import re

import numpy as np

from ...errors import InvalidInput, IoError
from .openfoam import PolyMesh, processor_patches, read_field, read_poly_mesh, times_of

_FOLDER = re.compile(r"processor(\d+)")


def read_case(case, name, time=None):
    """(PolyMesh, float64 (cells, k), time) of a field of cells, from the case itself or from its processors; time: None: the last one.

    Where both have the time, that of the case itself. Raises IoError naming the file; InvalidInput naming the times that there are.
    """
    parts = _parts(case)
    own, theirs = times_of(case, name), times_of(parts[0], name) if parts else []
    if parts and _is_of_parts(own, theirs, name, time):
        fields = [read_field(part, name, theirs[-1] if time is None else time) for part in parts]
        meshes = [read_poly_mesh(part) for part in parts]
        values = [_by_cell(values, mesh, name, part) for (values, _), mesh, part in zip(fields, meshes, parts)]
        return _joined(parts, meshes), np.concatenate(values), fields[0][1]
    values, time = read_field(case, name, time)
    mesh = read_poly_mesh(case)
    return mesh, _by_cell(values, mesh, name, case), time


def _parts(case):
    """The folders of the processors, by number."""
    try:
        found = {int(match[1]): os.path.join(case, match[0]) for match in map(_FOLDER.fullmatch, os.listdir(case)) if match}
    except OSError as error:
        raise IoError(f"cannot read the case '{case}': {error.strerror}") from error
    missing = [number for number in range(len(found)) if number not in found]
    if missing:
        raise IoError(f"cannot read the case '{case}': the folder processor{missing[0]} is missing, of {max(found) + 1}")
    return [found[number] for number in range(len(found))]


def _is_of_parts(own, theirs, name, time):
    if time is None:
        return bool(theirs) and (not own or float(theirs[-1]) > float(own[-1]))
    there = [any(entry == str(time) or float(entry) == float(time) for entry in times) for times in (own, theirs)]
    if not any(there) and own + theirs:
        raise InvalidInput(f"time = {time!r} is not possible: {name} is there at {', '.join(sorted({*own, *theirs}, key=float))}")
    return there[1] and not there[0]


def _by_cell(values, mesh, name, folder):
    if len(values) == 1:  # uniform
        return np.tile(values, (mesh.cells, 1))
    if len(values) != mesh.cells:
        raise InvalidInput(f"{name} of {folder} has {len(values)} values for {mesh.cells} cells: give the case that it was computed on")
    return values


def _joined(folders, meshes):
    """One PolyMesh: the faces between two processors are inner ones, once, as the lower processor has them."""
    first_cell = np.concatenate([[0], np.cumsum([mesh.cells for mesh in meshes])])
    first_point = np.concatenate([[0], np.cumsum([len(mesh.points) for mesh in meshes])])
    patches = [processor_patches(folder) for folder in folders]
    inner, outer = [], []  # of processor, face, and the cells on its two sides
    for here, mesh in enumerate(meshes):
        faces, shared = np.arange(len(mesh.owner)), np.zeros(len(mesh.owner), dtype=bool)
        count = len(mesh.neighbour)
        inner.append((here, faces[:count], mesh.owner[:count] + first_cell[here], mesh.neighbour + first_cell[here]))
        for there, (start, number) in patches[here].items():
            shared[start:start + number] = True
            if there > here:
                start_there, number_there = patches[there].get(here, (0, 0)) if there < len(meshes) else (0, 0)
                if number_there != number:
                    raise IoError(f"cannot read '{folders[here]}': it has {number} faces to processor{there}, which has {number_there}")
                across = meshes[there].owner[start_there:start_there + number] + first_cell[there]
                inner.append((here, faces[start:start + number], mesh.owner[start:start + number] + first_cell[here], across))
        rest = faces[count:][~shared[count:]]
        outer.append((here, rest, mesh.owner[rest] + first_cell[here], None))
    corners, lengths = zip(*(_corners(meshes[here], faces, first_point[here]) for here, faces, *_ in inner + outer))
    return PolyMesh(np.concatenate([mesh.points for mesh in meshes]), np.concatenate(corners),
                    np.concatenate([[0], np.cumsum(np.concatenate(lengths))]), np.concatenate([cells for _, _, cells, _ in inner + outer]),
                    np.concatenate([cells for *_, cells in inner]))


def _corners(mesh, faces, shift):
    """(points of some faces one after another, how many each has)."""
    lengths = mesh.starts[faces + 1] - mesh.starts[faces]
    first = np.concatenate([[0], np.cumsum(lengths)[:-1]]) if len(faces) else np.zeros(0, dtype=int)
    places = np.repeat(mesh.starts[faces] - first, lengths) + np.arange(lengths.sum())
    return mesh.corners[places] + shift, lengths
