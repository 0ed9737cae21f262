# SPDX-License-Identifier: LGPL-2.1-or-later
"""Odd arrays in the place of vertices and triangles."""

import contextlib
import os
import tempfile

import numpy as np
from attack import Attack, Planted, check, survive

import MeshQuality as mq

VERTICES = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=np.float64)
TRIANGLES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], dtype=np.int64)


class RaisingArray:
    """No array, in spite of what it says."""

    def __array__(self, *_, **__):
        raise Planted

    def __len__(self):
        return 4


class LyingLength(list):
    """Says that it is longer than it is."""

    def __len__(self):
        return 10**6


class OtherEachTime:
    """Gives fewer and fewer rows."""

    def __init__(self):
        self.left = 4

    def __len__(self):
        return 4

    def __getitem__(self, i):
        self.left -= 1
        if self.left < 0:
            raise IndexError
        return [0.0] * self.left


class Shrinking(np.ndarray):
    """A sub-class that gives other rows when it is sliced or converted."""

    def astype(self, *arguments, **values):
        return np.asarray(self)[:1].astype(*arguments, **values)


def _structured(array):
    return array.view([(name, array.dtype) for name in "xyz"])


def _itself():
    found = []
    found.append(found)
    return found


def _deep():
    found = 0.0
    for _ in range(60):
        found = [found]
    return found


def _widened(array, dtype):
    return np.ascontiguousarray(array.astype(dtype))


def _read_only(array):
    array = array.copy()
    array.setflags(write=False)
    return array


def _unaligned(array):
    raw = np.zeros(array.nbytes + 1, np.uint8)
    raw[1:] = np.frombuffer(array.tobytes(), np.uint8)
    return raw[1:].view(array.dtype).reshape(array.shape)


# What leaves the values as they are: the mesh is the same.
SAME = {
    "negative strides": lambda a: np.ascontiguousarray(a[::-1, ::-1])[::-1, ::-1],
    "Fortran order": np.asfortranarray,
    "read-only": _read_only,
    "byte-swapped": lambda a: a.astype(a.dtype.newbyteorder()),
    "every other row": lambda a: np.repeat(a, 2, axis=0)[::2],
    "every other column": lambda a: np.repeat(a, 2, axis=1)[:, ::2],
    "unaligned": _unaligned,
    "a matrix": np.matrix,
    "a list of arrays": list,
    "a tuple of tuples": lambda a: tuple(map(tuple, a.tolist())),
    "a view of a larger one": lambda a: np.pad(a, 3)[3:-3, 3:-3],
    "a memoryview": lambda a: memoryview(np.ascontiguousarray(a)),
    "a sub-class": lambda a: a.view(Shrinking).view(np.ndarray),
}
OTHER = {
    "no rows": lambda a: a[:0], "no columns": lambda a: a[:, :0],
    "zero-size of three dimensions": lambda a: a[:0, None],
    "0-d": lambda a: a[0, 0], "one dimension": np.ravel, "three dimensions": lambda a: a[None],
    "four columns": lambda a: np.pad(a, ((0, 0), (0, 1))), "two columns": lambda a: a[:, :2],
    "transposed": lambda a: a.T,
    "one row": lambda a: a[:1], "objects": lambda a: a.astype(object),
    "objects with None": lambda a: np.full_like(a, None, object),
    "structured": _structured, "record array": lambda a: _structured(a).view(np.recarray),
    "texts": lambda a: a.astype(str),
    "bytes": lambda a: a.astype("S8"), "void": lambda a: np.zeros(a.shape, "V8"), "bool": lambda a: a.astype(bool),
    "complex": lambda a: a + 0j, "datetime64": lambda a: a.astype("M8[s]"), "timedelta64": lambda a: a.astype("m8[s]"),
    "float16": lambda a: _widened(a, np.float16), "longdouble": lambda a: _widened(a, np.longdouble),
    "longdouble beyond double": lambda a: _widened(a, np.longdouble) * np.longdouble("1e4000"),
    "int8": lambda a: _widened(a, np.int8), "uint64": lambda a: _widened(a, np.uint64),
    "uint64 above int64": lambda a: _widened(a, np.uint64) + np.uint64(2**63),
    "uint64 that wraps around to small ones": lambda a: _widened(a, np.uint64) - np.uint64(1),
    "2**32 more": lambda a: a + 2**32, "2**31 more": lambda a: a + 2**31, "negative": lambda a: a - 10**6,
    "fractions": lambda a: a + 0.5, "NaN": lambda a: a * np.nan, "infinite": lambda a: a + np.inf,
    "one NaN": lambda a: np.where(np.arange(a.size).reshape(a.shape) == 5, np.nan, a), "1e300": lambda a: a * 1e300,
    "1e-300": lambda a: a * 1e-300, "denormal": lambda a: a * 5e-324, "-0.0": lambda a: a * -0.0,
    "beyond float32": lambda a: a * 1e39, "at the end of float32": lambda a: a * 3.4e38,
    "all the same": lambda a: a * 0,
    "a broadcast row": lambda a: np.broadcast_to(a[1], (1000, 3)), "an itself-holding list": lambda a: _itself(),
    "a deep list": lambda a: _deep(), "a ragged list": lambda a: [[0, 1, 2], [0, 1]],
    "a generator": lambda a: (r for r in a),
    "a dict": lambda a: dict(enumerate(a)), "a set": lambda a: {tuple(r) for r in a.tolist()}, "None": lambda a: None,
    "a raising array": lambda a: RaisingArray(), "a lying length": lambda a: LyingLength(a.tolist()),
    "rows that go": lambda a: OtherEachTime(), "a shrinking sub-class": lambda a: a.view(Shrinking),
    "an empty list": lambda a: [], "a list of None": lambda a: [[None] * 3],
    "a list of texts": lambda a: [["a", "b", "c"]],
    "a huge whole number": lambda a: [[10**400, 0, 0]] * 4, "a nested mesh": lambda a: (a, a),
    "a range": lambda a: range(12), "bytes of Python": lambda a: a.tobytes(), "a text": lambda a: "abc",
}
FACES = {
    "quality": mq.quality,
    "improve": mq.improve,
    "boolean": lambda given: mq.boolean(given, (VERTICES + 0.25, TRIANGLES), "union"),
}


