#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our triangulation beside Gmsh, Netgen and BRepMesh: same parts, same distance, same run.

    /usr/bin/python3 benchmarks/triangulate/quality_peers.py [-n 3] [--judge PROGRAM] [--model FILE] [--level 1e-3]
    /usr/bin/python3 benchmarks/triangulate/quality_peers.py --growth [--model FILE] [--most 1e7]

A level is a distance as a fraction of L, the part's largest dimension. We and BRepMesh (FreeCAD's
Shape.tessellate) are asked for it; Gmsh (sizes from curvature, algorithms 5 and 6) and Netgen
(nglib) get the coarsest setting on a grid with steps of sqrt(2) with which the mesh is measured to
keep it. Settings found are kept in the folder of --out, for the next run.

Seconds are the processor's, user and system, of the meshing call alone: the median of -n runs that
every mesher has in turn. `slack off` is triangles x distance / target, as counts go like 1 /
distance. With --judge, a program that reads MESH SHAPE --json, distances are two-sided and `forced`
leaves out what the part's own corners force; without it, distances are ours (mq.quality: corners,
edge middles and centroids of triangles) and `forced` is what our report exempts. Peers that are
not installed are skipped: Gmsh needs Debian's python3-gmsh, Netgen libnglib-dev and a build with
-DMESHQUALITY_BENCHMARKS=ON.

