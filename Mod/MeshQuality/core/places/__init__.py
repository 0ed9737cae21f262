# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the points of a mesh lie on the faces, edges and vertices of its shape."""
