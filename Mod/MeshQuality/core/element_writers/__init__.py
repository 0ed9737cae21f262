# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writers of meshes of any kind of element."""
