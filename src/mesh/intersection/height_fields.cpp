// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/height_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/memory/large_vector.h"
#include "base/predicates.h"
#include "mesh/corner_table.h"
#include "mesh/intersection/embedded_star.h"
#include "mesh/vertex_stars.h"

namespace mq::mesh {
namespace {

/// No patch, trial or number was assigned yet.
constexpr std::int32_t kUnassigned = -1;
constexpr std::size_t kMostTriangles =
    4096;  ///< largest number of triangles in a patch; larger patches overlap themselves more often
constexpr double kSteepest = 0.5;  ///< least cosine between the axis and the normal of a triangle

/// A coordinate axis, up or down, along which a patch is projected.
struct View {
    int axis = 0;
    int sign = 1;

    double x(const Vec3& p) const { return p[(axis + 1) % 3]; }
    double y(const Vec3& p) const { return p[(axis + 2) % 3]; }
};

/// The border of a patch, projected: directed edges, each with the one that follows it around the patch.
class Border {
  public:
    struct Edge {
        std::int32_t from;
        std::int32_t to;
        std::int32_t next;  ///< index of the next edge around the patch
    };

    Border(const std::vector<Vec3>& vertices, const View& view, std::vector<Edge>&& edges)
        : vertices_(vertices), view_(view), edges_(std::move(edges)) {}

    /// Whether the border proves that the patch is a height field.
    bool winds_once() const { return one_runs_round() && simple() && corners_apart(); }

  private:
    const Vec3& at(std::int32_t v) const { return vertices_[static_cast<std::size_t>(v)]; }
    int side(std::int32_t a, std::int32_t b, std::int32_t c) const {
        return view_.sign * orient2d(at(a), at(b), at(c), view_.axis);
    }

    /// Whether exactly one loop runs counter-clockwise seen along the view; its area must exceed its rounding error.
    bool one_runs_round() const {
        int positive = 0;
        std::vector<char> seen(edges_.size(), 0);
        for (std::size_t start = 0; start < edges_.size(); ++start) {
            if (seen[start] != 0) {
                continue;
            }
            const Vec3& origin = at(edges_[start].from);
            double area = 0.0;
            double size = 0.0;
            double terms = 4.0;
            for (std::size_t i = start; seen[i] == 0; i = static_cast<std::size_t>(edges_[i].next)) {
                seen[i] = 1;
                const Vec3 a = at(edges_[i].from) - origin;
                const Vec3 b = at(edges_[i].to) - origin;
                area += view_.x(a) * view_.y(b) - view_.y(a) * view_.x(b);
                size += std::abs(view_.x(a) * view_.y(b)) + std::abs(view_.y(a) * view_.x(b));
                terms += 1.0;
            }
            if (!(std::abs(area) > 1e-15 * terms * size)) {
                return false;
            }
            positive += view_.sign * area > 0.0 ? 1 : 0;
        }
        return positive == 1;
    }

