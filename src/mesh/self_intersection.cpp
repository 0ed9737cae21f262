// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/self_intersection.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/embedded_star.h"
#include "mesh/triangle_tree.h"
#include "mesh/vertex_stars.h"

namespace mq::mesh {
namespace {

/// Takes pairs whose boxes meet, and keeps those that are in contact.
class Collector {
  public:
    /// `embedded`: for each vertex whether no two triangles of its star are in contact.
    Collector(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
              const std::vector<char>& embedded, std::size_t limit, const Progress* progress)
        : vertices_(vertices), triangles_(triangles), embedded_(embedded), limit_(limit), progress_(progress) {}

    void operator()(std::int32_t i, std::int32_t j) {
        constexpr std::uint32_t kPairsBetweenChecks = 1u << 16;
        if (progress_ != nullptr && ++asked_ % kPairsBetweenChecks == 0) {
            progress_->check();
        }
        if (found_.size() >= limit_ || settled(triangles_[i], triangles_[j])) {
            return;
        }
        const auto [a, b] = std::minmax(i, j);
        const Contact how = contact(vertices_, triangles_[a], triangles_[b]);
        if (how != Contact::None) {
            found_.push_back({a, b, how});
        }
    }

    std::vector<ContactPair> take() {
        std::sort(found_.begin(), found_.end(),
                  [](const ContactPair& p, const ContactPair& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
        return std::move(found_);
    }

  private:
    bool settled(const Triangle& t, const Triangle& s) const {
        for (const std::int32_t v : t) {
            if ((v == s[0] || v == s[1] || v == s[2]) && embedded_[v] != 0) {
                return true;
            }
        }
        return false;
    }

    const std::vector<Vec3>& vertices_;
    const std::vector<Triangle>& triangles_;
    const std::vector<char>& embedded_;
    std::size_t limit_;
    const Progress* progress_;
    std::uint32_t asked_ = 0;
    std::vector<ContactPair> found_;
};

/// A grid of cells, those marked that the boxes of some triangles have parts of: a quick test of what may meet them.
class OccupiedCells {
  public:
    OccupiedCells(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                  const std::vector<std::int32_t>& marked)
        : vertices_(vertices), cells_(kSide * kSide * kSide / 8, 0) {
        for (const std::int32_t t : marked) {
            for (const std::int32_t v : triangles[t]) {
                box_.add(vertices[v]);
            }
        }
        const Vec3 size = box_.high - box_.low;
        for (int i = 0; i < 3; ++i) {
            scale_[i] = size[i] > 0.0 ? (kSide - 1) / size[i] : 0.0;
        }
        for (const std::int32_t t : marked) {
            visit(triangles[t], [this](std::size_t cell) {
                cells_[cell / 8] = static_cast<std::uint8_t>(cells_[cell / 8] | (1u << (cell % 8)));
                return true;
            });
        }
    }

    /// False only if the triangle's box meets none of those of the marked triangles.
    bool may_meet(const Triangle& t) const {
        bool found = false;
        visit(t, [&](std::size_t cell) {
            found = (cells_[cell / 8] >> (cell % 8) & 1u) != 0;
            return !found;
        });
        return found;
    }

  private:
    static constexpr std::size_t kSide = 128;

    /// The cell of a coordinate never falls while the coordinate grows, however it is rounded.
    std::size_t cell_of(double x, int axis) const {
        return static_cast<std::size_t>((std::clamp(x, box_.low[axis], box_.high[axis]) - box_.low[axis]) *
                                        scale_[axis]);
    }

    /// Each cell of the box of a triangle that meets the grid, until `use` says false.
    template <typename Use>
    void visit(const Triangle& t, const Use& use) const {
        Box box;
        for (const std::int32_t v : t) {
            box.add(vertices_[v]);
        }
        if ((box.low.array() > box_.high.array()).any() || (box.high.array() < box_.low.array()).any()) {
            return;
        }
        std::array<std::size_t, 3> low;
        std::array<std::size_t, 3> high;
        for (int i = 0; i < 3; ++i) {
            low[i] = cell_of(box.low[i], i);
            high[i] = cell_of(box.high[i], i);
        }
        for (std::size_t z = low[2]; z <= high[2]; ++z) {
            for (std::size_t y = low[1]; y <= high[1]; ++y) {
                for (std::size_t x = low[0]; x <= high[0]; ++x) {
                    if (!use((z * kSide + y) * kSide + x)) {
                        return;
                    }
                }
            }
        }
    }

    const std::vector<Vec3>& vertices_;
    Box box_;
    Vec3 scale_ = Vec3::Zero();
    std::vector<std::uint8_t> cells_;
};

}  // namespace

std::vector<ContactPair> self_intersections(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                                            std::size_t limit, const Progress* progress) {
    std::vector<char> embedded(vertices.size(), 0);
    {
        const VertexStars stars(triangles, vertices.size());
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            embedded[v] = static_cast<char>(embedded_star(vertices, triangles, stars[v]));
        }
    }
    const TriangleTree tree(vertices, triangles);
    Collector collector(vertices, triangles, embedded, limit, progress);
    tree.for_each_own_pair(collector);
    return collector.take();
}

std::vector<ContactPair> self_intersections_with(const std::vector<Vec3>& vertices,
                                                 const std::vector<Triangle>& triangles,
                                                 const std::vector<std::int32_t>& subset, std::size_t limit,
                                                 const Progress* progress) {
    const TriangleTree part(vertices, triangles, subset);
    const OccupiedCells cells(vertices, triangles, subset);
    std::vector<char> in_subset(triangles.size(), 0);
    for (const std::int32_t t : subset) {
        in_subset[t] = 1;
    }
    std::vector<std::int32_t> near;
    std::vector<Triangle> near_triangles;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        if (cells.may_meet(triangles[k])) {
            near.push_back(static_cast<std::int32_t>(k));
            near_triangles.push_back(triangles[k]);
        }
    }
    // A star of which only a part is near is not closed there, and its pairs are tested one by one.
    std::vector<char> embedded(vertices.size(), 0);
    {
        const VertexStars stars(near_triangles, vertices.size());
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            embedded[v] = static_cast<char>(embedded_star(vertices, near_triangles, stars[v]));
        }
    }
    const TriangleTree whole(vertices, triangles, near);
    Collector collector(vertices, triangles, embedded, limit, progress);
    part.for_each_pair(whole, [&](std::int32_t i, std::int32_t j) {
        if (i != j && !(in_subset[j] != 0 && j < i)) {
            collector(i, j);
        }
    });
    return collector.take();
}

}  // namespace mq::mesh
