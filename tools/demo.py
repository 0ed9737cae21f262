# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demo of the README, run inside FreeCAD by tools/demo: two parts, their meshes, a picture."""

import os
import sys
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests")]

import FreeCAD  # noqa: E402
import Import  # noqa: E402
import MeshPart  # noqa: E402
import numpy as np  # noqa: E402
import parts  # noqa: E402
import picture  # noqa: E402

import MeshQuality as mq  # noqa: E402

OUT = Path(os.environ.get("MESHQUALITY_OUT", ROOT / "out"))
STEP_PART = "Idf/Idflibs/SOT428_DPAK.stp"
OPTIONS = {"min_angle": 25.0, "chord_height_relative": 0.001}


def installed_step_part():
    """A transistor housing of FreeCAD's own library of electronic parts."""
    roots = [FreeCAD.getResourceDir(), FreeCAD.getHomePath()]
    for root in roots:
        path = Path(root) / "Mod" / STEP_PART
        if path.exists():
            return path
    raise FileNotFoundError(f"this FreeCAD does not install Mod/{STEP_PART} under {roots}")


def make_sources(document):
    """The document objects to mesh: one read from STEP, one modelled here."""
    before = set(document.Objects)
    Import.insert(str(installed_step_part()), document.Name)
    document.recompute()
    read = [o for o in document.Objects if o not in before and hasattr(o, "Shape")]
    largest = max(read, key=lambda o: len(o.Shape.Faces))
    largest.Label = "DPAK"
    bracket = document.addObject("Part::Feature", "Bracket")
    bracket.Shape = parts.bracket()
    return [largest, bracket]


def standard_tessellation(shape):
    """What FreeCAD makes of the shape with the same chord height, as a mesh of the picture."""
    box = shape.BoundBox
    deflection = OPTIONS["chord_height_relative"] * max(box.XLength, box.YLength, box.ZLength)
    mesh = MeshPart.meshFromShape(
        Shape=shape.copy(), LinearDeflection=deflection, AngularDeflection=0.5,
        Relative=False, Segments=True,
    )
    points, triangles = mesh.Topology
    faces = np.zeros(len(triangles), dtype=int)
    for i in range(mesh.countSegments()):
        faces[list(mesh.getSegment(i))] = i
    measured = mq.quality(mesh, shape)
    return picture.Mesh(np.array([tuple(p) for p in points]), np.array(triangles), faces,
                        measured.max_chord_height)


def mesh_part(source):
    """Meshes one document object, stores feature and PLY file; returns its row of the picture."""
    mesh = mq.triangulate(source, **OPTIONS)
    feature = mq.add_quality_mesh(source, **OPTIONS)
    if feature.Mesh.CountFacets != len(mesh.triangles):
        raise RuntimeError(f"{source.Label}: the document's mesh differs from the scripted one")
    mesh.write(str(OUT / f"{source.Label.lower()}.ply"))
    print(f"\n{source.Label}: {len(source.Shape.Faces)} CAD faces\n{mesh.report}")
    # The two are measured by the same ruler.
    after = picture.Mesh(mesh.vertices, mesh.triangles, mesh.triangle_face,
                         mq.quality(mesh, source.Shape).max_chord_height)
    return picture.Row(source.Label, standard_tessellation(source.Shape), after)


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    document = FreeCAD.newDocument("MeshQualityDemo")
    rows = [mesh_part(source) for source in make_sources(document)]
    document.recompute()
    stored, drawn = OUT / "demo.FCStd", OUT / "demo.png"
    stored.unlink(missing_ok=True)  # or FreeCAD keeps the old one as a backup
    document.saveAs(str(stored))
    picture.save(rows, drawn, OPTIONS["min_angle"])
    print("\nwritten:")
    for path in [stored, *sorted(OUT.glob("*.ply")), drawn]:
        print(f"  {path.relative_to(OUT.parent)}  {path.stat().st_size / 1024:.0f} KiB")


try:
    main()
except Exception:
    traceback.print_exc()
    sys.exit(1)
sys.stdout.flush()  # FreeCAD 1.0 ends without writing what Python still holds back
sys.exit(0)
