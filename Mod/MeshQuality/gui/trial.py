# SPDX-License-Identifier: LGPL-2.1-or-later
"""The estimate of how many triangles a quality mesh will have: it is tried."""

import time

from ..errors import Cancelled

_MOMENT = 2.0  # s
_LIMIT = 50_000  # triangles


class Trial:
    """For a moment it is the work itself, whose result then need not be computed again; where that does
    not suffice, the same with a limit on the number of triangles.

    kind, sources, values   of the work
    obj                     the document object that is edited, or None
    """

    def __init__(self, kind, sources, values, obj=None):
        # The cache of an object has a say in its triangles, and belongs to its own work.
        alone = getattr(getattr(obj, "Proxy", None), "cache", None) is None
        self._work = kind.work_on(sources, values, obj) if alone else None
        limit = min(_LIMIT, values["max_triangles"] or _LIMIT)
        self._limited = kind.work_on(sources, {**values, "max_triangles": limit})
        self._all = limit == values["max_triangles"]
        self._result = None  # of the work, once it has been computed
        self.triangles, self.complete = 0, False

    def compute(self, progress):
        """Fills `triangles` and `complete`, whether there are no more than these; on any thread."""
        if self._work is not None:
            self._result = self._for_a_moment(progress)
        report = (self._limited.result(progress) if self._result is None else self._result)[0].report
        self.complete = self._result is not None or self._all or report.complete
        self.triangles = report.triangles if self.complete else _LIMIT

    def _for_a_moment(self, progress):
        """The result of the work, or None."""
        end, late = time.monotonic() + _MOMENT, False

        def watched(fraction, stage):
            nonlocal late
            late = late or time.monotonic() > end
            return progress(fraction, stage) and not late

        try:
            return self._work.result(watched)
        except Cancelled:
            if not late:
                raise
            return None

    def result_of(self, work, progress):
        """The result of other work on any thread: that of the trial where it is the same work."""
        same = self._result is not None and self._work.values == work.values \
            and self._work.fingerprint == work.fingerprint
        return self._result if same else work.result(progress)
