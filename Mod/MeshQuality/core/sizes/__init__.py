# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size fields: edge lengths by their places."""

RATIO = 1.3  # promised bound on the length of an edge, divided by the field at its middle
