# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the document objects that hold a mesh have in common."""

import FreeCAD

from .. import options
from ..compat import PlainState
from ..errors import Error


# Name, type, what it says: measured on the mesh that an object holds.
TOPOLOGY = (
    ("Triangles", "App::PropertyInteger", "Number of triangles"),
    ("Vertices", "App::PropertyInteger", "Number of vertices"),
    ("Closed", "App::PropertyBool", "No border edge"),
    ("Oriented", "App::PropertyBool", "Neighbouring triangles agree on outside"),
    ("Manifold", "App::PropertyBool", "No edge of three or more triangles, no pinched vertex"),
)


class MeshObject(PlainState):
    """Proxy of a Mesh::FeaturePython. Its state is in the object's properties.

    A subclass has add_properties(obj), which adds those the object has not got yet, and
    update(obj), which sets the mesh. An error in it leaves the last good mesh as it is.
    """

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def onDocumentRestored(self, obj):
        """Documents of older versions get the properties that were added since."""
        self.add_properties(obj)

    def execute(self, obj):
        """Brings the mesh up to date, unless nothing that it depends on has changed."""
        self.error = None
        try:
            self.update(obj)
        except (Error, ImportError, MemoryError) as error:
            self.error = error
            raise type(error)(f"{obj.Label}: {error}") from error


def add_property(obj, kind, name, group, text):
    """Adds a property, unless the object has it; returns whether it was added."""
    if name in obj.PropertiesList:
        return False
    obj.addProperty(kind, name, group, text)
    return True


def add_measured(obj, table):
    """A read-only property for each (name, type, text) of the table, in the group Quality."""
    for name, kind, text in table:
        add_property(obj, kind, name, "Quality", text)
        obj.setEditorMode(name, 1)


def add_hidden(obj, group, table):
    """A property that the editor does not show for each (name, type, text) of the table."""
    for name, kind, text in table:
        add_property(obj, kind, name, group, text)
        obj.setEditorMode(name, 2)


def show_topology(obj, report):
    """Fills the properties of TOPOLOGY."""
    obj.Triangles, obj.Vertices = report.triangles, report.vertices
    obj.Closed, obj.Oriented, obj.Manifold = report.closed, report.oriented, report.manifold


def add_options(obj, table):
    """A property for each option of the table, with its default."""
    for option in table:
        unit = "" if option.default is not None else "; 0: no bound"
        name = option.property_name
        if add_property(obj, option.property_type, name, option.group, option.help + unit):
            if option.choices:
                setattr(obj, name, list(option.choices))
            setattr(obj, name, options.to_property(option, option.default))


def options_of(obj, table):
    """{option: value} of the object's properties."""
    return {option.name: options.from_property(option, getattr(obj, option.property_name))
            for option in table}


def set_options(obj, table, values):
    """Sets the properties of {option: value}, checked before."""
    for option in table:
        setattr(obj, option.property_name, options.to_property(option, values[option.name]))


def add(document, name, title, make):
    """Adds an object and computes it, as one undo step of its own or as a part of the transaction
    that is open. `make(obj)` gives it its properties and returns its proxy.

    Returns the object; on an error nothing is added.
    """
    # A transaction that was opened shows in the document only after its first change.
    own_transaction = not (document.HasPendingTransaction or FreeCAD.getActiveTransaction())
    if own_transaction:
        document.openTransaction(title)
    obj = document.addObject("Mesh::FeaturePython", name)
    try:
        proxy = make(obj)
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
