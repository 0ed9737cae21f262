// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace mq {

/// The best triangulation of a polygon of n vertices, by dynamic programming over its chords (Klincsek 1980): for each
/// chord i < j, the best value of the polygon i..j that it cuts off, and the apex k of the triangle at the chord. Time
/// O(n^3), memory O(n^2).
template <typename Value>
class ChordTable {
  public:
    /// @param side  value of a side of the polygon
    /// @param none  value of a polygon without a triangulation
    /// @param improve  (i, k, j, value of i..k, value of k..j, best value of i..j yet): whether the triangle i, k, j
    /// gives a better value, which it then stores in the last argument
    /// @return the value of the whole polygon
    template <typename Improve>
    const Value& find(std::size_t n, const Value& side, const Value& none, Improve&& improve) {
        n_ = n;
        best_.assign(n * n, side);
        apex_.assign(n * n, 0);
        for (std::size_t length = 2; length < n; ++length) {
            for (std::size_t i = 0; i + length < n; ++i) {
                const std::size_t j = i + length;
                Value best = none;
                for (std::size_t k = i + 1; k < j; ++k) {
                    if (improve(i, k, j, best_[i * n + k], best_[k * n + j], best)) {
                        apex_[i * n + j] = k;
                    }
                }
                best_[i * n + j] = best;
            }
        }
        return best_[n - 1];
    }

    /// visit(i, k, j) for each triangle of the polygon that find() was called for.
    template <typename Visit>
    void for_each_triangle(Visit&& visit) const {
        visit_below(0, n_ - 1, visit);
    }

  private:
    template <typename Visit>
    void visit_below(std::size_t i, std::size_t j, Visit& visit) const {
        if (j > i + 1) {
            const std::size_t k = apex_[i * n_ + j];
            visit(i, k, j);
            visit_below(i, k, visit);
            visit_below(k, j, visit);
        }
    }

    std::size_t n_ = 0;
    std::vector<Value> best_;
    std::vector<std::size_t> apex_;
};

}  // namespace mq
