# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a document object has to compute, and results that were computed in the background."""

from contextlib import contextmanager
from functools import cached_property

from ..frames import arrangement_of, frame_of

_handed = []


class Work:
    """What an object of these sources and options has to compute.

    kind     class of the object's proxy
    sources  document objects, or pairs (document object, path) as in frames
    values   checked options
    frame    where the container of the first source stands, see frames.frame_of
    arrangement  how those of the others stand to it, see frames.arrangement_of
    digest   digest() -> what the sources and the options were, in short
    compute  compute(progress) -> result, progress as for triangulate or None

    digest and compute touch no document, so that any thread may call them.
    """

    def __init__(self, kind, sources, values, digest, compute):
        self.kind, self.sources, self.values = kind, list(sources), values
        self._digest, self.compute = digest, compute
        known = [source for source in self.sources if source is not None]
        self.frame = frame_of(known[0]) if known else None
        self.arrangement = arrangement_of(known)

    def tell_apart(self, how):
        """Has the fingerprint say how it is computed, too."""
        digest = self._digest
        self._digest = lambda: f"{digest()} {how}"

    def result(self, progress):
        """What compute gives; the fingerprint is of what the sources were before."""
        _ = self.fingerprint
        return self.compute(progress)

    @cached_property
    def fingerprint(self):
        """Changes whenever a source or an option does; the same after saving and loading."""
        return self._digest()


@contextmanager
def handed_over(work, result):
    """Meanwhile an object of the same kind, sources and options takes this result."""
    _handed.append((work, result))
    try:
        yield
    finally:
        _handed.remove((work, result))


def result_for(kind, sources, values):
    """The (Work, result) that was handed over for such an object, or None."""
    for work, result in _handed:
        if (work.kind, work.sources, work.values) == (kind, list(sources), values):
            return work, result
    return None
