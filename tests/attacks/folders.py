# SPDX-License-Identifier: LGPL-2.1-or-later
"""bin/meshquality batch: folders, ledgers and names that are odd, and workers that are killed."""

import contextlib
import json
import os
import random
import shutil
import signal
import time
from pathlib import Path

from attack import Attack, check
from command_line import NAMES
from place import ENDLESS, LIMIT, Place, parts, processes_with, wait_until_it_takes_signals

MANY = 10**4
BATCH = ("batch", "parts", "-o", "out", "--jobs", "2", "--time-limit", "20")


class Folder(Place):
    """A Place with a folder of parts: a box and a ball."""

    def __enter__(self):
        super().__enter__()
        self.parts, self.out = self.work / "parts", self.work / "out"
        self.parts.mkdir()
        for name in ("box.brep", "ball.brep"):
            shutil.copy(self.work / name, self.parts / name)
        return self

    def batch(self, *arguments, **options):
        """(status, states by part) of a batch; its ledger and the meshes that it names are whole."""
        status, _, _ = self.run(*BATCH, *arguments, **options)
        return status, self.states()

    def states(self):
        """{part: state}."""
        path, found = self.out / "parts.jsonl", {}
        if not path.is_file():
            return found
        for line in path.read_bytes().splitlines(keepends=True):
            if line.endswith(b"\n"):
                with contextlib.suppress(ValueError):
                    entry = json.loads(line)
                    found[entry["part"]] = entry["state"]
                    if entry["state"] == "done" and entry.get("output"):
                        check((self.out / entry["output"]).stat().st_size > 0, f"{entry['output']} is empty")
        return found

    def all_done(self, count=2, *arguments):
        status, states = self.batch(*arguments)
        check(status == 0 and set(states.values()) == {"done"} and len(states) == count, f"{status}: {states}")


def attack_of(act):
    def attack():
        with Folder() as place:
            act(place)

    return attack


def _names(place):
    """All odd names at once, in odd folders, too."""
    count, box = 2, (parts() / "box.brep").read_bytes()
    for i, name in enumerate(NAMES.values()):
        given = name if isinstance(name, bytes) else name.encode()
        folder = os.fsencode(place.parts) + b"/" + (given if i % 2 else b"")
        if given.startswith(b"."):
            continue
        os.makedirs(folder, exist_ok=True)
        with open(folder + b"/" + given + b".brep", "wb") as stream:
            stream.write(box)
        count += 1
    place.all_done(count)


def _case(place):
    for name in ("Box.brep", "BOX.BREP", "box.Brep"):
        shutil.copy(place.work / "box.brep", place.parts / name)
    place.all_done(5)


def _one_stem(place):
    for name in ("box.step", "box.FCStd"):
        shutil.copy(place.work / name, place.parts / name)
    place.all_done(4)


def _empty_files(place):
    for i in range(60):
        (place.parts / f"e{i}.brep").touch()
    _, states = place.batch()
    check(len(states) == 62 and states["box.brep"] == "done", f"{len(states)} lines")


def _others(place):
    for i in range(MANY):
        (place.parts / f"{i}.txt").touch()
    place.all_done()


def _deep(place):
    folder = place.parts
    for _ in range(60):
        folder = folder / "a"
        folder.mkdir()
    shutil.copy(place.work / "box.brep", folder / "deep.brep")
    place.all_done(3)


def _loops(place):
    (place.parts / "again").symlink_to(place.parts)
    (place.parts / "loop.brep").symlink_to("loop.brep")
    (place.parts / "gone.brep").symlink_to("nowhere")
    _, states = place.batch()
    check(states["box.brep"] == "done" and states.get("loop.brep") == "input", f"{states}")


def ledger(content, then=None):
    """A ledger as it stands before the batch."""
    def act(place):
        place.batch()
        path = place.out / "parts.jsonl"
        lines = path.read_bytes().splitlines(keepends=True)
        path.write_bytes(content(lines))
        status, states = place.batch()
        check(states.get("box.brep") == "done" and states.get("ball.brep") == "done", f"{status}: {states}")

    return act


def _of_the_future(lines):
    found = []
    for line in lines:
        entry = json.loads(line)
        entry.update(version=99, key="x" * 64, report={"new": [1] * 1000}, unknown={"deep": [[]]})
        found.append(json.dumps(entry).encode() + b"\n")
    return b"".join(found)


