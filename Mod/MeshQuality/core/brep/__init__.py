# SPDX-License-Identifier: LGPL-2.1-or-later
"""The CAD faces on which meshes lie that were made of shapes."""
