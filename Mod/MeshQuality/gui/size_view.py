# SPDX-License-Identifier: LGPL-2.1-or-later
"""How size regions and size fields look in the tree."""

from ..compat import PlainState
from .view import badge


class SizeView(PlainState):
    """Proxy of the view of an object that gives a size field."""

    def __init__(self, view):
        view.Proxy = self

    def attach(self, view):
        """Called when the view is made, and when it is read from a file."""
        self.view = view

    def getIcon(self):
        """The path of its icon."""
        return badge.path_of("MeshQuality_SizeRegion")