def _changed(**changes):
    return lambda lines: b"".join(json.dumps({**json.loads(line), **changes}).encode() + b"\n" for line in lines)


LEDGERS = {
    "of the future": _of_the_future, "empty": lambda lines: b"", "all zeros": lambda lines: bytes(4096),
    "without a last line end": lambda lines: b"".join(lines)[:-1],
    "every line a thousand times": lambda lines: b"".join(lines * 1000),
    "one line of 8 MB": lambda lines: b"[" * 8_000_000 + b"\n" + b"".join(lines),
    "a state that is none": _changed(state="excellent"), "a size below 0": _changed(size=-1),
    "times in the future": _changed(mtime_ns=2**70), "an output outside": _changed(output="../../../etc/passwd"),
    "an absolute output": _changed(output="/etc/passwd"), "an output that is a folder": _changed(output="meshes"),
    "an output of NUL": _changed(output="a\0b"), "a part outside": _changed(part="../box.brep"),
    "a part of surrogates": _changed(part="\udcff"),
    "NaN": lambda lines: b"".join(lines).replace(b'"size": ', b'"size": NaN, "x": '),
    "Windows line ends": lambda lines: b"".join(line[:-1] + b"\r\n" for line in lines),
    "a BOM": lambda lines: b"\xef\xbb\xbf" + b"".join(lines),
}


def in_place_of(name, make):
    """Something else where the batch wants to have a file or a folder of its own."""
    def act(place):
        place.out.mkdir(exist_ok=True)
        make(place.out / name)
        place.batch()

    return act


def _fifo(path):
    os.mkfifo(path)


def _device(path):
    path.symlink_to("/dev/full")


def _to_thesis(path):
    """A link to a file that belongs to somebody: `digests` sees that it stays."""
    path.symlink_to("../cube.stl")


def _folder_with_files(path):
    path.mkdir()
    (path / "mine.txt").write_text("mine", encoding="ascii")


IN_PLACE = {"a folder": _folder_with_files, "a pipe": _fifo, "/dev/full": _device,
            "a link to a file of mine": _to_thesis, "a link to nowhere": lambda path: path.symlink_to("nowhere/x"),
            "a link to itself": lambda path: path.symlink_to(path.name),
            "a read-only file": lambda path: (path.write_text("x"), path.chmod(0))}


def ended(number, after):
    """Told to end in the middle, then run again: nothing is lost, all is done."""
    def act(place):
        process = place.start(*BATCH)
        wait_until_it_takes_signals(process)
        time.sleep(after)
        process.send_signal(number)
        try:
            _, err = process.communicate(timeout=LIMIT)
        finally:
            process.kill()
            process.wait()
        text = err.decode(errors="replace")
        if number == signal.SIGKILL:
            end = time.monotonic() + 3.0
            while processes_with(place.mark) and time.monotonic() < end:
                time.sleep(0.02)
            check(not processes_with(place.mark), "a process outlives the batch")
            for path in place.temporary.iterdir():  # nobody was there to do it
                shutil.rmtree(path, ignore_errors=True)
        else:
            place.ended(process.returncode, "", text)
        place.all_done()
        left = [path.name for path in place.out.rglob(".meshquality*")]
        check(not left, f"left: {left}")

    return act


def killed_workers(seed, number=signal.SIGKILL):
    """Random FreeCADs of the batch are ended while it runs."""
    def act(place):
        dice = random.Random(seed)
        for i in range(6):
            shutil.copy(place.work / "box.brep", place.parts / f"box{i}.brep")
        process = place.start(*BATCH)
        end = time.monotonic() + 2.5
        killed = 0
        while process.poll() is None and time.monotonic() < end:
            time.sleep(dice.uniform(0.05, 0.4))
            others = [pid for pid in processes_with(place.mark) if pid != process.pid and _is_freecad(pid)]
            if others and killed < 3:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(dice.choice(others), number)
                killed += 1
        try:
            _, err = process.communicate(timeout=LIMIT)
        finally:
            process.kill()
            process.wait()
        place.ended(process.returncode, "", err.decode(errors="replace"))
        place.all_done(8, "--retry")

    return act


