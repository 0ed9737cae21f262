# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volume meshes with layers of prisms on walls."""
