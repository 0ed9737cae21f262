# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the document objects that hold a mesh have in common."""

import hashlib
from contextlib import contextmanager
from functools import partial

import FreeCAD
import numpy as np

from .. import convert, frames, options, verdict
from ..compat import PlainState, attribute_of, property_of, without_traceback
from ..errors import Error, InvalidInput
from . import aliases, certificate, distance_bound, placement
from .work import Work, handed_over, result_for

# Name, type, what it says: measured on the mesh that an object holds.
TOPOLOGY = (
    ("Triangles", "App::PropertyInteger", "Number of triangles"),
    ("Vertices", "App::PropertyInteger", "Number of vertices"),
    ("Oriented", "App::PropertyBool", "Neighbouring triangles agree on outside"),
)
# Of the group Certificate, for every kind of object.
PROMISES = (
    ("Certificate", "App::PropertyString",
     "Whether the mesh meets all requested limits; if not, which one is not met and where"),
    ("AskedClosed", "App::PropertyBool", "A watertight mesh was requested, as the source is closed"),
    ("Closed", "App::PropertyBool", "The mesh is watertight: it has no open edge"),
    ("Manifold", "App::PropertyBool",
     "The mesh has no edge of three or more triangles and no pinched vertex"),
)
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
# The same, of those that promise a smallest angle; see show_angles.
ANGLES = (
    ("MeasuredMaxAngle", "App::PropertyAngle", "Largest angle of all triangles"),
    ("Exempt", "App::PropertyStringList", "Triangles below the requested angle, and why"),
)
ANGLE_PROMISES = (
    ("AskedMinAngle", "App::PropertyAngle", "Smallest angle that was requested"),
    ("MeasuredMinAngle", "App::PropertyAngle", "Smallest angle of all triangles"),
)
# Kept for the object's own use.
FINGERPRINT = ("Fingerprint", "App::PropertyString", "Digest of the sources and the options of this mesh")
FACE_RUNS = ("FaceRuns", "App::PropertyIntegerList",
             "Pairs (index of a CAD face, number of successive triangles on it)")



