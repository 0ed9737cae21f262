# SPDX-License-Identifier: LGPL-2.1-or-later
"""The estimate of how many triangles a quality mesh, or elements a FEM mesh or a flow mesh, will have: it is tried."""

import time

import FreeCAD

from ..core.fem import fem_size
from ..core.sources import convert
from ..core.volumes.volume_mesh import expected_cells
from ..errors import Cancelled
from ..features.flow_mesh import arguments_of
from .quantities import length_text

translate = FreeCAD.Qt.translate

_MOMENT = 2.0  # s
_LIMIT = 50_000  # triangles


class _Moment:
    """Work that is done for a moment: where that suffices, its result need not be computed again.

    work   None where it is not to be tried
    """

    def __init__(self, work):
        self._work = work
        self._result = None  # the result of the work, once it has been computed

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
        """The result of any work, on any thread: the trial's result if its work is the same."""
        same = self._result is not None and self._work.values == work.values \
            and self._work.fingerprint == work.fingerprint
        return self._result if same else work.result(progress)


class Trial(_Moment):
    """The trial of a quality mesh; where a moment does not suffice, with a limit on the number of triangles.

    kind, sources, values   of the work
    obj                     the document object that is edited, or None
    """

    def __init__(self, kind, sources, values, obj=None):
        # The cache of an object has a say in its triangles, and belongs to its own work.
        alone = getattr(getattr(obj, "Proxy", None), "cache", None) is None
        super().__init__(kind.work_on(sources, values, obj) if alone else None)
        limit = min(_LIMIT, values["max_triangles"] or _LIMIT)
        self._limited = kind.work_on(sources, {**values, "max_triangles": limit})
        self._all = limit == values["max_triangles"]
        self.count, self.complete = 0, False

    def compute(self, progress):
        """Fills `count` and `complete`, whether there are no more than these; on any thread."""
        if self._work is not None:
            self._result = self._for_a_moment(progress)
        report = (self._limited.result(progress) if self._result is None else self._result)[0].report
        self.complete = self._result is not None or self._all or report.complete
        self.count = report.triangles if self.complete else _LIMIT

    @staticmethod
    def begun():
        """What is said while it runs."""
        return translate("MeshQuality", "Counting triangles ...")

    @staticmethod
    def words(trials):
        """The text on the triangles of all of these trials, with {} for their number."""
        return translate("MeshQuality", "{} triangles") if all(trial.complete for trial in trials) \
            else translate("MeshQuality", "More than {} triangles")


class FemTrial(_Moment):
    """The trial of a FEM mesh; where a moment does not suffice, the number of elements is estimated from its longest edge."""

    def __init__(self, kind, sources, values, obj=None):
        super().__init__(kind.work_on(sources, values, obj))
        self._shape, self._values = convert.own_shape_of(sources[0]), values
        self.count, self.complete, self.length = 0, False, 0.0

    def compute(self, progress):
        """Fills `count`, `complete`, whether the count is exact, and `length`, the length of the longest edges; on any
        thread.
        """
        self._result = self._for_a_moment(progress)
        self.complete = self._result is not None
        self.length, _ = fem_size.longest_edge(self._shape, self._values)
        self.count = self._result.proof.report.elements if self.complete \
            else fem_size.expected_elements(self._shape, self._values)

    @staticmethod
    def begun():
        """What is said while it runs."""
        return translate("MeshQuality", "Counting elements ...")

    @staticmethod
    def words(trials):
        """The text on the elements of all of these trials, with {} for their number."""
        text = translate("MeshQuality", "{} elements, with edges up to {}") if all(trial.complete for trial in trials) \
            else translate("MeshQuality", "About {} elements, with edges up to {}")
        return text.format("{}", length_text(max(trial.length for trial in trials)))


class FlowTrial(_Moment):
    """The trial of a flow mesh; where a moment does not suffice, the number of cells is estimated by the triangles of its surface."""

    def __init__(self, kind, sources, values, obj=None):
        super().__init__(kind.work_on(sources, values, obj))
        self._shape, self._resolved = convert.taken(convert.own_shape_of(sources[0])), self._work.resolved
        self.count, self.complete, self.all = 0, False, True

    def compute(self, progress):
        """Fills `count`, `complete`, whether the count is exact, and `all`, whether it is not a bound; on any thread."""
        self._result = self._for_a_moment(progress)
        self.complete = self._result is not None
        if self.complete:
            self.count = sum(self._result.proof.report.elements.values())
        else:
            self.count, self.all = expected_cells(self._shape, _LIMIT, progress, **arguments_of(self._resolved))

    @staticmethod
    def begun():
        """What is said while it runs."""
        return translate("MeshQuality", "Counting cells ...")

    @staticmethod
    def words(trials):
        """The text on the cells of all of these trials, with {} for their number."""
        if all(trial.complete for trial in trials):
            return translate("MeshQuality", "{} cells")
        return translate("MeshQuality", "About {} cells") if all(trial.all for trial in trials) else \
            translate("MeshQuality", "More than {} cells")
