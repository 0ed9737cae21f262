# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects, one a file. Documents store these module paths: they stay for good."""
