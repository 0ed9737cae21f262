# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of a document: objects are added and updated, each as one undo step."""

from contextlib import contextmanager

import FreeCAD

from .. import label_phrases, options
from ..core.sources import convert, frames
from ..errors import Error, InvalidInput
from ..phrases import Text
from . import bindings, size_fields
from .gui_hooks import window
from .mesh_object import MANUAL, UP_TO_DATE, MeshObject, PatchedMesh, with_precomputed
from .patches import give_patches
from .properties import options_of, set_options


def add(document, kind, name, title, make):
    """Adds an object and computes it, as one undo step of its own or within the transaction that is open.
    `kind` is the class of its proxy; `make(obj)` gives it its properties and returns its proxy.

    Returns the object; on an error nothing is added.
    """
    with undo_step(document, title):
        obj = document.addObject(kind.TYPE, name)
        try:
            proxy = make(obj)
            window().attach_view(obj)
            obj.recompute()
            if proxy.error is not None:
                raise proxy.error
            if proxy.size(obj) > window().manual_above():
                obj.Recompute = MANUAL
            window().show_in_place_of_sources(obj)
            obj.purgeTouched()
        except BaseException:
            document.removeObject(obj.Name)
            raise
    return obj


def update(obj, progress=None, **values):
    """Brings a document object of this package up to date, with changed options; one undo step.

    obj       of add_quality_mesh, add_curved_mesh, add_fem_mesh, add_cured_mesh, add_boolean, add_repaired_mesh,
              add_improved_mesh, add_simplified_mesh, add_offset, add_hollow, add_wrap, add_cam_mesh, add_flow_mesh, add_inspection or add_deviation
    progress  callable(fraction 0..1, stage); returning False cancels
    values    options to change; the others stay as they are, but a bound on the distance replaces the
              one that was there

    Raises what adding such an object raises, and then leaves it as it was; InvalidInput for an option whose
    property is bound to an expression; Error where progress has removed the object, closed its document
    or changed what it is made of.
    """
    options.require_callable(progress)
    if isinstance(obj, FreeCAD.DocumentObject):
        obj = frames.linked_of(obj)[0]
    proxy = getattr(obj, "Proxy", None)
    if not isinstance(proxy, MeshObject):
        raise InvalidInput(f"{convert.label_of(obj)} is no mesh of MeshQuality: give an object of "
                           "add_quality_mesh, add_curved_mesh, add_fem_mesh, add_boolean, add_repaired_mesh, add_improved_mesh, "
                           "add_simplified_mesh, add_offset, add_hollow, add_wrap, add_flow_mesh, add_inspection or add_deviation")
    table, sources = proxy.OPTIONS, proxy.sources(obj)
    before = options_of(obj, table)
    if values.get("size_field") is not None:
        values = {**values, "size_field": size_fields.names_of(values["size_field"], sources[0])[0]}
    values = options.check(table, options.merged(before, options.renamed(table, values)))
    bindings.require_free(obj, table, before, values)
    done = proxy.precomputed_for(sources, values)
    if done is None:
        work = proxy.work_on(sources, values, obj)
        label = obj.Label
        done = work, None if proxy.is_result(obj, work) else work.result(progress)
        if progress is not None and done[1] is not None:
            _require_unchanged(obj, label, values, work)
    with undo_step(obj.Document, f"Update {obj.Label}"):
        set_options(obj, table, values)
        if done[1] is None:
            obj.Status = UP_TO_DATE
            return
        with with_precomputed(proxy, *done):
            obj.recompute()
        if proxy.error is not None:
            raise proxy.error
        obj.purgeTouched()
        for dependent in obj.InList:
            dependent.touch()


