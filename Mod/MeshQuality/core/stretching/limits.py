# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a change of triangles may not make worse."""

import numpy as np

_ALIGNED = 0.3  # least cosine between the normals of triangles and of their CAD face
LONGEST = np.sqrt(2.0)  # side in the metric


class Limits:
    """Bounds on triangles; those that are beyond may stay as they are.

    cosine    of the largest angle
    distance  mm, from the CAD face
    quality   in the metric
    verify    function(triangles, corners, group, groups): whether each group of new triangles is too far from the shape
    """

    def __init__(self, cosine, distance, quality, verify):
        self.cosine, self.distance, self.quality, self.verify = cosine, distance, quality, verify

    def broken(self, new, old):
        """Whether new triangles are beyond the bounds and worse than the worst of the old ones, both Measures by triangle."""
        return ((new.alignment < np.minimum(_ALIGNED, old.alignment)) | (new.cosine < np.minimum(self.cosine, old.cosine))
                | (new.quality < np.minimum(self.quality, old.quality)) | (new.distance > np.maximum(self.distance, old.distance)))
