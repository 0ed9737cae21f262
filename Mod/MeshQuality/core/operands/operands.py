# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operands of a Boolean: what scripts may pass, as surfaces of the core."""

import hashlib
import string
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property

import FreeCAD
import numpy as np

from ... import phrases
from ...compat import extension
from ...errors import Error, InvalidInput
from ..brep.construction import Construction
from ..meshes.surface_mesh import SurfaceMesh
from ..sources import convert, frames


@dataclass(frozen=True)
class _Mixed:
    """What a container holds: the meshes, and the Part.Shape of its shapes. They are joined to one operand."""

    meshes: convert.MeshCopy
    shape: object


class Operands:
    """Meshes and shapes on their way into the core. FreeCAD's are taken as they are at first; any thread may do the
    rest.
    """

    def __init__(self, sources):
        self._sources = sources
        self._letters = [f"operand {letter}" for letter in letters(len(sources))]
        self._names = _names(sources, self._letters)
        self._taken = [self._take(i) for i in range(len(sources))]
        # Only document objects ask for a digest.
        of_document = all(isinstance(frames.object_of(source), FreeCAD.DocumentObject) for source in sources)
        self._arrangement = frames.arrangement_of(sources) if of_document else ""
        self._own_shapes = [None if isinstance(taken, convert.MeshCopy) or not of_document
                            else convert.taken(convert.own_shape_of(source)) for taken, source in zip(self._taken, sources)]

    def is_shape(self, i):
        """Whether an operand is a shape, with no meshes in it."""
        return not isinstance(self._taken[i], (SurfaceMesh, convert.MeshCopy, _Mixed)) and not is_arrays(self._taken[i])

    def plain(self, i):
        """The Part.Shape of an operand, or the arrays of its mesh; raises InvalidInput where it has shapes and meshes."""
        taken = self._taken[i]
        if isinstance(taken, _Mixed):
            raise InvalidInput(phrases.Text(phrases.SHAPES_AND_MESHES, name=convert.label_of(self._sources[i])))
        return taken.arrays if isinstance(taken, convert.MeshCopy) else taken

    def construction(self, distance=0.0, openings=None):
        """The Construction of what is made of these operands, offset by a signed distance, mm, away from faces that are open."""
        known = [taken if isinstance(taken, SurfaceMesh) or self.is_shape(i) else None for i, taken in enumerate(self._taken)]
        return Construction(tuple(known), distance, openings)

    @cached_property
    def _core(self):
        """The core.Operands: meshes as surfaces of the core, and shapes."""
        core = extension().Operands()
        for i, name in enumerate(self._names):
            with self._naming(i):
                core.add(name, *self._read(i))
        return core

    def given_to(self, work):
        """The result of a function of core.Operands; its errors name operands by their labels, too."""
        try:
            return work(self._core)
        except Error as error:
            raise self._explained(error) from error

    def digest(self):
        """A hash of document objects as operands, and of how they stand to each other; the same after
        saving and loading, and after a container around all of them was moved.
        """
        digest = hashlib.sha256(self._arrangement.encode())
        for taken, own_shape in zip(self._taken, self._own_shapes):
            if own_shape is not None:
                digest.update(convert.shape_text(own_shape))
            copy = taken.meshes if isinstance(taken, _Mixed) else taken
            for array in copy.own_arrays if isinstance(copy, convert.MeshCopy) else ():
                digest.update(str(array.shape).encode())
                digest.update(np.ascontiguousarray(array))
        return digest.hexdigest()

    def _take(self, i):
        """A convert.MeshCopy of a mesh of FreeCAD, a SurfaceMesh or arrays as they are, the Part.Shape
        of anything else; of a container everything that is visible in it.
        """
        source = self._sources[i]
        with self._naming(i):
            if isinstance(source, SurfaceMesh) or is_arrays(source):
                return source
            if convert.is_mesh(source):
                return convert.MeshCopy(source)
            of_document = isinstance(frames.object_of(source), FreeCAD.DocumentObject)
            if not (of_document and convert.meshes_in(source)):
                return convert.taken(convert.shape_of(source))
            meshes = convert.MeshCopy(source)
            return _Mixed(meshes, convert.taken(convert.shape_of(source))) if convert.has_faces(source) else meshes

    def _read(self, i):
        """(core.Surface or None, whether it may be rounded to single precision, Part.Shape or None)"""
        taken = self._taken[i]
        if isinstance(taken, SurfaceMesh):
            return taken._surface, False, None
        if is_arrays(taken):
            return _surface_of(taken), False, None
        meshes = taken.meshes if isinstance(taken, _Mixed) else taken
        if not isinstance(meshes, convert.MeshCopy):
            return None, False, taken
        return _surface_of(meshes.arrays), True, taken.shape if isinstance(taken, _Mixed) else None

    @contextmanager
    def _naming(self, i):
        """Has errors name the operand; those of scripts what operands are, too, which the window offers only."""
        try:
            yield
        except InvalidInput as error:
            name = self._names[i]
            if name == self._letters[i]:
                raise InvalidInput(f"{name}: {error}; operands are meshes (Mesh.Mesh, SurfaceMesh, arrays (V, F)), shapes, and "
                                   "document objects with a mesh or a shape") from error
            raise error if name in str(error) else type(error)(
                phrases.Text("{name}: {phrase}", name=name, phrase=phrases.text_of(error))) from error

    def size(self):
        """Longest side of the box of all operands, mm."""
        return self._core.size()

    def divided_length(self):
        """mm; the length that a resolution divides, where the method is exact."""
        return self._core.divided_length()

    def _explained(self, error):
        """The error with the labels of the operands, where it names one by its letter."""
        said = phrases.text_of(error)
        for letter, name in zip(self._letters, self._names):
            said = said if name in said else phrases.renamed(said, letter, name)
        return error if said == str(error) else type(error)(said)


def _names(sources, operands):
    """How errors name operands: document objects by their labels, two of one label by their letters, too."""
    labels = [convert.label_of(source) if getattr(frames.object_of(source), "Label", None) else operand
              for source, operand in zip(sources, operands)]
    return [label if labels.count(label) == 1 else f"{label} ({operand})" for label, operand in zip(labels, operands)]


def _surface_of(arrays):
    return convert.surface_of_arrays(extension(), *arrays, measured=False)


def letters(count):
    """How operands are called: A, B, ... Z; by number where there are more of them."""
    if count <= len(string.ascii_uppercase):
        return list(string.ascii_uppercase[:count])
    return [str(i + 1) for i in range(count)]


def is_arrays(source):
    """True for a pair of array-likes of three columns."""
    if not isinstance(source, (tuple, list)) or len(source) != 2:
        return False
    return all(hasattr(part, "__len__") and not isinstance(part, str) for part in source)


def part_of(progress, low, high):
    """A callback that reports [0, 1] as [low, high] of the whole; None stays None."""
    if progress is None:
        return None
    return lambda fraction, stage: progress(low + (high - low) * fraction, stage)