def set_patches(obj, patches, patch_rest=None):
    """Gives a mesh object named groups of the faces of its sources; one undo step. The mesh stays as it is.

    obj         of add_quality_mesh, add_curved_mesh, add_offset, add_hollow (triangles of the hollow are in the patch of the
                face from which they are offset), add_wrap, add_fem_mesh or add_flow_mesh, which have them as groups of their elements
    patches     {"inlet": ["Face1", "Face4"], ...}, or {"inlet": {"faces": [...], "colour": "#ff0000"}}; of a
                container also "Box.Face1"; of a wrap "Box.Face1" by the name of the source, "Scan" of one that is a mesh,
                and "gaps"; None: no patches
    patch_rest  name of the patch of all other faces; None: each is one by its own name

    After an edit of a source the faces of patches are found again by kind, area and place; where that is not
    possible the property PatchesChanged and a warning name them. Raises InvalidInput naming patch, face and remedy.
    """
    if isinstance(obj, FreeCAD.DocumentObject):
        obj = frames.linked_of(obj)[0]
    if not isinstance(getattr(obj, "Proxy", None), PatchedMesh) or not obj.Proxy.has_faces(obj):
        raise InvalidInput(f"{convert.label_of(obj)} has no patches: give an object of add_quality_mesh, add_curved_mesh, "
                           "add_fem_mesh, add_flow_mesh, add_offset or add_hollow whose source is a shape, or of add_wrap")
    obj.Proxy.require_patch_names([*(patches if isinstance(patches, dict) else ()), *filter(None, (patch_rest,))])
    with undo_step(obj.Document, f"Patches of {obj.Label}"):
        give_patches(obj, obj.Proxy.faces(obj), patches, patch_rest)
        obj.Proxy.show_patches(obj)
        obj.purgeTouched()
        for dependent in obj.InList:
            dependent.touch()


def _require_unchanged(obj, label, values, work):
    """Raises Error if the object or its document is gone, or a source has changed meanwhile."""
    try:
        there = obj in obj.Document.Objects
    except (ReferenceError, RuntimeError, AttributeError):
        there = False
    if not there:
        raise Error(f"'{label}' was removed, or its document closed, while it was computed: nothing was changed")
    now = obj.Proxy.work_on(obj.Proxy.sources(obj), values, obj)
    if now.fingerprint != work.fingerprint:
        raise Error(f"the source of '{label}' was changed while the mesh was computed: the mesh stays as it was; "
                    "update it again")


@contextmanager
def undo_step(document, title):
    """One undo step, or changes of the transaction that is open; none after an error."""
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


def labelled(source, word):
    """The label of an object that is made of `source`: a word of the table behind that of the source, in the user's language."""
    return window().translated(Text(label_phrases.LABELS[word], name=frames.leaf_of(source).Label))


def add_of_source(proxy_class, source, values, name, title, label=None, then=None):
    """Adds an object that is made of `source`, a document object or a pair (document object, path) as in
    frames; see add. Its label begins with that of the source and ends with `label`, or the title. then(obj) does what
    else belongs to the step.
    """
    if not isinstance(frames.object_of(source), FreeCAD.DocumentObject):
        raise InvalidInput(f"a document object with {proxy_class.NEEDS} is needed, not "
                           f"{type(source).__name__}")
    if values.get("size_field") is None:
        return _add_of_source(proxy_class, source, values, name, title, label, then)
    options.check(proxy_class.OPTIONS, {**values, "size_field": None})
    with undo_step(frames.object_of(source).Document, title):
        fields, added = size_fields.names_of(values.get("size_field"), source)
        try:
            return _add_of_source(proxy_class, source, {**values, "size_field": fields}, name, title, label, then)
        except BaseException:
            for obj in added:
                obj.Document.removeObject(obj.Name)
            raise


def _add_of_source(proxy_class, source, values, name, title, label, then):
    checked = options.check(proxy_class.OPTIONS, values)

    def make(obj):
        proxy = proxy_class(obj)
        obj.Label = labelled(source, label or title.lower())
        obj.Source, obj.SourcePath = frames.object_of(source), frames.path_of(source)
        set_options(obj, proxy_class.OPTIONS, checked)
        if then is not None:
            then(obj)
        return proxy

    return add(frames.object_of(source).Document, proxy_class, name, title, make)
