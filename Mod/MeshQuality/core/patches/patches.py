# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches: named groups of the faces of a shape, by which files for solvers and printers tell triangles apart."""

import colorsys
import re
from typing import NamedTuple

import numpy as np

from ... import phrases
from ...errors import InvalidInput
from ...phrases import Text
from ..sources import convert

_FACE = re.compile(r"Face([1-9][0-9]{0,8})")
_COLOUR = re.compile(r"#([0-9a-fA-F]{2})([0-9a-fA-F]{2})([0-9a-fA-F]{2})")
_NO_FACE = "Surface"  # the patch of triangles that lie on no face of a shape
_GOLDEN = 0.618034  # step on the circle of hues, with which neighbours in the list differ most


class Division(NamedTuple):
    """Which face belongs to which patch: names, colours, {index of a face: index of its patch}, and the name of the patch
    of all other faces; None: each is one by its own name. These are `face_names`, "Face3" where there are none, and
    `no_face` of triangles on no face, index -1.
    """

    names: tuple = ()
    colours: tuple = ()
    patch_of: dict = {}
    rest: str = None
    face_names: tuple = ()
    no_face: str = _NO_FACE

    def own_name(self, index):
        """The name of the patch that a face by itself is."""
        if index < 0:
            return self.no_face
        return self.face_names[index] if index < len(self.face_names) else f"Face{index + 1}"

    def index_of(self, name):
        """The index of a face, "Face3" or by its own name; None for any other name."""
        if self.face_names and name in (*self.face_names, self.no_face):
            return -1 if name == self.no_face else self.face_names.index(name)
        found = _FACE.fullmatch(name)
        return int(found[1]) - 1 if found else None


_PLAIN = Division()


class Patches(NamedTuple):
    """The patches of a mesh: names, colours (red, green, blue) or None, and by triangle the index of its patch. `given`:
    they were asked for, by `division`.
    """

    names: tuple
    colours: tuple
    of_triangle: np.ndarray
    given: bool
    division: Division


def division_of(patches, rest=None, index_of=None, like=_PLAIN):
    """The Division of {"inlet": ["Face1", ...]} or {"inlet": {"faces": [...], "colour": "#ff0000"}}.

    `index_of` returns the index of a face by its name, or None; by default that of the Division `like`, whose names of
    faces the result keeps. None without patches and rest. Raises InvalidInput naming patch, face and remedy.
    """
    if patches is None and rest is None:
        return None
    if patches is not None and not hasattr(patches, "items"):
        raise InvalidInput(f"patches = {patches!r} is not possible: give a dict such as {{'inlet': ['Face1', 'Face4']}}")
    if rest is not None:
        _require_name(rest, phrases.PATCH_REST_NAME)
    names, colours, patch_of = [], [], {}
    for name, said in (patches or {}).items():
        _require_name(name, phrases.PATCH_NAME)
        faces, colour = _faces_and_colour(name, said)
        for face in faces:
            _add_face(patch_of, names, name, face, index_of or like.index_of)
        names.append(name)
        colours.append(colour)
    return like._replace(names=tuple(names), colours=tuple(colours), patch_of=patch_of, rest=rest)


def _require_name(name, phrase):
    if not isinstance(name, str) or not name.strip() or name != name.strip() or not name.isprintable():
        raise InvalidInput(Text(phrase, value=repr(name)))


def _faces_and_colour(name, said):
    colour = None
    if hasattr(said, "items"):
        unknown = sorted(set(said) - {"faces", "colour"})
        if unknown or "faces" not in said:
            raise InvalidInput(f"patch {name!r} needs 'faces' and may have a 'colour'"
                               + (f", not {unknown[0]!r}" if unknown else ""))
        colour = _colour_of(name, said.get("colour"))
        said = said["faces"]
    if isinstance(said, str) or not hasattr(said, "__iter__"):
        raise InvalidInput(f"patch {name!r} has {said!r} for its faces: give a list such as ['Face1', 'Face4']")
    return list(said), colour


def _colour_of(name, text):
    found = None if text is None else _COLOUR.fullmatch(str(text))
    if text is not None and not found:
        raise InvalidInput(f"patch {name!r} has the colour {text!r}: give it as '#rrggbb', such as '#ff0000'")
    return found and tuple(int(part, 16) for part in found.groups())


def _add_face(patch_of, names, name, face, index_of):
    index = index_of(face) if isinstance(face, str) else None
    if index is None:
        raise InvalidInput(Text(phrases.PATCH_NO_FACE, name=repr(name), value=repr(face)))
    if index in patch_of:
        other = (*names, name)[patch_of[index]]
        if other == name:
            raise InvalidInput(Text(phrases.PATCH_FACE_TWICE, face=face, name=repr(name)))
        raise InvalidInput(Text(phrases.PATCH_FACE_IN_TWO, face=face, name=repr(other), name2=repr(name)))
    patch_of[index] = len(names)