def _is_freecad(pid):
    with contextlib.suppress(OSError):
        return b"worker_loop.py" in Path("/proc", str(pid), "cmdline").read_bytes()
    return False


def _two_at_once(place):
    one, other = place.start(*BATCH), place.start(*BATCH)
    statuses = []
    for process in (one, other):
        process.communicate(timeout=LIMIT)
        statuses.append(process.returncode)
    check(0 in statuses and set(statuses) <= {0, 2}, f"{statuses}")
    place.ended(0, "", "")
    check(place.states().get("ball.brep") == "done", f"{place.states()}")


def _out_vanishes(place):
    process = place.start(*BATCH, *ENDLESS[:2])
    wait_until_it_takes_signals(process)
    time.sleep(1.2)
    shutil.rmtree(place.out, ignore_errors=True)
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=LIMIT)
    place.ended(process.returncode, "", err.decode(errors="replace"))


def _parts_vanish(place):
    process = place.start(*BATCH)
    time.sleep(0.5)
    shutil.rmtree(place.parts)
    _, err = process.communicate(timeout=LIMIT)
    place.ended(process.returncode, "", err.decode(errors="replace"))


def _changes_between(place):
    """Another content with the same size and time is found where it is asked for."""
    place.all_done()
    path = place.parts / "box.brep"
    status, data = path.stat(), path.read_bytes()
    path.write_bytes(data.replace(b"3", b"4", 1))
    os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))
    place.all_done(2, "--check-content")


def _time_moves(place):
    for seconds in (0, 4102444800, -10**9):
        os.utime(place.parts / "box.brep", (seconds, seconds))
        place.all_done()


def _output_is_read_only(place):
    place.all_done()
    mesh = place.out / "meshes" / "box.brep.ply"
    mesh.unlink()
    mesh.mkdir()
    (mesh / "mine").write_text("mine", encoding="ascii")
    _, states = place.batch()
    check((mesh / "mine").exists() and states["ball.brep"] == "done", f"{states}")


ARGUMENTS = {"only of nothing": ("--only", ""), "only of brackets": ("--only", "[[[!*?"),
             "only of 10^5": ("--only", "*" * 3000), "0 jobs": ("--jobs", "0"), "10^6 jobs": ("--jobs", "1000000"),
             "half a job": ("--jobs", "0.5"),
             "no time": ("--time-limit", "1e-9"), "no memory": ("--memory-limit", "0.001"),
             "a scheduler of nothing": ("--scheduler", ""), "a scheduler of text": ("--scheduler", "tcp://"),
             "a scheduler nobody is at": ("--scheduler", "tcp://127.0.0.1:1"),
             "a format of none": ("--format", "doc"), "a command of none": ("--command", "batch"),
             "an option of another command": ("--command", "improve", "--order", "3")}


def rows():
    found = [Attack(f"batch: {act.__name__.strip('_').replace('_', ' ')}", attack_of(act)) for act in (
        _names, _case, _one_stem, _empty_files, _others, _deep, _loops, _two_at_once, _out_vanishes, _parts_vanish,
        _changes_between, _time_moves, _output_is_read_only)]
    found += [Attack(f"batch: a ledger {name}", attack_of(ledger(content))) for name, content in LEDGERS.items()]
    found += [Attack(f"batch: {said} in the place of {name}", attack_of(in_place_of(name, make)))
              for name in ("parts.jsonl", ".lock", "meshes", "report.html") for said, make in IN_PLACE.items()]
    dice = random.Random(5)
    found += [Attack(f"batch: {signal.Signals(number).name} after {after:.2f} s", attack_of(ended(number, after)))
              for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP,
                             signal.SIGKILL) for after in (dice.uniform(0.2, 0.6), dice.uniform(0.7, 1.3))]
    found += [Attack(f"batch: FreeCADs killed, seed {seed}", attack_of(killed_workers(seed))) for seed in (1, 2)]
    found += [Attack("batch: FreeCADs that crash", attack_of(killed_workers(3, signal.SIGSEGV)))]
    found += [Attack(f"batch: {said}", attack_of(lambda place, a=arguments: place.batch(*a))) for said,
              arguments in ARGUMENTS.items()]
    return found
