# SPDX-License-Identifier: LGPL-2.1-or-later
"""How meshes are written into files: in which format, with which patches, and so that only a complete file replaces an
existing one.
"""

import math
import numbers
import os
import tempfile

import numpy as np

from ... import files, formats, phrases
from ...errors import InvalidInput, IoError
from ..formats import cgns, exodus, hopr, mfem, nektar, three_mf
from ..formats.arrays import element_blocks, points_of
from ..patches.patches import Division, colour_of, division_of, patches_of, require_faces, with_interfaces
from ..sources import convert
from .contact_sheets import SHEET, with_sheets

# What is written at most, and the least size of a mesh: beyond, single precision has infinities, or fewer digits.
_LARGEST, _SMALLEST = float(np.finfo(np.float32).max), float(np.finfo(np.float32).tiny / np.finfo(np.float32).eps)


def write(mesh, path, patches=None, patch_rest=None, scale=1.0, ascii=False, format=None,  # noqa: A002
          interfaces=False):
    """Writes a SurfaceMesh or a CurvedMesh; see their `write`."""
    name = convert.file_name(path)
    suffix = _suffix_of(mesh, os.fsdecode(name), format)
    scale = checked_scale(scale)
    require_in_range(points_of(mesh, 1.0), scale)
    if ascii:
        formats.check_text(suffix)
    if interfaces not in (False, True, None, SHEET):
        raise InvalidInput(f"interfaces = {interfaces!r} is not possible: give True for a patch on each side of a contact, "
                           f"or {SHEET!r} for one between both solids")
    found = _patches_for(mesh, patches, patch_rest)
    if interfaces == SHEET:
        mesh, found = with_sheets(mesh, found)
    elif interfaces:
        found = with_interfaces(found, mesh)
    formats.check_names(suffix, found.names, solids_of(mesh), ascii=bool(ascii))
    atomically(os.fsdecode(name), suffix, lambda ready: _write_as(mesh, ready, suffix, found, scale, bool(ascii)))


def _suffix_of(mesh, path, name):
    order = getattr(mesh, "order", 0)
    flat = "; tessellate() gives flat triangles" if formats.known_suffix(os.path.splitext(path)[1]) else ""
    suffix = suffix_of(path, name, formats.CURVED_SUFFIXES if order else formats.SUFFIXES,
                       ("curved elements are" if order else "a mesh is", flat))
    if order:
        formats.check_order(suffix, order)
    return suffix


def suffix_of(path, name, known, words):
    """The extension among those known that a format, or where it is None the path, says; words are what is written, and what is
    said besides of a path. Raises InvalidInput, IoError.
    """
    suffix = formats.known_suffix(os.path.splitext(path)[1] if name is None else f".{str(name).lstrip('.')}", known)
    if suffix is None and name is not None:
        raise InvalidInput(f"format = {name!r} is not known: {words[0]} written as one of " + ", ".join(other[1:] for other in known))
    if suffix is None:
        raise IoError(f"cannot write '{path}': {words[0]} written into files with a name that ends in one of {' '.join(known)}{words[1]}")
    return suffix


def checked_scale(scale, name="scale", example="0.001"):
    """The factor as a float; raises InvalidInput naming the option, with the one for metres."""
    if isinstance(scale, bool) or not isinstance(scale, numbers.Real) or not 0.0 < scale < math.inf:
        raise InvalidInput(f"{name} = {scale!r} is not possible: give a number greater than 0, such as {example} for metres")
    return float(scale)


def require_in_range(points, scale):
    """Raises InvalidInput where coordinates times a factor leave what files hold: single precision, as in .stl and .ply."""
    if not len(points):
        return
    size, largest = float(np.ptp(points, axis=0).max()), float(np.abs(points).max())
    if not largest * scale <= _LARGEST:
        raise InvalidInput(f"scale = {scale:.6g} gives coordinates of {largest * scale:.3g}, which single precision does not hold: give a "
                           "smaller scale")
    if size * scale < _SMALLEST and size > 0.0:
        raise InvalidInput(f"scale = {scale:.6g} gives a size of {size * scale:.3g}, in which single precision does not tell points "
                           "apart: give a larger scale")


