# SPDX-License-Identifier: LGPL-2.1-or-later
"""The longest edge of a FEM mesh where none is given: by the walls of the shape."""

import math

# Elements that a mesh of tetrahedra has, expected: its volume over the cube of its longest edge, times this. Measured as 8.4 to
# 9.4 on a cantilever, a bracket and a shaft (benchmarks/solvers/fem_stress.py); faces that bend take more.
_TETRAHEDRA = 9.0
_TRIANGLES = 5.0  # the same factor for a mesh of shells: its area over the square of its longest edge
_MOST = 100_000  # elements expected: CalculiX takes some minutes and gigabytes for quadratic ones
_SHELL_SIZES = 10.0  # longest edges along a shell, for one element through the walls


def longest_edge(shape, values):
    """(length, note): the longest edge of a FEM mesh with these options, in mm, and a sentence if the number of elements
    limits it, or "".

    Of solids: the mean wall thickness, twice the volume over the area of the surface, over `elements_through`. A plate
    has as many elements through its thickness, a round bar twice as many through its diameter.
    """
    if values["max_edge"] is not None:
        return values["max_edge"], ""
    through = values["elements_through"]
    volume, area = _measures(shape, values)
    if volume > 0.0:
        length, shortest = 2.0 * volume / (area * through), (_TETRAHEDRA * volume / _MOST) ** (1.0 / 3.0)
    else:
        length, shortest = shape.BoundBox.DiagonalLength / (_SHELL_SIZES * through), math.sqrt(_TRIANGLES * area / _MOST)
    if length >= shortest:
        return length, ""
    return shortest, (f"edges are up to {shortest:.3g} mm long in place of {length:.3g} mm, which would take more than "
                      f"{_MOST:,} elements: give max_edge (Longest edge) to have more")


def expected_elements(shape, values):
    """About how many elements a FEM mesh with these options will have; faces that bend take more."""
    volume, area = _measures(shape, values)
    length = longest_edge(shape, values)[0]
    return round(_TETRAHEDRA * volume / length**3 if volume > 0.0 else _TRIANGLES * area / length**2)


def _measures(shape, values):
    """Volume of the solids that are filled, 0 where there are none, and area of the surface."""
    solids = shape.Solids if values["volume"] else []
    measured = solids or [shape]
    return sum(abs(solid.Volume) for solid in solids), sum(part.Area for part in measured)
