# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Hollow": a wall that follows a solid of the document, with openings."""

import json

import FreeCAD
import numpy as np

from .. import options, phrases
from ..compat import property_of
from ..core.certify import verdict
from ..core.offsetting import run_hollow
from ..core.sources import convert
from ..errors import InvalidInput
from . import face_matching, offset, transactions
from .gui_hooks import window

_OF_HOLLOW = (
    ("HollowTriangles", "App::PropertyInteger", "Number of triangles of the surface of the hollow"),
    ("HollowVolume", "App::PropertyVolume", "Volume of a closed hollow, which is what it saves; 0 where it has openings"),
)
_FACES = ("OpeningFaces", "App::PropertyString",
          "What the faces of the source were like when the openings were last right: their kinds, areas and centres")


class HollowObject(offset.SolidMesh):
    """Proxy of a Mesh::FeaturePython that holds a wall along the surface of its source.

    After an edit of the source the openings are found again, as the faces of patches are.
    """

    COMMAND, CALL = "MeshQuality_Hollow", "add_hollow"
    SOURCE, NEEDS = "The object whose solid is hollowed", "a shape or a mesh"
    OPTIONS = options.offset.HOLLOW_OBJECT
    MEASURED = (*offset.SolidMesh.MEASURED, *_OF_HOLLOW)
    HIDDEN = (*offset.SolidMesh.HIDDEN, _FACES)

    @classmethod
    def given_of(cls, source, values, obj):
        """The Given, with the openings."""
        return _OpenGiven(source, values["openings"], obj.OpeningFaces if obj is not None else "")

    @classmethod
    def compute(cls, given, values, progress):
        """The mesh and what belongs to it."""
        mesh = run_hollow(given.operands, given.faces, values, progress)
        return mesh, mesh.to_mesh(), verdict.of_boolean(mesh), given

    def take(self, obj, result):
        """Shows the mesh and its report, and the openings by their present names."""
        finished, (mesh, *_, given) = super().take(obj, result), result
        obj.HollowTriangles = int(np.count_nonzero(mesh.triangle_source[:, 0] == 1))
        obj.HollowVolume = 0.0 if given.names else _volume_of(mesh)
        obj.Openings, obj.OpeningFaces = given.names or [], given.described
        obj.Notes = [*obj.Notes, *given.lost]
        for sentence in given.lost:
            FreeCAD.Console.PrintWarning(f"{obj.Label}: {window().translated(sentence)}\n")
        return finished

    def told(self, obj):
        """A Text if there is no hollow, or a sealed one with its volume."""
        if not obj.Fingerprint:
            return None
        if not obj.HollowTriangles:
            return phrases.Text(phrases.STAYS_WHOLE)
        hollow = property_of(obj, "HollowVolume").Value
        if not hollow:
            return None
        share = hollow / (hollow + property_of(obj, "Volume").Value)
        return phrases.Text(phrases.HOLLOW_SEALED, volume=f"{hollow:.4g} mm³", number=f"{100.0 * share:.3g}")


def _volume_of(mesh):
    """The volume in mm³ that the surface of the hollow encloses: its triangles face inwards."""
    a, b, c = np.moveaxis(mesh.vertices[mesh.triangles[mesh.triangle_source[:, 0] == 1]].astype(float), 1, 0)
    return max(-float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6.0, 0.0)


class _OpenGiven(offset.Given):
    """The shape or the mesh of a source with openings.

    names      of their faces, such as "Face3", or "Box.Face3" below a container; None: no openings
    faces      the same as indices of the faces of the shape
    described  what the faces are like, with the names, as text
    lost       sentences about openings that an edit may have exchanged
    """

    def __init__(self, source, names, before):
        super().__init__(source)
        self.names, self.lost, self.faces, self.described = names, [], None, ""
        if not names:
            return
        if not self.operands.is_shape(0):
            raise InvalidInput(phrases.Text(phrases.OPENINGS_OF_MESH, name=convert.label_of(source)))
        own = convert.own_shape_of(source)
        faces = face_matching.described(own)
        self.names, self.lost = _followed(names, before, faces)
        self.faces = sorted({int(_face_of(source, name, len(own.Faces))[4:]) - 1 for name in self.names})
        self.described = json.dumps({"names": self.names, "faces": faces})

    def digest(self, values):
        """A hash by the present names of the openings."""
        return super().digest({**values, "openings": self.faces})


def _followed(names, before, now):
    """(present names of the openings, sentences about those that are not found again).

    before  the described text of the last result; openings that are others than there were chosen since
    now     what the faces are like
    """
    try:
        held = json.loads(before or "{}")
        places = face_matching.followed(held["faces"], now) if held.get("names") == names else None
        same = places is None
    except (ValueError, KeyError, TypeError, IndexError, AttributeError):  # edited by hand
        same = True
    if same:
        return names, []
    found, lost = [], []
    for name in names:
        index = places.get(int(name[4:]) - 1) if "." not in name else None
        if index is None and "." not in name:
            lost.append(phrases.Text(phrases.OPENING_LOST, face=name))
        found.append(name if index is None else f"Face{index + 1}")
    return found, lost


def _face_of(source, name, count):
    """The name "Face12" that an opening has in the shape of the source, which has `count` faces."""
    label = convert.label_of(source)
    try:
        plain, = convert.resolve_sizes(source, {name: 1.0})
    except InvalidInput:
        raise InvalidInput(phrases.Text(phrases.OPENING_ELSEWHERE, value=name, name=label)) from None
    if int(plain[4:]) > count:
        raise InvalidInput(phrases.Text(phrases.NO_OPENING, value=name, name=label, face=f"Face{count}"))
    return plain


def add_hollow(source, thickness, openings=None, tolerance=None):
    """Adds a document object that keeps a wall of a solid of the document up to date; one undo step.

    source     document object with a shape or a closed mesh: feature, body, mesh, link or container
    thickness  mm; the wall grows inward
    openings   names of faces of the shape that get no wall, as in ["Face3", "Face7"], of a container also "Box.Face3";
               None: the hollow is closed
    tolerance  as for hollow

    After an edit of the source the openings are found again by kind, area and place; where that is not possible the
    property Notes and a warning name them.
    Returns the object. Raises what hollow raises, and then adds nothing.
    """
    values = {"thickness": thickness, "openings": openings, "tolerance": tolerance}
    return transactions.add_of_source(HollowObject, source, values, "Hollow", "Hollow")
