# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where FEM meshes of a document lie on their parts.

FreeCAD's FEM workbench makes meshes where the part's own placement has it, without the containers around it; other
programs give them back where the document has the part. Both are meshes of it: the one that lies on it is meant.
"""

import FreeCAD
import numpy as np

from . import convert, frames
from .element_mesh import ElementMesh


def shape_at(source, mesh, part):
    """The shape of a part where a mesh has it.

    source  what the ElementMesh `mesh` is of: where this is no object of a document, the part is where the document has it
    """
    shape = convert.shape_of(part)
    motion = _motion(source, mesh, part, shape.BoundBox)
    if not frames.is_identity(motion):
        shape = shape.copy()
        shape.transformShape(motion.inverse().toMatrix(), False)
    return shape


def mesh_at(source, part):
    """The ElementMesh of a document object with a FEM mesh on its part, where the document has that."""
    mesh = ElementMesh.of(source)
    return mesh.moved(_motion(source, mesh, part, convert.shape_of(part).BoundBox))


def mesh_in_frame(obj, part):
    """The same in the coordinate system of the containers around the part."""
    mesh, frame = ElementMesh.of(obj), frames.frame_of(part)
    motion = _motion(obj, mesh, part, convert.shape_of(part).BoundBox)
    if not frames.is_identity(motion) or frames.same(frames.frame_of(obj), frame):
        return ElementMesh.of(obj.FemMesh)
    return mesh.moved(frame.inverse())


def _motion(source, mesh, part, box):
    """What moves the mesh from where it stands in the document to where that has the part, whose box is given."""
    if not (frames.is_object(source) and frames.is_object(part)):
        return FreeCAD.Placement()
    motion = frames.relative_motion(frames.frame_of(source), frames.frame_of(part))
    if frames.is_identity(motion):
        return motion
    wanted = np.array([(box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)])
    nodes = mesh.nodes[np.unique(np.concatenate([block.nodes.ravel() for block in mesh.blocks]))]
    off = [np.abs(np.array([points.min(axis=0), points.max(axis=0)]) - wanted).max()
           for points in (nodes, convert.moved(nodes, motion))]
    return motion if off[1] <= off[0] else FreeCAD.Placement()
