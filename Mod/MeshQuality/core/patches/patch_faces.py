# SPDX-License-Identifier: LGPL-2.1-or-later
"""A shape whose faces are the patches of a mesh: each has the triangles of its patch in place of a surface, so that
whoever meshes the shape gets these triangles, as they are.
"""

import numpy as np

from ..sources import convert

# A face of two shapes: a vertex, by which programs tell faces apart, inside of a face that has triangles alone.
_FACE = """Ve
1e-07
{point}
0 0

0101101
*
Fa
0 1e-07 0 0
2 {number}

1101000
i{vertex} 0 *
"""
_TEXT = """
CASCADE Topology V1, (c) Matra-Datavision
Locations 0
Curve2ds 0
Curves 0
Polygon3D 0
PolygonOnTriangulations 0
Surfaces 0
Triangulations {count}
{triangulations}
TShapes {shapes}
{faces}Co

1100000
{members}*

+1 0 """


def shape_of(points, triangles, of_triangle):
    """A Part.Compound with one face for each patch that has triangles, by the number of the patch.

    points       (n, 3) in mm
    of_triangle  by triangle the number of its patch

    FreeCAD saves shapes without their triangles: what keeps such a shape in a document makes it anew.
    """
    import Part

    numbers = np.unique(of_triangle).tolist()
    shapes = 2 * len(numbers) + 1  # the format numbers them backwards
    triangulations, faces = [], []
    for i, number in enumerate(numbers):
        own = triangles[of_triangle == number]
        used, corners = np.unique(own, return_inverse=True)
        triangulations.append(f"{len(used)} {len(own)} 0 0\n{_words(points[used])}\n{_words(corners + 1)}\n")
        faces.append(_FACE.format(point=_words(points[own[0, 0]]), number=i + 1, vertex=shapes - 2 * i))
    members = "".join(f"+{shapes - 2 * i - 1} 0 " for i in range(len(numbers)))
    shape = Part.Shape()
    shape.importBrepFromString(_TEXT.format(count=len(numbers), triangulations="".join(triangulations), shapes=shapes,
                                            faces="".join(faces), members=members))
    return shape


def _words(numbers):
    return " ".join(map(repr, convert.lists(np.ravel(numbers))))
