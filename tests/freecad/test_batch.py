# SPDX-License-Identifier: LGPL-2.1-or-later
"""bin/meshquality batch from outside: lines, meshes, table, report, and what a second run does."""

import csv
import dataclasses
import html.parser
import importlib.util
import json
import logging
import os
import re
import shutil
import subprocess
import tempfile
import threading
import time
import unittest
import uuid
from collections import Counter
from pathlib import Path
from unittest import mock

import FreeCAD
import helpers
import Mesh
import numpy as np
import Part
from test_cli import COMMAND, run

from MeshQuality import charts
from MeshQuality.batch import cluster, command, freecad_pool, part, plan, report, table
from MeshQuality.cli import job as cli_job
from MeshQuality.cli.exit_status import DONE

HAS_DASK = importlib.util.find_spec("distributed") is not None
NEEDS_DASK = unittest.skipUnless(HAS_DASK, "python3-distributed is not installed")


def tree(folder):
    """{path: (content, time of change)} of all files below a folder."""
    found = {}
    for path, _, names in os.walk(folder):
        for name in names:
            full = os.path.join(path, name)
            with open(full, "rb") as stream:
                found[os.path.relpath(full, folder)] = (stream.read(), os.stat(full).st_mtime_ns)
    return found


def processes_with(mark):
    """Ids of processes that have the mark in their environment."""
    found = []
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/environ", "rb") as stream:
                if mark.encode() in stream.read():
                    found.append(int(entry))
        except OSError:
            continue
    return found


def wait_until(condition, seconds=60):
    """Whether the condition came true in time."""
    limit = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > limit:
            return False
        time.sleep(0.02)
    return True


