# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shape of a container with each part once.

FreeCAD lists what lies in a plain group within an App::Part twice: by the group, and by the part. The locations of the
two are equal, but made one by one, so that OpenCASCADE takes them for two things at one place.
"""

import FreeCAD


def each_once(shape):
    """The compound without the parts that it lists again at the same place; the shape itself where there are none."""
    return _rest(shape, FreeCAD.Placement(), {})[0] or shape


def _rest(compound, frame, known):
    """(the compound without parts that are known, or none where it has none of these; how many parts it has left)."""
    import Part

    if compound.ShapeType != "Compound":
        return None, 1
    frame, left, changed = frame.multiply(compound.Placement), [], False
    for part in compound.childShapes(False, False):
        if part.ShapeType != "Compound" and _is_known(part, frame, known):
            changed = True
            continue
        rest, count = _rest(part, frame, known)
        changed = changed or rest is not None
        if count:
            left.append(rest or part)
    if not changed:
        return None, len(left)
    made = Part.makeCompound(left)
    made.Placement = compound.Placement
    return made, len(left)


def _is_known(part, frame, known):
    """Whether the part was met before at this place; it is known from now on."""
    first = tuple(part.Vertexes[0].Point) if part.Vertexes else ()
    there = known.setdefault((frame.multiply(part.Placement).toMatrix().A, first), [])
    if any(part.isPartner(other) for other in there):
        return True
    there.append(part)
    return False
