# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a panel does to the document: it adds a mesh, or gives one other options.

The change is a line of Python that the macro records. The object takes the result, which has been computed
before, in the background.
"""

import FreeCAD
import FreeCADGui

from .. import options, phrases
from ..core.sources import frames
from ..errors import InvalidInput
from ..features import bindings, mesh_object, properties

translate = FreeCAD.Qt.translate

# Properties of a source that do not change its shape or mesh.
_LOOKS = ("Label", "Label2", "Visibility", "Proxy", "ExpressionEngine", "_GroupTouched")
_HELD = "Group", "ElementList"  # properties that list the objects in a container


class Operation:
    """One mesh that a panel makes.

    title    for windows and undo
    kind     class of the object's proxy
    sources  what the mesh is made of: document objects, or pairs (document object, path) as in frames
    trial    trial(values, obj) -> Trial with these options, for an estimate; None: no estimate
    obj      the document object, once there is one
    document name of the document
    chosen   {option: value} that the selection says of a new object
    """

    def __init__(self, title, kind, sources, trial=None, obj=None, chosen=None):
        self.title, self.kind, self.sources = title, kind, list(sources)
        self.chosen = chosen or {}
        self.trial, self._obj = trial, obj
        self.document = (obj or frames.object_of(self.sources[0])).Document.Name

    @classmethod
    def of_object(cls, title, obj, trial=None):
        """The operation that edits an object."""
        return cls(title, type(obj.Proxy), obj.Proxy.sources(obj), trial, obj)

    @property
    def obj(self):
        """The document object; None before it was added and after it was removed."""
        return self._obj if self._obj is not None and is_there(self.document, self._obj) else None

    def size(self):
        """Largest dimension of the source in mm, for people; 0: unknown."""
        return self.kind.size_of(self.sources)

    def values(self):
        """The options of the object, {} without one."""
        return properties.options_of(self.obj, self.kind.OPTIONS) if self.obj else {}

    def expressions(self):
        """{option: expression} of those options of the object that expressions set."""
        found = bindings.expressions_of(self.obj, self.kind.OPTIONS) if self.obj else {}
        return {name: expression for name, (_, expression) in found.items()}

    def work(self, values):
        """The Work to be done."""
        return self.kind.work_on(self.sources, values, self.obj)

    def is_done(self, work):
        """Whether the object already holds the result of the work with these values."""
        return self.obj is not None and work.values == self.values() and not self._order() \
            and self.obj.Proxy.is_result(self.obj, work)

    def possible(self, edited):
        """Whether the document still has the sources, and the object that is edited unless None."""
        needed = [*self.sources, *([edited] if edited is not None else [])]
        return all(obj is not None and is_there(self.document, frames.object_of(obj)) for obj in needed)

    def obstacle(self):
        """The obstacle that delays taking a result, see obstacle_in."""
        return obstacle_in(self.document)

    def obstacle_beside_tasks(self):
        """As obstacle(), or another task that the user has opened: the mesh would end the task's step of undo too early."""
        step_is_open = FreeCADGui.Control.activeDialog() and self.document in FreeCAD.listDocuments() \
            and (FreeCAD.getDocument(self.document).HasPendingTransaction or FreeCAD.getActiveTransaction())
        return obstacle_in(self.document) or (
            translate("MeshQuality", "waiting until the open task is closed") if step_is_open else "")

    @property
    def step(self):
        """The name of the step of undo."""
        return translate("MeshQuality", "Edit {}").format(self.obj.Label) \
            if self.obj is not None else self.title

    def line(self, values):
        """The line of Python that makes the change."""
        if self.obj is not None:
            return f"{self._order()}mq.update({name_of(self.obj)}{_arguments(values, self.values())})"
        given = self.kind.called_with([name_of(source) for source in self.sources])
        return f"mq.{self.kind.CALL}({given}{_arguments(values, options.defaults(self.kind.OPTIONS))})"

    def _order(self):
        """The Python that reorders the object's operands; empty if they are in this order."""
        if "Sources" not in self.kind.LINKS or self.obj.Proxy.sources(self.obj) == self.sources:
            return ""
        names = ", ".join(name_of(frames.object_of(source)) for source in self.sources)
        paths = [frames.path_of(source) for source in self.sources]
        return f"obj = {name_of(self.obj)}; obj.Sources, obj.SourcePaths = [{names}], {paths!r}; "

    def land(self, work, result, watch):
        """Changes the document by that line, as one undo step. Where a source has changed while the
        work ran, the object is left touched: the next recompute brings it up to date.
        """
        document, line = FreeCAD.getDocument(self.document), self.line(work.values)
        document.openTransaction(self.step)
        try:
            taker = self.obj.Proxy if self.obj is not None else self.kind
            with mesh_object.with_precomputed(taker, work, result):
                FreeCADGui.doCommand("import MeshQuality as mq")
                FreeCADGui.doCommand(line)
        except BaseException:
            document.abortTransaction()
            raise
        if self.obj is None:
            self._obj = document.ActiveObject
        document.commitTransaction()
        if watch.changed:
            self._obj.Status = mesh_object.OUT_OF_DATE
            self._obj.touch()


class Watch:
    """Notes whether one of the sources or what they are made of changes, or a container around them but for what it holds."""

    def __init__(self, sources):
        objects = [frames.object_of(source) for source in sources if frames.object_of(source) is not None]
        self._objects = {_key(obj) for source in objects for obj in (source, *source.OutListRecursive)}
        self._around = {_key(obj) for source in objects for obj in frames.containers_of(source)}
        self.changed = False
        FreeCAD.addDocumentObserver(self)

    def end(self):
        """Stops watching."""
        FreeCAD.removeDocumentObserver(self)

    def slotChangedObject(self, obj, name):
        """Called by FreeCAD."""
        if name not in _LOOKS and (_key(obj) in self._objects or name not in _HELD and _key(obj) in self._around):
            self.changed = True


def _key(obj):
    return obj.Document.Name, obj.Name


def is_there(document, obj):
    """Whether the object still is in the document of this name."""
    return document in FreeCAD.listDocuments() and obj in FreeCAD.getDocument(document).Objects


def obstacle_in(document):
    """The operation that the document of this name is in the middle of, in the user's language; empty: none."""
    if document not in FreeCAD.listDocuments():
        return ""
    found = FreeCAD.getDocument(document)
    if found.Recomputing:
        return translate("MeshQuality", "waits for FreeCAD: recomputing {}").format(found.Label)
    if found.Transacting:
        return translate("MeshQuality", "waits for FreeCAD: undoing or redoing in {}").format(found.Label)
    return translate("MeshQuality", "waits for FreeCAD: loading {}").format(found.Label) if found.Restoring else ""


def name_of(source):
    """The object or the source, in Python."""
    obj, path = frames.object_of(source), frames.path_of(source)
    if path:
        return f"({name_of(obj)}, {path!r})"
    return f"App.getDocument({obj.Document.Name!r}).getObject({obj.Name!r})"


def _arguments(values, known):
    """Those values that are not known, as arguments in Python."""
    return "".join(f", {name}={value!r}" for name, value in options.differing(values, known).items())


def check(operations, values):
    """The checked options of operations with one table.

    Raises InvalidInput, also where the document has lost what the operations need.
    """
    if operations[0].document not in FreeCAD.listDocuments():
        raise InvalidInput(phrases.Text(phrases.DOCUMENT_CLOSED))
    if not all(made.possible(made.obj) for made in operations):
        raise InvalidInput(phrases.Text(phrases.SOURCE_GONE))
    return options.check(operations[0].kind.OPTIONS, values)
