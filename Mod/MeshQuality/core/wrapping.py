# SPDX-License-Identifier: LGPL-2.1-or-later
"""wrap: the outer surface of objects that need not be clean."""

from dataclasses import dataclass

import numpy as np

from .. import options
from ..compat import extension
from ..errors import InvalidInput
from ..listing import Public
from .booleans import BooleanMesh
from .operands.operands import Operands, is_arrays
from .patches.patches import Division, patches_of
from .patches.source_faces import GAPS, own_names
from .sources import frames
from .sources import hidden_parts


@dataclass(frozen=True)
class Leak:
    """A way from outside to a place that was to stay dry.

    dry        float64 (3,), mm: the place
    path       float64 (N, 3), mm: from there to beside the objects
    narrowest  float64 (3,), mm: the narrowest place of the path
    width      mm: the largest ball that passes there, up to the tolerance; a wrap with a larger gap closes it
    """

    dry: np.ndarray
    path: np.ndarray
    narrowest: np.ndarray
    width: float

    def to_dict(self):
        """It as plain values for JSON."""
        return {"dry": self.dry.tolist(), "path": self.path.tolist(), "narrowest": self.narrowest.tolist(), "width": self.width}

    def __str__(self):
        dry, narrowest = (", ".join(f"{x:.4g}" for x in place) for place in (self.dry, self.narrowest))
        return (f"({dry}) is not dry: a ball {self.width:.4g} mm wide comes in at ({narrowest}); close that opening, or give "
                "a larger gap")


class WrapMesh(BooleanMesh, metaclass=Public):
    """A BooleanMesh around what was wrapped: closed, manifold, without self-intersections.

    triangle_source      int32 (T, 2): the object (0, 1, ...), and its triangle, on which each triangle lies; (-1, -1) where
                         it closes a gap
    triangle_face        int32 (T,): the face on which each triangle lies, all faces of all objects numbered on; -1 where it
                         closes a gap
    patches              names of patches: the faces of the objects ("Face3" of one object, "Box_Face3" of several), and "gaps"
    leaks                [Leak, ...]: of the places that were to stay dry, those that do not
    distance_to_input    mm, a proven bound: of the wrap from what it lies on; gaps are left out
    distance_from_input  mm: of what sticks out of the wrap from it, likewise
    gap_triangles        number of the triangles that close gaps
    gap_area             mm2, of these
    report               BooleanReport; error_bound is the larger one of the distances, with that of the meshes from shapes
    """

    __slots__ = ("_leaks",)

    def __init__(self, surface, patches=None, leaks=()):
        super().__init__(surface, patches)
        self._leaks = list(leaks)

    leaks = property(lambda self: self._leaks, doc="[Leak, ...]")
    distance_to_input = property(lambda self: self._surface.distance_to_input, doc="mm")
    distance_from_input = property(lambda self: self._surface.distance_from_input, doc="mm")
    gap_triangles = property(lambda self: self._surface.gap_triangles, doc="number")
    gap_area = property(lambda self: self._surface.gap_area, doc="mm2")


def wrap(objects, gap, tolerance=None, dry=None, progress=None, threads=0):
    """The outer surface of objects: everything that a ball as wide as the gap can touch from outside.

    objects    one or a list of them: Mesh.Mesh, SurfaceMesh, arrays (V, F), Part.Shape, or document objects. They may
               overlap, miss each other, be open, and be oriented in any way
    gap        mm; openings narrower than this are closed, those wider than the gap and three tolerances are entered
    tolerance  mm, the largest distance between the wrap and what it lies on, at most half of the gap; None: a quarter of
               the gap, at most a fiftieth of the size. It is also the size of the smallest thing that is found for certain
    dry        [(x, y, z), ...], mm: places that are to stay inside. Where the ball reaches one of them, leaks has its way
    progress   callable(fraction 0..1, stage); returning False cancels
    threads    that work at a time; 0: one for each core. The result is the same for any number

    Sheets without thickness become as thick as the tolerance. Pockets no deeper than half of the gap stay open, so that
    concave edges stay sharp.

    Returns a WrapMesh. Raises InvalidInput naming the object and the remedy; TopologyError; Cancelled.
    """
    values = options.check(options.wrap.WRAP, {"gap": gap, "tolerance": tolerance, "threads": threads})
    if values["gap"] is None:
        raise InvalidInput(f"gap = {gap!r}: give a length in mm")
    options.require_callable(progress)
    places = _places(dry)
    wrapped = Wrapped(objects)
    left_out = [text for source in wrapped.sources for text in hidden_parts.sentences_of(source, with_meshes=True)]
    return hidden_parts.noted(run(wrapped, values, progress, places), left_out)


class Wrapped:
    """What is wrapped, taken from the document: the rest may be done by any thread."""

    def __init__(self, objects):
        several = isinstance(objects, list) or (isinstance(objects, tuple) and not is_arrays(objects)
                                                and not frames.is_object(objects))
        sources = self.sources = list(objects) if several else [objects]
        if not sources:
            raise InvalidInput("the list of objects is empty")
        self.operands = Operands(sources)
        self.labels = [_label(source, i) for i, source in enumerate(sources)]

    def digest(self):
        """As Operands.digest."""
        return self.operands.digest()


def run(wrapped, values, progress=None, dry=()):
    """The WrapMesh with checked options."""
    surface = wrapped.operands.given_to(lambda core: extension().wrap_objects(
        core, values["gap"], values["tolerance"] or 0.0, [*dry], values["threads"], progress))
    leaks = [Leak(np.array(place), np.array(path), np.array(narrowest), width)
             for place, path, narrowest, width in surface.leaks]
    division = Division(face_names=own_names(wrapped.labels, [count or None for count in surface.faces]), no_face=GAPS)
    return WrapMesh(surface, patches_of(division, surface.triangle_face, len(surface.triangles)), leaks)


def _label(source, i):
    return getattr(frames.object_of(source), "Label", None) or f"Object{i + 1}"


def _places(dry):
    """[(x, y, z), ...] of what was given as places."""
    if dry is None:
        return []
    try:
        places = np.asarray(dry, dtype=float)
    except (TypeError, ValueError):
        places = np.zeros(0)
    if places.ndim == 1 and len(places) == 3:
        places = places.reshape(1, 3)
    if places.ndim != 2 or places.shape[1] != 3 or not np.isfinite(places).all():
        raise InvalidInput(f"dry = {dry!r}: give places in mm as [(x, y, z), ...]")
    return [tuple(place) for place in places.tolist()]
