# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn of a mesh that a plane cuts: the cut itself, or the whole elements behind it. No windows here."""

from dataclasses import dataclass

import numpy as np

from ..core.elements import boundary, kinds
from ..core.inspect import section
from ..core.meshes.element_mesh import ElementMesh
from .flat_faces import sides_of, triangles_of_faces
from .quality_data import runs_of_sides


@dataclass(frozen=True)
class Drawn:
    """corners float32 (T, 3, 3), triangles; element int (T,), of each, -1 where there is none; lines (float32 (P, 3), int32 runs
    ended by -1), their edges.
    """

    corners: np.ndarray
    element: np.ndarray
    lines: tuple


class SectionData:
    """Cuts the mesh of a QualityData after its prepare(). Elements are those that the measures are of, of a volume mesh all that
    it has, those inside, too.
    """

    def __init__(self, data):
        self._data, self._mesh = data, None
        if data.solid is not None:
            self._mesh = ElementMesh.of(data.solid)
            self._blocks = section.corners_of(self._mesh)
            self._centres = np.concatenate([self._mesh.nodes[corners].mean(axis=1) for _, corners in self._blocks])
            return
        centres, count = data.corners.mean(axis=1, dtype=np.float64), np.bincount(data.element, minlength=data.elements)
        sums = [np.bincount(data.element, centres[:, k], data.elements) for k in range(3)]
        self._centres = np.stack(sums, axis=1) / np.maximum(count, 1)[:, None]

    def range(self, plane):
        """(lowest, highest) distance of the mesh from a plane, mm."""
        heights = plane.heights(self._data.corners.reshape(-1, 3))
        return float(heights.min()), float(heights.max())

    def middle(self):
        """float64 (3,): the middle of the box around the mesh."""
        points = self._data.corners.reshape(-1, 3)
        return 0.5 * (points.min(axis=0) + points.max(axis=0)).astype(np.float64)

    def centre(self, element):
        """float64 (3,): the middle of an element."""
        return self._centres[element]

    def cut(self, plane):
        """The Drawn cut: polygons of volume elements, and what surfaces enclose."""
        if self._mesh is not None:
            found = section.cut_volumes(self._mesh.nodes, self._blocks, plane)
            corners, ring = found.fans()
            sides = np.stack([found.points, np.roll(found.points, -1, axis=1)], axis=2).reshape(-1, 2, 3)
            return _drawn(corners, found.element[ring], sides)
        points = self._data.corners.reshape(-1, 3).astype(np.float64)
        segments = section.cut_triangles(points, np.arange(len(points)).reshape(-1, 3), plane).points
        corners = section.filled(segments, plane)
        return _drawn(corners, np.full(len(corners), -1), segments)

    def whole(self, plane):
        """The Drawn whole elements whose middle is not in the half that is cut off."""
        kept = plane.heights(self._centres) <= 0.0
        if self._mesh is None:
            rows = np.flatnonzero(kept[self._data.element])
            corners = self._data.corners[rows]
            return _drawn(corners, self._data.element[rows], corners[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2, 3))
        first, blocks, numbers = 0, [], []
        for block in (block for block in self._mesh.blocks if kinds.DIMENSION[block.kind] == 3):
            numbers.append(first + np.flatnonzero(kept[first:first + len(block.nodes)]))
            blocks.append(block._replace(nodes=block.nodes[numbers[-1] - first]))
            first += len(block.nodes)
        starts, numbers = np.cumsum([0, *map(len, numbers)]), np.concatenate(numbers)
        faces = boundary.with_elements(blocks) if len(numbers) else []
        divided = [triangles_of_faces(nodes) for nodes, _, _ in faces]
        owners = [np.repeat(numbers[starts[of] + row], part.shape[1]) for (_, of, row), part in zip(faces, divided)]
        nodes, nothing = self._mesh.nodes.astype(np.float32), [np.zeros((0, 3), dtype=int)]
        rows = np.concatenate([*nothing, *(part.reshape(-1, 3) for part in divided)])
        sides = np.concatenate([*(row[:, :2] for row in nothing), *(sides_of(face) for face, _, _ in faces)])
        return Drawn(nodes[rows], np.concatenate([*(row[:, 0] for row in nothing), *owners]), (nodes, runs_of_sides(sides)))


def _drawn(corners, element, sides):
    """The Drawn with sides (n, 2, 3) as lines."""
    ends = np.arange(2 * len(sides), dtype=np.int32).reshape(-1, 2)
    runs = np.column_stack([ends, np.full(len(ends), -1, dtype=np.int32)]).ravel()
    return Drawn(np.asarray(corners, dtype=np.float32), element, (np.asarray(sides, dtype=np.float32).reshape(-1, 3), runs))
