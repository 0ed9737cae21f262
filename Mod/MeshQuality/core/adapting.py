# SPDX-License-Identifier: LGPL-2.1-or-later
"""adapt: meshes of tetrahedra that follow the error of a solution."""

from collections import namedtuple

import numpy as np

from .. import options
from ..errors import InvalidInput
from ..listing import Public
from .curving import curve
from .sizes import error_estimate

CHANGE = 2.0  # largest factor of sizes from a step to the next
_GROWTH = 4.0  # largest factor of the number of elements likewise
_FALLS = 0.97  # an error above this fraction of the least before does not fall
_STEPS_WITHOUT = 2  # successive steps without a fall that end the work
_AIM, _LOWER = 0.8, 0.6  # fraction of the target that new sizes are for, and its factor after a step without a fall

_ROUNDING = 1e-9  # of values of solutions

# One step: unknowns (nodes times components), elements, the estimated relative error, and the least size in mm.
AdaptStep = namedtuple("AdaptStep", "unknowns elements error least_size")


class Adaptation(metaclass=Public):
    """The result of adapt.

    mesh      the CurvedMesh of the step with the least error
    values    float64 (N, k), the solution at its nodes
    errors    float64 (E,), its estimated error by tetrahedron, in the norm of the gradient
    steps     list of AdaptStep: unknowns, elements, error (relative), least_size
    stopped   why it ended: "target", "unknowns", "steps", "no fall"
    sizes     the size field that made that mesh, as size_field= takes it; None: there was none
    """

    __slots__ = {"errors": "float64 (E,), estimated, by tetrahedron", "mesh": "the CurvedMesh", "sizes": "its size field, or None",
                 "steps": "list of AdaptStep", "stopped": '"target", "unknowns", "steps" or "no fall"', "values": "float64 (N, k), the solution"}

    def __init__(self, mesh, values, errors, sizes, steps, stopped):
        self.mesh, self.values, self.errors, self.sizes = mesh, values, errors, sizes
        self.steps, self.stopped = steps, stopped

    error = property(lambda self: min(step.error for step in self.steps), doc="estimated, relative: of `mesh`")

    @property
    def rate(self):
        """The slope of log(error) over log(unknowns), by all steps but the first; nan of fewer than two."""
        steps = self.steps[1:]
        if len(steps) < 2:
            return float("nan")
        logs = np.log([(step.unknowns, step.error) for step in steps])
        return float(np.polyfit(logs[:, 0], logs[:, 1], 1)[0])

    def to_dict(self):
        """The table and why it ended, as plain values for JSON."""
        return {"steps": [step._asdict() for step in self.steps], "stopped": self.stopped, "error": self.error, "rate": self.rate,
                "notes": []}

    def __str__(self):
        rows = [f"{'unknowns':>10} {'elements':>10} {'error':>9} {'least size':>11}"]
        rows += [f"{step.unknowns:10,} {step.elements:10,} {step.error:9.2%} {step.least_size:8.4g} mm" for step in self.steps]
        return "\n".join([*rows, f"ended: {self.stopped}", ""])

    def __repr__(self):
        return f"<Adaptation: {len(self.steps)} steps, error {self.error:.2%}, ended by {self.stopped}>"


