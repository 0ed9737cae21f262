# SPDX-License-Identifier: LGPL-2.1-or-later
"""Salome's .med by h5py, or by FreeCAD's FEM where that is missing; the first mesh in it, at its first step."""

import importlib.util

import numpy as np

from ...errors import IoError
from ..elements import kinds
from ..elements.freecad_mesh import of_fem_mesh
from ..elements.parts import REMEDY, Parts, count_within, hdf5, unsupported, words_of

_TYPES = {"SE2": "line", "SE3": "line", "TR3": "triangle", "TR6": "triangle", "QU4": "quadrilateral", "QU8": "quadrilateral",
          "QU9": "quadrilateral", "TE4": "tetrahedron", "T10": "tetrahedron", "PY5": "pyramid", "P13": "pyramid",
          "PE6": "prism", "P15": "prism", "P18": "prism", "HE8": "hexahedron", "H20": "hexahedron", "H27": "hexahedron"}
_POINT = "PO1"


def read(path):
    """The Parts of a file."""
    if importlib.util.find_spec("h5py") is None and importlib.util.find_spec("Fem") is not None:
        import Fem
        return of_fem_mesh(Fem.read(path))
    with hdf5(path, "files of Salome") as file:
        return _parts(file)


def _parts(file):
    if "ENS_MAA" not in file or not len(file["ENS_MAA"]):
        raise IoError("it has no mesh (ENS_MAA): write the mesh into it")
    names = list(file["ENS_MAA"])
    mesh = file["ENS_MAA"][names[0]]
    step = mesh if "NOE" in mesh else mesh[next(iter(mesh))]
    if "NOE" not in step or "MAI" not in step:
        raise IoError("its mesh has no nodes or no elements: write the mesh into it")
    parts = Parts(_columns(step["NOE"]["COO"], "nodes"), [])
    if len(names) > 1:
        parts.notes.append(f"{len(names):,} meshes in the file, of which {names[0]!r} was read")
    families = _families(file, mesh, names[0])
    for name, table in step["MAI"].items():
        if name == _POINT:
            continue
        if name not in _TYPES:
            raise unsupported(f"elements of type {name}")
        kind, nodes = _TYPES[name], _columns(table["NOD"], "elements").astype(np.int64) - 1
        if kinds.order_of(kind, nodes.shape[1]) not in (1, 2):
            raise IoError(f"elements of type {name} have {nodes.shape[1]} nodes: {REMEDY}")
        numbers = parts.add(kind, nodes[:, kinds.from_mirrored(kind, nodes.shape[1])])
        if "FAM" in table:
            family = table["FAM"][()]
            for tag in np.unique(family).tolist():
                for group in families.get(tag, ()):
                    parts.add_to_group(group, numbers[family == tag])
    return parts


def _columns(dataset, what):
    """The rows of a table that is stored column by column."""
    count = count_within(dataset.attrs["NBR"], dataset.size, what)
    if not count or dataset.size % count:
        raise IoError(f"the number of its {what} does not fit: {REMEDY}")
    return dataset[()].reshape(-1, count).T


def _families(file, mesh, name):
    """{family: names of its groups}."""
    found = {}
    home = mesh["FAS"] if "FAS" in mesh else file.get(f"FAS/{name}", {})
    for family in (home["ELEME"].values() if "ELEME" in home else ()):
        if "GRO" in family:
            rows = family["GRO"]["NOM"][()]
            rows = np.frombuffer(rows.tobytes(), dtype="S1").reshape(len(rows), -1)
            found[int(family.attrs["NUM"])] = [words_of(row.tobytes().split(b"\0")[0]) for row in rows]
    return found
