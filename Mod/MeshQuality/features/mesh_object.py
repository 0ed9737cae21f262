# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common base of document objects that hold a mesh."""

import hashlib
import json
from contextlib import contextmanager, suppress
from functools import partial

import FreeCAD
import numpy as np

from .. import options, phrases
from ..compat import PlainState, attribute_of, property_of, without_traceback
from ..core.certify import verdict
from ..core.patches.source_faces import FacesOfOne
from ..core.sources import convert, frames
from ..core.sources import hidden_parts
from ..errors import Error, InvalidInput
from . import aliases, distance_bound, patches, placement, size_fields
from .gui_hooks import window
from .properties import (add_hidden, add_measured, add_options, add_property, clear_mesh, options_of, show_deviation, show_mesh,
                         show_report)
from .recompute_work import Work

# Name, type, what it says: properties of the group Certificate, for every kind of object.
PROMISES = (
    ("Certificate", "App::PropertyString",
     "Whether the mesh meets all requested limits; if not, which one is not met and where"),
    ("AskedClosed", "App::PropertyBool", "A watertight mesh was requested, as the source is closed"),
    ("Closed", "App::PropertyBool", "The mesh is watertight: it has no open edge"),
    ("Manifold", "App::PropertyBool",
     "The mesh has no edge of three or more triangles and no pinched vertex"),
)
STATUS_DATA = ("StatusData", "App::PropertyString",
               "What a failure in Status is made of, by which the window translates it")
CERTIFICATE_DATA = ("CertificateData", "App::PropertyString",
                    "What the certificate is made of, by which the window translates it")
CERTIFICATE_FACES = ("CertificateFaces", "App::PropertyStringList",
                     "CAD faces on which a requested limit is not met")
CERTIFICATE_PLACE = ("CertificatePlace", "App::PropertyVectorList",
                     "Corners of the triangle that is farthest from a requested limit")
AUTOMATIC, MANUAL = "Automatic", "Manual"
UP_TO_DATE = "up to date"
COMPUTING = "being computed in the background"
OUT_OF_DATE = "out of date: a source or an option has changed; choose Update Mesh"
SOURCE_DELETED = "out of date: the source was deleted"
FAILED = "failed: "  # and why
# Properties of objects that promise a smallest angle; the last column is the name in the report.
ANGLE_PROMISES = (
    ("AskedMinAngle", "App::PropertyAngle", "Smallest angle that was requested", "min_angle_asked"),
    ("MeasuredMinAngle", "App::PropertyAngle", "Smallest angle of all triangles", "min_angle"),
)
# Kept for the object's own use.
FINGERPRINT = ("Fingerprint", "App::PropertyString", "Digest of the sources and the options of this mesh")
FACE_RUNS = ("FaceRuns", "App::PropertyIntegerList",
             "Pairs (index of a CAD face, number of successive triangles on it); -1: on none")