def adapt(solve, shape, target_error=0.05, max_unknowns=200_000, steps=8, order=2, size_field=None, progress=None, strains=False, kept=None,
          **values):
    """A mesh of tetrahedra that is refined where the error of a solution is, until that is small enough.

    solve         function(mesh) that solves on a CurvedMesh and returns values at mesh.nodes: (N,), or (N, k) of k components
    shape         Part.Shape with solids, or a document object that has one
    target_error  relative error in the norm of the gradient, as estimated: 0.05 is 5 %
    max_unknowns  nodes times components: no mesh is made that is expected to have more
    steps         most meshes that are made
    order         of the elements: 1 or 2
    size_field    bounds sizes in all steps, as for triangulate; values: further options of curve, for the first mesh and all others
    strains       of three components, displacements: the error of the strains counts, not that of the gradient
    progress      callable(fraction 0..1, stage); returning False cancels, what it raises comes out
    kept          callable(Adaptation) after each step whose error is the least until then; None: nobody is told

    The error is estimated by superconvergent patch recovery (Zienkiewicz and Zhu 1992); new sizes are those of the mesh with the
    fewest elements for the target, changed by a factor of 2 at most. Returns an Adaptation. What `solve` raises comes out.
    Raises InvalidInput naming the argument; what curve raises.
    """
    _check(solve, target_error, max_unknowns, steps, order)
    options.require_callable(progress)
    table, best, wanted, stopped = [], None, size_field, "steps"
    for _ in range(steps):
        mesh = curve(shape, order=order, volume=True, size_field=wanted, progress=progress, **values)
        found = _solution(solve, mesh)
        errors, norm = error_estimate.estimated(mesh.nodes, mesh.tetrahedra, found, order, strains)
        total = float(np.sqrt(np.sum(errors**2)))
        error = total / norm if norm > _gradient_of_rounding(mesh.nodes, found) else 0.0
        sizes = error_estimate.sizes_of(mesh.nodes, mesh.tetrahedra)
        table.append(AdaptStep(found.size, len(mesh.tetrahedra), error, float(sizes.min())))
        if best is None or error < best[0]:
            best = error, mesh, found, errors, wanted
            if kept is not None:
                kept(Adaptation(*best[1:], list(table), ""))
        without = _without_fall(table)
        stopped = _stopped(table, without, target_error, max_unknowns)
        if stopped:
            break
        aim = _AIM * _LOWER**without * max(target_error, 0.4 * error)
        most = min(_GROWTH, 0.95 * max_unknowns / found.size) * len(mesh.tetrahedra)
        new = error_estimate.optimal_sizes(sizes, errors, aim * norm, order, CHANGE, most)
        wanted = [(mesh, new)] if size_field is None else [(mesh, new), size_field]
    return Adaptation(*best[1:], table, stopped or "steps")


def _without_fall(table):
    """How many of the last steps have no lower error than those before."""
    errors = [step.error for step in table]
    best = 0
    for i, error in enumerate(errors):
        best = i if error <= _FALLS * errors[best] else best
    return len(errors) - 1 - best


def _stopped(table, without, target, most):
    last = table[-1]
    if last.error <= target:
        return "target"
    if last.unknowns >= 0.85 * most:
        return "unknowns"
    return "no fall" if without >= _STEPS_WITHOUT else ""


def _gradient_of_rounding(nodes, values):
    """The norm of a gradient that rounding of the values alone makes."""
    extent = np.ptp(nodes, axis=0)
    return _ROUNDING * float(np.abs(values).max()) * float(np.sqrt(extent.prod())) / float(extent.max())


def _solution(solve, mesh):
    found = np.asarray(solve(mesh), dtype=np.float64)
    if found.shape[:1] != (len(mesh.nodes),) or found.ndim > 2:
        raise InvalidInput(f"the solution has the shape {found.shape} on a mesh of {len(mesh.nodes)} nodes: it must have a row for "
                           "each node of this mesh")
    found = found.reshape(len(mesh.nodes), -1)
    bad = ~np.isfinite(found).all(axis=1)
    if bad.any():
        place = ", ".join(f"{c:.6g}" for c in mesh.nodes[int(np.argmax(bad))])
        raise InvalidInput(f"the solution has no number at node {int(np.argmax(bad))}, ({place}) mm, one of {int(bad.sum())} such nodes")
    return found


def _check(solve, target_error, max_unknowns, steps, order):
    if not callable(solve):
        raise InvalidInput(f"solve = {solve!r} is no function of a mesh that returns values at its nodes")
    for name, value, good in (("target_error", target_error, 0.0 < target_error < 1.0), ("max_unknowns", max_unknowns, max_unknowns >= 1),
                              ("steps", steps, isinstance(steps, int) and steps >= 1), ("order", order, order in (1, 2))):
        if not good:
            said = {"target_error": "above 0 and below 1", "order": "1 or 2"}.get(name, "a whole number, at least 1")
            raise InvalidInput(f"{name} = {value!r} is not allowed: it must be {said}")
