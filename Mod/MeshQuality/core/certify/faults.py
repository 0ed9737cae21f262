# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with a mesh of triangles, fault by fault."""

from dataclasses import dataclass

import numpy as np

from ... import fault_phrases, phrases
from ...compat import extension

MOST = 1_000_000  # pairs of triangles that are searched
_BY_CORE = {"pinched": "pinched vertex", "degenerate": "degenerate triangle", "crossing": "crossing pair of triangles",
            "touching": "touching pair of triangles"}


@dataclass(frozen=True)
class Faults:
    """The faults of one kind.

    kind       of fault_phrases.FAULTS
    triangles  int32 (n, 2): one or two triangles at each fault; -1 beside one alone
    """

    kind: str
    triangles: np.ndarray

    def words(self):
        """How many there are, a Text."""
        said = phrases.counted(fault_phrases.FAULTS[self.kind], len(self.triangles))
        return phrases.Text(fault_phrases.AT_LEAST, phrase=said) if len(self.triangles) >= MOST else said


def find_faults(surface, progress=None):
    """[Faults, ...] of a core.Surface, of those kinds that it has, found exactly. Raises Cancelled."""
    triangles = np.asarray(surface.triangles)
    found = dict(_at_edges(triangles))
    corners = np.sort(triangles, axis=1)
    _, first, same = np.unique(corners, axis=0, return_index=True, return_inverse=True)
    first = first[same.ravel()]  # by triangle: the first triangle with the same corners
    later = np.flatnonzero(first != np.arange(len(triangles)))
    found["duplicate"] = np.column_stack((later, first[later]))
    by_core = extension().faults(surface, MOST, progress)
    for kind, name in _BY_CORE.items():
        pairs = by_core[name]
        if kind in ("crossing", "touching"):
            pairs = pairs[first[pairs[:, 0]] != first[pairs[:, 1]]]  # duplicates are told already
        found[kind] = pairs
    return [Faults(kind, found[kind]) for kind in fault_phrases.FAULTS if len(found[kind])]


def _at_edges(triangles):
    """(kind, int (n, 2)) of the faults that show in the number and the directions of triangles at edges."""
    sides = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2).astype(np.int64)
    owner = np.repeat(np.arange(len(triangles)), 3)
    sound = sides[:, 0] != sides[:, 1]
    sides, owner = sides[sound], owner[sound]
    key = sides.min(axis=1) << 32 | sides.max(axis=1)
    order = np.argsort(key, kind="stable")
    _, start, count = np.unique(key[order], return_index=True, return_counts=True)
    owner, forward = owner[order], (sides[:, 0] < sides[:, 1])[order]
    second = np.where(count > 1, owner[np.minimum(start + 1, len(owner) - 1)], -1) if len(start) else start
    pairs = np.column_stack((owner[start], second))
    alike = (count == 2) & (forward[start] == forward[np.minimum(start + 1, len(forward) - 1)]) if len(start) else start > 0
    return ("open", pairs[count == 1]), ("nonmanifold", pairs[count > 2]), ("flipped", pairs[alike])
