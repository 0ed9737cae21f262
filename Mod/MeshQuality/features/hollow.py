# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Hollow": a wall that follows a solid of the document, with openings."""

import FreeCAD
import numpy as np

from .. import options, phrases
from ..compat import property_of
from ..core.certify import verdict
from ..core.offsetting import run_hollow, tolerance_of_hollow
from ..core.sources import convert
from ..errors import InvalidInput
from . import offset, transactions
from .chosen_faces import ChosenFaces, Said
from .gui_hooks import window

_OF_HOLLOW = (
    ("HollowTriangles", "App::PropertyInteger", "Number of triangles of the surface of the hollow"),
    ("HollowVolume", "App::PropertyVolume", "Volume of a closed hollow, which is what it saves; 0 where it has openings"),
)
_FACES = ("OpeningFaces", "App::PropertyString",
          "What the faces of the source were like when the openings were last right: their kinds, areas and centres")

_SAID = Said(phrases.OPENING_LOST, phrases.OPENING_ELSEWHERE, phrases.NO_OPENING)


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
    def kept_length(cls, sources):
        """A function from options to the tolerance."""
        return tolerance_of_hollow

    @classmethod
    def given_of(cls, source, values, obj):
        """The Given, with the openings."""
        return _OpenGiven(source, values["openings"], obj.OpeningFaces if obj is not None else "")

    @classmethod
    def compute(cls, given, values, progress):
        """The mesh and what belongs to it."""
        mesh = run_hollow(given.operands, given.openings.faces, values, progress)
        return mesh, mesh.to_mesh(), verdict.of_boolean(mesh), given

    def take(self, obj, result):
        """Shows the mesh and its report, and the openings by their present names."""
        finished, mesh, openings = super().take(obj, result), result[0], result[-1].openings
        obj.HollowTriangles = int(np.count_nonzero(mesh.triangle_source[:, 0] == 1))
        obj.HollowVolume = 0.0 if openings.names else _volume_of(mesh)
        obj.Openings, obj.OpeningFaces = openings.names or [], openings.described
        obj.Notes = [*obj.Notes, *openings.lost]
        for sentence in openings.lost:
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
    """The shape or the mesh of a source with openings, ChosenFaces."""

    def __init__(self, source, names, before):
        super().__init__(source)
        if names and not self.operands.is_shape(0):
            raise InvalidInput(phrases.Text(phrases.OPENINGS_OF_MESH, name=convert.label_of(source)))
        self.openings = ChosenFaces(source, names, before, _SAID)

    def digest(self, values):
        """A hash by the present names of the openings."""
        return super().digest({**values, "openings": self.openings.faces})


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
