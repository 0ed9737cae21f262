# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size fields of points with sizes: arrays and files of columns."""

import csv
import os

import numpy as np

from ...errors import InvalidInput, IoError
from .interpolated import Interpolated, require_sizes

COLUMNS = ("x", "y", "z", "size")


def from_rows(rows, name):
    """The field of rows x, y, z, size in mm."""
    try:
        array = np.array(rows, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InvalidInput(f"{name} is no array of numbers ({error})") from error
    if array.ndim != 2 or array.shape[1] != 4 or not len(array):
        raise InvalidInput(f"{name} has the shape {array.shape}: points with sizes are an array (n, 4) of x, y, z and size in mm, "
                           "n at least 1")
    points, sizes = np.ascontiguousarray(array[:, :3]), np.ascontiguousarray(array[:, 3])
    if not np.isfinite(points).all():
        row = int(np.argmax(~np.isfinite(points).all(axis=1)))
        raise InvalidInput(f"{name}: row {row + 1} has the place {points[row].tolist()}: coordinates must be numbers")
    require_sizes(points, sizes, name)
    if not np.isfinite(sizes).all():
        raise InvalidInput(f"{name}: row {int(np.argmax(~np.isfinite(sizes))) + 1} has an infinite size: leave such points out")
    simplices = np.full((len(points), 4), -1, dtype=np.int32)
    simplices[:, 0] = np.arange(len(points))
    return Interpolated(points, simplices, sizes, name)


def from_csv(path):
    """The field of a file with a line of names, among which are x, y, z and size; comma, semicolon, tabulator or blanks
    between the columns.
    """
    name = f"'{path}'"
    if not os.path.isfile(path):
        raise IoError(f"cannot read {name}: there is no such file")
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            text = file.read()
    except (OSError, UnicodeDecodeError) as error:
        raise IoError(f"cannot read {name}: {error}") from error
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    if not lines:
        raise InvalidInput(f"{name} is empty: give it the columns {', '.join(COLUMNS)}")
    split = _splitter(lines[0])
    names = [word.strip().strip('"').lower() for word in split(lines[0])]
    missing = [column for column in COLUMNS if column not in names]
    if missing:
        raise InvalidInput(f"{name} lacks the column{'s' if len(missing) > 1 else ''} {', '.join(missing)}: its first line names "
                           f"{', '.join(names)}, and must name {', '.join(COLUMNS)}")
    places, rows = [names.index(column) for column in COLUMNS], []
    for number, line in enumerate(lines[1:], 2):
        words = split(line)
        try:
            rows.append([float(words[place]) for place in places])
        except (ValueError, IndexError) as error:
            raise InvalidInput(f"{name}: row {number} is {line.strip()[:80]!r}: it must have numbers in the columns "
                               f"{', '.join(COLUMNS)}") from error
    if not rows:
        raise InvalidInput(f"{name} has no rows below its names: give points with sizes")
    return from_rows(rows, name)


def _splitter(line):
    for mark in (",", ";", "\t"):
        if mark in line:
            return lambda text: next(csv.reader([text], delimiter=mark))
    return str.split
