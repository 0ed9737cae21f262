# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size fields by values at nodes."""

import numpy as np

from ...compat import extension
from ...errors import InvalidInput


class Interpolated:
    """Sizes at the nodes of simplices, linear in these; of single points by the distances of the nearest ones."""

    def __init__(self, nodes, simplices, sizes, name):
        self.name = name
        self._nodes, self._simplices, self._sizes = nodes, simplices, sizes
        self._core = extension().SimplexField(nodes, simplices, sizes)

    def sizes(self, points):
        """float64 (n,), mm."""
        return self._core.at(points)

    def arrays(self):
        """Nodes, simplices and sizes."""
        return self._nodes, self._simplices, self._sizes

    def marks(self):
        """Each node has a feature as small as its size."""
        return self._nodes, self._sizes


def interpolated(nodes, simplices, sizes, name):
    """The Interpolated of arrays whose values are sizes. Raises InvalidInput naming a bad one and its place."""
    require_sizes(nodes, sizes, name)
    return Interpolated(nodes, simplices, sizes, name)


def require_sizes(points, sizes, name):
    """Raises InvalidInput where a size is not a number, or not above 0, with the place."""
    bad = ~(sizes > 0.0)
    if not bad.any():
        return
    i = int(np.argmax(bad))
    place = ", ".join(f"{c:.6g}" for c in points[i])
    said = "has a hole: no size" if np.isnan(sizes[i]) else f"has a size of {sizes[i]:.6g} mm"
    raise InvalidInput(f"{name} {said} at ({place}) mm, one of {int(bad.sum())} such places: sizes must be above 0 mm everywhere "
                       "(infinity: no bound)")
