# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a B-rep promises of every mesh of it."""

import Part


def euler(shape):
    """V - E + F of the faces, where one whose boundary falls into n parts counts 2 - n."""
    faces = Part.makeCompound(shape.Faces)
    edges = [edge for edge in faces.Edges if not edge.Degenerated]
    return len(faces.Vertexes) - len(edges) + sum(2 - boundary_parts(f) for f in faces.Faces)


def boundary_parts(face):
    """The number of the face's wires, those that touch in a vertex counted as one."""
    parts = []
    for wire in face.Wires:
        part = {vertex.hashCode() for vertex in wire.Vertexes}
        touching = [other for other in parts if other & part]
        parts = [other for other in parts if not other & part] + [part.union(*touching)]
    return len(parts)
