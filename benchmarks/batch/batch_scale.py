# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `meshquality batch` costs beside the meshing, and how it grows; the figures of docs/measurements/batches.md.

    /usr/bin/python3 benchmarks/batch/batch_scale.py workers [--parts 300] [--jobs 1 2]
    /usr/bin/python3 benchmarks/batch/batch_scale.py startup|scheduler|driver|files

workers    parts a second against the number of jobs, and of workers of a Dask scheduler
startup    the same parts with FreeCADs that do many, and with one for each part
scheduler  empty and sleeping tasks: what Dask and the driver take for each
driver     lines of many parts: to find, to go on, to write table and report
files      many small files in one folder and in many
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections import namedtuple
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Mod"))

from MeshQuality.batch import cluster, freecad_pool, ledger, plan, report, table  # noqa: E402

COMMAND = ROOT / "bin" / "meshquality"
DATA = Path(os.environ.get("MESHQUALITY_DATA", ROOT.parent / "shared" / "data")) / "cad"

Cost = namedtuple("Cost", "wall cpu")


@contextmanager
def measured():
    """A list that gets the Cost of what is done inside: this process and the children it waits for."""
    def used():
        times = os.times()
        return times.user + times.system + times.children_user + times.children_system

    found, wall, cpu = [], time.perf_counter(), used()
    yield found
    found.append(Cost(time.perf_counter() - wall, used() - cpu))


def small_parts(folder, count):
    """Copies of the CAD files below 60 kB, until there are so many."""
    sources = sorted(path for path in DATA.iterdir()
                     if path.suffix in (".brep", ".step", ".stp") and path.stat().st_size < 60000)
    if not sources:
        sys.exit(f"no CAD files in {DATA}")
    for i in range(count):
        source = sources[i % len(sources)]
        place = folder / f"{i // 100:03d}"
        place.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, place / f"{i:06d}_{source.name}")
    return len(sources)


def batch(folder, out, *arguments):
    """The cost of one batch."""
    shutil.rmtree(out, ignore_errors=True)
    with measured() as cost:
        done = subprocess.run(["/usr/bin/python3", COMMAND, "batch", folder, "-o", out, "--json",
                               *map(str, arguments)], capture_output=True, text=True, check=False)
    states = json.loads(done.stdout)["states"]
    return cost[0], states


@contextmanager
def dask_cluster(workers, threads, folder):
    """The address of a scheduler with so many workers, and its process."""
    known = Path(folder) / "scheduler.json"
    known.unlink(missing_ok=True)
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    started = [subprocess.Popen(["dask-scheduler", "--host", "127.0.0.1", "--port", "0",
                                 "--no-dashboard", "--scheduler-file", str(known)], **quiet)]
    try:
        while not known.exists() or not known.stat().st_size:
            time.sleep(0.05)
        address = json.loads(known.read_text())["address"]
        for _ in range(workers):
            started.append(subprocess.Popen(
                ["dask-worker", address, "--nthreads", str(threads), "--no-nanny",
                 "--no-dashboard", "--memory-limit", "0", "--local-directory", folder], **quiet))
        yield address, started[0]
    finally:
        for process in reversed(started):
            process.kill()
            process.wait()


def measure_workers(arguments, scratch):
    """Parts a second against jobs, and against workers of a scheduler."""
    kinds = small_parts(scratch / "parts", arguments.parts)
    print(f"{arguments.parts} parts, copies of {kinds}")
    print(f"{'':<24} {'wall s':>8} {'CPU s':>8} {'parts/s':>8}")
    for jobs in arguments.jobs:
        cost, states = batch(scratch / "parts", scratch / "out", "--jobs", jobs)
        show(f"--jobs {jobs}", cost, arguments.parts)
    print(states)
    for workers in arguments.jobs:
        with dask_cluster(workers, 1, str(scratch)) as (address, _):
            cost, _ = batch(scratch / "parts", scratch / "out", "--scheduler", address)
        # What the workers' children use is not of this process.
        show(f"--scheduler, {workers} workers", Cost(cost.wall, float("nan")), arguments.parts)


def show(what, cost, parts):
    print(f"{what:<24} {cost.wall:8.2f} {cost.cpu:8.2f} {parts / cost.wall:8.1f}", flush=True)


def measure_startup(arguments, scratch):
    """FreeCADs that do many parts, and one for each part, in this process."""
    small_parts(scratch / "parts", arguments.parts)
    for most in (1000, 1):
        freecad_pool.MOST_JOBS = most
        chosen = plan.Plan(scratch / "parts", scratch / f"out{most}", "triangulate", {}, ".ply",
                           60.0, 2.0)
        found = []
        with measured() as cost, cluster.client_of(jobs=1) as client:
            cluster.run(client, chosen, plan.find_parts(chosen), found.append)
        show(f"{most} parts a FreeCAD", cost[0], len(found))