class MeshObject(PlainState):
    """Proxy of a document object that holds a mesh. Its state is in the object's properties.

    A subclass has
    TYPE, MESH          the type of the object, and the property that holds its mesh
    size(obj)           how many triangles or elements that mesh has
    COMMAND             the command that adds one, by which it also gets its icon
    CALL                the function of the API that adds one
    OPTIONS, PRESETS    the table of its options, and values of them that go together
    MEASURED, PROMISES  the tables of what is measured, and of what it promises, see properties
    HIDDEN              the table of properties for its own use
    sources(obj)        what it is made of: document objects, or pairs (document object, path) as in frames
    add_properties(obj) adds those properties that the object has not got yet
    LINKS               the properties by which `sources` finds them
    work_on(sources, values, obj=None)
                        class method: the Work of an object with these sources and options, `obj`
                        itself where it is there already
    holds_mesh(obj)     whether the mesh of its last result is there
    take(obj, result)   shows a result; returns its report and the findings of its certificate, or None
                        where these are not new
    size_of(sources)    largest dimension of the sources in mm, for people; 0: unknown
    kept_length(sources)
                        class methods: a function of options, the distance in mm that a result of these sources keeps by
                        them, where they do not say it themselves; else None
    BOUND_BEFORE        the bound on the distance in older versions, where neither value was given
    TAKES_MESHES        whether of a container the meshes in it count, too, and not its shape alone
    LEAVES_CONTAINERS   whether the mesh is where the source's own placement has it, whatever containers around
                        the source say, and not where the document has the source
    PLACED_IN_DOCUMENT  whether its Placement is that in the document, whatever containers around the mesh say
    An error leaves the last good mesh as it is.
    """

    TYPE, MESH = "Mesh::FeaturePython", "Mesh"
    MEASURED = PRESETS = PROMISES = HIDDEN = ()
    TAKES_MESHES = LEAVES_CONTAINERS = PLACED_IN_DOCUMENT = False
    BOUND_BEFORE = options.UNBOUNDED
    _clearing = False
    _precomputed = None  # the (Work, result) of with_precomputed

    @classmethod
    def size_of(cls, sources):
        """See the docstring of MeshObject."""
        return convert.size_of(sources[0])

    @classmethod
    def kept_length(cls, sources):
        """See the docstring of MeshObject."""
        return None

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def add_common_properties(self, obj):
        """Adds the properties of every kind of object."""
        for name, kind, text, *_ in (*PROMISES, *self.PROMISES):
            if not add_property(obj, kind, name, "Certificate", text):
                obj.setGroupOfProperty(name, "Certificate")  # older versions had some elsewhere
            elif name == "Certificate" and self.size(obj):
                obj.Certificate = verdict.UNKNOWN
            obj.setEditorMode(name, 1)
        add_hidden(obj, "Certificate", (CERTIFICATE_DATA, CERTIFICATE_FACES, CERTIFICATE_PLACE, FINGERPRINT, STATUS_DATA))
        older = placement.ORIGIN[0] not in obj.PropertiesList
        add_hidden(obj, "Mesh", (*self.HIDDEN, placement.FRAME, placement.ORIGIN, placement.ARRANGEMENT))
        if older:  # computed in the frame of its source, whatever container that is in
            obj.MeshOrigin = attribute_of(property_of(obj, "Placement"), "Base")
        obj.setEditorMode("Placement", 1)
        if add_property(obj, "App::PropertyEnumeration", "Recompute", "Update",
                        "Automatic: the mesh follows its sources and options; Manual: only Update mesh "
                        "computes it again"):
            obj.Recompute = [AUTOMATIC, MANUAL]
        if add_property(obj, "App::PropertyString", "Status", "Update",
                        "Whether the mesh is up to date with its sources and options"):
            obj.Status = UP_TO_DATE
        obj.setEditorMode("Status", 1)

    def onDocumentRestored(self, obj):
        """An object of an older version gets the properties that were added since; one that was
        saved without the GUI, or by a version without views of its own, gets a view.
        """
        self.add_properties(obj)
        if obj.Status == COMPUTING:
            obj.Status = OUT_OF_DATE
            window().resume_in_background(obj)
        window().attach_view(obj)

    def onChanged(self, obj, name):
        """Called by FreeCAD; it takes an object that is deleted out of the properties that name it."""
        distance_bound.follow_change(self, obj, name)
        aliases.follow_change(self.OPTIONS, obj, name)
        with suppress(AttributeError):  # scripts may have removed a property, or made it read-only
            if name in self.LINKS and obj.Fingerprint and not obj.Document.Restoring and self.lacks_source(obj):
                obj.Status = SOURCE_DELETED

    def onBeforeChange(self, obj, name):
        """Called by FreeCAD; undo and redo replace a mesh as fast as show_mesh does."""
        if name == "Mesh" and obj.Document.Transacting and not self._clearing:
            self._clearing = True
            try:
                clear_mesh(obj)
            finally:
                self._clearing = False

    def show(self, obj, mesh, shown, closed, findings):
        """Shows a mesh with its report, as a Mesh.Mesh, and the certificate; returns what `take` does."""
        show_mesh(obj, shown)
        show_report(obj, (*self.MEASURED, *self.PROMISES), mesh.report, mesh)
        show_certificate(obj, mesh.report, closed, findings)
        return mesh.report, findings

    def follow(self, obj):
        """Updates names of sub-elements after a change of the sources."""

    def size(self, obj):
        """Number of triangles of the mesh that it holds."""
        return obj.Mesh.CountFacets

    def lacks_source(self, obj):
        """Whether a source was deleted, or never chosen."""
        return None in self.sources(obj)

    @property
    def execute(self):
        """What FreeCAD calls to bring the mesh up to date. FreeCAD prints what it raises with the
        traceback, which of an option out of range says nothing to users.
        """
        return without_traceback(self._bring_up_to_date)

    def _bring_up_to_date(self, obj):
        """Computes the mesh, unless nothing that it depends on has changed."""
        self.error = None
        try:
            self.add_properties(obj)  # scripts may have removed some
            done = self._result(obj)
            if done is not None:
                work, result = done
                if isinstance(result, Exception):
                    raise result
                finished = self.take(obj, result)
                placement.record(obj, self.frame_of_result(obj, work, result), work.arrangement)
                self.follow(obj)
                window().stop_in_background(obj)
                obj.Fingerprint, obj.Status = work.fingerprint, UP_TO_DATE
                if finished is not None:
                    left_out = self.left_out(obj)
                    if left_out:
                        obj.Notes = [*obj.Notes, *left_out]
                    _tell(obj, *finished, left_out)
            placement.move_to_source(obj)
        except Exception as error:
            if isinstance(error, AttributeError) and "read-only" in str(error):
                error = Error(f"{error}: allow it to be changed")
            self.error = error
            with suppress(AttributeError):  # where Status is read-only, too
                deleted = obj.Fingerprint and self.lacks_source(obj)
                obj.Status = SOURCE_DELETED if deleted else f"{FAILED}{error}"
                obj.StatusData = json.dumps(phrases.to_data(phrases.text_of(error)))
            if isinstance(error, (Error, ImportError, MemoryError)):
                raise type(error)(f"{obj.Label}: {window().translated(error)}") from error
            raise

    @classmethod
    def called_with(cls, names):
        """The arguments by which CALL takes sources of these names in Python."""
        return names[0] if len(names) == 1 else f"[{', '.join(names)}]"

    def told(self, obj):
        """A Text on the result for users, beside its certificate; None: nothing."""
        return None

    def left_out(self, obj):
        """A sentence for each source that is a container in which something is hidden."""
        return [text for source in self.sources(obj)
                for text in hidden_parts.sentences_of(source, self.TAKES_MESHES)]

    def precomputed_for(self, sources, values):
        """The (Work, result) of with_precomputed, if it is for these sources and options; else None."""
        done = self._precomputed
        return done if done is not None and done[0].is_for(sources, values) else None

    def frame_of_result(self, obj, work, result):
        """Where the container of the first source stood when the result was computed."""
        return work.frame

    def _result(self, obj):
        """The (Work, result) that the object takes; None when it is up to date, is computed in the
        background, or is to stay as it is until an update is requested.
        """
        placement.require_outside(obj)
        sources, values = self.sources(obj), options_of(obj, self.OPTIONS)
        done = self.precomputed_for(sources, values)
        if done is not None:
            return done
        if window().begin_in_background(obj):
            return None
        work = self.work_on(sources, values, obj)
        if self.is_result(obj, work):
            obj.Status = UP_TO_DATE
            return None
        if obj.Recompute == MANUAL and obj.Fingerprint:
            obj.Status = OUT_OF_DATE
            return None
        return work, work.result(None)

    def is_result(self, obj, work):
        """Whether the object holds the result of the work."""
        held = self.held(obj)
        return bool(held) and work.fingerprint == held

    def held(self, obj):
        """The fingerprint of the result that the object holds; empty when it holds none."""
        known = obj.Certificate not in (verdict.UNKNOWN, verdict.NOT_COMPUTED)
        return obj.Fingerprint if known and self.holds_mesh(obj) else ""


