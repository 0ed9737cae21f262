# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analyses of FreeCAD's FEM workbench, as the window knows them."""

import FemGui
import FreeCADGui

from ..core.sources import frames
from ..features import fem_mesh


def chosen_for(source):
    """The analysis that a mesh of this source is meant for: the active one, else one that is selected or that lists
    something selected; None without one in the source's document.
    """
    document = frames.object_of(source).Document
    selected = FreeCADGui.Selection.getSelection(document.Name)
    found = [FemGui.getActiveAnalysis(), *filter(fem_mesh.is_analysis, selected),
             *map(fem_mesh.analysis_around, selected)]
    return next((analysis for analysis in found if analysis is not None and analysis.Document == document), None)
