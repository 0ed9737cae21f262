# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panels, and what they are made of."""