@contextmanager
def with_precomputed(taker, work, result):
    """Meanwhile an object of the sources and the options of `work` takes this result when it is recomputed.

    taker   the proxy of the object; or the class of its proxy, for an object that a line of Python adds meanwhile:
            FreeCAD's macros record only lines that they run, and such a line cannot name the result
    result  the return value of work.result, or the exception that it raised
    """
    taker._precomputed = work, result
    try:
        yield
    finally:
        taker._precomputed = None


class OfOneSource(MeshObject):
    """Proxy of an object that is made of its Source alone.

    A subclass has SOURCE, what the property says, and NEEDS, what a source has.
    """

    OPTIONS = ()
    LINKS = ("Source", "SourcePath")

    def sources(self, obj):
        """The Source, with its path."""
        return [frames.source_of(obj.Source, obj.SourcePath)]

    def holds_mesh(self, obj):
        """There is no mesh without a triangle."""
        return self.size(obj) > 0

    def add_properties(self, obj):
        """Adds those properties that the object has not got yet."""
        # Global: a mesh may follow an object inside a container to which the mesh does not belong.
        add_property(obj, "App::PropertyLinkGlobal", "Source", "Mesh", self.SOURCE)
        add_property(obj, "App::PropertyString", "SourcePath", "Mesh",
                     "The path from the source to what is meshed, where only a link leads there: Part.Box.")
        add_options(obj, self.OPTIONS)
        add_measured(obj, self.MEASURED)
        self.add_common_properties(obj)


