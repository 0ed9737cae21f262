# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of what a mesh is made of, numbered on through all of its sources, and the names by which patches have them."""

from typing import NamedTuple

from ... import phrases
from ...errors import InvalidInput
from ...phrases import Text
from ..sources import convert, frames
from .patch_names import plain_name
from .patches import Division, division_for, division_of, index_in

GAPS = "gaps"  # the patch of triangles that close gaps between sources


class Member(NamedTuple):
    """One of several sources: what its names begin with, the source, the index of its first face, and how many it has;
    None: it is a mesh, which is one face by the name of the source.
    """

    prefix: str
    source: object
    first: int
    count: int

    def index_of(self, name):
        """The index of a face by its full name; None where it is none of this source."""
        if self.count is None:
            return self.first if name == self.prefix[:-1] else None
        if not name.startswith(self.prefix):
            return None
        own = index_in(self.source, name[len(self.prefix):])
        if own is not None and own >= self.count:
            raise InvalidInput(Text(phrases.PATCH_ELSEWHERE, value=name, name=convert.label_of(self.source)))
        return None if own is None else self.first + own

    def name_of(self, index):
        """The inverse."""
        return self.prefix[:-1] if self.count is None else f"{self.prefix}Face{index - self.first + 1}"


class FacesOfOne:
    """Those of one source: "Face3", and "Box.Face3" below a container or a link."""

    def __init__(self, source):
        self.members = [Member("", source, 0, 0)]

    def division(self, patches, rest=None):
        """The Division; None where neither is given. Raises InvalidInput as division_for."""
        return division_for(self.members[0].source, patches, rest)

    def kept_name(self, name):
        """The name by which an object keeps a face."""
        return name


class FacesOfSeveral:
    """Those of a list of sources: "Box.Face3" and, below a container, "Part.Box.Face3", by the names of objects as in local
    sizes; a mesh is "Mesh". Names of patches are those that mq.wrap gives ("Box_Face3", by labels), and may stand for faces,
    too, as do numbers through all sources ("Face9"). "gaps" are the triangles between them.
    """

    def __init__(self, sources):
        self.members, first = [], 0
        counts = [_face_count(source) for source in sources]
        for source, count in zip(sources, counts):
            prefix = f"{frames.object_of(source).Name}.{frames.path_of(source)}"
            self.members.append(Member(prefix, source, first, count))
            first += 1 if count is None else count
        self._total = first
        self._own = Division(face_names=own_names([frames.object_of(source).Label for source in sources], counts),
                             no_face=GAPS)

    def division(self, patches, rest=None):
        """The Division, in which faces have names of their own where no patch is given."""
        return division_of(patches, rest, self.index_of, self._own) or self._own

    def index_of(self, name):
        """The index of a face by any of its names; None of another name."""
        own = self._own.index_of(name)
        if own is not None:
            if own >= self._total:
                raise InvalidInput(Text(phrases.PATCH_ELSEWHERE, value=name, name=self._labels()))
            return own
        for member in sorted(self.members, key=lambda member: -len(member.prefix)):
            own = member.index_of(name)
            if own is not None:
                return own
        if "." in name:
            raise InvalidInput(Text(phrases.PATCH_ELSEWHERE, value=name, name=self._labels()))
        return None

    def kept_name(self, name):
        """The name by which an object keeps a face: one that stays when other sources are added or taken away."""
        index = self._own.index_of(name)
        if index is None or index < 0:
            return name
        return next(member for member in reversed(self.members) if member.first <= index).name_of(index)

    def _labels(self):
        return ", ".join(convert.label_of(member.source) for member in self.members)


def own_names(labels, counts, kind="Face"):
    """The names of the patches that all faces are, each by itself, of sources with these numbers of faces; None: a mesh.
    They are names that all formats can hold (plain_name). Likewise of all solids; the only one of a source has its name.
    """
    if len(labels) == 1 and counts[0] is not None:
        return tuple(f"{kind}{k + 1}" for k in range(counts[0]))
    plain = [plain_name(label) for label in labels]
    names, taken = [], set()
    for i, (name, count) in enumerate(zip(plain, counts)):
        unique, number = name if plain.count(name) == 1 else f"{name}_{i + 1}", i + 1
        while (own := _of_one(unique, count, kind)) and not taken.isdisjoint(own):
            number += 1
            unique = f"{name}_{number}"
        taken.update(own)
        names += own
    return tuple(names)


def _of_one(name, count, kind):
    if count is None or (kind == "Solid" and count == 1):
        return [name]
    return [f"{name}_{kind}{k + 1}" for k in range(count)]


def _face_count(source):
    """How many faces a source has in a mesh that takes meshes, too."""
    if convert.is_mesh(source) or convert.meshes_in(source):
        return None
    return convert.own_shape_of(source).countElement("Face")
