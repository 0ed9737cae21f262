# SPDX-License-Identifier: LGPL-2.1-or-later
"""The region of a flow around a part: what a box, a sphere or any solid leaves around it, its faces by the names of the part's."""

import re
from dataclasses import dataclass

import numpy as np
import Part
from FreeCAD import Vector

from ...errors import InvalidInput
from ..patches.patches import division_of, index_in
from ..sources import convert

_FACTOR = 5.0  # the far field is as many times the size of the part away from it
_FACTORS = (0.5, 1000.0)
_FORM = re.compile(r"(box|sphere)(?::([0-9.eE+-]+))?")
_HALF = re.compile(r"\s*([xyz])\s*([<>])\s*([-+0-9.eE]+)\s*")
_EDGES = 5  # edges of the far field along its distance
_SAME = 1e-5  # share of the part's size within which two places are the same
SYMMETRY = "symmetry"  # what patches of that type are called
_SPHERE_NAME = "farField"
_SIDES = ("xMin", "xMax", "yMin", "yMax", "zMin", "zMax")
FAR_NAMES = (SYMMETRY, _SPHERE_NAME, *_SIDES)


@dataclass(frozen=True)
class Region:
    """One solid, the fluid.

    shape    Part.Shape
    origin   int (F,): by face of it the index of the part's face, or, from `count` on, of `names`
    count    how many faces the part has
    names    of the far field's own faces
    edge     mm, the longest edge of triangles on those
    size     mm, largest dimension of the part
    """

    shape: object
    origin: np.ndarray
    count: int
    names: tuple
    edge: float
    size: float

    def division(self, part, patches, rest):
        """The Division of patches that name the part's faces and the far field's; those that none names keep their names, `rest`
        is that of the part's."""
        def index_of(name):
            if name in self.names:
                return self.count + self.names.index(name)
            index = index_in(part, name)
            return None if index is not None and index >= self.count else index
        given = division_of(patches or {}, rest, index_of)
        own = {name: i for i, name in enumerate(self.names, self.count) if i not in given.patch_of}
        taken = next((name for name in own if name in given.names or name == rest), None)
        if taken is not None:
            raise InvalidInput(f"patch {taken!r} has the name of a face of the far field: add that face to it, or give it another name")
        return given._replace(names=(*given.names, *own), colours=(*given.colours, *(None for _ in own)),
                              patch_of={**given.patch_of, **{face: len(given.names) + k for k, face in enumerate(own.values())}})

    def sizes(self, values, part):
        """The options of the surface for `shape`: what is relative is so to the part, and max_edge is of the part's faces."""
        local = self._local_sizes(convert.resolve_sizes(part, values["local_sizes"]) or {}, convert.shape_of(part))
        for face, origin in enumerate(self.origin.tolist(), 1):
            size = self.edge if origin >= self.count else values["max_edge"]
            if size is not None:
                local.setdefault(f"Face{face}", size)
        found = {**values, "max_edge": None, "local_sizes": local}
        if values["chord_height"] is None:
            found["chord_height"] = (0.003 if values["chord_height_relative"] is None else values["chord_height_relative"]) * self.size
            found["chord_height_relative"] = None
        return found

    def _local_sizes(self, sizes, part):
        found = {}
        for name, size in sizes.items():
            kind = name.rstrip("0123456789")
            if kind == "Face":
                names = [f"Face{face + 1}" for face in np.flatnonzero(self.origin == int(name[4:]) - 1).tolist()]
            else:
                wanted = part.getElement(name)
                names = [f"{kind}{i}" for i, one in enumerate(getattr(self.shape, {"Edge": "Edges", "Vertex": "Vertexes"}[kind]), 1)
                         if one.isPartner(wanted)]
            if not names:
                raise InvalidInput(f"local_sizes names {name}, which the region around the part does not have as a whole: name a face")
            found.update(dict.fromkeys(names, size))
        return found


def region_around(source, far_field, symmetry, edge):
    """The Region around a part; see volume_mesh. Raises InvalidInput naming what is not possible."""
    part, label = convert.shape_of(source), convert.label_of(source)
    if not part.countElement("Solid"):
        raise InvalidInput(f"{label} has no solid: a flow goes around solids; make one of its faces")
    box = part.optimalBoundingBox(False)
    size = max(box.XLength, box.YLength, box.ZLength)
    half = _half_of(symmetry)
    solid, named, distance = _solid_of(far_field, box, size, half)
    names = tuple(dict.fromkeys(named))
    count, left = len(part.Faces), solid.cut(part)
    origins = [_origins_of(one.Faces, part, solid, [count + names.index(name) for name in named], _SAME * size) for one in left.Solids]
    fluids = [i for i, found in enumerate(origins) if (found >= count).any()]
    if len(fluids) != 1 or not (origins[fluids[0]] < count).any():
        raise InvalidInput(f"the far field leaves {len(fluids)} regions around {label}, or does not reach it: give one that has all of the "
                           "part inside, or that its plane of symmetry cuts")
    return Region(left.Solids[fluids[0]], origins[fluids[0]], count, names, edge or distance / _EDGES, size)


