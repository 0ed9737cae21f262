// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "mesh/triangle_mesh.h"

namespace mq::boolean {

/// The directed edges of a surface. Each may be used by one triangle only, so that no edge gets a third triangle and
/// two neighbours always run their edge in opposite directions.
class EdgeSet {
  public:
    EdgeSet() : slots_(1024, kEmpty) {}

    bool has(std::int32_t from, std::int32_t to) const { return slots_[place(ordered_key(from, to))] != kEmpty; }
    /// Whether a triangle has three different corners and none of its edges is in use.
    bool admits(const mesh::Triangle& t) const {
        return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && !has(t[0], t[1]) && !has(t[1], t[2]) && !has(t[2], t[0]);
    }
    void add(std::int32_t from, std::int32_t to) {
        if (2 * (count_ + 1) > slots_.size()) {
            grow();
        }
        std::uint64_t& slot = slots_[place(ordered_key(from, to))];
        count_ += slot == kEmpty ? 1 : 0;
        slot = ordered_key(from, to);
    }
    void add(const mesh::Triangle& t) {
        for (int i = 0; i < 3; ++i) {
            add(t[i], t[i == 2 ? 0 : i + 1]);
        }
    }

  private:
    /// The key of an empty slot; no edge has it.
    static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};

    /// The slot that contains the key, or the free slot for it.
    std::size_t place(std::uint64_t k) const {
        std::size_t slot = KeyHash()(k) & (slots_.size() - 1);
        while (slots_[slot] != kEmpty && slots_[slot] != k) {
            slot = (slot + 1) & (slots_.size() - 1);
        }
        return slot;
    }
    void grow() {
        std::vector<std::uint64_t> old(2 * slots_.size(), kEmpty);
        old.swap(slots_);
        for (const std::uint64_t k : old) {
            if (k != kEmpty) {
                slots_[place(k)] = k;
            }
        }
    }

    std::vector<std::uint64_t> slots_;
    std::size_t count_ = 0;
};

}  // namespace mq::boolean
