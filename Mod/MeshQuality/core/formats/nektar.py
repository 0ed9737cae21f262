# SPDX-License-Identifier: LGPL-2.1-or-later
"""Geometries of Nektar++ (.xml, not compressed): vertices, edges and faces, each once, with the points of those that are
curved, and composites of solids and patches.
"""

import itertools
from xml.sax.saxutils import quoteattr

import numpy as np

from ..elements import kinds, skeleton
from .arrays import element_blocks, points_of


def write(mesh, path, patches, solids, scale):
    """Writes a SurfaceMesh or a CurvedMesh."""
    order, points = getattr(mesh, "order", 1), points_of(mesh, scale)
    volume = len(getattr(mesh, "tetrahedra", ())) > 0
    if volume:
        faces = skeleton.faces_of({"tetrahedron": mesh.tetrahedra, "triangle": mesh.triangles}, order)
        triangles, cells = faces.nodes, _faces_in_order(mesh.tetrahedra, faces)
    else:
        triangles, cells = mesh.triangles, None
    edges = skeleton.edges_of({"triangle": triangles}, order)
    with open(path, "w", encoding="utf-8") as file:
        file.write('<?xml version="1.0" encoding="utf-8" ?>\n<NEKTAR>\n'
                   f'<GEOMETRY DIM="{3 if volume else 2}" SPACE="3">\n')
        _write_list(file, "VERTEX", "V", points[:int(triangles[:, :3].max()) + 1])
        _write_list(file, "EDGE", "E", edges.corners)
        _write_list(file, "FACE" if volume else "ELEMENT", "T", edges.of["triangle"])
        if volume:
            _write_list(file, "ELEMENT", "A", cells)
        if order > 1:
            _write_curves(file, points, edges.nodes, triangles)
        if volume:
            rank = np.unique(mesh.tetrahedron_solid, return_inverse=True)[1]
            known = mesh._curved.tetrahedra_behind() >= 0
            inside = [(name, "A", members) for name, members in element_blocks(solids, rank)]
            rim = [(name, "F", faces.of["triangle"][members[known[members]], 0])
                   for name, members in element_blocks(patches.names, patches.of_triangle)]
        else:
            inside = [(name, "T", members) for name, members in element_blocks(patches.names, patches.of_triangle)]
            rim = _rims(mesh, edges)
        _write_composites(file, inside, [part for part in rim if len(part[2])])
        file.write("</NEKTAR>\n")


def _faces_in_order(tetrahedra, faces):
    """int (E, 4): the faces of each tetrahedron as Nektar++ numbers them: its vertices ascend, which makes the collapsed
    corners of neighbours meet, but the first two change places where it would be the wrong way round.
    """
    place = np.argsort(tetrahedra[:, :4], axis=1)
    odd = np.array([sum(a > b for a, b in itertools.combinations(row, 2)) % 2 for row in place.tolist()], dtype=bool)
    place[odd, :2] = place[odd, 1::-1]
    # Face i of ours is opposite to corner i; theirs are opposite to vertices 3, 2, 0 and 1.
    return np.take_along_axis(faces.of["tetrahedron"], place[:, [3, 2, 0, 1]], axis=1)


def _rims(mesh, edges):
    """[(name, "E", edges), ...]: the ends of a surface by CAD edge."""
    given = getattr(mesh, "edges", np.zeros((0, 2), dtype=np.int64))
    once = np.flatnonzero(np.bincount(edges.of["triangle"].ravel(), minlength=len(edges.corners)) == 1)
    if not len(given) or not len(once):
        return []
    number = {tuple(corners): i for i, corners in zip(once.tolist(), edges.corners[once].tolist())}
    found = {}
    for corners, entity in zip(np.sort(given[:, :2], axis=1).tolist(), mesh.edge_entity.tolist()):
        if tuple(corners) in number:
            found.setdefault(entity, []).append(number[tuple(corners)])
    return [(f"Edge{entity + 1}", "E", np.array(found[entity])) for entity in sorted(found)]


def _write_list(file, title, tag, rows):
    file.write(f"<{title}>\n")
    file.writelines(f'<{tag} ID="{i}">{" ".join(map(repr, row))}</{tag}>\n' for i, row in enumerate(rows.tolist()))
    file.write(f"</{title}>\n")


def _write_curves(file, points, edges, triangles):
    """Points of edges from one end to the other, of faces as evenly spaced nodes: corners, edges, then rows within."""
    order = edges.shape[1] - 1
    along = [0, *range(2, order + 1), 1]
    inner = [(i, j) for j in range(1, order) for i in range(1, order - j)]
    count = kinds.count_of("triangle", order)
    rows = kinds.matching("triangle", count, np.array([(i / order, j / order, 0.0) for i, j in inner]).reshape(-1, 3))
    within = [*range(count - len(inner)), *rows.tolist()]
    file.write("<CURVED>\n")
    for i, nodes in enumerate(edges[:, along]):
        file.write(f'<E ID="{i}" EDGEID="{i}" NUMPOINTS="{order + 1}" TYPE="PolyEvenlySpaced">{_text(points[nodes])}</E>\n')
    for i, nodes in enumerate(triangles[:, within]):
        file.write(f'<F ID="{len(edges) + i}" FACEID="{i}" NUMPOINTS="{count}" TYPE="NodalTriEvenlySpaced">'
                   f'{_text(points[nodes])}</F>\n')
    file.write("</CURVED>\n")


def _text(points):
    return "   ".join(f"{x!r} {y!r} {z!r}" for x, y, z in points.tolist())


def _write_composites(file, inside, rim):
    file.write("<COMPOSITE>\n")
    for i, (name, tag, members) in enumerate([*inside, *rim]):
        file.write(f'<C ID="{i}" NAME={quoteattr(name)}> {tag}[{_ranges(members)}] </C>\n')
    used = f"0-{len(inside) - 1}" if len(inside) > 1 else "0"
    file.write(f'</COMPOSITE>\n<DOMAIN>\n<D ID="0"> C[{used}] </D>\n</DOMAIN>\n</GEOMETRY>\n<EXPANSIONS>\n')
    for i in range(len(inside)):
        file.write(f'<E COMPOSITE="C[{i}]" NUMMODES="4" TYPE="MODIFIED" FIELDS="u" />\n')
    file.write("</EXPANSIONS>\n")


def _ranges(members):
    """"0-4,7" of numbers."""
    numbers = np.unique(members)
    parts = np.split(numbers, np.flatnonzero(np.diff(numbers) > 1) + 1)
    return ",".join(f"{part[0]}-{part[-1]}" if len(part) > 1 else str(part[0]) for part in parts)
