# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved elements: their arrays and orders."""
