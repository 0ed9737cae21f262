# SPDX-License-Identifier: LGPL-2.1-or-later
"""Independent checks of a certificate."""
