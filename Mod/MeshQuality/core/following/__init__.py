# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that are moved along when their part is edited."""
