# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quality meshes of CAD shapes and of meshes, inside FreeCAD. Lengths are in mm, angles in degrees.

First steps
    import MeshQuality as mq
    mesh = mq.triangulate(shape, min_angle=25.0, chord_height_relative=0.001)
    mesh.write("part.ply")
    mq.add_quality_mesh(App.ActiveDocument.Body, min_angle=25.0)

Meshes for scripts
    triangulate   a triangle mesh of a shape with a bound on its angles and its distance -> SurfaceMesh
    curve         curved triangles or tetrahedra on a shape, each proven valid           -> CurvedMesh
    boolean       joins, intersects or subtracts closed meshes and shapes                -> BooleanMesh
    improve       the same surface with better triangles                                 -> SurfaceMesh
    quality       measures any mesh                                                      -> MeshReport
    Memory        what an edit left alone keeps its triangles

Objects of the document, which follow what they are made of
    add_quality_mesh, add_curved_mesh, add_boolean, add_improved_mesh
    update              gives such an object other options, and computes it
    export_curved_mesh  writes its curved elements

Results and reports
    A mesh has NumPy arrays (vertices, triangles, ...), to_mesh() for a Mesh.Mesh, write(path) by extension, and its
    report: a MeshReport, BooleanReport or CurveReport. print(mesh.report) tells what was measured and requested.

Callbacks
    progress(fraction, stage) of a long call is called by the thread that called. It may return False, which raises
    Cancelled; what it raises comes out as it is; it may call functions of MeshQuality, undo, close documents and delete
    objects. update() raises Error where its object is gone then or its source another one, and changes nothing.
    Work of daemon threads is cancelled when Python ends.

Errors
    Error and its subclasses InvalidInput, TopologyError, GeometryError, Cancelled, IoError, MissingBinary. Their text
    names the sub-element at fault and the remedy.

help(mq.triangulate) and so on has all options.
"""

import importlib

from .errors import (Cancelled, Error, GeometryError, InvalidInput, IoError, MissingBinary,
                     TopologyError)
from .version import __version__

# Loaded on first use: FreeCAD starts no slower, and errors and options work without the core.
_LAZY = {
    "triangulate": "MeshQuality.api",
    "Memory": "MeshQuality.api",
    "quality": "MeshQuality.api",
    "improve": "MeshQuality.api",
    "add_improved_mesh": "MeshQuality.api",
    "curve": "MeshQuality.curved_mesh",
    "CurvedMesh": "MeshQuality.curved_mesh",
    "boolean": "MeshQuality.boolean_mesh",
    "BooleanMesh": "MeshQuality.boolean_mesh",
    "add_quality_mesh": "MeshQuality.api",
    "add_curved_mesh": "MeshQuality.curved_mesh",
    "add_boolean": "MeshQuality.boolean_mesh",
    "export_curved_mesh": "MeshQuality.export",
    "update": "MeshQuality.api",
    "SurfaceMesh": "MeshQuality.surface_mesh",
    "MeshReport": "MeshQuality._core",
    "BooleanReport": "MeshQuality._core",
    "CurveReport": "MeshQuality._core",
}

__all__ = sorted(["Cancelled", "Error", "GeometryError", "InvalidInput", "IoError", "MissingBinary",
                  "TopologyError", *_LAZY])


def __getattr__(name):
    if name not in _LAZY:
        raise AttributeError(f"module 'MeshQuality' has no attribute {name!r}")
    if _LAZY[name] == "MeshQuality._core":
        from .compat import core

        module = core()
    else:
        module = importlib.import_module(_LAZY[name])
    value = getattr(module, name)
    globals()[name] = value
    return value


def __dir__():
    """What scripts use, for tab completion and help()."""
    return ["__version__", *__all__]
