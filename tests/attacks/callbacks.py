# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress callbacks that return odd things, raise at each stage or call back in; threads that work at once."""

import ctypes
import gc
import os
import signal
import tempfile
import threading
import time

import Mesh
import numpy as np
import Part
from attack import Attack, Patience, Planted, check, survive

import FreeCAD
import MeshQuality as mq

LATENCY = 2.0  # seconds until a call ends in which a callback raised
MOST_CALLS = 60  # of a callback at which it raises


class Stubborn:
    """Raises when it is asked whether it is true."""

    def __bool__(self):
        raise Planted


class Length:
    """False by its length alone."""

    def __len__(self):
        return 0


class FalseSubclass(int):
    """0, but not False."""


RETURNS = {
    "None": None, "True": True, "1": 1, "0": 0, "0.0": 0.0, "NaN": float("nan"), "an empty text": "",
    "'False'": "False",
    "numpy.False_": np.False_, "numpy.True_": np.True_, "numpy 0": np.int8(0), "an array": np.zeros(3),
    "an empty array": np.zeros(0),
    "what raises": Stubborn(), "an empty list": [], "what has no length": Length(), "a class": int,
    "an int of its own": FalseSubclass(0),
    "NotImplemented": NotImplemented, "...": ..., "a dict": {"cancel": True}, "a lambda": lambda: False,
}
RAISED = {
    "KeyError": KeyError("mine"), "SystemExit": SystemExit(3), "KeyboardInterrupt": KeyboardInterrupt(),
    "StopIteration": StopIteration(),
    "GeneratorExit": GeneratorExit(), "MemoryError": MemoryError(), "RecursionError": RecursionError("mine"),
    "mq.Cancelled": mq.Cancelled("mine"), "mq.GeometryError": mq.GeometryError("mine"),
    "UnicodeError": UnicodeError("\ud800"),
    "what has no text": type("Mute", (Exception,), {"__str__": lambda self: 1 / 0})(),
    "a chain": None,
}
try:
    try:
        raise KeyError("first")
    except KeyError as first:
        raise ValueError("second") from first
except ValueError as second:
    RAISED["a chain"] = second


def _works():
    """{name: call(progress)} of every long call."""
    ball, box = Part.makeSphere(5), Part.makeBox(1, 1, 1)
    bored = Part.makeBox(10, 10, 10).cut(Part.makeCylinder(2, 30, FreeCAD.Vector(5, 5, -5)))
    one, other = mq.triangulate(ball, chord_height=0.05), mq.triangulate(Part.makeBox(7, 7, 7), chord_height=0.05)
    rough = Mesh.createSphere(5.0, 30)
    curved = mq.curve(ball, order=3)
    return {
        "triangulate": lambda progress: mq.triangulate(bored, chord_height=0.01, progress=progress),
        "star": lambda progress: mq.triangulate(ball, method="star", progress=progress),
        "sprinkle": lambda progress: mq.triangulate(ball, method="sprinkle", progress=progress),
        "boolean": lambda progress: mq.boolean(one, other, "union", progress=progress),
        "boolean of shapes": lambda progress: mq.boolean(ball, box, "difference", resolution=64, progress=progress),
        "uniform": lambda progress: mq.boolean(one, other, "union", method="uniform", resolution=64, progress=progress),
        "curve": lambda progress: mq.curve(bored, order=2, chord_height=0.1, progress=progress),
        "curve volume": lambda progress: mq.curve(ball, order=2, volume=True, chord_height=0.5, progress=progress),
        "improve": lambda progress: mq.improve(rough, progress=progress),
        "quality": lambda progress: mq.quality(one, ball, progress),
        "tessellate": lambda progress: curved.tessellate(0.0005, progress),
    }


def _fans(progress):
    """Many triangles at each end of an edge, more than are allowed."""
    return mq.triangulate(Part.makeBox(1, 1, 1), local_sizes={"Edge1": 3e-5}, max_triangles=30000, progress=progress)


