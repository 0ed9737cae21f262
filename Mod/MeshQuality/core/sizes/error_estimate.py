# SPDX-License-Identifier: LGPL-2.1-or-later
"""The error of a finite element solution by recovered gradients, and the sizes of the optimal mesh for a target."""

import numpy as np

_GAUSS = 0.5854101966249685, 0.1381966011250105  # barycentric coordinates of the four-point rule
# Barycentric coordinates of points, by order: where gradients are most accurate, and of the rule for integrals.
_SAMPLES = {1: np.full((1, 4), 0.25), 2: np.full((4, 4), _GAUSS[1]) + np.eye(4) * (_GAUSS[0] - _GAUSS[1])}
_RULE = _SAMPLES[2]
_EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))  # Gmsh's order of the middle nodes
# Weight of the terms that are not constant, where a patch has too few samples for them.
_RIDGE = 1e-4
# Volume of a tetrahedron of our meshes, divided by the cubed size, see docs/method/size-field.md.
_VOLUME = 0.053


def shapes(order, at):
    """Shape functions (q, n) and their gradients (q, n, 3) in the reference tetrahedron, at barycentric coordinates (q, 4)."""
    slopes = np.array([[-1.0, -1, -1], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    if order == 1:
        return at, np.repeat(slopes[None], len(at), axis=0)
    values = [at[:, i] * (2 * at[:, i] - 1) for i in range(4)] + [4 * at[:, i] * at[:, j] for i, j in _EDGES]
    gradients = [(4 * at[:, i] - 1)[:, None] * slopes[i] for i in range(4)] + \
                [4 * (at[:, i, None] * slopes[j] + at[:, j, None] * slopes[i]) for i, j in _EDGES]
    return np.stack(values, axis=1), np.stack(gradients, axis=1)


def gradients_at(nodes, elements, values, order, at, strains=False):
    """Points (e, q, 3), gradients (e, q, 3 k) of nodal values (n, k), and determinants (e, q) at barycentric coordinates (q, 4).
    strains: of three components the symmetric part of the gradient, which rotations leave alone.
    """
    functions, slopes = shapes(order, at)
    corners = nodes[elements]
    jacobians = np.einsum("qni,enj->eqij", slopes, corners)
    inverse = np.linalg.inv(jacobians)
    found = np.einsum("eqij,qnj,enk->eqik", inverse, slopes, values[elements])
    if strains:
        found = (found + np.swapaxes(found, 2, 3)) / 2
    points = np.einsum("qn,enj->eqj", functions, corners)
    return points, found.reshape(*found.shape[:2], -1), np.abs(np.linalg.det(jacobians))


def recovered(nodes, elements, values, order, strains=False):
    """Gradients at the nodes (n, 3 k) by superconvergent patch recovery (Zienkiewicz and Zhu 1992): at each corner the polynomial
    of the order of the elements that fits best to the gradients at the sample points of the elements around.
    """
    points, samples, _ = gradients_at(nodes, elements, values, order, _SAMPLES[order], strains)
    corners = elements[:, :4]
    lengths = np.zeros(len(nodes))
    sides = np.linalg.norm(nodes[corners][:, :, None] - nodes[corners][:, None], axis=3).max(axis=(1, 2))
    np.maximum.at(lengths, corners.ravel(), np.repeat(sides, 4))
    terms = {1: 4, 2: 10}[order]
    matrices, rights = np.zeros((len(nodes), terms, terms)), np.zeros((len(nodes), terms, samples.shape[2]))
    for i in range(4):
        at = corners[:, i]
        basis = _basis((points - nodes[at][:, None]) / lengths[at][:, None, None], order)
        np.add.at(matrices, at, np.einsum("eqs,eqt->est", basis, basis))
        np.add.at(rights, at, np.einsum("eqs,eqk->esk", basis, samples))
    counts = matrices[:, 0, 0]
    ridge = _RIDGE * np.maximum(counts, 1.0)
    matrices[:, range(1, terms), range(1, terms)] += ridge[:, None]
    matrices[counts == 0] = np.eye(terms)
    fits = np.linalg.solve(matrices, rights)
    result = fits[:, 0].copy()
    if order == 2:
        sums, weights = np.zeros_like(result), np.zeros(len(nodes))
        for k, (i, j) in enumerate(_EDGES, 4):
            for at in (corners[:, i], corners[:, j]):
                middle = elements[:, k]
                basis = _basis(((nodes[middle] - nodes[at]) / lengths[at][:, None])[:, None], order)[:, 0]
                np.add.at(sums, middle, np.einsum("es,esk->ek", basis, fits[at]))
                np.add.at(weights, middle, 1.0)
        result[weights > 0] = sums[weights > 0] / weights[weights > 0, None]
    return result


def _basis(offsets, order):
    x, y, z = np.moveaxis(offsets, -1, 0)
    terms = [np.ones_like(x), x, y, z]
    if order == 2:
        terms += [x * x, y * y, z * z, x * y, y * z, z * x]
    return np.stack(terms, axis=-1)


def estimated(nodes, elements, values, order, strains=False):
    """The error of each element (e,) in the norm of the gradient or the strains, and the norm of the recovered gradient of all."""
    smooth = recovered(nodes, elements, values, order, strains)
    _, rough, determinants = gradients_at(nodes, elements, values, order, _RULE, strains)
    functions, _ = shapes(order, _RULE)
    fine = np.einsum("qn,enk->eqk", functions, smooth[elements])
    weights = determinants / 24.0
    errors = np.sqrt(np.einsum("eq,eqk->e", weights, (fine - rough)**2))
    return errors, float(np.sqrt(np.einsum("eq,eqk->", weights, fine**2)))


def sizes_of(nodes, elements):
    """The size field of which our mesh would have elements of these volumes, by element (e,)."""
    corners = nodes[elements[:, :4]]
    volumes = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6.0
    return np.cbrt(volumes / _VOLUME)


def optimal_sizes(sizes, errors, target, order, change, most):
    """The sizes by element of the mesh with the fewest elements whose error is `target`, from sizes and errors by element.

    h_new = h (target^2 / sum_j e_j^(2 d / (2 p + d)))^(1 / (2 p)) e^(-2 / (2 p + d)), with d = 3 and the order p (Diez and Huerta
    1999), limited to a factor `change` each way, and enlarged all over where more than `most` elements are expected.
    """
    power = 2.0 * order + 3.0
    floored = np.maximum(errors, 1e-12 * max(float(errors.max()), 1e-300))
    total = np.sum(floored**(6.0 / power))
    wanted = (target**2 / total)**(0.5 / order) * floored**(-2.0 / power)
    factors = np.clip(wanted, 1.0 / change, change)
    expected = np.sum(factors**-3.0)
    return sizes * factors * max(1.0, np.cbrt(expected / most))
