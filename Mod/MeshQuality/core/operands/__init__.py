# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operands of Booleans, offsets and wraps."""
