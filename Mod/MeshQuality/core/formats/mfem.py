# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of MFEM (mesh v1.0): curved elements as nodes of the continuous space H1 of the mesh's order."""

import numpy as np

from ..elements import kinds, lagrange, skeleton
from .arrays import points_of
from .completion import completed
from .sides import faces_of_groups

_TYPES = {"line": 1, "triangle": 2, "quadrilateral": 3, "tetrahedron": 4, "hexahedron": 5, "prism": 6, "pyramid": 7}
# (kind, nodes) that write_elements takes: of order 2 with or without nodes amid quadrilaterals.
TYPES = frozenset((kind, count) for kind, counts in {
    "tetrahedron": (4, 10), "pyramid": (5, 13, 14), "prism": (6, 15, 18), "hexahedron": (8, 20, 27)}.items() for count in counts)
# Edges and quadrilaterals of elements as MFEM goes through them (fem/geom.cpp).
_EDGES = {
    "tetrahedron": skeleton.EDGES["tetrahedron"],
    "pyramid": ((0, 1), (1, 2), (3, 2), (0, 3), (0, 4), (1, 4), (2, 4), (3, 4)),
    "prism": ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)),
    "hexahedron": ((0, 1), (1, 2), (3, 2), (0, 3), (4, 5), (5, 6), (7, 6), (4, 7), (0, 4), (1, 5), (2, 6), (3, 7)),
}
_QUADRILATERALS = {
    "tetrahedron": (), "pyramid": ((3, 2, 1, 0),), "prism": ((0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
    "hexahedron": ((3, 2, 1, 0), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7)),
}


def write(mesh, path, patches, solids, scale):
    """Writes a SurfaceMesh or a CurvedMesh: attributes are solids of a volume and patches of a surface, those of the
    boundary patches of a volume and CAD edges at the ends of a surface.
    """
    volume = len(getattr(mesh, "tetrahedra", ())) > 0
    kind, elements = ("tetrahedron", mesh.tetrahedra) if volume else ("triangle", mesh.triangles)
    attributes = mesh.tetrahedron_solid if volume else patches.of_triangle
    order, points = getattr(mesh, "order", 1), points_of(mesh, scale)
    edges = skeleton.edges_of({kind: elements}, order)
    faces = skeleton.faces_of({kind: elements}, order) if volume else None
    rim = _outer_triangles(mesh, patches) if volume else _outer_edges(mesh, edges)
    corners = int(elements[:, :4 if volume else 3].max()) + 1
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"MFEM mesh v1.0\n\n{_names(mesh, patches, solids)}\ndimension\n{3 if volume else 2}\n")
        _write_elements(file, "elements", [(kind, elements, attributes)])
        _write_elements(file, "boundary", [("triangle" if volume else "line", *rim)])
        file.write(f"\nvertices\n{corners}\n")
        if order == 1:
            file.write("3\n")
            _write_rows(file, points[:corners])
            return
        file.write(f"\nnodes\nFiniteElementSpace\nFiniteElementCollection: H1_{3 if volume else 2}D_P{order}\n"
                   "VDim: 3\nOrdering: 1\n\n")
        _write_rows(file, points[:corners])
        _write_rows(file, _inside("line", order, points[edges.nodes]))
        if volume:
            _write_rows(file, _inside_faces(order, points, faces))
        _write_rows(file, _inside(kind, order, points[elements]))


def write_elements(mesh, path, scale):
    """Writes the volumes of an ElementMesh, all of order 1 or all of order 2. Their attributes are the CAD volumes that the mesh knows of,
    else groups; those of the boundary are groups of faces, named in comments.
    """
    blocks = [block for block in mesh.blocks if kinds.DIMENSION[block.kind] == 3]
    known = all((block.geometry >= 0).all() for block in blocks)
    rest = len(mesh.groups)  # attribute, from 0, of what is in no group
    points, volumes = completed(mesh.nodes * scale, [(block.kind, block.nodes) for block in blocks])
    corners = [nodes[:, :kinds.CORNERS[kind]] for kind, nodes in volumes]
    used = np.unique(np.concatenate([rows.ravel() for rows in corners]))
    number = np.zeros(len(points), dtype=np.int64)
    number[used] = np.arange(len(used))
    faces = faces_of_groups(mesh)
    names = list(dict.fromkeys(name for name, _ in faces))
    with open(path, "w", encoding="utf-8") as file:
        named = [] if known else [f"# attribute {i + 1}: {name}\n" for i, name in enumerate(mesh.groups) if any((block.group == i).any() for block in blocks)]
        named += [f"# boundary attribute {i + 1}: {name}\n" for i, name in enumerate(names)]
        file.write("MFEM mesh v1.0\n\n" + "".join(named) + "\ndimension\n3\n")
        _write_elements(file, "elements", [(kind, number[rows], block.geometry if known else np.where(block.group < 0, rest, block.group))
                                           for (kind, _), rows, block in zip(volumes, corners, blocks)])
        _write_elements(file, "boundary", [("triangle" if rows.shape[1] == 3 else "quadrilateral", number[rows],
                                            np.full(len(rows), names.index(name))) for name, rows in faces])
        file.write(f"\nvertices\n{len(used)}\n")
        if all(block.order == 1 for block in blocks):
            file.write("3\n")
            _write_rows(file, points[used])
            return
        # Pyramids of 14 nodes, like ours; by itself MFEM from 4.8 on takes those of 15.
        suffix = "_Pyr0" if any(kind == "pyramid" for kind, _ in volumes) else ""
        file.write(f"\nnodes\nFiniteElementSpace\nFiniteElementCollection: H1_3D_P2{suffix}\nVDim: 3\nOrdering: 1\n\n")
        _write_rows(file, points[used])
        _write_rows(file, points[_first_of(volumes, _EDGES)])
        _write_rows(file, points[_first_of(volumes, _QUADRILATERALS)])
        _write_rows(file, points[np.concatenate([np.zeros(0, dtype=np.int64), *(nodes[:, -1] for kind, nodes in volumes if kind == "hexahedron")])])


