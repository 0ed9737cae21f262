# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size fields of document objects: what stores them, and what meshes take of them."""

import hashlib

import numpy as np

from ..compat import PlainState, extension
from ..core.sizes import forms, regions, size_field
from ..core.sizes.interpolated import Interpolated, interpolated
from ..core.sources import convert, frames
from ..errors import InvalidInput
from .gui_hooks import window
from .properties import add_hidden, add_property


class SizeData(PlainState):
    """Proxy of an App::FeaturePython with sizes of points, of a mesh, or of a function that was sampled."""

    _ARRAYS = (("Nodes", "App::PropertyFloatList", "Places, three numbers each"),
               ("Simplices", "App::PropertyIntegerList", "Four indices of nodes each; of a sampled function its cells"),
               ("Sizes", "App::PropertyFloatList", "Sizes by node; of a sampled function by corner of its cells"))

    def __init__(self, obj):
        obj.Proxy = self
        add_property(obj, "App::PropertyString", "From", "Sizes", "What the sizes were made of")
        add_hidden(obj, "Sizes", [(name, kind, text) for name, kind, text in self._ARRAYS])
        obj.setEditorMode("From", 1)

    def onDocumentRestored(self, obj):
        """A document that was saved without the GUI gets views."""
        window().attach_view(obj)

    def execute(self, obj):
        """What FreeCAD calls."""

    def store(self, obj, field):
        """Puts the numbers of an Interpolated, or of the octree of the core, into the object."""
        obj.From = field.name
        for (name, *_), array in zip(self._ARRAYS, field.arrays()):
            setattr(obj, name, convert.lists(np.asarray(array).ravel()))

    def size_fields(self, obj):
        """The field of the numbers."""
        nodes, sizes = np.array(obj.Nodes), np.array(obj.Sizes)
        simplices = np.array(obj.Simplices, dtype=np.int32)
        digest = hashlib.sha256(nodes.tobytes() + simplices.tobytes() + sizes.tobytes()).hexdigest()
        if len(nodes) == 4:  # low corner and side of an octree
            core = extension().size_field_from_arrays(tuple(nodes[:3]), nodes[3], simplices, sizes)
            field = forms.Octree(core)
        else:
            field = interpolated(nodes.reshape(-1, 3), simplices.reshape(-1, 4), sizes, obj.Label)
        field.digest = lambda: digest
        return [field]


def is_field(obj):
    """Whether a document object gives a size field."""
    return hasattr(getattr(obj, "Proxy", None), "size_fields")


def names_of(form, source):
    """The names of document objects that stand for any form of size_field=: those there are, and new ones with what else is given.

    source  what is meshed. Returns (names or None, objects that were added).
    """
    if form is None:
        return None, []
    document = frames.object_of(source).Document
    parts = form if isinstance(form, list) and all(map(_is_whole, form)) else [form]
    names, added = [], []
    for part in parts:
        if isinstance(part, str) and document.getObject(part) is not None:
            part = document.getObject(part)
        if not is_field(part):
            part = _stored(part, source, document)
            added.append(part)
        names.append(part.Name)
    return names, added


def _is_whole(part):
    return callable(part) or isinstance(part, (str, tuple, np.ndarray, Given)) or is_field(part)


def _stored(form, source, document):
    fields = forms.fields_of(form)
    if len(fields) == 1 and hasattr(fields[0], "arrays"):
        field = fields[0]
    else:
        field = forms.Octree(size_field.Sampling(convert.shape_of(source), fields, None, True).core())
        field.name = ", ".join(one.name for one in fields)
    obj = document.addObject("App::FeaturePython", "SizeField")
    SizeData(obj)
    obj.Label = "Size field"
    obj.Proxy.store(obj, field)
    window().attach_view(obj)
    obj.purgeTouched()
    return obj


def fields_for(source, names, own_frame=False):
    """The fields of document objects by name, for the mesh of a source; own_frame: where that is without its containers.

    Returns (fields or None, digests).
    """
    if not names:
        return None, []
    document, found = frames.object_of(source).Document, []
    for name in names:
        obj = document.getObject(name)
        if obj is None or not is_field(obj):
            raise InvalidInput(f"size_field names {name!r}, which is no Size region or Size field of document '{document.Label}'")
        found += obj.Proxy.size_fields(obj)
    digests = [field.digest() for field in found]
    frame = frames.frame_of(source) if own_frame else None
    if frame is not None and not frames.is_identity(frame):
        found = [regions.Moved(field, frame) for field in found]
    return Given(found), digests


def moved(form, frame):
    """A form of size_field= for points that the frame takes to those of that form."""
    if frames.is_identity(frame):
        return form
    return Given([_moved_nodes(field, frame) if isinstance(field, Interpolated) else regions.Moved(field, frame) for field in forms.fields_of(form)])


def _moved_nodes(field, frame):
    nodes, simplices, sizes = field.arrays()
    return interpolated(convert.moved(nodes, frame.inverse()), simplices, sizes, field.name)


class Given:
    """Fields as a form of size_field=."""

    def __init__(self, fields):
        self._fields = fields

    def size_fields(self):
        """The fields."""
        return self._fields
