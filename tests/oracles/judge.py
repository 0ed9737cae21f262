# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an oracle finds of one result: claims that are false, and limits that are missed without being said."""

import random

import numpy as np


class WrongError(AssertionError):
    """The result is wrong: an independent measure refutes what it claims, or it misses a limit and is called met."""


class Judge:
    """Gathers the faults of one result.

    findings  what the product itself says that the result does not meet: then missed limits are no faults
    """

    def __init__(self, findings=()):
        self.findings = [str(getattr(one, "text", one)) for one in findings]
        self._false, self._missed = [], []

    def claim(self, holds, sentence):
        """Something that must hold whatever the product says of limits."""
        if not holds:
            self._false.append(sentence)

    def limit(self, holds, sentence):
        """Something that must hold of a result that is called met."""
        if not holds:
            self._missed.append(sentence)

    def verdict(self):
        """"right", or "said": missed, and called so. Raises WrongError."""
        faults = self._false + ([] if self.findings else self._missed)
        if faults:
            raise WrongError("; ".join(faults))
        return "said" if self._missed else "right"


def dice_of(function, seed):
    """The options of a call by chance: (random.Random, numpy generator), the same for the same seed."""
    dice = random.Random(f"{function} {seed}")
    return dice, np.random.default_rng(dice.getrandbits(32))
