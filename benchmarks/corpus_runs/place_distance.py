# SPDX-License-Identifier: LGPL-2.1-or-later
"""The distance of a place from a shape by OpenCASCADE, inside freecadcmd: what a judge's own search says is far can be refuted so.

MESHQUALITY_JOB: {"brep": FILE, "place": [x, y, z]}. The last line of the output is the distance, mm.
"""

import json
import os

import FreeCAD
import Part

JOB = json.loads(os.environ["MESHQUALITY_JOB"])

shape = Part.Shape()
shape.read(JOB["brep"])
print()
print(shape.distToShape(Part.Vertex(FreeCAD.Vector(*JOB["place"])))[0])
