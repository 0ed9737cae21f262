#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What more threads give: the wall time of triangulate or curve by stage, and whether the bytes are the same.

    /usr/bin/python3 benchmarks/cores.py [--threads 1 --threads 2] [--rounds 5] [--only PATTERN]
                                         [--of triangulate|surface|volume] [--order 2]

--of surface and volume curve the triangles, or fill the solids with curved tetrahedra, in place of
triangulate. The numbers of threads take turns in every round, after one round that does not count;
medians of the rounds are compared. Parts are those of $MESHQUALITY_DATA/cad. The status is 1 where
bytes differ.
"""

import fnmatch
import hashlib
import statistics
import time

import inside_freecad

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


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--threads", type=int, action="append", help="1 and 2 where none is given")
    result.add_argument("--rounds", type=int, default=5)
    result.add_argument("--of", default="triangulate", choices=tuple(CASES))
    result.add_argument("--order", type=int, default=2, help="of curved elements")
    result.add_argument("--only", default="*", metavar="PATTERN", help="names of files")
    return result


def measured(shape, relative, threads, arguments):
    """Seconds of one call, and a digest of its arrays."""
    import MeshQuality as mq

    start = time.perf_counter()
    if arguments.of == "triangulate":
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
    return {"wall": wall, "cpu": mesh.report.cpu_seconds, "stages": dict(mesh.report.seconds),
            "elements": len(arrays[1]), "digest": digest.hexdigest()}


def median_of(runs):
    """The medians of several runs."""
    stages = {name: statistics.median(run["stages"].get(name, 0.0) for run in runs) for name in runs[0]["stages"]}
    return {"wall": statistics.median(run["wall"] for run in runs), "cpu": statistics.median(run["cpu"] for run in runs),
            "stages": stages}


def case(path, relative, numbers, arguments):
    """Medians of one part by number of threads."""
    import Part

    shape = Part.Shape()
    shape.read(str(path))
    runs = {threads: [] for threads in numbers}
    for _ in range(arguments.rounds + 1):
        for threads in numbers:
            runs[threads].append(measured(shape, relative, threads, arguments))
    every = [run for of_number in runs.values() for run in of_number]
    return {"part": path.name, "faces": len(shape.Faces), "relative": relative, "elements": every[0]["elements"],
            "same_bytes": len({run["digest"] for run in every}) == 1,
            "threads": {threads: median_of(of_number[1:]) for threads, of_number in runs.items()}}


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


def work(arguments):
    numbers = arguments.threads or [1, 2]
    results = []
    for name, heights in CASES[arguments.of].items():
        for relative in heights if fnmatch.fnmatch(name, arguments.only) else ():
            results.append(case(inside_freecad.data_folder() / "cad" / name, relative, numbers, arguments))
            show(results[-1])
    return {"cases": results, "status": 0 if all(result["same_bytes"] for result in results) else 1}


inside_freecad.start(__file__, parser(), work)