--growth meshes one part by itself with smaller and smaller chord heights and prints microseconds
and bytes of memory per triangle, those of the peak above what FreeCAD had before. Those of stages
are of the clock: give MESHQUALITY_THREADS=1 on an idle machine.
"""

import json
import math
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
from setting_search import coarsest

HERE = Path(__file__).resolve().parent
MODELS = ("netgen_screw.step", "gmsh_t20_data.step", "linkrods.step")
INSTALLED = "/usr/share/freecad/Mod/Idf/Idflibs/SOT428_DPAK.stp"
FIRST, LAST = 0, 14  # of the grid of settings
SAMPLES = "20000"  # of the surface, for the judge
GROWTH = 4.0  # chord heights go down by this factor
STAGES = ("chord height", "taking out vertices", "crossings", "checking")  # that large meshes take time in


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("-n", "--runs", type=int, default=3, help="of every mesher, in turn")
    result.add_argument("--model", action="append", help="CAD file; may be given more than once")
    result.add_argument("--level", action="append", type=float, help="1e-3 and 1e-4 unless given")
    result.add_argument("--angle", type=float, default=25.0, help="ours, degrees")
    result.add_argument("--judge", help="program that judges a mesh: MESH SHAPE --json")
    result.add_argument("--data", default=str(inside_freecad.data_folder()))
    result.add_argument("--python", default="/usr/bin/python3", help="that has the module gmsh")
    result.add_argument("--netgen", help="the program quality_netgen",
                        default=str(inside_freecad.ROOT / "build" / "benchmarks" / "quality_netgen"))
    result.add_argument("--limit", type=float, default=120.0, help="seconds a run of a peer")
    result.add_argument("--growth", action="store_true", help="our time and memory against size")
    result.add_argument("--most", type=float, default=3e6, help="triangles, with --growth")
    return result


class Model:
    """A CAD file: its shape, as a file for programs too, and its largest dimension."""

    def __init__(self, path, folder, judge):
        import Part

        self.name, self.judge = Path(path).stem, judge
        self.shape = Part.Shape()
        self.shape.read(str(path))
        self.brep = folder / f"{self.name}.brep"
        self.shape.exportBrep(str(self.brep))
        self.size = self._judged_size() if judge else self._size()

    def _judged_size(self):
        return json.loads(run([self.judge, "--info", str(self.brep), "--json"], 600.0))["brep_L"]

    def _size(self):
        """The boxes of splines are too large: that of a triangulation is not."""
        import numpy as np

        points = np.array(self.shape.copy().tessellate(1e-3 * self.shape.BoundBox.DiagonalLength)[0])
        return float(np.ptp(points, axis=0).max())

    def measured(self, off, *flags):
        """Distance in mm, smallest angle and that without what is forced, and faults.

        The judge also gets the flags.
        """
        if self.judge:
            return self._judged(off, flags)
        import boolean_peers
        import MeshQuality as mq

        report = mq.quality(boolean_peers.read_off(off), self.shape)
        faults = [f"not {name}" for name in ("closed", "manifold", "oriented")
                  if not getattr(report, name)]
        return {"distance": report.max_chord_height, "angle": report.min_angle, "forced": None,
                "faults": faults}

    def _judged(self, off, flags):
        found = json.loads(run([self.judge, str(off), str(self.brep), "--json",
                                "--samples", SAMPLES, *flags], 600.0))
        faults = [f"not {name}" for name in ("closed", "manifold", "oriented") if not found[name]]
        faults += [f"{found[name]} {text}" for name, text in
                   (("self_intersections", "crossings"), ("faces_over_2pct", "faces lost"))
                   if found.get(name)]
        return {"distance": found["hausdorff_L"] * self.size, "angle": found["min_angle"],
                "forced": found["min_angle_unexcused"], "faults": faults}


def run(command, limit):
    """What a program prints; raises subprocess.SubprocessError."""
    return subprocess.run(command, capture_output=True, text=True, timeout=limit, check=True,
                          stdin=subprocess.DEVNULL,
                          env={**inside_freecad.system_environment(), "OMP_NUM_THREADS": "1"}).stdout


class Ours:
    name, grid = "MeshQuality", None

    def __init__(self, arguments):
        self.angle = arguments.angle
        self.forced = None

    def mesh(self, part, target, off):
        """Seconds of the call; the mesh is written to `off`. A copy holds nothing of other runs."""
        import MeshQuality as mq

        shape = part.shape.copy()
        start = time.process_time()
        mesh = mq.triangulate(shape, min_angle=self.angle, chord_height=target)
        seconds = time.process_time() - start
        mesh.write(off)
        self.forced = mesh.report.min_angle_unexempted
        return seconds


class BRepMesh:
    name, grid = "BRepMesh", None

    def __init__(self, _arguments):
        pass

    def mesh(self, part, target, off):
        import boolean_peers
        import numpy as np

        shape = part.shape.copy()
        start = time.process_time()
        points, triangles = shape.tessellate(target)
        seconds = time.process_time() - start
        boolean_peers.write_off(off, np.array(points), np.array(triangles))
        return seconds


class Program:
    """A peer that is a program of its own, with a setting for sizes instead of a distance."""

    def __init__(self, name, command, after, least, limit):
        self.name, self.command, self.after, self.limit = name, command, after, limit
        self.grid = [round(least * math.sqrt(2.0) ** k, 2) for k in range(FIRST, LAST)]

    def mesh(self, part, setting, off):
        said = run([*self.command, str(part.brep), str(off), *self.after, str(setting)], self.limit)
        return json.loads(said.strip().splitlines()[-1])["seconds"]


def gmsh(arguments):
    try:
        run([arguments.python, "-c", "import gmsh"], 60.0)
    except (OSError, subprocess.SubprocessError):
        print(f"Gmsh is skipped: {arguments.python} has no module gmsh (package python3-gmsh)")
        return []
    return [Program(f"Gmsh {algorithm}", [arguments.python, str(HERE / "quality_gmsh.py")],
                    [str(algorithm)], 10.0, arguments.limit) for algorithm in (5, 6)]


def netgen(arguments):
    if not Path(arguments.netgen).exists():
        print(f"Netgen is skipped: there is no {arguments.netgen}; build it with "
              "-DMESHQUALITY_BENCHMARKS=ON (package libnglib-dev)")
        return []
    return [Program("Netgen", [arguments.netgen], [], 2.0, arguments.limit)]


class Settings:
    """The settings found in this and former runs, by part, peer and level."""

    def __init__(self, path):
        self.path = path
        self.known = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}

    def of(self, part, peer, target, scratch):
        """The coarsest setting that keeps the distance, or None."""
        judge = "judged" if part.judge else "measured"
        key = f"{part.name}, {len(part.shape.Faces)} faces, {peer.name}, {target:.6g} mm, {judge}"
        if key not in self.known:
            self.known[key] = coarsest(peer.grid, lambda setting: distance_with(
                part, peer, setting, scratch), target)
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self.path.write_text(json.dumps(self.known, indent=1), encoding="utf-8")
        return self.known[key]


def distance_with(part, peer, setting, scratch):
    off = scratch / "search.off"
    try:
        peer.mesh(part, setting, off)
        return part.measured(off, "--no-si")["distance"]
    except (subprocess.SubprocessError, ValueError, IndexError):
        return None


def compare(part, level, peers, settings, scratch, runs):
    """One row a mesher, with medians of the seconds."""
    target = level * part.size
    asked = {peer: settings.of(part, peer, target, scratch) if peer.grid else target
             for peer in peers}
    seconds = {peer: [] for peer in peers}
    for _ in range(runs):
        for peer in peers:
            if asked[peer] is not None:
                seconds[peer].append(peer.mesh(part, asked[peer], off_of(peer, scratch)))
    rows = [row_of(part, peer, asked[peer], seconds[peer], target, scratch) for peer in peers]
    base = next((row["rate"] for row in rows if row["mesher"] == "Gmsh 5" and "rate" in row), None)
    for row in rows:
        if base and "rate" in row:
            row["times"] = row["rate"] / base
    return [{"model": part.name, "level": level, **row} for row in rows]


def off_of(peer, scratch):
    return scratch / f"{peer.name.replace(' ', '_')}.off"


def row_of(part, peer, asked, seconds, target, scratch):
    row = {"mesher": peer.name, "asked": asked, "runs": seconds}
    if not seconds:
        return {**row, "faults": ["no setting of the grid reaches it"]}
    off = off_of(peer, scratch)
    row.update(part.measured(off))
    if isinstance(peer, Ours) and not part.judge:
        row["forced"] = peer.forced
    with open(off, encoding="ascii") as stream:
        stream.readline()
        row["triangles"] = int(stream.readline().split()[1])
    row["seconds"] = statistics.median(seconds)
    row["distance"] /= target
    row["slack_off"] = row["triangles"] * row["distance"]
    row["rate"] = row["triangles"] / row["seconds"] / 1000.0
    return row


HEAD = ("| part | target / L | mesher | triangles | distance / target | slack off | angle "
        "| forced left out | CPU s | ktri/s | x Gmsh 5 | faults |\n"
        "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---|")


def line(row):
    def one(key, pattern):
        return format(row[key], pattern) if row.get(key) is not None else "-"

    cells = [row["model"], f"{row['level']:.0e}", row["mesher"], one("triangles", "d"),
             one("distance", ".2f"), one("slack_off", ".0f"), one("angle", ".1f"),
             one("forced", ".1f"), one("seconds", ".3f"), one("rate", ".1f"), one("times", ".2f"),
             "; ".join(row["faults"])]
    return f"| {' | '.join(cells)} |"


def models(arguments):
    if arguments.model:
        return [str(Path(path).resolve()) for path in arguments.model]
    found = [str(Path(arguments.data) / "cad" / name) for name in MODELS]
    found = [path for path in found if Path(path).exists()]
    if len(found) < len(MODELS):
        print(f"{len(MODELS) - len(found)} parts are skipped: not in {arguments.data}/cad")
    return found or [INSTALLED]


def comparison(arguments):
    peers = [Ours(arguments), *gmsh(arguments), *netgen(arguments), BRepMesh(arguments)]
    settings = Settings(Path(arguments.out).with_name("quality_peers_settings.json"))
    print(HEAD)
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        for path in models(arguments):
            part = Model(path, Path(scratch), arguments.judge)
            for level in arguments.level or (1e-3, 1e-4):
                found = compare(part, level, peers, settings, Path(scratch), arguments.runs)
                print("\n".join(map(line, found)), flush=True)
                rows += found
    return {"runs": arguments.runs, "judged": bool(arguments.judge), "rows": rows}


def memory(key):
    """Of this process in bytes; VmRSS is that of now, VmHWM the peak."""
    lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    return 1024 * next(int(text.split()[1]) for text in lines if text.startswith(key + ":"))


def forget_peak():
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")


def growth(arguments):
    import MeshQuality as mq

    path = models(arguments)[0]
    rows, chord = [], 0.02
    with tempfile.TemporaryDirectory() as scratch:
        part = Model(path, Path(scratch), arguments.judge)
    before = memory("VmRSS")
    print(f"{part.name}\n| chord height / L | triangles | CPU s | us per triangle | {' | '.join(STAGES)} "
          f"| bytes per triangle |\n|---|{'---:|' * (len(STAGES) + 4)}")
    while not rows or rows[-1]["triangles"] * GROWTH ** 0.5 < arguments.most:
        mesh = None  # the one before is not to count
        forget_peak()
        shape = part.shape.copy()
        start = time.process_time()
        mesh = mq.triangulate(shape, min_angle=arguments.angle, chord_height=chord * part.size,
                              max_triangles=int(GROWTH * arguments.most))
        seconds = time.process_time() - start
        count = len(mesh.triangles)
        rows.append({"chord": chord, "triangles": count, "seconds": seconds,
                     "stages": dict(mesh.report.seconds), "bytes": (memory("VmHWM") - before) / count})
        stages = [f"{1e6 * rows[-1]['stages'].get(name, 0.0) / count:.2f}" for name in STAGES]
        print(f"| {chord:.2e} | {count} | {seconds:.3f} | {1e6 * seconds / count:.1f} "
              f"| {' | '.join(stages)} | {rows[-1]['bytes']:.0f} |", flush=True)
        chord /= GROWTH
    return {"model": part.name, "rows": rows}


def work(arguments):
    return growth(arguments) if arguments.growth else comparison(arguments)


inside_freecad.start(__file__, parser(), work)
