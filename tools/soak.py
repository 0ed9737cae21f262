# SPDX-License-Identifier: LGPL-2.1-or-later
"""The work of tools/soak: random operations and attacks for a given time, inside FreeCADCmd.

Each operation is drawn from a seeded generator, checks what MeshQuality promises of its result,
and leaves nothing behind. Memory is looked at after a collection and malloc_trim: the resident set,
and how much of it malloc has given out and not got back. Each of the two counts as flat when its median
over the last quarter of the time is at most FLAT times that over the second quarter. A leak lets both
grow; the resident set alone grows with free memory in pieces too small to give back.
"""

import ctypes
import functools
import gc
import importlib
import json
import os
import random
import statistics
import sys
import tempfile
import time
import traceback
from collections import Counter
from pathlib import Path

import FreeCAD
import inside
import Mesh
import numpy as np
import Part

import MeshQuality as mq

OUT = Path(__file__).resolve().parent.parent / "out" / "soak.json"
FLAT = 1.05
SAMPLE_EVERY = 20.0  # seconds


def say(text):
    """To the user; FreeCAD prints its own progress to stdout."""
    print(text, file=sys.stderr, flush=True)


def random_shape(dice):
    """A solid of one to three bodies in random places; boxes may have rounded edges.

    No more of FreeCAD's modelling: makeFillet of what Booleans leave can end the process.
    """
    def body():
        size = [dice.uniform(4, 12) for _ in range(3)]
        place = FreeCAD.Vector(*(dice.uniform(-4, 4) for _ in range(3)))
        kind = dice.choice(("box", "rounded", "cylinder", "sphere", "cone", "torus"))
        if kind == "cylinder":
            return Part.makeCylinder(size[0] / 2, size[1], place)
        if kind == "sphere":
            return Part.makeSphere(size[0] / 2, place)
        if kind == "cone":
            return Part.makeCone(size[0] / 2, size[1] / 4, size[2], place)
        if kind == "torus":
            return Part.makeTorus(size[0], size[1] / 4, place)
        box = Part.makeBox(*size, place)
        return box.makeFillet(dice.uniform(0.2, 1.0), box.Edges) if kind == "rounded" else box

    shape = body()
    for _ in range(dice.randrange(3)):
        other = shape.cut(body()) if dice.random() < 0.5 else shape.fuse(body())
        if len(other.Solids) == 1 and other.isValid() and other.Volume > 1.0 and not half_done(other):
            shape = other
    return shape


def half_done(shape):
    """Whether a Boolean found where faces cross, but did not cut them there: two tori can end so, with the volume of one."""
    return any(edge.Orientation == "Internal" for face in shape.Faces for edge in face.Edges)


def check(condition, text):
    """Counts a promise that was not kept."""
    if not condition:
        raise AssertionError(text)


def check_report(report, shape=None):
    """What every surface mesh promises."""
    check(report.closed and report.oriented and report.manifold, f"not closed: {report}")
    check(report.min_angle_unexempted >= report.min_angle_asked - 1e-9, f"angle: {report}")
    if report.chord_height_asked > 0.0:
        check(report.max_chord_height <= report.chord_height_asked * (1.0 + 1e-6),
              f"chord height: {report}")
    if shape is not None:
        slack = max(report.max_chord_height, 0.0) * shape.Area + 1e-6 * shape.Volume
        check(abs(report.volume - shape.Volume) <= slack,
              f"volume {report.volume}, of the part {shape.Volume}")


def some_mesh(dice):
    """A quality mesh of a random part."""
    shape = random_shape(dice)
    return shape, mq.triangulate(shape, chord_height_relative=dice.choice((0.02, 0.005)))


def triangulate(dice):
    """All methods and most options."""
    shape = random_shape(dice)
    options = {"min_angle": dice.uniform(15, 30),
               "chord_height_relative": 10 ** dice.uniform(-3, -1.5)}
    method = dice.choice(("refine", "refine", "refine", "star", "sprinkle"))
    if method == "refine" and dice.random() < 0.3:
        options["max_edge"] = dice.uniform(1, 5)
    mesh = mq.triangulate(shape, method=method, **options)
    check_report(mesh.report, shape if method == "refine" else None)
    again = mq.triangulate(shape, method=method, **options)
    check(np.array_equal(again.triangles, mesh.triangles), "not the same mesh twice")