class BatchTest(unittest.TestCase):
    """A folder with parts, and one for results."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.parts, self.out = os.path.join(holder.name, "parts"), os.path.join(holder.name, "out")
        os.makedirs(os.path.join(self.parts, "sub"))
        self.mark = uuid.uuid4().hex

    def shape(self, name, shape):
        path = os.path.join(self.parts, name)
        shape.exportBrep(path)
        return path

    def batch(self, *arguments):
        """(exit status, summary, lines of stderr)."""
        status, out, err = run("batch", self.parts, "-o", self.out, "--jobs", 2, "--json", *arguments)
        return status, json.loads(out), err

    def lines(self):
        path = os.path.join(self.out, "parts.jsonl")
        if not os.path.exists(path):
            return []
        with open(path, encoding="utf-8") as stream:
            return [json.loads(line) for line in stream if line.endswith("\n")]

    def assert_same_as_alone(self, name, *arguments):
        """The mesh of a part is that of the command for single parts, byte by byte."""
        alone = os.path.join(self.parts, "alone.ply")
        status, _, err = run("triangulate", os.path.join(self.parts, name), "-o", alone, *arguments)
        self.assertEqual(status, 0, err)
        with open(alone, "rb") as expected, \
                open(os.path.join(self.out, "meshes", name + ".ply"), "rb") as found:
            self.assertEqual(found.read(), expected.read())
        os.unlink(alone)


@NEEDS_DASK
class Batch(BatchTest):
    def setUp(self):
        super().setUp()
        self.shape("box.brep", Part.makeBox(1, 2, 3))
        self.shape("cylinder.brep", Part.makeCylinder(5, 10))
        self.shape("sub/box.brep", Part.makeBox(3, 2, 1))
        with open(os.path.join(self.parts, "junk & more.step"), "w", encoding="ascii") as stream:
            stream.write("no STEP file\n")
        os.symlink("nowhere.step", os.path.join(self.parts, ".hidden.step"))
        with open(os.path.join(self.parts, "notes.txt"), "w", encoding="ascii") as stream:
            stream.write("no part\n")

    def test_a_line_a_part_and_meshes_as_those_of_single_parts(self):
        status, summary, err = self.batch("--chord-height-relative", 0.01)
        self.assertEqual(status, 1)
        self.assertIn("1 of 4 parts failed", err[-1])
        self.assertEqual(summary["states"], {"done": 3, "input": 1})
        entries = {entry["part"]: entry for entry in self.lines()}
        self.assertEqual(sorted(entries),
                         ["box.brep", "cylinder.brep", "junk & more.step", "sub/box.brep"])
        self.assertIn("cannot read", entries["junk & more.step"]["error"])
        for name in ("box.brep", "cylinder.brep", "sub/box.brep"):
            report = entries[name]["report"]
            self.assertTrue(report["closed"])
            mesh = Mesh.Mesh(os.path.join(self.out, entries[name]["output"]))
            self.assertEqual(mesh.CountFacets, report["triangles"])
        self.assert_same_as_alone("cylinder.brep", "--chord-height-relative", 0.01)
        self.assertEqual(sorted(tree(os.path.join(self.out, "meshes"))),
                         ["box.brep.ply", "cylinder.brep.ply", "sub/box.brep.ply"])

    def test_table_and_report(self):
        self.batch()
        with open(os.path.join(self.out, "parts.csv"), encoding="utf-8", newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual([row["part"] for row in rows],
                         ["box.brep", "cylinder.brep", "junk & more.step", "sub/box.brep"])
        self.assertEqual(float(rows[3]["volume"]), 6.0)
        self.assertEqual((rows[0]["closed"], rows[0]["exempt_count"]), ("True", "0"))
        self.assertEqual(rows[2]["state"], "input")
        with open(os.path.join(self.out, "report.html"), encoding="utf-8") as stream:
            page = stream.read()
        checker = Checker()
        checker.feed(page)
        self.assertEqual(checker.open, [])
        self.assertGreater(checker.counts["svg"], 3)
        self.assertEqual(checker.outside, [])
        self.assertIn("junk &amp; more.step", page)
        for target in checker.links:
            self.assertTrue(os.path.exists(os.path.join(self.out, target)), target)

    def test_verdicts_and_strict(self):
        os.unlink(os.path.join(self.parts, "junk & more.step"))
        status, summary, err = self.batch("--strict")
        self.assertEqual((status, summary["verdict"], summary["not_met"]), (0, "met", 0), err)
        self.assertEqual({entry["report"]["verdict"] for entry in self.lines()}, {"met"})
        corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (10, 0, 0), (10, 0.8, 0), (0, 0, 0))]
        self.shape("wedge.brep", Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 3)))
        self.assertEqual(self.batch()[0], 0)
        status, summary, err = self.batch("--strict")
        self.assertEqual((status, summary["verdict"], summary["not_met"]), (3, "not met", 1), err)
        self.assertIn("1 of 4 meshes does not meet a requested limit", err[-1])
        entry = next(entry for entry in self.lines() if entry["part"] == "wedge.brep")
        self.assertEqual((entry["report"]["verdict"], entry["report"]["findings_count"]), ("not met", 1))
        with open(os.path.join(self.out, "parts.csv"), encoding="utf-8", newline="") as stream:
            self.assertEqual([row["verdict"] for row in csv.DictReader(stream)], ["met"] * 3 + ["not met"])
        with open(os.path.join(self.out, "report.html"), encoding="utf-8") as stream:
            page = stream.read()
        self.assertIn("met by 3 of 4 meshes", page)
        self.assertIn("<td>Smallest angle 4.57° (requested 25°)", page)

    def test_a_second_run_does_what_is_missing_only(self):
        self.batch()
        before = tree(self.out)
        _, summary, _ = self.batch()
        self.assertEqual(summary["worked_on"], 0)
        after = tree(self.out)
        self.assertEqual({name: after[name] for name in after if name.startswith("meshes")},
                         {name: before[name] for name in before if name.startswith("meshes")})
        self.assertEqual(after["parts.csv"][0], before["parts.csv"][0])
        # A time of change alone is no change; another content is, and so is a mesh that is gone.
        os.utime(os.path.join(self.parts, "box.brep"))
        self.shape("cylinder.brep", Part.makeCylinder(6, 10))
        os.unlink(os.path.join(self.out, "meshes", "sub", "box.brep.ply"))
        _, summary, _ = self.batch()
        self.assertEqual(summary["worked_on"], 2)
        found = {entry["part"]: entry["report"]["volume"] for entry in self.lines()
                 if entry["state"] == "done"}
        self.assertGreater(found["cylinder.brep"], 1000.0)
        # Failures only when asked for, all with other options, and none of a part that is gone.
        self.assertEqual(self.batch("--retry")[1]["worked_on"], 1)
        self.assertEqual(self.batch("--min-angle", 20)[1]["worked_on"], 4)
        os.unlink(os.path.join(self.parts, "junk & more.step"))
        status, summary, _ = self.batch("--min-angle", 20)
        self.assertEqual((status, summary["worked_on"], summary["parts"]), (0, 0, 3))
        self.assertEqual(len(self.lines()), 3)

    def test_content_of_the_same_size_and_time(self):
        path = os.path.join(self.parts, "junk & more.step")
        self.batch()
        status = os.stat(path)
        with open(path, "r+", encoding="ascii") as stream:
            stream.write("ON")
        os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))
        self.assertEqual(self.batch()[1]["worked_on"], 0)
        self.assertEqual(self.batch("--check-content")[1]["worked_on"], 1)
        # What cannot be read costs itself only.
        os.symlink("nowhere", os.path.join(self.parts, "link.step"))
        self.assertEqual(self.batch("--check-content")[1]["states"], {"done": 3, "input": 2})

    def test_meshes_that_are_cut_or_of_another_part_are_made_again(self):
        self.batch()
        os.truncate(os.path.join(self.out, "meshes", "box.brep.ply"), 200)
        self.assertEqual(self.batch()[1]["worked_on"], 1)
        path = os.path.join(self.out, "meshes", "cylinder.brep.ply")
        with open(path, "r+b") as stream:
            stream.seek(-4, os.SEEK_END)
            stream.write(b"torn")
        self.assertEqual(self.batch()[1]["worked_on"], 0)
        self.assertEqual(self.batch("--check-content")[1]["worked_on"], 1)
        # A line that names the mesh of another part.
        lines = self.lines()
        for entry in lines:
            if entry["part"] == "sub/box.brep":
                entry.update({name: value for other in lines if other["part"] == "box.brep"
                              for name, value in other.items() if name.startswith("output")})
        with open(os.path.join(self.out, "parts.jsonl"), "w", encoding="utf-8") as stream:
            stream.writelines(json.dumps(entry) + "\n" for entry in lines)
        self.assertEqual(self.batch()[1]["worked_on"], 1)
        self.assertEqual({entry["output"] for entry in self.lines() if entry["part"] == "sub/box.brep"}, {"meshes/sub/box.brep.ply"})

    def test_a_line_cut_short_is_done_again(self):
        self.batch()
        path = os.path.join(self.out, "parts.jsonl")
        with open(path, "r+b") as stream:
            stream.truncate(os.path.getsize(path) - 10)
        self.assertEqual(self.batch()[1]["worked_on"], 1)
        self.assertEqual(len(self.lines()), 4)

    def test_a_hang_and_a_memory_hog_cost_one_part_each(self):
        ball = self.shape("ball.brep", Part.makeSphere(5))
        endless = ("--chord-height", "2e-6", "--max-triangles", "2000000000")
        status, summary, _ = self.batch("--time-limit", 3, *endless, "--only", "b*.brep")
        self.assertEqual((status, summary["states"]), (1, {"done": 1, "timeout": 1}))
        entry = next(entry for entry in self.lines() if entry["part"] == "ball.brep")
        self.assertIn("3 s", entry["error"])
        self.assertEqual(os.listdir(os.path.join(self.out, "meshes")), ["box.brep.ply"])
        status, summary, _ = self.batch("--memory-limit", 0.2, *endless, "--only", "b*.brep",
                                        "--retry")
        self.assertEqual((status, summary["states"]), (1, {"done": 1, "memory": 1}))
        os.unlink(ball)

    def test_curved_meshes_and_measurements(self):
        status, summary, err = self.batch("--command", "curve", "--volume", "--only", "*box.brep",
                                          "--format", "vtu")
        self.assertEqual(status, 0, err)
        self.assertEqual({entry["report"]["invalid"] for entry in self.lines()}, {0})
        self.assertTrue(os.path.exists(os.path.join(self.out, "meshes", "sub", "box.brep.vtu")))
        for deviation in (0.2, 0.02):
            status, summary, err = self.batch("--command", "curve", "--only", "cyl*", "--format",
                                              "stl", "--deviation", deviation)
            self.assertEqual((status, summary["worked_on"]), (0, 1), err)
        fine = Mesh.Mesh(os.path.join(self.out, "meshes", "cylinder.brep.stl"))
        cylinder = next(entry for entry in self.lines() if entry["part"] == "cylinder.brep")
        self.assertGreater(fine.CountFacets, 2 * cylinder["report"]["elements"])
        Mesh.createBox(1, 1, 1).write(os.path.join(self.parts, "box.stl"))
        status, summary, err = self.batch("--command", "quality")
        self.assertEqual((status, summary["parts"]), (0, 1), err)
        self.assertEqual(self.lines()[0]["report"]["triangles"], 12)
        self.assertIsNone(self.lines()[0]["output"])

    def test_bad_usage_ends_with_2(self):
        empty = os.path.join(self.parts, "empty")
        os.mkdir(empty)
        for arguments, word in (
                ((self.parts + "/none", "-o", self.out), "none"),
                ((empty, "-o", self.out), ".step"),
                ((self.parts, "-o", self.out, "--only", "x*"), "--only"),
                ((self.parts, "-o", self.parts + "/notes.txt"), "notes.txt"),
                ((self.parts, "-o", self.parts + "/sub/.."), "of their own"),
                ((self.parts, "-o", self.out, "--min-angle", "50"), "34 degrees"),
                ((self.parts, "-o", self.out, "--format", "xyz"), "ply"),
                ((self.parts, "-o", self.out, "--jobs", "0"), "--jobs"),
                ((self.parts, "-o", self.out, "--time-limit", "-1"), "--time-limit"),
                ((self.parts, "-o", self.out, "--order", "2"), "rounds, worst first"),
                ((self.parts, "-o", self.out, "--command", "curve", "--deviation", "1"), "flat"),
                ((self.parts,), "--output")):
            with self.subTest(arguments):
                status, out, err = run("batch", *arguments)
                self.assertEqual((status, out), (2, ""))
                self.assertIn(word, err[-1])

    def test_told_to_end_it_leaves_nothing_running_and_goes_on_later(self):
        for i in range(16):
            self.shape(f"ring{i}.brep", Part.makeTorus(10 + i, 3))
        command = [COMMAND, "batch", self.parts, "-o", self.out, "--jobs", "2",
                   "--chord-height", "0.003"]
        slow = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, text=True,
                                env={**os.environ, "MESHQUALITY_TEST": self.mark})
        self.assertTrue(wait_until(lambda: len(self.lines()) > 3))
        status, _, err = run("batch", self.parts, "-o", self.out)
        self.assertEqual(status, 2)
        self.assertIn("another batch is at work", err[-1])
        slow.terminate()
        _, err = slow.communicate(timeout=30)
        self.assertEqual(slow.returncode, 1)
        self.assertIn("interrupted", err.splitlines()[-1])
        self.assertTrue(wait_until(lambda: not processes_with(self.mark), 10))
        had = len(self.lines())
        self.assertLess(had, 20)
        _, summary, _ = self.batch("--chord-height", "0.003")
        self.assertEqual(summary["worked_on"], 20 - had)
        self.assertEqual(set(Counter(entry["part"] for entry in self.lines()).values()), {1})
        self.assertEqual(summary["states"], {"done": 19, "input": 1})
        self.assertFalse([name for name in tree(self.out) if ".part" in name])


class Checker(html.parser.HTMLParser):
    """Which elements are open, how many there are of each, and what a page refers to."""

    VOID = {"meta", "br", "img", "link"}

    def __init__(self):
        super().__init__()
        self.open, self.counts, self.links, self.outside = [], Counter(), [], []

    def handle_starttag(self, tag, attrs):
        self.counts[tag] += 1
        if tag not in self.VOID:
            self.open.append(tag)
        for name, value in attrs:
            if name == "href":
                self.links.append(value)
            if name == "src" or (value or "").startswith("http"):
                self.outside.append(value)

    def handle_startendtag(self, tag, attrs):
        self.counts[tag] += 1

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, (self.open, tag)
        self.open.pop()


class Workers(BatchTest):
    """The FreeCADs of a worker, without Dask."""

    def task(self, name, **options):
        path = os.path.join(self.parts, name)
        output = os.path.join(self.out, "meshes", name + ".ply")
        return {"part": name, "path": path, "size": 1, "mtime_ns": 1, "key": "k", "output": "o",
                "output_path": output, "command": "triangulate", "suffix": ".ply",
                "options": options, "deviation": None, "seconds": 60.0, "bytes": 2**31}

    def kill_soon(self):
        """Kills the FreeCAD that works, in the middle of its work."""
        pool = freecad_pool.pool(self.mark)
        self.assertTrue(wait_until(lambda: any(one.jobs for one in pool._busy)))
        time.sleep(0.3)
        os.kill(next(iter(pool._busy)).pid, 11)

    def run_part(self, task, kills):
        worker = threading.Thread(target=lambda: [self.kill_soon() for _ in range(kills)])
        worker.start()
        entry = part.run(task, self.mark)
        worker.join()
        return entry

    def test_a_crash_is_the_parts_if_it_happens_in_a_new_freecad(self):
        self.addCleanup(freecad_pool.close_pool, self.mark)
        self.shape("ball.brep", Part.makeSphere(5))
        slow = self.task("ball.brep", chord_height=1e-4)
        entry = self.run_part(slow, kills=1)
        self.assertEqual((entry["state"], entry["attempts"]), ("crash", 1))
        self.assertIn("SIGSEGV", entry["error"])
        # The next part gets a FreeCAD of its own; a crash in one that was used is not the part's.
        self.assertEqual(part.run(self.task("ball.brep"), self.mark)["state"], "done")
        entry = self.run_part(self.task("ball.brep", chord_height=2e-4), kills=1)
        self.assertEqual((entry["state"], entry["attempts"]), ("done", 2))

    def test_files_that_are_gone_and_ends(self):
        entry = part.run(self.task("none.brep"), self.mark)
        self.assertEqual((entry["state"], entry["attempts"]), ("input", 0))
        self.shape("box.brep", Part.makeBox(1, 1, 1))
        self.assertEqual(part.run(self.task("box.brep"), self.mark)["state"], "done")
        self.assertEqual(len(freecad_pool.pool(self.mark)._idle), 1)
        freecad_pool.close_pool(self.mark)
        entry = part.run(self.task("box.brep"), self.mark)
        self.assertEqual((entry["state"], entry["attempts"]), ("lost", 0))

    def test_bins(self):
        self.assertEqual(charts.counts_of([1, 10, 99, 1000], [1, 10, 100, 1000]), [1, 2, 1])
        self.assertEqual(sum(charts.counts_of([5.0] * 7, charts.edges_of([5.0] * 7, False))), 7)
        self.assertEqual(charts.ticks([0.0, 60.0], False), [0, 10, 20, 30, 40, 50, 60])
        self.assertEqual(charts.ticks([0.001, 10.0], True), [0.001, 0.01, 0.1, 1.0, 10.0])
        self.assertIn("2 of 0 left out", charts.histogram([0, 0, 1], "n", log=True))


@NEEDS_DASK
class Scheduler(BatchTest):
    """An existing Dask cluster: a real scheduler and two workers, processes of their own."""

    def start(self, *command):
        process = subprocess.Popen(
            list(map(str, command)), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, env={**os.environ, "MESHQUALITY_TEST": self.mark,
                                            "DASK_DISTRIBUTED__SCHEDULER__WORK_STEALING": "False"})

        def end():
            process.kill()
            process.wait()

        self.addCleanup(end)
        return process

    def cluster(self, workers):
        """(address, worker processes)."""
        self.scratch = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.scratch, ignore_errors=True)
        known = os.path.join(self.scratch, "scheduler.json")
        self.start("dask-scheduler", "--host", "127.0.0.1", "--port", 0, "--no-dashboard",
                   "--scheduler-file", known)
        self.assertTrue(wait_until(lambda: os.path.exists(known) and os.path.getsize(known)))
        with open(known, encoding="utf-8") as stream:
            address = json.load(stream)["address"]
        return address, [
            self.start("dask-worker", address, "--nthreads", 1, "--no-nanny", "--no-dashboard",
                       "--memory-limit", 0, "--local-directory", self.scratch, "--name", f"w{i}")
            for i in range(workers)]

    def test_a_worker_killed_in_the_middle_loses_nothing_and_doubles_nothing(self):
        names = [f"ring{i}.brep" for i in range(40)]
        for i, name in enumerate(names):
            self.shape(name, Part.makeTorus(10 + i, 3))
        address, workers = self.cluster(2)
        driver = subprocess.Popen(
            [COMMAND, "batch", self.parts, "-o", self.out, "--scheduler", address, "--json",
             "--chord-height", "0.02"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True)
        self.assertTrue(wait_until(lambda: len(self.lines()) >= 8))
        workers[0].kill()
        had = len(self.lines())
        out, err = driver.communicate(timeout=120)
        self.assertLess(had, 38)  # it was killed in the middle
        self.assertEqual(driver.returncode, 0, err)
        self.assertEqual(len(err.splitlines()), 1, err)
        self.assertEqual(json.loads(out)["states"], {"done": 40})
        self.assertEqual(Counter(entry["part"] for entry in self.lines()), Counter(names))
        self.assertEqual(sorted(tree(os.path.join(self.out, "meshes"))),
                         sorted(name + ".ply" for name in names))
        self.assert_same_as_alone(names[0], "--chord-height", "0.02")
        for entry in self.lines():
            mesh = Mesh.Mesh(os.path.join(self.out, entry["output"]))
            self.assertEqual(mesh.CountFacets, entry["report"]["triangles"])
        # All FreeCADs are gone: of the marked processes the scheduler and one worker are left.
        self.assertTrue(wait_until(lambda: len(processes_with(self.mark)) == 2, 15),
                        processes_with(self.mark))

    def test_a_cluster_whose_last_worker_dies_is_told(self):
        self.shape("ring.brep", Part.makeTorus(10, 3))
        address, workers = self.cluster(1)
        chosen = plan.Plan(Path(self.parts), Path(self.out), "triangulate", {}, ".ply", 60.0, 1.0)
        began = os.path.join(self.scratch, "began")

        def work(folder, task, batch):
            import time

            with open(began, "w", encoding="ascii"):
                time.sleep(600)

        killer = threading.Thread(target=lambda: wait_until(lambda: os.path.exists(began)) and workers[0].kill())
        with cluster.client_of(address) as client, mock.patch.object(cluster, "WAIT_FOR_WORKERS", 2.0):
            killer.start()
            with self.assertRaisesRegex(ConnectionError, "no workers any more"):
                cluster.run(client, chosen, plan.find_parts(chosen), self.fail, work)
            killer.join()

    def test_dask_says_nothing_of_its_own(self):
        with cluster.client_of(jobs=1):
            loud = [name for name in logging.root.manager.loggerDict
                    if name.partition(".")[0] == "distributed"
                    and logging.getLogger(name).isEnabledFor(logging.ERROR)]
        self.assertEqual(loud, [])

    def test_no_scheduler_there(self):
        self.shape("box.brep", Part.makeBox(1, 1, 1))
        status, out, err = run("batch", self.parts, "-o", self.out, "--scheduler",
                               "tcp://127.0.0.1:9")
        self.assertEqual((status, out), (2, ""))
        self.assertIn("no Dask scheduler at tcp://127.0.0.1:9", err[-1])


class Report(unittest.TestCase):
    """The findings of many parts; no FreeCAD, no Dask."""

    PLAN = plan.Plan(Path("parts"), Path("out"), "triangulate", {"min_angle": 25.0}, ".ply", 1.0, 1.0)

    def entry(self, i, angle, **more):
        return {"part": f"p{i:05d}.step", "state": "done", "seconds": 0.5, "peak_mib": 100,
                "output": f"meshes/p{i:05d}.step.ply",
                "report": {"min_angle": angle, "min_angle_unexempted": max(angle, 25.0),
                           "triangles": i + 1, "exempt_count": 0, "closed": True,
                           "box": [[0, 0, 0], [1, 2, 4]], "max_chord_height": 0.04}, **more}

    def test_of_many_parts_the_worst_are_kept(self):
        findings = report.Findings("triangulate")
        for i in range(3000):
            findings.add(self.entry(i, 30.0 - 0.01 * ((i * 1237) % 3000)))
        page = report.page(self.PLAN, findings)
        lowest = page.partition("smallest angle, degrees, lowest")[2].partition("</table>")[0]
        self.assertNotIn("yet to be done", page)
        found = [float(value) for value in re.findall(r"<td>([\d.]+)</td>", lowest)]
        np.testing.assert_allclose(found, [0.01 * i for i in range(1, 11)], rtol=1e-5)
        # Nobody is among the worst who keeps what was asked for.
        self.assertNotIn("without exempted triangles, degrees, lowest", page)
        self.assertIn("3000 of 3000 parts", page)
        self.assertIn("<td>0.01</td>", page.partition("max. deviation relative to size, highest")[2])

    def test_the_kind_of_a_failure_is_its_phrase(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        kinds = []
        for name in ("a", "b"):
            path = os.path.join(folder, f"{name}.brep")
            Part.makeLine(FreeCAD.Vector(), FreeCAD.Vector(len(name), 2, 3)).exportBrep(path)
            result = cli_job.run({"command": "triangulate", "input": path, "options": {}, "output": None})
            self.assertNotEqual(result["status"], DONE)
            self.assertIn("kind", result, result)
            kinds.append(result["kind"])
        self.assertEqual(kinds[0], kinds[1])
        self.assertIn("{", kinds[0])

    def test_failures_are_gathered_by_cause(self):
        findings = report.Findings("triangulate")
        for i in range(300):
            findings.add(self.entry(i, 25.0, state="failed", error=f"Face{i} of '{i}.step' <fails>",
                                    kind="{name} of '{name2}' <fails>"))
        findings.add(self.entry(301, 25.0, state="timeout", error="took more than 5 s"))
        page = report.page(self.PLAN, findings)
        self.assertIn("<td>failed</td><td>300</td><td>Face0 of &#x27;0.step&#x27; &lt;fails&gt;</td>", page)
        self.assertEqual(len(findings.causes), 2)

    def test_while_it_runs_the_results_so_far_are_there(self):
        class Lines:
            def entries(_):
                return iter([self.entry(0, 25.0), self.entry(1, 25.0)])

            sorted_entries = entries

        with tempfile.TemporaryDirectory() as folder:
            chosen = dataclasses.replace(self.PLAN, out=Path(folder))
            self.assertGreaterEqual(command.write_results(chosen, Lines(), 10), 0.0)
            page = (Path(folder) / "report.html").read_text(encoding="utf-8")
            self.assertIn("2 of 10 parts", page)
            self.assertIn("<td>not done yet</td><td>8</td><td>80.00 %</td>", page)
            rows = (Path(folder) / "parts.csv").read_text(encoding="utf-8").splitlines()
            self.assertEqual((len(rows), rows[2].split(",")[0]), (3, "p00001.step"))

    @unittest.skipUnless(importlib.util.find_spec("pyarrow"), "python3-pyarrow is not installed")
    def test_the_table_is_there_as_parquet_too(self):
        from pyarrow import parquet

        entries = [self.entry(i, 20.0 + 0.001 * i) for i in range(14000)]
        # Columns that are empty, or whole numbers, for long.
        entries[-1].update(state="failed", error="Face3 of 'ä.step': no triangulation, \"sorry\"")
        entries[-2]["peak_mib"] = 100.5

        class Lines:
            def entries(_):
                return iter(entries)

            def sorted_entries(_):
                return iter(entries)

        with tempfile.TemporaryDirectory() as folder:
            table.write(dataclasses.replace(self.PLAN, out=Path(folder)), Lines())
            with open(os.path.join(folder, "parts.csv"), encoding="utf-8", newline="") as stream:
                rows = list(csv.DictReader(stream))
            self.assertGreater(os.path.getsize(os.path.join(folder, "parts.csv")), 2 ** 20,
                               "it is to be more than pyarrow reads at once")
            read = parquet.read_table(os.path.join(folder, "parts.parquet")).to_pydict()
        self.assertEqual(list(read), list(rows[0]))
        self.assertEqual(read["part"], [row["part"] for row in rows])
        self.assertEqual(read["error"][-1], rows[-1]["error"])
        self.assertEqual(read["peak_mib"][-2:], [100.5, 100.0])
        self.assertEqual(read["triangles"], list(range(1, 14001)))
        np.testing.assert_array_equal(read["min_angle"], [float(row["min_angle"]) for row in rows])
