// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::contour {

/// The corners at each vertex of a surface that is edited, in lists without memory of their own: corner 3 t + k is the
/// k-th one of triangle t.
class CornerLists {
  public:
    class Iterator {
      public:
        Iterator(const CornerLists& lists, std::int32_t corner) : lists_(lists), corner_(corner) {}
        std::int32_t operator*() const { return corner_; }
        Iterator& operator++() {
            corner_ = lists_.next_[static_cast<std::size_t>(corner_)];
            return *this;
        }
        bool operator!=(const Iterator& o) const { return corner_ != o.corner_; }

      private:
        const CornerLists& lists_;
        std::int32_t corner_;
    };
    struct Range {
        Iterator first;
        Iterator last;
        Iterator begin() const { return first; }
        Iterator end() const { return last; }
    };

    CornerLists(const std::vector<mesh::Triangle>& triangles, std::size_t vertices)
        : first_(vertices, kNoCorner), next_(3 * triangles.size()) {
        for (std::size_t c = next_.size(); c-- > 0;) {
            std::int32_t& first = first_[static_cast<std::size_t>(triangles[c / 3][c % 3])];
            next_[c] = first;
            first = static_cast<std::int32_t>(c);
        }
    }

    Range at(std::int32_t v) const { return {{*this, first_[static_cast<std::size_t>(v)]}, {*this, kNoCorner}}; }
    /// Takes a corner out of the list of its vertex.
    void remove(std::int32_t corner, std::int32_t v) {
        std::int32_t* at = &first_[static_cast<std::size_t>(v)];
        while (*at != corner) {
            at = &next_[static_cast<std::size_t>(*at)];
        }
        *at = next_[static_cast<std::size_t>(corner)];
    }
    /// Appends the list of `from` to that of `to`.
    void append(std::int32_t to, std::int32_t from) {
        std::int32_t* at = &first_[static_cast<std::size_t>(to)];
        while (*at != kNoCorner) {
            at = &next_[static_cast<std::size_t>(*at)];
        }
        *at = first_[static_cast<std::size_t>(from)];
        first_[static_cast<std::size_t>(from)] = kNoCorner;
    }

  private:
    static constexpr std::int32_t kNoCorner = -1;

    std::vector<std::int32_t> first_;  ///< by vertex
    std::vector<std::int32_t> next_;   ///< by corner
};

}  // namespace mq::contour
