# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size fields: edge lengths by their places."""
