# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes as scripts have them, read from files and written into them."""
