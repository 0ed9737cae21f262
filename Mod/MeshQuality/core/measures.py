# SPDX-License-Identifier: LGPL-2.1-or-later
"""measures: the quality measures of elements that users know from Verdict and OpenFOAM."""

import os
import re

import numpy as np

from ..errors import InvalidInput
from ..listing import Public
from .curving import holds_elements, taken_from
from .elements import kinds
from .elements.alike import shares
from .elements.measures import MEASURES, ElementMeasure
from .elements.neighbours import finite_volume_measures
from .inspect import tables
from .meshes.element_mesh import ElementMesh, read_mesh
from .meshes.surface_mesh import SurfaceMesh, surface_of
from .operands.operands import is_arrays
from .sources import convert, frames

# OpenFOAM calls faces beyond 70 degrees non-orthogonal, and those beyond 4 skew.
FINITE_VOLUME = (ElementMeasure("non_orthogonality", 0.0, 70.0, "°", {}), ElementMeasure("skewness", 0.0, 4.0, "", {}))
ALL = (*MEASURES, *FINITE_VOLUME)
_BY_NAME = {measure.name: measure for measure in ALL}


class MeasureTable(metaclass=Public):
    """The measures of each element of a mesh, those of its highest dimension; edge_ratio, say, is table["edge_ratio"].

    names  tuple of the measures that some element has: of edge_ratio, aspect_ratio, scaled_jacobian, equiangle_skew, min_angle,
           max_angle (degrees), skew, taper, warpage, non_orthogonality (degrees), skewness
    kinds  {kind of element: count}, in the order of the elements
    numbers  int (E,), the number of each element, from 0
    face   int32 (E,), the CAD face of each triangle: faces[i] is that of shape.Faces[i]; -1 where that is not known

    Values are float64 (E,), not a number where a measure is not defined for the kind, computed when they are first asked for.
    print(table) writes the worst value and the mean of each.
    """

    __slots__ = {"_blocks": None, "_check": None, "_found": None, "_nodes": None, "face": "int32 (E,)", "kinds": "{kind of element: count}",
                 "names": "tuple", "numbers": "int (E,)"}

    def __init__(self, nodes, blocks, face=None, check=lambda: None):
        self._check = check  # called now and then; may raise Cancelled
        self._nodes, self._found = np.asarray(nodes, dtype=np.float64), {}
        self._blocks = [(kind, corners) for kind, corners in blocks if len(corners)]
        self.kinds = {}
        for kind, corners in self._blocks:
            self.kinds[kind] = self.kinds.get(kind, 0) + len(corners)
        count = sum(self.kinds.values())
        self.face = np.full(count, -1, dtype=np.int32) if face is None else face
        self.numbers, self.names = np.arange(count), self.names_of(self.kinds)

    @staticmethod
    def names_of(present):
        """The names of the measures that some of these kinds of elements have."""
        solid = any(kinds.DIMENSION[kind] == 3 for kind in present)
        return tuple(measure.name for measure in ALL
                     if any(kind in measure.of for kind in present) or solid and measure in FINITE_VOLUME)

    def __len__(self):
        return len(self.face)

    def __getitem__(self, name):
        if name not in self.names:
            raise InvalidInput(f"there is no measure {name!r} of these elements: there are {', '.join(self.names)}")
        if name not in self._found:
            self._compute(name)
        return self._found[name]

    def _compute(self, name):
        if _BY_NAME[name] in FINITE_VOLUME:
            found = finite_volume_measures(self._nodes, self._blocks, self._check)
            self._found.update(zip([measure.name for measure in FINITE_VOLUME], found))
        else:
            parts = [(kind, corners[share]) for kind, corners in self._blocks for share in shares(len(corners))]
            self._found[name] = np.concatenate([self._values(name, *part) for part in parts])

    def _values(self, name, kind, corners):
        self._check()
        return _BY_NAME[name].values(kind, self._nodes[corners])

    def worst(self, name):
        """(index of the element, value) with the worst value of a measure, the farthest from the ideal one on its bad side."""
        values = self[name]
        measure = _BY_NAME[name]
        bad = values if measure.poor > measure.ideal else -values
        at = int(np.nanargmax(bad))
        return at, float(values[at])

    def mean(self, name):
        """The mean of the values that are finite; not a number where none is."""
        values = self[name]
        finite = values[np.isfinite(values)]
        return float(finite.mean()) if len(finite) else float("nan")

    def write_csv(self, path, more=None):
        """Writes a line for each element: its number, its kind, its CAD face where that is known, and each measure; empty
        where a measure is not defined. `more` are further columns, {title: float64 (E,)}. Raises IoError naming the path.
        """
        added = {_column_of(title): values for title, values in (more or {}).items()}
        added = {name: values for name, values in added.items() if name not in self.names}
        columns = [*(self[name] for name in self.names), *added.values()]
        kinds_of = np.repeat([kind for kind, _ in self._blocks], [len(corners) for _, corners in self._blocks])
        faces = ["" if face < 0 else f"Face{face + 1}" for face in self.face.tolist()]
        texts = [["" if np.isnan(value) else repr(value) for value in column.tolist()] for column in columns]
        tables.write(path, ("element", "kind", "face", *self.names, *added),
                     zip(self.numbers.tolist(), kinds_of.tolist(), faces, *texts))

    @property
    def notes(self):
        """Sentences that a user should know; none."""
        return ()

    def to_dict(self):
        """The worst value, its element, and the mean of each measure, as plain values."""
        found = {}
        for name in self.names:
            at, value = self.worst(name)
            found[name] = {"worst": value if np.isfinite(value) else None, "element": int(self.numbers[at]), "mean": self.mean(name)}
        return {"elements": dict(self.kinds), "measures": found, "notes": []}

    def __str__(self):
        lines = ["elements     " + ", ".join(f"{count:,} {kinds.PLURALS[kind]}" for kind, count in self.kinds.items())]
        for name in self.names:
            at, value = self.worst(name)
            unit = _BY_NAME[name].unit
            lines.append(f"{name:<18} worst {value:.6g}{unit} (element {self.numbers[at]:,}), mean {self.mean(name):.6g}{unit}, "
                         f"ideal {_BY_NAME[name].ideal:g}{unit}")
        return "\n".join(lines) + "\n"

    def __repr__(self):
        return f"<{type(self).__name__}: {len(self):,} elements, {len(self.names)} measures>"


