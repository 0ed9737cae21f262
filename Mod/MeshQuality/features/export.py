# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes what document objects hold into files, by their patches."""

import os
from functools import partial

import FreeCAD
import numpy as np

from .. import files, formats, phrases
from ..compat import extension, property_of
from ..core.curving import holds_elements, taken_from
from ..core.meshes.element_mesh import ElementMesh
from ..core.meshes.surface_mesh import SurfaceMesh
from ..core.patches.patches import division_of, kept
from ..core.sources import convert, frames
from ..errors import Error, InvalidInput, IoError
from ..phrases import Text
from .cured_mesh import has_fem_mesh
from .flow_mesh import is_flow_mesh, volume_mesh_of
from .mesh_object import PatchedMesh, faces_of_runs
from .patches import patches_of_object
from .properties import options_of

_written = {}  # what _key gives -> file that holds its content already


def export_mesh(obj, path, patches=None, patch_rest=None, scale=1.0, ascii=False):  # noqa: A002 - an option of write
    """Writes the mesh of a document object into a file, with its patches.

    obj      any object with a mesh, or a link to one: the mesh is written where that stands; of a FEM mesh, whoever made it,
             the elements are written with their groups, into what ElementMesh.write takes
    path     the extension says the format, as for SurfaceMesh.write; of add_curved_mesh the curved elements are
             written where the format holds them, else the flat triangles that are shown
    patches, patch_rest
             as for SurfaceMesh.write; None: those of set_patches
    scale, ascii
             as for SurfaceMesh.write

    Raises InvalidInput for other objects, for what the format cannot hold, and for a mesh with patches that is out of
    date: they name faces of the source as it is now. Without patches that is a warning in the Report view. IoError naming
    the path.
    """
    if not isinstance(frames.object_of(obj), FreeCAD.DocumentObject):
        raise InvalidInput(f"{convert.label_of(obj)} holds no mesh: give an object with a mesh, or a link to one")
    path = checked(obj, path)
    ready = _written.pop(_key(obj, path, scale, ascii), None) if patches is None and patch_rest is None else None
    if ready is not None:
        files.put_in_place(ready, os.path.realpath(path))
    else:
        _write(maker_of(obj, path, patches, patch_rest)(), path, scale, ascii)


def _write(mesh, path, scale, ascii):  # noqa: A002
    if isinstance(mesh, ElementMesh):
        if ascii:
            raise InvalidInput("ascii is for STL files: a FEM mesh is written as elements")
        mesh.write(path, scale=scale)
    else:
        mesh.write(path, scale=scale, ascii=ascii)


def export_curved_mesh(obj, path):
    """Writes the curved elements of a document object of add_curved_mesh; see export_mesh.

    obj   such an object, or a link to one: the elements are written where that stands
    path  as for CurvedMesh.write; an existing file is replaced

    Raises InvalidInput for other objects, IoError naming the path.
    """
    if not holds_elements(obj):
        taken_from(obj)  # says why
    path = checked(obj, path, formats.CURVED_SUFFIXES)
    export_mesh(obj, path)


def suffixes_for(obj):
    """The extensions of the formats that hold the mesh of an object."""
    if holds_fem_mesh(obj):
        return formats.ELEMENTS_WRITTEN
    order = _order_of(obj)
    return tuple(suffix for suffix, form in formats.FORMATS.items()
                 if (not order and not form.volumes) or (order and (not form.curved or form.curved >= order)))


def holds_fem_mesh(source):
    """Whether elements of a FEM mesh are what is written of an object, or of a link to one."""
    return frames.is_object(source) and not convert.is_mesh(source) and has_fem_mesh(frames.linked_of(source)[0])


def _order_of(source):
    return frames.linked_of(source)[0].ElementsOrder if holds_elements(source) else 0


def checked(obj, path, known=None):
    """The path as absolute text; raises IoError where nothing can be written there."""
    known = suffixes_for(obj) if known is None else known
    endings = " ".join(known)
    path = os.fsdecode(convert.file_name(path))
    if not path:
        raise IoError(Text(phrases.FILE_NO_NAME, value=endings))
    path = os.path.abspath(path)
    folder, extension_of_path = os.path.dirname(path), os.path.splitext(path)[1]
    if os.path.isdir(path):
        raise IoError(Text(phrases.FILE_IS_FOLDER, value=path, value2=endings))
    if formats.known_suffix(extension_of_path, known) is None:
        order = _order_of(obj)
        if order:
            raise IoError(Text(phrases.FILE_ENDING_CURVED, value=path, count=str(order), value2=endings))
        raise IoError(Text(phrases.FILE_ENDING, value=path, value2=endings))
    if not os.path.isdir(folder):
        raise IoError(Text(phrases.FILE_NO_FOLDER, value=path, value2=folder))
    if not os.access(folder, os.W_OK):
        raise IoError(Text(phrases.FILE_NOT_WRITABLE, value=path))
    return path