class MeshObject(PlainState):
    """Proxy of a Mesh::FeaturePython. Its state is in the object's properties.

    A subclass has
    COMMAND             the command that adds one, by which it also gets its icon
    CALL                the function of the API that adds one
    OPTIONS, PRESETS    the table of its options, and values of them that go together
    sources(obj)        what it is made of: document objects, or pairs (document object, path) as in frames
    add_properties(obj) adds those properties that the object has not got yet
    work_on(sources, values, obj=None)
                        class method: the Work of an object with these sources and options, `obj`
                        itself where it is there already
    holds_mesh(obj)     whether the mesh of its last result is there
    take(obj, result)   shows a result; returns its report and the findings of its certificate, or None
                        where these are not new
    BOUND_BEFORE        the bound on the distance in older versions, where neither value was given
    An error leaves the last good mesh as it is.
    """

    PRESETS = PROMISES = ()
    BOUND_BEFORE = options.UNBOUNDED
    _clearing = False

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def add_common_properties(self, obj):
        """Adds what every kind of object has."""
        for name, kind, text in (*PROMISES, *self.PROMISES):
            if not add_property(obj, kind, name, "Certificate", text):
                obj.setGroupOfProperty(name, "Certificate")  # older versions had some elsewhere
            elif name == "Certificate" and obj.Mesh.CountFacets:
                obj.Certificate = certificate.UNKNOWN
            obj.setEditorMode(name, 1)
        add_hidden(obj, "Certificate", (CERTIFICATE_FACES, CERTIFICATE_PLACE, FINGERPRINT))
        older = placement.ORIGIN[0] not in obj.PropertiesList
        add_hidden(obj, "Mesh", (placement.FRAME, placement.ORIGIN, placement.ARRANGEMENT))
        if older:  # computed in the frame of its source, whatever container that is in
            obj.MeshOrigin = property_of(obj, "Placement").Base
        obj.setEditorMode("Placement", 1)
        if add_property(obj, "App::PropertyEnumeration", "Recompute", "Update",
                        "Automatic: the mesh follows its sources and options; Manual: only Update mesh "
                        "computes it again"):
            obj.Recompute = [AUTOMATIC, MANUAL]
        if add_property(obj, "App::PropertyString", "Status", "Update",
                        "Whether the mesh is up to date with its sources and options"):
            obj.Status = UP_TO_DATE
        obj.setEditorMode("Status", 1)

    def attach_view(self, view):
        """Gives the object's view in the GUI its proxy."""
        from ..gui.mesh_view import MeshView

        MeshView(view)

    def onDocumentRestored(self, obj):
        """Documents of older versions get the properties that were added since; those that were
        saved without the GUI, or by a version without views of its own, get a view.
        """
        self.add_properties(obj)
        if obj.Status == COMPUTING:
            obj.Status = OUT_OF_DATE
            if FreeCAD.GuiUp:
                _follow().resume(obj)
        if FreeCAD.GuiUp and not isinstance(obj.ViewObject.Proxy, PlainState):
            self.attach_view(obj.ViewObject)

    def onChanged(self, obj, name):
        """Called by FreeCAD; it takes an object that is deleted out of the properties that name it."""
        distance_bound.follow_change(self, obj, name)
        aliases.follow_change(self.OPTIONS, obj, name)
        if name in ("Source", "Sources") and getattr(obj, "Fingerprint", "") \
                and not obj.Document.Restoring and self.lacks_source(obj):
            obj.Status = SOURCE_DELETED

    def onBeforeChange(self, obj, name):
        """Called by FreeCAD; undo and redo replace a mesh as fast as show_mesh does."""
        if name == "Mesh" and obj.Document.Transacting and not self._clearing:
            self._clearing = True
            try:
                _clear_mesh(obj)
            finally:
                self._clearing = False

    def lacks_source(self, obj):
        """Whether something that it is made of was deleted, or never chosen."""
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
            done = self._result(obj)
            if done is not None:
                work, result = done
                if isinstance(result, Exception):
                    raise result
                finished = self.take(obj, result)
                placement.record(obj, self.frame_of_result(obj, work, result), work.arrangement)
                if FreeCAD.GuiUp:
                    _follow().stop(obj)
                obj.Fingerprint, obj.Status = work.fingerprint, UP_TO_DATE
                if finished is not None:
                    _tell(obj, *finished)
            placement.settle(obj)
        except Exception as error:
            self.error = error
            deleted = obj.Fingerprint and self.lacks_source(obj)
            obj.Status = SOURCE_DELETED if deleted else f"{FAILED}{error}"
            if isinstance(error, (Error, ImportError, MemoryError)):
                raise type(error)(f"{obj.Label}: {error}") from error
            raise

    def frame_of_result(self, obj, work, result):
        """Where the container of the first source stood when the result was computed."""
        return work.frame

    def _result(self, obj):
        """The (Work, result) that the object takes; None when it is up to date, is computed in the
        background, or is to stay as it is until it is asked for.
        """
        sources, values = self.sources(obj), options_of(obj, self.OPTIONS)
        done = result_for(type(self), sources, values)
        if done is not None:
            return done
        if FreeCAD.GuiUp and _follow().begin(obj):
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
        """Whether the object holds what the work would give."""
        held = self.held(obj)
        return bool(held) and work.fingerprint == held

    def held(self, obj):
        """The fingerprint of the result that the object holds; empty when it holds none."""
        known = obj.Certificate != certificate.UNKNOWN
        return obj.Fingerprint if known and self.holds_mesh(obj) else ""


class OfOneSource(MeshObject):
    """Proxy of an object that is made of its Source alone.

    A subclass has SOURCE, what the property says, NEEDS, what a source has, and the tables OPTIONS,
    MEASURED and HIDDEN of its other properties.
    """

    OPTIONS = MEASURED = HIDDEN = ()

    def sources(self, obj):
        """The Source, with its path."""
        return [frames.source_of(obj.Source, obj.SourcePath)]

    def holds_mesh(self, obj):
        """There is no mesh without a triangle."""
        return obj.Mesh.CountFacets > 0

    def add_properties(self, obj):
        """Adds those properties that the object has not got yet."""
        # Global: a mesh may follow something inside a container that it does not belong to itself.
        add_property(obj, "App::PropertyLinkGlobal", "Source", "Mesh", self.SOURCE)
        add_property(obj, "App::PropertyString", "SourcePath", "Mesh",
                     "The path from the source to what is meshed, where only a link leads there: Part.Box.")
        add_options(obj, self.OPTIONS)
        add_measured(obj, self.MEASURED)
        add_hidden(obj, "Mesh", self.HIDDEN)
        self.add_common_properties(obj)


