# SPDX-License-Identifier: LGPL-2.1-or-later
"""Automatic meshes follow what they are made of in the background.

A recompute that comes from the window leaves the work to a job and goes on; the mesh that was there
stays until the new one lands. Python code that has a document recomputed finds the new mesh when
that returns, as everywhere in FreeCAD. A mesh that lands is no undo step of its own, as the user has
done none; after undo, redo or a step that was given up, meshes follow again.
"""

import os
import sys
from contextlib import contextmanager

import FreeCAD
from PySide import QtCore

from ..features import mesh_object, properties
from ..features.recompute_work import Work
from . import background, jobs, preferences
from .panel_operation import Operation, Watch, is_there, obstacle_in

translate = FreeCAD.Qt.translate

_PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
_LINE = "<string>"  # file name of the lines of Python that FreeCAD's own commands are made of

_PAUSE = 10  # ms

_followers = {}  # by document and object, by name: what computes it
_landing = False
_observer = None


def begin(obj):
    """Has an automatic mesh computed in the background, from its sources as they are once the work
    starts, unless Python code waits for it. Work for it that was begun before ends.

    Returns whether it is left to the background.
    """
    if not (preferences.in_background() and _follows(obj) and (_landing or not _python_waits())):
        return False
    _begin(obj)
    return True


def stop(obj):
    """Ends the work for an object, if there is any; the mesh that it has stays."""
    follower = _followers.pop(_key(obj), None)
    if follower is not None:
        follower.job.cancel()
        obj.Status = mesh_object.OUT_OF_DATE


def is_computing(obj):
    """Whether there is work for an object."""
    return _key(obj) in _followers


def resume(obj):
    """Takes up what was not finished when its document was saved, once that has been loaded."""
    if _follows(obj):
        document = obj.Document.Name
        _once_at_rest(document, lambda: is_there(document, obj) and _begin(obj))


def _follows(obj):
    """Whether a mesh follows by itself; one that is new is computed by what adds it."""
    return isinstance(getattr(obj, "Proxy", None), mesh_object.MeshObject) \
        and obj.Recompute == mesh_object.AUTOMATIC and bool(obj.Fingerprint)


def _python_waits():
    """Whether code in a file or in the console goes on when the recompute returns."""
    frame = sys._getframe()
    while frame is not None:
        name = frame.f_code.co_filename
        if name != _LINE and not os.path.abspath(name).startswith(_PACKAGE):
            return True
        frame = frame.f_back
    return False


def _begin(obj):
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)
    stop(obj)
    obj.Status = mesh_object.COMPUTING
    follower = _followers[_key(obj)] = _Follower(obj)
    jobs.queue().add(follower.job)


def _key(obj):
    return obj.Document.Name, obj.Name


@contextmanager
def _while_landing():
    """Meanwhile what is made of the mesh follows in the background, too."""
    global _landing
    _landing = True
    try:
        yield
    finally:
        _landing = False


class _Follower:
    """Computes one object once."""

    def __init__(self, obj):
        self._obj, self._key = obj, _key(obj)
        self._made = self._work = self._watch = None
        self._held = ""
        self.job = jobs.Job(
            translate("MeshQuality", "Update {}").format(obj.Label), self._compute, self._take,
            self._is_there, quiet=True, prepare=self._prepare,
            obstacle=lambda: obstacle_in(self._key[0]), taking=jobs.ADDING)
        self.job.ended.connect(self._ended)
        background.tell(self.job, lambda: stop(obj))

    def _is_there(self):
        return is_there(self._key[0], self._obj)

    def _prepare(self):
        self._made = Operation.of_object(self.job.title, self._obj)
        self._work = self._made.work(self._made.values())
        self._held = self._obj.Proxy.held(self._obj)
        self._watch = Watch(self._made.sources)

    def _compute(self, progress):
        """The result; None where the object has it already."""
        return None if self._work.announced_fingerprint(progress) == self._held else self._work.result(progress)

    def _take(self, result):
        self._forget()
        if result is None:
            self._obj.Status = mesh_object.UP_TO_DATE
            return
        self._hand_over(self._work, result)
        needed_by = self._obj.InListRecursive
        if needed_by:
            for obj in self._obj.InList:
                obj.touch()
            with _while_landing():
                self._obj.Document.recompute(needed_by)

    def _ended(self):
        if self._watch is not None:
            self._watch.end()
        newest = _followers.get(self._key) in (None, self)
        self._forget()
        if not newest or not self._is_there() or self.job.state == jobs.CANCELLED:
            return
        if self.job.state == jobs.FAILED:
            self._fail()
        elif self._watch.changed:
            _begin(self._obj)

    def _fail(self):
        """Marks the object as FreeCAD marks what it could not compute."""
        obj = self._obj
        obj.Status = mesh_object.OUT_OF_DATE
        self._hand_over(self._work or Work(
            obj.Proxy.sources(obj),
            properties.options_of(obj, obj.Proxy.OPTIONS), None, None), self.job.error)

    def _hand_over(self, work, result):
        """Has the object take a result, or fail with an error."""
        with mesh_object.with_precomputed(self._obj.Proxy, work, result), _while_landing():
            self._obj.recompute()
        self._obj.purgeTouched()

    def _forget(self):
        if _followers.get(self._key) is self:
            del _followers[self._key]


class _Observer:
    """Has meshes follow where undo, redo or a step given up has changed what they are made of."""

    def slotUndoDocument(self, document):
        """Called by FreeCAD."""
        _follow_all(document)

    slotRedoDocument = slotAbortTransaction = slotUndoDocument


def _follow_all(document):
    name = document.Name

    def follow():
        if name in FreeCAD.listDocuments():
            for obj in FreeCAD.getDocument(name).Objects:
                if _follows(obj) and any("Touched" in o.State
                                         for o in (obj, *obj.OutListRecursive)):
                    _begin(obj)

    _once_at_rest(name, follow)


def _once_at_rest(document, act):
    """Acts once FreeCAD is through with what it does to the document of this name."""
    QtCore.QTimer.singleShot(
        _PAUSE, lambda: _once_at_rest(document, act) if obstacle_in(document) else act())
