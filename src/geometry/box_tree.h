// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace mq::geometry {

/// The distances of a point from a box along the axes, whose norm is the distance.
inline Vec3 gap(const Box& box, const Vec3& p) {
    return (box.low - p).cwiseMax(p - box.high).cwiseMax(0.0);
}

/// Items in a tree of boxes, halved at the median along the longest side. `Bounds` of items has a `box`, add(item), and
/// position(item), by which items are sorted.
template <typename Item, typename Bounds>
class BoxTree {
  public:
    std::vector<Item> items;  ///< build() sorts them

    /// To be called before the first search, and again after changes of the items. O(n log n).
    /// @param leaf  items that are not divided any more
    void build(std::size_t leaf) {
        nodes_.clear();
        if (!items.empty()) {
            build(0, items.size(), leaf);
        }
    }

    /// visit(index) for the items in leaves for which lowest(bounds) is below a limit, which visits may lower; the
    /// lower half first.
    template <typename Lowest, typename Visit>
    void search(const double& limit, const Lowest& lowest, const Visit& visit) const {
        if (!nodes_.empty() && lowest(nodes_[0].bounds) < limit) {
            search(0, limit, lowest, visit);
        }
    }

  private:
    struct Node {
        Bounds bounds;
        std::size_t first;
        std::size_t last;
        std::size_t second_child;  ///< the first child is the next node; 0: a leaf
    };

    std::size_t build(std::size_t first, std::size_t last, std::size_t leaf) {
        const std::size_t at = nodes_.size();
        Bounds bounds;
        std::for_each(&items[first], &items[last - 1] + 1, [&](const Item& item) { bounds.add(item); });
        nodes_.push_back({bounds, first, last, 0});
        if (last - first > leaf) {
            int axis = 0;
            (bounds.box.high - bounds.box.low).maxCoeff(&axis);
            const std::size_t middle = (first + last) / 2;
            std::nth_element(&items[first], &items[middle], &items[last - 1] + 1, [&](const Item& a, const Item& b) {
                return Bounds::position(a)[axis] < Bounds::position(b)[axis];
            });
            build(first, middle, leaf);
            nodes_[at].second_child = build(middle, last, leaf);
        }
        return at;
    }

    template <typename Lowest, typename Visit>
    void search(std::size_t at, const double& limit, const Lowest& lowest, const Visit& visit) const {
        const Node& node = nodes_[at];
        if (node.second_child == 0) {
            for (std::size_t i = node.first; i < node.last; ++i) {
                visit(i);
            }
            return;
        }
        std::pair<double, std::size_t> children[2] = {{lowest(nodes_[at + 1].bounds), at + 1},
                                                      {lowest(nodes_[node.second_child].bounds), node.second_child}};
        if (children[1] < children[0]) {
            std::swap(children[0], children[1]);
        }
        for (const auto& [least, child] : children) {
            if (least < limit) {
                search(child, limit, lowest, visit);
            }
        }
    }

    std::vector<Node> nodes_;
};

}  // namespace mq::geometry
