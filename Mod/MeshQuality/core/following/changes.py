# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the points of a mesh move with a parameter of its part."""

from ...errors import TopologyError
from ..places.entities import Entities, differences
from ..places.places import Places
from .follow import shape_of_mesh
from .moving import moved


def central_differences(mesh, shape_at, value, step):
    """float64 (V, 3): d(point) / d(parameter) by the shapes at value - step and value + step.

    shape_at  function(value) -> Part.Shape
    Raises TopologyError naming the faces where one of them has other faces or edges than the shape of the mesh.
    """
    before = Entities(shape_of_mesh(mesh))
    places, found = Places(mesh, before), []
    for at in (value - step, value + step):
        after = Entities(shape_at(at))
        reasons = differences(before, after)
        if reasons:
            raise TopologyError(f"there is no derivative: at the value {at:.6g} {reasons[0]}")
        found.append(moved(places, after)[0])
    return (found[1] - found[0]) / (2.0 * step)
