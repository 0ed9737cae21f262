# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operands of a Boolean: what scripts may pass, as surfaces of the core."""

import hashlib
import string
import time
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property

import FreeCAD
import numpy as np

from ... import phrases
from ...compat import attribute_of, extension
from ...errors import InvalidInput, TopologyError
from ..sources import convert, frames
from .distance_meshes import mesh_within, require_complete
from ..surface_mesh import SurfaceMesh
from ..triangulation import triangulate

# Triangulating asks for at least 4 times the rounding error of single precision, which is sqrt(3)
# times 2^-24 of the largest coordinate in the local frame of the shape. That frame keeps
# coordinates within 4 times the shape's size.
_FINEST_CHORD = 4.0 * 3.0**0.5 * 2.0**-24
_FRAME = 4.0
# Meshes that keep the volume: how much coarser the first one is, by which the error is found; how often a finer one is made;
# the error that is accepted, as a fraction of that allowed, and the one that is aimed at; how much finer at most in one step; triangles that
# are expected of a finer one at most.
_COARSE, _FINER, _ACCEPTED, _AIM, _STEP, _MOST = 4.0, 3, 0.85, 0.75, 1.0 / 32.0, 500_000
_MOST_NOTES = 3  # of operands that are shapes; more are told in one
# Fraction of the size of all operands that a Boolean asks for at least.
_FINEST_TOLERANCE = 4.0 * 2.0**-23
# The length that a resolution divides: at most this multiple of the mean thickness of each operand, and at least this fraction of the size
# of all, which bounds what slender operands cost: their curved faces take at most 1 / _SHORTEST times as many triangles.
_THICKNESSES, _SHORTEST = 8.0, 1.0 / 16.0


@dataclass(frozen=True)
class _Mixed:
    """What a container holds: the meshes, and the Part.Shape of its shapes. They are joined to one operand."""

    meshes: convert.MeshCopy
    shape: object


