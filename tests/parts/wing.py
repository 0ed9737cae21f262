# SPDX-License-Identifier: LGPL-2.1-or-later
"""The main element and the flap of a swept, tapered wing, after section 4 of Aftosmis 1999.

Lofts of B-spline aerofoil sections with a sharp trailing edge, flat tips and, in the main element,
a cut-out for the flap. As in the paper's parts the shortest edge is about 1e-4 of the longest: a
narrow relief slot in the outboard corner of the cut-out plays the part of a relic of the modelling
history.
"""

import math

import Part
from FreeCAD import Vector

SPAN, ROOT_CHORD, TIP_CHORD, SWEEP = 1500.0, 400.0, 160.0, 24.0
THICKNESS, CAMBER, CAMBER_AT = 0.13, 0.02, 0.4
STATIONS = (0.0, 0.09, 0.19, 0.38, 0.61, 0.80, 1.0)
CUT_OUT = (0.2, 0.57)  # fractions of the span
RELIEF = 0.06  # mm


def wing_main():
    """The main element: 36 faces, most of them B-spline surfaces."""
    wires = [_section(y, _main_curves) for y in STATIONS]
    wing = Part.makeLoft(wires, True, True)
    cut = [_section(y, _cut_out_curves) for y in CUT_OUT]
    wing = wing.cut(Part.makeLoft(cut, True, True))
    return wing.cut(_relief()).Solids[0]


def flap():
    """The flap that fits the cut-out: 10 faces, 8 of them B-spline surfaces."""
    first, last = CUT_OUT
    stations = (first + 0.004, (first + last) / 2, last - 0.004)
    return Part.makeLoft([_section(y, _flap_curves) for y in stations], True, True).Solids[0]


def _naca(x):
    """Camber line and half thickness of the four-digit family at x, closed at the trailing edge."""
    p, m = CAMBER_AT, CAMBER
    half = 5.0 * THICKNESS * (
        0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4
    )
    if x < p:
        return m / p**2 * (2.0 * p * x - x * x), half
    return m / (1.0 - p) ** 2 * (1.0 - 2.0 * p + 2.0 * p * x - x * x), half


def _upper(x):
    camber, half = _naca(x)
    return camber + half


def _lower(x):
    camber, half = _naca(x)
    return camber - half


def _spaced(start, end, count):
    """Abscissae from start to end, dense at the leading edge."""
    a, b = math.sqrt(start), math.sqrt(end)
    return [(a + (b - a) * i / count) ** 2 for i in range(count + 1)]


def _main_curves():
    """Runs of (x, z) from the trailing edge over the nose and back, split fore and aft."""
    upper = [(x, _upper(x)) for x in _spaced(1.0, 0.25, 8)]
    nose = [(x, _upper(x)) for x in _spaced(0.25, 0.0, 10)]
    under = [(x, _lower(x)) for x in _spaced(0.0, 0.25, 10)]
    lower = [(x, _lower(x)) for x in _spaced(0.25, 1.0, 8)]
    return [upper, nose, under, lower]


def _cut_out_curves():
    """The cove: rises from the lower side at 0.70 to the upper side at 0.84 of the chord."""
    low, high = (0.70, _lower(0.70) - 0.02), (0.86, _upper(0.86) + 0.02)
    front = [low, (0.703, -0.006), (0.713, 0.008)]
    roof = [front[-1], (0.726, 0.018), (0.745, 0.0245), (0.77, 0.029)]
    lip = [roof[-1], (0.80, 0.033), (0.83, 0.040), high]
    return [front, roof, lip, [high, (1.1, 0.1)], [(1.1, 0.1), (1.1, -0.1)], [(1.1, -0.1), low]]


def _flap_curves():
    """A slender section with a blunt nose inside the cove and the wing's own trailing edge."""
    start, length = 0.72, 0.28

    def point(x, side):
        camber = 0.008 * (1.0 - x) - 0.012 * (1.0 - x) ** 2
        _, half = _naca(x)
        return (start + length * x, camber + side * 0.3 * half)

    upper = [point(x, 1.0) for x in _spaced(1.0, 0.3, 8)]
    nose = [point(x, 1.0) for x in _spaced(0.3, 0.0, 8)]
    under = [point(x, -1.0) for x in _spaced(0.0, 0.3, 8)]
    lower = [point(x, -1.0) for x in _spaced(0.3, 1.0, 8)]
    return [upper, nose, under, lower]


def _chord(fraction):
    return ROOT_CHORD + (TIP_CHORD - ROOT_CHORD) * fraction


def _place(fraction, x, z):
    """The point of the section at `fraction` of the span, x and z in chords."""
    y, chord = SPAN * fraction, _chord(fraction)
    return Vector(y * math.tan(math.radians(SWEEP)) + x * chord, y, z * chord)


def _section(fraction, curves):
    """A closed wire: one B-spline for each run of points of `curves`."""
    edges = []
    for run in curves():
        spline = Part.BSplineCurve()
        spline.interpolate([_place(fraction, x, z) for x, z in run])
        edges.append(spline.toShape())
    return Part.Wire(edges)


def _relief():
    """A narrow blind slot in the outboard front corner of the cut-out."""
    corner = _place(CUT_OUT[1], 0.70, 0.0)
    return Part.makeBox(17.0, RELIEF, 32.0, Vector(corner.x - 5.0, corner.y, corner.z - 30.0))
