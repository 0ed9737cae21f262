# SPDX-License-Identifier: LGPL-2.1-or-later
"""Input files of Abaqus and CalculiX: nodes, elements, sets of elements and surfaces of one part."""

import os
import re

import numpy as np

from ...errors import IoError
from ..elements import kinds
from ..elements.parts import REMEDY, Parts, Section, content, numbers_in, unsupported, whole, words_of

_LINES = {"B21": 2, "B31": 2, "B33": 2, "B23": 2, "B22": 3, "B32": 3, "T2D2": 2, "T3D2": 2, "T2D3": 3, "T3D3": 3, "R2D2": 2,
          "RB3D2": 2, "SAX1": 2, "SAX2": 3}
_SOLIDS = re.compile(r"(?:A|D|Q|)C3D(\d+)|SC(\d)R?|COH3D(\d)|F3D(\d)")
_FLATS = re.compile(r"(?:STRI|DS|S|M3D|R3D|SFM3D|CPS|CPEG|CPE|CAX|CGAX|DC2D|DCAX|AC2D|ACAX)(\d+)")
# Faces of kinds.FACES, in the order of S1, S2, ...
SIDES = {"tetrahedron": (0, 1, 3, 2), "hexahedron": (0, 5, 1, 3, 4, 2), "prism": (0, 1, 2, 4, 3),
         "pyramid": (4, 0, 2, 3, 1)}
_SURFACE = "_surface"  # follows the name of a patch in the names of its faces in our own files
_DEEPEST = 8


class _Reader:
    def __init__(self):
        self.parts = Parts(None, [], side_order=SIDES)
        self.points, self.numbers = [], []
        self.sets, self.surfaces, self.parts_seen = {}, {}, 0

    def read(self, path, depth=0):
        data = content(path).replace(b"\r", b"")
        if b"**" in data:
            data = re.sub(rb"^[ \t]*\*\*.*\n?", b"", data, flags=re.M)
        starts = [found.start() for found in re.finditer(rb"^[ \t]*\*", data, re.M)]
        if not starts:
            raise IoError("it has no keywords, such as *NODE: it is no input file of Abaqus")
        for start, end in zip(starts, [*starts[1:], len(data)]):
            line, _, body = data[start:end].partition(b"\n")
            while line.rstrip().endswith(b",") and body:
                more, _, body = body.partition(b"\n")
                line += more
            keyword, options = _options(words_of(line))
            self._keyword(keyword, options, body, (path, depth))

    def _keyword(self, keyword, options, body, place):
        path, depth = place
        if keyword == "NODE":
            self._nodes(body)
        elif keyword == "ELEMENT":
            self._elements(options, body)
        elif keyword == "ELSET":
            self._set(options, body)
        elif keyword == "SURFACE" and options.get("TYPE", "ELEMENT").upper() == "ELEMENT" and "NAME" in options:
            self._surface(options["NAME"], body)
        elif keyword == "PART":
            self.parts_seen += 1
            if self.parts_seen > 1:
                raise unsupported("several parts that number their nodes alike (*PART)")
        elif keyword == "SYSTEM" and body.strip():
            raise unsupported("nodes in a coordinate system of their own (*SYSTEM)")
        elif keyword == "INSTANCE" and body.strip():
            raise unsupported("an instance that is moved (*INSTANCE)")
        elif keyword == "INCLUDE":
            if depth >= _DEEPEST:
                raise IoError("it includes itself: take that *INCLUDE out")
            other = os.path.join(os.path.dirname(path), options.get("INPUT", ""))
            if not os.path.isfile(other):
                raise IoError(f"it includes '{options.get('INPUT', '')}', which is not there: put that file beside it")
            self.read(other, depth + 1)

    def _nodes(self, body):
        width = body.strip().partition(b"\n")[0].rstrip(b", \t").count(b",") + 1
        if not body.strip():
            return
        if not 3 <= width <= 7:
            raise IoError(f"*NODE has lines of {width} numbers: {REMEDY}")
        rows = _numbers(body, width, "*NODE")
        self.numbers.append(whole(rows[:, 0]))
        points = np.zeros((len(rows), 3))
        points[:, :min(width - 1, 3)] = rows[:, 1:4]
        self.points.append(points)

    def _elements(self, options, body):
        name = options.get("TYPE", "").upper()
        kind, count = _type(name)
        if not body.strip():
            return
        rows = whole(_numbers(body, count + 1, f"*ELEMENT of type {name}"))
        _check_rows(body, len(rows), f"*ELEMENT of type {name}")
        order = [0, 2, 1] if (kind, count) == ("line", 3) else kinds.from_convention(kind, count, kinds.RINGS)
        self.parts.sections.append(Section(kind, rows[:, 1:][:, order], rows[:, 0]))
        if "ELSET" in options:
            self._add(options["ELSET"], rows[:, 0])

    def _add(self, name, numbers):
        known = self.sets.setdefault(name.upper(), (name, []))
        known[1].append(np.asarray(numbers, dtype=np.int64))

    def _set(self, options, body):
        if "ELSET" not in options:
            raise IoError(f"*ELSET has no name: {REMEDY}")
        if "GENERATE" in options:
            for first, last, *step in (_row(line) for line in body.split(b"\n") if line.strip(b" ,\t")):
                if not 0 < (step or [1])[0] or not 0 <= last - first < 2**31:
                    raise IoError(f"*ELSET {options['ELSET']} has no elements by GENERATE: {REMEDY}")
                self._add(options["ELSET"], np.arange(first, last + 1, (step or [1])[0]))
        elif re.search(rb"[^\d\s,]", body):
            for word in re.split(rb"[,\n]", body):
                if word.strip():
                    self._add(options["ELSET"], self._members(words_of(word)))
        elif body.strip(b" ,\t\n"):
            self._add(options["ELSET"], whole(numbers_in(body.replace(b",", b" "))))

    def _members(self, word):
        """Elements by a number or by the name of a set."""
        if re.fullmatch(r"\d{1,10}", word):
            return np.array([int(word)])
        name = word.strip('"').upper()
        if name not in self.sets:
            raise IoError(f"it names the set of elements {word!r}, which is not there before: write that *ELSET first, or take the "
                          "name out")
        return np.concatenate(self.sets[name][1])

    def _surface(self, name, body):
        numbers, sides = self.surfaces.setdefault(name, ([], []))
        for line in body.split(b"\n"):
            words = [words_of(word) for word in line.split(b",")]
            if not words[0]:
                continue
            members = self._members(words[0])
            side = re.fullmatch(r"[SF]?(\d)", words[1].upper()) if len(words) > 1 else None
            numbers.append(members)
            sides.append(np.full(len(members), int(side[1]) if side else 0))

    def result(self):
        if not self.points:
            raise IoError("it has no *NODE: it is cut off, or no mesh")
        self.parts.points, self.parts.point_numbers = _last_of_each(np.concatenate(self.points), np.concatenate(self.numbers))
        solids = {"tetrahedron", "pyramid", "prism", "hexahedron"}
        volumes = np.concatenate([np.zeros(0, dtype=np.int64), *(section.numbers for section in self.parts.sections
                                                                 if section.kind in solids)])
        for name, (numbers, sides) in self.surfaces.items():
            self._take_surface(name, np.concatenate([*numbers, np.zeros(0, dtype=np.int64)]),
                               np.concatenate([*sides, np.zeros(0, dtype=np.int64)]), volumes)
        for name, lists in self.sets.values():
            self.parts.add_to_group(name, np.concatenate(lists))
        return self.parts

    def _take_surface(self, name, numbers, sides, volumes):
        """A surface as a group; one that our own files have beside the set of the same elements has its name."""
        base = name[:-len(_SURFACE)].upper() if name.lower().endswith(_SURFACE) else None
        if base in self.sets and set(numbers.tolist()) == set(np.concatenate(self.sets[base][1]).tolist()):
            name = self.sets.pop(base)[0]
        of_volume = np.isin(numbers, volumes)
        if of_volume.any():
            if (sides[of_volume] == 0).any():
                raise unsupported(f"surface {name!r} without the sides of its elements")
            self.parts.sides.append((name, numbers[of_volume], sides[of_volume]))
        self.parts.add_to_group(name, numbers[~of_volume])


