# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between versions and builds of FreeCAD, in one place."""

import importlib


def core():
    """The extension module MeshQuality._core.

    Raises ImportError with the remedy where it is missing or belongs to another FreeCAD.
    """
    try:
        return importlib.import_module("MeshQuality._core")
    except ModuleNotFoundError as error:
        if error.name != "MeshQuality._core":
            raise
        raise ImportError("MeshQuality's extension module is not built for this Python: run "
                          "tools/build in MeshQuality's folder") from error


def flags(buttons):
    """What getStandardButtons of a task panel returns; the flags of Qt 6 are no numbers."""
    return int(getattr(buttons, "value", buttons))


class PlainState:
    """Proxy of a document object that keeps all of its state in properties.

    FreeCAD up to 0.21.1 asks for __getstate__ and __setstate__, later ones for dumps and loads.
    """

    def dumps(self):
        """Nothing to save besides the properties."""
        return None

    def loads(self, state):
        """Nothing to restore besides the properties."""

    __getstate__ = dumps
    __setstate__ = loads
