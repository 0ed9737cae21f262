# SPDX-License-Identifier: LGPL-2.1-or-later
"""sensitivity: how the points of a mesh move with a dimension of the part, a function or a property of the document."""

import FreeCAD

from ..core.following.changes import central_differences
from ..core.sources import convert
from ..errors import InvalidInput

_STEP = 1e-3  # of the value, where none is given
_CONSTRAINT = "Constraints."


def sensitivity(mesh, parameter, value=None, step=None, shape=None):
    """How much each point of a mesh moves with a parameter of its part: float64 (V, 3), mm for each unit of the parameter.

    mesh       SurfaceMesh of triangulate or follow, on the part as it is now
    parameter  function(value) that returns the Part.Shape for it, or (document object, name of a property), such as (box, "Length"),
               (sheet, "width") or (sketch, "Constraints.Radius")
    value      where; of a property, None: as it is
    step       of the central difference, in units of the parameter; None: a thousandth of the value
    shape      of a property: the document object that has the part; None: that which has the property

    The points are moved as by follow, without the moves that improve angles. A property has its value again afterwards.
    Raises InvalidInput for what is no parameter; TopologyError where the part has other faces or edges within the step; what the function
    raises.
    """
    if callable(parameter):
        if value is None:
            raise InvalidInput("value= is needed: a function is differentiated there")
        return central_differences(mesh, lambda at: convert.shape_of(parameter(at)), value, _step_at(value, step))
    if not (isinstance(parameter, tuple) and len(parameter) == 2 and isinstance(parameter[0], FreeCAD.DocumentObject)):
        raise InvalidInput(f"parameter = {parameter!r} is not allowed: give a function, or (document object, name of a property)")
    obj, name = parameter
    held = _Property(obj, name)
    value = held.value if value is None else value
    part = obj if shape is None else shape

    def shape_at(at):
        held.put(at)
        return convert.shape_of(part)

    try:
        return central_differences(mesh, shape_at, value, _step_at(value, step))
    finally:
        held.restore()


def _step_at(value, step):
    step = _STEP * abs(value) if step is None else step
    if not step > 0.0:
        raise InvalidInput(f"step = {step!r} is not allowed: it must be above 0")
    return step


class _Property:
    """A number of a document object that can be changed: `value` is the one that it had."""

    def __init__(self, obj, name):
        self._obj, self._name = obj, name
        self._sheet = obj.isDerivedFrom("Spreadsheet::Sheet")
        constraint = name.startswith(_CONSTRAINT) and hasattr(obj, "getDatum")
        if not (constraint or hasattr(obj, name)):
            raise InvalidInput(f"{obj.Label} has no property {name}")
        if any(path == name for path, _ in obj.ExpressionEngine):
            raise InvalidInput(f"{name} of {obj.Label} follows an expression: give the property that this is made of")
        self._constraint = name[len(_CONSTRAINT):] if constraint else None
        found = obj.getDatum(self._constraint) if constraint else getattr(obj, name)
        number = getattr(found, "Value", found)
        if isinstance(number, bool) or not isinstance(number, (int, float)):
            raise InvalidInput(f"{name} of {obj.Label} is no number")
        self.value, self._unit = float(number), getattr(found, "Unit", None)
        self._content = obj.getContents(name) if self._sheet else None

    def put(self, value):
        """Gives the property a value, in the units of FreeCAD: mm and degrees, and recomputes the document."""
        quantity = value if self._unit is None else FreeCAD.Units.Quantity(value, self._unit)
        if self._constraint is not None:
            self._obj.setDatum(self._constraint, quantity)
        elif self._sheet:
            self._obj.set(self._name, f"={quantity}")
        else:
            setattr(self._obj, self._name, value)
        self._obj.Document.recompute()

    def restore(self):
        """Gives it what it had."""
        if self._sheet:
            self._obj.set(self._name, self._content)
            self._obj.Document.recompute()
        else:
            self.put(self.value)
