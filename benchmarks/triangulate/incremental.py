# SPDX-License-Identifier: LGPL-2.1-or-later
"""A parametric part of 156 faces, a plate with a hundred holes, whose quality mesh follows each edit:
CPU seconds of the mesh object's recompute from nothing (Reuse off) and with what it remembers.

    freecadcmd -P <root>/Mod benchmarks/triangulate/incremental.py </dev/null
"""

import time

PITCH, ALONG = 10.0, 10
FIRST, EDITED = 2.0, 2.5  # radius of one hole, mm


def plate(document):
    """(the cut, the cylinder that is edited) as parametric objects."""
    from FreeCAD import Placement, Rotation, Vector  # noqa: PLC0415  only FreeCAD has it

    block = document.addObject("Part::Box", "Block")
    block.Length = block.Width = PITCH * ALONG
    holes = []
    for i in range(ALONG):
        for j in range(ALONG):
            hole = document.addObject("Part::Cylinder", "Hole")
            hole.Radius = FIRST if i == j == 0 else 2.0 + 0.1 * ((i + 3 * j) % 7)
            hole.Height = 12.0 if (i + j) % 2 else 6.0
            hole.Placement = Placement(Vector(PITCH * (i + 0.5), PITCH * (j + 0.5), -1.0), Rotation())
            holes.append(hole)
    tools = document.addObject("Part::Compound", "Holes")
    tools.Links = holes
    cut = document.addObject("Part::Cut", "Plate")
    cut.Base, cut.Tool = block, tools
    document.recompute()
    return cut, holes[0]


def seconds(document, source, change):
    """CPU seconds that the meshes of `source` take after a change."""
    change()
    document.recompute([source])
    for mesh in source.InList:
        mesh.touch()
    begun = time.process_time()
    document.recompute()
    return time.process_time() - begun


def measure(chord, reuse):
    """CPU seconds of each step, and the mesh object after the first edit."""
    import FreeCAD  # noqa: PLC0415

    import MeshQuality as mq  # noqa: PLC0415

    document = FreeCAD.newDocument()
    source, hole = plate(document)
    mesh = mq.add_quality_mesh(source, chord_height=chord)
    mesh.Reuse = reuse
    document.recompute()

    def place():
        source.Placement.Base.x = 7.0
        source.Placement = source.Placement

    steps = {
        "edit": lambda: setattr(hole, "Radius", EDITED),
        "back": lambda: setattr(hole, "Radius", FIRST),
        "move": place,
    }
    found = {}
    for name, change in steps.items():
        cpu = seconds(document, source, change)
        found[name] = cpu, mesh.ReusedFaces, mesh.Triangles
    faces = len(source.Shape.Faces)
    FreeCAD.closeDocument(document.Name)
    return found, faces


def main():
    print("chord mm  step   triangles      again      CPU s      again  faces kept")
    for chord in (0.1, 0.05, 0.02):
        nothing, faces = measure(chord, False)
        again, _ = measure(chord, True)
        for step in nothing:
            print(f"{chord:8g}  {step:5} {nothing[step][2]:10d} {again[step][2]:10d} "
                  f"{nothing[step][0]:10.2f} {again[step][0]:10.2f} {again[step][1]:6d} of {faces}", flush=True)


main()