    /// Where the border comes several times to one vertex, the corners of the patch there must lie side by side: the
    /// border could then be moved slightly into each corner, so that its loops are disjoint.
    bool corners_apart() const {
        std::vector<std::array<std::int32_t, 2>> leaving;  // (vertex, edge)
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            leaving.push_back({edges_[e].to, static_cast<std::int32_t>(e)});
        }
        std::sort(leaving.begin(), leaving.end());
        for (std::size_t i = 0; i < leaving.size(); ++i) {
            for (std::size_t j = i + 1; j < leaving.size() && leaving[j][0] == leaving[i][0]; ++j) {
                if (!beside(leaving[i][1], leaving[j][1]) || !beside(leaving[j][1], leaving[i][1])) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Whether the interval between a and b ends before that between c and d begins, or the other way.
    static bool apart(double a, double b, double c, double d) {
        return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
    }

    /// Whether the corner after edge q at its head has both of its sides outside of the corner after edge p, which has
    /// the same head.
    bool beside(std::int32_t p, std::int32_t q) const {
        const Edge& in = edges_[static_cast<std::size_t>(p)];
        const std::int32_t out = edges_[static_cast<std::size_t>(in.next)].to;
        const Edge& other = edges_[static_cast<std::size_t>(q)];
        return outside(in.to, out, in.from, other.from) &&
               outside(in.to, out, in.from, edges_[static_cast<std::size_t>(other.next)].to);
    }

    /// Whether d, seen from v, is not between a and b, counter-clockwise.
    bool outside(std::int32_t v, std::int32_t a, std::int32_t b, std::int32_t d) const {
        if (along(v, a, d) || along(v, b, d)) {
            return false;
        }
        const bool left_of_a = side(v, a, d) > 0;
        const bool right_of_b = side(v, d, b) > 0;
        const bool convex = side(v, a, b) > 0;
        return !(convex ? left_of_a && right_of_b : left_of_a || right_of_b);
    }

    /// Whether no two edges meet except in the common ends of successive edges.
    bool simple() const {
        const std::vector<std::pair<std::uint32_t, std::uint32_t>> entries = in_cells();
        if (entries.empty()) {
            return false;
        }
        for (std::size_t i = 0; i < entries.size(); ++i) {
            for (std::size_t j = i + 1; j < entries.size() && entries[j].first == entries[i].first; ++j) {
                if (meet(edges_[entries[i].second], edges_[entries[j].second])) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Pairs of a cell of a grid and an edge whose box meets it, sorted by cells; nothing when there are more than
    /// kMostEntries for each edge.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> in_cells() const {
        constexpr double kMostCells = 1000.0;  // cells along a side of the grid at most
        // Largest average number of cells per edge, which bounds the memory and time of the grid.
        constexpr std::size_t kMostEntries = 24;
        Box box;
        for (const Edge& edge : edges_) {
            box.add(at(edge.from));
        }
        const double cells = std::min(kMostCells, 2.0 * std::sqrt(static_cast<double>(edges_.size())) + 1.0);
        const double size = std::max(view_.x(box.high) - view_.x(box.low), view_.y(box.high) - view_.y(box.low));
        const auto side = static_cast<std::uint32_t>(cells) + 1;
        const auto cell = [&](double place) { return static_cast<std::uint32_t>(cells * (place / size)); };
        std::vector<std::pair<std::uint32_t, std::uint32_t>> entries;
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            Box own;
            own.add(at(edges_[e].from) - box.low);
            own.add(at(edges_[e].to) - box.low);
            for (std::uint32_t y = cell(view_.y(own.low)); y <= cell(view_.y(own.high)); ++y) {
                for (std::uint32_t x = cell(view_.x(own.low)); x <= cell(view_.x(own.high)); ++x) {
                    entries.emplace_back(side * y + x, e);
                }
            }
            if (entries.size() > kMostEntries * edges_.size()) {
                return {};
            }
        }
        std::sort(entries.begin(), entries.end());
        return entries;
    }

    bool meet(const Edge& p, const Edge& q) const {
        if (p.from == q.from && p.to == q.to) {
            return true;
        }
        if (p.to == q.from || p.to == q.to) {
            return along(p.to, p.from, p.to == q.from ? q.to : q.from);
        }
        if (p.from == q.from || p.from == q.to) {
            return along(p.from, p.to, p.from == q.from ? q.to : q.from);
        }
        if (apart(view_.x(at(p.from)), view_.x(at(p.to)), view_.x(at(q.from)), view_.x(at(q.to))) ||
            apart(view_.y(at(p.from)), view_.y(at(p.to)), view_.y(at(q.from)), view_.y(at(q.to)))) {
            return false;
        }
        return side(q.from, q.to, p.from) * side(q.from, q.to, p.to) <= 0 &&
               side(p.from, p.to, q.from) * side(p.from, p.to, q.to) <= 0;
    }

    /// Whether a and b are seen from v in one direction.
    bool along(std::int32_t v, std::int32_t a, std::int32_t b) const {
        if (a == b || side(v, a, b) == 0) {
            const Vec3 one = at(a) - at(v);
            const Vec3 two = at(b) - at(v);
            return !(view_.x(one) * view_.x(two) + view_.y(one) * view_.y(two) < 0.0);
        }
        return false;
    }

    const std::vector<Vec3>& vertices_;
    View view_;
    std::vector<Edge> edges_;
};

class PatchFinder {
  public:
    PatchFinder(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles, std::size_t fewest)
        : vertices_(vertices),
          triangles_(triangles),
          fewest_(fewest),
          twins_(edge_twins(triangles, vertices.size())),
          patch_(triangles.size(), kUnassigned),
          tried_(triangles.size(), kUnassigned) {}

    std::vector<std::int32_t> run(const Progress* progress) {
        std::int32_t trial = 0;
        std::int32_t patches = 0;
        assign_large_stars(trial, patches);
        for (std::size_t seed = 0; seed < triangles_.size(); ++seed) {
            if (tried_[seed] != kUnassigned) {
                continue;
            }
            const View view = grow(static_cast<std::int32_t>(seed), trial);
            if (members_.size() >= fewest_) {
                check_cancelled(progress);
                if (proven(view, trial)) {
                    for (const std::int32_t t : members_) {
                        patch_[static_cast<std::size_t>(t)] = patches;
                    }
                    ++patches;
                }
            }
            ++trial;
        }
        return std::move(patch_);
    }

  private:
    /// A star with more triangles than the largest patch is one where it is embedded: as their boxes all meet in its
    /// center, every two of them would be tested.
    void assign_large_stars(std::int32_t& trial, std::int32_t& patches) {
        std::vector<std::uint32_t> valence(vertices_.size(), 0);
        for (const Triangle& t : triangles_) {
            for (const std::int32_t v : t) {
                ++valence[static_cast<std::size_t>(v)];
            }
        }
        if (std::none_of(valence.begin(), valence.end(), [](std::uint32_t count) { return count > kMostTriangles; })) {
            return;
        }
        const VertexStars stars(triangles_, vertices_.size());
        for (std::size_t v = 0; v < vertices_.size(); ++v) {
            const VertexStars::Star star = stars[v];
            if (star.size() <= kMostTriangles ||
                std::any_of(star.begin(), star.end(), [&](std::uint32_t c) { return tried_[c / 3] != kUnassigned; }) ||
                !embedded_star(vertices_, triangles_, star)) {
                continue;
            }
            for (const std::uint32_t corner : star) {
                tried_[corner / 3] = trial;
                patch_[corner / 3] = patches;
            }
            ++trial;
            ++patches;
        }
    }

    Vec3 normal(std::int32_t t) const {
        const Triangle& c = triangles_[static_cast<std::size_t>(t)];
        const Vec3& a = vertices_[static_cast<std::size_t>(c[0])];
        return (vertices_[static_cast<std::size_t>(c[1])] - a).cross(vertices_[static_cast<std::size_t>(c[2])] - a);
    }

    bool fits(std::int32_t t, const View& view) const {
        const Vec3 n = normal(t);
        const double height = view.sign * n[view.axis];
        if (!(height > 0.0) || height * height < kSteepest * kSteepest * n.squaredNorm()) {
            return false;
        }
        const Triangle& c = triangles_[static_cast<std::size_t>(t)];
        return view.sign * orient2d(vertices_[static_cast<std::size_t>(c[0])],
                                    vertices_[static_cast<std::size_t>(c[1])],
                                    vertices_[static_cast<std::size_t>(c[2])], view.axis) >
               0;
    }

    /// Gathers the members of a patch around a triangle, breadth first.
    View grow(std::int32_t seed, std::int32_t trial) {
        View view;
        const Vec3 n = normal(seed);
        n.cwiseAbs().maxCoeff(&view.axis);
        view.sign = n[view.axis] < 0.0 ? -1 : 1;
        members_.assign(1, seed);
        tried_[static_cast<std::size_t>(seed)] = trial;
        if (!fits(seed, view)) {
            return view;
        }
        for (std::size_t i = 0; i < members_.size() && members_.size() < kMostTriangles; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t twin = twins_[3 * static_cast<std::size_t>(members_[i]) + k];
                if (twin >= 0 && tried_[static_cast<std::size_t>(twin / 3)] == kUnassigned && fits(twin / 3, view)) {
                    tried_[static_cast<std::size_t>(twin / 3)] = trial;
                    members_.push_back(twin / 3);
                }
            }
        }
        return view;
    }

    bool inside(std::int32_t corner, std::int32_t trial) const {
        return corner >= 0 && tried_[static_cast<std::size_t>(corner / 3)] == trial;
    }
    std::int32_t twin(std::int32_t corner) const { return twins_[static_cast<std::size_t>(corner)]; }
    std::int32_t vertex(std::int32_t corner) const {
        return triangles_[static_cast<std::size_t>(corner / 3)][static_cast<std::size_t>(corner % 3)];
    }

    bool proven(const View& view, std::int32_t trial) {
        std::vector<std::int32_t> corners;
        std::vector<std::array<std::int32_t, 2>>
            numbers;  // corners on the border, ascending, with their positions in it
        for (const std::int32_t t : members_) {
            for (std::int32_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
                if (!inside(twin(corner), trial)) {
                    numbers.push_back({corner, static_cast<std::int32_t>(corners.size())});
                    corners.push_back(corner);
                }
            }
        }
        std::sort(numbers.begin(), numbers.end());
        std::vector<Border::Edge> edges;
        for (const std::int32_t corner : corners) {
            std::int32_t next = next_corner(corner);
            while (inside(twin(next), trial)) {
                next = next_corner(twin(next));
            }
            const auto found = std::lower_bound(numbers.begin(), numbers.end(), std::array<std::int32_t, 2>{next, 0});
            edges.push_back({vertex(corner), vertex(next_corner(corner)), (*found)[1]});
        }
        return Border(vertices_, view, std::move(edges)).winds_once();
    }

    const std::vector<Vec3>& vertices_;
    const std::vector<Triangle>& triangles_;
    std::size_t fewest_;
    std::vector<std::int32_t> twins_;  ///< twin of each corner
    std::vector<std::int32_t> patch_;
    LargeVector<std::int32_t> tried_;  ///< by triangle: the trial in which it was tested
    std::vector<std::int32_t> members_;
};

}  // namespace

std::vector<std::int32_t> height_fields(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                                        std::size_t fewest, const Progress* progress) {
    return PatchFinder(vertices, triangles, fewest).run(progress);
}

}  // namespace mq::mesh