def _last_of_each(points, numbers):
    """Nodes that are given again replace those before."""
    if len(np.unique(numbers)) == len(numbers):
        return points, numbers
    found, first = np.unique(numbers[::-1], return_index=True)
    return points[::-1][first], found


def _row(line):
    return whole(numbers_in(line.replace(b",", b" "))).tolist()


def _numbers(body, width, what):
    values = numbers_in(body.replace(b",", b" ").translate(bytes.maketrans(b"Dd", b"ee")))
    if len(values) % width:
        raise IoError(f"{what} lacks numbers: it has {len(values):,}, which are not rows of {width}; {REMEDY}")
    return values.reshape(-1, width)


def _check_rows(body, count, what):
    """Raises IoError where lines do not end with elements: some programs write more nodes than a type has."""
    lines = [line.rstrip() for line in body.split(b"\n") if line.strip()]
    if count not in (len(lines), sum(not line.endswith(b",") for line in lines)):
        raise IoError(f"{what} has other numbers of nodes than elements of this type have: {REMEDY}")


def _options(line):
    """(keyword, {option: value})."""
    first, *others = line.split(",")
    pairs = (other.partition("=") for other in others)
    return " ".join(first.strip().lstrip("*").upper().split()), {key.strip().upper(): value.strip().strip('"')
                                                                 for key, _, value in pairs}


def _type(name):
    if name in _LINES:
        return "line", _LINES[name]
    if name == "STRI65":
        return "triangle", 6
    for pattern, known in ((_SOLIDS, kinds.SOLID_OF), (_FLATS, {**kinds.FLAT_OF, 9: "quadrilateral"})):
        found = pattern.match(name)
        count = int(next(filter(None, found.groups()))[:2]) if found else 0
        if count in known:
            return known[count], count
    raise unsupported(f"elements of type {name or 'no name'}")


def read(path):
    """The Parts of a file."""
    reader = _Reader()
    reader.read(path)
    return reader.result()