class ShapeMesh(OfOneSource):
    """Proxy of an object that meshes the shape of its Source.

    A subclass has the class method compute(shape, values, progress), and take(obj, result).
    """

    SOURCE, NEEDS = "The object whose shape is meshed", "a shape"

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """The Work of meshing the source with these options."""
        require_source(sources, obj)
        values = options.check(cls.OPTIONS, values)
        own = convert.taken(convert.own_shape_of(sources[0]))
        shape = own if cls.LEAVES_CONTAINERS else convert.taken(convert.shape_of(sources[0]))
        # Names of sub-elements of a container, and size fields, are found here, where documents may be asked.
        found = convert.with_resolved_sizes(sources[0], values)
        fields, digests = size_fields.fields_for(sources[0], found.get("size_field"), cls.LEAVES_CONTAINERS)
        if digests:
            found = {**found, "size_field": fields}
        work = Work(sources, values, partial(fingerprint_of, own, {**found, "size_field": digests or None}),
                    partial(cls.compute, shape, found))
        work.size_digests = digests or None
        return work


class PatchedMesh(MeshObject):
    """Proxy of an object whose mesh has patches, by the faces of its sources."""

    def add_properties(self, obj):
        """As in the base class, with the properties of patches."""
        super().add_properties(obj)
        patches.add_patch_properties(obj)

    def follow(self, obj):
        """Patches keep their faces."""
        for sentence in patches.follow_sources(obj, self.faces(obj)):
            FreeCAD.Console.PrintWarning(f"{obj.Label}: {window().translated(sentence)}\n")

    def faces(self, obj):
        """The names of its sources' faces, as in source_faces."""
        return FacesOfOne(self.sources(obj)[0])

    def has_faces(self, obj):
        """Whether its mesh has faces of which patches can be made."""
        return True

    def require_patch_names(self, names):
        """Raises InvalidInput where the mesh cannot have patches of these names."""

    def show_patches(self, obj):
        """Has the mesh show patches that were given."""


class SegmentedMesh(PatchedMesh):
    """Proxy of such an object whose mesh has one segment for each CAD face."""

    HIDDEN = (FACE_RUNS,)

    def show(self, obj, mesh, shown, closed, findings):
        """As in the base class."""
        obj.FaceRuns = runs_of_faces(mesh.triangle_face)
        return super().show(obj, mesh, shown, closed, findings)

    def onDocumentRestored(self, obj):
        """The mesh gets its segments back, which FreeCAD does not save."""
        super().onDocumentRestored(obj)
        segments = convert.face_segments(faces_of_runs(obj.FaceRuns, obj.Mesh.CountFacets))
        if segments and obj.Mesh.countSegments() == 0 and "Immutable" not in obj.getPropertyStatus("Mesh"):
            mesh = obj.Mesh.copy()
            convert.add_segments(mesh, segments)
            obj.Mesh = mesh
            obj.purgeTouched()


