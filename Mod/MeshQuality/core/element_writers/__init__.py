# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writers of meshes of any kind of element.

Those of formats that hold several kinds are modules with TYPES, by (kind, number of nodes) what the format calls it, BOUNDARIES
and write(mesh, path) of a Numbered mesh. HOPR's takes volumes and conditions instead.
"""
