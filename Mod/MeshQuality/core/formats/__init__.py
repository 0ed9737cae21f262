# SPDX-License-Identifier: LGPL-2.1-or-later
"""Formats of meshes, a module each, with `read` where it is read and `write` where it is written here; the core writes the others."""
