# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pages of reports say, a part of the table of phrases. Imports nothing of FreeCAD."""

TITLE = "Report: {name}"
MET, NOT_MET, NOT_DECIDED, NO_LIMITS = "All requested limits are met", "Target not met", "Target not decided", "No limits were requested"
REQUESTED, MEASURED, WHOLE = "Requested", "Measured", "The whole report"
SEEN, DISTRIBUTION, BY_FACE, PLACES, ORIGIN = "Pictures", "Distribution", "By face", "Places", "Versions and digest"
TRIANGLES, ELEMENTS, VERTICES, CLOSED, MANIFOLD, CROSSINGS = "Triangles", "Elements", "Vertices", "Closed", "Manifold", "Crossing pairs of triangles"
MIN_ANGLE, MAX_ANGLE, DEVIATION, PROVEN = "Smallest angle", "Largest angle", "Max. deviation", "Max. deviation, proven"
AREA, VOLUME, SIZE = "Area", "Volume", "Size"
SIGNED, THICKNESS, DRAFT, JACOBIAN = "Deviation from the part", "Wall thickness", "Draft", "Scaled Jacobian of the corners"
FACE, COUNT, WORST, MEAN = "Face", "Count", "Worst", "Mean"
YES, NO, NONE = "yes", "no", "none"
SHOWN = "{count} of {count2} are shown."
GREY = "Grey: no value there."
DIGEST = "SHA-256 of the vertices (float64) and triangles (int32)"
WRITTEN = "Written"
TEXTS = tuple(value for name, value in sorted(globals().items()) if name.isupper() and isinstance(value, str))
