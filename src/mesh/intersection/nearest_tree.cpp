// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/intersection/nearest_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mesh/intersection/triangle_distance.h"

namespace mq::mesh {

/// A point in single precision, rounded both ways, so that the distances of boxes are never too large (but for those
/// whose squares are below the smallest number of single precision, 1e-38 mm^2).
class NearestTree::Point {
  public:
    explicit Point(const Vec3& p) {
        Box box;
        box.add(p);
        const Bounds bounds = outward(box);
        for (std::size_t i = 0; i < 3; ++i) {
            low_[i] = Lanes::Constant(bounds.low[i]);
            high_[i] = Lanes::Constant(bounds.high[i]);
        }
    }
    /// Squared distances of four boxes, mm^2, at most the true ones.
    Lanes squared_distances(const WideNode& node) const {
        // Three differences, squares and sums, each with an error of half a unit in the last place.
        constexpr float kLess = 1.0F - 8.0F * std::numeric_limits<float>::epsilon();
        Lanes sum = Lanes::Zero();
        for (std::size_t i = 0; i < 3; ++i) {
            const Lanes gap = (node.low[i] - high_[i]).max(low_[i] - node.high[i]).max(0.0F);
            sum += gap * gap;
        }
        return sum.min(std::numeric_limits<float>::max()) * kLess;
    }

  private:
    std::array<Lanes, 3> low_;
    std::array<Lanes, 3> high_;
};

NearestTree::NearestTree(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles)
    : AabbTree(vertices, triangles) {
    build();
}

NearestTree::NearestTree(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                         const std::vector<std::int32_t>& subset)
    : AabbTree(vertices, triangles, subset) {
    build();
}

void NearestTree::build() {
    if (size() > 0) {
        add(0);
        wide_.shrink_to_fit();
    }
}

/// Makes a node of the four largest boxes below a node of the binary tree; returns its index.
std::int32_t NearestTree::add(std::int32_t binary) {
    struct Entry {
        const Bounds* bounds;
        std::int32_t node;  // its index in the binary tree, or ~item
    };
    std::vector<Entry> entries{{&nodes_[binary].bounds, binary}};
    // The children of an entry: two nodes, or the items of a leaf.
    const auto below = [&](const Entry& entry) {
        return entry.node < 0 ? 1 : nodes_[entry.node].count == 0 ? 2 : nodes_[entry.node].count;
    };
    while (true) {
        auto largest = entries.end();
        for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
            const bool fits =
                entry->node >= 0 && entries.size() - 1 + static_cast<std::size_t>(below(*entry)) <= kWidth;
            if (fits && (largest == entries.end() || entry->bounds->size() > largest->bounds->size())) {
                largest = entry;
            }
        }
        if (largest == entries.end()) {
            break;
        }
        const Node& node = nodes_[largest->node];
        const std::int32_t count = below(*largest);
        entries.erase(largest);
        for (std::int32_t k = 0; k < count; ++k) {
            const std::int32_t at = node.first + k;
            entries.push_back(node.count == 0 ? Entry{&nodes_[at].bounds, at} : Entry{&items_[at].bounds, ~at});
        }
    }
    const std::size_t index = wide_.size();
    wide_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
        wide_[index].low[i].setZero();
        wide_[index].high[i].setZero();
    }
    wide_[index].child.fill(kNoChild);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        for (std::size_t i = 0; i < 3; ++i) {
            wide_[index].low[i][static_cast<Eigen::Index>(k)] = entries[k].bounds->low[i];
            wide_[index].high[i][static_cast<Eigen::Index>(k)] = entries[k].bounds->high[i];
        }
        const std::int32_t node = entries[k].node;
        const std::int32_t child = node < 0 ? ~items_[~node].triangle : add(node);
        wide_[index].child[k] = child;
    }
    return static_cast<std::int32_t>(index);
}

