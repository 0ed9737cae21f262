# SPDX-License-Identifier: LGPL-2.1-or-later
"""The forms in which a metric is given, each as a function of points and what the CAD faces are like there."""

import numpy as np

from ...errors import InvalidInput
from ..sizes.interpolated import Interpolated
from . import metrics

NONE = "none"  # without a metric
ACCEPTED = ("\"curvature\", a function of points (n, 3) that returns metrics (n, 6): xx, yy, zz, xy, yz, zx for each mm^2, "
            "or (points, metrics)")


class Curvature:
    """By the principal curvatures of the faces, for the largest distance."""

    def __init__(self, distance, longest, stretching):
        """mm, mm, and a ratio."""
        self._distance, self._longest, self._stretching = distance, longest, stretching

    @classmethod
    def of(cls, distance, longest, stretching):
        """Raises InvalidInput where no distance is asked for."""
        if not distance:
            raise InvalidInput("metric = 'curvature' needs a bound on the distance: give chord_height or chord_height_relative")
        return cls(distance, longest, stretching)

    def at(self, points, normals, curvatures):  # noqa: ARG002  by curvature alone
        """(n, 6)."""
        return metrics.by_curvature(curvatures, normals, self._distance, self._longest, self._stretching)

    def along_edges(self, rows, tangents, bent):
        """Metrics (n, 6) of places on edges of the shape that have these tangents and curvatures, too."""
        return metrics.with_curves(rows, tangents, bent, self._distance, self._stretching)

    def across_faces(self, rows, across, widths):
        """Metrics (n, 6) that know how wide the faces are at their borders, too."""
        return metrics.within(rows, across, widths)


class Given:
    """A function, or values at points, between which it is interpolated."""

    def __init__(self, form, longest, stretching):
        self._function = form if callable(form) else _of_points(form)
        self._longest, self._stretching = longest, stretching

    def at(self, points, normals=None, curvatures=None):  # noqa: ARG002  by place alone
        """(n, 6)."""
        rows = np.array(self._function(points), dtype=np.float64)
        if rows.shape != (len(points), 6):
            raise InvalidInput(f"metric: the function returned an array of shape {rows.shape} for {len(points)} points: it must return six "
                               f"numbers for each, of shape ({len(points)}, 6)")
        _require(points, rows)
        return metrics.bounded(rows, self._longest, self._stretching)

    def along_edges(self, rows, tangents, bent):  # noqa: ARG002
        """The metrics themselves."""
        return rows

    def across_faces(self, rows, across, widths):  # noqa: ARG002
        """The metrics themselves."""
        return rows

    def shortest(self, points):
        """float64 (n,), mm: the least length wanted in any direction, as a size field."""
        return metrics.shortest(self.at(points))


def _of_points(form):
    """A function of places of (points, metrics)."""
    try:
        points, rows = (np.ascontiguousarray(part, dtype=np.float64) for part in form)
    except (TypeError, ValueError) as error:
        raise InvalidInput(f"metric = {type(form).__name__} is not allowed: it must be {ACCEPTED}") from error
    if points.ndim != 2 or points.shape[1] != 3 or rows.shape != (len(points), 6) or not len(points):
        raise InvalidInput(f"metric: points of shape {points.shape} with metrics of shape {rows.shape}: give (n, 3) and (n, 6), n at least 1")
    _require(points, rows)
    alone = np.full((len(points), 4), -1, dtype=np.int32)
    alone[:, 0] = np.arange(len(points))
    fields = [Interpolated(points, alone, np.ascontiguousarray(column), "metric") for column in rows.T]
    return lambda places: np.stack([field.sizes(places) for field in fields], axis=1)


def _require(points, rows):
    """Raises InvalidInput where a metric is no number, or gives a direction a negative squared length."""
    numbers = np.isfinite(rows).all(axis=1)
    least = np.full(len(rows), np.nan)
    least[numbers] = np.linalg.eigvalsh(metrics.matrices(rows[numbers])).min(axis=1)
    bad = ~(least >= -1e-9 * np.abs(rows).max(axis=1, initial=0.0))
    if bad.any():
        i = int(np.argmax(bad))
        place = ", ".join(f"{c:.6g}" for c in points[i])
        why = f"has an eigenvalue of {least[i]:.4g} for each mm^2" if numbers[i] else "has no numbers"
        raise InvalidInput(f"metric {why} at ({place}) mm, one of {int(bad.sum())} such places: metrics are symmetric matrices without "
                           "negative eigenvalues")
