# SPDX-License-Identifier: LGPL-2.1-or-later
"""What MeshQuality costs a FreeCAD that starts, and what its own OpenCASCADE costs in memory.

    /usr/bin/python3 benchmarks/window/start_up.py [WHEEL]

Printed are the least seconds of the processor, and the middle of the memory, of some starts: what FreeCAD executes of the addon
when its window starts, whether NumPy or the binary were loaded then, the first use of the workbench, and the imports and the
memory of a headless FreeCAD before and after them and after a first mesh. With a wheel the same is done with the committed tree
and the wheel.
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
STARTS = 5
REGISTER = """
import json, os, sys, time
import FreeCAD, FreeCADGui
from PySide import QtCore
tree = os.environ["MESHQUALITY_TREE"]
sys.path.append(tree)

def timed(work):
    begin = time.process_time()
    work()
    return time.process_time() - begin

def execute(name):
    with open(os.path.join(tree, name), encoding="utf-8") as stream:
        exec(stream.read(), {"FreeCAD": FreeCAD, "FreeCADGui": FreeCADGui, "Workbench": FreeCADGui.Workbench})

def main():
    said = {"registration": timed(lambda: (execute("Init.py"), execute("InitGui.py")))}
    said["loaded then"] = " ".join(name for name in ("numpy", "MeshQuality._core") if name in sys.modules) or "neither NumPy nor the binary"
    said["first use of the workbench"] = timed(lambda: FreeCADGui.activateWorkbench("MeshQualityWorkbench"))
    with open(os.environ["MESHQUALITY_RESULT"], "w", encoding="utf-8") as stream:
        json.dump(said, stream)
    FreeCADGui.getMainWindow().close()

QtCore.QTimer.singleShot(300, main)
"""
IMPORT = """
import json, sys, time
import FreeCAD, Part, Mesh, numpy

def memory():
    with open("/proc/self/status", encoding="ascii") as stream:
        return next(int(line.split()[1]) / 1024 for line in stream if line.startswith("VmRSS:"))

said = {"MB before": memory()}
begin = time.process_time()
import MeshQuality as mq
said["import MeshQuality"] = time.process_time() - begin
from MeshQuality import compat
begin = time.process_time()
compat.extension()
said["import of the binary"] = time.process_time() - begin
said["MB after the imports"] = memory()
from MeshQuality.gui import example
begin = time.process_time()
mesh = mq.triangulate(example.tee())
said["first mesh"] = time.process_time() - begin
said["MB after a mesh"] = memory()
said["bridge"], said["triangles"] = mesh.report.bridge, len(mesh.triangles)
print("said=" + json.dumps(said), flush=True)
sys.exit(0)
"""


def headless(tree, home):
    script = Path(home, "import.py")
    script.write_text(IMPORT, encoding="utf-8")
    told = subprocess.run(["freecadcmd", "-P", str(Path(tree, "Mod")), str(script)], env={**os.environ, "FREECAD_USER_HOME": str(home)},
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False).stdout
    return json.loads(told.partition("said=")[2])


def window(script, home):
    result = Path(home, "result.json")
    subprocess.run(["xvfb-run", "-a", "freecad", str(script)], check=False, stdin=subprocess.DEVNULL, capture_output=True,
                   env={**os.environ, "FREECAD_USER_HOME": str(home), "LIBGL_ALWAYS_SOFTWARE": "1", "QTWEBENGINE_DISABLE_SANDBOX": "1",
                        "MESHQUALITY_TREE": str(ROOT), "MESHQUALITY_RESULT": str(result)})
    return json.loads(result.read_text(encoding="utf-8"))


def middle(starts):
    """The least of each time, the middle of each memory, and what all starts have alike."""
    def of(name, values):
        if not isinstance(values[0], float):
            return values[0]
        return round(statistics.median(values)) if name.startswith("MB") else round(min(values), 3)

    return {name: of(name, [start[name] for start in starts]) for name in starts[0]}


def table(title, starts):
    print(f"| {title} | |\n|---|---:|")
    for name, value in middle(starts).items():
        print(f"| {name} | {value} |")
    print()


def main():
    with tempfile.TemporaryDirectory() as home:
        script = Path(home, "register.py")
        script.write_text(REGISTER, encoding="utf-8")
        table("window", [window(script, home) for _ in range(STARTS)])
        table("headless, binary beside the sources", [headless(ROOT, home) for _ in range(STARTS)])
    for wheel in sys.argv[1:]:
        with tempfile.TemporaryDirectory() as home:
            tree = Path(home, "tree")
            tree.mkdir()
            subprocess.run(f"git archive HEAD Mod | tar -x -C '{tree}'", shell=True, check=True, cwd=ROOT)
            zipfile.ZipFile(wheel).extractall(Path(home, "AdditionalPythonPackages"))
            table("headless, binary of the wheel", [headless(tree, home) for _ in range(STARTS)])


if __name__ == "__main__":
    main()
