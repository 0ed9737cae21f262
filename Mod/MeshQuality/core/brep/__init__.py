# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids with exact surfaces from meshes that know their CAD."""