def _patches_for(mesh, patches, patch_rest):
    """Those given here, those that the mesh was made with, or each face by its own name."""
    made_with = mesh._patches
    division = division_of(patches, patch_rest, like=made_with.division if made_with is not None else Division())
    if division is None and made_with is not None:
        return made_with
    face, count = mesh.triangle_face, len(mesh.triangles)
    if len(face):
        require_faces(division, int(face.max()) + 1, "the mesh")
    return patches_of(division, face, count)


def solids_of(mesh):
    """The names of the solids that have tetrahedra, ascending."""
    solids, names = getattr(mesh, "tetrahedron_solid", None), getattr(mesh, "_solid_names", ())
    present = [] if solids is None else sorted(set(solids.tolist()))
    return [names[index] if 0 <= index < len(names) else f"Solid{index + 1}" for index in present]


def _write_as(mesh, path, suffix, patches, scale, ascii):  # noqa: A002
    if suffix == ".cgns":
        cgns.write(mesh, path, patches, solids_of(mesh), scale)
    elif suffix == ".exo":
        exodus.write(mesh, path, patches, solids_of(mesh), scale)
    elif suffix == ".h5":
        _write_hopr(mesh, path, patches, scale)
    elif suffix == ".mesh":
        mfem.write(mesh, path, patches, solids_of(mesh), scale)
    elif suffix == ".xml":
        nektar.write(mesh, path, patches, solids_of(mesh), scale)
    elif suffix == ".3mf":
        three_mf.write(path, [("", [("", mesh, patches)])], scale)
    else:
        mesh._write_core(os.fsencode(path), suffix[1:].lower(), patches, scale, ascii)


def _write_hopr(mesh, path, patches, scale):
    volumes = []
    if len(getattr(mesh, "tetrahedra", ())):
        volumes = [("tetrahedron", mesh.tetrahedra, np.unique(mesh.tetrahedron_solid, return_inverse=True)[1].ravel() + 1)]
    faces = [(name, mesh.triangles[members, :3]) for name, members in element_blocks(patches.names, patches.of_triangle)]
    hopr.write(path, points_of(mesh, scale), volumes, faces)


def arguments_of(patches):
    """The arguments of the core's writers for Patches."""
    return {"names": list(patches.names), "patch": patches.of_triangle, "given": patches.given,
            "colours": [colour_of(patches, i) for i in range(len(patches.names))]}


def atomically(path, suffix, write_into):
    """Has `write_into` write a file beside the path, which gets the name once it is complete. Where the path is a pipe or a
    device, or a file in a folder that takes no other, it gets the content of one written elsewhere: libraries of formats
    would remove it first, or want to read back what they wrote.

    Raises IoError naming the path.
    """
    target = os.path.realpath(path)
    folder = os.path.dirname(target)
    if not os.path.isdir(folder):
        raise IoError(f"cannot open '{path}': there is no folder {folder}")
    elsewhere = os.path.exists(target) and not (os.path.isfile(target) and os.access(folder, os.W_OK))
    ready = files.unfinished(os.path.join(tempfile.gettempdir(), "") if elsewhere else target, suffix)
    try:
        write_into(ready)
        if elsewhere:
            files.fill(ready, target)
        else:
            files.put_in_place(ready, target)
    except OSError as error:
        why = error.strerror or str(error)
        raise IoError(f"cannot write '{path}': {why}; choose another file or folder, or make room there") from error
    except IoError as error:
        said = phrases.text_of(error)
        for written, name in ((ready, path), (os.path.basename(ready), os.path.basename(target)), (target, path)):
            said = phrases.renamed(said, written, name)
        raise IoError(said if path in said else f"cannot write '{path}': {said}") from error
    finally:
        files.remove_if_there(ready)
