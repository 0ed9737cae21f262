// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/matching/touching_bodies.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.h"
#include "mesh/edge_table.h"

namespace mq::given {

namespace {

/// Angles (radians) of triangles that lie on each other differ by at most this, by rounding.
constexpr double kSameAngle = 1e-6;

constexpr double kTurn = 6.283185307179586;

/// A triangle at an edge from node `low` to `high`.
struct Wing {
    std::size_t triangle;
    bool opens;  ///< whether the body begins at it, going round the edge by the right-hand rule
    double angle;
    int place;  ///< order around the edge; equal for triangles that lie on each other
};

class Bodies {
  public:
    explicit Bodies(const GivenMesh& mesh) : mesh_(mesh), joined_(mesh.triangles.size()) {
        std::vector<mesh::Triangle> triangles;
        for (const auto& t : mesh.triangles) {
            triangles.push_back({t[0], t[1], t[2]});
        }
        const mesh::EdgeTable table(triangles, mesh.nodes.size());
        table.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
            if (last - first <= 2) {
                joined_.unite(*first / 3, *(last - 1) / 3);
            } else {
                join_wings(low, high, first, last);
            }
        });
    }

    std::size_t of(std::size_t triangle) { return joined_.find(triangle); }

  private:
    const Vec3& at(int node) const { return mesh_.nodes[static_cast<std::size_t>(node)]; }

    void join_wings(int low, int high, const std::uint32_t* first, const std::uint32_t* last) {
        const std::vector<Wing> wings = wings_of(low, high, first, last);
        const auto opening = std::count_if(wings.begin(), wings.end(), [](const Wing& wing) { return wing.opens; });
        if (2 * opening != static_cast<std::ptrdiff_t>(wings.size())) {
            for (const Wing& wing : wings) {
                joined_.unite(wings[0].triangle, wing.triangle);
            }
            return;
        }
        // The first round only finds the bodies that are open at the start of the turn.
        std::deque<std::size_t> open;
        for (int round = 0; round < 2; ++round) {
            for (const Wing& wing : wings) {
                if (wing.opens) {
                    open.push_back(wing.triangle);
                } else if (!open.empty()) {
                    if (round == 1) {
                        joined_.unite(open.front(), wing.triangle);
                    }
                    open.pop_front();
                }
            }
        }
    }

    /// The triangles in their order around the edge; among triangles that lie on each other those that close a body
    /// come first.
    std::vector<Wing> wings_of(int low, int high, const std::uint32_t* first, const std::uint32_t* last) const {
        const Vec3 along = (at(high) - at(low)).normalized();
        Vec3 right = Vec3::Zero();
        std::vector<Wing> wings;
        for (const std::uint32_t* corner = first; corner != last; ++corner) {
            const std::size_t t = *corner / 3;
            const auto& v = mesh_.triangles[t];
            const Vec3 to_apex = at(v[(*corner + 2) % 3]) - at(low);
            const Vec3 away = to_apex - along * to_apex.dot(along);
            right = wings.empty() ? away : right;
            double angle = std::atan2(along.dot(right.cross(away)), right.dot(away));
            angle += angle < -kSameAngle ? kTurn : 0.0;
            wings.push_back({t, v[*corner % 3] == high, angle, 0});
        }
        std::sort(wings.begin(), wings.end(), [](const Wing& a, const Wing& b) {
            return std::tie(a.angle, a.triangle) < std::tie(b.angle, b.triangle);
        });
        for (std::size_t i = 1; i < wings.size(); ++i) {
            wings[i].place = wings[i - 1].place + (wings[i].angle - wings[i - 1].angle > kSameAngle ? 1 : 0);
        }
        std::stable_sort(wings.begin(), wings.end(), [](const Wing& a, const Wing& b) {
            return std::tie(a.place, a.opens) < std::tie(b.place, b.opens);
        });
        return wings;
    }

    const GivenMesh& mesh_;
    DisjointSets<std::size_t> joined_;
};

}  // namespace

std::vector<int> separate_touching_bodies(GivenMesh& mesh) {
    std::vector<int> original(mesh.nodes.size());
    std::iota(original.begin(), original.end(), 0);
    if (!mesh.tetrahedra.empty()) {
        return original;
    }
    Bodies bodies(mesh);
    std::vector<std::map<std::size_t, int>> of_body(mesh.nodes.size());  // by node and body: the node of that body
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::size_t body = bodies.of(t);
        for (int& v : mesh.triangles[t]) {
            auto& own = of_body[static_cast<std::size_t>(v)];
            const auto [known, fresh] = own.emplace(body, v);
            if (fresh && own.size() > 1) {
                known->second = static_cast<int>(mesh.nodes.size());
                const Vec3 place = mesh.nodes[static_cast<std::size_t>(v)];
                mesh.nodes.push_back(place);
                original.push_back(v);
            }
            v = known->second;
        }
    }
    return original;
}

}  // namespace mq::given