def division_for(source, patches, rest=None):
    """The Division for a shape or a document object, which must have the faces. Names are those of local sizes:
    "Box.Face3" of a container or a link.
    """
    division = division_of(patches, rest, lambda name: index_in(source, name))
    if division is not None and division.patch_of:
        require_faces(division, convert.shape_of(source).countElement("Face"), convert.label_of(source))
    return division


def index_in(source, name):
    """The index of a face of a shape or a document object by its name, as for division_for; None where it is no name of a
    face. Raises InvalidInput where the source does not hold it.
    """
    if not _FACE.fullmatch(name.rpartition(".")[2]):
        return None
    try:
        plain = next(iter(convert.resolve_sizes(source, {name: 1.0})))
    except InvalidInput:
        raise InvalidInput(Text(phrases.PATCH_ELSEWHERE, value=name, name=convert.label_of(source))) from None
    return _PLAIN.index_of(plain)


def kept(division, surface):
    """The Patches that a mesh of the core keeps; None without a division."""
    return None if division is None else patches_of(division, surface.triangle_face, len(surface.triangles))


def require_faces(division, count, what):
    """Raises InvalidInput where a patch names a face beyond the `count` ones of what is meshed."""
    if division is None:
        return
    for index, patch in division.patch_of.items():
        if index >= count:
            name, face = repr(division.names[patch]), f"Face{index + 1}"
            if count:
                raise InvalidInput(Text(phrases.PATCH_BEYOND, name=name, face=face, name2=what, face2=f"Face{count}"))
            raise InvalidInput(f"patch {name} names {face}, but {what} has no faces: take it out or name another one")


def patches_of(division, triangle_face, count):
    """The Patches of a mesh with `count` triangles on these faces; without a division each face is a patch."""
    given = division is not None
    division = division or _PLAIN
    face = np.asarray(triangle_face, dtype=np.int64)
    if not len(face):
        if division.patch_of:
            raise InvalidInput("patches name faces, but the mesh does not know those of a shape: take a mesh of "
                               "triangulate or curve, or leave patches out")
        face = np.full(count, -1, dtype=np.int64)
    most = int(face.max(initial=-1))
    # Index -1, the last one, is that of triangles on no face.
    patch = np.full(most + 2, -1, dtype=np.int32)
    for index, number in division.patch_of.items():
        if index <= most:
            patch[index] = number
    names, colours = list(division.names), list(division.colours)
    for index in np.unique(face).tolist():
        if patch[index] < 0:
            name = division.rest or division.own_name(index)
            if name in division.names and not division.rest:
                raise InvalidInput(Text(phrases.PATCH_LIKE_FACE, name=repr(name)))
            if name not in names:
                names.append(name)
                colours.append(None)
            patch[index] = names.index(name)
    return Patches(tuple(names), tuple(colours), patch[face], given, division)


def with_interfaces(patches, mesh, link="to"):
    """The Patches of a SurfaceMesh in which triangles between two solids are patches of their own: on the side of the
    first one "Solid1_to_Solid2", and "Solid2_to_Solid1" on the other, as solvers of several regions call them. `link`
    is the word between the solids.
    """
    opposite = mesh.triangle_opposite
    if not len(opposite):
        raise InvalidInput("no solid shares triangles with another one: mesh an assembly with imprint=True, or leave "
                           "interfaces out")
    here = np.flatnonzero(opposite >= 0)
    own, other = mesh.triangle_solid[here], mesh.triangle_solid[opposite[here]]
    pairs, number = np.unique(np.column_stack((own, other)), axis=0, return_inverse=True)
    names = [f"Solid{one + 1}_{link}_Solid{two + 1}" for one, two in pairs.tolist()]
    taken = next((name for name in names if name in patches.names), None)
    if taken:
        raise InvalidInput(f"patch {taken!r} has the name of an interface: give it another name")
    of_triangle = patches.of_triangle.copy()
    of_triangle[here] = len(patches.names) + number.reshape(-1)
    used = np.unique(of_triangle).tolist()  # the patch of a face that a contact covers is empty
    all_names, all_colours = [*patches.names, *names], [*patches.colours, *[None] * len(names)]
    return patches._replace(names=tuple(all_names[i] for i in used), colours=tuple(all_colours[i] for i in used),
                            of_triangle=np.searchsorted(used, of_triangle).astype(np.int32), given=True)


def colour_of(patches, i):
    """The colour of a patch, red, green, blue from 0 to 255: its own, or one that differs from its neighbours'."""
    if patches.colours[i]:
        return patches.colours[i]
    return distinct_colour(i)


def distinct_colour(i):
    """The colour of a patch that has none of its own, red, green, blue from 0 to 255."""
    return tuple(round(255 * part) for part in colorsys.hsv_to_rgb(i * _GOLDEN % 1.0, 0.55, 0.9))
