# SPDX-License-Identifier: LGPL-2.1-or-later
"""The binary BREP of FreeCAD's shapes, for an OpenCASCADE that is not FreeCAD's."""

import os
import tempfile

from ...errors import GeometryError, IoError


def bytes_of(shape):
    """What Part.Shape.exportBinary writes: all bits, and no triangulation. The shape is not changed.

    It lies in memory only where the system has files there; elsewhere it is a file for a moment. Raises GeometryError for
    shapes that FreeCAD cannot write, IoError where there is no place for the file.
    """
    return _by_memory(shape) or _by_file(shape)


def _by_memory(shape):
    """Empty where there are no files in memory, or no names of them."""
    try:
        with open(os.memfd_create("shape"), "rb") as stream:
            return _written(shape, f"/proc/self/fd/{stream.fileno()}", stream)
    except (AttributeError, OSError):
        return b""


def _by_file(shape):
    try:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "shape.bin")
            with open(path, "w+b") as stream:
                written = _written(shape, path, stream)
    except OSError as error:
        raise IoError(f"no shape can be passed on by a file in {tempfile.gettempdir()}: {error.strerror}; "
                      "set TMPDIR to a folder that can be written") from error
    if not written:  # FreeCAD does not say so
        raise IoError(f"FreeCAD cannot write a shape into {tempfile.gettempdir()}: set TMPDIR to another folder")
    return written


def _written(shape, path, stream):
    import Part

    try:
        shape.exportBinary(path)
    except Part.OCCError as error:
        raise GeometryError(f"FreeCAD cannot write the shape: {error}") from error
    return stream.read()
