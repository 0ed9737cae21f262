# SPDX-License-Identifier: LGPL-2.1-or-later
"""certify: which elements of a mesh are proven valid, whoever made it."""

import os

import numpy as np

from .. import options
from ..compat import extension
from ..errors import InvalidInput
from ..listing import Public
from . import convert
from .element_mesh import ElementMesh
from .elements import conformity, kinds

_VALID, _FOLDED, _INVERTED, _NOT_PROVEN = range(4)  # verdicts of the core
_WORDS = {_FOLDED: "folded", _INVERTED: "numbered the wrong way round", _NOT_PROVEN: "not proven valid"}
_ON_CAD = 5  # highest order of triangles that are measured against a shape


class MeshCertificate(metaclass=Public):
    """What was proven of a mesh that anybody made.

    elements          {kind: how many}
    invalid           elements that are not proven valid: folded, inverted or not proven
    folded            somewhere J <= 0 (of triangles and quadrilaterals: the normal turns by 90 degrees or more)
    inverted          J < 0 everywhere: the nodes are numbered the wrong way round
    not_proven        neither proven valid nor folded
    invalid_elements  which these are: "tetrahedron 22 folded at (1, 2, 3) mm"
    min_distortion    the smallest proven lower bound of min J / max |J|, equation (3) of Dey, O'Bara, Shephard 1999
    distortion        float64 (E,) by block of the mesh: these bounds, in the order of its elements
    conforming        whether no face has more than two elements
    oriented          whether neighbours are seen from the same side
    max_deviation     largest distance of the surface from its CAD faces, mm; None without a shape
    folded_on_cad     triangles of the surface that fold over their CAD face; None without a shape
    triangle_face     int32 (F,), the CAD face of each triangle of the surface, as mesh.boundary() has them; likewise
    triangle_deviation
                      float64 (F,), mm, the largest distance of each
    notes             sentences about the mesh that a user should know
    """

    __slots__ = {
        "elements": "{kind: how many}", "folded": "how many", "inverted": "how many", "not_proven": "how many",
        "invalid_elements": "which, and where", "distortion": "float64 (E,) by block", "conforming": "True or False",
        "oriented": "True or False", "max_deviation": "mm, or None", "folded_on_cad": "how many, or None",
        "triangle_face": "int32 (F,), or None", "triangle_deviation": "float64 (F,), mm, or None", "notes": "sentences"}

    def __init__(self):
        self.elements, self.distortion, self.invalid_elements, self.notes = {}, (), [], []
        self.folded = self.inverted = self.not_proven = 0
        self.conforming = self.oriented = True
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
                 "conforming", "oriented", "max_deviation", "folded_on_cad", "notes")
        return {name: getattr(self, name) for name in names}

    def __str__(self):
        counts = ", ".join(f"{count:,} {kinds.PLURALS[kind] if count != 1 else kind}"
                           for kind, count in self.elements.items())
        lines = [f"elements     {counts}",
                 f"invalid      {self.invalid:,}: {self.folded:,} folded, {self.inverted:,} numbered the wrong way round, "
                 f"{self.not_proven:,} not proven",
                 f"distortion   {self.min_distortion:.3g} at least",
                 f"conforming   {'yes' if self.conforming else 'no'}, oriented {'yes' if self.oriented else 'no'}"]
        if self.max_deviation is not None:
            lines.append(f"deviation    {self.max_deviation:.3g} mm at most, {self.folded_on_cad:,} triangles fold over "
                         "their CAD face")
        return "\n".join([*lines, *(f"note         {note}" for note in self.notes)]) + "\n"

    def __repr__(self):
        said = f"{self.invalid:,} not proven valid" if self.invalid else "all proven valid"
        return f"<MeshCertificate: {sum(self.elements.values()):,} elements, {said}>"


def certify(mesh, shape=None, progress=None):
    """Proves which elements of a mesh are valid: a MeshCertificate.

    mesh      the path of a file that mq.read_mesh takes, or anything that ElementMesh.of takes: triangles,
              quadrilaterals, tetrahedra, prisms, pyramids and hexahedra of orders 1 to 5
    shape     Part.Shape or document object; the surface of the mesh is measured against it, where it is of triangles
    progress  as for curve

    Validity is proven by Bernstein bounds of the Jacobian, see docs/method/validity.md. Nothing is changed.
    Raises IoError, InvalidInput naming the element; with a shape, TopologyError and GeometryError naming what does not
    lie on it; Cancelled.
    """
    options.require_callable(progress)
    mesh = given_mesh(mesh)
    found = MeshCertificate()
    found.notes += mesh.faults
    _prove(mesh, found, progress)
    found.conforming, found.oriented = conformity.of_blocks(mesh.blocks)
    if shape is not None:
        _measure(mesh, convert.shape_of(shape), found, progress)
    return found


def given_mesh(mesh):
    """The ElementMesh of a path or of what ElementMesh.of takes."""
    return ElementMesh.read(mesh) if isinstance(mesh, (str, os.PathLike)) else ElementMesh.of(mesh)


def _prove(mesh, found, progress):
    highest = mesh.dimension
    if highest < 2:
        raise InvalidInput("the mesh has lines only: nothing of it can be certified")
    parts = []
    for block in mesh.blocks:
        if kinds.DIMENSION[block.kind] < highest:
            parts.append(np.empty(0))
            continue
        low, _, verdict = extension().check_elements(block.kind, block.order, mesh.nodes, block.nodes, progress)
        parts.append(low)
        found.elements[block.kind] = found.elements.get(block.kind, 0) + len(block.nodes)
        for name, number in (("folded", _FOLDED), ("inverted", _INVERTED), ("not_proven", _NOT_PROVEN)):
            setattr(found, name, getattr(found, name) + int((verdict == number).sum()))
        for i in np.flatnonzero(verdict != _VALID):
            x, y, z = mesh.nodes[block.nodes[i]].mean(axis=0)
            found.invalid_elements.append(f"{block.kind} {i} {_WORDS[verdict[i]]} at ({x:.4g}, {y:.4g}, {z:.4g}) mm")
    found.distortion = tuple(parts)


def _measure(mesh, shape, found, progress):
    """Against the shape, where the surface is one of triangles of one order."""
    surface = mesh.boundary()
    orders = [kinds.order_of("triangle", part.shape[1]) for part in surface]
    if len(surface) != 1 or orders[0] is None or orders[0] > _ON_CAD:
        found.notes.append("the surface was not measured against the shape: it is not of triangles of one order")
        return
    face, quality, deviation = extension().measure_given_surface(mesh.nodes, orders[0], surface[0], shape, progress)
    found.triangle_face, found.triangle_deviation = face, deviation
    found.max_deviation = float(deviation.max(initial=0.0))
    found.folded_on_cad = int((~(quality > 0.0)).sum())
