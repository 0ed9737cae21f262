# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a user waits from one click to a mesh and its quality in colour.

    /usr/bin/python3 benchmarks/window/first_mesh.py [part.stp ...]
FreeCAD opens each part, by default those of about 50 faces that come with it, in its window on a virtual screen; the
solid is selected and the command Quick mesh is run once. Printed are the seconds until progress is seen first, until
the mesh is in the document, and until its colours are drawn. Nothing was used before in that FreeCAD.
"""

import sys
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
from in_window import text_of

FOLDER = "/usr/share/freecad/Mod/Idf/Idflibs/"
PARTS = ["2225_SMD.stp", "CAP_50SGV_8_10.stp", "SOT428_DPAK.stp"]


def main():
    parts = sys.argv[1:] or [FOLDER + part for part in PARTS]
    head = "| part | faces | progress is seen | mesh | triangles | certificate | colours |"
    print(head, "|---|---|---|---|---|---|---|", sep="\n")
    for part in parts:
        print(text_of("first_mesh_gui.py", MESHQUALITY_PART=part), end="")


if __name__ == "__main__":
    main()
