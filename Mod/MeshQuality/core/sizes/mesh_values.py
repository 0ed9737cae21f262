# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sizes that are known on meshes: nodes, simplices of them, and a size at each node."""

import os

import numpy as np

from ...errors import Error, InvalidInput, IoError
from ..elements import kinds

# Names by which an array of a file is taken for sizes, in this order; else the only one there is.
NAMES = ("size", "sizes", "h", "mesh_size", "element_size")
# Simplices into which an element is divided, by its corners.
_SIMPLICES = {
    "line": ((0, 1),), "triangle": ((0, 1, 2),), "quadrilateral": ((0, 1, 2), (0, 2, 3)), "tetrahedron": ((0, 1, 2, 3),),
    "pyramid": ((0, 1, 2, 4), (0, 2, 3, 4)), "prism": ((0, 1, 2, 3), (1, 2, 3, 4), (2, 3, 4, 5)),
    "hexahedron": ((0, 1, 3, 4), (1, 2, 3, 6), (1, 3, 4, 6), (1, 4, 5, 6), (3, 4, 6, 7)),
}


def of_mesh(mesh, values):
    """(nodes, simplices, sizes) of a mesh of ours with a value by node, or by element."""
    from ..meshes.element_mesh import ElementMesh

    mesh = ElementMesh.of(mesh)
    values = np.asarray(values, dtype=np.float64)
    blocks = [(block.kind, block.nodes) for block in mesh.blocks]
    return _arrays(mesh.nodes, blocks, values, "size_field")


def of_result(result):
    """The same of a FEM result object of FreeCAD that has an array of sizes: its property Size, or MeshSize."""
    mesh = getattr(result, "Mesh", None)
    for name in ("Size", "MeshSize"):
        values = getattr(result, name, None)
        if values and mesh is not None:
            return of_mesh(mesh, np.asarray(values, dtype=np.float64))
    raise InvalidInput(f"{result.Label} has no sizes: a result that gives a size field has a property Size with a number for each "
                       "node; for sizes by the error of a solution use mq.adapt")


def of_file(path):
    """The same of a file with a mesh and an array of sizes; `path#name` names the array."""
    path, _, wanted = path.partition("#")
    if not os.path.isfile(path):
        raise IoError(f"cannot read '{path}': there is no such file")
    suffix = os.path.splitext(path)[1].lower()
    try:
        if suffix == ".pos":
            return _of_pos(path)
        points, blocks, arrays = (of_frd if suffix == ".frd" else _of_meshio)(path)
    except Error:
        raise
    except Exception as error:  # of libraries, or a damaged file
        raise IoError(f"cannot read '{path}' as a mesh with sizes: {' '.join(str(error).split())[:200]}") from error
    return _arrays(points, blocks, _chosen(arrays, wanted, path), f"'{path}'")


def _chosen(arrays, wanted, path):
    """The array that has the sizes."""
    if wanted:
        if wanted not in arrays:
            raise InvalidInput(f"'{path}' has no array {wanted}: it has {', '.join(arrays) or 'none'}")
        return arrays[wanted]
    by_name = {name.lower(): values for name, values in arrays.items()}
    for name in NAMES:
        if name in by_name:
            return by_name[name]
    if len(arrays) == 1:
        return next(iter(arrays.values()))
    raise InvalidInput(f"'{path}' has {'no array' if not arrays else 'the arrays ' + ', '.join(arrays)}: name that with the sizes "
                       f"'size', or give '{os.path.basename(path)}#NAME'")


