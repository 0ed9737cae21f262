# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces of a source that an option names: found again after an edit as those of patches are, and as indices."""

import json
from typing import NamedTuple

from .. import phrases
from ..core.sources import convert
from ..errors import InvalidInput
from . import face_matching


class Said(NamedTuple):
    """The phrases for a face that may be another one after an edit, is none of the source, or has too large a number."""

    lost: str
    elsewhere: str
    beyond: str


class ChosenFaces:
    """The faces of a source by their present names.

    names      of the faces, such as "Face3", or "Box.Face3" below a container; None: none are chosen
    faces      the same as indices of the faces of the source's shape; None likewise
    described  what the faces are like, with the names, as text
    lost       sentences about faces that an edit may have exchanged
    """

    def __init__(self, source, names, before, said):
        """before: `described` of the last result"""
        self.names, self.lost, self.faces, self.described = names, [], None, ""
        if not names:
            return
        own = convert.own_shape_of(source)
        faces = face_matching.described(own)
        self.names, self.lost = _followed(names, before, faces, said)
        self.faces = sorted({int(_face_of(source, name, len(own.Faces), said)[4:]) - 1 for name in self.names})
        self.described = json.dumps({"names": self.names, "faces": faces})


def _followed(names, before, now, said):
    """(present names, sentences about those that are not found again).

    before  the described text of the last result; names that are others than there were chosen since
    now     what the faces are like
    """
    try:
        held = json.loads(before or "{}")
        places = face_matching.followed(held["faces"], now) if held.get("names") == names else None
        same = places is None
    except (ValueError, KeyError, TypeError, IndexError, AttributeError):  # edited by hand
        same = True
    if same:
        return names, []
    found, lost = [], []
    for name in names:
        index = places.get(int(name[4:]) - 1) if "." not in name else None
        if index is None and "." not in name:
            lost.append(phrases.Text(said.lost, face=name))
        found.append(name if index is None else f"Face{index + 1}")
    return found, lost


def _face_of(source, name, count, said):
    """The name "Face12" that a face has in the shape of the source, which has `count` faces."""
    label = convert.label_of(source)
    try:
        plain, = convert.resolve_sizes(source, {name: 1.0})
    except InvalidInput:
        raise InvalidInput(phrases.Text(said.elsewhere, value=name, name=label)) from None
    if int(plain[4:]) > count:
        raise InvalidInput(phrases.Text(said.beyond, value=name, name=label, face=f"Face{count}"))
    return plain
