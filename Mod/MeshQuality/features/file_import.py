# SPDX-License-Identifier: LGPL-2.1-or-later
"""File > Import: meshes of files as objects of the FEM workbench, with their groups."""

import os

import FreeCAD

from ..core.fem import fem
from ..core.meshes.element_mesh import read_mesh
from . import file_settings
from .gui_hooks import window
from .transactions import undo_step


def name_of(path):
    """What a document or an object is called after a file."""
    return os.path.splitext(os.path.basename(path))[0]


def add(path, document):
    """Adds a Fem::FemMeshObject with the elements and the groups in a file; one undo step. Returns it."""
    fem.module()
    mesh = read_mesh(path, scale=1.0 / file_settings.scale())
    elements = fem.elements_of_mesh(mesh)
    with undo_step(document, "Import"):
        obj = document.addObject("Fem::FemMeshObject", "Mesh")
        obj.Label = name_of(path)
        obj.FemMesh = fem.mesh_of(elements)
        obj.purgeTouched()
    FreeCAD.Console.PrintMessage(f"{obj.Label}: {repr(mesh).strip('<>')}\n")
    for fault in mesh.faults:
        FreeCAD.Console.PrintWarning(f"{obj.Label}: {window().translated(fault)}\n")
    return obj
