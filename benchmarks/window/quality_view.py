# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a frame of the quality view takes, against FreeCAD's own view of the same mesh.

    /usr/bin/python3 benchmarks/window/quality_view.py [triangles ...]
FreeCAD draws a torus of so many triangles on a virtual screen by the processor alone, turned a little from frame to
frame; printed are medians of 9 frames: FreeCAD's own view, the quality view with all triangles, as it stands still,
and as it moves, with the coarse triangles that stand for them where drawing takes long. Without numbers: 100000,
1000000 and 2000000.
"""

import sys
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
from in_window import text_of


def main():
    triangles = sys.argv[1:] or ["100000", "1000000", "2000000"]
    print(text_of("quality_view_gui.py", MESHQUALITY_VIEW_TRIANGLES=" ".join(triangles)))


if __name__ == "__main__":
    main()
