# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an attack is, and what must come of it: a result that is what its report says, or an error of MeshQuality.

A table is a module with `rows()`, the attacks of its class, and `combined(dice)` where it can also put random ones
together for the soak.
"""

import time
from dataclasses import dataclass

import numpy as np

import MeshQuality as mq

ANGLE_SLACK = 1e-3  # degrees: what rounding does to the angle of a needle, computed here in another way
PATIENCE = 0.6  # seconds, after which an attack cancels the work
LATENCY = 1.0  # seconds of the processor from then on; benchmarks/window/cancel_latency.py measures it in detail
STUCK = 15.0  # seconds from then on, on a machine that others use, too
_SHORTEST_SENTENCE = 12


@dataclass(frozen=True)
class Attack:
    """One attack: call() does it and looks at what comes of it; more than `limit` seconds are a hang."""

    name: str
    call: object
    limit: float = 5.0


class Planted(Exception):  # noqa: N818 - an event
    """What objects of an attack raise: it may come out as it is."""


def check(condition, text):
    """Raises AssertionError with the text unless the condition holds."""
    if not condition:
        raise AssertionError(text)


class Patience:
    """A progress callback that cancels when its time is over; `over` is when it did."""

    def __init__(self, seconds=PATIENCE):
        self._end, self.over, self.used = time.monotonic() + seconds, None, 0.0

    def __call__(self, _fraction, _stage):
        now = time.monotonic()
        if now < self._end:
            return True
        if self.over is None:
            self.over, self.used = now, time.process_time()
        return False


def with_patience(function):
    """What function(progress) gives, None where it took too long and ended soon after it was cancelled."""
    progress = Patience()
    try:
        return survive(lambda: function(progress))
    finally:
        if progress.over:
            latency, used = time.monotonic() - progress.over, time.process_time() - progress.used
            check(used < LATENCY and latency < STUCK,
                  f"ended {latency:.2f} s, {used:.2f} s of the processor, after it was cancelled")


def survive(function, allowed=(Planted,)):
    """The result of the function, checked; None where it was cancelled, raised an error of MeshQuality with a
    sentence, or one that is allowed.
    """
    try:
        result = function()
    except mq.Cancelled:
        return None
    except mq.Error as error:
        said = str(error)
        check(len(said) >= _SHORTEST_SENTENCE and "Traceback" not in said, f"an error that says little: {said!r}")
        return None
    except allowed:
        return None
    keeps_promises(result)
    return result


def keeps_promises(result):
    """Raises AssertionError where a mesh is not what its report says."""
    if isinstance(result, mq.SurfaceMesh):
        _mesh_is_as_reported(result)
    elif isinstance(result, mq.CurvedMesh):
        check(np.isfinite(result.nodes).all(), "a node is no number")
        if len(result.elements):
            check(0 <= result.elements.min() and result.elements.max() < len(result.nodes), "an element has no node")
        check(result.report.invalid == len(result.report.invalid_elements),
              f"{result.report.invalid} invalid elements, {len(result.report.invalid_elements)} named")


def _mesh_is_as_reported(mesh):
    vertices, triangles, report = mesh.vertices, mesh.triangles, mesh.report
    check(np.isfinite(vertices).all(), "a vertex is no number")
    check(report.triangles == len(triangles), f"{report.triangles} triangles reported, {len(triangles)} are there")
    if not len(triangles):
        return
    check(0 <= triangles.min() and triangles.max() < len(vertices), "a triangle has no vertex")
    single = (vertices == vertices.astype(np.float32)).all()
    check(single or "more digits than single" in " ".join(report.notes), "a vertex is not of single precision")
    border, many = edge_faults(triangles)
    check(report.border_edges == border, f"{report.border_edges} border edges reported, {border} are there")
    check(report.nonmanifold_edges == many,
          f"{report.nonmanifold_edges} edges of more than two triangles, {many} are there")
    check(not report.closed or border == 0, "reported as closed")
    check(not report.manifold or many == 0, "reported as manifold")
    angles = smallest_angles(vertices, triangles)
    check(abs(report.min_angle - angles.min()) <= ANGLE_SLACK + 1e-6 * abs(angles.min()),
          f"smallest angle {report.min_angle} reported, {angles.min()} measured")
    if report.min_angle_asked > 0 and report.complete:
        exempt = [t for t, _ in report.exempt]
        below = np.setdiff1d(np.flatnonzero(angles < report.min_angle_asked - ANGLE_SLACK), exempt)
        check(not len(below), f"{len(below)} triangles below the angle are not exempt")


def edge_faults(triangles):
    """(edges of one triangle, edges of more than two)."""
    ends = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, counts = np.unique(ends, axis=0, return_counts=True)
    return int((counts == 1).sum()), int((counts > 2).sum())


def smallest_angles(vertices, triangles):
    """The smallest angle of each triangle in degrees, by cross products."""
    corners = vertices[triangles]
    found = []
    for k in range(3):
        one = corners[:, (k + 1) % 3] - corners[:, k]
        other = corners[:, (k + 2) % 3] - corners[:, k]
        found.append(np.arctan2(np.linalg.norm(np.cross(one, other), axis=1), (one * other).sum(axis=1)))
    return np.degrees(np.min(found, axis=0))
