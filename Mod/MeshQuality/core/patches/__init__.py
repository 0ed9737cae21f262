# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches: named groups of faces."""