def _arrays(points, blocks, values, name):
    """Nodes, simplices of the highest dimension and sizes by node of blocks (kind, nodes); of values by element those at a node are the
    mean of the elements around.
    """
    blocks = [(kind, np.asarray(nodes)) for kind, nodes in blocks]
    if values.ndim != 1:
        raise InvalidInput(f"{name}: the array of sizes has the shape {values.shape}: give one number for each node or element")
    if not blocks:
        raise InvalidInput(f"{name} has no elements")
    dimension = max(kinds.DIMENSION[kind] for kind, _ in blocks)
    elements = sum(len(nodes) for _, nodes in blocks)
    highest = [(kind, nodes) for kind, nodes in blocks if kinds.DIMENSION[kind] == dimension]
    count = sum(len(nodes) for _, nodes in highest)
    if len(values) == len(points):
        sizes = values
    elif len(values) in (elements, count):
        if len(values) == elements:
            starts = np.cumsum([0, *(len(nodes) for _, nodes in blocks)])
            values = np.concatenate([values[start:start + len(nodes)] for start, (kind, nodes) in zip(starts, blocks)
                                     if kinds.DIMENSION[kind] == dimension])
        sizes = _by_node(len(points), highest, values)
    else:
        raise InvalidInput(f"{name}: {len(values)} sizes for {len(points)} nodes and {elements} elements: give one for each node or "
                           "each element")
    simplices = [_simplices(kind, nodes) for kind, nodes in highest]
    return np.ascontiguousarray(points, dtype=np.float64), np.concatenate(simplices), np.ascontiguousarray(sizes)


def _simplices(kind, nodes):
    rows = np.concatenate([nodes[:, list(part)] for part in _SIMPLICES[kind]]).astype(np.int32)
    return np.pad(rows, ((0, 0), (0, 4 - rows.shape[1])), constant_values=-1)


def _by_node(count, blocks, values):
    sums, weights, first = np.zeros(count), np.zeros(count), 0
    for _, nodes in blocks:
        own = values[first:first + len(nodes)]
        first += len(nodes)
        np.add.at(sums, nodes.ravel(), np.repeat(own, nodes.shape[1]))
        np.add.at(weights, nodes.ravel(), 1.0)
    mean = float(values.mean()) if len(values) else 1.0
    return np.where(weights > 0, sums / np.maximum(weights, 1), mean)  # nodes without elements are of no simplex


_OF_MESHIO = {"line": "line", "triangle": "triangle", "quad": "quadrilateral", "tetra": "tetrahedron", "pyramid": "pyramid",
              "wedge": "prism", "hexahedron": "hexahedron", "line3": "line", "triangle6": "triangle", "quad8": "quadrilateral",
              "quad9": "quadrilateral", "tetra10": "tetrahedron", "wedge15": "prism", "hexahedron20": "hexahedron",
              "hexahedron27": "hexahedron"}


def _of_meshio(path):
    """Points, blocks, and {name: array} of a file that meshio reads."""
    try:
        import meshio
    except ImportError as error:
        raise IoError(f"cannot read sizes from '{path}': meshio is not installed in FreeCAD's Python (pip install meshio); CSV files "
                      "with x, y, z, size, and .frd and .pos files, need nothing") from error
    mesh = meshio.read(path)
    blocks = [(_OF_MESHIO[block.type], block.data) for block in mesh.cells if block.type in _OF_MESHIO]
    arrays = {name: np.asarray(values, dtype=np.float64) for name, values in mesh.point_data.items()
              if np.ndim(values) == 1 or np.shape(values)[-1] == 1}
    kept = [i for i, block in enumerate(mesh.cells) if block.type in _OF_MESHIO]
    for name, parts in mesh.cell_data.items():
        if not name.startswith("gmsh:") and all(np.ndim(parts[i]) == 1 for i in kept):
            arrays.setdefault(name, np.concatenate([np.asarray(parts[i], dtype=np.float64) for i in kept]))
    points = np.asarray(mesh.points, dtype=np.float64)
    return np.pad(points, ((0, 0), (0, 3 - points.shape[1]))), blocks, {name: values.ravel() for name, values in arrays.items()}