Vec3 NearestTree::nearest_on(std::int32_t triangle, const Vec3& p) const {
    const Triangle& t = (*triangles_)[triangle];
    return nearest_on_triangle(p, (*vertices_)[t[0]], (*vertices_)[t[1]], (*vertices_)[t[2]]);
}

/// visit(i) for the triangles whose boxes are within a bound, which visits may lower, nearer boxes of each node first.
/// A visit that returns false ends it.
template <typename Visit>
void NearestTree::for_each_near(const Vec3& p, const double& bound_squared, Visit&& visit) const {
    struct Entry {
        float distance;
        std::int32_t child;
    };
    // Each level adds at most three entries to the stack.
    std::array<Entry, 3 * kDeepest + kWidth> stack;
    std::size_t height = 0;
    if (!wide_.empty()) {
        stack[height++] = {0.0F, 0};
    }
    const Point point(p);
    while (height > 0) {
        const Entry top = stack[--height];
        if (static_cast<double>(top.distance) > bound_squared) {
            continue;
        }
        if (top.child < 0) {
            if (!visit(~top.child)) {
                return;
            }
            continue;
        }
        const WideNode& node = wide_[top.child];
        const Lanes distance = point.squared_distances(node);
        const std::size_t bottom = height;
        for (std::size_t k = 0; k < kWidth; ++k) {
            const float d = distance[static_cast<Eigen::Index>(k)];
            if (node.child[k] == kNoChild || static_cast<double>(d) > bound_squared) {
                continue;
            }
            // The nearest on top.
            std::size_t at = height++;
            for (; at > bottom && stack[at - 1].distance < d; --at) {
                stack[at] = stack[at - 1];
            }
            stack[at] = {d, node.child[k]};
        }
    }
}

void NearestTree::search(const Vec3& p, ClosestPoint& best, double best_squared) const {
    for_each_near(p, best_squared, [&](std::int32_t triangle) {
        const Vec3 q = nearest_on(triangle, p);
        const double squared = (q - p).squaredNorm();
        const bool lower = best.triangle < 0 || triangle < best.triangle;
        if (squared < best_squared || (squared == best_squared && lower)) {
            best_squared = squared;
            best = {triangle, q, std::sqrt(squared)};
        }
        return true;
    });
}

ClosestPoint NearestTree::nearest(const Vec3& p, double bound) const {
    ClosestPoint best;
    search(p, best, bound * bound);
    return best;
}

ClosestPoint NearestTree::nearest_from(const Vec3& p, std::int32_t guess) const {
    const Vec3 q = nearest_on(guess, p);
    const double squared = (q - p).squaredNorm();
    ClosestPoint best{guess, q, std::sqrt(squared)};
    search(p, best, squared);
    return best;
}

std::int32_t NearestTree::any_within(const Vec3& p, double distance, std::int32_t guess) const {
    const auto is_within = [&](std::int32_t triangle) { return (nearest_on(triangle, p) - p).norm() <= distance; };
    if (is_within(guess)) {
        return guess;
    }
    std::int32_t found = -1;
    const double bound_squared = distance * distance * (1.0 + 8.0 * std::numeric_limits<double>::epsilon());
    for_each_near(p, bound_squared, [&](std::int32_t triangle) {
        found = is_within(triangle) ? triangle : -1;
        return found < 0;
    });
    return found;
}

void NearestTree::all_within(const Vec3& p, double distance, std::vector<ClosestPoint>& found) const {
    found.clear();
    const double bound_squared = distance * distance;
    for_each_near(p, bound_squared, [&](std::int32_t triangle) {
        const Vec3 q = nearest_on(triangle, p);
        const double squared = (q - p).squaredNorm();
        if (squared <= bound_squared) {
            found.push_back({triangle, q, std::sqrt(squared)});
        }
        return true;
    });
    std::sort(found.begin(), found.end(), [](const ClosestPoint& a, const ClosestPoint& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
    });
}

}  // namespace mq::mesh