def _returning(work, value):
    """What is not False goes on."""
    def attack():
        said = survive(lambda: work(lambda *_: value))
        check(isinstance(value, (Stubborn, np.ndarray, Length)) or value is np.False_ or said is not None or not value,
              "it was cancelled")

    return attack


def _raising(work, error, at):
    """At the call of this number what it raises comes out as it is, soon; the next call is a new one."""
    def attack():
        calls, raised = [], []

        def progress(*_):
            calls.append(1)
            if len(calls) == at:
                raised.append(time.monotonic())
                raise error

        try:
            work(progress)
        except BaseException as caught:  # noqa: BLE001 - that it is that very error is what is looked at
            check(caught is error, f"{caught!r} came out")
            check(time.monotonic() - raised[0] < LATENCY, "it ended late")
            check(len(calls) == at, f"called {len(calls) - at} times after it raised")
        else:
            check(not raised, "what it raised is lost")

    return attack


def _calls_of(work):
    """How often a work calls back, until it is told to end."""
    calls = []

    def count(*_):
        calls.append(1)
        return len(calls) < MOST_CALLS

    survive(lambda: work(count))
    return len(calls)


def _at_the_same_time(*works):
    """Threads that work at the same time get what each gets alone."""
    def attack():
        found, threads = {}, []
        for i, work in enumerate(works):
            def run(i=i, work=work):
                try:
                    found[i] = survive(lambda: work(Patience(8.0)))
                except BaseException as error:  # noqa: BLE001 - told to the thread that looks
                    found[i] = error

            threads.append(threading.Thread(target=run))
            threads[-1].start()
        for thread in threads:
            thread.join()
        for i, work in enumerate(works):
            check(not isinstance(found[i], BaseException), f"{found[i]!r}")
            alone = work(None)
            if hasattr(alone, "triangles") and found[i] is not None:
                check(np.array_equal(found[i].triangles, alone.triangles), "other triangles than alone")

    return attack


def _gc_storm(work):
    def attack():
        survive(lambda: work(lambda *_: gc.collect() and None))
        gc.set_threshold(1, 1, 1)
        try:
            survive(lambda: work(lambda *_: [[] for _ in range(50)] and None))
        finally:
            gc.set_threshold(700, 10, 10)

    return attack


def _again_within(work, inner):
    def attack():
        depth = []

        def progress(*_):
            if len(depth) < 3:
                depth.append(1)
                survive(lambda: inner(progress))

        survive(lambda: work(progress))

    return attack


def _cancelled_in_a_thread(work):
    """A call within the callback is cancelled, the outer one goes on."""
    def attack():
        inner = []

        def progress(*_):
            if not inner:
                inner.append(1)
                try:
                    work(lambda *_: False)
                except mq.Cancelled:
                    inner.append("cancelled")

        result = survive(lambda: work(progress))
        check("cancelled" not in inner or result is not None, "the outer call was cancelled, too")

    return attack


def _forked(work):
    """A child of a process whose engine runs: it works, says that it cannot, or at least ends."""
    def attack():
        survive(lambda: work(None))
        child = os.fork()
        if not child:
            signal.alarm(8)
            status = 3
            try:
                survive(lambda: work(Patience()))
                status = 0
            finally:
                os._exit(status)
        _, status = os.waitpid(child, 0)
        check(status == 0, f"the child ended with {status}")
        survive(lambda: work(None))

    return attack


def _interrupted(work, after):
    """Ctrl-C at some time: it comes out as KeyboardInterrupt, soon, or the work had ended."""
    def attack():
        interrupted = []

        def interrupt(*_):
            interrupted.append(time.monotonic())
            raise KeyboardInterrupt

        before = signal.signal(signal.SIGALRM, interrupt)
        try:
            signal.setitimer(signal.ITIMER_REAL, after)
            try:
                survive(lambda: work(lambda *_: None))
            except KeyboardInterrupt:
                check(time.monotonic() - interrupted[0] < LATENCY, "it ended late")
            finally:
                signal.setitimer(signal.ITIMER_REAL, 0)
        finally:
            signal.signal(signal.SIGALRM, before)
        survive(lambda: work(None))

    return attack


