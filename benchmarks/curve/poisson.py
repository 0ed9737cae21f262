# SPDX-License-Identifier: LGPL-2.1-or-later
"""Isoparametric finite elements for a problem with a known solution in a torus.

-Laplace(u) = f with u = 0 on the surface; u = phi exp(k . x), where phi vanishes on the torus.
Elements of order p are taken as mq.curve makes them, and with straight sides between the same
corners.
"""

import numpy as np
import scipy.sparse
import scipy.sparse.linalg
import scipy.special

RADIUS, TUBE = 1.0, 0.4
WAVE = np.array([1.0, -0.5, 0.8])
COLUMNS = ("order", "elements", "unknowns", "curved_l2", "curved_h1", "straight_l2",
           "straight_h1")


def solution(x):
    """u, its gradient and -Laplace(u) at points (..., 3)."""
    rho = np.hypot(x[..., 0], x[..., 1])
    radial = np.stack((x[..., 0] / rho, x[..., 1] / rho, np.zeros_like(rho)), axis=-1)
    axial = np.stack((np.zeros_like(rho), np.zeros_like(rho), x[..., 2]), axis=-1)
    phi = TUBE ** 2 - (rho - RADIUS) ** 2 - x[..., 2] ** 2
    slope = -2 * (rho - RADIUS)[..., None] * radial - 2 * axial
    laplace = -4 - 2 * (rho - RADIUS) / rho
    wave = np.exp(x @ WAVE)
    gradient = wave[..., None] * (slope + phi[..., None] * WAVE)
    return phi * wave, gradient, -wave * (laplace + 2 * slope @ WAVE + phi * (WAVE @ WAVE))


def quadrature(count):
    """Points (n, 3) in the reference tetrahedron and weights; exact to degree 2 count - 1."""
    rules = []
    for power in (2, 1, 0):
        points, weights = scipy.special.roots_jacobi(count, power, 0)
        rules.append(((points + 1) / 2, weights / 2 ** (power + 1)))
    (a, wa), (b, wb), (c, wc) = rules
    a, b, c = np.meshgrid(a, b, c, indexing="ij")
    weights = wa[:, None, None] * wb[None, :, None] * wc[None, None, :]
    points = np.stack((a, b * (1 - a), c * (1 - a) * (1 - b)), axis=-1)
    return points.reshape(-1, 3), weights.ravel()


class Element:
    """Lagrange polynomials of one order on the reference tetrahedron, in the mesh's node order."""

    def __init__(self, order, places):
        self.places = places
        self.powers = np.array([(i, j, k) for i in range(order + 1) for j in range(order + 1 - i)
                                for k in range(order + 1 - i - j)])
        self.coefficients = np.linalg.inv(self._monomials(places))

    def _monomials(self, x, along=None):
        powers, factor = self.powers, 1.0
        if along is not None:
            factor = powers[:, along]
            powers = np.maximum(powers - np.eye(3, dtype=int)[along], 0)
        return factor * np.prod(x[:, None, :] ** powers, axis=2)

    def values(self, x):
        """(points, nodes)"""
        return self._monomials(x) @ self.coefficients

    def gradients(self, x):
        """(points, nodes, 3)"""
        return np.stack([self._monomials(x, k) @ self.coefficients for k in range(3)], axis=2)


def places_of_nodes(nodes, elements, order):
    """Where the nodes of an element lie in the reference tetrahedron, from one with straight sides."""
    corners = nodes[elements[0][:4]]
    sides = (corners[1:] - corners[0]).T
    places = np.linalg.solve(sides, (nodes[elements[0]] - corners[0]).T).T
    return np.round(places * order) / order


def straightened(nodes, elements, element):
    """The nodes moved to where they are with straight sides between the corners."""
    corners = nodes[elements[:, :4]]
    weights = np.column_stack((1 - element.places.sum(axis=1), element.places))
    moved = nodes.copy()
    moved[elements] = np.einsum("nc,ecx->enx", weights, corners)
    return moved


