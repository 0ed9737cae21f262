# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Quality Mesh": a mesh that follows a shape of the document."""

import hashlib
import json

import FreeCAD

from .. import convert, options
from ..api import triangulate
from ..compat import PlainState
from ..errors import Error, InvalidInput

# Name, type, what it says. All read-only, measured on the mesh that the object holds.
MEASURED = (
    ("Triangles", "App::PropertyInteger", "Number of triangles"),
    ("Vertices", "App::PropertyInteger", "Number of vertices"),
    ("Closed", "App::PropertyBool", "No border edge"),
    ("Oriented", "App::PropertyBool", "Neighbouring triangles agree on outside"),
    ("Manifold", "App::PropertyBool", "No edge of three or more triangles, no pinched vertex"),
    ("MeasuredMinAngle", "App::PropertyAngle", "Smallest angle of all triangles"),
    ("MeasuredMaxAngle", "App::PropertyAngle", "Largest angle of all triangles"),
    ("MaxChordHeight", "App::PropertyLength", "Largest measured distance to the shape"),
    ("Exempt", "App::PropertyStringList", "Triangles below the angle asked for, and why"),
    ("Notes", "App::PropertyStringList", "What else happened on the way"),
)
FINGERPRINT = "Fingerprint"


class QualityMesh(PlainState):
    """Proxy of a Mesh::FeaturePython. Its state is in the object's properties."""

    def __init__(self, obj):
        obj.Proxy = self
        add_properties(obj)

    def onDocumentRestored(self, obj):
        """Documents of older versions get the properties that were added since."""
        add_properties(obj)

    def execute(self, obj):
        """Meshes the source anew, unless neither it nor an option has changed."""
        self.error = None
        try:
            self._update(obj)
        except (Error, ImportError, MemoryError) as error:
            self.error = error
            raise type(error)(f"{obj.Label}: {error}") from error

    def _update(self, obj):
        if obj.Source is None:
            raise InvalidInput("Source is empty: choose an object with a shape")
        values = options_of(obj)
        options.check(options.TRIANGULATE, values)
        shape = convert.shape_of(obj.Source)
        fingerprint = fingerprint_of(shape, values)
        if fingerprint == getattr(obj, FINGERPRINT) and obj.Mesh.CountFacets > 0:
            return
        mesh = triangulate(shape, **values)
        obj.Mesh = mesh.to_mesh()
        show_report(obj, mesh.report)
        setattr(obj, FINGERPRINT, fingerprint)


def add_properties(obj):
    """Adds those properties that the object has not got yet."""
    present = set(obj.PropertiesList)

    def add(kind, name, group, text):
        if name in present:
            return False
        obj.addProperty(kind, name, group, text)
        return True

    # Global: a mesh may follow a shape inside a container that it does not belong to itself.
    add("App::PropertyLinkGlobal", "Source", "Mesh", "The object whose shape is meshed")
    for option in options.TRIANGULATE:
        unit = "" if option.default is not None else "; 0: no bound"
        name = option.property_name
        if add(option.property_type, name, option.group, option.help + unit):
            if option.choices:
                setattr(obj, name, list(option.choices))
            setattr(obj, name, options.to_property(option, option.default))
    for name, kind, text in MEASURED:
        add(kind, name, "Quality", text)
        obj.setEditorMode(name, 1)
    add("App::PropertyString", FINGERPRINT, "Mesh", "Of the shape and the options of this mesh")
    obj.setEditorMode(FINGERPRINT, 2)


def options_of(obj):
    """{option: value} of the object's properties."""
    return {option.name: options.from_property(option, getattr(obj, option.property_name))
            for option in options.TRIANGULATE}


def set_options(obj, values):
    """Sets the properties of {option: value}, checked before."""
    for option in options.TRIANGULATE:
        setattr(obj, option.property_name, options.to_property(option, values[option.name]))


def fingerprint_of(shape, values):
    """Changes whenever the shape or an option does; the same after saving and loading."""
    digest = hashlib.sha256(shape.exportBrepToString().encode())
    digest.update(json.dumps(values, sort_keys=True).encode())
    return digest.hexdigest()


def show_report(obj, report):
    """Fills the group Quality."""
    obj.Triangles, obj.Vertices = report.triangles, report.vertices
    obj.Closed, obj.Oriented, obj.Manifold = report.closed, report.oriented, report.manifold
    obj.MeasuredMinAngle, obj.MeasuredMaxAngle = report.min_angle, report.max_angle
    obj.MaxChordHeight = max(report.max_chord_height, 0.0)
    obj.Exempt = [f"triangle {triangle}: {why}" for triangle, why in report.exempt]
    obj.Notes = list(report.notes)


def add(source, values):
    """Adds a quality mesh of `source` to its document, as one undo step of its own or as a part
    of the transaction that is open. Returns the object; on an error nothing is added.
    """
    if not isinstance(source, FreeCAD.DocumentObject):
        raise InvalidInput("a document object with a shape is needed, not "
                           f"{type(source).__name__}")
    checked = options.check(options.TRIANGULATE, values)
    document = source.Document
    # A transaction that was opened shows in the document only after its first change.
    own_transaction = not (document.HasPendingTransaction or FreeCAD.getActiveTransaction())
    if own_transaction:
        document.openTransaction("Quality mesh")
    obj = document.addObject("Mesh::FeaturePython", "QualityMesh")
    try:
        proxy = QualityMesh(obj)
        obj.Label = f"{source.Label} quality mesh"
        obj.Source = source
        set_options(obj, checked)
        if FreeCAD.GuiUp:
            obj.ViewObject.Proxy = 0
        obj.recompute()
        if proxy.error is not None:
            raise proxy.error
        obj.purgeTouched()
    except BaseException:
        document.removeObject(obj.Name)
        if own_transaction:
            document.abortTransaction()
        raise
    if own_transaction:
        document.commitTransaction()
    return obj