def _write_elements(file, title, parts):
    """A list of elements, [(kind, their nodes, attributes from 0), ...]."""
    file.write(f"\n{title}\n{sum(len(elements) for _, elements, _ in parts)}\n")
    for kind, elements, attributes in parts:
        rows = np.column_stack([attributes + 1, np.full(len(elements), _TYPES[kind]), elements[:, :kinds.CORNERS[kind]]])
        file.writelines(" ".join(map(str, row)) + "\n" for row in rows.tolist())


def _first_of(volumes, table):
    """int (n,): the nodes of order 2 amid edges or quadrilaterals, each once, in the order in which elements first have them."""
    found = []
    for kind, nodes in volumes:
        places = kinds.places(kind, nodes.shape[1])
        amid = [kinds.matching(kind, nodes.shape[1], places[list(side)].mean(axis=0)[None])[0] for side in table[kind]]
        found.append(nodes[:, amid].ravel())
    found = np.concatenate(found).astype(np.int64)
    return found[np.sort(np.unique(found, return_index=True)[1])]


def _names(mesh, patches, solids):
    """Which attribute has which name, as comments: the format has no place for them."""
    patch = "boundary attribute" if solids else "attribute"
    numbers = sorted(set(mesh.tetrahedron_solid.tolist())) if solids else []
    return "".join([*(f"# attribute {i + 1}: {name}\n" for i, name in zip(numbers, solids)),
                    *(f"# {patch} {i + 1}: {name}\n" for i, name in enumerate(patches.names))])


def _outer_triangles(mesh, patches):
    """The triangles that are faces of tetrahedra, and the patch of each."""
    known = mesh._curved.tetrahedra_behind() >= 0
    return mesh.triangles[known], patches.of_triangle[known]


def _outer_edges(mesh, edges):
    """The mesh edges with one triangle that lie on CAD edges, and the number of each."""
    given = getattr(mesh, "edges", np.zeros((0, 2), dtype=np.int64))
    if not len(given):
        return np.zeros((0, 2), dtype=np.int64), np.zeros(0, dtype=np.int64)
    number, count = edges.of["triangle"], len(edges.corners)
    outer = edges.corners[np.bincount(number.ravel(), minlength=count) == 1]
    size = int(edges.corners.max()) + 1
    keys = np.sort(given[:, :2].astype(np.int64), axis=1) @ [size, 1]
    known = np.isin(keys, outer.astype(np.int64) @ [size, 1])
    return given[known], mesh.edge_entity[known]


def _write_rows(file, points):
    file.writelines(f"{x!r} {y!r} {z!r}\n" for x, y, z in points.tolist())


def closed_points(order):
    """float64 (order + 1,): the Gauss-Lobatto points of [0, 1], where MFEM has the nodes of an edge."""
    inner = np.polynomial.legendre.Legendre.basis(order).deriv().roots()
    found = np.concatenate([[0.0], (np.sort(inner.real) + 1.0) / 2.0, [1.0]])
    return (found + 1.0 - found[::-1]) / 2.0  # exactly symmetric


def inner_shares(kind, order):
    """float64 (n, corners): barycentric coordinates of MFEM's nodes inside of an element, in its order."""
    points, dimension = closed_points(order), {"line": 1, "triangle": 2, "tetrahedron": 3}[kind]
    steps = np.array([step[::-1] for step in np.ndindex(*[order] * dimension)
                      if all(step) and sum(step) < order], dtype=int).reshape(-1, dimension)
    found = points[np.column_stack([order - steps.sum(axis=1), steps])]
    return found / found.sum(axis=1, keepdims=True)


def _inside(kind, order, nodes):
    """float64 (n, 3): where MFEM has the nodes inside of elements with these nodes."""
    values = lagrange.values(kind, order, inner_shares(kind, order))
    return np.einsum("ij,njk->nik", values, nodes).reshape(-1, 3)


def _inside_faces(order, points, faces):
    """Likewise for faces, which have the direction that their first tetrahedron gives them."""
    shares = inner_shares("triangle", order)
    found = np.zeros((len(faces.corners), len(shares), 3))
    for turn in skeleton.TURNS[3]:
        which = (faces.corners[:, turn] == faces.first).all(axis=1)
        values = lagrange.values("triangle", order, shares[:, np.argsort(turn)])
        found[which] = np.einsum("ij,njk->nik", values, points[faces.nodes[which]])
    return found.reshape(-1, 3)
