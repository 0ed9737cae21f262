# SPDX-License-Identifier: LGPL-2.1-or-later
"""certify: which elements of a mesh are proven valid, whoever made it."""

import os

import numpy as np

from ... import options
from ...compat import extension
from ...errors import GeometryError, InvalidInput, TopologyError
from ...listing import Public
from ..elements import bodies, conformity, cut_surface, kinds
from ..fem import fem_places
from ..meshes.element_mesh import ElementMesh
from ..meshes.writing import checked_scale
from ..sources import convert
from . import saved_certificate

_VALID, _FOLDED, _INVERTED, _NOT_PROVEN = range(4)  # verdicts of the core
_WORDS = {_FOLDED: "folded", _INVERTED: "numbered the wrong way round", _NOT_PROVEN: "not proven valid"}
_LEFT_OUT = 3.0  # times the deviation of the mesh from the CAD: the mesh misses a place of the CAD at this distance
_UNKNOWN = 1e-3  # assumed distance of the mesh where it was not measured, a share of the shape's diagonal


class MeshCertificate(metaclass=Public):
    """What was proven of a mesh that anybody made.

    elements          {kind: how many}
    invalid           elements that are not proven valid: folded, inverted or not proven
    folded            somewhere J <= 0 (of triangles and quadrilaterals: the normal turns by 90 degrees or more; of triangles that
                      were measured against a shape: it does not follow that of the CAD face)
    inverted          J < 0 everywhere: the nodes are numbered the wrong way round
    not_proven        neither proven valid nor folded
    invalid_elements  which these are: "tetrahedron 22 folded at (1, 2, 3) mm"
    min_distortion    the smallest proven lower bound of min J / max |J|, equation (3) of Dey, O'Bara, Shephard 1999
    distortion        float64 (E,) by block of the mesh: these bounds, in the order of its elements
    conforming        whether no face has more than two elements, no element is there twice, and no corner lies amid an edge
                      or a face of another
    oriented          whether neighbours are seen from the same side
    overlapping_bodies
                      pairs of bodies, which share no faces, that are proven to overlap: a point is inside of an element of each;
                      None without volumes
    max_deviation     largest distance of the surface from its CAD faces, mm; None without a shape
    folded_on_cad     triangles of the surface that fold over their CAD face; None without a shape
    cad_deviation     the other way: largest distance of points of the CAD faces and edges from the surface of the mesh, mm, so that
                      what the mesh leaves out shows; None without a shape
    cad_spacing       mm, how far these points are apart at most: no place of the CAD is farther from the mesh than by both
    face_deviation    float64 (shape.Faces,), cad_deviation of each CAD face; None without a shape
    curved_intersections
                      pairs of curved triangles and quadrilaterals of the surface that are proven to cross, equation (2)
    not_proven_apart  pairs that are neither proven to cross nor not to, such as those of bodies that touch
    not_on_shape      why the surface is not on the shape; None where it is, or was not compared
    triangle_face     int32 (F,), the CAD face of each triangle of the surface, as mesh.boundary() has them, then of the halves of its
                      quadrilaterals; likewise
    triangle_deviation
                      float64 (F,), mm, the largest distance of each
    notes             sentences about the mesh that a user should know
    """

    __slots__ = {
        "_blocks": None, "_scale": None, "_source": None, "_crossings": None, "_turning": None, "_overlaps": None, "_grids": None, "_folded_on_cad": None,
        "elements": "{kind: how many}",
        "folded": "how many are folded",
        "inverted": "how many are numbered the wrong way round", "not_proven": "how many are neither proven nor folded",
        "invalid_elements": "sentences: which are not valid, and where", "distortion": "bounds of each, by block",
        "conforming": "whether elements fit together", "oriented": "whether neighbours are seen from the same side",
        "overlapping_bodies": "pairs that lie in one another, or None",
        "max_deviation": "mm, or None", "cad_deviation": "of CAD faces from the mesh, mm, or None",
        "cad_spacing": "of the points measured there, mm, or None", "face_deviation": "float64 (shape.Faces,), mm, or None",
        "folded_on_cad": "triangles that fold over their CAD face, or None",
        "curved_intersections": "pairs of sides that cross, or None",
        "not_on_shape": "why the surface is not on the shape, or None",
        "not_proven_apart": "pairs that may cross, or None",
        "triangle_face": "int32 (F,), or None", "triangle_deviation": "float64 (F,), mm, or None",
        "notes": "sentences about the mesh",
    }

    def __init__(self):
        self.elements, self.distortion, self.invalid_elements, self.notes = {}, (), [], []
        self._blocks, self._scale, self._source = [], 1.0, None
        self._crossings, self._turning, self._overlaps, self._grids = ((), (), ()), (), (), ((), ())
        self._folded_on_cad = ()
        self.folded = self.inverted = self.not_proven = 0
        self.conforming = self.oriented = True
        self.curved_intersections = self.not_proven_apart = self.not_on_shape = self.overlapping_bodies = None
        self.cad_deviation = self.cad_spacing = self.face_deviation = None
        self.max_deviation = self.folded_on_cad = self.triangle_face = self.triangle_deviation = None

    @property
    def invalid(self):
        """Elements that are not proven valid."""
        return self.folded + self.inverted + self.not_proven

    @property
    def min_distortion(self):
        """The smallest of distortion; None of no elements."""
        return min((float(part.min()) for part in self.distortion if len(part)), default=None)

    def to_dict(self):
        """All but the arrays, for JSON."""
        names = ("elements", "invalid", "folded", "inverted", "not_proven", "invalid_elements", "min_distortion",
                 "conforming", "oriented", "overlapping_bodies", "curved_intersections", "not_proven_apart", "max_deviation", "folded_on_cad",
                 "cad_deviation", "cad_spacing", "not_on_shape", "notes")
        return {name: getattr(self, name) for name in names}

    def save(self, path, cad=None):
        """Writes it as JSON, so that mq.verify and `meshquality verify` can check it again, anywhere.

        path   of the new file, best beside the mesh
        cad    path of the file that the shape is from
        The file has what was proven of which element, and the SHA-256 of the mesh and of the CAD file. Raises
        InvalidInput where certify was not given the path of the mesh; IoError naming the path.
        """
        saved_certificate.save(self, path, cad)

    def __str__(self):
        counts = ", ".join(f"{count:,} {kinds.PLURALS[kind] if count != 1 else kind}"
                           for kind, count in self.elements.items())
        lines = [f"elements     {counts}",
                 f"invalid      {self.invalid:,}: {self.folded:,} folded, {self.inverted:,} numbered the wrong way round, "
                 f"{self.not_proven:,} not proven",
                 f"distortion   {self.min_distortion:.3g} at least",
                 f"conforming   {'yes' if self.conforming else 'no'}, oriented {'yes' if self.oriented else 'no'}"]
        if self.overlapping_bodies is not None:
            lines.append(f"bodies       {self.overlapping_bodies:,} pairs that lie in one another")
        if self.curved_intersections is not None:
            lines.append(f"crossings    {self.curved_intersections:,} pairs of sides, {self.not_proven_apart:,} not proven "
                         "apart")
        if self.max_deviation is not None:
            lines.append(f"deviation    {self.max_deviation:.3g} mm at most, {self.folded_on_cad:,} triangles fold over "
                         "their CAD face")
        if self.cad_deviation is not None:
            lines.append(f"from the CAD {self.cad_deviation:.3g} mm at most, at points {self.cad_spacing:.3g} mm apart")
        return "\n".join([*lines, *(f"note         {note}" for note in self.notes)]) + "\n"

    def __repr__(self):
        said = f"{self.invalid:,} not proven valid" if self.invalid else "all proven valid"
        return f"<MeshCertificate: {sum(self.elements.values()):,} elements, {said}>"


