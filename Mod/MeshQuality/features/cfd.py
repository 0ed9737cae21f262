# SPDX-License-Identifier: LGPL-2.1-or-later
"""Folders for meshers of flows, of document objects and of meshes."""

import functools
import os

from .. import phrases
from ..core.meshes import openfoam_case
from ..core.meshes.surface_mesh import SurfaceMesh
from ..core.sizes.refinement_regions import refinement_boxes
from ..core.sources import convert, frames
from ..core.volumes import polymesh
from ..core.volumes.volume_mesh import VolumeMesh
from ..errors import InvalidInput, IoError
from .export import flat_maker_of
from .flow_mesh import is_flow_mesh, volume_mesh_of
from .mesh_object import SourceMesh

_ready = {}  # (key of the object, folder, flow, cell) of a case that write_ahead has written: its levels


def write_openfoam_case(mesh, folder, name="surface", flow="internal", cell=None, scale=0.001, types=None,
                        size_field=None):
    """Writes a case in which OpenFOAM's blockMesh and snappyHexMesh, or cfMesh's cartesianMesh, fill a part or the space
    around it, with the names of its patches.

    mesh    closed SurfaceMesh, or a document object with one, which has patches by set_patches; or a VolumeMesh, see below
    folder  of the case; it is made where it is not there, and files of these names in it are replaced:
            constant/triSurface/NAME.stl, .eMesh (sharp edges and borders of patches) and .fms; system/blockMeshDict,
            snappyHexMeshDict, meshDict (of cfMesh), controlDict, fvSchemes, fvSolution
    name    of the surface in the case
    flow    "internal": inside of the part; "external": around it, with the wind along x
    cell    mm, cells of the background; None: 1/20 of the part inside, 1/4 around it
    scale   factor of the coordinates; 0.001: metres, which OpenFOAM takes
    types   {patch: "wall" or "patch"}; others are walls, but for those with names that begin with inlet, outlet,
            opening or farfield
    size_field
            lengths of cells by place, as for triangulate, such as of flow_sizes: boxes of refinement for snappyHexMesh

    Of a VolumeMesh, or an object of add_flow_mesh, the cells are there already: the case gets constant/polyMesh, as by VolumeMesh.write, name,
    flow, cell and size_field mean nothing, and {} is returned; types are those of its patches unless given here.

    Surfaces get levels of refinement at which cells are as large as the triangles there, at most 6.
    Returns the levels: {patch: (least, greatest)}. Raises InvalidInput for a mesh that is open; IoError.
    """
    if not isinstance(name, str) or not name.isidentifier() or not name.isascii():
        raise InvalidInput(f"name = {name!r} is not possible: give letters, digits and _ only, a letter first")
    for patch, kind in (types if isinstance(types, dict) else {}).items():
        if kind not in ("wall", "patch"):
            raise InvalidInput(f"types says {kind!r} of patch {patch!r}: give 'wall' or 'patch'")
    folder = os.fsdecode(convert.file_name(folder))
    if not folder:
        raise IoError(phrases.Text(phrases.CASE_NO_FOLDER))
    if isinstance(mesh, (SurfaceMesh, VolumeMesh)):
        made = mesh
    else:
        make = maker_of(mesh, flow)
        ready = _ready.pop((frames.key_of(mesh), folder, flow, cell), None)
        if ready is not None and (name, scale, types, size_field) == ("surface", 0.001, None, None):
            return ready
        made = make()
    if isinstance(made, VolumeMesh):
        return _write_cells(made, folder, scale, types)
    regions_of = None if size_field is None else functools.partial(refinement_boxes, size_field)
    return openfoam_case.write_case(made, folder, name, flow, cell, scale, types, regions_of).levels


def holds_cells(source):
    """Whether it is an object of add_flow_mesh, or a link to one."""
    return frames.is_object(source) and is_flow_mesh(frames.linked_of(source)[0])


def _write_cells(mesh, folder, scale=0.001, types=None):
    polymesh.write_case(mesh, folder, scale, {**mesh.patch_types, **(types or {})}, False)
    return {}


def maker_of(obj, flow):
    """A function that makes the SurfaceMesh of a document object for a case, or the VolumeMesh of add_flow_mesh; any thread may call
    it. Raises InvalidInput where it cannot be one.
    """
    if holds_cells(obj):
        found = volume_mesh_of(obj)
        return lambda: found
    make = flat_maker_of(obj)
    holder = frames.linked_of(obj)[0]
    if isinstance(getattr(holder, "Proxy", None), SourceMesh):  # an offset unites the solids
        openfoam_case.require_one_space(flow, len(convert.own_shape_of(holder.Proxy.sources(holder)[0]).Solids))
    return make


def write_ahead(make, obj, folder, flow, cell):
    """Writes the case of what maker_of made of an object, for the write_openfoam_case with these arguments that follows;
    any thread may call it. Returns what forgets that.
    """
    key = frames.key_of(obj), folder, flow, cell
    made = make()
    _ready[key] = _write_cells(made, folder) if isinstance(made, VolumeMesh) else \
        openfoam_case.write_case(made, folder, flow=flow, cell=cell).levels
    return lambda: _ready.pop(key, None)
