# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether elements are valid, shown a second time: an independent check of what the core proves.

It shares no code with the core's prover, and goes another way. All kinds are mapped from a square or cube, triangles,
tetrahedra, prisms and pyramids with collapsed sides. There J is a polynomial with known degrees: from its values at
as many points its Bernstein coefficients follow by interpolation. They enclose J; halving the cube makes them tighter.
Weights are whole numbers and exact. Elements are decided with floating point and a bound on its error; those that it
cannot decide, with whole numbers and no error at all.
"""

import functools
import itertools
import math
from fractions import Fraction

import numpy as np

from ..elements import kinds

POSITIVE, TOUCHING, NEGATIVE, UNKNOWN = 1, 0, -1, -2  # J > 0 everywhere; somewhere J = 0, J < 0; not decided
_UNIT = 128  # points of interpolation are multiples of 1 / 128, so that they are exact
_LEVELS, _PIECES = (8, 14), (4096, 512)  # how often and into how many pieces an element is halved, with floating point and without
_NOTHING = 44  # bits: what is 2^44 times smaller than the largest coefficient counts as zero
_AT_A_TIME = 2_000_000  # values of J in memory
_SIMPLEX = {2: ((1, -1, -1, 0), (0, 1, 0, 0), (0, 0, 1, 0)),
            3: ((1, -1, -1, -1), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))}
_ALONG = (((1, -1, 0, 0), (0, 1, 0, 0)), ((1, 0, -1, 0), (0, 0, 1, 0)), ((1, 0, 0, -1), (0, 0, 0, 1)))
# By kind its barycentric coordinates, a simplex after the other, each by its constant and its gradient.
_BARYCENTRIC = {"triangle": (_SIMPLEX[2],), "tetrahedron": (_SIMPLEX[3],), "quadrilateral": _ALONG[:2],
                "hexahedron": _ALONG, "prism": (_SIMPLEX[2], _ALONG[2])}


def _degrees(kind, p):
    """The degrees of J, or of the normal of a surface, along the sides of the square or cube."""
    return {"triangle": (2 * p - 2,) * 2, "quadrilateral": (2 * p - 1,) * 2, "tetrahedron": (3 * p - 3,) * 3,
            "hexahedron": (3 * p - 1,) * 3, "prism": (3 * p - 2, 3 * p - 2, 3 * p - 1),
            "pyramid": (3 * p - 1, 3 * p - 1, 3 * p - 3)}[kind]


def _inverse(rows):
    """The inverse of a matrix of whole or rational numbers times the whole number, which comes second, that makes it whole."""
    size = len(rows)
    work = np.array([[Fraction(v) for v in row] + [Fraction(int(i == j)) for j in range(size)]
                     for i, row in enumerate(rows)], dtype=object)
    for i in range(size):
        pivot = next(r for r in range(i, size) if work[r, i])
        work[[i, pivot]] = work[[pivot, i]]
        work[i] /= work[i, i]
        for r in range(size):
            if r != i and work[r, i]:
                work[r] -= work[r, i] * work[i]
    found = work[:, size:]
    whole = math.lcm(*(v.denominator for v in found.ravel()))
    return np.array([[int(v * whole) for v in row] for row in found], dtype=object), whole


def _points(degree):
    """Where J is evaluated along a side: denser at its ends, in units of 1 / 128."""
    return [round(_UNIT * (1 - math.cos(math.pi * i / degree)) / 2) for i in range(degree + 1)] if degree else [_UNIT // 2]


def _rounded(matrix, divisor):
    """Whole numbers divided by one: extended precision, where the machine has it."""
    high = np.array([int(v) / divisor for v in matrix.ravel()], dtype=float)
    low = [float(Fraction(int(v), divisor) - Fraction(h)) for v, h in zip(matrix.ravel(), high.tolist())]
    return (high.astype(np.longdouble) + np.array(low, dtype=float)).reshape(matrix.shape)


@functools.lru_cache(maxsize=None)
def _to_bernstein(degree):
    """The matrix from values to coefficients along one side: whole numbers, and as floating point."""
    rows = [[math.comb(degree, j) * t**j * (_UNIT - t) ** (degree - j) for j in range(degree + 1)] for t in _points(degree)]
    matrix, whole = _inverse(rows)
    return matrix, _rounded(matrix * _UNIT**degree, whole)


@functools.lru_cache(maxsize=None)
def _halves(degree):
    """The matrices from the coefficients of a polynomial to those of its halves, times 2^degree."""
    left = [[math.comb(i, j) * 2 ** (degree - i) if j <= i else 0 for j in range(degree + 1)] for i in range(degree + 1)]
    return tuple(np.array(half, dtype=object) for half in (left, [row[::-1] for row in left[::-1]]))


def _derivatives(kind, p):
    """(dimension, points, nodes) of complete elements: weights of nodes in the derivatives, whole numbers up to a common
    factor.
    """
    at = np.array(list(itertools.product(*map(_points, _degrees(kind, p)))), dtype=object).T
    if kind == "pyramid":
        return _derivatives_of_pyramid(p, at)
    unit = _UNIT ** len(at)
    x = [at[0] * (unit // _UNIT), *(a * (unit // _UNIT) for a in at[1:])]
    if kind in ("triangle", "tetrahedron", "prism"):
        x[1] = (_UNIT - at[0]) * at[1] * (unit // _UNIT**2)
    if kind == "tetrahedron":
        x[2] = (_UNIT - at[0]) * (_UNIT - at[1]) * at[2]
    places = kinds.places(kind, kinds.count_of(kind, p))
    values, slopes, gradients = [], [], []
    for simplex in _BARYCENTRIC[kind]:
        for constant, *gradient in simplex:
            value = constant * unit + sum(g * c for g, c in zip(gradient, x))
            factors = [p * value - m * unit for m in range(p)]
            index = np.rint(p * (constant + places @ gradient)).astype(int)
            products = [functools.reduce(np.multiply, factors[:a], 0 * value + 1) * (math.factorial(p) // math.factorial(a))
                        for a in range(p + 1)]
            without = [sum((functools.reduce(np.multiply, factors[:m] + factors[m + 1:a], 0 * value + 1) for m in range(a)),
                           0 * value) * (math.factorial(p) // math.factorial(a)) for a in range(p + 1)]
            values.append(np.array(products, dtype=object)[index].T)
            slopes.append(np.array(without, dtype=object)[index].T)
            gradients.append(gradient)
    terms = [functools.reduce(np.multiply, values[:i] + values[i + 1:], slope) for i, slope in enumerate(slopes)]
    return np.array([sum(g[d] * term for g, term in zip(gradients, terms) if g[d]) for d in range(len(at))], dtype=object)


def _derivatives_of_pyramid(p, at):
    """As _derivatives, in z, u = (x - z / 2) / (1 - z) and v alike; derivatives by u and v are divided by 1 - z."""
    basis = [(i, j, k) for k in range(p + 1) for i in range(p - k + 1) for j in range(p - k + 1)]
    rows = []
    for x, y, z in kinds.places("pyramid", kinds.count_of("pyramid", p)):
        left = p - round(p * z)
        u, v = (Fraction(round(left * (c - z / 2) / (1 - z)), left) if left else Fraction(0) for c in (x, y))
        z = Fraction(p - left, p)
        rows.append([u**i * v**j * z**k * (1 - z) ** (p - k) for i, j, k in basis])
    nodal, _ = _inverse(rows)
    u, v, z = at

    def power(base, i):  # zero where a derivative has removed the last factor
        return base**i if i >= 0 else 0 * base

    by_u, by_v, by_z = [], [], []
    for i, j, k in basis:
        left = p - k
        across = u**i * v**j * _UNIT ** (2 * p - i - j)
        flat = power(_UNIT - z, left - 1) * z**k * _UNIT ** (2 * p - i - j + 1)
        by_u.append(i * power(u, i - 1) * v**j * flat)
        by_v.append(j * u**i * power(v, j - 1) * flat)
        by_z.append(across * (k * power(z, k - 1) * (_UNIT - z) ** left - left * z**k * power(_UNIT - z, left - 1)))
    return np.array([np.array(rows, dtype=object).T @ nodal for rows in (by_u, by_v, by_z)], dtype=object)


def _completion(kind, count):
    """(nodes, count): the complete nodes of a serendipity element; -1/4 of each corner, equal shares of the edges; times 4."""
    places = kinds.places(kind, kinds.count_of(kind, 2))
    corners, found = kinds.CORNERS[kind], [[4 * int(i == j) for j in range(count)] for i in range(count)]
    inside = {"pyramid": ((0, 0, 0, 1),)}.get(kind) or sum(_BARYCENTRIC[kind], ())
    for place in places[count:]:
        zero = [(c, g) for c, *g in inside if abs(c + place @ g) < 1e-9]
        around = [n for n in range(count) if all(abs(c + places[n] @ g) < 1e-9 for c, g in zero)]
        edges = [n for n in around if n >= corners]
        share = (4 + len(around) - len(edges)) // len(edges)
        found.append([share if n in edges else -int(n in around) for n in range(count)])
    return np.array(found, dtype=object)


@functools.lru_cache(maxsize=None)
def _weights(kind, order, count):
    """(dimension, points, nodes) as whole numbers, and as floating point up to a power of two."""
    whole = _derivatives(kind, order)
    if whole.shape[2] != count:
        whole = np.array([part @ _completion(kind, count) for part in whole], dtype=object)
    unit = 2 ** max(int(abs(v)).bit_length() for v in whole.ravel())
    return whole, _rounded(whole, unit).astype(_precision(order))


def _precision(order):
    """Extended where the bound on the error would be too wide."""
    return float if order < 3 else np.longdouble


def _cross(a, b):
    return np.stack([a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1], a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2],
                     a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]], axis=-1)


def _coefficients(kind, order, corners, exact):
    """(coefficients of J (E, ...), values of J at points (E, P), bound on the error of either (E,)) of (E, nodes, 3)."""
    weights = _weights(kind, order, corners.shape[1])[0 if exact else 1]
    degrees = _degrees(kind, order)
    fields = [np.moveaxis(np.tensordot(part, corners, (1, 1)), 0, 1) for part in weights]
    field = _cross(fields[0], fields[1])
    J = (field * fields[2]).sum(axis=-1) if len(fields) == 3 else field
    found = J.reshape(len(J), *(d + 1 for d in degrees), *J.shape[2:])
    gain = 1.0
    for axis, degree in enumerate(degrees, 1):
        matrix = _to_bernstein(degree)[0] if exact else _to_bernstein(degree)[1].astype(_precision(order))
        found = np.moveaxis(np.tensordot(matrix, found, (1, axis)), 0, axis)
        gain *= 1.0 if exact else np.abs(matrix).sum(axis=1).max()
    error = None
    if not exact:
        size = np.abs(corners).max(axis=(1, 2))
        steps = corners.shape[1] + 2 * _LEVELS[0] * (sum(degrees) + 3) + 60  # more than the number of roundings one after the other
        longest = [np.abs(part).sum(axis=1).max() * size for part in weights]
        error = 6 * steps * np.finfo(size.dtype).eps * gain * np.prod(longest, axis=0)
    if len(fields) == 3:
        return found, J, error
    # The mean of the normal; along a collapsed side the square has more of the triangle where it is wide.
    share = np.arange(degrees[0] + 1, 0, -1) if kind == "triangle" else np.ones(degrees[0] + 1, dtype=int)
    mean = (found * share.astype(object if exact else J.dtype)[None, :, None, None]).sum(axis=(1, 2))
    if not exact:
        most = np.abs(found).max(axis=(1, 2, 3), initial=0.0)
        error = 6 * error * (np.abs(mean).max(axis=1) + share.sum() * (degrees[1] + 1) * most)
    return (found * mean[:, None, None]).sum(axis=-1), (J * mean[:, None]).sum(axis=-1), error


def _decide(coefs, error, exact):
    """By element the sign of J: POSITIVE, TOUCHING, NEGATIVE or UNKNOWN."""
    found = np.full(len(error), UNKNOWN)
    owner, degrees = np.arange(len(error)), [n - 1 for n in coefs.shape[1:]]
    open_, ends = found == UNKNOWN, (slice(None), *(slice(None, None, max(degree, 1)) for degree in degrees))
    for _ in range(_LEVELS[exact] + 1):
        attained = coefs[ends].reshape(len(coefs), -1).min(axis=1)
        np.maximum.at(found, owner[attained <= error[owner]], TOUCHING)
        found[owner[attained < -error[owner]]] = NEGATIVE
        left = coefs.reshape(len(coefs), -1).min(axis=1) <= error[owner]
        count = np.bincount(owner[left], minlength=len(found))
        found[open_ & (count == 0) & (found == UNKNOWN)] = POSITIVE
        open_ &= (found == UNKNOWN) & (count * 2 ** len(degrees) <= _PIECES[exact])
        left &= open_[owner]
        coefs, owner = coefs[left], owner[left]
        if not len(owner):
            break
        for axis, degree in enumerate(degrees, 1):
            halves = [half if exact else half.astype(coefs.dtype) / 2.0**degree for half in _halves(degree)]
            coefs = np.concatenate([np.moveaxis(np.tensordot(half, coefs, (1, axis)), 0, axis) for half in halves])
            owner = np.concatenate([owner, owner])
    return found


def _as_whole_numbers(corners):
    """Coordinates times a power of two, with no rounding at all."""
    fractions = [Fraction(float(v)) for v in corners.ravel()]
    common = max(v.denominator for v in fractions)
    return np.array([v.numerator * (common // v.denominator) for v in fractions], dtype=object).reshape(corners.shape)


def examine(kind, order, nodes, rows, turned=None):
    """(int (E,), float (E,)): the sign of J of each element, a row of nodes in Gmsh's order, and an upper bound
    of min J / max |J|.

    turned: bool (E,): elements whose J is taken with the opposite sign.
    """
    sign = np.where(np.zeros(len(rows), bool) if turned is None else turned, -1, 1)
    found, distortion = np.full(len(rows), UNKNOWN), np.full(len(rows), 1.0)
    size = math.prod(degree + 1 for degree in _degrees(kind, order))
    step = max(1, _AT_A_TIME // (size * 9))
    for start in range(0, len(rows), step):
        part = slice(start, start + step)
        corners = nodes.astype(_precision(order))[rows[part]]
        corners = corners - corners[:, :1]
        extent = np.abs(corners).max(axis=(1, 2))
        corners /= np.where(extent > 0, extent, 1.0)[:, None, None]
        coefs, values, error = _coefficients(kind, order, corners, False)
        coefs *= sign[part].reshape(-1, *[1] * (coefs.ndim - 1))
        found[part] = _decide(coefs, error, False)
        most = np.abs(values).max(axis=1)
        distortion[part] = (values.min(axis=1) * sign[part] + 2 * error) / np.where(most > 0, most, 1.0)
    for i in np.flatnonzero((found == UNKNOWN) | (found == TOUCHING)):
        coefs, _, _ = _coefficients(kind, order, _as_whole_numbers(nodes[rows[i : i + 1]]), True)
        found[i] = _decide(coefs * int(sign[i]), np.array([abs(coefs).max() >> _NOTHING]), True)[0]
    return found, distortion
