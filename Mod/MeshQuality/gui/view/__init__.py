# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view and the tree show of a mesh."""
