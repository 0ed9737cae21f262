# SPDX-License-Identifier: LGPL-2.1-or-later
"""The requests of document objects to the window. The window fills this in: document objects import nothing of it."""

import contextlib
import importlib
import math

_filled_by = ""  # name of the module that answers where there is a window


class Windowless:
    """The requests, with the answers where there is no window."""

    def attach_view(self, obj):
        """Gives the view of an object its proxy."""

    def begin_in_background(self, obj):
        """Has the background compute an object; returns whether it does."""
        return False

    def resume_in_background(self, obj):
        """Has the background compute what was unfinished when the document was saved."""

    def stop_in_background(self, obj):
        """Ends that."""

    def translated(self, text):
        """A reason, an error or another phrase, for the report view."""
        return str(text)

    def manual_above(self):
        """Number of triangles above which a new mesh does not follow its source by itself."""
        return math.inf

    def analysis_for(self, source):
        """The analysis of FreeCAD's FEM workbench that a mesh of this source is meant for, if the window knows one."""
        return None

    def show_in_place_of_sources(self, obj):
        """Shows an object that was added where its sources were seen."""

    def show_faces(self, obj, colours):
        """Shows the faces of an object with a shape in colours: red, green, blue from 0 to 255, in place of its sources."""

    def show_solid(self, obj):
        """Shows an object with a solid that was made of its Source, in place of that."""

    def show_values(self, obj, values, limit=None):
        """Colours the triangles of an object by thicknesses in mm, or by deviations between -limit and limit; None: it has one
        colour.
        """

    def file_progress(self, title):
        """A context whose value is what triangulate takes as progress, for work on the main thread that a window shows."""
        return contextlib.nullcontext()

    def drawing(self):
        """drawing(tessellation, quality), which any thread may call, makes what shows a curved mesh; None: nothing
        shows it.
        """
        return None


WINDOWLESS = Windowless()


def fill(module):
    """Names the module whose WINDOW, a Windowless, answers where there is a window; it is loaded on first use."""
    global _filled_by
    _filled_by = module


def window():
    """The object that answers now."""
    import FreeCAD  # not above: the command line loads this outside FreeCAD, too

    return importlib.import_module(_filled_by).WINDOW if FreeCAD.GuiUp and _filled_by else WINDOWLESS