def _half_of(symmetry):
    """(axis, sign, place) of "y>0"; None of None."""
    if symmetry is None:
        return None
    found = _HALF.fullmatch(symmetry) if isinstance(symmetry, str) else None
    try:
        return "xyz".index(found[1]), 1 if found[2] == ">" else -1, float(found[3])
    except (TypeError, ValueError):
        raise InvalidInput(f"symmetry = {symmetry!r}: give the half-space of the fluid, such as 'y>0' or 'z>-2.5', in mm") from None


def _solid_of(far_field, box, size, half):
    """(solid, names of its faces, mm between it and the part)."""
    if hasattr(far_field, "ShapeType") or hasattr(far_field, "Shape"):
        return _given(far_field, half, size)
    form = _FORM.fullmatch(far_field) if isinstance(far_field, str) else None
    try:
        factor = float(form[2] or _FACTOR)
    except (TypeError, ValueError):
        factor = 0.0
    if not _FACTORS[0] <= factor <= _FACTORS[1]:
        raise InvalidInput(f"far_field = {far_field!r}: give 'box' or 'sphere', with the distance in sizes of the part, {_FACTORS[0]:g} to "
                           f"{_FACTORS[1]:g}, such as 'box:10', or a solid")
    low, high = np.array([[box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]])
    middle, distance = (low + high) / 2, factor * size
    if half is not None:
        middle[half[0]] = half[2]
    if form[1] == "sphere":
        radius = distance + size / 2
        found = Part.makeSphere(radius, Vector(*middle))
        if half is not None:
            found = found.common(_box(middle - 2 * radius, middle + 2 * radius, half)).Solids[0]
        return found, [SYMMETRY if isinstance(face.Surface, Part.Plane) else _SPHERE_NAME for face in found.Faces], distance
    low, high = low - distance, high + distance
    found = _box(low, high, half)
    return found, [_side_of(face, low, high, half, size) for face in found.Faces], distance


def _box(low, high, half):
    """The box, of which only what is in the half-space."""
    low, high = low.copy(), high.copy()
    if half is not None:
        axis, sign, place = half
        (low if sign > 0 else high)[axis] = place
    if not (low < high).all():
        raise InvalidInput("symmetry: the half-space of the fluid does not have the part in it: turn the sign, or move the plane")
    return Part.makeBox(*(high - low), Vector(*low))


def _side_of(face, low, high, half, size):
    middle = np.array(face.CenterOfMass)
    if half is not None and abs(middle[half[0]] - half[2]) <= _SAME * size:
        return SYMMETRY
    return _SIDES[int(np.argmin(np.abs(np.column_stack([middle - low, middle - high]).ravel())))]


def _given(far_field, half, size):
    shape = convert.shape_of(far_field)
    if half is not None:
        raise InvalidInput("symmetry is for a box and a sphere: cut the solid of the far field yourself, and name its faces")
    if shape.countElement("Solid") != 1:
        raise InvalidInput(f"the far field has {shape.countElement('Solid')} solids, not one: give a single solid")
    distance = (max(shape.BoundBox.XLength, shape.BoundBox.YLength, shape.BoundBox.ZLength) - size) / 2
    return shape.Solids[0], [f"Far{i}" for i in range(1, len(shape.Solids[0].Faces) + 1)], max(distance, size / 2)


def _origins_of(faces, part, solid, numbers, tolerance):
    """int (F,): by face of the region the index of the part's face that it is of, or the number of the far field's."""
    sources = [*part.Faces, *solid.Faces]
    known = {}
    for i, source in enumerate(sources):
        known.setdefault(source.hashCode(), []).append(i)
    found = []
    for face in faces:
        same = next((i for i in known.get(face.hashCode(), ()) if sources[i].isPartner(face)), None)
        found.append(_nearest(face, sources, tolerance) if same is None else same)
    return np.array([i if i < len(part.Faces) else numbers[i - len(part.Faces)] for i in found], dtype=np.int64)


def _nearest(face, sources, tolerance):
    """The index of the face on which points of a face lie."""
    points = [Part.Vertex(point) for point in _points_of(face)]
    reach = face.BoundBox
    reach.enlarge(tolerance)
    near = [i for i, source in enumerate(sources) if reach.intersect(source.BoundBox)]
    return min(near, key=lambda i: max(sources[i].distToShape(point)[0] for point in points))


def _points_of(face):
    """Corners and middles of a coarse triangulation's triangles."""
    points, triangles = face.tessellate(0.05 * face.BoundBox.DiagonalLength)
    middles = [(points[a] + points[b] + points[c]) / 3 for a, b, c in triangles[:: max(1, len(triangles) // 4)]]
    return middles[:4]
