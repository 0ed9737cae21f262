// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

#include "base/key_set.h"
#include "mesh/triangle_mesh.h"

namespace mq::layered_depth {

/// The directed edges of a surface. Each may be used by one triangle only, so that no edge gets a third triangle and
/// two neighbours always run their edge in opposite directions.
class EdgeSet {
  public:
    bool has(std::int32_t from, std::int32_t to) const { return keys_.count(ordered_key(from, to)) != 0; }
    /// Whether a triangle has three different corners and none of its edges is in use.
    bool admits(const mesh::Triangle& t) const {
        return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && !has(t[0], t[1]) && !has(t[1], t[2]) && !has(t[2], t[0]);
    }
    void add(std::int32_t from, std::int32_t to) { keys_.insert(ordered_key(from, to)); }
    void add(const mesh::Triangle& t) {
        for (int i = 0; i < 3; ++i) {
            add(t[i], t[i == 2 ? 0 : i + 1]);
        }
    }

  private:
    KeySet keys_;
};

}  // namespace mq::layered_depth