def edit(dice):
    """A mesh cache over a few edits of one part."""
    cache = mq.MeshCache(most_runs=3)
    for _ in range(4):
        bore = Part.makeCylinder(dice.choice((2, 3)), 10, FreeCAD.Vector(5, 5, 0))
        shape = Part.makeBox(10, 10, 10).cut(bore)
        check_report(mq.triangulate(shape, chord_height=0.02, cache=cache).report, shape)
    check(len(cache) <= 3, "the cache holds more runs than it may")


def curve(dice):
    """Curved surfaces and volumes."""
    shape = random_shape(dice)
    mesh = mq.curve(shape, order=dice.choice((1, 2, 3)), volume=dice.random() < 0.3,
                    chord_height_relative=0.02)
    check(mesh.report.invalid == 0, f"invalid elements: {mesh.report}")


def boolean(dice):
    """Two meshes, or a mesh and a shape."""
    _, mesh = some_mesh(dice)
    other = random_shape(dice)
    operation = dice.choice(("union", "intersection", "difference"))
    result = mq.boolean(mesh, other, operation, tolerance=0.05)
    if len(result.triangles):
        report = result.report
        check(report.closed and report.oriented and report.manifold, f"Boolean: {report}")


def improve(dice):
    """FreeCAD's own mesh of a part, made better."""
    shape = random_shape(dice)
    mesh = Mesh.Mesh([tuple(p) for p in _stock_triangles(shape)])
    before = mq.quality(mesh)
    after = mq.improve(mesh, min_angle=25, tolerance=0.05).report
    below = sum(before.angle_histogram[:25])
    check(len(after.exempt) <= below, f"improve: {below} below before, {after}")
    check(after.min_angle_unexempted >= 25.0, f"improve: {after}")


def _stock_triangles(shape):
    points, facets = shape.tessellate(0.1)
    return [points[i] for facet in facets for i in facet]


def files(dice):
    """Every format is written; a mesh read back has the triangles."""
    _, mesh = some_mesh(dice)
    with tempfile.TemporaryDirectory() as folder:
        for suffix in (".stl", ".ply", ".obj", ".off", ".msh", ".vtu"):
            mesh.write(os.path.join(folder, "part" + suffix))
        read = Mesh.Mesh(os.path.join(folder, "part.ply"))
        check(read.CountFacets == len(mesh.triangles), "other triangles than were written")


def document(dice):
    """Objects that follow their source through edits, undo and redo, and a file."""
    doc = FreeCAD.newDocument("Soak")
    try:
        doc.UndoMode = 1
        source = doc.addObject("Part::Box", "Box")
        doc.recompute()
        mesh = mq.add_quality_mesh(source, chord_height=0.05)
        mq.add_curved_mesh(source, order=2)
        for _ in range(3):
            doc.openTransaction("edit")
            source.Length = dice.uniform(5, 15)
            doc.commitTransaction()
            doc.recompute()
        count = mesh.Mesh.CountFacets
        doc.undo()
        doc.recompute()
        doc.redo()
        doc.recompute()
        check(mesh.Mesh.CountFacets == count, "another mesh after undo and redo")
        with tempfile.TemporaryDirectory() as folder:
            doc.saveAs(os.path.join(folder, "soak.FCStd"))
    finally:
        FreeCAD.closeDocument(doc.Name)


def cancel(dice):
    """The work ends when it is told to."""
    shape, after = random_shape(dice), dice.uniform(0, 1)
    try:
        mq.triangulate(shape, chord_height_relative=1e-3,
                       progress=lambda fraction, stage: fraction < after)
    except mq.Cancelled:
        return


def bad_input(dice):
    """Errors have texts."""
    try:
        box = Part.makeBox(1, 1, 1)
        dice.choice((lambda: mq.triangulate(Part.Shape()),
                     lambda: mq.triangulate(box, min_angle=50),
                     lambda: mq.boolean(Mesh.Mesh(), box, "union"),
                     lambda: mq.curve(box, order=9)))()
    except mq.Error as error:
        check(len(str(error)) > 20, f"an error that says little: {error}")
        return
    raise AssertionError("bad input was taken")


