# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gmsh's .msh 4.1 as text: an entity for the elements that are of the same CAD entity and in the same groups."""

import numpy as np

from ..elements import gmsh_file, kinds
from .numbered import lines

TYPES = {known: number for number, known in gmsh_file.TYPES.items()}

BOUNDARIES = 2  # how many lower dimensions are elements, too


class _Entities:
    """The entities of one dimension: tag of each by number, and the number of each element by block."""

    def __init__(self, mesh, dimension, physical):
        self.of_block = {i: mesh.geometry[i].astype(np.int64) + 1 for i, (kind, _) in enumerate(mesh.blocks)
                         if kinds.DIMENSION[kind] == dimension}
        used = np.unique(np.concatenate([np.zeros(0, dtype=np.int64), *self.of_block.values()]))
        self.physical, last = {tag: [] for tag in used.tolist()}, int(used.max(initial=0))
        for name, parts in mesh.groups_of(dimension).items():
            made = {}  # the entity of those that are in this group, too
            for i, rows in parts:
                tags, place = np.unique(self.of_block[i][rows], return_inverse=True)
                for tag in tags.tolist():
                    if tag not in made:
                        last += 1
                        made[tag], self.physical[last] = last, [*self.physical[tag], physical[name]]
                self.of_block[i][rows] = np.array([made[tag] for tag in tags.tolist()])[place.ravel()]
        self._name_as_before()

    def _name_as_before(self):
        """Numbers that no element has any more go; an entity that has all elements of a CAD entity gets its number."""
        values = np.concatenate([np.zeros(0, dtype=np.int64), *self.of_block.values()])
        used = np.unique(values)
        number = {tag: i for i, tag in enumerate(used.tolist(), 1)}
        table = np.zeros(int(used.max(initial=0)) + 1, dtype=np.int64)
        table[used] = np.arange(1, len(used) + 1)
        self.of_block = {i: table[tags] for i, tags in self.of_block.items()}
        self.physical = {number[tag]: names for tag, names in self.physical.items() if tag in number}


def write(mesh, path):
    """Writes a Numbered mesh."""
    physical = {dimension: {name: i for i, name in enumerate(mesh.groups_of(dimension), 1)} for dimension in (1, 2, 3)}
    entities = [_Entities(mesh, dimension, physical[dimension]) for dimension in (1, 2, 3)]
    with open(path, "w", encoding="utf-8") as file:
        file.write("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n")
        names = [f'{dimension} {i} "{name}"\n' for dimension, found in physical.items() for name, i in found.items()]
        if names:
            file.write(f"$PhysicalNames\n{len(names)}\n{''.join(names)}$EndPhysicalNames\n")
        blocks = _blocks(mesh, entities)
        _write_entities(file, mesh, entities, blocks)
        top, count = entities[mesh.dimension - 1], len(mesh.points)
        file.write(f"$Nodes\n1 {count} 1 {count}\n{mesh.dimension} {min(top.physical)} 0 {count}\n")
        file.write(lines(np.arange(1, count + 1)[:, None]))
        file.write(lines(mesh.points))
        total = mesh.first[-1] - 1
        file.write(f"$EndNodes\n$Elements\n{len(blocks)} {total} 1 {total}\n")
        for (dimension, tag), block, rows in blocks:
            kind, nodes = mesh.blocks[block]
            file.write(f"{dimension} {tag} {TYPES[kind, nodes.shape[1]]} {len(rows)}\n")
            file.write(lines(np.column_stack([rows + mesh.first[block], nodes[rows] + 1])))
        file.write("$EndElements\n")


def _blocks(mesh, entities):
    """[((dimension, entity), block, rows), ...] of all elements."""
    found = []
    for dimension, own in enumerate(entities, 1):
        for i, tags in own.of_block.items():
            order = np.argsort(tags, kind="stable")
            for part in np.split(order, np.flatnonzero(np.diff(tags[order])) + 1):
                if len(part):
                    found.append(((dimension, int(tags[part[0]])), i, part))
    return found


def _write_entities(file, mesh, entities, blocks):
    boxes = {}
    for entity, i, rows in blocks:
        points = mesh.points[mesh.blocks[i][1][rows]].reshape(-1, 3)
        boxes.setdefault(entity, []).extend([points.min(axis=0), points.max(axis=0)])
    file.write(f"$Entities\n0 {' '.join(str(len(own.physical)) for own in entities)}\n")
    for dimension, own in enumerate(entities, 1):
        for tag, names in own.physical.items():
            corners = np.array(boxes[dimension, tag])
            box = " ".join(map(repr, [*corners.min(axis=0).tolist(), *corners.max(axis=0).tolist()]))
            file.write(f"{tag} {box} {len(names)}{''.join(f' {i}' for i in names)} 0\n")
    file.write("$EndEntities\n")