class SourceMesh(OfOneSource):
    """Proxy of an object that meshes the shape of its Source, with one segment a CAD face.

    A subclass has the class method compute(shape, values, progress), and take(obj, result).
    """

    SOURCE, NEEDS = "The object whose shape is meshed", "a shape"
    HIDDEN = (FACE_RUNS,)

    def onDocumentRestored(self, obj):
        """The mesh gets its segments back, which FreeCAD does not save."""
        super().onDocumentRestored(obj)
        segments = convert.face_segments(faces_of_runs(obj.FaceRuns))
        if segments and obj.Mesh.countSegments() == 0:
            mesh = obj.Mesh.copy()
            convert.add_segments(mesh, segments)
            obj.Mesh = mesh
            obj.purgeTouched()

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """To mesh the source with these options."""
        require_source(sources, obj)
        values = options.check(cls.OPTIONS, values)
        own, shape = convert.own_shape_of(sources[0]), convert.shape_of(sources[0])
        # Of a container the names of sub-elements are found here, where documents may be asked.
        found = convert.with_resolved_sizes(sources[0], values)
        return Work(cls, sources, values, partial(fingerprint_of, own, found),
                    partial(cls.compute, shape, found))


def require_source(sources, obj):
    """Raises InvalidInput where there is no source, or none any more."""
    if None not in sources:
        return
    if obj is not None and obj.Fingerprint:
        raise InvalidInput("Source is empty: the source was deleted; choose another one, or delete "
                           "this mesh")
    raise InvalidInput("Source is empty: choose an object with a shape")


def _tell(obj, report, findings):
    """Has the report view say in one line what came of an object that was computed."""
    if FreeCAD.GuiUp:
        from ..gui.words import translate_phrase

        text = verdict.line(obj.Label, report, findings, translate_phrase)
    else:
        text = verdict.line(obj.Label, report, findings)
    (FreeCAD.Console.PrintWarning if findings else FreeCAD.Console.PrintMessage)(text + "\n")


def _follow():
    """What has meshes follow in the background; needs the window."""
    from ..gui import follow

    return follow


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


def faces_of_runs(runs):
    """The inverse of runs_of_faces."""
    pairs = np.array(runs, dtype=np.int64).reshape(-1, 2)
    return np.repeat(pairs[:, 0], pairs[:, 1])


def add_property(obj, kind, name, group, text):
    """Adds a property, unless the object has it; returns whether it was added."""
    if name in obj.PropertiesList:
        return False
    obj.addProperty(kind, name, group, text)
    return True


def add_measured(obj, table):
    """A read-only property for each (name, type, text) of the table, in the group Quality."""
    for name, kind, text in table:
        add_property(obj, kind, name, "Quality", text)
        obj.setEditorMode(name, 1)


def add_hidden(obj, group, table):
    """A property that the editor does not show for each (name, type, text) of the table."""
    for name, kind, text in table:
        add_property(obj, kind, name, group, text)
        obj.setEditorMode(name, 2)


def show_mesh(obj, mesh):
    """Gives the object its mesh."""
    _clear_mesh(obj)
    obj.Mesh = mesh


def _clear_mesh(obj):
    """Takes away a mesh with segments. FreeCAD would mark the facets of all segments anew for each
    segment of the mesh that replaces it: of 500,000 triangles on 50 faces that takes seven seconds.
    """
    import Mesh

    if obj.Mesh.countSegments():
        empty = Mesh.Mesh()
        empty.Placement = attribute_of(obj.Mesh, "Placement")
        obj.Mesh = empty


def show_topology(obj, report):
    """Fills the properties of TOPOLOGY."""
    obj.Triangles, obj.Vertices = report.triangles, report.vertices
    obj.Oriented = report.oriented


def show_angles(obj, report):
    """Fills the properties of ANGLES and ANGLE_PROMISES, and Notes."""
    obj.MeasuredMinAngle, obj.MeasuredMaxAngle = report.min_angle, report.max_angle
    obj.AskedMinAngle = report.min_angle_asked
    obj.Exempt = [f"triangle {triangle}: {why}" for triangle, why in report.exempt]
    obj.Notes = list(report.notes)


def show_certificate(obj, report, closed, findings):
    """Fills what every kind of object has in the group Certificate.

    report  a MeshReport
    closed  whether the mesh was to be closed
    """
    obj.AskedClosed, obj.Closed, obj.Manifold = closed, report.closed, report.manifold
    obj.Certificate = certificate.sentence(findings)
    obj.CertificateFaces = certificate.faces(findings)
    obj.CertificatePlace = [FreeCAD.Vector(*corner) for corner in certificate.place(findings)]


def add_options(obj, table):
    """A property for each option of the table, with its default."""
    for option in table:
        name, value = option.property_name, aliases.first_value(obj, option)
        if add_property(obj, option.property_type, name, option.group, option.property_help):
            if option.choices:
                setattr(obj, name, option.property_choices)
            setattr(obj, name, value)
    aliases.add(obj, table)
    if options.has_distance(table):
        distance_bound.add(obj, table)


def options_of(obj, table):
    """{option: value} of the object's properties."""
    values = {option.name: options.from_property(option, property_of(obj, option.property_name))
              for option in table}
    if options.has_distance(table):
        values.update(options.bound_from_properties(obj.DistanceBound, values))
    return values


