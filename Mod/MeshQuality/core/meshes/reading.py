# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads meshes that others made: from files, from FEM meshes of FreeCAD, and from meshes of this package."""

import importlib
import os
import struct
import xml.etree.ElementTree as ElementTree
import zlib

from ... import formats
from ...errors import Error, InvalidInput, IoError
from ..elements import freecad_mesh
from ..elements.assembly import assembled
from ..sources import convert
from .writing import checked_scale

# Exceptions, our own and those of libraries, that reading a damaged file raises.
_DAMAGE = (ValueError, LookupError, TypeError, AttributeError, ArithmeticError, AssertionError, EOFError, MemoryError,
           RuntimeError, OSError, struct.error, zlib.error, ElementTree.ParseError)


def content_of_file(path, scale):
    """The Content of a file; see read_mesh."""
    name = os.fsdecode(convert.file_name(path))
    scale = checked_scale(scale)
    suffix = formats.known_suffix(os.path.splitext(name)[1], formats.READABLE)
    if suffix is None:
        raise IoError(f"cannot read '{name}': elements are read from files with a name that ends in one of "
                      f"{' '.join(formats.READABLE)}")
    if not os.path.isfile(name):
        raise IoError(f"cannot read '{name}': there is no such file")
    title, module = formats.READABLE[suffix]
    reader = importlib.import_module(f"..formats.{module}", __package__)
    try:
        return assembled(reader.read(name), scale)
    except Error as error:
        raise type(error)(f"cannot read '{name}': {error}") from error
    except _DAMAGE as error:
        words = " ".join(str(error).split())[:200] or type(error).__name__
        raise IoError(f"cannot read '{name}' as {title}: it is damaged, or of another format than its name says "
                      f"({words}); write it anew") from error


def content_of(source):
    """The Content of a mesh in FreeCAD; see ElementMesh.of."""
    if isinstance(source, (str, bytes, os.PathLike)):
        raise InvalidInput(f"{source!r} is the name of a file: read it by mq.read_mesh")
    return assembled(freecad_mesh.parts_of(source))