class Operands:
    """Meshes and shapes on their way into a Boolean. FreeCAD's are taken as they are at first; any
    thread may do the rest.

    surfaces    [(core.Surface, whether it may be rounded to single precision,
                the Part.Shape it was made of or None), ...]
    notes       a sentence for each shape that was meshed
    seconds     [(stage, wall-clock seconds), ...]
    cpu_seconds of the process, in all stages
    deviation   mm; of the meshes from their shapes, the largest
    """

    def __init__(self, sources):
        self.seconds, self.cpu_seconds, self.notes, self.deviation = [], 0.0, [], 0.0
        self._sources = sources
        self._volume_error = None
        self._deviations = []  # (name, mm) of operands whose meshes have nothing else to tell
        self._letters = [f"operand {letter}" for letter in letters(len(sources))]
        self._names = _names(sources, self._letters)
        self._taken = [self._take(i) for i in range(len(sources))]
        # Only document objects ask for a digest.
        of_document = all(isinstance(frames.object_of(source), FreeCAD.DocumentObject) for source in sources)
        self._arrangement = frames.arrangement_of(sources) if of_document else ""
        self._own_shapes = [None if isinstance(taken, convert.MeshCopy) or not of_document
                            else convert.own_shape_of(source) for taken, source in zip(self._taken, sources)]

    @property
    def surfaces(self):
        return [found for found in self._found if isinstance(found, tuple)]

    def is_shape(self, i):
        """Whether an operand is a shape, with no meshes in it."""
        return not isinstance(self._taken[i], (SurfaceMesh, convert.MeshCopy, _Mixed)) and not is_arrays(self._taken[i])

    def face_counts(self):
        """For each operand, which was meshed, how many CAD faces it has; None: not all of its triangles know theirs."""
        def count(surface, shape):
            if shape is not None:
                return shape.countElement("Face")
            faces = surface.triangle_face
            return int(faces.max()) + 1 if len(faces) and faces.min() >= 0 else None

        return [count(surface, shape) for surface, _, shape in self.surfaces]

    def plain(self, i):
        """The Part.Shape of an operand, or the arrays of its mesh; raises InvalidInput where it has shapes and meshes."""
        taken = self._taken[i]
        if isinstance(taken, _Mixed):
            raise InvalidInput(phrases.Text(phrases.SHAPES_AND_MESHES, name=convert.label_of(self._sources[i])))
        return taken.arrays if isinstance(taken, convert.MeshCopy) else taken

    @cached_property
    def _found(self):
        """What _read gives for each."""
        with self._stage("reading the operands"):
            return [self._read(i) for i in range(len(self._taken))]

    def mesh_shapes(self, core_options, progress, fraction=0.5, min_angle=None, any_faces=False, volume_error=None):
        """Meshes the operands that are shapes, as far from them as this fraction of the tolerance of these
        core.BooleanOptions, on as many threads as these say.

        min_angle  degrees, the bound on the angles of the meshes; None: that of triangulate
        any_faces  also shapes with faces that we cannot mesh, as mesh_within does, with notes of that only
        volume_error
                   relative: meshes are finer where they would change the volume of a shape by more

        Returns whether there were any.
        """
        shapes = [i for i, found in enumerate(self._found) if not isinstance(found, tuple)]
        if not shapes:
            return False
        meshing = {"threads": core_options.threads, **({} if min_angle is None else {"min_angle": min_angle})}
        self._volume_error = volume_error
        with self._stage("meshing shapes"):
            wanted = self._possible(core_options.tolerance_for(self.size()))
            for done, i in enumerate(shapes):
                part = part_of(progress, done / len(shapes), (done + 1) / len(shapes))
                self._found[i] = self._mesh_shape(i, fraction * wanted, part, meshing, any_faces)
        self._note_deviations()
        return True

    def _possible(self, tolerance):
        """The tolerance; raises InvalidInput where it is finer than the core can keep, before shapes are
        meshed as finely.
        """
        least = _FINEST_TOLERANCE * self.size()
        if tolerance < least:
            raise InvalidInput(phrases.Text(phrases.CORE_ERRORS["fine_tolerance"], length=f"{tolerance:.4g} mm",
                                            length2=f"{least:.4g} mm"))
        return tolerance

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

    @contextmanager
    def _stage(self, name):
        wall, cpu = time.perf_counter(), time.process_time()
        yield
        self.seconds.append((name, time.perf_counter() - wall))
        self.cpu_seconds += time.process_time() - cpu

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
                return convert.shape_of(source)
            meshes = convert.MeshCopy(source)
            return _Mixed(meshes, convert.shape_of(source)) if convert.has_faces(source) else meshes

    def _read(self, i):
        """(surface, round, None) of a mesh, the Part.Shape or the _Mixed as it is."""
        taken, module = self._taken[i], extension()
        with self._naming(i):
            if isinstance(taken, SurfaceMesh):
                return taken._surface, False, None
            if isinstance(taken, convert.MeshCopy):
                return convert.surface_of_arrays(module, *taken.arrays, measured=False), True, None
            if is_arrays(taken):
                return convert.surface_of_arrays(module, *taken, measured=False), False, None
            return taken

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
            raise _of(name, error) from error

    def size(self):
        """Longest side of the box of all operands, mm."""
        boxes = []
        for found in self._found:
            if not isinstance(found, tuple):
                box = attribute_of(_shape_in(found), "BoundBox")
                boxes += [(box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)]
                if isinstance(found, _Mixed):
                    boxes += [found.meshes.arrays[0].min(axis=0), found.meshes.arrays[0].max(axis=0)]
            elif len(found[0].vertices):
                points = found[0].vertices
                boxes += [points.min(axis=0) + found[0].origin,
                          points.max(axis=0) + found[0].origin]
        return float(np.ptp(np.array(boxes), axis=0).max()) if boxes else 0.0

    def divided_length(self):
        """mm; the length that a resolution divides, where the method is exact: the size, or 8 times the mean thickness of the
        thinnest operand, where that is less, and not below a sixteenth of the size. What is thinner than the tolerance may be
        lost where operands nearly touch, so that the tolerance goes by what is thin.
        """
        size = self.size()
        thin = min((thickness for found in self._found for thickness in _thicknesses(found)), default=size)
        return min(size, max(_THICKNESSES * thin, _SHORTEST * size))

    def _mesh_shape(self, i, chord_height, progress, meshing, any_faces):
        shape = _shape_in(self._found[i])
        box = attribute_of(shape, "BoundBox")
        side = max(box.XLength, box.YLength, box.ZLength)
        largest = max(map(abs, (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax)))
        chord_height = max(chord_height, _FINEST_CHORD * min(largest, _FRAME * side))
        try:
            mesh, deviation, rounded, note = self._any_mesh(i, shape, chord_height, progress, meshing) if any_faces else \
                self._mesh_of_all_faces(i, shape, chord_height, progress, meshing)
        except (InvalidInput, TopologyError) as error:
            raise _of(self._names[i], error) from error
        self.deviation = max(self.deviation, deviation)
        self.notes += [note] if note else []
        if not isinstance(self._found[i], _Mixed):
            return mesh, rounded, shape
        # Overlapping surfaces of one operand enclose together what each of them does.
        vertices, triangles = self._found[i].meshes.arrays
        own = np.asarray(mesh.vertices) + mesh.origin
        return convert.surface_of_arrays(extension(), np.concatenate((own, vertices)),
                                         np.concatenate((mesh.triangles, triangles + len(own))),
                                         measured=False), True, None

    def _mesh_of_all_faces(self, i, shape, chord_height, progress, meshing):
        """(Surface, its distance from the shape, whether it may be rounded, note)."""
        volume_error = 0.0
        if self._volume_error is None:
            mesh = _complete(shape, chord_height, progress, meshing)
        else:
            mesh, volume_error = _keeping_volume(shape, chord_height, self._volume_error, progress, meshing)
        mixed = isinstance(self._found[i], _Mixed)
        if not mixed and volume_error <= (self._volume_error or 1.0):
            self._deviations.append((self._names[i], mesh.report.max_chord_height))
            return mesh._surface, mesh.report.max_chord_height, False, ""
        volume = f", and its volume by about {100.0 * volume_error:.2g} %" if volume_error > (self._volume_error or 1.0) else ""
        what = "holds shapes and meshes: the mesh of the shapes" if mixed else "is a shape: its mesh"
        return mesh._surface, mesh.report.max_chord_height, False, (
            f"{self._names[i]} {what} deviates by at most {mesh.report.max_chord_height:.3g} mm from "
            f"{'them' if mixed else 'it'}{volume}; the max. deviation is that of the Boolean of the meshes")

    def _note_deviations(self):
        """A note for each operand of _deviations, for many of them one."""
        told = [(f"{name} is a shape: its mesh deviates", deviation, "it") for name, deviation in self._deviations]
        if len(told) > _MOST_NOTES:
            told = [(f"{len(told)} operands are shapes: their meshes deviate", max(note[1] for note in told), "them")]
        self.notes += [f"{what} by at most {deviation:.3g} mm from {those}; the max. deviation is that of the Boolean of the meshes"
                       for what, deviation, those in told]

    def _any_mesh(self, i, shape, chord_height, progress, meshing):
        """As _mesh_of_all_faces, of mesh_within."""
        mesh = mesh_within(shape, chord_height, progress, meshing["threads"])
        return mesh.surface, mesh.deviation, mesh.rounded, mesh.note and f"{self._names[i]}, {mesh.note}"

    def explain(self, error):
        """The error with the labels of the operands, where it names one by its letter."""
        said = phrases.text_of(error)
        for letter, name in zip(self._letters, self._names):
            said = phrases.renamed(said, letter, name)
        return error if said == str(error) else type(error)(said)