def set_options(obj, table, values):
    """Sets the properties of {option: value}, checked before."""
    for option in table:
        setattr(obj, option.property_name, options.to_property(option, values[option.name]))
    if options.has_distance(table):
        obj.DistanceBound = options.bound_of(values)


def add(document, name, title, make):
    """Adds an object and computes it, as one undo step of its own or as a part of the transaction
    that is open. `make(obj)` gives it its properties and returns its proxy.

    Returns the object; on an error nothing is added.
    """
    with _undo_step(document, title):
        obj = document.addObject("Mesh::FeaturePython", name)
        try:
            proxy = make(obj)
            if FreeCAD.GuiUp:
                proxy.attach_view(obj.ViewObject)
            obj.recompute()
            if proxy.error is not None:
                raise proxy.error
            if FreeCAD.GuiUp:
                _leave_heavy_to_the_user(obj)
                _show_in_place_of_sources(obj)
            obj.purgeTouched()
        except BaseException:
            document.removeObject(obj.Name)
            raise
    return obj


def _leave_heavy_to_the_user(obj):
    from ..gui import preferences

    if obj.Mesh.CountFacets > preferences.manual_above():
        obj.Recompute = MANUAL


def _show_in_place_of_sources(obj):
    from ..gui import looks

    looks.show_in_place_of_sources(obj)


def update(obj, values, progress=None):
    """Gives the object those options and computes it, as one undo step of its own or as a part of
    the transaction that is open. On an error all stays as it was; also where `progress` has removed
    the object, closed its document or changed what it is made of.
    """
    proxy = getattr(obj, "Proxy", None)
    if not isinstance(proxy, MeshObject):
        raise InvalidInput(f"{convert.label_of(obj)} is no mesh of MeshQuality: give an object of "
                           "add_quality_mesh, add_curved_mesh, add_boolean or add_improved_mesh")
    table, sources = proxy.OPTIONS, proxy.sources(obj)
    values = options.check(table, options.merged(options_of(obj, table), options.renamed(table, values)))
    done = result_for(type(proxy), sources, values)
    if done is None:
        work = proxy.work_on(sources, values, obj)
        label = obj.Label
        done = work, None if proxy.is_result(obj, work) else work.result(progress)
        if progress is not None and done[1] is not None:
            _require_unchanged(obj, label, values, work)
    with _undo_step(obj.Document, f"Update {obj.Label}"):
        set_options(obj, table, values)
        if done[1] is None:
            obj.Status = UP_TO_DATE
            return
        with handed_over(*done):
            obj.recompute()
        if proxy.error is not None:
            raise proxy.error
        obj.purgeTouched()
        for dependent in obj.InList:
            dependent.touch()


def _require_unchanged(obj, label, values, work):
    """Raises Error where scripts have taken away meanwhile what the result is for."""
    try:
        there = obj.Document.getObject(obj.Name) == obj
    except (ReferenceError, RuntimeError, AttributeError):
        there = False
    if not there:
        raise Error(f"'{label}' was removed, or its document closed, while it was computed: nothing was changed")
    now = obj.Proxy.work_on(obj.Proxy.sources(obj), values, obj)
    if now.fingerprint != work.fingerprint:
        raise Error(f"the source of '{label}' was changed while the mesh was computed: the mesh stays as it was; "
                    "update it again")


@contextmanager
def _undo_step(document, title):
    """One undo step, or a part of the transaction that is open; none after an error."""
    # A transaction that was opened shows in the document only after its first change.
    own_transaction = not (document.HasPendingTransaction or FreeCAD.getActiveTransaction())
    if own_transaction:
        document.openTransaction(title)
    try:
        yield
    except BaseException:
        if own_transaction:
            document.abortTransaction()
        raise
    if own_transaction:
        document.commitTransaction()


def add_of_source(proxy_class, source, values, name, title, label=None):
    """Adds an object that is made of `source`, a document object or a pair (document object, path) as in
    frames; see add. Its label begins with
    that of the source and ends with `label`, or the title.
    """
    if not isinstance(frames.object_of(source), FreeCAD.DocumentObject):
        raise InvalidInput(f"a document object with {proxy_class.NEEDS} is needed, not "
                           f"{type(source).__name__}")
    checked = options.check(proxy_class.OPTIONS, values)

    def make(obj):
        proxy = proxy_class(obj)
        obj.Label = f"{frames.leaf_of(source).Label} {label or title.lower()}"
        obj.Source, obj.SourcePath = frames.object_of(source), frames.path_of(source)
        set_options(obj, proxy_class.OPTIONS, checked)
        return proxy

    return add(frames.object_of(source).Document, name, title, make)
