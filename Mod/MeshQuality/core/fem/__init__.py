# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of FreeCAD's FEM workbench."""
