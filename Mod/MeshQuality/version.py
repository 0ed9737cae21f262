# SPDX-License-Identifier: LGPL-2.1-or-later
"""The version, as in package.xml. Imports nothing, so that anything may import it."""

__version__ = "0.1.0"
