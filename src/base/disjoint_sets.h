// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "base/memory/large_vector.h"

namespace mq {

/// Disjoint sets of 0 .. count - 1 with path halving. The root of a set is always its lowest member, so that results do
/// not depend on the order in which sets were united. Index is a type of integers that holds the count.
template <typename Index>
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

    /// The lowest member of the set of i.
    Index find(Index i) {
        while (up(i) != i) {
            up(i) = up(up(i));
            i = up(i);
        }
        return i;
    }
    void unite(Index a, Index b) {
        a = find(a);
        b = find(b);
        up(std::max(a, b)) = std::min(a, b);
    }

    /// Adds a member, as a set of its own.
    void add() { parent_.push_back(static_cast<Index>(parent_.size())); }

    /// Makes i a set of its own again. All members of its former set must be reset as well.
    void reset(Index i) { up(i) = i; }

    /// Numbers the sets 0, 1, ... in the order of their lowest members.
    /// @return the number of each member's set
    std::vector<Index> number(Index& count) {
        std::vector<Index> result(parent_.size());
        count = 0;
        for (std::size_t i = 0; i < parent_.size(); ++i) {
            const auto root = static_cast<std::size_t>(find(static_cast<Index>(i)));
            result[i] = root == i ? count++ : result[root];
        }
        return result;
    }

  private:
    Index& up(Index i) { return parent_[static_cast<std::size_t>(i)]; }

    LargeVector<Index> parent_;
};

}  // namespace mq
