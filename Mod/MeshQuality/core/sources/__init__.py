# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's objects hold: shapes, meshes, frames."""
