# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of elements, a module a format; each gives Parts, and what makes an ElementMesh of them."""
