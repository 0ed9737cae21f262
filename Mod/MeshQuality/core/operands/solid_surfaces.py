# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surfaces of solids to be inspected: of shapes, which are meshed, and of meshes."""

from ... import phrases
from ...compat import extension
from ...errors import InvalidInput, TopologyError
from ..meshes.surface_mesh import SurfaceMesh, surface_of
from ..sources import convert
from ..triangulation import triangulate
from .operands import is_arrays

_RELATIVE = 1e-3  # first distance of the mesh from a shape, as a fraction of its largest dimension
_FINEST = 1e-6  # the finest distance, such a fraction too: single precision holds no finer one
_MOST_FOR_ANGLES = 200_000  # no bound on angles where it takes more triangles, as along a face of a millionth of the size


def is_given_mesh(source):
    """Whether the source is a mesh, so that no shape need be meshed."""
    return isinstance(source, SurfaceMesh) or is_arrays(source) or convert.is_mesh(source)


class SolidSource:
    """A shape or a mesh, as it is now, with its name for errors.

    shape  the Part.Shape; None of a mesh
    label  how sentences call it
    size   of a shape: the largest dimension, mm
    """

    def __init__(self, source):
        self.label = convert.label_of(source) if not is_arrays(source) else "the mesh"
        self.shape = self._surface = None
        if is_given_mesh(source):
            self._surface = surface_of(source)
        else:
            self.shape = convert.shape_of(source)
            box = self.shape.BoundBox
            self.size = max(box.XLength, box.YLength, box.ZLength)

    def first_chord_height(self):
        """The tolerance for the mesh of a shape where none is given."""
        return _RELATIVE * self.size

    def mesh(self, chord_height, max_edge, progress):
        """The core's Surface; a shape is meshed within this distance."""
        if self.shape is None:
            return self._surface
        chord_height = max(chord_height, _FINEST * self.size)
        try:
            mesh = triangulate(self.shape, chord_height=chord_height, max_edge=max_edge, progress=progress,
                               max_triangles=_MOST_FOR_ANGLES)
            if not mesh.report.complete:
                mesh = self._of_any_angles(chord_height, max_edge, progress)
        except (InvalidInput, TopologyError) as error:
            raise self.named(error) from error
        if not mesh.report.complete:
            raise InvalidInput(f"{self.label} has more than {mesh.report.triangles} triangles at a max. deviation of "
                               f"{chord_height:g} mm: give a larger tolerance or spacing")
        return mesh._surface

    def _of_any_angles(self, chord_height, max_edge, progress):
        """The SurfaceMesh within this distance with edges up to this length, without a bound on its angles."""
        core_options = extension().TriangulateOptions()
        core_options.min_angle, core_options.chord_height = 0.0, chord_height
        core_options.max_edge = max_edge or core_options.max_edge
        return SurfaceMesh(extension().triangulate(self.shape, core_options, progress, None))

    def named(self, error):
        """An error of the core with the name of what was given."""
        if str(error).startswith(self.label):
            return error
        return type(error)(phrases.Text("{name}: {phrase}", name=self.label, phrase=phrases.text_of(error)))


def face_name(surface, triangle):
    """"Face7" of a triangle; None where no CAD face is known."""
    faces = surface.triangle_face
    if triangle < 0 or not len(faces) or faces[triangle] < 0:
        return None
    return f"Face{faces[triangle] + 1}"