def _injected(work):
    """An exception that another thread puts into the one that works."""
    def attack():
        me, done = threading.get_ident(), threading.Event()

        def inject():
            if not done.wait(0.02):
                ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(me), ctypes.py_object(Planted))

        thread = threading.Thread(target=inject)
        thread.start()
        try:
            survive(lambda: work(lambda *_: None))
            done.set()
            thread.join()
            time.sleep(0)
        except Planted:
            done.set()
            thread.join()
        survive(lambda: work(None))

    return attack


def _recursion(work):
    """At the end of Python's stack."""
    def deeper(n):
        return deeper(n - 1) if n else survive(lambda: work(lambda *_: None))

    def attack():
        for depth in (900, 940, 960, 970, 980):
            try:
                deeper(depth)
            except RecursionError:
                return

    return attack


def _on_small_stack(work):
    def attack():
        before = threading.stack_size(65536)
        try:
            _at_the_same_time(work)()
        finally:
            threading.stack_size(before)

    return attack


def _writing_at_once():
    """Two threads write one file: it is one of the two in whole."""
    def attack():
        meshes = [mq.triangulate(Part.makeSphere(5), chord_height=h) for h in (0.01, 0.05)]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mesh.stl")
            threads = [threading.Thread(target=lambda m=mesh: [survive(lambda: m.write(path)) for _ in range(20)])
                       for mesh in meshes]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            sizes = {84 + 50 * len(mesh.triangles) for mesh in meshes}
            check(os.path.getsize(path) in sizes, "neither of the two")
            check(os.listdir(folder) == ["mesh.stl"], f"left: {os.listdir(folder)}")

    return attack


def rows():
    works, found = _works(), []
    for name, work in works.items():
        found += [Attack(f"{name}: returns {said}", _returning(work, value)) for said, value in RETURNS.items()]
        calls = _calls_of(work)
        times = sorted({1, 2, 3, *(1 + calls * k // 6 for k in range(7))})
        for i, at in enumerate(times):
            said = list(RAISED)[i % len(RAISED)]
            found.append(Attack(f"{name}: {said} at call {at}", _raising(work, RAISED[said], at)))
        found += [Attack(f"{name}: {said} at once", _raising(work, error, 1)) for said, error in RAISED.items()]
        found += [
            Attack(f"{name}: storms of garbage collection", _gc_storm(work)),
            Attack(f"{name}: the same within itself", _again_within(work, work)),
            Attack(f"{name}: a triangulation within", _again_within(work, works["triangulate"])),
            Attack(f"{name}: a Boolean within", _again_within(work, works["boolean"])),
            Attack(f"{name}: cancelled within", _cancelled_in_a_thread(work)),
            Attack(f"{name}: in two threads", _at_the_same_time(work, work), 20.0),
            Attack(f"{name}: beside a volume", _at_the_same_time(work, works["curve volume"]), 20.0),
            Attack(f"{name}: after a fork", _forked(work), 12.0),
            Attack(f"{name}: an exception from another thread", _injected(work)),
            Attack(f"{name}: at the end of the stack", _recursion(work)),
            Attack(f"{name}: on a stack of 64 KiB", _on_small_stack(work)),
        ]
        found += [Attack(f"{name}: Ctrl-C after {after} s", _interrupted(work, after)) for after in (0.001, 0.02, 0.1)]
    found += [Attack(f"fans at the limit of triangles: Ctrl-C after {after} s", _interrupted(_fans, after))
              for after in (0.02, 0.1, 0.5)]
    found.append(Attack("two threads write one file", _writing_at_once()))
    return found


def combined(dice):
    """A raising callback at a random call."""
    name, work = dice.choice(list(_works().items()))
    said, error = dice.choice(list(RAISED.items()))
    at = dice.randrange(1, MOST_CALLS)
    return Attack(f"{name}: {said} at call {at}", _raising(work, error, at))
