# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a measure of the quality view is."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Optional

import numpy as np


@dataclass(frozen=True)
class Measure:
    """A measure that can be shown on each element.

    title    for people
    help     what the numbers mean to them
    unit     after a number, with a blank where one is wanted; None: a length, in the user's unit
    bad      the number that is shown red, or None: see Scale
    good     the number that is shown blue
    values   values(data, progress) -> float64 (elements,); any thread may call it
    of_all   of_all(data, progress) -> float64 of all tetrahedra of a volume mesh, likewise; None where
             there is no such number
    """

    title: str
    help: str
    unit: Optional[str]
    bad: Optional[float]
    good: float
    values: Callable
    of_all: Optional[Callable] = None

    @property
    def low_is_bad(self):
        """Whether small numbers are the bad ones."""
        return self.bad is not None and self.bad < self.good

    @property
    def is_signed(self):
        """Whether numbers are bad on both sides of 0."""
        return self.bad is not None and self.bad == -self.good

    def badness(self, values):
        """Numbers that grow the worse the values are."""
        return np.abs(values) if self.is_signed else -values if self.low_is_bad else values

    def order(self, values):
        """Indices of the elements, the worst first; the lower index where they are alike."""
        return np.argsort(-self.badness(values), kind="stable")
