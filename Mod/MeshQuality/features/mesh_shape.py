# SPDX-License-Identifier: LGPL-2.1-or-later
"""What document objects have in common whose shape is made of a mesh of the document and follows that."""

from .. import phrases
from ..compat import PlainState, without_traceback
from ..core.sources import frames
from ..errors import InvalidInput
from ..phrases import Text
from .properties import add_property
from .transactions import labelled, undo_step


class MeshShape(PlainState):
    """Proxy of a Part::FeaturePython that makes a shape of its Source's mesh. A subclass has NAME, of the object, TITLE, of the
    step of undo, WORD, of the table of labels, and make_shape.
    """

    def __init__(self, obj):
        obj.Proxy = self
        add_property(obj, "App::PropertyLinkGlobal", "Source", "Mesh", "The object whose mesh is taken")
        add_property(obj, "App::PropertyString", "SourcePath", "Mesh",
                     "The path from the source to what is meshed, where only a link leads there: Part.Box.")

    def make_shape(self, obj, source):
        """Gives the object the shape of the mesh of a source, and what is said of it."""
        raise NotImplementedError

    @property
    def execute(self):
        """What FreeCAD calls to bring the shape up to date; see without_traceback."""
        return without_traceback(self._bring_up_to_date)

    @staticmethod
    def source(obj):
        """The source, see frames; None where it was deleted."""
        return frames.source_of(obj.Source, obj.SourcePath)

    def _bring_up_to_date(self, obj):
        source = self.source(obj)
        if source is None:
            raise InvalidInput(Text(phrases.SOURCE_DELETED))
        self.make_shape(obj, source)

    @classmethod
    def add(cls, source, **values):
        """Adds an object with this shape of a source, and these values of its properties; one undo step. On an error nothing is added."""
        document = frames.object_of(source).Document
        with undo_step(document, cls.TITLE):
            made = document.addObject("Part::FeaturePython", cls.NAME)
            try:
                proxy = cls(made)
                made.Label = labelled(source, cls.WORD)
                made.Source, made.SourcePath = frames.object_of(source), frames.path_of(source)
                for name, value in values.items():
                    setattr(made, name, value)
                proxy.make_shape(made, source)
                made.purgeTouched()
            except BaseException:
                document.removeObject(made.Name)
                raise
        return made
