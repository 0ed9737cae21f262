# SPDX-License-Identifier: LGPL-2.1-or-later
"""Salome's .med and VTK's legacy .vtk, by meshio; .med by FreeCAD's FEM where h5py is missing."""

import os

import numpy as np

from ...errors import IoError
from . import kinds
from .parts import Parts, Section, silent, unsupported

_KINDS = {"line": "line", "triangle": "triangle", "quad": "quadrilateral", "tetra": "tetrahedron", "pyramid": "pyramid",
          "wedge": "prism", "hexahedron": "hexahedron", "VTK_LAGRANGE_CURVE": "line", "VTK_LAGRANGE_TRIANGLE": "triangle",
          "VTK_LAGRANGE_QUADRILATERAL": "quadrilateral", "VTK_LAGRANGE_TETRAHEDRON": "tetrahedron"}


def read(path):
    """The Parts of a file."""
    suffix = os.path.splitext(path)[1].lower()
    try:
        import meshio

        if suffix == ".med":
            import h5py
    except ImportError as error:
        if suffix == ".med" and _has_fem():
            return _by_freecad(path)
        package = "python3-meshio" if error.name != "h5py" else "python3-h5py"
        raise IoError(f"{suffix} files need {error.name}, which is not there: install it (Debian: {package})") from error
    if suffix == ".med":
        if not h5py.is_hdf5(path):
            raise IoError("it is no HDF5 file, which .med files are: write it anew")
        read_by = meshio.med.read
    else:
        read_by = meshio.vtk.read
    try:
        with silent():
            return _parts(read_by(path))
    except meshio.ReadError as error:
        raise IoError(f"meshio cannot read it: {error or 'it is damaged'}; write it anew") from error


def _has_fem():
    try:
        import Fem
    except ImportError:
        return False
    return Fem is not None


def _by_freecad(path):
    import Fem

    from .freecad_mesh import of_fem_mesh

    return of_fem_mesh(Fem.read(path))


def _parts(mesh):
    parts, last = Parts(mesh.points, []), 0
    tags = mesh.cell_data.get("cell_tags", [])
    names = getattr(mesh, "cell_tags", {})
    for i, block in enumerate(mesh.cells):
        nodes, name = np.asarray(block.data), block.type.rstrip("0123456789")
        numbers = np.arange(last + 1, last + 1 + len(nodes))
        last += len(nodes)
        if name == "vertex" or not len(nodes):
            continue
        if name not in _KINDS:
            raise unsupported(f"elements that meshio calls {block.type}")
        kind, count = _KINDS[name], nodes.shape[1]
        if kinds.order_of(kind, count) is None:
            raise unsupported(f"{kinds.PLURALS[kind]} with {count} nodes")
        order = kinds.from_lagrange(kind, count) if name.startswith("VTK") else \
            kinds.from_convention(kind, count, kinds.RINGS)
        parts.sections.append(Section(kind, nodes[:, order], numbers, _entities(mesh, i)))
        for tag, groups in names.items() if i < len(tags) else ():
            for group in groups:
                parts.add_to_group(group, numbers[np.asarray(tags[i]) == tag])
    return parts


def _entities(mesh, block):
    found = mesh.cell_data.get("CellEntityIds")
    return None if found is None else np.maximum(np.asarray(found[block]).reshape(-1).astype(np.int64) - 1, -1)
