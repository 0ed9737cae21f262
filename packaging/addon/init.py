# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD executes when it starts, with or without a window: the types of files of its File menu."""

from MeshQuality import exchange

exchange.register()