def _column_of(title):
    """The name of a column: what a measure is called in words, as a name in Python."""
    return re.sub(r"\W+", "_", title.lower()).strip("_")


def measures(mesh):
    """The quality measures of each element of a mesh -> MeasureTable.

    mesh  Mesh.Mesh, Mesh feature, SurfaceMesh or arrays (V, F): triangles; ElementMesh, CurvedMesh, Fem.FemMesh, objects of the
          document with such, or the name of a file that read_mesh reads: the elements of the highest dimension

    edge_ratio, aspect_ratio, scaled_jacobian, equiangle_skew, min_angle, max_angle, skew, taper and warpage are Verdict's, by the
    corners of the elements. The aspect ratio of hexahedra is Verdict's maximum edge ratio, that of prisms its maximum aspect
    Frobenius; pyramids have none. warpage is 0 of flat quadrilaterals (VTK's function returns 1 - warpage); of pyramids, prisms and
    hexahedra it is the largest of their faces. non_orthogonality and skewness of volume elements are OpenFOAM's, of each element
    the largest of its faces.

    Raises InvalidInput for other things, or a mesh without triangles, quadrilaterals and volumes; IoError naming a file.
    """
    if frames.is_object(mesh) and holds_elements(mesh):
        mesh = taken_from(mesh)()
    if isinstance(mesh, SurfaceMesh) or convert.is_mesh(mesh) or is_arrays(mesh):
        surface = surface_of(mesh, measured=False)
        if not len(surface.triangles):
            raise InvalidInput("the mesh has no triangles: there is nothing to measure")
        face = np.array(surface.triangle_face)
        return MeasureTable(surface.vertices, [("triangle", surface.triangles)], face if len(face) else None)
    return table_of_elements(read_mesh(mesh) if isinstance(mesh, (str, os.PathLike)) else ElementMesh.of(mesh))


def table_of_elements(mesh, check=lambda: None):
    """The MeasureTable of an ElementMesh; `check` is called now and then while it is computed, and may raise Cancelled."""
    if mesh.dimension < 2:
        raise InvalidInput("the mesh has lines only: measures are of triangles, quadrilaterals and volumes")
    return MeasureTable(mesh.nodes, [(block.kind, block.nodes[:, :kinds.CORNERS[block.kind]]) for block in mesh.blocks
                                     if kinds.DIMENSION[block.kind] == mesh.dimension], check=check)