def maker_of(obj, path, patches=None, patch_rest=None):
    """A function that makes what is written of the object as it is now into this file; any thread may call it."""
    if holds_fem_mesh(obj):
        if patches is not None or patch_rest is not None:
            raise InvalidInput(f"{convert.label_of(obj)} is a FEM mesh, whose groups are written: leave the patches out")
        made = volume_mesh_of(obj) if is_flow_mesh(frames.linked_of(obj)[0]) else ElementMesh.of(obj)
        return partial(_as_it_is, made)
    suffix = formats.known_suffix(os.path.splitext(path)[1], tuple(formats.FORMATS))
    curved = holds_elements(obj) and formats.FORMATS[suffix].curved
    make = taken_from(obj) if curved else _flat_maker(obj)
    if patches is None and patch_rest is None:
        patches, patch_rest = patches_of_object(obj)
    return partial(_with_patches, make, _division(obj, patches, patch_rest))


def _as_it_is(mesh):
    return mesh


def flat_maker_of(obj):
    """A function that makes the SurfaceMesh that a document object shows, with its patches, measured; any thread may call
    it.
    """
    return partial(_with_patches, _flat_maker(obj, measured=True), _division(obj, *patches_of_object(obj)))


def _division(obj, patches, patch_rest):
    holder = frames.linked_of(obj)[0]
    current = _require_current(holder, patches)
    knows = isinstance(getattr(holder, "Proxy", None), PatchedMesh) and hasattr(holder, "FaceRuns")
    if not current or not knows or holder.Proxy.lacks_source(holder) or not holder.Proxy.has_faces(holder):
        return division_of(patches, patch_rest)
    return holder.Proxy.faces(holder).division(patches, patch_rest)


def _require_current(holder, patches):
    """Raises InvalidInput where patches name faces of a source that has changed since it was meshed: other triangles would
    be in them. Warns where an old mesh is written without. Returns whether the mesh is that of its sources.
    """
    if not isinstance(getattr(holder, "Proxy", None), PatchedMesh) or not is_outdated(holder):
        return True
    text = f"{holder.Label} is out of date: its source or an option has changed since the mesh was made"
    if patches:
        raise InvalidInput(f"{text}, and patches name faces as they are now; recompute it first (Update Mesh)")
    FreeCAD.Console.PrintWarning(f"{text}. The older mesh is written; recompute it (Update Mesh) and export it anew.\n")
    return False


def is_outdated(holder):
    """Whether the mesh of an object of this package is not that of its sources and options as they are now."""
    sources, held = holder.Proxy.sources(holder), holder.Proxy.held(holder)
    if not held or None in sources:
        return False
    try:
        return holder.Proxy.work_on(sources, options_of(holder, holder.Proxy.OPTIONS), holder).fingerprint != held
    except Error:  # the present options or sources cannot be meshed
        return True


def _with_patches(make, division):
    mesh = make()
    mesh._patches = kept(division, mesh)
    return mesh


def _flat_maker(source, measured=False):
    if not isinstance(frames.object_of(source), FreeCAD.DocumentObject) or not convert.is_mesh(source):
        raise InvalidInput(f"{convert.label_of(source)} holds no mesh: give an object with a mesh, or a link to one")
    copy, holder = convert.MeshCopy(source), frames.linked_of(source)[0]
    runs = list(property_of(holder, "FaceRuns") or ()) if "FaceRuns" in holder.PropertiesList else []

    def make():
        vertices, triangles = copy.arrays
        if not len(triangles):
            raise InvalidInput(Text(phrases.NO_TRIANGLES_YET, name=convert.label_of(source)))
        faces = faces_of_runs(runs, len(triangles)).astype(np.int32)
        return SurfaceMesh(extension().surface_from_arrays(vertices, triangles, faces, measured))

    return make


def write_ahead(make, obj, path, scale=1.0, ascii=False):  # noqa: A002
    """Writes what maker_of made of an object beside a checked path, for the export_mesh that follows; any thread may call
    it. Returns what takes the file away again if it was not taken.
    """
    ready = files.unfinished(os.path.realpath(path), os.path.splitext(path)[1])
    try:
        _write(make(), ready, scale, ascii)
    except BaseException:
        files.remove_if_there(ready)
        raise
    key = _key(obj, path, scale, ascii)
    _written[key] = ready
    return lambda: files.remove_if_there(_written.pop(key, ready))


def _key(source, path, scale, ascii):  # noqa: A002
    return frames.key_of(source), path, scale, bool(ascii)
