# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes what document objects keep into files."""

import os

from ..errors import IoError
from .convert import file_name
from .curving import CurvedMesh

CURVED_FORMATS = {".msh": "Gmsh mesh", ".vtu": "VTK unstructured grid"}

_written = {}  # file asked for -> file that holds its content already


def export_curved_mesh(obj, path):
    """Writes the curved elements of a document object of add_curved_mesh.

    obj   such an object, or a link to one: the elements are written where that stands
    path  .msh (Gmsh 4.1, ASCII) or .vtu (VTK); an existing file is replaced

    Raises InvalidInput for other objects, IoError naming the path.
    """
    path = checked(path)
    ready = _written.pop(path, None)
    if ready is None:
        CurvedMesh.of(obj).write(path)
    else:
        os.replace(ready, path)


def checked(path):
    """The path as absolute text; raises IoError where nothing can be written there."""
    endings = " or ".join(CURVED_FORMATS)
    path = os.fsdecode(file_name(path))
    if not path:
        raise IoError(f"the file has no name: give one that ends in {endings}")
    path = os.path.abspath(path)
    folder, extension = os.path.dirname(path), os.path.splitext(path)[1].lower()
    if os.path.isdir(path):
        raise IoError(f"{path} is a folder and cannot be written: give the name of a file that ends in {endings}")
    if extension not in CURVED_FORMATS:
        raise IoError(f"{path}: curved elements are written into files with a name that ends in {endings}")
    if not os.path.isdir(folder):
        raise IoError(f"{path}: there is no folder {folder}")
    if not os.access(folder, os.W_OK):
        raise IoError(f"{path} cannot be written")
    return path


def write_ahead(curved, path):
    """Writes a CurvedMesh beside a checked path, for the export_curved_mesh that follows; any
    thread may call it. Returns what takes the file away again if it was not taken.
    """
    stem, extension = os.path.splitext(path)
    ready = f"{stem}.part{extension}"
    try:
        curved.write(ready)
    except IoError:
        _remove(ready)
        raise
    _written[path] = ready
    return lambda: _remove(_written.pop(path, ready))


def _remove(path):
    if os.path.exists(path):
        os.remove(path)
