# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers behind the quality view of a FEM mesh: what is proven of the Jacobian of its elements, and their distance
from the part.
"""

from dataclasses import replace
from functools import partial

import FreeCAD
import numpy as np

from .. import phrases
from ..core.certify.certification import certify
from ..core.elements import boundary, cut_surface, kinds, shapes
from ..core.fem import fem_places
from ..core.measures import table_of_elements
from ..core.meshes.element_mesh import ElementMesh
from ..core.sources import frames
from ..errors import Error, InvalidInput
from ..features import cured_mesh
from .element_measures import measures_of
from .flat_faces import sides_of, triangles_of_faces
from .quality_data import ASPECT, DISTANCE, DISTORTION, MIN_ANGLE, QualityData, runs_of_sides
from .quality_measure import Measure
from .quantities import count_text

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

JACOBIAN_RATIO = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Least / largest Jacobian"),
    QT_TRANSLATE_NOOP("MeshQuality", "1 = not distorted by its middle nodes, ≤ 0 = not proven valid; those are marked."),
    "", 0.0, 1.0, lambda data, _: data.ratios)
DIHEDRAL = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Smallest dihedral angle"),
    QT_TRANSLATE_NOOP("MeshQuality", "Between two faces of an element: a regular tetrahedron has 70.5°; 10° and less harm simulations."),
    "°", 0.0, 70.5, lambda data, _: data.shapes()[0])
# Ends at twice the median, as what is large depends on the mesh: see QualityData.scale.
VOLUME = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Volume"),
    QT_TRANSLATE_NOOP("MeshQuality", "Of the element with straight sides; ≤ 0 = inside out."),
    " mm³", 0.0, 1.0, lambda data, _: data.contents)
AREA = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Area"), QT_TRANSLATE_NOOP("MeshQuality", "Of the element with straight sides."),
    " mm²", 0.0, 1.0, lambda data, _: data.contents)
_MOST_INSIDE = 1000  # elements inside of the mesh that light up at a time


class FemQualityData(QualityData):
    """The elements of a FEM mesh object; see QualityData. The elements are all that the mesh has of its highest dimension,
    of which those inside are not drawn until they light up.
    """

    def __init__(self, source):
        obj = frames.linked_of(source)[0]
        if not cured_mesh.has_fem_mesh(obj):
            raise InvalidInput(phrases.Text(phrases.NO_TRIANGLES, name=f"'{obj.Label}'"))
        self._mesh = ElementMesh.of(source)
        self.corners = self._curved = self._division = self.bound = self._fault = None
        self.tetrahedra = self.shown = 0
        self._why, self._numbers = {}, _numbers_of(obj, self._mesh)
        part = cured_mesh.part_of(obj) if obj == source else None
        self._shape = None if part is None else fem_places.shape_at(source, self._mesh, part)
        by_shape = (DIHEDRAL, ASPECT, VOLUME) if self._mesh.dimension == 3 else (MIN_ANGLE, ASPECT, AREA)
        self.measures = [JACOBIAN_RATIO, DISTORTION, *by_shape, *([DISTANCE] if part is not None else []),
                         *measures_of(table_of_elements(self._mesh).names)]
        self._prepare = partial(self._take_elements, self._mesh)

    @property
    def curved(self):
        """They are called elements."""
        return True

    @property
    def solid(self):
        """The mesh, where it has volumes."""
        return self._mesh if self._mesh.dimension == 3 else None

    def _made_table(self):
        found = table_of_elements(self._mesh)
        found.face, found.numbers = self.face, np.array(self._numbers)
        return found

    def _take_elements(self, mesh):
        found = boundary.with_elements(mesh.blocks)
        highest = mesh.dimension
        counts = [len(block.nodes) if kinds.DIMENSION[block.kind] == highest else 0 for block in mesh.blocks]
        self._starts = np.cumsum([0, *counts])
        self._certificate = self._certified(mesh)
        self.ratios = np.concatenate(self._certificate.distortion)
        found_shapes = [shapes.shapes_of(block.kind, mesh.nodes[block.nodes[:, :kinds.CORNERS[block.kind]]])
                        for block in mesh.blocks if kinds.DIMENSION[block.kind] == highest]
        *self._shapes, self.contents = (np.concatenate([getattr(each, name) for each in found_shapes])
                                        for name in ("angle", "aspect", "distortion", "content"))
        self._nodes = mesh.nodes.astype(np.float32)
        owners = [self._starts[block] + element for _, block, element in found]
        rows = [triangles_of_faces(nodes) for nodes, _, _ in found]
        self.corners = np.concatenate([self._nodes[part].reshape(-1, 3, 3) for part in rows])
        self.element = np.concatenate([np.repeat(owner, part.shape[1]) for owner, part in zip(owners, rows)])
        self._outside = np.zeros(self._starts[-1], dtype=bool)
        self._outside[self.element] = True
        self.face = np.full(self._starts[-1], -1)
        if self._certificate.triangle_face is not None:
            self._at_surface = cut_surface.owners_of_triangles([nodes for nodes, _, _ in found], owners)
            self.face[self._at_surface] = self._certificate.triangle_face
        self._lines = lambda: (self._nodes, runs_of_sides(np.concatenate([sides_of(nodes) for nodes, _, _ in found])))

    def _certified(self, mesh):
        """The MeshCertificate; where the mesh is none of the part, that is told where distances are asked for."""
        if self._shape is not None:
            try:
                return certify(mesh, self._shape)
            except Error as error:
                self._fault = error
        return certify(mesh)

    def distances(self, progress=None):
        """The largest distance of each element at the surface from the part, mm; not a number of those inside."""
        if self._fault is not None:
            raise self._fault
        found = self._certificate
        if found.triangle_deviation is None:
            raise InvalidInput(phrases.Text(phrases.NOT_MEASURED))
        worst = np.zeros(self.elements)
        np.maximum.at(worst, self._at_surface, found.triangle_deviation)
        return np.where(self._outside, worst, np.nan)

    def marked(self, measure, values):
        """The elements that are not proven valid."""
        return values <= 0.0 if measure is JACOBIAN_RATIO else super().marked(measure, values)

    def scale(self, measure, values):
        """As in the base class; that of volumes ends at twice the median."""
        if measure in (VOLUME, AREA):
            measure = replace(measure, good=2.0 * max(float(np.median(values)), np.finfo(float).tiny))
        return super().scale(measure, values)

    def is_inside(self, element):
        """The elements without a face on the surface."""
        return not self._outside[element]

    def remark(self):
        """The number of elements without a face on the surface."""
        invalid, count = self._certificate.invalid, count_text(self.elements)
        if not invalid:
            return translate("MeshQuality", "All {0} proven valid.").format(count)
        words = translate("MeshQuality", "1 of {1} is not proven valid.") if invalid == 1 else \
            translate("MeshQuality", "{0} of {1} are not proven valid.")
        return words.format(count_text(invalid), count)

    def place(self, element):
        """Words for where an element lies, by its number in FreeCAD's mesh."""
        number, face = self._numbers[element], self.face[element]
        if face < 0:
            return translate("MeshQuality", "element {0}").format(number)
        return translate("MeshQuality", "element {0} on {1}").format(number, f"Face{face + 1}")

    def triangles_of(self, chosen):
        """As in the base class; those inside have all of their faces."""
        inside = np.flatnonzero(chosen & ~self._outside)[:_MOST_INSIDE]
        parts = [super().triangles_of(chosen)]
        for block, first, end in zip(self._mesh.blocks, self._starts, self._starts[1:]):
            nodes = block.nodes[inside[(inside >= first) & (inside < end)] - first]
            if len(nodes):
                parts += [self._nodes[triangles_of_faces(nodes[:, local])].reshape(-1, 3, 3)
                          for _, local in kinds.faces_of(block.kind, block.nodes.shape[1])]
        return np.concatenate(parts)


def _numbers_of(obj, mesh):
    """The numbers in FreeCAD's mesh of the elements; from 1 where kinds are mixed."""
    of_highest = [block for block in mesh.blocks if kinds.DIMENSION[block.kind] == mesh.dimension]
    count = sum(len(block.nodes) for block in of_highest)
    numbers = obj.FemMesh.Volumes if mesh.dimension == 3 else obj.FemMesh.Faces
    return sorted(numbers) if len(of_highest) == 1 and len(numbers) == count else range(1, count + 1)