class SourceMesh(SegmentedMesh, ShapeMesh):
    """Proxy of an object that meshes the shape of its Source, with one segment a CAD face."""


def require_source(sources, obj):
    """Raises InvalidInput where there is no source, or none any more."""
    if None not in sources:
        return
    if obj is not None and obj.Fingerprint:
        raise InvalidInput(phrases.Text(phrases.SOURCE_DELETED))
    raise InvalidInput(phrases.Text(phrases.NO_SOURCE))


def _tell(obj, report, findings, left_out):
    """Writes one line on the result of an object to the report view, and others on what is left out."""
    text = verdict.line(obj.Label, report, findings, window().translated)
    (FreeCAD.Console.PrintWarning if findings else FreeCAD.Console.PrintMessage)(text + "\n")
    told = obj.Proxy.told(obj)
    said = window().translated(told) if told is not None else ""
    if said not in text:
        FreeCAD.Console.PrintMessage(f"{obj.Label}: {said}\n")
    for sentence in left_out:
        FreeCAD.Console.PrintWarning(f"{obj.Label}: {window().translated(sentence)}\n")


def fingerprint_of(shape, values):
    """Changes whenever the shape or an option does; the same after saving and loading."""
    digest = hashlib.sha256(convert.shape_text(shape))
    digest.update(options.hashed(values).encode())
    return digest.hexdigest()


def runs_of_faces(triangle_face):
    """triangle_face as a flat list face, count, ...: short, as triangles come sorted."""
    starts = np.flatnonzero(np.diff(triangle_face, prepend=-2))
    counts = np.diff(starts, append=len(triangle_face))
    return np.column_stack((triangle_face[starts], counts)).ravel().tolist()


def faces_of_runs(runs, triangles):
    """The inverse of runs_of_faces; empty where the runs do not belong to a mesh with this number of triangles, as in
    a document that was edited.
    """
    pairs = np.array(runs[:len(runs) // 2 * 2], dtype=np.int64).reshape(-1, 2)
    sound = len(runs) % 2 == 0 and (pairs >= (-1, 0)).all() and (pairs[:, 0] <= np.iinfo(np.int32).max).all() \
        and (pairs[:, 1] <= triangles).all() and pairs[:, 1].sum() == triangles
    return np.repeat(pairs[:, 0], pairs[:, 1]) if sound else np.zeros(0, dtype=np.int64)


def show_certificate(obj, report, closed, findings):
    """Fills the properties of the group Certificate that every kind of object has.

    report  a MeshReport
    closed  whether the mesh was to be closed
    """
    obj.AskedClosed, obj.Closed, obj.Manifold = closed, report.closed, report.manifold
    show_deviation(obj)
    certificate = verdict.sentence(findings)
    obj.Certificate, obj.CertificateData = certificate, json.dumps(phrases.to_data(certificate))
    obj.CertificateFaces = verdict.faces(findings)
    obj.CertificatePlace = [FreeCAD.Vector(*corner) for corner in verdict.place(findings)]


class _Observer:
    """Sees changes for which execute is never called: FreeCAD does not compute an object with an expression that has no
    value.
    """

    def slotRecomputedDocument(self, document):
        """Called by FreeCAD: a certificate becomes void if its mesh does not fit the present options."""
        for obj in document.Objects:
            if isinstance(getattr(obj, "Proxy", None), MeshObject):
                with suppress(AttributeError):  # properties that are read-only, or that a script has removed
                    self._tell(obj)

    @staticmethod
    def _tell(obj):
        if obj.Fingerprint and obj.Status == UP_TO_DATE and obj.Proxy.lacks_source(obj):
            obj.Status = SOURCE_DELETED  # a copy from another document
        if "Invalid" in obj.State and obj.Fingerprint and obj.Status != SOURCE_DELETED and obj.Certificate != verdict.NOT_COMPUTED:
            obj.Certificate, obj.CertificateData = verdict.NOT_COMPUTED, ""
            if not obj.Status.startswith(FAILED):
                obj.Status, obj.StatusData = f"{FAILED}{obj.getStatusString()}", ""


FreeCAD.addDocumentObserver(_Observer())
