#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What more threads give: the wall time of triangulate or curve by stage, and whether the bytes are the same.

    /usr/bin/python3 benchmarks/cores.py [--threads 1 --threads 2] [--rounds 5] [--only PATTERN]
                                         [--of triangulate|surface|volume] [--order 2] [--simulate 2,8,16,32]

--of surface and volume curve the triangles, or fill the solids with curved tetrahedra, in place of
triangulate. The numbers of threads take turns in every round, after one round that does not count;
medians of the rounds are compared. Parts are those of $MESHQUALITY_DATA/cad; "corpus" are all of them,
one after the other. The status is 1 where bytes differ.

--simulate tells for numbers of cores that this machine need not have how much faster they are than
one: the work is divided as for that number of threads, but done in one, which records the processor
time of every piece; the pieces are then given to the threads of each section in their order (see
schedule.py), by a build with the CMake option MESHQUALITY_SCHEDULE_TRACE. Starting threads costs what it does here. Without --of, parts are those of SIMULATED.
Not simulated: caches and memory that cores share, and waiting for a turn of the engine's thread.
"""

import fnmatch
import hashlib
import statistics
import sys
import time
from collections import Counter
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parent.iterdir())
import inside_freecad
import schedule

# By what is done: file -> chord heights as fractions of the largest dimension.
CASES = {"triangulate": {
    "gmsh_t20_data.step": (1e-4, 2e-5),
    "netgen_screw.step": (1e-4, 2e-5),
    "linkrods.step": (1e-3, 1e-4),
    "as1-oc-214.stp": (1e-3, 1e-4),
    "nist_ctc_05_asme1_rd.stp": (1e-3, 1e-4),
}, "surface": {
    "gmsh_t20_data.step": (1e-3, 3e-5),
    "netgen_screw.step": (1e-4,),
    "as1-oc-214.stp": (1e-3,),
}, "volume": {
    "gmsh_t20_data.step": (1e-3,),
    "netgen_screw.step": (3e-4,),
    "as1-oc-214.stp": (1e-3,),
    "nist_ctc_05_asme1_rd.stp": (1e-3,),
}}

SIMULATED = {
    "gmsh_t20_data.step": (2e-5,),
    "nist_ctc_05_asme1_rd.stp": (1e-3,),
    "as1-oc-214.stp": (1e-4,),
    "corpus": (1e-3,),
}

# Seconds that starting and ending threads takes here, by their number: measured when needed.
STARTS = {}


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--threads", type=int, action="append", help="1 and 2 where none is given")
    result.add_argument("--rounds", type=int, default=5)
    result.add_argument("--of", choices=tuple(CASES))
    result.add_argument("--order", type=int, default=2, help="of curved elements")
    result.add_argument("--only", default="*", metavar="PATTERN", help="names of files")
    result.add_argument("--simulate", type=lambda text: [int(number) for number in text.split(",")], default=[],
                        metavar="NUMBER,...", help="of cores")
    return result


def measured(shape, relative, threads, arguments):
    """Seconds of one call, and a digest of its arrays."""
    import MeshQuality as mq

    start = time.perf_counter()
    if arguments.of in (None, "triangulate"):
        mesh = mq.triangulate(shape, chord_height_relative=relative, threads=threads)
        arrays = (mesh.vertices, mesh.triangles, mesh.triangle_face, mesh.vertex_entity)
    else:
        mesh = mq.curve(shape, arguments.order, arguments.of == "volume", chord_height_relative=relative,
                        threads=threads)
        arrays = (mesh.nodes, mesh.elements, mesh.triangles, mesh.node_entity, mesh.triangle_quality,
                  mesh.tetrahedron_quality)
    wall = time.perf_counter() - start
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(array.tobytes())
    return {"wall": wall, "cpu": mesh.report.cpu_seconds, "stages": Counter(dict(mesh.report.seconds)),
            "elements": len(arrays[1]), "digest": digest.hexdigest()}


def measured_in_turn(shapes, relative, threads, arguments, call=measured):
    """The sums of several parts; those that cannot be meshed are left out."""
    import MeshQuality as mq

    sums = None
    for shape in shapes:
        try:
            run = call(shape, relative, threads, arguments)
        except mq.Error:
            continue
        sums = run if sums is None else {name: sums[name] + run[name] for name in sums}
    return sums


def recorded(shape, relative, threads, arguments):
    """What a replay of one call gives: seconds of its stages on one and on so many threads."""
    from MeshQuality import _core

    if not hasattr(_core, "start_recording"):
        raise RuntimeError("--simulate needs a build with the CMake option MESHQUALITY_SCHEDULE_TRACE")
    _core.start_recording()
    try:
        run = measured(shape, relative, threads, arguments)
    finally:
        record = _core.stop_recording()
    for number in schedule.numbers_of_threads(record):
        if number not in STARTS:
            STARTS[number] = _core.seconds_of_empty_section(number)
    one, several = Counter(), Counter()
    for name, (on_one, on_several) in schedule.stage_seconds(record, STARTS).items():
        one[name], several[name] = on_one, on_several
    return {"one": one, "several": several, "sections": len(record["sections"]), "tasks": len(record["tasks"]),
            "digest": run["digest"]}


def median_of(runs):
    """The medians of several runs."""
    stages = {name: statistics.median(run["stages"].get(name, 0.0) for run in runs) for name in runs[0]["stages"]}
    return {"wall": statistics.median(run["wall"] for run in runs), "cpu": statistics.median(run["cpu"] for run in runs),
            "stages": stages}


def shapes_of(name):
    """The shape of a file, or of all files."""
    import Part

    folder = inside_freecad.data_folder() / "cad"
    paths = [folder / name]
    if name == "corpus":
        paths = sorted(path for path in folder.iterdir() if path.suffix.lower() in inside_freecad.CAD_SUFFIXES)
    shapes = []
    for path in paths:
        shapes.append(Part.Shape())
        shapes[-1].read(str(path))
    return shapes


def case(name, relative, numbers, arguments):
    """Medians of one part by number of threads, and replays by number of cores."""
    shapes = shapes_of(name)
    runs = {threads: [] for threads in numbers}
    for _ in range(arguments.rounds + 1):
        for threads in numbers:
            runs[threads].append(measured_in_turn(shapes, relative, threads, arguments))
    every = [run for of_number in runs.values() for run in of_number]
    replays = {cores: measured_in_turn(shapes, relative, cores, arguments, recorded) for cores in arguments.simulate}
    return {"part": name, "faces": sum(len(shape.Faces) for shape in shapes), "relative": relative,
            "elements": every[0]["elements"],
            "same_bytes": len({run["digest"] for run in every + list(replays.values())}) == 1,
            "threads": {threads: median_of(of_number[1:]) for threads, of_number in runs.items()},
            "simulated": replays}


def show(result):
    first, *others = result["threads"]
    one = result["threads"][first]
    print(f"\n{result['part']} at {result['relative']:g} L: {result['faces']} faces, {result['elements']} elements, "
          f"bytes {'the same' if result['same_bytes'] else 'DIFFER'}; {first}: {one['wall']:.3f} s")
    for threads in others:
        several = result["threads"][threads]
        print(f"    {threads}: {several['wall']:.3f} s, share {several['wall'] / one['wall']:.2f}, "
              f"CPU {several['cpu'] / one['cpu']:.2f}; " +
              ", ".join(f"{name} {one['stages'][name]:.3f} -> {seconds:.3f}"
                        for name, seconds in several["stages"].items() if one["stages"].get(name, 0.0) > 0.005),
              flush=True)
    for cores, replay in result["simulated"].items():
        before, after = sum(replay["one"].values()), sum(replay["several"].values())
        print(f"    {cores} simulated: share {after / before:.3f}, {before / after:.2f} times; {replay['sections']} sections, "
              f"{replay['tasks']} tasks, {before:.3f} -> {after:.3f} CPU s; " +
              ", ".join(f"{name or 'the rest'} {seconds:.3f} -> {replay['several'][name]:.3f}"
                        for name, seconds in replay["one"].items() if seconds > 0.005), flush=True)


def work(arguments):
    numbers = arguments.threads or [1, 2]
    cases = SIMULATED if arguments.simulate and arguments.of is None else CASES[arguments.of or "triangulate"]
    results = []
    for name, heights in cases.items():
        for relative in heights if fnmatch.fnmatch(name, arguments.only) else ():
            results.append(case(name, relative, numbers, arguments))
            show(results[-1])
    if STARTS:
        print("\nstarting and ending threads, microseconds: " +
              ", ".join(f"{threads}: {1e6 * seconds:.0f}" for threads, seconds in sorted(STARTS.items())))
    return {"cases": results, "starts": STARTS, "status": 0 if all(result["same_bytes"] for result in results) else 1}


inside_freecad.start(__file__, parser(), work)