def certify(mesh, shape=None, progress=None, mesh_scale=1.0):
    """Proves which elements of a mesh are valid: a MeshCertificate.

    mesh      the path of a file that mq.read_mesh takes, or anything that ElementMesh.of takes: triangles,
              quadrilaterals, tetrahedra, prisms, pyramids and hexahedra of orders 1 to 5
    shape     Part.Shape or document object; the surface of the mesh is measured against it, where it is of triangles
    progress  as for curve
    mesh_scale
              factor from the coordinates of a file to mm: 1000 for one in metres

    Validity is proven by Bernstein bounds of the Jacobian, see docs/method/validity.md. Nothing is changed.
    Where the surface is not on the shape, `not_on_shape` says why, naming the place. Raises IoError, InvalidInput naming
    the element; Cancelled.
    """
    options.require_callable(progress)
    found = MeshCertificate()
    if isinstance(mesh, (str, os.PathLike)):
        found._source = saved_certificate.digest_of(os.fsdecode(convert.file_name(mesh)))
        found._scale = mesh_scale
    source, mesh = mesh, given_mesh(mesh, mesh_scale)
    found.notes += mesh.faults
    _prove(mesh, found, progress)
    found.conforming, found.oriented = conformity.of_blocks(mesh.blocks, mesh.nodes)
    _name_doubled(mesh, found)
    if mesh.dimension == 3:
        _find_overlaps(mesh, found, progress)
    _find_crossings(mesh.nodes, sides_of_surface(mesh), found, progress)
    if shape is not None:
        shape, surface = fem_places.shape_at(source, mesh, shape), cut_surface.triangles_of_surface(mesh)
        _measure(mesh, surface, shape, found, progress)
        if surface[-1] is not None:
            _measure_from_cad(mesh, surface, shape, found, progress)
    return found


