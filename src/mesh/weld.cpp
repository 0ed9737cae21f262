// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/weld.h"

#include <cstring>

namespace mq::mesh {
namespace {

std::uint64_t hash_of(const Vec3& p) {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) {
        const double x = p[i] + 0.0;  // -0 becomes 0
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
    }
    return hash;
}

}  // namespace

std::vector<std::int32_t> equal_vertices(const std::vector<Vec3>& vertices) {
    std::size_t size = 16;
    while (size < 2 * vertices.size()) {
        size *= 2;
    }
    // Open addressing. The slot keeps a part of the hash, so that a vertex is looked up only when it is most likely
    // equal.
    struct Slot {
        std::int32_t vertex;
        std::uint32_t tag;
    };
    std::vector<Slot> slots(size, Slot{-1, 0});
    std::vector<std::int32_t> first(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const std::uint64_t hash = hash_of(vertices[v]);
        const auto tag = static_cast<std::uint32_t>(hash >> 32);
        std::size_t at = hash & (size - 1);
        while (slots[at].vertex >= 0 && !(slots[at].tag == tag && vertices[slots[at].vertex] == vertices[v])) {
            at = (at + 1) & (size - 1);
        }
        if (slots[at].vertex < 0) {
            slots[at] = {static_cast<std::int32_t>(v), tag};
        }
        first[v] = slots[at].vertex;
    }
    return first;
}

}  // namespace mq::mesh
