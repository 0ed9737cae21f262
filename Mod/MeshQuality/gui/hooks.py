# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window's answers to requests of document objects; see features/gui_hooks.py."""

from ..compat import PlainState
from ..features import size_fields
from ..features.curved_mesh import CurvedMeshObject
from ..features.gui_hooks import Windowless
from . import (background_recompute, file_progress, mesh_view, preferences, size_view, translation, value_colours,
               visibility)


class Window(Windowless):
    """The answers where there is a window."""

    def attach_view(self, obj):
        """Gives the view of an object its proxy, unless it has one."""
        if not isinstance(obj.ViewObject.Proxy, PlainState):
            _view_of(obj)(obj.ViewObject)

    def begin_in_background(self, obj):
        """As background_recompute.begin."""
        return background_recompute.begin(obj)

    def resume_in_background(self, obj):
        """As background_recompute.resume."""
        background_recompute.resume(obj)

    def stop_in_background(self, obj):
        """As background_recompute.stop."""
        background_recompute.stop(obj)

    def translated(self, text):
        """As translation.translated."""
        return translation.translated(text)

    def manual_above(self):
        """As preferences.manual_above."""
        return preferences.manual_above()

    def analysis_for(self, source):
        """As fem_analyses.chosen_for."""
        from . import fem_analyses  # imports FreeCAD's FEM workbench, which no other object needs

        return fem_analyses.chosen_for(source)

    def show_in_place_of_sources(self, obj):
        """As visibility.show_in_place_of_sources."""
        visibility.show_in_place_of_sources(obj)

    def show_faces(self, obj, colours):
        """As visibility.show_faces."""
        visibility.show_faces(obj, colours)

    def show_solid(self, obj):
        """As visibility.show_solid."""
        visibility.show_solid(obj)

    def show_values(self, obj, values, limit=None):
        """As value_colours.show."""
        value_colours.show(obj, values, limit)

    def file_progress(self, title):
        """As file_progress.shown."""
        return file_progress.shown(title)

    def drawing(self):
        """The Drawing of the 3D view."""
        # Here, not on the thread that computes: Coin is loaded where the window is.
        from .curved_view import Drawing

        return Drawing


def _view_of(obj):
    """The class of the view's proxy: curved elements are shown with their edges."""
    if isinstance(obj.Proxy, CurvedMeshObject):
        from .curved_view import CurvedMeshView  # imports Coin, which no other object needs

        return CurvedMeshView
    if size_fields.is_field(obj):
        return size_view.SizeView
    return mesh_view.MeshView


WINDOW = Window()
