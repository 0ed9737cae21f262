// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "curve/output/curved_mesh.h"
#include "elements/product/reference_nodes.h"

namespace mq::curve {

/// A mesh of triangles by formula. Coordinates are multiples of a power of two, so that nodes of one place are equal,
/// however they are computed.
class PatchMesh {
  public:
    using Map = std::function<Vec3(const Vec3&)>;

    explicit PatchMesh(int order) { mesh.order = order; }

    /// The triangle between three points, mapped.
    void add(
        const std::array<Vec3, 3>& corners, const Map& map = [](const Vec3& p) { return p; }) {
        const elements::Lattice& lattice = elements::Lattice::of(2, mesh.order);
        for (const int i : elements::gmsh_order(lattice)) {
            const elements::Barycentric b = lattice.node(i);
            mesh.triangles.push_back(static_cast<std::int32_t>(mesh.nodes.size()));
            mesh.nodes.push_back(rounded(map(b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2])));
        }
        mesh.triangle_face.push_back(0);
    }
    /// A ball of eight triangles, turned by the columns of a matrix.
    void add_ball(const Vec3& centre, double radius, const std::array<Vec3, 3>& axes) {
        for (int octant = 0; octant < 8; ++octant) {
            const std::array<Vec3, 3> corners{(octant & 1) != 0 ? Vec3(-axes[0]) : axes[0],
                                              (octant & 2) != 0 ? Vec3(-axes[1]) : axes[1],
                                              (octant & 4) != 0 ? Vec3(-axes[2]) : axes[2]};
            add(corners, [&](const Vec3& p) { return Vec3(centre + radius * p.normalized()); });
        }
    }

    CurvedMesh mesh;

  private:
    static Vec3 rounded(const Vec3& p) {
        const auto round = [](double x) { return std::ldexp(std::round(std::ldexp(x, 24)), -24); };
        return {round(p.x()), round(p.y()), round(p.z())};
    }
};

}  // namespace mq::curve
