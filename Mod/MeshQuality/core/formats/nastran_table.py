# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries of Nastran bulk data in columns, all lines at once."""

import numpy as np

_LINE, _HEAD, _SMALL, _WIDE, _END = 80, 8, 8, 16, 72
_BLANK = b" "
_DIGITS = np.zeros(256, dtype=bool)
_DIGITS[list(b"0123456789.")] = True
_SIGNS = np.zeros(256, dtype=bool)
_SIGNS[list(b"+-")] = True


class Unusual(Exception):
    """The entries are to be read line by line: they have commas, tabs, or what needs words."""


def tables_of(data):
    """[(name, bytes (entries, fields)), ...] of entries of a name with equally many lines, blanks around fields as they are.

    Raises Unusual.
    """
    if b"," in data or b"\t" in data:
        raise Unusual
    lines = [line for line in data.split(b"\n") if line.strip() and line[:1] != b"$"]
    if not lines or b"$" in b"".join(lines):
        raise Unusual
    text = np.array(lines, dtype=f"S{_LINE}")
    text = text.view(np.uint8).reshape(len(lines), _LINE)
    text = np.where(text == 0, ord(_BLANK), text)
    heads = np.ascontiguousarray(text[:, :_HEAD])
    following = np.isin(text[:, 0], list(b" +*"))
    if following[0] or ((text[:, 0] == ord(_BLANK)) & (heads != ord(_BLANK)).any(axis=1)).any():
        raise Unusual
    wide = np.where(following, text[:, 0] == ord("*"), (heads == ord("*")).any(axis=1))
    starts = np.flatnonzero(~following)
    counts = np.diff(np.append(starts, len(lines)))
    keys = heads[starts].view(np.uint64).ravel()
    found = []
    for key in np.unique(keys):
        of_name = keys == key
        name = key.tobytes().strip().rstrip(b"*").strip().upper()
        for count in np.unique(counts[of_name]).tolist():
            rows = starts[of_name & (counts == count)][:, None] + np.arange(count)
            if (wide[rows] != wide[rows[0, 0]]).any():
                raise Unusual
            width = _WIDE if wide[rows[0, 0]] else _SMALL
            fields = np.ascontiguousarray(text[rows][:, :, _HEAD:_END])
            found.append((name, fields.reshape(len(rows), -1, width)))
    return found


def blank(fields):
    """bool: which fields have nothing in them."""
    return (fields == ord(_BLANK)).all(axis=-1)


def whole_of(fields):
    """int64 of fields without blank ones; raises ValueError."""
    return _as_text(fields).astype(np.int64)


def floats_of(fields, number_of):
    """float64 of fields; blank ones are 0. `number_of` reads those with an exponent that has no letter, or a D."""
    odd = (_SIGNS[fields[..., 1:]] & _DIGITS[fields[..., :-1]]).any(axis=-1) | np.isin(fields, list(b"Dd")).any(axis=-1)
    text, found = _as_text(fields), np.zeros(fields.shape[:-1])
    plain = ~(odd | blank(fields))
    found[plain] = text[plain].astype(np.float64)
    found[odd] = [number_of(value.strip()) for value in text[odd].tolist()]
    return found


def _as_text(fields):
    fields = np.ascontiguousarray(fields)
    return fields.view(f"S{fields.shape[-1]}")[..., 0]
