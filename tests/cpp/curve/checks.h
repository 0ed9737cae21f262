// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <vector>

#include "curve/curve.h"
#include "elements/bezier/validity.h"
#include "elements/product/reference_nodes.h"
#include "triangulate/triangulate.h"

/// Makes curved meshes, and checks the properties of every one, measured from its nodes alone.
namespace mq::curve {

inline CurvedMesh curved(const std::shared_ptr<geometry::Model>& model, const CurveOptions& options,
                         double max_edge = 0.0) {
    geometry::Engine engine(geometry::Engine::Mode::Direct);
    triangulate::TriangulateOptions straight;
    straight.min_angle = 20.0;
    straight.max_edge = max_edge;
    straight.chord_height_relative = max_edge > 0.0 ? 0.0 : 0.02;
    return curve(engine, model, triangulate::triangulate(engine, model, straight).mesh, options);
}

inline CurveOptions of_order(int order, bool volume = false) {
    CurveOptions options;
    options.order = order;
    options.volume = volume;
    return options;
}

inline std::vector<Vec3> nodes_of(const CurvedMesh& mesh, const std::vector<std::int32_t>& list, std::size_t element,
                                  const elements::Lattice& lattice) {
    const std::vector<int> order = elements::gmsh_order(lattice);
    std::vector<Vec3> nodes(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto node = static_cast<std::size_t>(list[element * order.size() + i]);
        nodes[static_cast<std::size_t>(order[i])] = mesh.nodes[node];
    }
    return nodes;
}

/// The integral of the Jacobian over all tetrahedra: the volume that the mesh covers, overlaps counted twice.
inline double volume_of(const CurvedMesh& mesh) {
    const elements::Lattice& lattice = elements::Lattice::of(3, mesh.order);
    double sum = 0.0;
    for (std::size_t e = 0; e < mesh.tetrahedron_volume.size(); ++e) {
        const elements::JacobianForm form = elements::jacobian_of(
            lattice, elements::nodes_to_bezier(lattice, nodes_of(mesh, mesh.tetrahedra, e, lattice)));
        double mean = 0.0;
        for (const double c : form.coefficients) {
            mean += c / static_cast<double>(form.coefficients.size());
        }
        sum += mean / 6.0;
    }
    return sum;
}

inline std::size_t invalid_tetrahedra(const CurvedMesh& mesh) {
    const elements::Lattice& lattice = elements::Lattice::of(3, mesh.order);
    std::size_t invalid = 0;
    for (std::size_t e = 0; e < mesh.tetrahedron_volume.size(); ++e) {
        const auto control = elements::nodes_to_bezier(lattice, nodes_of(mesh, mesh.tetrahedra, e, lattice));
        invalid += elements::check_positive(elements::jacobian_of(lattice, control)).valid ? 0 : 1;
    }
    return invalid;
}

/// Tetrahedra by the nodes of their faces.
inline std::map<std::set<int>, std::vector<std::size_t>> tetrahedra_of_faces(const CurvedMesh& mesh) {
    const elements::Lattice& lattice = elements::Lattice::of(3, mesh.order);
    const std::vector<int> order = elements::gmsh_order(lattice);
    std::map<std::set<int>, std::vector<std::size_t>> faces;
    for (std::size_t e = 0; e < mesh.tetrahedron_volume.size(); ++e) {
        for (std::size_t opposite = 0; opposite < 4; ++opposite) {
            std::set<int> face;
            for (std::size_t i = 0; i < order.size(); ++i) {
                if (lattice.exponents(order[i])[opposite] == 0) {
                    face.insert(mesh.tetrahedra[e * order.size() + i]);
                }
            }
            faces[face].push_back(e);
        }
    }
    return faces;
}

inline std::set<int> nodes_of_triangle(const CurvedMesh& mesh, std::size_t triangle) {
    const auto per = static_cast<std::ptrdiff_t>(mesh.nodes_per_triangle());
    const auto first = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(triangle) * per;
    return {first, first + per};
}

/// Every face of a tetrahedron belongs to two of them with the same nodes, or to one and a boundary triangle.
inline void expect_conforming(const CurvedMesh& mesh) {
    std::set<std::set<int>> boundary;
    for (std::size_t t = 0; t < mesh.triangle_face.size(); ++t) {
        boundary.insert(nodes_of_triangle(mesh, t));
    }
    EXPECT_EQ(boundary.size(), mesh.triangle_face.size());
    for (const auto& [face, elements] : tetrahedra_of_faces(mesh)) {
        EXPECT_EQ(elements.size(), boundary.count(face) > 0 ? 1u : 2u);
    }
}

}  // namespace mq::curve