def given_mesh(mesh, mesh_scale=1.0):
    """The ElementMesh of a path, with the factor of its coordinates, or of what ElementMesh.of takes."""
    scale = checked_scale(mesh_scale, "mesh_scale", "1000")
    if isinstance(mesh, (str, os.PathLike)):
        return ElementMesh.read(mesh, scale)
    if scale != 1.0:
        raise InvalidInput("mesh_scale= is for a mesh that is given by the path of its file: this one is in mm")
    return ElementMesh.of(mesh)


def _prove(mesh, found, progress):
    highest = mesh.dimension
    if highest < 2:
        raise InvalidInput("the mesh has lines only: nothing of it can be certified")
    if not any(len(block.nodes) for block in mesh.blocks if kinds.DIMENSION[block.kind] == highest):
        raise InvalidInput("the mesh has no elements: nothing of it can be certified")
    parts = []
    for block in mesh.blocks:
        if kinds.DIMENSION[block.kind] < highest:
            parts.append(np.empty(0))
            found._blocks.append((block.kind, block.order, np.empty(0, dtype=int), parts[-1]))
            continue
        low, _, verdict = extension().check_elements(block.kind, block.order, mesh.nodes, block.nodes, progress)
        parts.append(low)
        found._blocks.append((block.kind, block.order, verdict, low))
        found.elements[block.kind] = found.elements.get(block.kind, 0) + len(block.nodes)
        for name, number in (("folded", _FOLDED), ("inverted", _INVERTED), ("not_proven", _NOT_PROVEN)):
            setattr(found, name, getattr(found, name) + int((verdict == number).sum()))
        for i in np.flatnonzero(verdict != _VALID):
            x, y, z = mesh.nodes[block.nodes[i]].mean(axis=0)
            found.invalid_elements.append(f"{block.kind} {i} {_WORDS[verdict[i]]} at ({x:.4g}, {y:.4g}, {z:.4g}) mm")
    found.distortion = tuple(parts)


def sides_of_surface(mesh):
    """[(kind, order, int32 (F, n))]: the triangles and quadrilaterals that bound a mesh, of each kind and order."""
    found = []
    for rows in mesh.boundary():
        kind = "triangle" if kinds.order_of("triangle", rows.shape[1]) else "quadrilateral"
        found.append((kind, kinds.order_of(kind, rows.shape[1]), rows))
    return found


def _find_crossings(nodes, sides, found, progress):
    crossing, open_ones, touching, given_up = extension().surface_crossings(nodes, sides, progress)
    found.curved_intersections, found.not_proven_apart = len(crossing), len(open_ones)
    found._crossings = crossing, open_ones, touching
    word = "triangles" if all(kind == "triangle" for kind, *_ in sides) else "sides"
    for pairs, said in ((crossing, ("crosses", "cross")), (open_ones, ("is not proven apart", "are not proven apart"))):
        if len(pairs):
            x, y, z = _middle(nodes, sides, pairs[0][0])
            text = f"1 pair of {word} {said[0]}, at" if len(pairs) == 1 else f"{len(pairs):,} pairs of {word} {said[1]}, one at"
            found.notes.append(f"{text} ({x:.4g}, {y:.4g}, {z:.4g}) mm")
    if given_up:
        found.notes.append(f"{given_up:,} of these pairs were not compared to the end, as where bodies lie on each other")


def _name_doubled(mesh, found):
    twice = conformity.doubled([block for block in mesh.blocks if kinds.DIMENSION[block.kind] == mesh.dimension])
    if twice:
        kind, first, second = twice[0]
        more = f", and {len(twice) - 1:,} more pairs likewise" if len(twice) > 1 else ""
        found.notes.append(f"{kinds.PLURALS[kind]} {first} and {second} have the same corners{more}: take one of them out of the mesh")


def _middle(nodes, sides, number):
    """The middle of a side by its corners."""
    for kind, _, rows in sides:
        if number < len(rows):
            return nodes[rows[number, :kinds.CORNERS[kind]]].mean(axis=0)
        number -= len(rows)
    raise IndexError(number)


def _find_overlaps(mesh, found, progress):
    whole = bodies.solids(mesh.blocks)
    solids = [(block.kind, block.order, block.nodes, [(kind, block.order, local[None]) for kind, local in
                                         kinds.faces_of(block.kind, block.nodes.shape[1])]) for block in whole]
    found._overlaps = extension().common_points(mesh.nodes, solids, bodies.of_elements(whole), progress)
    found.overlapping_bodies = len(found._overlaps)
    if found._overlaps:
        x, y, z = found._overlaps[0][2]
        said = "1 pair of bodies lies in one another, at" if found.overlapping_bodies == 1 else \
            f"{found.overlapping_bodies:,} pairs of bodies lie in one another, one at"
        found.notes.append(f"{said} ({x:.4g}, {y:.4g}, {z:.4g}) mm")


