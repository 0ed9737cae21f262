// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include "curve/curved_mesh.h"
#include "curve/gmsh_order.h"

namespace mq::curve {

namespace {

constexpr int kMostPieces = kMaxDegree;

class Tessellation {
  public:
    Tessellation(const CurvedMesh& mesh, double deviation)
        : mesh_(mesh), lattice_(Lattice::of(2, mesh.order)), order_(gmsh_order(lattice_)) {
        Box box;
        for (const Vec3& p : mesh.nodes) {
            box.add(p);
        }
        const double allowed = deviation > 0.0 ? deviation : 1e-3 * box.largest_side();
        // Chords of n pieces are off by about 1/n^2 of what the whole edge is.
        const double n = std::sqrt(bulge() / allowed);
        pieces_ = std::clamp(static_cast<int>(std::ceil(n)), 1, kMostPieces);
    }

    mesh::TriangleMesh run() {
        const Lattice& fine = Lattice::of(2, pieces_);
        for (std::size_t t = 0; t < mesh_.triangle_face.size(); ++t) {
            const std::vector<Vec3> control = control_of(t);
            std::vector<std::int32_t> index;
            for (int i = 0; i < fine.size(); ++i) {
                index.push_back(vertex(t, fine.exponents(i), control, fine.node(i)));
            }
            append_triangles(fine, index, mesh_.triangle_face[t]);
        }
        return std::move(result_);
    }

  private:
    std::int32_t corner(std::size_t t, std::size_t k) const {
        return mesh_.triangles[t * order_.size() + k];  // the corners come first
    }

    std::vector<Vec3> control_of(std::size_t t) const {
        std::vector<Vec3> nodes(order_.size());
        for (std::size_t i = 0; i < order_.size(); ++i) {
            nodes[static_cast<std::size_t>(order_[i])] =
                mesh_.nodes[static_cast<std::size_t>(mesh_.triangles[t * order_.size() + i])];
        }
        return nodes_to_bezier(lattice_, nodes);
    }

    /// The largest distance of a node from the straight triangle's corresponding point.
    double bulge() const {
        double most = 0.0;
        for (std::size_t t = 0; t < mesh_.triangle_face.size(); ++t) {
            for (std::size_t i = 3; i < order_.size(); ++i) {
                const Barycentric b = lattice_.node(order_[i]);
                Vec3 straight = Vec3::Zero();
                for (std::size_t k = 0; k < 3; ++k) {
                    straight += b[k] * mesh_.nodes[static_cast<std::size_t>(corner(t, k))];
                }
                const auto node = static_cast<std::size_t>(mesh_.triangles[t * order_.size() + i]);
                most = std::max(most, (mesh_.nodes[node] - straight).norm());
            }
        }
        return most;
    }

    /// Points on corners and edges are shared: they are known by the corners and their place between them.
    std::int32_t vertex(std::size_t t, const Exponents& e, const std::vector<Vec3>& control, const Barycentric& at) {
        std::vector<std::pair<std::int32_t, int>> place;
        for (std::size_t k = 0; k < 3; ++k) {
            if (e[k] > 0) {
                place.emplace_back(corner(t, k), e[k]);
            }
        }
        std::sort(place.begin(), place.end());
        if (place.size() == 3) {
            place.emplace_back(-1, static_cast<int>(t));  // of this triangle alone
        }
        const auto [found, fresh] = known_.try_emplace(place, static_cast<std::int32_t>(result_.vertices.size()));
        if (fresh) {
            const Vec3 p = place.size() == 1 ? mesh_.nodes[static_cast<std::size_t>(place[0].first)]
                                             : value(lattice_, control, at);
            result_.vertices.push_back(to_single(p));
        }
        return found->second;
    }

    void append_triangles(const Lattice& fine, const std::vector<std::int32_t>& index, std::int32_t face) {
        const auto at = [&](int i, int j) {
            return index[static_cast<std::size_t>(fine.index({pieces_ - i - j, i, j, 0}))];
        };
        for (int j = 0; j < pieces_; ++j) {
            for (int i = 0; i + j < pieces_; ++i) {
                add({at(i, j), at(i + 1, j), at(i, j + 1)}, face);
                if (i + j + 1 < pieces_) {
                    add({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, face);
                }
            }
        }
    }

    void add(const mesh::Triangle& triangle, std::int32_t face) {
        result_.triangles.push_back(triangle);
        result_.triangle_face.push_back(face);
    }

    const CurvedMesh& mesh_;
    const Lattice& lattice_;
    std::vector<int> order_;
    int pieces_ = 1;
    mesh::TriangleMesh result_;
    std::map<std::vector<std::pair<std::int32_t, int>>, std::int32_t> known_;
};

}  // namespace

mesh::TriangleMesh tessellate(const CurvedMesh& mesh, double deviation) {
    return Tessellation(mesh, deviation).run();
}

}  // namespace mq::curve
