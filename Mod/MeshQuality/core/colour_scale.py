# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one scale of colours by which quality is shown: red is bad, blue is good."""

import numpy as np

# Where on the scale, red, green, blue: red, yellow, green, blue.
_STOPS = np.array([[0.0, 0.85, 0.1, 0.1], [0.3, 0.95, 0.85, 0.1], [0.6, 0.2, 0.75, 0.3],
                   [1.0, 0.2, 0.4, 0.9]])
GREEN = _STOPS[2, 0]
_NONE = 0.62  # grey: what has no number


def colours_of(goodness):
    """float (n, 3): the colours of numbers from 0, bad, to 1, good; others get the nearer end's, what is not a number grey."""
    known = np.clip(np.nan_to_num(goodness, nan=0.0), 0.0, 1.0)
    colours = np.column_stack([np.interp(known, _STOPS[:, 0], _STOPS[:, k]) for k in (1, 2, 3)])
    colours[np.isnan(goodness)] = _NONE
    return colours


def bytes_of(goodness):
    """uint8 (n, 4): the same colours, opaque."""
    rgb = np.rint(255 * colours_of(goodness)).astype(np.uint8)
    return np.column_stack([rgb, np.full(len(rgb), 255, dtype=np.uint8)])
