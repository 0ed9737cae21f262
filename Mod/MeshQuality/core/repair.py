# SPDX-License-Identifier: LGPL-2.1-or-later
"""repair: a closed mesh without faults from one that has some."""

from .. import options
from .booleans import run
from .operands.operands import Operands


def repair(mesh, tolerance=None, progress=None, threads=0):
    """The outer surface of a mesh with small faults: closed, manifold, without self-intersections.

    mesh       what boolean takes as an operand
    tolerance  mm; largest distance between the repaired surface and the given one, but for holes that are closed; None: that
               of boolean
    progress, threads   as boolean has them

    It is the union of the one operand: duplicate, flipped and degenerate triangles are put right, small holes closed, and
    triangles that cross are divided along their intersection. Surfaces inside the solid are
    removed.

    Returns a BooleanMesh; report.repaired says what was put right. Raises what boolean raises, as for a hole too large to be
    closed by guessing.
    """
    values = options.check(options.repair.REPAIR, {"tolerance": tolerance, "threads": threads})
    options.require_callable(progress)
    return run_repair(Operands([mesh]), values, progress)


def run_repair(operands, values, progress=None):
    """The BooleanMesh of a single operand that was read (Operands), with checked options."""
    return run(operands, {**options.defaults(options.BOOLEAN), **values}, progress)