def _names(sources, operands):
    """How errors name operands: document objects by their labels, two of one label by their letters, too."""
    labels = [convert.label_of(source) if getattr(frames.object_of(source), "Label", None) else operand
              for source, operand in zip(sources, operands)]
    return [label if labels.count(label) == 1 else f"{label} ({operand})" for label, operand in zip(labels, operands)]


def _of(name, error):
    """An error that begins with the name of the operand, unless it says that already."""
    if name in str(error):
        return error
    return type(error)(phrases.Text("{name}: {phrase}", name=name, phrase=phrases.text_of(error)))


def _complete(shape, chord_height, progress, meshing):
    """The SurfaceMesh of all of the shape."""
    mesh = triangulate(shape, chord_height=chord_height, progress=progress, **meshing)
    require_complete(mesh.report, chord_height)
    return mesh


def _keeping_volume(shape, chord_height, error, progress, meshing):
    """(the same, as fine as a relative error of its volume needs, and that error). The volume of a mesh errs by a multiple of
    its chord height: two meshes tell by which (Richardson's extrapolation).
    """
    share = 1.0 / (_FINER + 2)
    coarse = _complete(shape, _COARSE * chord_height, part_of(progress, 0.0, share), meshing)
    if coarse.report.max_chord_height <= 0.0:
        return coarse, 0.0  # all faces are plane, and their edges straight
    if not coarse.report.closed:
        return _complete(shape, chord_height, part_of(progress, share, 1.0), meshing), 0.0
    longer = _COARSE * chord_height
    for step in range(1, _FINER + 2):
        mesh = _complete(shape, chord_height, part_of(progress, step * share, (step + 1) * share), meshing)
        volume = abs(mesh.report.volume)
        found = abs(volume - abs(coarse.report.volume)) * chord_height / (longer - chord_height)
        if found <= _ACCEPTED * error * volume:
            break
        finer = max(_AIM * error * volume / found, _STEP)
        if mesh.report.triangles > finer * _MOST:
            break
        coarse, longer = mesh, chord_height
        chord_height *= finer
    return mesh, found / volume


def _thicknesses(found):
    """The mean thickness, 2 V / A, mm, of each solid and of the mesh that an operand has; none of what has no volume."""
    if isinstance(found, tuple):
        thicknesses = [found[0].mean_thickness()]
    else:
        shape = _shape_in(found)
        bodies = attribute_of(shape, "Solids") or [shape]
        measures = [(attribute_of(body, "Volume"), attribute_of(body, "Area")) for body in bodies]
        thicknesses = [2.0 * abs(volume) / area for volume, area in measures if area]
        if isinstance(found, _Mixed):
            meshes = convert.surface_of_arrays(extension(), *found.meshes.arrays, measured=False)
            thicknesses.append(meshes.mean_thickness())
    return [thickness for thickness in thicknesses if thickness > 0.0]


def _shape_in(found):
    return found.shape if isinstance(found, _Mixed) else found


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