# CalculiX's numbers of element types, and how many nodes each has.
_FRD_TYPES = {1: ("hexahedron", 8), 2: ("prism", 6), 3: ("tetrahedron", 4), 4: ("hexahedron", 20), 5: ("prism", 15),
              6: ("tetrahedron", 10), 7: ("triangle", 3), 8: ("triangle", 6), 9: ("quadrilateral", 4), 10: ("quadrilateral", 8),
              11: ("line", 2), 12: ("line", 3)}


def of_frd(path):
    """The same of CalculiX's results, text; arrays are the components of the last step, by name."""
    nodes, elements, arrays, state, names, dataset = {}, {}, {}, "", [], ""
    kind, count, corners = "", 0, []
    with open(path, encoding="latin-1") as file:
        for line in file:
            code = line[:3].strip()
            if line[:6].strip() in ("2C", "3C"):
                state = line[:6].strip()
            elif code == "-3":
                state = ""
            elif code == "-4":
                dataset, names, state = line.split()[1], [], "values"
            elif code == "-5" and state == "values":
                names.append(line.split()[1])
            elif code == "-1" and state == "2C":
                nodes[int(line[3:13])] = [float(line[13 + 12 * i:25 + 12 * i]) for i in range(3)]
            elif code == "-1" and state == "3C":
                number = int(line[13:18])
                if number not in _FRD_TYPES:
                    raise IoError(f"elements of type {number} are not known")
                (kind, count), corners = _FRD_TYPES[number], []
                elements.setdefault((kind, count), []).append(corners)
            elif code == "-2" and state == "3C":
                corners += [int(line[3 + 10 * i:13 + 10 * i]) for i in range((len(line.rstrip()) - 3 + 9) // 10)]
            elif code == "-1" and state == "values":
                node, text = int(line[3:13]), line[13:].rstrip("\n")
                for i, name in enumerate(names):
                    if text[12 * i:12 * i + 12].strip():
                        arrays.setdefault(name if len(names) > 1 else dataset, {})[node] = float(text[12 * i:12 * i + 12])
    if not nodes:
        raise IoError(f"cannot read '{path}': it has no nodes; CalculiX writes text unless OUTPUT=ASCII is changed")
    row = {number: i for i, number in enumerate(nodes)}
    blocks = [(kind, np.array([[row[n] for n in corners] for corners in of_kind])) for (kind, _), of_kind in elements.items()]
    columns = {name: np.array([values.get(number, np.nan) for number in nodes]) for name, values in arrays.items()}
    return np.array(list(nodes.values())), blocks, columns


_POS_KINDS = {"SP": 1, "SL": 2, "ST": 3, "SS": 4}


def _of_pos(path):
    """Nodes, simplices and sizes of a parsed view of Gmsh: SP, SL, ST and SS of scalars."""
    import re

    with open(path, encoding="latin-1") as file:
        text = file.read()
    points, simplices, sizes = [], [], []
    for kind, places, values in re.findall(r"\b(S[PLTS])\s*\(([^)]*)\)\s*\{([^}]*)\}", text):
        corners = _POS_KINDS[kind]
        at = np.array([float(word) for word in places.split(",")]).reshape(-1, 3)
        own = [float(word) for word in values.split(",")][:corners]
        if len(at) != corners or len(own) != corners:
            raise IoError(f"cannot read '{path}': {kind}({places[:60]}) has {len(at)} points and {len(own)} values")
        first = len(points)
        points.extend(at)
        sizes.extend(own)
        simplices.append([first + i if i < corners else -1 for i in range(4)])
    if not points:
        raise IoError(f"cannot read '{path}': it has no scalar points, lines, triangles or tetrahedra (SP, SL, ST, SS)")
    highest = max(sum(v >= 0 for v in simplex) for simplex in simplices)
    kept = [simplex for simplex in simplices if sum(v >= 0 for v in simplex) == highest]
    return np.array(points), np.array(kept, dtype=np.int32), np.array(sizes)
