# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places in the 3D view: the sub-element that a CAD face is, and a mark at a triangle."""

import FreeCADGui
import Part
from pivy import coin

from ..core.sources import convert, frames

_NEAR = 1e-6  # share of the size within which points are the same
_COLOUR, _WIDTH = (1.0, 0.125, 1.0), 4.0  # the colour of lit elements in the quality view; pixels


def sub_element(source, face):
    """The path in the source to its face "Face7": in a container the faces are counted through all
    that it holds, "Box.Face1" is one of them.
    """
    obj, start = frames.object_of(source), frames.path_of(source)
    leaves = [start + path for path in frames.leaf_paths(frames.leaf_of(source))]
    if not leaves:
        return start + face
    shape = convert.own_shape_of(source)
    wanted, near = shape.getElement(face), _NEAR * max(shape.BoundBox.DiagonalLength, 1.0)
    for path in leaves:
        for i, other in enumerate(Part.getShape(obj, path).Faces, 1):
            if _alike(wanted, other, near):
                return f"{path}Face{i}"
    return ""


def select_face(source, face):
    """Selects the face "Face7" of a source in the 3D view, also inside of containers."""
    obj, path = frames.path_from_root((frames.object_of(source), sub_element(source, face)))
    FreeCADGui.Selection.addSelection(obj, path)


def _alike(face, other, near):
    """Whether it is the same face in the same place; containers place it anew each time."""
    if not face.isPartner(other) or (face.CenterOfMass - other.CenterOfMass).Length > near:
        return False
    return all((a.Point - b.Point).Length <= near for a, b in zip(face.Vertexes, other.Vertexes))


class Mark:
    """The outline of a triangle, drawn over all else in a 3D view until `end`."""

    def __init__(self, view, corners):
        self.node = coin.SoAnnotation()
        light, colour, style = coin.SoLightModel(), coin.SoBaseColor(), coin.SoDrawStyle()
        light.model = coin.SoLightModel.BASE_COLOR
        colour.rgb = _COLOUR
        style.lineWidth = _WIDTH
        points, line = coin.SoCoordinate3(), coin.SoLineSet()
        points.point.setValues(0, 4, [tuple(corner) for corner in (*corners, corners[0])])
        for node in (light, colour, style, points, line):
            self.node.addChild(node)
        self._graph = view.getSceneGraph()
        self._graph.addChild(self.node)

    def end(self):
        """Draws it no longer."""
        self._graph.removeChild(self.node)
