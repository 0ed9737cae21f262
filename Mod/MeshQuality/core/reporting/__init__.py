# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of meshes as pages with pictures."""
