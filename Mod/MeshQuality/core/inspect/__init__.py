# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of wall thickness, clearance, draft and voids."""
