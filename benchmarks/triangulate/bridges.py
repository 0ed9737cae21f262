#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long shapes take to come as a stream, beside meshing them, in seconds of the processor.

    /usr/bin/python3 benchmarks/triangulate/bridges.py [--only 'a*'] --out bridges.json

For each CAD file of $MESHQUALITY_DATA/cad: kB of the stream, ms in which FreeCAD writes it, ms in which the core reads it, s of
mq.triangulate with its defaults on the live shape, the share of the transfer in that, and whether the copy gives the same stream
again. A mesh is cancelled after --seconds, and its file is marked >. The status is 1 where a copy differs.
"""

import os
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--data", default=str(inside_freecad.data_folder()), help="folder with cad/")
    result.add_argument("--only", metavar="PATTERN", default="*", help="names of files")
    result.add_argument("--seconds", type=float, default=20.0, help="of the processor for each mesh, at most")
    return result


def timed(work):
    """(what work gives, seconds of the processor)"""
    start = time.process_time()
    return work(), time.process_time() - start


def meshed(shape, seconds):
    """Whether the mesh was finished; an error of a shape that cannot be meshed is an end, too."""
    import MeshQuality as mq

    end = time.process_time() + seconds
    try:
        mq.triangulate(shape, progress=lambda *_: time.process_time() < end)
    except mq.Cancelled:
        return False
    except mq.Error:
        pass
    return True


def measured(path, seconds):
    """A row of the table."""
    import Part

    from MeshQuality import _core
    from MeshQuality.core.sources import shape_stream

    shape = Part.Shape()
    shape.read(str(path))
    os.environ["MESHQUALITY_BRIDGE"] = "stream"
    stream, writing = timed(lambda: shape_stream.bytes_of(shape))
    _, taking = timed(lambda: _core.take(shape))  # writes it once more, and reads it
    same = _core.shape_stream(shape) == stream
    os.environ["MESHQUALITY_BRIDGE"] = "live"
    finished, meshing = timed(lambda: meshed(shape, seconds))
    return {"file": path.name, "bytes": len(stream), "writing": writing, "reading": max(taking - writing, 0.0),
            "meshing": meshing, "finished": finished, "same": same}


def work(arguments):
    files = sorted(path for path in (Path(arguments.data) / "cad").glob(arguments.only)
                   if path.suffix.lower() in inside_freecad.CAD_SUFFIXES)
    print("| file | kB | writing ms | reading ms | meshing s | share | same |\n|---|---|---|---|---|---|---|")
    rows = []
    for path in files:
        row = measured(path, arguments.seconds)
        rows.append(row)
        print(f"| {path.name} | {row['bytes'] / 1e3:.0f} | {1e3 * row['writing']:.1f} | {1e3 * row['reading']:.1f} | "
              f"{'' if row['finished'] else '>'}{row['meshing']:.2f} | {share(row):.2%} | {'yes' if row['same'] else 'no'} |", flush=True)
    transfer, meshing = sum(row["writing"] + row["reading"] for row in rows), sum(row["meshing"] for row in rows)
    print(f"{len(rows)} files, {sum(not row['same'] for row in rows)} differ; {transfer:.2f} s of {meshing:.0f} s: "
          f"{transfer / meshing:.3%}; largest share {max(map(share, rows)):.2%}")
    return {"rows": rows, "status": int(not all(row["same"] for row in rows))}


def share(row):
    """Of the transfer in the meshing."""
    return (row["writing"] + row["reading"]) / row["meshing"]


inside_freecad.start(__file__, parser(), work)