def attacked(dice):
    """One attack of tests/attacks: of a table, or put together by chance. Nothing of it is left behind."""
    table = importlib.import_module(dice.choice(ATTACKS))
    attack = table.combined(dice) if dice.random() < 0.5 else dice.choice(attacks_of(table))
    before = set(os.listdir(tempfile.gettempdir()))
    try:
        attack.call()
    except AssertionError as error:
        raise AssertionError(f"{table.__name__}: {attack.name}: {error}") from error
    left = inside.left_behind(before)
    check(not left, f"{table.__name__}: {attack.name}: left behind: {left}")


# Not that of callbacks: a child of a fork is another process, and small stacks are kept for the next thread.
ATTACKS = ("numbers_given", "arrays_given", "meshes_given", "shapes_given", "documents_edited")


@functools.lru_cache(maxsize=None)
def attacks_of(table):
    """All rows of a table, made once."""
    return table.rows()


OPERATIONS = (triangulate, triangulate, triangulate, edit, curve, boolean, improve, files, document,
              cancel, bad_input, attacked, attacked, attacked)


class _MallocInfo(ctypes.Structure):
    """The struct mallinfo2 of the C library."""

    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks",
        "keepcost")]


def memory_now():
    """MiB (resident, given out by malloc), after everything free has gone back."""
    gc.collect()
    library = ctypes.CDLL(None)
    library.malloc_trim(0)
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    library.mallinfo2.restype = _MallocInfo
    info = library.mallinfo2()
    return pages * os.sysconf("SC_PAGE_SIZE") / 2 ** 20, (info.uordblks + info.hblkhd) / 2 ** 20


def soak(minutes, seed):
    """Runs for so long. Returns what was done, what failed, and memory over time."""
    for name in ATTACKS:  # what they take is no leak
        attacks_of(importlib.import_module(name))
    done, failures, memory = Counter(), [], []
    start = time.monotonic()
    number = 0
    while time.monotonic() - start < 60.0 * minutes:
        dice = random.Random(f"{seed}:{number}")
        operation = dice.choice(OPERATIONS)
        try:
            operation(dice)
        except Exception as error:
            failures.append({"number": number, "operation": operation.__name__,
                             "what": str(error)[:500], "where": traceback.format_exc()[-800:]})
            say(f"{operation.__name__} {number} failed: {str(error)[:300]}")
        done[operation.__name__] += 1
        number += 1
        if not memory or time.monotonic() - start - memory[-1][0] > SAMPLE_EVERY:
            resident, given_out = memory_now()
            memory.append((round(time.monotonic() - start, 1), round(resident, 1),
                           round(given_out, 2)))
            say(f"{memory[-1][0]:7.0f} s  {number:6d} operations  {resident:7.1f} MiB, "
                f"{given_out:7.2f} given out  {len(failures)} failed")
    return {"minutes": minutes, "seed": seed, "done": dict(done), "failures": failures,
            "memory": memory}


def quarters(memory, seconds, column):
    """The median of a column of `memory` in each quarter of the time; None where there is none."""
    result = []
    for quarter in range(4):
        found = [row[column] for row in memory
                 if min(int(4.0 * row[0] / seconds), 3) == quarter]
        result.append(statistics.median(found) if found else None)
    return result


def main():
    """One run; ends FreeCAD."""
    minutes, seed = float(os.environ["SOAK_MINUTES"]), int(os.environ["SOAK_SEED"])
    result = soak(minutes, seed)
    flat = True
    for column, name in enumerate(("resident", "given_out"), 1):
        result[name] = medians = quarters(result["memory"], 60.0 * minutes, column)
        long_enough = None not in (medians[1], medians[3])
        growth = medians[3] / medians[1] if long_enough else 1.0
        flat = flat and growth <= FLAT
        told = f"{growth:.3f}" if long_enough else "too short to tell"
        say(f"MiB {name.replace('_', ' ')}, by quarter: {', '.join(map(str, medians))}; "
            f"the last over the second: {told}")
    OUT.write_text(json.dumps(result, indent=1), encoding="utf-8")
    say(f"{sum(result['done'].values())} operations, {len(result['failures'])} failed; memory "
        f"{'flat' if flat else 'not flat'}")
    os._exit(0 if flat and not result["failures"] else 1)
