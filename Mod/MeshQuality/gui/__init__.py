# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user sees: commands, panels, view providers. The only part that may import Qt."""
