# SPDX-License-Identifier: LGPL-2.1-or-later
"""The computation of a document object."""

from functools import cached_property

from ..core.sources.frames import arrangement_of, frame_of
from ..phrases import WAITS_FOR_KERNEL, Text

_COMPARING = Text(WAITS_FOR_KERNEL, stage="comparing the shape")


class Work:
    """The computation of an object with these sources and options.

    sources  document objects, or pairs (document object, path) as in frames
    values   checked options
    frame    where the container of the first source stands, see frames.frame_of
    arrangement  how those of the others stand to it, see frames.arrangement_of
    digest   digest() -> what the sources and the options were, in short
    compute  compute(progress) -> result, progress as for triangulate or None

    digest and compute touch no document, so that any thread may call them.
    """

    def __init__(self, sources, values, digest, compute):
        self.sources, self.values = list(sources), values
        self._digest, self.compute = digest, compute
        known = [source for source in self.sources if source is not None]
        self.frame = frame_of(known[0]) if known else None
        self.arrangement = arrangement_of(known)

    def is_for(self, sources, values):
        """Whether an object of these sources and options has this to compute."""
        return (self.sources, self.values) == (list(sources), values)

    def add_to_fingerprint(self, how):
        """Adds to the fingerprint how the result is computed."""
        digest = self._digest
        self._digest = lambda: f"{digest()} {how}"

    def result(self, progress):
        """The result of compute; the fingerprint is that of the sources before the call."""
        self.announced_fingerprint(progress)
        return self.compute(progress)

    def announced_fingerprint(self, progress):
        """The fingerprint; while it is computed, which nothing can interrupt, progress says so."""
        if progress is not None and "fingerprint" not in vars(self):
            progress(0.0, _COMPARING)
        return self.fingerprint

    @cached_property
    def fingerprint(self):
        """Changes whenever a source or an option does; the same after saving and loading."""
        return self._digest()
