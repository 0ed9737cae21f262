# SPDX-License-Identifier: LGPL-2.1-or-later
"""The errors of MeshQuality. Their text is a sentence that names the fault and the remedy."""


class Error(RuntimeError):  # noqa: N818 - the public name is MeshQuality.Error
    """Base of all errors of MeshQuality."""


class InvalidInput(Error):
    """An option, a shape or a mesh that cannot be worked on as it was given."""


class TopologyError(Error):
    """Faces, edges or triangles do not fit together."""


class GeometryError(Error):
    """A surface or a curve cannot be evaluated where it is needed."""


class Cancelled(Error):
    """The operation was asked to stop; nothing was changed."""


class IoError(Error):
    """A file cannot be read or written."""


class MissingBinary(Error, ImportError):
    """The part written in C++ is missing, or belongs to another FreeCAD."""


for _error in (Error, InvalidInput, TopologyError, GeometryError, Cancelled, IoError,
               MissingBinary):
    _error.__module__ = "MeshQuality"
del _error
