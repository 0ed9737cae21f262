# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles that follow a metric: fewer, stretched ones in place of those of equal sides."""