def _measure(mesh, surface, shape, found, progress):
    """Against the shape, where there are cut_surface.triangles_of_surface."""
    order, nodes, rows = surface
    if rows is None:
        found.notes.append("the surface was not measured against the shape: it is not of triangles of one order")
        return
    if is_between_solids(mesh):
        found.notes.append("the surface was not measured against the shape: there are triangles between solids of the mesh")
        return
    try:
        face, quality, deviation = extension().measure_given_surface(nodes, order, rows, shape, progress)
    except (InvalidInput, TopologyError, GeometryError) as error:
        found.not_on_shape = str(error)
        found.notes.append(f"the surface was not measured against the shape: {error}")
        return
    found.triangle_face, found.triangle_deviation = face, deviation
    found.max_deviation = float(deviation.max(initial=0.0))
    found._folded_on_cad = np.flatnonzero(~(quality > 0.0)).tolist()
    found.folded_on_cad = len(found._folded_on_cad)
    if mesh.dimension == 2:
        _follow_cad(found, quality)


def _follow_cad(found, quality):
    """Triangles of a surface mesh that turn by 90 degrees or more are valid where they follow the CAD normal all over."""
    block = next(i for i, (kind, *_) in enumerate(found._blocks) if kind == "triangle")
    kind, order, verdict, low = found._blocks[block]
    turning = np.flatnonzero((verdict == _FOLDED) & (quality > 0.0))
    if not len(turning):
        return
    verdict, low = verdict.copy(), low.copy()
    verdict[turning], low[turning] = _VALID, quality[turning]
    found._blocks[block] = kind, order, verdict, low
    found.distortion = tuple(low if i == block else part for i, part in enumerate(found.distortion))
    found._turning, found.folded = turning.tolist(), found.folded - len(turning)
    named = {f"triangle {i} {_WORDS[_FOLDED]} at" for i in found._turning}
    found.invalid_elements = [said for said in found.invalid_elements if said.partition(" (")[0] not in named]
    many = len(turning) > 1
    found.notes.append(f"{len(turning):,} triangle{'s' if many else ''} that turn{'' if many else 's'} by 90 degrees or more "
                       f"follow{'' if many else 's'} the CAD face: valid")


def _measure_from_cad(mesh, surface, shape, found, progress):
    """Measures the distances of the CAD from the mesh; triangles listed between bodies count, too."""
    order, nodes, rows = surface
    listed = [block.nodes for block in mesh.blocks if block.kind == "triangle" and block.order == order]
    rows = np.concatenate([rows, *listed]) if mesh.dimension == 3 else rows
    try:
        by_face, farthest, spacing, *found._grids = extension().cad_distances(nodes, order, rows, shape, progress)
    except (InvalidInput, TopologyError, GeometryError) as error:
        found.notes.append(f"the shape was not measured against the mesh: {error}")
        return
    found.face_deviation = np.zeros(len(shape.Faces))
    found.face_deviation[:len(by_face)] = by_face
    found.cad_deviation, found.cad_spacing = float(found.face_deviation.max(initial=0.0)), float(spacing)
    size = shape.BoundBox.DiagonalLength
    usual = _UNKNOWN * size if found.max_deviation is None else max(found.max_deviation, 1e-6 * size)
    if found.cad_deviation > _LEFT_OUT * usual:
        x, y, z = farthest
        found.notes.append(f"the mesh leaves out a part of Face{int(found.face_deviation.argmax()) + 1}, which is "
                           f"{found.cad_deviation:.3g} mm from it at ({x:.4g}, {y:.4g}, {z:.4g}) mm")


def is_between_solids(mesh):
    """Whether triangles that a mesh lists beside its volume elements are faces of two of them."""
    given = [block.nodes[:, :3] for block in mesh.blocks if block.kind == "triangle"]
    if mesh.dimension < 3 or not given:
        return False
    faces = [block.nodes[:, list(face)] for block in bodies.solids(mesh.blocks) for face in kinds.FACES[block.kind] if len(face) == 3]
    faces, counts = np.unique(np.sort(np.concatenate(faces), axis=1), axis=0, return_counts=True) if faces \
        else (np.empty((0, 3)), np.empty(0))
    inner, listed = faces[counts == 2], np.unique(np.sort(np.concatenate(given), axis=1), axis=0)
    return len(np.unique(np.concatenate([inner, listed]), axis=0)) < len(inner) + len(listed)