class Problem:
    """The equation on one mesh of isoparametric elements."""

    def __init__(self, nodes, elements, boundary, element, order):
        self.elements, self.boundary, self.count = elements, boundary, len(nodes)
        points, weights = quadrature(order + 3)
        self.values = element.values(points)
        slopes = element.gradients(points)
        corners = nodes[elements]
        self.points = np.einsum("qn,enx->eqx", self.values, corners)
        jacobian = np.einsum("qnr,enx->eqxr", slopes, corners)
        self.weights = weights * np.linalg.det(jacobian)
        if self.weights.min() <= 0:
            raise ValueError("an element is invalid")
        self.slopes = np.einsum("qnr,eqrx->eqnx", slopes, np.linalg.inv(jacobian))

    def solve(self):
        """Values at the nodes."""
        rows = np.broadcast_to(self.elements[:, :, None],
                               (*self.elements.shape, self.elements.shape[1]))
        stiffness = np.einsum("eq,eqnx,eqmx->enm", self.weights, self.slopes, self.slopes,
                              optimize=True)
        matrix = scipy.sparse.csr_matrix(
            (stiffness.ravel(), (rows.ravel(), rows.transpose(0, 2, 1).ravel())),
            shape=(self.count, self.count))
        load = np.zeros(self.count)
        _, _, source = solution(self.points)
        np.add.at(load, self.elements, np.einsum("eq,eq,qn->en", self.weights, source, self.values))
        free = np.setdiff1d(np.unique(self.elements), self.boundary)
        u = np.zeros(self.count)
        u[free] = scipy.sparse.linalg.spsolve(matrix[free][:, free].tocsc(), load[free])
        return u, len(free)

    def errors(self, u):
        """In the L2 norm and in the H1 seminorm, as parts of the solution's."""
        local = u[self.elements]
        exact, slope, _ = solution(self.points)
        value = np.einsum("qn,en->eq", self.values, local) - exact
        gradient = np.einsum("eqnx,en->eqx", self.slopes, local) - slope
        return (np.sqrt((self.weights * value ** 2).sum() / (self.weights * exact ** 2).sum()),
                np.sqrt((self.weights[..., None] * gradient ** 2).sum()
                        / (self.weights[..., None] * slope ** 2).sum()))


def study(orders, max_edge=0.36):
    """A row of COLUMNS for each order.

    Edges of the default length turn by less than what is split, so that the mesh is the same for
    all orders.
    """
    import Part

    import MeshQuality as mq

    rows = []
    for order in orders:
        box = mq.curve(Part.makeBox(1, 1, 1), order=order, volume=True)
        element = Element(order, places_of_nodes(box.nodes, box.elements, order))
        mesh = mq.curve(Part.makeTorus(RADIUS, TUBE), order=order, volume=True, max_edge=max_edge)
        if mesh.report.invalid:
            raise ValueError(str(mesh.report))
        row = [order, len(mesh.elements)]
        for nodes in (mesh.nodes, straightened(mesh.nodes, mesh.elements, element)):
            problem = Problem(nodes, mesh.elements, np.unique(mesh.triangles), element, order)
            u, unknowns = problem.solve()
            row += [unknowns] * (len(row) == 2) + list(problem.errors(u))
        rows.append(tuple(row))
    return rows


def draw(rows, path, mesh=""):
    """A picture of both errors against the order, curved and straight; rows as study has them."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "p-convergence"
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.8), sharey=True)
    columns = list(zip(*rows))
    for axis, name, curved, straight in ((axes[0], "L2 error", 3, 5), (axes[1], "H1 error", 4, 6)):
        axis.semilogy(columns[0], columns[straight], "s--", color="#b33", label="straight sides")
        axis.semilogy(columns[0], columns[curved], "o-", color="#24a", label="curved")
        axis.set_xticks(columns[0])
        axis.set_xlabel("order of the elements")
        axis.set_title(f"relative {name}")
        axis.grid(True, which="both", alpha=0.3)
    axes[0].legend()
    figure.suptitle(f"Poisson's equation in a torus, {rows[0][1]} tetrahedra{mesh}")
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
