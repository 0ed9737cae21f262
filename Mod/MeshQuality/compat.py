# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between versions and builds of FreeCAD, in one place."""

import functools
import importlib
import os
import platform
import sys

from .errors import MissingBinary
from .listing import hide_modules
from .version import __version__

# The folder that has this package, in which Python finds others, too, and the folder of the addon.
PACKAGES = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
HOME = os.path.dirname(PACKAGES)


def extension():
    """The extension module MeshQuality._core: beside the sources, or else of the Python package meshquality-core.

    Raises MissingBinary with the remedy where it is missing or belongs to another FreeCAD.
    """
    other = _search_wheel()
    try:
        return importlib.import_module("MeshQuality._core")
    except ImportError as error:
        absent = getattr(error, "name", None) == "MeshQuality._core" \
            and isinstance(error, ModuleNotFoundError)
        why = (other or "it is not there") if absent else str(error)
        raise MissingBinary(f"MeshQuality's binary for {versions()} cannot be used: {why}. "
                            f"To get it, {remedy()}") from error


@functools.lru_cache(maxsize=None)
def _search_wheel():
    """Has the package find the binary in the Python package meshquality-core, too. Returns why not where that is of
    another version; else nothing.
    """
    try:
        wheel = importlib.import_module("meshquality_core")
    except ModuleNotFoundError:
        return ""
    if wheel.__version__ != __version__:
        return f"the Python package meshquality-core is of version {wheel.__version__}, not {__version__}"
    hide_modules(wheel.__path__)
    sys.modules[__package__].__path__.extend(wheel.__path__)
    return ""


def without_traceback(function):
    """The function; where the binary is there, without the traceback of errors of ours that it raises."""
    return function if why_no_extension() else extension().without_traceback(function)


@functools.lru_cache(maxsize=None)
def why_no_extension():
    """The error of extension(); empty if it succeeds. Computed once: the binary is looked for again
    when FreeCAD starts.
    """
    try:
        extension()
    except MissingBinary as error:
        return str(error)
    return ""


def versions():
    """The version and platform that a binary must be made for, in words."""
    import FreeCAD
    import Part

    return (f"FreeCAD {'.'.join(FreeCAD.Version()[:2])}, OpenCASCADE {Part.OCC_VERSION}, "
            f"Python {sys.version_info[0]}.{sys.version_info[1]}, {platform.machine()}")


def remedy():
    """How to get the binary, as the end of a sentence; docs/install.md has all ways."""
    build = os.path.join(HOME, "tools", "build")
    if os.path.exists(build):
        return f"run 'bash {build}' and start FreeCAD again"
    return f"unpack {wheel()} into the folder {PACKAGES}, or install a package of MeshQuality made for these versions; then start FreeCAD again"


def wheel():
    """The wheel that has the binary for this FreeCAD."""
    return f"meshquality_core-{__version__}-cp{sys.version_info[0]}{sys.version_info[1]}-*.whl"


# The property of a view that has the colour of its faces: before FreeCAD 1.0, and since.
SHAPE_COLOURS = ("ShapeColor", "ShapeAppearance")


def shape_colour(view):
    """The colour of a view's faces as (red, green, blue); light grey while it is not read yet."""
    appearance = getattr(view, "ShapeAppearance", None)
    colour = appearance[0].DiffuseColor if appearance else getattr(view, "ShapeColor", None)
    return tuple(colour or (0.8, 0.8, 0.8))[:3]


def fem_source_property():
    """The property by which FreeCAD's FEM workbench finds what a mesh is of: before FreeCAD 1.0, and since."""
    import FreeCAD

    return "Part" if FreeCAD.Version()[0] == "0" else "Shape"


def fem_in_document():
    """Whether FreeCAD's FEM workbench looks for the faces of a part where the document has it, as since FreeCAD 1.0; before, it did
    without the containers around the part.
    """
    import FreeCAD

    return FreeCAD.Version()[0] != "0"


def flags(buttons):
    """What getStandardButtons of a task panel returns; the flags of Qt 6 are no numbers."""
    return int(getattr(buttons, "value", buttons))


# FreeCAD 0.20 loses 96 bytes each time that an attribute gives a quantity, a placement, a vector or a
# box (PyObjectBase::trackAttribute); 1.0 and 1.1 do not. The next two functions get these values
# without the loss.


def property_of(obj, name):
    """The value of a property of a document object."""
    return obj.getPropertyByName(name)


def attribute_of(geometry, name):
    """The value of an attribute of a Part.Shape, a Mesh.Mesh or a placement."""
    return getattr(type(geometry), name).__get__(geometry)


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
