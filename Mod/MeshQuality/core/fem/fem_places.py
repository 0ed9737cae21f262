# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where FEM meshes of a document lie on their parts.

Before version 1.0 FreeCAD's FEM workbench makes meshes where the part's own placement has it, without the containers around it; since
then, and by other programs, they lie where the document has the part. So a mesh may lie on the part in either place: the place where it
fits counts. Boxes tell that mostly; where both fit, as of a part that is turned about the middle of its box, the distance
from the faces does.
"""

import FreeCAD
import numpy as np

from ...compat import extension
from ..meshes.element_mesh import ElementMesh
from ..sources import convert, frames

_FITS = 0.02  # share of the diagonal by which boxes may differ where the mesh is coarse
_COMPARED = 2000  # nodes of the surface that are held against the faces


def shape_at(source, mesh, part):
    """The shape of a part where a mesh has it.

    source  what the ElementMesh `mesh` is of: where this is no object of a document, the part is where the document has it
    """
    shape = convert.shape_of(part)
    motion = _motion(source, mesh, part, shape)
    if not frames.is_identity(motion):
        shape = shape.copy()
        shape.transformShape(motion.inverse().toMatrix(), False)
    return shape


def mesh_at(source, part):
    """The ElementMesh of a document object with a FEM mesh, moved to where its part is in the document."""
    mesh = ElementMesh.of(source)
    return mesh.moved(_motion(source, mesh, part, convert.shape_of(part)))


def mesh_in_frame(obj, part):
    """The same in the coordinate system of the containers around the part."""
    mesh, frame = ElementMesh.of(obj), frames.frame_of(part)
    motion = _motion(obj, mesh, part, convert.shape_of(part))
    if not frames.is_identity(motion) or frames.same(frames.frame_of(obj), frame):
        return ElementMesh.of(obj.FemMesh)
    return mesh.moved(frame.inverse())


def _motion(source, mesh, part, shape):
    """What moves the mesh from where it stands in the document to where that has the part, whose shape is given."""
    if not (frames.is_object(source) and frames.is_object(part)):
        return FreeCAD.Placement()
    motion = frames.relative_motion(frames.frame_of(source), frames.frame_of(part))
    if frames.is_identity(motion):
        return motion
    off = _off_box(mesh, motion, shape.BoundBox)
    if max(off) <= _FITS * shape.BoundBox.DiagonalLength and mesh.dimension > 1:
        off = _off_faces(mesh, motion, shape)
    return motion if off[1] <= off[0] else FreeCAD.Placement()


def _off_box(mesh, motion, box):
    """mm: how far the box of the mesh is from that of the part, without the motion and with it."""
    wanted = np.array([(box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)])
    nodes = mesh.nodes[np.unique(np.concatenate([block.nodes.ravel() for block in mesh.blocks]))]
    return [np.abs(np.array([points.min(axis=0), points.max(axis=0)]) - wanted).max()
            for points in (nodes, convert.moved(nodes, motion))]


def _off_faces(mesh, motion, shape):
    """mm: the mean distance of nodes of the surface from the faces of the part, without the motion and with it. A part that
    is turned onto itself has the same but for rounding: then either place is one of the mesh.
    """
    nodes = np.unique(np.concatenate([rows.ravel() for rows in mesh.boundary()]))
    nodes = mesh.nodes[nodes[np.unique(np.linspace(0, len(nodes) - 1, _COMPARED).astype(int))]]
    off = [float(extension().distances_to_faces(shape, points, None).mean()) for points in (nodes, convert.moved(nodes, motion))]
    return off if abs(off[0] - off[1]) > 1e-9 * shape.BoundBox.DiagonalLength else [0.0, 0.0]