def empty(seconds):
    """A task that sleeps, and returns an entry as long as that of a part."""
    def work(folder, task, batch):
        import time

        time.sleep(seconds)
        return {"part": task["part"], "state": "done", "report": {"histogram": [1] * 60,
                "text": "x" * 1300}}

    return work


def measure_scheduler(arguments, scratch):
    """Empty tasks: the cost of Dask and of the driver; sleeping ones: how many threads they feed."""
    chosen = plan.Plan(scratch, scratch / "out", "triangulate", {}, ".ply", 60.0, 2.0)
    count = arguments.parts
    print(f"{'':<32} {'wall s':>8} {'parts/s':>8} {'driver ms':>10} {'scheduler ms':>12}")
    for seconds, threads in ((0.0, 2), (0.1, 8), (0.1, 32), (0.1, 128)):
        with dask_cluster(1, threads, str(scratch)) as (address, scheduler), \
                cluster.client_of(address) as client:
            parts = [plan.Part(f"{i:06d}.step", 1, 1) for i in range(count)]
            before, found = cpu_of(scheduler.pid), []
            with measured() as cost:
                cluster.run(client, chosen, parts, found.append, empty(seconds))
            used = cpu_of(scheduler.pid) - before
        assert sorted(entry["part"] for entry in found) == [part.name for part in parts]
        print(f"{f'{seconds:g} s tasks, {threads} threads':<32} {cost[0].wall:8.2f} "
              f"{count / cost[0].wall:8.0f} {1000 * cost[0].cpu / count:10.2f} "
              f"{1000 * used / count:12.2f}", flush=True)


def cpu_of(pid):
    """CPU seconds of a process so far."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def measure_driver(arguments, scratch):
    """What the driver does beside Dask, with as many parts as asked for, none of them meshed."""
    parts, out = scratch / "parts", scratch / "out"
    small_parts(parts, 60)
    batch(parts, out)
    lines = (out / "parts.jsonl").read_text().splitlines()
    entries = [json.loads(line) for line in lines]
    print(f"{sum(map(len, lines)) / len(lines):.0f} bytes a line")
    chosen = plan.Plan(parts, scratch / "many", "triangulate", {}, None, 60.0, 2.0)
    chosen.out.mkdir()
    found = []
    with open(chosen.out / ledger.NAME, "w", encoding="utf-8") as stream:
        for i in range(arguments.parts):
            entry = {**entries[i % len(entries)], "part": f"{i // 1000:04d}/{i:07d}.step",
                     "key": chosen.key, "output": None}
            found.append(plan.Part(entry["part"], entry["size"], entry["mtime_ns"]))
            stream.write(json.dumps(entry) + "\n")
    book = ledger.Ledger(chosen)
    for name, do in (("go on", lambda: book.keep(found)), ("table", lambda: table.write(chosen, book)),
                     ("report", lambda: report.write(chosen, book, len(found)))):
        with measured() as cost:
            do()
        print(f"{name:<10} {cost[0].wall:8.2f} s, {1e6 * cost[0].wall / len(found):8.1f} us a part")
    with measured() as cost:
        for entry in entries * 100:
            book.add(entry)
    print(f"add a line {1e6 * cost[0].wall / len(entries) / 100:.1f} us")
    book.close()


def measure_files(arguments, scratch):
    """Small files written as meshes are, in one folder and in folders of a thousand."""
    for title, width in (("one folder", None), ("a thousand a folder", 1000)):
        top = scratch / title.replace(" ", "_")
        top.mkdir()
        with measured() as cost:
            for i in range(arguments.parts):
                place = top if width is None else top / f"{i // width:05d}"
                if width and i % width == 0:
                    place.mkdir()
                ready = place / f".{i:07d}.ply.1.part.ply"
                ready.write_bytes(b"x" * 2000)
                os.replace(ready, place / f"{i:07d}.ply")
        with measured() as walk:
            count = sum(os.stat(os.path.join(path, name)).st_size > 0
                        for path, _, names in os.walk(top) for name in names)
        each = 1e6 / count
        print(f"{title:<22} {count} files: write {cost[0].wall * each:7.1f} us, walk and stat "
              f"{walk[0].wall * each:6.1f} us each", flush=True)


def main():
    measures = {"workers": measure_workers, "startup": measure_startup,
                "scheduler": measure_scheduler, "driver": measure_driver, "files": measure_files}
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=measures)
    parser.add_argument("--parts", type=int, default=300)
    parser.add_argument("--jobs", type=int, nargs="+", default=[1, 2])
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="batch_scale-") as folder:
        measures[arguments.what](arguments, Path(folder))


if __name__ == "__main__":
    main()
