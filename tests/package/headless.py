# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes a part that FreeCAD itself installs, in a headless FreeCAD that has the addon installed."""

import os
import sys
import traceback

import FreeCAD
import Part

PART = "/usr/share/freecad/Mod/Idf/Idflibs/SOT428_DPAK.stp"


def main():
    import MeshQuality as mq

    shape = Part.read(PART)
    mesh = mq.triangulate(shape, min_angle=25, chord_height_relative=0.001)
    report = mesh.report
    print(f"{len(shape.Faces)} faces, {len(mesh.triangles)} triangles, {os.path.dirname(mq.__file__)}")
    assert report.closed and report.oriented and not report.self_intersections
    assert report.min_angle_unexempted >= 25
    document = FreeCAD.newDocument("Installed")
    source = document.addObject("Part::Feature", "Source")
    source.Shape = shape
    feature = mq.add_quality_mesh(source, min_angle=25, chord_height_relative=0.001)
    assert feature.Mesh.CountFacets == len(mesh.triangles)
    document.saveAs(os.path.abspath("installed.FCStd"))


try:
    main()
except Exception:
    traceback.print_exc()
    sys.exit(1)
sys.stdout.flush()  # FreeCAD 1.0 ends without writing what Python still holds back
sys.exit(0)
