# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quality meshes of CAD shapes, inside FreeCAD.

    import MeshQuality as mq
    mesh = mq.triangulate(shape, min_angle=25.0, chord_height_relative=0.001)
    print(mesh.report)
    mesh.write("part.ply")
    mq.add_quality_mesh(App.ActiveDocument.Body, min_angle=25.0)

Lengths are in mm, angles in degrees. Errors are MeshQuality.Error and its subclasses; their text
names the sub-element at fault.
"""

import importlib

from .errors import (Cancelled, Error, GeometryError, InvalidInput, IoError, MissingBinary,
                     TopologyError)

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

__all__ = ["Cancelled", "Error", "GeometryError", "InvalidInput", "IoError", "MissingBinary",
           "TopologyError", *_LAZY]


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
    return sorted(set(globals()) | set(_LAZY))