def _same(name, call, change, which):
    def attack():
        given = [VERTICES.copy(), TRIANGLES.copy()]
        given[which] = change(given[which])
        result = survive(lambda: call(tuple(given)))
        check(result is not None, f"{name}: the same numbers were refused")
        expected = call((VERTICES, TRIANGLES))
        if isinstance(result, mq.SurfaceMesh):
            check((result.triangles == expected.triangles).all(), "other triangles than those of a plain array")
        else:
            check(result.volume == expected.volume, "another volume than that of a plain array")

    return attack


def _other(call, change, which):
    def attack():
        given = [VERTICES.copy(), TRIANGLES.copy()]
        if which == 0 or change(np.zeros((4, 3))) is not None:
            with np.errstate(all="ignore"):
                given[which] = change(given[which])
        survive(lambda: call(tuple(given)))

    return attack


def _on_file(call, which, end):
    """Arrays on a file that has got shorter since: to read them would end the process."""
    def attack():
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "array")
            given = [np.repeat(VERTICES, 1000, axis=0), TRIANGLES + np.zeros((1000, 1, 1), np.int64)]
            given[1] = given[1].reshape(-1, 3)
            given[which].tofile(path)
            given[which] = np.memmap(path, given[which].dtype, "r", shape=given[which].shape)
            os.truncate(path, end)
            survive(lambda: call(tuple(given)))
            given[which] = np.asarray(given[which])[10:, ::-1]  # a view of it
            survive(lambda: call(tuple(given)))

    return attack


def _changed_meanwhile(call):
    """Another thread writes into the arrays while they are read."""
    def attack():
        import threading

        vertices, triangles = np.tile(VERTICES, (5000, 1)), np.tile(TRIANGLES, (5000, 1))
        stop = threading.Event()

        def scribble():
            while not stop.is_set():
                triangles[:] = 10**9
                triangles[:] = 0
                vertices[:] = np.nan

        writer = threading.Thread(target=scribble)
        writer.start()
        try:
            with contextlib.suppress(AssertionError):  # what it reports is of other numbers by then
                survive(lambda: call((vertices, triangles)))
        finally:
            stop.set()
            writer.join()

    return attack


def rows():
    found = []
    for function, call in FACES.items():
        for which, array in enumerate(("vertices", "triangles")):
            found += [Attack(f"{function}, {array}: {name}", _same(name, call, change, which))
                      for name, change in SAME.items()]
            found += [Attack(f"{function}, {array}: {name}", _other(call, change, which))
                      for name, change in OTHER.items()]
            found += [Attack(f"{function}, {array}: a mapped file cut to {end} bytes", _on_file(call, which, end))
                      for end in (0, 5000)]
        found.append(Attack(f"{function}: arrays that are written to", _changed_meanwhile(call)))
    return found


def combined(dice):
    """An attack that changes both arrays."""
    changes = [dice.choice(list(OTHER.items()) + list(SAME.items())) for _ in range(2)]
    call = dice.choice(list(FACES.values()))

    def attack():
        with np.errstate(all="ignore"):
            try:
                given = tuple(change(array.copy()) for (_, change), array in zip(changes, (VERTICES, TRIANGLES)))
            except (TypeError, ValueError, OverflowError):
                return  # NumPy itself refuses to make it
        survive(lambda: call(given))

    return Attack(" and ".join(name for name, _ in changes), attack)
