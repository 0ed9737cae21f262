# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a hostile folder, a killed owner, a full disk or a damaged ledger do to bin/meshquality: nothing worse than a
line with the reason.
"""

import contextlib
import errno
import json
import os
import signal
import socket
import stat
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

import helpers
import Mesh
import Part
from test_batch import NEEDS_DASK, BatchTest, processes_with, tree, wait_until
from test_cli import COMMAND, run

import MeshQuality as mq
from MeshQuality import files, limits
from MeshQuality.batch import ledger, part, plan
from MeshQuality.cli import output_file

ENDLESS = ("--chord-height", "5e-6", "--max-triangles", "2000000000")


def listening(pid):
    """Addresses, as hexadecimal text, of the sockets on which the process listens for TCP."""
    sockets = set()
    for end in os.listdir(f"/proc/{pid}/fd"):
        try:
            sockets.add(os.readlink(f"/proc/{pid}/fd/{end}"))
        except OSError:
            continue
    found = []
    for table in ("tcp", "tcp6"):
        with open(f"/proc/{pid}/net/{table}", encoding="ascii") as stream:
            rows = [line.split() for line in stream][1:]
        found += [row[1].rpartition(":")[0] for row in rows if row[3] == "0A" and f"socket:[{row[9]}]" in sockets]
    return found


def end_if_there(pid):
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, signal.SIGKILL)


class Started(BatchTest):
    """Commands that a test ends in its own way."""

    def start(self, *arguments):
        process = subprocess.Popen(
            [COMMAND, *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, env={**os.environ, "MESHQUALITY_TEST": self.mark})

        def end():
            process.kill()
            process.wait()

        self.addCleanup(end)
        return process

    def freecads(self, script):
        """Ids of the FreeCADs of this test that have come to run the script."""
        found = []
        for pid in processes_with(self.mark):
            try:
                with open(f"/proc/{pid}/cmdline", "rb") as stream:
                    runs = script.encode() in stream.read()
                with open(f"/proc/{pid}/maps", encoding="utf-8", errors="replace") as stream:
                    runs = runs and "_core." in stream.read()
            except OSError:
                continue
            found += [pid] if runs else []
        return found

    def assert_ends_with_its_owner(self, script, owner):
        self.assertTrue(wait_until(lambda: self.freecads(script)))
        time.sleep(0.3)  # into its work
        for pid in self.freecads(script):
            os.kill(pid, signal.SIGSTOP)  # as in a reader of OpenCASCADE, none of its code can look for its owner
            self.addCleanup(end_if_there, pid)
        owner.kill()
        owner.wait()
        self.assertTrue(wait_until(lambda: not processes_with(self.mark)), processes_with(self.mark))


class Owners(Started):
    def test_freecad_of_a_single_command_ends_when_that_is_killed(self):
        ball = self.shape("ball.brep", Part.makeSphere(5))
        self.assert_ends_with_its_owner("cli/job.py", self.start("triangulate", ball, *ENDLESS))

    @NEEDS_DASK
    def test_freecads_of_a_batch_end_when_that_is_killed(self):
        self.shape("ball.brep", Part.makeSphere(5))
        self.assert_ends_with_its_owner("worker_loop.py", self.start("batch", self.parts, "-o", self.out, *ENDLESS))

    def test_the_pipe_alone_ends_what_lets_python_run(self):
        """Where the kernel has no such signal, or a program between FreeCAD and its owner gets it."""
        code = ("import sys, time; sys.platform = 'other'; from MeshQuality import limits; limits.end_with_owner(); "
                "print('ready', flush=True); time.sleep(600)")
        with limits.ownership() as (ends, owner):
            worker = subprocess.Popen(["/usr/bin/python3", "-c", code],
                                      stdout=subprocess.PIPE, pass_fds=ends,
                                      env={**os.environ, **owner, "PYTHONPATH": os.path.join(helpers.ROOT, "Mod")})
            self.addCleanup(worker.stdout.close)
            self.assertEqual(worker.stdout.readline(), b"ready\n")
            self.assertIsNone(worker.poll())
        self.assertEqual(worker.wait(60), 1)

    @unittest.skipUnless(sys.platform.startswith("linux"), "the kernel of Linux has the signal")
    def test_code_that_never_returns_to_python_ends_too(self):
        """As in a reader of OpenCASCADE, which keeps the lock of the interpreter."""
        work = ("import ctypes; from MeshQuality import limits; limits.end_with_owner(); print('ready', flush=True); "
                "ctypes.PyDLL(None).sleep(600)")
        own = ("import subprocess, sys; from MeshQuality import limits\n"
               "with limits.ownership() as (ends, owner):\n"
               "    subprocess.run(['/usr/bin/python3', '-c', sys.argv[1]], pass_fds=ends, "
               "env={**__import__('os').environ, **owner})")
        owner = subprocess.Popen(
            ["/usr/bin/python3", "-c", own, work], stdout=subprocess.PIPE,
            env={**os.environ, "MESHQUALITY_TEST": self.mark, "PYTHONPATH": os.path.join(helpers.ROOT, "Mod")})
        self.addCleanup(owner.stdout.close)
        self.assertEqual(owner.stdout.readline(), b"ready\n")
        time.sleep(0.1)
        owner.kill()
        owner.wait()
        self.assertTrue(wait_until(lambda: not processes_with(self.mark)))



class Limits(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.ball = os.path.join(self.folder, "ball.brep")
        Part.makeSphere(5).exportBrep(self.ball)
        self.output = os.path.join(self.folder, "ball.ply")

    def assert_ended(self, flag, value, *arguments):
        """Checks that a limit ends a command that would go on without end; the CPU time that it took."""
        before = helpers.cpu_seconds_of_children()
        status, out, err = run(*arguments, flag, value)
        self.assertEqual((status, out), (1, ""))
        self.assertIn(flag, err[-1])
        self.assertIn(f"{value:g}", err[-1])
        self.assertEqual(os.listdir(self.folder), ["ball.brep"])
        return helpers.cpu_seconds_of_children() - before

    def test_time(self):
        # CPU time on one thread is no longer than the time that the limit counts, however busy the machine is.
        with mock.patch.dict(os.environ, MESHQUALITY_THREADS="1"):
            self.assertLess(
                self.assert_ended("--time-limit", 2, "triangulate", self.ball, "-o", self.output, *ENDLESS), 6)

    def test_memory(self):
        self.assert_ended("--memory-limit", 0.15, "triangulate", self.ball, "-o", self.output, *ENDLESS)

    def test_standard_input_that_never_ends(self):
        reading, writing = os.pipe()
        self.addCleanup(os.close, writing)
        with os.fdopen(reading) as stream:
            done = subprocess.run([COMMAND, "triangulate", "-", "--input-format", "brep", "--time-limit", "1"],
                                  stdin=stream, capture_output=True, text=True, timeout=30)
        self.assertEqual(done.returncode, 1)
        self.assertIn("--time-limit", done.stderr)

    def test_every_command_takes_them_and_refuses_nonsense(self):
        stl = os.path.join(self.folder, "box.stl")
        Mesh.createBox(1, 2, 3).write(stl)
        for command, name in (("triangulate", self.ball), ("curve", self.ball), ("improve", stl), ("quality", stl)):
            status, _, err = run(command, name, "--time-limit", 200, "--memory-limit", 2)
            self.assertEqual(status, 0, err)
        for flag, value in (("--time-limit", 0), ("--memory-limit", -1), ("--time-limit", "nan")):
            status, _, err = run("boolean", stl, stl, flag, value)
            self.assertEqual(status, 2)
            self.assertIn(flag, err[-1])


@NEEDS_DASK
class Folders(Started):
    def setUp(self):
        super().setUp()
        self.shape("box.brep", Part.makeBox(1, 2, 3))

    def states(self):
        return {entry["part"]: entry["state"] for entry in self.lines()}

    def test_nothing_listens(self):
        self.shape("ball.brep", Part.makeSphere(5))
        batch = self.start("batch", self.parts, "-o", self.out, *ENDLESS)
        self.assertTrue(wait_until(lambda: self.freecads("worker_loop.py")))
        self.assertEqual([address for pid in processes_with(self.mark) for address in listening(pid)], [])
        batch.kill()
        batch.wait()
        batch = self.start("batch", self.parts, "-o", self.out, "--dashboard", *ENDLESS)
        self.assertTrue(wait_until(lambda: listening(batch.pid)))
        self.assertTrue(wait_until(lambda: self.freecads("worker_loop.py")))
        self.assertEqual({address for pid in processes_with(self.mark) for address in listening(pid)}, {"0100007F"})

    def test_what_is_not_a_file_is_left_out_with_the_reason(self):
        os.mkfifo(os.path.join(self.parts, "pipe.step"))
        os.symlink("/dev/zero", os.path.join(self.parts, "endless.step"))
        os.mkdir(os.path.join(self.parts, "folder.step"))
        os.makedirs(os.path.join(self.parts, "holder.step"))
        self.shape("holder.step/box.brep", Part.makeBox(1, 2, 3))
        with socket.socket(socket.AF_UNIX) as listener:
            listener.bind(os.path.join(self.parts, "socket.step"))
        for arguments in ((), ("--retry", "--check-content")):
            status, summary, _ = self.batch("--time-limit", 30, *arguments)
            self.assertEqual((status, summary["states"]), (1, {"done": 2, "input": 4}))
            errors = {entry["part"]: entry["error"] for entry in self.lines() if entry["state"] == "input"}
            for name in ("pipe", "device", "folder", "socket"):
                said = [error for error in errors.values() if error.endswith(f"is a {name}, not a file")]
                self.assertEqual(len(said), 1, errors)

    def test_only_leaves_the_lines_of_others_alone(self):
        self.shape("cone.brep", Part.makeCone(5, 0, 10))
        self.shape("cone2.brep", Part.makeCone(5, 1, 10))
        self.batch()
        status, summary, _ = self.batch("--only", "cone*")
        self.assertEqual((status, summary["parts"], summary["worked_on"], summary["states"]), (0, 2, 0, {"done": 2}))
        self.assertEqual(set(self.states()), {"box.brep", "cone.brep", "cone2.brep"})
        self.batch("--only", "cone.*", "--min-angle", 20)
        self.assertEqual(set(self.states()), {"box.brep", "cone.brep", "cone2.brep"})
        page = Path(self.out, "report.html").read_text(encoding="utf-8")
        self.assertIn("3 of 3 parts", page)
        self.assertEqual(self.batch()[1]["worked_on"], 1)

    def test_files_of_others_are_left_alone(self):
        mine = os.path.join(self.out, "mine")
        os.makedirs(mine)
        left = os.path.join(self.out, files.UNFINISHED_OF_BATCH + "0123.part.ply")
        for name in (".thesis.part.doc", ".download.part", ".x.part"):
            Path(mine, name).write_text("x", encoding="ascii")
        Path(left).write_text("x", encoding="ascii")
        target = Path(self.out, "thesis.doc")
        target.write_text("x", encoding="ascii")
        os.symlink("thesis.doc", os.path.join(self.out, ".parts.jsonl.part"))
        self.batch()
        self.assertEqual(sorted(os.listdir(mine)), [".download.part", ".thesis.part.doc", ".x.part"])
        self.assertEqual(target.read_text(encoding="ascii"), "x")
        self.assertFalse(os.path.exists(left))

    def test_the_lock_is_no_way_to_other_files(self):
        os.mkdir(self.out)
        target = Path(self.out, "thesis.doc")
        target.write_text("x", encoding="ascii")
        os.symlink("thesis.doc", os.path.join(self.out, ".lock"))
        self.assertEqual(self.batch()[0], 1)
        self.assertEqual(target.read_text(encoding="ascii"), "x")

    def test_results_are_no_parts_by_whatever_path(self):
        Mesh.createBox(1, 2, 3).write(os.path.join(self.parts, "box.stl"))
        link = os.path.join(self.parts, "..", "link")
        os.symlink(self.parts, link)
        for out in (os.path.join(self.parts, "..", "parts", "out"), os.path.join(link, "out"),
                    os.path.join(self.parts, "sub", "..", "out")):
            for _ in range(2):
                status, _, err = run("batch", self.parts, "-o", out, "--command", "improve", "--jobs", 1)
                self.assertEqual(status, 0, err)
                self.assertIn("1 part done", err[-1])
        self.assertEqual(list(tree(os.path.join(self.parts, "out", "meshes"))), ["box.stl.ply"])
        status, _, err = run("batch", os.path.join(self.parts, "out", "meshes"), "-o", os.path.join(link, "out"),
                             "--command", "improve")
        self.assertEqual(status, 2)
        self.assertIn("of their own", err[-1])

    def test_a_damaged_line_costs_that_line(self):
        for i in range(5):
            self.shape(f"box{i}.brep", Part.makeBox(1, 2, 3 + i))
        self.batch()
        path = Path(self.out, "parts.jsonl")
        lines = path.read_bytes().splitlines(keepends=True)
        entry = json.loads(lines[4])
        entry["report"]["box"] = 3
        lines[:5] = [b'{"part": "x", garbage\n', b"[]\n", b"\xff\x00\xfe\n", lines[3][:100] + b"\n",
                     json.dumps(entry).encode() + b"\n"]
        path.write_bytes(b"".join([*lines, b"[" * 5000 + b"\n"]))
        status, summary, err = self.batch()
        self.assertEqual((status, summary["worked_on"], summary["states"]), (0, 5, {"done": 6}))
        self.assertEqual([f"line {i} is damaged" in line for i, line in zip((1, 2, 3, 4, 5, 7), err)], [True] * 6, err)
        self.assertEqual(len(self.lines()), 6)

    def test_who_holds_the_lock_is_said(self):
        self.shape("ball.brep", Part.makeSphere(5))
        batch = self.start("batch", self.parts, "-o", self.out, *ENDLESS)
        self.assertTrue(wait_until(lambda: os.path.exists(os.path.join(self.out, "parts.jsonl"))))
        status, _, err = run("batch", self.parts, "-o", self.out)
        self.assertEqual(status, 2)
        self.assertIn(f"(process {batch.pid} on {socket.gethostname()})", err[-1])

    def test_odd_names(self):
        names = [os.fsdecode(b"caf\xe9.brep"), "x" * 250 + ".brep", "new\nline.brep", "-o.brep"]
        for name in names:
            with open(os.path.join(self.parts, "box.brep"), "rb") as source, \
                    open(os.path.join(self.parts, name), "wb") as target:
                target.write(source.read())
        status, summary, err = self.batch()
        self.assertEqual((status, summary["states"]), (0, {"done": 5}), self.lines())
        for entry in self.lines():
            self.assertTrue(os.path.isfile(os.path.join(self.out, entry["output"])), entry["part"])
        self.assertEqual(self.batch()[1]["worked_on"], 0)


class FullDisk(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name
        self.path = os.path.join(self.folder, "mesh.ply")
        self.job = {"output": self.path, "ready": files.unfinished(self.path, ".ply"), "suffix": ".ply",
                    "scratch": self.folder}

    def full(self, path):
        Path(path).write_text("half", encoding="ascii")
        raise mq.IoError(f"cannot write '{path}'")

    def test_the_reason_is_said_and_nothing_is_left(self):
        with mock.patch.object(files, "disk_is_full", return_value=True), self.assertRaises(files.DiskFull) as caught:
            output_file.written(self.job, self.full)
        self.assertIn("the disk is full", str(caught.exception))
        self.assertEqual(os.listdir(self.folder), [])
        with self.assertRaises(mq.IoError) as caught:
            output_file.written(self.job, self.full)
        self.assertNotIn("full", str(caught.exception))

    def test_the_part_is_done_again_without_being_asked(self):
        task = {"bytes": 2**30}
        result = {"status": 1, "text": "the disk is full", "limit": "disk", "seconds": 1.0, "peak": 0}
        found = part._outcome(result, task)
        self.assertEqual(found["state"], part.DISK)
        chosen = plan.Plan(Path(self.folder), Path(self.folder, "out"), "triangulate", {}, ".ply", 1.0, 1.0)
        lines = ledger.Ledger(chosen)
        self.addCleanup(lines.close)
        one = plan.Part("a.step", 1, 1)
        entry = {"part": "a.step", "key": chosen.key, "size": 1, "mtime_ns": 1, "output": None, "digest": None,
                 "error": "e", "state": "failed"}
        lines.add(entry)
        self.assertEqual(lines.keep([one]), [])
        lines.add({**entry, "state": part.DISK})
        self.assertEqual(lines.keep([one]), [one])

    def test_an_error_of_the_system_is_known_by_its_number(self):
        self.assertTrue(files.is_full(OSError(errno.ENOSPC, "")))
        self.assertFalse(files.is_full(OSError(errno.EACCES, "")))
        with mock.patch.object(os, "fsync", side_effect=OSError(errno.ENOSPC, "")):
            self.assertTrue(files.disk_is_full(self.path))
        self.assertFalse(files.disk_is_full(self.path))
        self.assertEqual(os.listdir(self.folder), [])


class Outputs(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.brep = os.path.join(self.folder, "box.brep")
        Part.makeBox(1, 2, 3).exportBrep(self.brep)
        self.output = os.path.join(self.folder, "box.ply")

    def shell(self, line):
        """(exit status, stderr) of a line of shell, $M and $B stand for the command and the part."""
        done = subprocess.run(["bash", "-c", line], stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              stdout=subprocess.DEVNULL, timeout=120, env={**os.environ, "M": COMMAND, "B": self.brep})
        return done.returncode, done.stderr

    def test_a_replaced_file_keeps_mode_and_links(self):
        Path(self.output).write_text("old" * 10**6, encoding="ascii")
        os.chmod(self.output, 0o640)
        self.assertEqual(run("triangulate", self.brep, "-o", self.output)[0], 0)
        self.assertEqual(stat.S_IMODE(os.stat(self.output).st_mode), 0o640)
        other = os.path.join(self.folder, "other.ply")
        os.link(self.output, other)
        self.assertEqual(run("triangulate", self.brep, "-o", self.output, "--max-edge", 0.5)[0], 0)
        self.assertTrue(os.path.samefile(self.output, other))
        self.assertGreater(Mesh.Mesh(other).CountFacets, 12)
        self.assertEqual(sorted(os.listdir(self.folder)), ["box.brep", "box.ply", "other.ply"])

    @unittest.skipUnless(os.geteuid() == 0, "only root can give a file to somebody else")
    def test_a_replaced_file_keeps_its_owner(self):
        Path(self.output).write_text("old", encoding="ascii")
        os.chown(self.output, 1234, 1235)
        self.assertEqual(run("triangulate", self.brep, "-o", self.output)[0], 0)
        self.assertEqual((os.stat(self.output).st_uid, os.stat(self.output).st_gid), (1234, 1235))
        self.assertEqual(Mesh.Mesh(self.output).CountFacets, 16)

    def test_devices_pipes_and_folders(self):
        status, _, err = run("triangulate", self.brep, "-o", "/dev/null", "--format", "ply")
        self.assertEqual(status, 0, err)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))
        for command, name in (("triangulate", "ply"), ("curve", "msh"), ("curve", "vtu")):
            status, _, err = run(command, self.brep, "-o", "/dev/full", "--format", name)
            self.assertEqual(status, 1)
            self.assertIn("the disk is full", err[-1])
        status, _, err = run("triangulate", self.brep, "-o", self.folder, "--format", "ply")
        self.assertEqual(status, 2)
        self.assertIn("is a folder", err[-1])
        pipe = os.path.join(self.folder, "pipe.step")
        os.mkfifo(pipe)
        status, _, err = run("triangulate", pipe)
        self.assertEqual(status, 2)
        self.assertIn("is a pipe, not a file", err[-1])

    def test_names_that_are_long_or_not_utf8(self):
        for name in ("x" * 249 + ".ply", "x" * 251 + ".ply", os.fsdecode(b"caf\xe9.ply")):
            path = os.path.join(self.folder, name)
            status, _, err = run("triangulate", self.brep, "-o", path)
            self.assertEqual(status, 0, err)
            self.assertGreater(os.path.getsize(path), 100)
            os.unlink(path)
        odd = os.path.join(self.folder, os.fsdecode(b"caf\xe9.brep"))
        os.rename(self.brep, odd)
        status, out, err = run("triangulate", odd, "--json")
        self.assertEqual((status, json.loads(out)["triangles"]), (0, 16), err)

    def test_writing_from_python(self):
        mesh = mq.triangulate(Part.makeBox(1, 2, 3))
        for given in (mesh, mq.curve(Part.makeBox(1, 2, 3))):
            with self.assertRaises(mq.IoError) as caught:
                given.write(os.path.join(self.folder, "a\0b.msh"))
            self.assertIn("NUL", str(caught.exception))
        path = os.path.join(self.folder, os.fsdecode(b"caf\xe9.stl"))
        mesh.write(path)
        self.assertEqual(os.path.getsize(path), 84 + 16 * 50)
        self.assertEqual(len(os.listdir(self.folder)), 2)

    def test_closed_and_full_streams_end_with_1(self):
        for redirection in (">&-", "2>&-", ">/dev/full", "2>/dev/full"):
            with self.subTest(redirection):
                self.assertEqual(self.shell(f'"$M" triangulate "$B" --json {redirection}')[0], 1)
        self.assertIn("could not be written", self.shell('"$M" triangulate "$B" --json >&-')[1])
        self.assertEqual(self.shell('"$M" triangulate "$B" --json')[0], 0)

    def test_no_folder_for_temporary_files(self):
        status, err = self.shell('TMPDIR=/dev/null/none "$M" triangulate "$B"')
        self.assertEqual(status, 1)
        self.assertIn("TMPDIR names '/dev/null/none'", err)
