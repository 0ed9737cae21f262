# SPDX-License-Identifier: LGPL-2.1-or-later
"""The unit in which lengths of one kind are shown: the user's, and the same for all of them."""

from dataclasses import dataclass

import FreeCAD

_NAMES = {'"': "in", "'": "ft"}  # signs of FreeCAD that are hard to read after a number


@dataclass(frozen=True)
class LengthUnit:
    """A unit: how many mm it has, and its name."""

    millimetres: float
    name: str

    @classmethod
    def for_lengths_up_to(cls, largest):
        """That in which FreeCAD shows a length of so many mm, such as µm, mm or thou."""
        _, factor, name = FreeCAD.Units.Quantity(largest, FreeCAD.Units.Length).getUserPreferred()
        return cls(factor, _NAMES.get(name, name))
